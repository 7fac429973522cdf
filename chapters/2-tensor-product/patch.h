/* patch.h -- the example of a geometry that this lesson draws and measures. */
#ifndef PATCH_H
#define PATCH_H

#include "tensor.h"

enum { N1 = 5, N2 = 4, POINTS = N1 * N2, SPACE = 3 };

/* Control points of the patch in the plane and, with their heights, of the surface. */
static const double points[POINTS * SPACE] = {
    0,   0,    0,   -0.3, 1,   0.4, -0.2, 2,   0.6, 0.2, 3,   0.2, /* j_1 = 0 */
    1,   -0.4, 0.6, 0.9,  0.8, 1.6, 1.1,  2.1, 1.4, 1.2, 3.3, 0.6, /* j_1 = 1 */
    2.1, -0.5, 0.4, 2,    0.9, 0.2, 2.2,  2.2, 0.4, 2.1, 3.5, 0.8, /* j_1 = 2 */
    3.2, -0.1, 0.8, 3,    1,   1.2, 3.1,  2,   1.6, 3.3, 3.2, 1,   /* j_1 = 3 */
    4,   0.3,  0.2, 4.3,  1.2, 0.6, 4.4,  2.1, 0.4, 4.1, 2.8, 0};  /* j_1 = 4 */

/* Its space: bi-degree (2,2); the knot 1/2 of the second direction mu times. The control points
   fit mu = 1. The caller frees. */
static inline kw_tensor *new_patch(int mu)
{
    const double knots1[] = {0, 0.4, 0.7, 1}, knots2[] = {0, 0.5, 1};
    kw_bspline *s[2] = {kw_bspline_new_open(2, 3, knots1, NULL),
                        kw_bspline_new_open(2, 2, knots2, &mu)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);

    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return g;
}

#endif
