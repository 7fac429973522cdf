#include "hiergeo.h"
#include "insert.h"
#include "need.h"
#include "twoscale.h"
#include <stdlib.h>
#include <string.h>

enum { K = KW_BSPLINE_DEGREE + 1, D_MOST = KW_TENSOR_D };

/* --- local coefficients --- */

/* kw_hiergeo_local, with the spaces of `spaces`, which may have more levels than b's own mesh. */
static void local_coefficients(const kw_hier *b, const kw_mesh *spaces, kw_hier_kind kind,
                               int N, const double *c, int level, const int *cell,
                               double *local)
{
    const kw_active *active = b->active;
    int size = active->local * N, is[KW_ACTIVE_LOCAL];
    double *work = kw_need_memory((size_t)size, sizeof *work);

    memset(local, 0, (size_t)size * sizeof *local);
    for (int l = 0; l <= level; l++) {
        int here[D_MOST], parent[D_MOST], child = 0;

        for (int h = 0; h < spaces->D; h++) {
            here[h] = cell[h] >> (level - l);
            parent[h] = here[h] >> 1;
            child |= (here[h] & 1) << h;
        }
        if (l > 0) {
            kw_twoscale s;

            kw_twoscale_of_cell(spaces, l - 1, parent, &s);
            kw_twoscale_apply(&s, child, size, local, work);
        }
        if (l >= active->mesh->levels)
            continue; /* no function of this level is active */
        kw_active_of_cell(active, l, here, is);
        for (int f = 0; f < active->local; f++)
            for (int a = 0; a < N; a++) {
                double *q = &local[f * N + a];

                if (kind == KW_THB && is[f] >= KW_ACTIVE_COVERED)
                    *q = 0; /* truncated */
                if (is[f] >= KW_ACTIVE_FIRST)
                    *q += c[(size_t)(is[f] - KW_ACTIVE_FIRST) * (size_t)N + (size_t)a];
            }
    }
    free(work);
}

void kw_hiergeo_local(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                      int level, const int *cell, double *local)
{
    const kw_mesh *m = b->active->mesh;

    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    KW_NEED(N >= 1, "N = %d", N);
    local_coefficients(b, m, kind, N, c, level, cell, local);
}

/* Where function j stands among the local functions of a cell. */
static int place_in_cell(const kw_mesh *m, int level, const int *cell, const int *j)
{
    int low[D_MOST], high[D_MOST], place = 0;

    kw_active_box(m, level, cell, low, high);
    for (int h = 0; h < m->D; h++)
        place = place * (high[h] - low[h]) + j[h] - low[h];
    return place;
}

/* Aborts unless every refined cell of the coarse mesh is refined in the fine one, and both
   begin with the same spaces. */
static void need_finer(const kw_mesh *m, const kw_mesh *fine)
{
    int cell[D_MOST];

    KW_NEED(m->D == fine->D, "%d and %d directions", m->D, fine->D);
    KW_NEED(m->levels <= fine->levels, "%d levels and only %d", m->levels, fine->levels);
    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[0].s[h], *t = fine->level[0].s[h];

        KW_NEED(
            s->d == t->d && s->n == t->n &&
                memcmp(s->t, t->t, ((size_t)s->n + (size_t)s->d + 1) * sizeof *s->t) == 0,
            "different spaces of level 0 in direction %d", h);
    }
    for (int level = 0; level < m->levels; level++)
        for (int i = 0; i < m->level[level].count; i++) {
            kw_mesh_multi(m, level, m->level[level].list[i], cell);
            KW_NEED(kw_mesh_refined(fine, level, cell),
                    "cell %d, .. of level %d is not refined in the finer mesh", cell[0],
                    level);
        }
}

/* Function i of `bases`: the entry of the local coefficients of a geometry of b, on an active
   cell of the function's own level, that belongs to it. */
static const double *entry(const kw_hier *b, const kw_hier *bases, int i,
                           kw_hier_kind kind, int N, const double *c, double *local)
{
    const kw_mesh *m = bases->active->mesh;
    int level, j[D_MOST], cell[D_MOST];

    kw_active_function(bases->active, i, &level, j);
    kw_active_cell(bases->active, i, cell);
    local_coefficients(b, m, kind, N, c, level, cell, local);
    return local + (size_t)place_in_cell(m, level, cell, j) * (size_t)N;
}

void kw_hiergeo_refine(const kw_hier *b, const kw_hier *fine, int N, const double *c,
                       double *out)
{
    double *local;

    KW_NEED(N >= 1, "N = %d", N);
    need_finer(b->active->mesh, fine->active->mesh);
    local = kw_need_memory((size_t)b->active->local * (size_t)N, sizeof *local);
    for (int i = 0; i < fine->active->size; i++)
        memcpy(out + (size_t)i * (size_t)N, entry(b, fine, i, KW_THB, N, c, local),
               (size_t)N * sizeof *out);
    free(local);
}

/* On an active cell of its level the coefficient of a function in the sum one is one: what
   the coarser functions leave of it is its weight. */
void kw_hiergeo_weights(const kw_hier *b, double *w)
{
    double local[KW_ACTIVE_LOCAL];

    memset(w, 0, (size_t)b->active->size * sizeof *w);
    for (int i = 0; i < b->active->size; i++)
        w[i] = 1 - *entry(b, b, i, KW_HB, 1, w, local);
}

/* --- representation on one level --- */

/* Steps a multi-index through low <= at < high, last direction first; 0 behind the end. */
static int next_index(int D, const int *low, const int *high, int *at)
{
    for (int h = D - 1; h >= 0; h--) {
        if (++at[h] < high[h])
            return 1;
        at[h] = low[h];
    }
    return 0;
}

/* A box of functions of one level with their coefficients. */
typedef struct box {
    int level, first[D_MOST], count[D_MOST];
    double *c;
} box;

/* The fine functions that the two-scale relations of `count` coarse ones need. */
static void fine_range(const kw_bspline *s, const kw_bspline *fine, int first, int count,
                       int *fine_first, int *fine_count)
{
    double *unused = kw_need_memory((size_t)fine->n, sizeof *unused);
    int last;

    *fine_count = kw_insert_two_scale(s, fine, first + count - 1, &last, unused);
    last += *fine_count - 1;
    kw_insert_two_scale(s, fine, first, fine_first, unused);
    *fine_count = last - *fine_first + 1;
    free(unused);
}

/* The box that the two-scale relation makes of it on the next level. */
static box refined_box(const kw_mesh *m, const box *coarse)
{
    box fine = {.level = coarse->level + 1};
    const double *from = coarse->c;
    double *owned = NULL;
    size_t outer = 1, inner = 1;

    for (int h = 0; h < m->D; h++)
        inner *= (size_t)coarse->count[h];
    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[coarse->level].s[h],
                         *t = m->level[fine.level].s[h];
        size_t n = (size_t)coarse->count[h], size;
        double *to, alpha[K];

        fine_range(s, t, coarse->first[h], coarse->count[h], &fine.first[h],
                   &fine.count[h]);
        size = (size_t)fine.count[h];
        inner /= n;
        to = kw_need_memory(outer * size * inner, sizeof *to);
        for (size_t f = 0; f < size; f++) {
            int at = kw_insert_oslo_row(s, t, fine.first[h] + (int)f, alpha);

            for (int q = 0; q <= s->d; q++) {
                int j = at + q - coarse->first[h];

                if (j < 0 || j >= coarse->count[h] || alpha[q] == 0)
                    continue;
                for (size_t o = 0; o < outer; o++)
                    for (size_t i = 0; i < inner; i++)
                        to[(o * size + f) * inner + i] +=
                            alpha[q] * from[(o * n + (size_t)j) * inner + i];
            }
        }
        free(owned);
        from = owned = to;
        outer *= size;
    }
    KW_NEED(owned, "D = %d", m->D);
    fine.c = owned;
    return fine;
}

/* Sets the coefficients of functions inside Omega^l to zero, where l is the level of the box;
   returns whether one of them was not zero before. */
static int truncate_box(const kw_hier *b, box *f)
{
    int high[D_MOST] = {0}, j[D_MOST] = {0}, truncated = 0;
    size_t at = 0;

    for (int h = 0; h < b->active->mesh->D; h++) {
        j[h] = f->first[h];
        high[h] = f->first[h] + f->count[h];
    }
    do {
        double *c = &f->c[at++];

        if (kw_active_status(b->active, f->level, j) >= KW_ACTIVE_COVERED && *c != 0) {
            *c = 0;
            truncated = 1;
        }
    } while (next_index(b->active->mesh->D, f->first, high, j));
    return truncated;
}

/* Is a cell of `level` refined that lies in the support of function j of level `from`? */
static int meets_support(const kw_mesh *m, int from, const int *j, int level)
{
    const kw_mesh_level *l = &m->level[from];

    for (int i = 0; i < m->level[level].count; i++) {
        int cell[D_MOST], meets = 1;

        kw_mesh_multi(m, level, m->level[level].list[i], cell);
        for (int h = 0; h < m->D; h++) {
            int above = cell[h] >> (level - from);

            meets = meets && l->edge[h][j[h]] <= above &&
                    above < l->edge[h][j[h] + l->s[h]->d + 1];
        }
        if (meets)
            return 1;
    }
    return 0;
}

int kw_hiergeo_new_representation(const kw_hier *b, int i, int *first, int *count,
                                  double **coefficient)
{
    const kw_mesh *m = b->active->mesh;
    box now = {0}, needed; /* as far as we are; the last one in which something was cut */
    int level, j[D_MOST];

    kw_active_function(b->active, i, &level, j);
    now.level = level;
    now.c = kw_need_memory(1, sizeof *now.c);
    now.c[0] = 1;
    for (int h = 0; h < m->D; h++) {
        now.first[h] = j[h];
        now.count[h] = 1;
    }
    needed = now;
    while (now.level + 1 < m->levels && meets_support(m, level, j, now.level)) {
        box next = refined_box(m, &now);

        if (now.c != needed.c)
            free(now.c);
        now = next;
        if (truncate_box(b, &now)) {
            free(needed.c);
            needed = now;
        }
    }
    if (now.c != needed.c)
        free(now.c);
    memcpy(first, needed.first, (size_t)m->D * sizeof *first);
    memcpy(count, needed.count, (size_t)m->D * sizeof *count);
    *coefficient = needed.c;
    return needed.level;
}
