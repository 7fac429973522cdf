#include "hierpieces.h"
#include "need.h"
#include "twoscale.h"
#include <stdlib.h>
#include <string.h>

enum { D_MOST = KW_TENSOR_D };

/* What is carried along on the way down: the geometry on a cell of each level, in functions of
   that level and coarser ones. */
typedef struct carried {
    double *c; /* local x N */
    kw_twoscale halves;
    int is[KW_ACTIVE_LOCAL];
} carried;

typedef struct walk {
    kw_hierpieces *p;
    kw_hier_kind kind;
    const double *c;
    carried *level;
    double *work; /* local x N */
} walk;

/* Adds the active functions of the cell's level. THB: what the coarser ones have in functions
   that lie in Omega^level is cut off first. */
static void add_level(const walk *w, const carried *now)
{
    size_t N = (size_t)w->p->N;

    for (int f = 0; f < w->p->b->active->local; f++)
        for (size_t a = 0; a < N; a++) {
            double *q = &now->c[(size_t)f * N + a];

            if (w->kind == KW_THB && now->is[f] >= KW_ACTIVE_COVERED)
                *q = 0;
            if (now->is[f] >= KW_ACTIVE_FIRST)
                *q += w->c[(size_t)(now->is[f] - KW_ACTIVE_FIRST) * N + a];
        }
}

static void descend(walk *w, int node, int level, const int *cell)
{
    const kw_hier *b = w->p->b;
    const kw_mesh *m = b->active->mesh;
    int size = b->active->local * w->p->N, first = b->tree->node[node].child;
    carried *now = &w->level[level];

    kw_active_of_cell(b->active, level, cell, now->is);
    add_level(w, now);
    if (first < 0) {
        memcpy(w->p->c + (size_t)(-1 - first) * (size_t)size, now->c,
               (size_t)size * sizeof *now->c);
        return;
    }
    kw_twoscale_of_cell(m, level, cell, &now->halves);
    for (int c = 0; c < 1 << m->D; c++) {
        int child[D_MOST] = {0};

        for (int h = 0; h < m->D; h++)
            child[h] = 2 * cell[h] + (c >> h & 1);
        memcpy(now[1].c, now->c, (size_t)size * sizeof *now->c);
        kw_twoscale_apply(&now->halves, c, size, now[1].c, w->work);
        descend(w, first + c, level + 1, child);
    }
}

kw_hierpieces *kw_hierpieces_new(const kw_hier *b, kw_hier_kind kind, int N,
                                 const double *c)
{
    const kw_mesh *m = b->active->mesh;
    size_t size = (size_t)b->active->local * (size_t)N;
    kw_hierpieces *p = kw_need_memory(1, sizeof *p);
    walk w = {p, kind, c, NULL, NULL};
    long long cells;

    KW_NEED(N >= 1, "N = %d", N);
    p->b = b;
    p->N = N;
    p->c = kw_need_memory((size_t)b->tree->leaves * size, sizeof *p->c);
    w.work = kw_need_memory(size, sizeof *w.work);
    w.level = kw_need_memory((size_t)m->levels, sizeof *w.level);
    for (int l = 0; l < m->levels; l++)
        w.level[l].c = kw_need_memory(size, sizeof *w.work);
    free(kw_mesh_cells(m, 0, &cells));
    for (int i = 0; i < (int)cells; i++) {
        int cell[D_MOST];

        kw_mesh_multi(m, 0, (uint64_t)i, cell);
        memset(w.level[0].c, 0, size * sizeof *w.work);
        descend(&w, i, 0, cell);
    }
    for (int l = 0; l < m->levels; l++)
        free(w.level[l].c);
    free(w.level);
    free(w.work);
    return p;
}

void kw_hierpieces_free(kw_hierpieces *p)
{
    if (!p)
        return;
    free(p->c);
    free(p);
}

/* The sum of all local functions times their coefficients. A constant N keeps it in
   registers. */
static inline void sum_up(int local, int N, const double *restrict value,
                          const double *restrict c, double *restrict point)
{
    for (int a = 0; a < N; a++)
        point[a] = 0;
    for (int f = 0; f < local; f++, c += N)
        for (int a = 0; a < N; a++)
            point[a] += value[f] * c[a];
}

static void piece(const kw_hierpieces *p, int leaf, const double *value, double *point)
{
    const int local = p->b->active->local;
    const double *c = p->c + (size_t)leaf * (size_t)local * (size_t)p->N;

    if (p->N == 1)
        sum_up(local, 1, value, c, point);
    else if (p->N == 2)
        sum_up(local, 2, value, c, point);
    else if (p->N == 3)
        sum_up(local, 3, value, c, point);
    else
        sum_up(local, p->N, value, c, point);
}

/* Points that are looked at together: first the cells of all, then the local functions, then
   the sums. */
enum { TOGETHER = 64 };

void kw_hierpieces_point_many(const kw_hierpieces *p, const int *r, int count,
                              const double *x, double *point)
{
    const int D = p->b->active->mesh->D, local = p->b->active->local;
    const int room = KW_ACTIVE_LOCAL / local, most = room < TOGETHER ? room : TOGETHER;
    int leaf[TOGETHER];
    double value[KW_ACTIVE_LOCAL]; /* most x local */

    KW_NEED(count >= 0, "%d points", count);
    for (int now; count > 0; count -= now) {
        now = count < most ? count : most;
        kw_celltree_leaf_many(p->b->tree, now, x, leaf);
        for (int i = 0; i < now; i++, x += D)
            kw_hier_local(p->b, leaf[i], r, x, value + i * local);
        for (int i = 0; i < now; i++, point += p->N)
            piece(p, leaf[i], value + i * local, point);
    }
}

void kw_hierpieces_point(const kw_hierpieces *p, const int *r, const double *x,
                         double *point)
{
    kw_hierpieces_point_many(p, r, 1, x, point);
}
