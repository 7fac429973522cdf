/* elevate.h -- degree elevation: the same spline in a space of one degree more.

   The smoothness stays: every knot appears once more. Coefficients are as in curve.h,
   n x N row-major. [Ramshaw; Prautzsch: Degree elevation of B-spline curves, CAGD 1
   (1984)] */
#ifndef KW_ELEVATE_H
#define KW_ELEVATE_H

#include "bspline.h"

/* The space of degree d+1 with every knot of the domain once more; open knots stay open.
   d < KW_BSPLINE_DEGREE. The caller frees. */
kw_bspline *kw_elevate_new(const kw_bspline *s);

/* From the coefficients c of s to those of elevated = kw_elevate_new(s), out; aborts if
   `elevated` is another space. */
void kw_elevate(const kw_bspline *s, const kw_bspline *elevated, int N, const double *c,
                double *out);

#endif
