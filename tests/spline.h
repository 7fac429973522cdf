/* spline.h -- what the tests of the splines share: a property held over many random
   spaces, bounds of the rounding error, and arrays in which shows what was written.

   Bounds. A term that goes through at most n roundings has a relative error of at most
   n u / (1 - n u), u = 2^-53. A sum of such terms has that error times the sum of their
   absolute values, the `size' below; where all terms are positive, that is the sum itself.
   In the recursion a degree costs a term five roundings (x - left, right - left, the
   quotient, the product, the sum), a differentiation four (right - left, the quotient,
   times p, the difference). So a B-spline of degree d and each derivative of it has at
   most 5d of them, whichever of the two forms of the recursion is used. */
#ifndef SPLINE_H
#define SPLINE_H

#include "test.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum {
    SPACES = 300, /* random spaces a property is held over */
    K = KW_BSPLINE_DEGREE + 1,
    GUARD = 8, /* entries behind an array that must stay as they are */
    ROOM = (K + 2) * K + GUARD
};

/* The error of n roundings of terms whose absolute values have the sum `size`. */
static inline double bound(int n, double size)
{
    const double u = DBL_EPSILON / 2;

    return n * u / (1 - n * u) * size;
}

/* size[0..d]: of the q-th derivatives at the blossom's arguments u[0..d-q-1], the local
   functions of span i, the sum of the absolute values of their terms: the recursion with
   every sign positive. */
static inline void blossom_size(const kw_bspline *s, int i, const double *u, int q,
                                double *size)
{
    size[0] = 1;
    for (int p = 1; p <= s->d; p++) {
        double from_left = 0;

        for (int r = 0; r < p; r++) {
            double left = s->t[i + 1 + r - p], right = s->t[i + 1 + r];
            double share = size[r] / (right - left);

            if (p > s->d - q) {
                size[r] = from_left + p * share;
                from_left = p * share;
            } else {
                size[r] = from_left + fabs(right - u[p - 1]) * share;
                from_left = fabs(u[p - 1] - left) * share;
            }
        }
        size[p] = from_left;
    }
}

/* The same with all arguments x; zero for q > d. */
static inline void derivative_size(const kw_bspline *s, int i, double x, int q,
                                   double *size)
{
    double u[K];

    for (int p = 0; p < s->d; p++)
        u[p] = x;
    blossom_size(s, i, u, q, size);
    for (int j = 0; j <= s->d && q > s->d; j++)
        size[j] = 0;
}

/* Makes a[0..count-1] and the guard behind it NaN. */
static inline void poison(double *a, int count)
{
    test_poison(a, count + GUARD);
}

/* Whether a[0..count-1] was written and the guard was not. */
static inline int written(const double *a, int count)
{
    for (int i = 0; i < count + GUARD; i++)
        if (isnan(a[i]) != (i >= count))
            return 0;
    return 1;
}

static inline int same_bits(const double *a, const double *b, int count)
{
    return memcmp(a, b, (size_t)count * sizeof *a) == 0;
}

/* A random span. */
static inline int random_span(kw_rng *r, const kw_bspline *s)
{
    return kw_bspline_span(s, test_random_in(r, s->t[s->d], s->t[s->n]));
}

/* A multiple of 1/1024 in [-4, 4): sums, quarters and means of a few are exact. */
static inline double random_dyadic(kw_rng *r)
{
    return (kw_rng_below(r, 8192) - 4096) / 1024.0;
}

/* A property of a space; r goes on with numbers for it. */
typedef void property(const kw_bspline *s, kw_rng *r);

static property *spline_property; /* what the test that runs now is about */
static int spline_highest;

static inline void spline_over_spaces(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(20, (uint64_t)spline_highest, (uint64_t)sample, 0);
        kw_bspline *s = test_random_space(&r, spline_highest);

        spline_property(s, &r);
        kw_bspline_free(s);
    }
}

/* Runs a test that holds the property over SPACES random spaces of degree 0 .. highest. */
static inline void run_over_spaces(const char *name, int highest, property *holds)
{
    spline_property = holds;
    spline_highest = highest;
    test_run(name, spline_over_spaces);
}

#endif
