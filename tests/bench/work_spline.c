#include "work_spline.h"
#include "curve.h"
#include "insert.h"
#include "need.h"
#include "rng.h"
#include <stdlib.h>

double *new_random(size_t count)
{
    kw_rng r = kw_rng_at(2, 0, 0, 0);
    double *x = kw_need_memory(count, sizeof *x);

    for (size_t i = 0; i < count; i++)
        x[i] = kw_rng_uniform(&r);
    return x;
}

/* --- random points --- */

spline_work *spline_work_new(int d, int spans, int directions, int count, int numbers)
{
    spline_work *w = kw_need_memory(1, sizeof *w);

    w->count = count;
    w->s = kw_bspline_new_open_uniform(d, spans, 0, 1);
    if (directions == 2) {
        const kw_bspline *both[] = {w->s, w->s};

        w->g = kw_tensor_new(2, both);
    }
    w->x = new_random((size_t)count * (size_t)directions);
    w->c = new_random((size_t)(w->g ? kw_tensor_dimension(w->g) : w->s->n) * WORK_N);
    w->first = kw_need_memory((size_t)count, sizeof *w->first);
    w->value = kw_need_memory((size_t)count * (size_t)numbers, sizeof *w->value);
    return w;
}

void spline_work_free(spline_work *w)
{
    kw_bspline_free(w->s);
    kw_tensor_free(w->g);
    free(w->x);
    free(w->c);
    free(w->first);
    free(w->value);
    free(w);
}

void work_basis(void *with)
{
    const spline_work *w = with;

    kw_bspline_basis_many(w->s, w->count, w->x, w->first, w->value);
}

void work_curve(void *with)
{
    const spline_work *w = with;

    kw_curve_point_many(w->s, WORK_N, w->c, w->count, w->x, w->value);
}

void work_curve2(void *with)
{
    const spline_work *w = with;

    kw_curve_derivatives_many(w->s, WORK_N, w->c, w->count, w->x, WORK_DERIVATIVES,
                              w->value);
}

void work_basis2(void *with)
{
    const spline_work *w = with;
    int local = kw_tensor_local(w->g), first[2];

    for (int i = 0; i < w->count; i++)
        kw_tensor_basis(w->g, NULL, w->x + (size_t)2 * (size_t)i, first,
                        w->value + (size_t)i * (size_t)local);
}

void work_surface(void *with)
{
    const spline_work *w = with;

    kw_tensor_point_many(w->g, WORK_N, w->c, NULL, w->count, w->x, w->value);
}

/* --- a grid --- */

static const int grid[] = {WORK_GRID, WORK_GRID};

grid_work *grid_work_new(const spline_work *of)
{
    grid_work *w = kw_need_memory(1, sizeof *w);

    w->of = of;
    w->x = kw_need_memory(WORK_GRID, sizeof *w->x);
    for (int i = 0; i < WORK_GRID; i++)
        w->x[i] = i / (WORK_GRID - 1.0);
    w->room = kw_need_memory(kw_tensor_grid_work(of->g, WORK_N, grid), sizeof *w->room);
    w->point = kw_need_memory((size_t)WORK_GRID * WORK_GRID * WORK_N, sizeof *w->point);
    return w;
}

void grid_work_free(grid_work *w)
{
    free(w->x);
    free(w->room);
    free(w->point);
    free(w);
}

void work_grid(void *with)
{
    const grid_work *w = with;
    const double *x[] = {w->x, w->x};

    kw_tensor_grid(w->of->g, WORK_N, w->of->c, NULL, grid, x, w->room, w->point);
}

/* --- refinement --- */

refine_work *refine_work_new(int d, int n)
{
    refine_work *w = kw_need_memory(1, sizeof *w);

    w->s = kw_bspline_new_open_uniform(d, n - d, 0, 1);
    w->fine = kw_insert_new_dyadic(w->s);
    w->c = new_random((size_t)n * WORK_N);
    w->out = kw_need_memory((size_t)w->fine->n * WORK_N, sizeof *w->out);
    return w;
}

void refine_work_free(refine_work *w)
{
    kw_bspline_free(w->s);
    kw_bspline_free(w->fine);
    free(w->c);
    free(w->out);
    free(w);
}

void work_refine_space(void *with)
{
    const refine_work *w = with;

    kw_bspline_free(kw_insert_new_dyadic(w->s));
}

void work_refine(void *with)
{
    const refine_work *w = with;

    kw_insert_boehm_all(w->s, w->fine, WORK_N, w->c, w->out);
}
