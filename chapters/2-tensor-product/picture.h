/* picture.h -- what the drivers of this lesson draw or count alike, for D = 2 on the unit
   square. */
#ifndef PICTURE_H
#define PICTURE_H

#include "need.h"
#include "out.h"
#include "tensor.h"
#include <math.h>
#include <stdlib.h>

/* Writes a row of three numbers. */
static inline void write_row3(kw_out *f, double x, double y, double z)
{
    kw_out_number(f, x);
    kw_out_number(f, y);
    kw_out_number(f, z);
    kw_out_row(f);
}

/* The knot lines of the domain, as a section of segments (x, y). */
static inline void write_knot_lines(kw_out *f, const char *name, const kw_tensor *g)
{
    kw_out_section(f, name, "x y");
    for (int h = 0; h < 2; h++)
        for (int i = g->s[h]->d; i <= g->s[h]->n; i++) {
            for (int end = 0; end <= 1; end++) {
                kw_out_number(f, h == 0 ? g->s[h]->t[i] : end);
                kw_out_number(f, h == 0 ? end : g->s[h]->t[i]);
                kw_out_row(f);
            }
            kw_out_gap(f);
        }
}

/* The cells of the grid of knot lines: the product of the numbers of spans. */
static inline int count_cells(const kw_tensor *g)
{
    int cells = 1;

    for (int h = 0; h < g->D; h++) {
        int spans = 0;

        for (int i = g->s[h]->d; i < g->s[h]->n; i++)
            spans += g->s[h]->t[i] < g->s[h]->t[i + 1];
        cells *= spans;
    }
    return cells;
}

/* A whole basis as one surface: at each point of a grid of cells x cells the largest of its
   functions. */
static inline void write_largest(kw_out *f, const char *name, const kw_tensor *g,
                                 int cells)
{
    int count = kw_tensor_local(g);
    double *local = kw_need_memory((size_t)count, sizeof *local);

    kw_out_section(f, name, "x y value");
    for (int a = 0; a <= cells; a++) {
        for (int b = 0; b <= cells; b++) {
            const double x[2] = {(double)a / cells, (double)b / cells};
            double largest = 0;
            int first[2];

            kw_tensor_basis(g, NULL, x, first, local);
            for (int i = 0; i < count; i++)
                largest = fmax(largest, local[i]);
            write_row3(f, x[0], x[1], largest);
        }
        kw_out_gap(f);
    }
    free(local);
}

#endif
