/* line.h -- THB-splines on a line of equal cells, refined towards its end, and their exact values.

   A uniform B-spline of degree d is the sum of d+2 shifts of the same at half the scale, with
   binomials over 2^d. So a THB-spline has whole coefficients on the last level, over a power of
   two. Which functions are truncated is asked of active.h. */
#ifndef LINE_H
#define LINE_H

#include "../../tests/rational.h"
#include "hier.h"
#include <string.h>

enum {
    LINE_CELLS = 8, /* of level 0 */
    LINE_WIDTH = 3, /* of such a cell: a third of a point is rounded */
    LINE_TOP = 3,   /* the last level */
    LINE_DEGREE = 4,
    LINE_MOST = (LINE_CELLS << LINE_TOP) + LINE_DEGREE /* functions of a level */
};

/* Omega^l goes from the end of cell l of level 0 to the end of the line. */
static inline kw_hier *new_line(int d)
{
    kw_bspline *s = kw_bspline_new_uniform(d, LINE_CELLS, 0, LINE_CELLS * LINE_WIDTH);
    const kw_bspline *only[] = {s};
    kw_tensor *g = kw_tensor_new(1, only);
    kw_mesh *m = kw_mesh_new(g);
    kw_hier *b;

    for (int l = 0; l < LINE_TOP; l++) {
        const int low[] = {(l + 2) << l}, high[] = {LINE_CELLS << l};

        kw_mesh_refine(m, l, low, high);
    }
    b = kw_hier_new(m);
    kw_mesh_free(m);
    kw_tensor_free(g);
    kw_bspline_free(s);
    return b;
}

/* From level l to level l+1, times 2^d; c has LINE_MOST numbers, zero behind the last. */
static inline void to_next_level(int d, int l, long long *c)
{
    long long fine[LINE_MOST] = {0};

    for (int j = 0; j < (LINE_CELLS << l) + d; j++) {
        long long binomial = 1;

        for (int k = 0; k <= d + 1; k++) {
            int to = 2 * j - d + k;

            if (0 <= to && to < (LINE_CELLS << (l + 1)) + d)
                fine[to] += binomial * c[j];
            binomial = binomial * (d + 1 - k) / (k + 1);
        }
    }
    memcpy(c, fine, sizeof fine);
}

/* The coefficients of THB-spline i on the last level, times the power of two that is returned; c
   has LINE_MOST numbers, zero so far.
   [source text, (15)] */
static inline long long on_last_level(const kw_active *a, int i, long long *c)
{
    int d = a->mesh->level[0].s[0]->d, level, function;
    long long scale = 1;

    KW_NEED(1 <= d && d <= LINE_DEGREE, "degree %d", d);
    kw_active_function(a, i, &level, &function);
    c[function] = 1;
    for (int l = level; l < LINE_TOP; l++) {
        to_next_level(d, l, c);
        scale <<= d;
        for (int j = 0; j < (LINE_CELLS << (l + 1)) + d; j++)
            if (kw_active_status(a, l + 1, &j) != KW_ACTIVE_OUTSIDE)
                c[j] = 0;
    }
    return scale;
}

/* THB-spline i at x; the functions are computed on cells of length one on level 0. */
static inline rational exact_on_line(const kw_active *a, int i, rational x)
{
    const rational width = {LINE_WIDTH, 1}, last = {LINE_CELLS, 1};
    rational u = rational_div(x, width), sum = {0, 1};
    long long c[LINE_MOST] = {0};
    long long scale = on_last_level(a, i, c);
    int d = a->mesh->level[0].s[0]->d;

    for (int j = 0; j < (LINE_CELLS << LINE_TOP) + d; j++) {
        rational t[LINE_DEGREE + 2], term;

        for (int k = 0; k <= d + 1; k++)
            t[k] = rational_new(j + k - d, 1 << LINE_TOP);
        term = rational_bspline(t, d, 0, u, !rational_less(u, last));
        sum = rational_add(sum, rational_mul(rational_new(c[j], scale), term));
    }
    return sum;
}

#endif
