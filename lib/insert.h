/* insert.h -- knot insertion: the same spline in a finer space.

   A finer space has the same degree and domain and, inside it, every knot of the coarse
   space at least as often. Its auxiliary knots are its own affair. Coefficients are as in
   curve.h, n x N row-major; arrays do not overlap. The functions for one row or one column,
   which are called often, check degree and domain alone; knots that are missing are the
   caller's affair (kw_insert_need_nested).

   Sources: [Boehm] is Inserting new knots into B-spline curves, CAD 12 (1980); [Oslo] is
   Cohen, Lyche, Riesenfeld: Discrete B-splines and subdivision techniques, CGIP 14
   (1980). */
#ifndef KW_INSERT_H
#define KW_INSERT_H

#include "bspline.h"

/* --- finer spaces; the caller frees them --- */

/* s with the knot x once more. x lies inside the domain, at most d times a knot so far. */
kw_bspline *kw_insert_new_knot(const kw_bspline *s, double x);

/* s with every non-empty span halved. */
kw_bspline *kw_insert_new_dyadic(const kw_bspline *s);

/* --- coefficients --- */

/* One knot by Boehm's rule: from the coefficients c of s to those of
   kw_insert_new_knot(s, x), fine: (n+1) x N. Only d of them are new averages. */
void kw_insert_boehm(const kw_bspline *s, double x, int N, const double *c, double *fine);

/* All knots of `fine` by Boehm's rule, one after the other from left to right, in one walk: from
   c, coarse->n x N, to out, fine->n x N; d quotients for a knot. The auxiliary knots of the two
   spaces are the same. [Boehm] */
void kw_insert_boehm_all(const kw_bspline *coarse, const kw_bspline *fine, int N,
                         const double *c, double *out);

/* Row i of the Oslo matrix: the fine coefficient i is the sum of
   alpha[0..d] times the coarse coefficients from `first` on; returns first. The alpha add up
   to one, and none is negative on open knots, and wherever the fine auxiliary knots contain
   the coarse ones. */
int kw_insert_oslo_row(const kw_bspline *coarse, const kw_bspline *fine, int i,
                       double *alpha);

/* All coefficients by the Oslo rows, whatever the auxiliary knots: from c, coarse->n x N, to out,
   fine->n x N. [Oslo] */
void kw_insert_oslo(const kw_bspline *coarse, const kw_bspline *fine, int N,
                    const double *c, double *out);

/* Column j of the Oslo matrix, the two-scale relation of one function:
   coarse beta_j = sum of coefficient[i] * fine beta_{first+i}, i = 0 .. count-1, over the
   fine functions that live in the support of beta_j. Returns count: at most d+2 if the
   knots are open and the fine space is the dyadic one, else at most fine->n. */
int kw_insert_two_scale(const kw_bspline *coarse, const kw_bspline *fine, int j,
                        int *first, double *coefficient);

/* Aborts unless `fine` is finer than `coarse` in the sense above. */
void kw_insert_need_nested(const kw_bspline *coarse, const kw_bspline *fine);

#endif
