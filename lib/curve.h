/* curve.h -- spline curves s(x) = sum of c_j beta_j(x) in R^N.

   s is a space (bspline.h), c its n x N coefficients, row-major: the control point c_j is
   c[j*N .. j*N+N-1]. N >= 1; N = 1 is a function; n x N is at most INT_MAX. x lies in the domain.
   Points are written to point[0..N-1]. Arrays do not overlap; nothing is allocated.
   [source text, (9)] */
#ifndef KW_CURVE_H
#define KW_CURVE_H

#include "bspline.h"

/* s(x) as the sum of the d+1 coefficients that count, each times its function. */
void kw_curve_point(const kw_bspline *s, int N, const double *c, double x, double *point);

/* s(x) by repeated averaging of the same coefficients, without any function.
   [de Boor, ch. X, (4)] */
void kw_curve_deboor(const kw_bspline *s, int N, const double *c, double x,
                     double *point);

/* The polar form (blossom) of the piece on span i at the arguments u[0..d-1]: de Boor's
   algorithm with another argument in each of its d steps. It is symmetric in them, affine
   in each, and s(x) if all are x. [Ramshaw] */
void kw_curve_blossom(const kw_bspline *s, int i, int N, const double *c, const double *u,
                      double *point);

/* The derivatives of order 0 .. r, r >= 0: value is (r+1) x N. Those beyond d are zero. */
void kw_curve_derivatives(const kw_bspline *s, int N, const double *c, double x, int r,
                          double *value);

/* Closes a curve in a periodic space: c_{n-d+j} = c_j for j = 0 .. d-1, in place. */
void kw_curve_close(const kw_bspline *s, int N, double *c);

/* --- many points: x[0..count-1], count >= 0, results one after the other, the same bits as one
   by one --- */

/* point: count x N. */
void kw_curve_point_many(const kw_bspline *s, int N, const double *c, int count,
                         const double *x, double *point);

/* point: count x N. */
void kw_curve_deboor_many(const kw_bspline *s, int N, const double *c, int count,
                          const double *x, double *point);

/* value: count x (r+1) x N. */
void kw_curve_derivatives_many(const kw_bspline *s, int N, const double *c, int count,
                               const double *x, int r, double *value);

#endif
