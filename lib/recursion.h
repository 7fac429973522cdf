/* recursion.h -- the recursion of Definition 3 on one span, from the knots around it alone.

   t points behind the span: t[-1] < t[0] are its ends, t[-d] .. t[d-1] the knots that the d+1
   local functions of degree d need, 0 <= d <= KW_BSPLINE_DEGREE. Nothing is checked here and
   nothing allocated; spaces and their contracts are in bspline.h, whose functions call these.

   Most of the time goes into quotients, and a processor makes two of them in the time of one.
   So of many points two are taken abreast, each with its own span.
   [source text, Definition 3, corrected; de Boor, ch. X] */
#ifndef KW_RECURSION_H
#define KW_RECURSION_H

/* Two numbers, here at two points; operations are those of each. */
typedef double kw_pair __attribute__((vector_size(2 * sizeof(double))));

/* One step: from the p local functions of degree p-1 at x, value[0..p-1], to the p+1 of degree
   p, value[0..p]. No denominator is zero, because every one of these supports contains the
   span. */
static inline void kw_recursion_raise(int p, const double *restrict t, double x,
                                      double *restrict value)
{
    double from_left = 0;

    for (int r = 0; r < p; r++) {
        double left = t[r - p], right = t[r], width = right - left, lower = value[r];

        /* quotients first: at either end they are exactly 0 and 1 */
        value[r] = from_left + (right - x) / width * lower;
        from_left = (x - left) / width * lower;
    }
    value[p] = from_left;
}

/* The same step at two points, the second on the span before u[0], from lower[0..p-1] to
   value[0..p], in the same place or another. */
static inline void kw_recursion_raise_both(int p, const double *t, const double *u,
                                           kw_pair x, const kw_pair *lower,
                                           kw_pair *value)
{
    kw_pair from_left = {0};

    for (int r = 0; r < p; r++) {
        kw_pair left = {t[r - p], u[r - p]}, right = {t[r], u[r]};
        kw_pair width = right - left, old = lower[r];

        value[r] = from_left + (right - x) / width * old;
        from_left = (x - left) / width * old;
    }
    value[p] = from_left;
}

/* The functions with another argument at each step, x[0..d-1]: value[0..d]. With all
   arguments equal to x they are the local functions at x. */
void kw_recursion_blossom(int d, const double *t, const double *x, double *value);

/* The derivatives 0 .. r, r <= d, in units of x of length h: value is (r+1) x (d+1). */
void kw_recursion_one(int d, const double *t, double x, double h, int r, double *value);

/* The same in units of 1 at x on the span before t[0], and at y on the span before u[0]. */
void kw_recursion_two(int d, const double *t, double x, double *at_x, const double *u,
                      double y, double *at_y, int r);

#endif
