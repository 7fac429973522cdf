/* bernstein.h -- Bernstein polynomials of degree d, and polynomials in Bezier form.

   d is 0 .. KW_BSPLINE_DEGREE; the domain is [0,1], but x may be any finite number.
   Sources: [source text, (8) and Remark 4]; [Farin] is Curves and Surfaces for CAGD, 5th
   edition, 2002. */
#ifndef KW_BERNSTEIN_H
#define KW_BERNSTEIN_H

/* value[j] = binomial(d, j) x^j (1-x)^(d-j), j = 0 .. d, with 0^0 = 1.
   [source text, (8)] */
void kw_bernstein_basis(int d, double x, double *value);

/* The point at x of the polynomial with Bezier points c, (d+1) x N row-major, by de
   Casteljau's repeated averaging: point[0..N-1]. N >= 1. [Farin, ch. 4] */
void kw_bernstein_casteljau(int d, int N, const double *c, double x, double *point);

#endif
