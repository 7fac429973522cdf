/* twoscale.h -- from the local functions of a cell to those of its children.

   On a cell of level l a spline of V^l is a combination of the local functions of the cell;
   on a child it is one of the child's local functions, which belong to V^{l+1}. The new
   coefficients come from the old ones by a small matrix in each direction, the part of the
   Oslo matrix (insert.h) that belongs to the two spans. */
#ifndef KW_TWOSCALE_H
#define KW_TWOSCALE_H

#include "mesh.h"

typedef struct kw_twoscale {
    int D, k[KW_TENSOR_D]; /* directions, orders */
    double a[KW_TENSOR_D][2]
            [(KW_BSPLINE_DEGREE + 1) * (KW_BSPLINE_DEGREE + 1)]; /* for the first and the
                             second half: k x k, row = new local function, column = old one */
} kw_twoscale;

/* Fills s for the halves of a cell of `level`, one level above the last at most. */
void kw_twoscale_of_cell(const kw_mesh *m, int level, const int *cell, kw_twoscale *s);

/* Changes coefficients c in place to those on a child, the second half in direction h if bit h
   of `child` is set: `size` numbers, prod k_h x N, row-major, the last direction before N
   fastest. `work` has as many. */
void kw_twoscale_apply(const kw_twoscale *s, int child, int size, double *restrict c,
                       double *restrict work);

#endif
