/* meshes.h -- what the drivers of this lesson share: meshes to begin with, random meshes, and
   cells as boxes for a picture. */
#ifndef MESHES_H
#define MESHES_H

#include "hier.h"
#include "out.h"
#include "rng.h"
#include <stdlib.h>

/* `cells` equal cells of [0,1] in each of D directions, open knots, one degree. */
static inline kw_mesh *uniform_mesh(int D, int degree, int cells)
{
    kw_bspline *s = kw_bspline_new_open_uniform(degree, cells, 0, 1);
    const kw_bspline *all[KW_TENSOR_D] = {s, s, s};
    kw_tensor *g = kw_tensor_new(D, all);
    kw_mesh *m = kw_mesh_new(g);

    kw_tensor_free(g);
    kw_bspline_free(s);
    return m;
}

/* Refines the cells low .. high-1 of a mesh with D = 1. */
static inline void refine_interval(kw_mesh *m, int level, int low, int high)
{
    kw_mesh_refine(m, level, &low, &high);
}

/* Refines one cell of a mesh with D = 2. */
static inline void refine_cell(kw_mesh *m, int level, int i, int j)
{
    const int low[2] = {i, j}, high[2] = {i + 1, j + 1};

    kw_mesh_refine(m, level, low, high);
}

/* Refines one or two random boxes on each of the levels 0 .. rounds-1, as far as there are
   cells to refine. */
static inline void refine_boxes(kw_mesh *m, kw_rng *r, int rounds)
{
    for (int level = 0; level < rounds && level < m->levels; level++)
        for (int boxes = 1 + kw_rng_below(r, 2); boxes > 0; boxes--) {
            int low[KW_TENSOR_D] = {0}, high[KW_TENSOR_D] = {0};

            for (int h = 0; h < m->D; h++) {
                int cells = m->level[level].cells[h], size = 1 + kw_rng_below(r, cells);

                low[h] = kw_rng_below(r, cells - size + 1);
                high[h] = low[h] + size;
            }
            kw_mesh_refine(m, level, low, high);
        }
}

/* Sample `sample` of random meshes in D directions: degree 1 .. 3, 3 .. 6 cells, and two or
   three rounds of random boxes on ever finer levels. */
static inline kw_mesh *random_mesh(uint64_t seed, uint64_t sample, int D)
{
    kw_rng r = kw_rng_at(seed, 0, sample, (uint64_t)D);
    int degree = 1 + kw_rng_below(&r, 3), rounds = 2 + kw_rng_below(&r, 2);
    kw_mesh *m = uniform_mesh(D, degree, 3 + kw_rng_below(&r, 4));

    refine_boxes(m, &r, rounds);
    return m;
}

/* Sample `sample` of random meshes of a given degree on 8, 4 or 2 cells a direction in D = 1,
   2 or 3, with two rounds of random boxes. Up to degree 2 the knots of a function lie a power
   of two apart: then all that is computed on it at points with few binary digits is exact. */
static inline kw_mesh *dyadic_mesh(uint64_t seed, uint64_t sample, int D, int degree)
{
    kw_rng r = kw_rng_at(seed, 1, sample, (uint64_t)D);
    kw_mesh *m = uniform_mesh(D, degree, 16 >> D);

    refine_boxes(m, &r, 2);
    return m;
}

/* The ends of a cell in direction h. */
static inline void cell_ends(const kw_mesh *m, int level, int h, int cell, double *low,
                             double *high)
{
    const kw_mesh_level *l = &m->level[level];
    int span = l->span[h][cell];

    *low = l->s[h]->t[span];
    *high = l->s[h]->t[span + 1];
}

/* A number that belongs to an active cell, for a picture. */
typedef double number_of_cell(const kw_hier *b, int level, const int *cell);

/* The active cells of a mesh with D = 2 as a section of boxes with their level and a number of
   each; NULL for none. */
static inline void write_cells(kw_out *f, const char *name, const kw_hier *b,
                               number_of_cell *number)
{
    const kw_mesh *m = b->active->mesh;

    kw_out_section(f, name, "x y x_low x_high y_low y_high level number");
    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];
            double low[2], high[2];

            kw_mesh_multi(m, level, list[i], cell);
            if (kw_mesh_refined(m, level, cell))
                continue;
            for (int h = 0; h < 2; h++)
                cell_ends(m, level, h, cell[h], &low[h], &high[h]);
            kw_out_number(f, (low[0] + high[0]) / 2);
            kw_out_number(f, (low[1] + high[1]) / 2);
            kw_out_number(f, low[0]);
            kw_out_number(f, high[0]);
            kw_out_number(f, low[1]);
            kw_out_number(f, high[1]);
            kw_out_number(f, level);
            kw_out_number(f, number ? number(b, level, cell) : 0);
            kw_out_row(f);
        }
        free(list);
    }
}

#endif
