/* tensor.h -- tensor-product B-splines in D = 1, 2 or 3 directions.

   Direction h has its own space g->s[h] (bspline.h), degree and knots. Conventions:
     multi-index   j[0..D-1], 0 <= j[h] < n_h = g->s[h]->n, stands for the function
                   beta_j(x) = product over h of beta_{j[h]}(x[h])
     flat index    row-major, the last direction runs fastest
     point         x[0..D-1], in the domain, the closed box of the univariate domains
     orders        r[0..D-1] >= 0, how often to differentiate in each direction; NULL
                   stands for the value itself
     coefficients  c, n_0 x .. x n_{D-1} x N, row-major, N >= 1, at most INT_MAX numbers
   Arrays do not overlap. Nothing is allocated but by kw_tensor_new*.
   [source text, section 1.1, (10) with indices from 0, (11)] */
#ifndef KW_TENSOR_H
#define KW_TENSOR_H

#include "bspline.h"
#include <stddef.h>

enum { KW_TENSOR_D = 3 };

typedef struct kw_tensor {
    int D;
    kw_bspline *s[KW_TENSOR_D]; /* s[0..D-1]; owned */
} kw_tensor;

/* --- spaces; the caller frees them; never NULL --- */

/* The product of the D spaces s[0..D-1], which are copied. */
kw_tensor *kw_tensor_new(int D, const kw_bspline *const *s);

/* g with `fine` in direction h: one more knot line, say, with kw_insert_new_knot. */
kw_tensor *kw_tensor_new_direction(const kw_tensor *g, int h, const kw_bspline *fine);

/* g with every span of every direction halved. */
kw_tensor *kw_tensor_new_dyadic(const kw_tensor *g);

/* Frees g; NULL is fine. */
void kw_tensor_free(kw_tensor *g);

/* --- indices --- */

/* The dimension, the product of all n_h; it fits an int (kw_tensor_new needs that). */
int kw_tensor_dimension(const kw_tensor *g);

/* How many functions are non-zero at a point inside a cell, the product of all d_h + 1. */
int kw_tensor_local(const kw_tensor *g);

/* From a multi-index to the flat index, and back. */
int kw_tensor_flat(const kw_tensor *g, const int *j);
void kw_tensor_multi(const kw_tensor *g, int flat, int *j);

/* --- functions --- */

/* The derivatives of orders r of the local functions at x: value, (d_0+1) x .. x
   (d_{D-1}+1), belongs to the multi-indices first[h] + i[h], 0 <= i[h] <= d_h. */
void kw_tensor_basis(const kw_tensor *g, const int *r, const double *x, int *first,
                     double *value);

/* The derivative of orders r of the function with multi-index j, at any finite x. */
double kw_tensor_one(const kw_tensor *g, const int *j, const int *r, const double *x);

/* --- geometries s(x) = sum over j of c_j beta_j(x) --- */

/* The derivative of orders r at x: point[0..N-1]. */
void kw_tensor_point(const kw_tensor *g, int N, const double *c, const int *r,
                     const double *x, double *point);

/* The same bits at many points: x is count x D, count >= 0, point is count x N. */
void kw_tensor_point_many(const kw_tensor *g, int N, const double *c, const int *r,
                          int count, const double *x, double *point);

/* The same on the grid of the points (x[0][i_0], .., x[D-1][i_{D-1}]), 0 <= i_h < count[h]:
   point is count[0] x .. x count[D-1] x N. One direction after the other is summed up, so
   that a grid point costs about d+1 products and not (d+1)^D.
   `work` has kw_tensor_grid_work numbers; count[h] >= 0. */
void kw_tensor_grid(const kw_tensor *g, int N, const double *c, const int *r,
                    const int *count, const double *const *x, double *work,
                    double *point);
size_t kw_tensor_grid_work(const kw_tensor *g, int N, const int *count);

/* --- refinement --- */

/* From the coefficients c in g to those of the same geometry in `fine`, out, whose every
   direction is finer than that of g or equal to it (insert.h).
   `work` has kw_tensor_refine_work numbers. */
void kw_tensor_refine(const kw_tensor *g, const kw_tensor *fine, int N, const double *c,
                      double *work, double *out);
size_t kw_tensor_refine_work(const kw_tensor *g, const kw_tensor *fine, int N);

#endif
