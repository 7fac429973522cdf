/* cellbasis.h -- the local functions of a cell at a point in it.

   The functions of the cell's level that are not zero on it, prod (d_h+1) of them, are products of
   the local functions of its spans (bspline.h). Its spans are known, so nothing is searched for;
   values are the same to the bit as those of kw_tensor_basis. */
#ifndef KW_CELLBASIS_H
#define KW_CELLBASIS_H

#include "mesh.h"

/* The derivatives of orders r (NULL: the values) of the functions that are local to the cell of
   `level` with the spans span[0..D-1], at x in it: value[0 .. prod (d_h+1) - 1], in the order of
   kw_tensor_basis. */
void kw_cellbasis_at(const kw_mesh *m, int level, const int *span, const int *r,
                     const double *x, double *value);

#endif
