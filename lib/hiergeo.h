/* hiergeo.h -- coefficients of hierarchical splines, from one representation to another.

   b is a pair of bases (hier.h), c coefficients of size x N, row-major. */
#ifndef KW_HIERGEO_H
#define KW_HIERGEO_H

#include "hier.h"

/* The geometry on a cell of any level that lies in an active cell: its coefficients in the
   local functions of the cell, local: prod (d_h+1) x N. */
void kw_hiergeo_local(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                      int level, const int *cell, double *local);

/* The same geometry on a finer mesh, whose domains contain those of b's mesh level by level:
   from coefficients c in b to coefficients `out`, fine->active->size x N, in `fine`, both of
   the same kind. THB coefficients are read off: that of tau_j^l is the coefficient of beta_j^l
   on any active cell of level l, and functions that stay keep theirs to the bit. An HB
   coefficient is what the coarser HB-splines leave of this; it may change even if its function
   stays, where a coarser one is dropped. [Giannelli, Juettler, Speleers: Strongly stable bases for
   adaptively refined multilevel spline spaces, Adv. Comput. Math. 40 (2014)] */
void kw_hiergeo_refine(const kw_hier *b, const kw_hier *fine, kw_hier_kind kind, int N,
                       const double *c, double *out);

/* The weights w[0..size-1] with which the HB-splines add up to one; there are no others. They
   are not negative but for rounding, and may be zero. */
void kw_hiergeo_weights(const kw_hier *b, double *w);

/* THB-spline i in B-splines of one level, the coarsest on which nothing of it is left to be
   truncated; returns that level. The B-splines are those of the box first[h] <= j[h] <
   first[h] + count[h]; *coefficient, row-major, is freed by the caller. Time and memory follow
   the cells of all levels in the support and the size of the box. */
int kw_hiergeo_new_representation(const kw_hier *b, int i, int *first, int *count,
                                  double **coefficient);

#endif
