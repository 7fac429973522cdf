/* counted.h -- arithmetic that counts itself, and the algorithms of the library written in it,
   operation by operation and in the same order: their results must have the same bits. */
#ifndef COUNTED_H
#define COUNTED_H

#include "bspline.h"

typedef struct tally {
    long long sums; /* and differences */
    long long products;
    long long quotients;
    long long comparisons; /* of a point with a knot */
} tally;

static inline double plus(tally *t, double a, double b)
{
    t->sums++;
    return a + b;
}

static inline double minus(tally *t, double a, double b)
{
    t->sums++;
    return a - b;
}

static inline double times(tally *t, double a, double b)
{
    t->products++;
    return a * b;
}

static inline double over(tally *t, double a, double b)
{
    t->quotients++;
    return a / b;
}

static inline int below(tally *t, double a, double b)
{
    t->comparisons++;
    return a < b;
}

static inline long long operations(const tally *t)
{
    return t->sums + t->products + t->quotients;
}

/* --- the span of a point, three ways --- */

/* The knots one after the other. */
static inline int span_by_scan(tally *t, const kw_bspline *s, double x)
{
    int i = s->d;

    while (i + 1 < s->n && !below(t, x, s->t[i + 1]))
        i++;
    return i;
}

/* Halving what is left, t[low] <= x < t[high]. */
static inline int span_between(tally *t, const kw_bspline *s, double x, int low, int high)
{
    while (high - low > 1) {
        int middle = low + (high - low) / 2;

        if (below(t, x, s->t[middle]))
            high = middle;
        else
            low = middle;
    }
    return low;
}

static inline int span_by_bisection(tally *t, const kw_bspline *s, double x)
{
    return span_between(t, s, x, s->d, s->n);
}

/* --- the basis at a point of span i --- */

/* Definition 3 word by word: beta_j of degree p calls two functions of degree p-1. */
static inline double basis_by_definition(tally *t, const kw_bspline *s, int i, int j,
                                         int p, double x)
{
    double left = s->t[j], right = s->t[j + p + 1], value = 0;

    if (p == 0)
        return i == j;
    if (s->t[j + p] > left)
        value = times(t, over(t, minus(t, x, left), minus(t, s->t[j + p], left)),
                      basis_by_definition(t, s, i, j, p - 1, x));
    if (right > s->t[j + 1])
        value = plus(t, value,
                     times(t, over(t, minus(t, right, x), minus(t, right, s->t[j + 1])),
                           basis_by_definition(t, s, i, j + 1, p - 1, x)));
    return value;
}

/* From the p functions of degree p-1 that are not zero on span i, value[0..p-1], to
   the p+1 of degree p: each of the former is used twice. */
static inline void raise_degree(tally *t, const kw_bspline *s, int i, int p, double x,
                                double *value)
{
    double from_left = 0;

    for (int r = 0; r < p; r++) {
        double left = s->t[i + 1 + r - p], right = s->t[i + 1 + r];
        double width = minus(t, right, left), old = value[r];

        value[r] = plus(t, from_left, times(t, over(t, minus(t, right, x), width), old));
        from_left = times(t, over(t, minus(t, x, left), width), old);
    }
    value[p] = from_left;
}

/* All d+1 functions together, degree by degree, as kw_bspline_basis has them. */
static inline void basis_by_triangle(tally *t, const kw_bspline *s, int i, double x,
                                     double *value)
{
    value[0] = 1;
    for (int p = 1; p <= s->d; p++)
        raise_degree(t, s, i, p, x, value);
}

/* The same with another argument at each degree: the weights of the polar form at the increasing
   arguments u[0..d-1], from the span outwards, as kw_bspline_blossom_knots has them. */
static inline void blossom_by_triangle(tally *t, const kw_bspline *s, int i,
                                       const double *u, double *value)
{
    int left = 0; /* arguments up to the span */

    while (left < s->d && u[left] <= s->t[i])
        left++;
    value[0] = 1;
    for (int p = 1; p <= s->d; p++)
        raise_degree(t, s, i, p, u[p <= left ? left - p : p - 1], value);
}

/* From the q-th derivatives of the functions of degree p-1 to the (q+1)-th of those of
   degree p. */
static inline void raise_derivative(tally *t, const kw_bspline *s, int i, int p,
                                    double *value)
{
    double from_left = 0;

    for (int r = 0; r < p; r++) {
        double width = minus(t, s->t[i + 1 + r], s->t[i + 1 + r - p]);
        double share = times(t, p, over(t, value[r], width));

        value[r] = minus(t, from_left, share);
        from_left = share;
    }
    value[p] = from_left;
}

/* The functions and their derivatives of order 1 .. r <= d, value: (r+1) x (d+1). The functions
   of a lower degree, from which a derivative begins, are those on the way to the degree d. */
static inline void derivatives_by_triangle(tally *t, const kw_bspline *s, int i, double x,
                                           int r, double *value)
{
    int d = s->d;
    double *row = value + r * (d + 1);

    row[0] = 1;
    for (int p = 1; p <= d - r; p++)
        raise_degree(t, s, i, p, x, row);
    for (int q = r; q >= 0; q--, row -= d + 1) {
        if (q > 0) {
            for (int j = 0; j <= d - q; j++)
                (row - (d + 1))[j] = row[j];
            raise_degree(t, s, i, d - q + 1, x, row - (d + 1));
        }
        for (int p = d - q + 1; p <= d; p++)
            raise_derivative(t, s, i, p, row);
    }
}

/* --- what is made of it --- */

/* sum += weight[0..k-1] times k points of R^N, `step` numbers from one to the next */
static inline void add_combination(tally *t, int k, int N, const double *weight,
                                   const double *c, int step, double *sum)
{
    for (int j = 0; j < k; j++)
        for (int a = 0; a < N; a++)
            sum[a] = plus(t, sum[a], times(t, weight[j], c[j * step + a]));
}

/* Numbers of a that are not those of b; but for the sign of zero they have the same bits then. */
static inline int differing(int count, const double *a, const double *b)
{
    int differ = 0;

    for (int i = 0; i < count; i++)
        differ += a[i] != b[i];
    return differ;
}

#endif
