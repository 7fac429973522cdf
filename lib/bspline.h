/* bspline.h -- univariate B-splines of degree d on an extended knot vector t.

   Conventions, stated here once for the whole package:
     d        degree, 0 .. KW_BSPLINE_DEGREE; the order is k = d+1
     n        number of functions beta_0 .. beta_{n-1}, the dimension of the space
              (the book's n is ours minus 1); n >= d+1
     t        extended knots t[0] <= ... <= t[n+d], n+d+1 of them, finite, each value at
              most d+1 times; the book's t_{k-1} and t_{n+1} are t[d] and t[n]
     domain   [t[d], t[n]], closed at BOTH ends, with t[d] < t[d+1] and t[n-1] < t[n], so
              that every function is non-zero on it; the knots before t[d] and behind t[n]
              are the auxiliary ones
     span     an index i with d <= i < n and t[i] < t[i+1]; on the span the functions
              i-d .. i, its d+1 `local' functions, are non-zero and polynomials
     values   at a knot are taken from the right, and at the right end of the domain from
              the left, so the partition of unity holds there too
   Knots are compared exactly; there is no knot tolerance. Where a function below names no
   error it has none; a point outside the domain, a NaN or an index out of range is the
   caller's mistake (need.h).

   Sources: [source text, section 1.1]; [de Boor] is A Practical Guide to Splines, revised
   edition, 2001; [Ramshaw] is Blossoms are polar forms, CAGD 6 (1989). */
#ifndef KW_BSPLINE_H
#define KW_BSPLINE_H

/* The largest degree; it bounds the arrays that evaluation keeps on the stack. */
enum { KW_BSPLINE_DEGREE = 31 };

typedef struct kw_bspline {
    int d;     /* degree */
    int n;     /* dimension */
    double *t; /* knots, n+d+1; owned */
    /* a table of where to look for the span of a point, see kw_bspline_span */
    int buckets;    /* n - d + 1 */
    double scale;   /* (n - d) / length of the domain */
    int *before;    /* buckets + 1; owned */
    int candidates; /* spans to choose from in each bucket */
} kw_bspline;

/* --- spaces; the caller frees them; never NULL --- */

/* The space on the n+d+1 knots t, which are copied. */
kw_bspline *kw_bspline_new(int d, int n, const double *t);

/* The same space again. */
kw_bspline *kw_bspline_new_copy(const kw_bspline *s);

/* The space on the open knot vector of the partition tau[0] < ... < tau[L], whose end
   knots appear k times and whose interior knot tau[i] appears mu[i-1] times, 1 .. k, for
   i = 1 .. L-1. mu == NULL stands for all ones. n = k + sum of mu.
   [source text, Remark 2] */
kw_bspline *kw_bspline_new_open(int d, int L, const double *tau, const int *mu);

/* The same on `cells` equal cells of [a,b], all interior knots simple. */
kw_bspline *kw_bspline_new_open_uniform(int d, int cells, double a, double b);

/* `cells` equal cells of [a,b] and auxiliary knots that go on at the same distance:
   every function is a shift of the same one. n = cells + d. */
kw_bspline *kw_bspline_new_uniform(int d, int cells, double a, double b);

/* The partition as in kw_bspline_new_open, its end knots simple, and auxiliary knots that
   repeat it with the period tau[L] - tau[0]. n = d + 1 + sum of mu; a spline whose
   coefficients repeat with the period n-d is a periodic function of smoothness d-1 at the
   seam (kw_curve_close). */
kw_bspline *kw_bspline_new_periodic(int d, int L, const double *tau, const int *mu);

/* Frees s; NULL is fine. */
void kw_bspline_free(kw_bspline *s);

/* --- knots --- */

/* The span of x: t[i] <= x < t[i+1], at the right end of the domain the last span. It is looked
   for by bisection among the `candidates` of the part of the domain that x lies in: two if all
   spans are equal, few if they do not differ much, at most n-d. */
int kw_bspline_span(const kw_bspline *s, double x);

/* The first span on which function j is non-zero. */
int kw_bspline_first_span(const kw_bspline *s, int j);

/* How often x is among the knots; 0 if it is none. */
int kw_bspline_multiplicity(const kw_bspline *s, double x);

/* The Greville point of function j, the mean of t[j+1 .. j+d]: the coefficients for which
   the spline is the identity. For d = 0 the middle of [t[j], t[j+1]].
   [de Boor, ch. IX] */
double kw_bspline_greville(const kw_bspline *s, int j);

/* --- the d+1 local functions of a point in the domain --- */

/* value[i] = beta_{first+i}(x), i = 0 .. d; returns first.
   [source text, Definition 3, corrected; de Boor, ch. X, BSPLVB] */
int kw_bspline_basis(const kw_bspline *s, double x, double *value);

/* value[q*(d+1) + i] = q-th derivative of beta_{first+i} at x, q = 0 .. r, i = 0 .. d,
   r >= 0; returns first. Rows with q > d are zero. A derivative grows with the q-th power of
   1 / span: on tiny spans it may overflow to infinity, and a difference of two such to NaN.
   [de Boor, ch. X, (15)] */
int kw_bspline_derivatives(const kw_bspline *s, double x, int r, double *value);

/* The same of the polynomials that the local functions are on span i, at any finite x:
   with x = t[i+1] the derivatives from the left. */
void kw_bspline_derivatives_on(const kw_bspline *s, int i, double x, int r,
                               double *value);

/* Of these the r-th derivatives alone: value[0..d]. */
void kw_bspline_derivative_on(const kw_bspline *s, int i, double x, int r, double *value);

/* The polynomial pieces of the local functions of span i in powers of the local variable
   u = (x - t[i]) / (t[i+1] - t[i]): beta_{i-d+j} = sum of piece[j*(d+1) + q] u^q. */
void kw_bspline_pieces(const kw_bspline *s, int i, double *piece);

/* The weights with which the d+1 coefficients of span i give the polar form (blossom) of
   that polynomial piece at the arguments u[0..d-1]: value[0..d]. With all arguments equal
   to x they are the local functions at x. [Ramshaw] */
void kw_bspline_blossom(const kw_bspline *s, int i, const double *u, double *value);

/* The same for increasing arguments u, which may lie far from the span, as the knots of a finer
   space do. The order of the arguments does not matter but for rounding: here they are taken
   from the span outwards, and then no term is negative if every knot of s between the span
   and an argument is an argument too. */
void kw_bspline_blossom_knots(const kw_bspline *s, int i, const double *u, double *value);

/* --- one function anywhere --- */

/* The r-th derivative of beta_j at any finite x, inside the domain or outside; zero
   outside its support. r >= 0. */
double kw_bspline_one(const kw_bspline *s, int j, int r, double x);

/* --- many points: x[0..count-1], count >= 0, results one after the other, nothing
   allocated; the same bits as one by one, local functions in less time --- */

/* span: count. */
void kw_bspline_span_many(const kw_bspline *s, int count, const double *x, int *span);

/* first: count; value: count x (d+1). */
void kw_bspline_basis_many(const kw_bspline *s, int count, const double *x, int *first,
                           double *value);

/* first: count; value: count x (r+1) x (d+1). */
void kw_bspline_derivatives_many(const kw_bspline *s, int count, const double *x, int r,
                                 int *first, double *value);

#endif
