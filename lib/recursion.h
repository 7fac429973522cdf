/* recursion.h -- the recursion of Definition 3 on one span, from the knots around it alone.

   t points behind the span: t[-1] < t[0] are its ends, t[-d] .. t[d-1] the knots that the d+1
   local functions of degree d need, 0 <= d <= KW_BSPLINE_DEGREE. Nothing is checked here and
   nothing allocated; spaces and their contracts are in bspline.h, whose functions call these.

   Most of the time goes into quotients, and a processor makes two of them in the time of one.
   So all is computed at two points abreast, and one point alone stands for both.
   [source text, Definition 3, corrected; de Boor, ch. X] */
#ifndef KW_RECURSION_H
#define KW_RECURSION_H

/* The derivatives 0 .. r, r <= d, in units of x of length h: value is (r+1) x (d+1). */
void kw_recursion_one(int d, const double *t, double x, double h, int r, double *value);

/* The same in units of 1 at x on the span before t[0], and at y on the span before u[0]. */
void kw_recursion_two(int d, const double *t, double x, double *at_x, const double *u,
                      double y, double *at_y, int r);

/* The functions with another argument at each step, x[0..d-1]: value[0..d]. */
void kw_recursion_blossom(int d, const double *t, const double *x, double *value);

#endif
