/* hierpieces.h -- geometries (19) in hierarchical splines, at points.

   A geometry is the sum over i of c_i times function i (hier.h), with coefficients c of size x
   N, row-major: c_j^l stands at the index i of its function. [source text, (19), with the level
   that it leaves out]

   On each active cell it is one polynomial, kept as coefficients in the local functions of the
   cell. So a point costs the way down to its cell and prod (d_h+1) x N products, no matter how
   many functions overlap there. */
#ifndef KW_HIERPIECES_H
#define KW_HIERPIECES_H

#include "hier.h"

typedef struct kw_hierpieces {
    const kw_hier *b; /* not owned */
    int N;
    double *c; /* b->tree->leaves x prod (d_h+1) x N; owned */
} kw_hierpieces;

/* N >= 1. Time and memory are linear in the number of cells; c is not needed afterwards, b is.
   The caller frees. Never NULL. */
kw_hierpieces *kw_hierpieces_new(const kw_hier *b, kw_hier_kind kind, int N,
                                 const double *c);
void kw_hierpieces_free(kw_hierpieces *p);

/* The derivative of orders r (NULL: the value) at x: point[0..N-1]. */
void kw_hierpieces_point(const kw_hierpieces *p, const int *r, const double *x,
                         double *point);

/* The same at many points: x is count x D, point is count x N. The same bits as one by one, in
   less time; nothing is allocated. */
void kw_hierpieces_point_many(const kw_hierpieces *p, const int *r, int count,
                              const double *x, double *point);

#endif
