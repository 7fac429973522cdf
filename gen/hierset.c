#include "hierset.h"
#include "draw.h"
#include "gen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { DIAGONAL, BOXES, FRONT, SCATTERED };

/* Purposes of random numbers; the families begin behind them. */
enum { WHERE = 100, WHICH };

/* Where a mesh is refined. */
typedef struct refiner {
    int kind, D;
    double low[KW_TENSOR_D], high[KW_TENSOR_D]; /* of the box of the present level */
    double centre[KW_TENSOR_D], radius;         /* of the front */
    kw_rng random;                              /* of single cells */
} refiner;

int hierset_check(const gen_call *c)
{
    const double finest = ldexp(gen_whole(c, HIER_CELLS), gen_whole(c, HIER_LEVELS) - 1);
    const int D = gen_whole(c, HIER_DIM);

    if (pow(finest, D) <= 0x1p22)
        return GEN_GOOD;
    return gen_say(GEN_BAD_CALL,
                   "--dim %d, --cells %d, --levels %d: more than 2^22 cells if all "
                   "were refined",
                   D, gen_whole(c, HIER_CELLS), gen_whole(c, HIER_LEVELS));
}

void hierset_plan(const gen_call *c, gen_plan *p, const char *more)
{
    static const char *const columns[] = {"level c1", "level c1 c2", "level c1 c2 c3"};
    char counts[GEN_TEXT];

    snprintf(counts, sizeof counts, "levels cells%s", more);
    gen_plan_add_integers(p, "counts", 1, counts,
                          "levels that are in use, and rows of the other arrays");
    gen_plan_add_integers(p, "per_level", gen_whole(c, HIER_LEVELS),
                          "level cells functions",
                          "active cells and functions of each level");
    gen_plan_add_integers(p, "cells", 0, columns[gen_whole(c, HIER_DIM) - 1],
                          "the active cells: level, and which one in each direction, of "
                          "--cells times 2^level equal ones of [0,1]");
}

/* --- which cells --- */

void hierset_corners(const kw_mesh *m, int level, const int *cell, double *low,
                     double *high)
{
    const kw_mesh_level *l = &m->level[level];

    for (int h = 0; h < m->D; h++) {
        int span = l->span[h][cell[h]];

        low[h] = l->s[h]->t[span];
        high[h] = l->s[h]->t[span + 1];
    }
}

static refiner begin(const gen_call *c, const gen_sample *s)
{
    refiner r = {.kind = gen_whole(c, HIER_KIND), .D = gen_whole(c, HIER_DIM)};
    kw_rng where = gen_rng(c, s, WHERE);

    gen_draw_uniform(&where, 0, 1, r.D, r.centre);
    r.radius = 0.2 + 0.4 * kw_rng_uniform(&where);
    r.random = gen_rng(c, s, WHICH);
    for (int h = 0; h < r.D; h++)
        r.high[h] = 1;
    return r;
}

/* The box of the next level: a random part of the present one, from 0.5 to 0.8 of its sides. */
static void shrink(refiner *r)
{
    for (int h = 0; h < r->D; h++) {
        double side = r->high[h] - r->low[h],
               part = 0.5 + 0.3 * kw_rng_uniform(&r->random);

        r->low[h] += side * (1 - part) * kw_rng_uniform(&r->random);
        r->high[h] = r->low[h] + side * part;
    }
}

/* Does the sphere about the centre pass between the nearest and the farthest point of the cell? */
static int meets_front(const refiner *r, const double *low, const double *high)
{
    double near = 0, far = 0;

    for (int h = 0; h < r->D; h++) {
        double a = low[h] - r->centre[h], b = high[h] - r->centre[h];
        double least = a > 0 ? a : b < 0 ? -b : 0, most = -a > b ? -a : b;

        near += least * least;
        far += most * most;
    }
    return near <= r->radius * r->radius && r->radius * r->radius <= far;
}

/* Has the cell a point of the diagonal, all coordinates equal? In one direction: the point
   centre[0]. */
static int meets_diagonal(const refiner *r, const double *low, const double *high)
{
    double from = r->D > 1 ? low[0] : r->centre[0],
           to = r->D > 1 ? high[0] : r->centre[0];

    for (int h = 0; h < r->D; h++) {
        from = low[h] > from ? low[h] : from;
        to = high[h] < to ? high[h] : to;
    }
    return r->D > 1 ? from < to : from <= to;
}

static int middle_in_box(const refiner *r, const double *low, const double *high)
{
    for (int h = 0; h < r->D; h++) {
        double middle = 0.5 * (low[h] + high[h]);

        if (middle < r->low[h] || middle > r->high[h])
            return 0;
    }
    return 1;
}

static int is_wanted(refiner *r, const double *low, const double *high)
{
    if (r->kind == DIAGONAL)
        return meets_diagonal(r, low, high);
    if (r->kind == BOXES)
        return middle_in_box(r, low, high);
    if (r->kind == FRONT)
        return meets_front(r, low, high);
    return kw_rng_below(&r->random, 3) == 0;
}

/* --- meshes --- */

static void refine_level(kw_mesh *m, int level, refiner *r)
{
    long long count;
    uint64_t *flat = kw_mesh_cells(m, level, &count);

    if (r->kind == BOXES)
        shrink(r);
    for (long long i = 0; i < count; i++) {
        double low[KW_TENSOR_D] = {0}, high[KW_TENSOR_D] = {0};
        int cell[KW_TENSOR_D], end[KW_TENSOR_D];

        kw_mesh_multi(m, level, flat[i], cell);
        hierset_corners(m, level, cell, low, high);
        for (int h = 0; h < m->D; h++)
            end[h] = cell[h] + 1;
        if (is_wanted(r, low, high))
            kw_mesh_refine(m, level, cell, end);
    }
    free(flat);
}

kw_mesh *hierset_new(const gen_call *c, const gen_sample *s)
{
    const int D = gen_whole(c, HIER_DIM);
    kw_bspline *b = kw_bspline_new_open_uniform(gen_whole(c, HIER_DEGREE),
                                                gen_whole(c, HIER_CELLS), 0, 1);
    kw_tensor *g = kw_tensor_new(D, (const kw_bspline *const[]){b, b, b});
    kw_mesh *m = kw_mesh_new(g);
    refiner r = begin(c, s);

    for (int l = 0; l + 1 < gen_whole(c, HIER_LEVELS) && l < m->levels; l++)
        refine_level(m, l, &r);
    kw_tensor_free(g);
    kw_bspline_free(b);
    return m;
}

/* --- arrays --- */

static int count_cells(const kw_mesh *m)
{
    long long cells = 0;

    for (int l = 0; l < m->levels; l++)
        cells += kw_mesh_active(m, l);
    return (int)cells;
}

static void fill_cells(const kw_mesh *m, double *row)
{
    for (int l = 0; l < m->levels; l++) {
        long long count;
        uint64_t *flat = kw_mesh_cells(m, l, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];

            kw_mesh_multi(m, l, flat[i], cell);
            if (kw_mesh_refined(m, l, cell))
                continue;
            *row++ = l;
            for (int h = 0; h < m->D; h++)
                *row++ = cell[h];
        }
        free(flat);
    }
}

double *hierset_fill(const gen_call *c, gen_sample *s, const kw_active *a)
{
    const kw_mesh *m = a->mesh;
    const int levels = gen_whole(c, HIER_LEVELS), cells = count_cells(m);
    double *counts = gen_rows(s, HIER_COUNTS, 1),
           *row = gen_rows(s, HIER_PER_LEVEL, levels);

    counts[0] = m->levels;
    counts[1] = cells;
    for (int l = 0; l < levels; l++, row += 3) {
        row[0] = l;
        row[1] = l < m->levels ? (double)kw_mesh_active(m, l) : 0;
        row[2] = l < m->levels ? a->start[l + 1] - a->start[l] : 0;
    }
    fill_cells(m, gen_rows(s, HIER_ACTIVE, cells));
    return counts + 2;
}
