#include "hiergeo.h"
#include "box.h"
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

/* Function i of `bases`: the entry of the local coefficients of a geometry of b,
   on an active cell of the function's own level, that belongs to it. */
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

/* On an active cell of level l no finer function is there. What the geometry has of beta_j^l
   is the coefficient of the function, and, of an HB-spline, what the coarser ones bring. */
void kw_hiergeo_refine(const kw_hier *b, const kw_hier *fine, kw_hier_kind kind, int N,
                       const double *c, double *out)
{
    double *local;

    KW_NEED(N >= 1, "N = %d", N);
    need_finer(b->active->mesh, fine->active->mesh);
    local = kw_need_memory((size_t)b->active->local * (size_t)N, sizeof *local);
    memset(out, 0, (size_t)fine->active->size * (size_t)N * sizeof *out);
    for (int i = 0; i < fine->active->size; i++) {
        double *here = out + (size_t)i * (size_t)N;
        const double *part;

        if (kind == KW_HB) {
            part = entry(fine, fine, i, KW_HB, N, out, local);
            for (int a = 0; a < N; a++)
                here[a] = -part[a];
        }
        part = entry(b, fine, i, kind, N, c, local);
        for (int a = 0; a < N; a++)
            here[a] += part[a];
    }
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

/* A box of functions of one level with their coefficients. */
typedef struct box {
    int level, first[D_MOST], count[D_MOST];
    double *c;
} box;

/* Has coarse function j a share of fine function i? */
static int has_share(const kw_bspline *s, const kw_bspline *fine, int i, int j)
{
    double alpha[K];
    int q = j - kw_insert_oslo_row(s, fine, i, alpha);

    return 0 <= q && q <= s->d && alpha[q] != 0;
}

/* The fine functions that have a share of `count` coarse ones in direction h. They are among
   those that are local to the cells of the support. */
static void fine_range(const kw_mesh *m, int level, int h, int first, int count,
                       int *fine_first, int *fine_count)
{
    const kw_mesh_level *l = &m->level[level], *fine = l + 1;
    int d = l->s[h]->d, last = first + count - 1;
    int from = fine->span[h][2 * l->edge[h][first]] - d;
    int to = fine->span[h][2 * l->edge[h][last + d + 1] - 1];

    while (!has_share(l->s[h], fine->s[h], from, first))
        from++;
    while (!has_share(l->s[h], fine->s[h], to, last))
        to--;
    *fine_first = from;
    *fine_count = to - from + 1;
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

        fine_range(m, coarse->level, h, coarse->first[h], coarse->count[h],
                   &fine.first[h], &fine.count[h]);
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

/* Sets the coefficients of functions inside Omega^l to zero, where l is the level of the box. */
static void truncate_box(const kw_hier *b, box *f)
{
    int high[D_MOST] = {0}, j[D_MOST] = {0};
    size_t at = 0;

    for (int h = 0; h < b->active->mesh->D; h++) {
        j[h] = f->first[h];
        high[h] = f->first[h] + f->count[h];
    }
    do {
        if (kw_active_status(b->active, f->level, j) >= KW_ACTIVE_COVERED)
            f->c[at] = 0;
        at++;
    } while (kw_box_next(b->active->mesh->D, f->first, high, j));
}

/* The local coefficients of a THB-spline on a cell of each level, on the way down. */
typedef struct way {
    const kw_hier *b;
    int children;     /* of a cell */
    double *c, *work; /* levels x local, local */
} way;

/* Cuts off what Definition 5 does from the coefficients on a cell. Returns 1 if one of them
   was not zero, and sets *left to whether one is not zero still. */
static int truncate_cell(const kw_active *a, int level, const int *cell, double *c,
                         int *left)
{
    int is[KW_ACTIVE_LOCAL], cut = 0;

    *left = 0;
    kw_active_of_cell(a, level, cell, is);
    for (int f = 0; f < a->local; f++) {
        if (is[f] >= KW_ACTIVE_COVERED) {
            cut = cut || c[f] != 0;
            c[f] = 0;
        }
        *left = *left || c[f] != 0;
    }
    return cut;
}

/* The finest level on which something is cut off below a cell whose coefficients are known, or
   -1. It goes as deep as there are cells and something is left. */
static int last_cut_below(const way *w, int level, const int *cell)
{
    const kw_mesh *m = w->b->active->mesh;
    int local = w->b->active->local, last = -1;
    double *here = w->c + (size_t)level * (size_t)local, *below = here + local;
    kw_twoscale halves;

    if (!kw_mesh_refined(m, level, cell))
        return -1;
    kw_twoscale_of_cell(m, level, cell, &halves);
    for (int child = 0; child < w->children; child++) {
        int at[D_MOST] = {0}, left, deeper = -1;

        for (int h = 0; h < m->D; h++)
            at[h] = 2 * cell[h] + (child >> h & 1);
        memcpy(below, here, (size_t)local * sizeof *below);
        kw_twoscale_apply(&halves, child, local, below, w->work);
        if (truncate_cell(w->b->active, level + 1, at, below, &left))
            last = last > level + 1 ? last : level + 1;
        if (left)
            deeper = last_cut_below(w, level + 1, at);
        last = last > deeper ? last : deeper;
    }
    return last;
}

/* The last level on which something of function j is cut off; its own if nothing is. */
static int last_cut(const kw_hier *b, int level, const int *j)
{
    const kw_mesh *m = b->active->mesh;
    size_t local = (size_t)b->active->local;
    way w = {b, 1 << m->D, kw_need_memory((size_t)m->levels * local, sizeof *w.c),
             kw_need_memory(local, sizeof *w.work)};
    double *c = w.c + (size_t)level * local;
    int low[D_MOST] = {0}, high[D_MOST] = {0}, cell[D_MOST], last = level;

    for (int h = 0; h < m->D; h++) {
        low[h] = m->level[level].edge[h][j[h]];
        high[h] = m->level[level].edge[h][j[h] + m->level[level].s[h]->d + 1];
    }
    memcpy(cell, low, sizeof cell);
    do {
        int place = place_in_cell(m, level, cell, j), below;

        c[place] = 1;
        below = last_cut_below(&w, level, cell);
        c[place] = 0;
        last = last > below ? last : below;
    } while (kw_box_next(m->D, low, high, cell));
    free(w.c);
    free(w.work);
    return last;
}

int kw_hiergeo_new_representation(const kw_hier *b, int i, int *first, int *count,
                                  double **coefficient)
{
    const kw_mesh *m = b->active->mesh;
    box now = {0};
    int level, last, j[D_MOST];

    kw_active_function(b->active, i, &level, j);
    last = last_cut(b, level, j);
    now.level = level;
    now.c = kw_need_memory(1, sizeof *now.c);
    now.c[0] = 1;
    for (int h = 0; h < m->D; h++) {
        now.first[h] = j[h];
        now.count[h] = 1;
    }
    while (now.level < last) {
        box next = refined_box(m, &now);

        free(now.c);
        now = next;
        truncate_box(b, &now);
    }
    memcpy(first, now.first, (size_t)m->D * sizeof *first);
    memcpy(count, now.count, (size_t)m->D * sizeof *count);
    *coefficient = now.c;
    return now.level;
}
