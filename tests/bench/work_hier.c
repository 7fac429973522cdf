#include "work_hier.h"
#include "../../chapters/9-cost/diagonal.h"
#include "need.h"
#include "work_spline.h"
#include <stdlib.h>

hier_work *hier_work_new(int d, int cells, int times, int count)
{
    hier_work *w = kw_need_memory(1, sizeof *w);
    double *c;

    w->m = new_diagonal(d, cells, times);
    w->b = kw_hier_new(w->m);
    w->kind = KW_THB;
    w->count = count;
    w->x = new_random((size_t)2 * (size_t)count);
    for (int i = 0; i < count; i += 2)
        w->x[2 * i + 1] = w->x[2 * i];
    w->y = kw_need_memory((size_t)count * WORK_N, sizeof *w->y);
    w->found = kw_need_memory(WORK_BLOCK, sizeof *w->found);
    w->index = kw_need_memory((size_t)WORK_BLOCK * (size_t)w->b->most, sizeof *w->index);
    w->value = kw_need_memory((size_t)WORK_BLOCK * (size_t)w->b->most, sizeof *w->value);
    c = new_random((size_t)w->b->active->size * WORK_N);
    w->p = kw_hierpieces_new(w->b, w->kind, WORK_N, c);
    free(c);
    return w;
}

void hier_work_free(hier_work *w)
{
    free(w->x);
    free(w->y);
    free(w->found);
    free(w->index);
    free(w->value);
    kw_hierpieces_free(w->p);
    kw_hier_free(w->b);
    kw_mesh_free(w->m);
    free(w);
}

void work_build(void *with)
{
    const hier_work *w = with;

    kw_hier_free(kw_hier_new(w->m));
}

void work_functions(void *with)
{
    hier_work *w = with;
    double listed = 0;

    for (int done = 0; done < w->count; done += WORK_BLOCK) {
        int block = w->count - done < WORK_BLOCK ? w->count - done : WORK_BLOCK;

        kw_hier_at_many(w->b, w->kind, NULL, block, w->x + (size_t)2 * (size_t)done,
                        w->found, w->index, w->value);
        for (int i = 0; i < block; i++)
            listed += w->found[i];
    }
    w->listed = listed / w->count;
}

void work_hierpieces(void *with)
{
    const hier_work *w = with;

    kw_hierpieces_point_many(w->p, NULL, w->count, w->x, w->y);
}
