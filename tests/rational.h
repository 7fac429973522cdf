/* rational.h -- exact fractions, and the B-splines in them.

   A fraction is reduced, its denominator positive. Whatever does not fit into a long long
   aborts, so a result that comes back is exact. */
#ifndef RATIONAL_H
#define RATIONAL_H

#include "need.h"
#include <limits.h>

typedef struct rational {
    long long p, q; /* p/q */
} rational;

static inline rational rational_new(long long p, long long q)
{
    long long a = p, b = q;

    KW_NEED(q != 0 && p > LLONG_MIN && q > LLONG_MIN, "%lld / %lld", p, q);
    while (b != 0) { /* Euclid: a becomes the greatest common divisor */
        long long rest = a % b;

        a = b;
        b = rest;
    }
    if ((a < 0) != (q < 0))
        a = -a;
    return (rational){p / a, q / a};
}

static inline long long rational_product(long long a, long long b)
{
    long long product = 0;

    KW_NEED(!__builtin_mul_overflow(a, b, &product), "%lld * %lld", a, b);
    return product;
}

static inline rational rational_mul(rational a, rational b)
{
    return rational_new(rational_product(a.p, b.p), rational_product(a.q, b.q));
}

static inline rational rational_div(rational a, rational b)
{
    return rational_new(rational_product(a.p, b.q), rational_product(a.q, b.p));
}

static inline rational rational_add(rational a, rational b)
{
    long long left = rational_product(a.p, b.q), right = rational_product(b.p, a.q);
    long long sum = 0;

    KW_NEED(!__builtin_add_overflow(left, right, &sum), "%lld + %lld", left, right);
    return rational_new(sum, rational_product(a.q, b.q));
}

static inline rational rational_sub(rational a, rational b)
{
    return rational_add(a, (rational){-b.p, b.q});
}

static inline int rational_less(rational a, rational b)
{
    return rational_product(a.p, b.q) < rational_product(b.p, a.q);
}

/* The nearest double: the division is the only rounding. */
static inline double rational_double(rational a)
{
    const long long exact = 1LL << 53;

    KW_NEED(-exact <= a.p && a.p <= exact && a.q <= exact, "%lld / %lld", a.p, a.q);
    return (double)a.p / (double)a.q;
}

/* a / b, where 0/0 is 0: the convention of the recursion */
static inline rational rational_ratio(rational a, rational b)
{
    return a.p == 0 ? a : rational_div(a, b);
}

/* The r-th derivative at x of the B-spline of degree d on the d+2 knots t[0..d+1], by the
   recursion of Definition 3 as it stands (corrected): no table, no case but 0/0. The spans
   are closed on the left, or on the right if `from_left`. With the sign of a derivative's
   second term +1 instead of -1 it is the sum of the absolute values of all terms. */
static inline rational rational_terms(const rational *t, int d, int r, rational x,
                                      int from_left, int sign)
{
    const rational zero = {0, 1}, one = {1, 1};
    rational left, right;

    if (r > d || rational_less(x, t[0]) || rational_less(t[d + 1], x))
        return zero;
    if (d == 0 && from_left)
        return rational_less(t[0], x) && !rational_less(t[1], x) ? one : zero;
    if (d == 0)
        return !rational_less(x, t[0]) && rational_less(x, t[1]) ? one : zero;
    left = rational_terms(t, d - 1, r > 0 ? r - 1 : 0, x, from_left, sign);
    right = rational_terms(t + 1, d - 1, r > 0 ? r - 1 : 0, x, from_left, sign);
    left = rational_ratio(left, rational_sub(t[d], t[0]));
    right = rational_ratio(right, rational_sub(t[d + 1], t[1]));
    if (r > 0) {
        right = rational_mul((rational){sign, 1}, right);
        return rational_mul((rational){d, 1}, rational_add(left, right));
    }
    return rational_add(rational_mul(rational_sub(x, t[0]), left),
                        rational_mul(rational_sub(t[d + 1], x), right));
}

static inline rational rational_bspline(const rational *t, int d, int r, rational x,
                                        int from_left)
{
    return rational_terms(t, d, r, x, from_left, -1);
}

#endif
