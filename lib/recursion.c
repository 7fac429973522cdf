#include "recursion.h"
#include "bspline.h"

enum { K = KW_BSPLINE_DEGREE + 1 };

/* Numbers at the two points; operations are those of each. */
typedef double pair __attribute__((vector_size(2 * sizeof(double))));

static pair twice(double a)
{
    return (pair){a, a};
}

/* Copies the knots around two spans; returns the place behind the spans. */
static const pair *knots_around(int d, const double *t, const double *u, pair *around)
{
    for (int r = -d; r < d; r++)
        around[d + r] = (pair){t[r], u[r]};
    return around + d;
}

/* One step of the recursion of Definition 3: from the p local functions of degree p-1,
   lower[0..p-1], to the p+1 of degree p, value[0..p], in the same place or another. No
   denominator is zero, because every one of these supports contains the span. */
static inline void raise_degree(const pair *restrict t, int p, pair x, const pair *lower,
                                pair *value)
{
    pair from_left = {0};

    for (int r = 0; r < p; r++) {
        pair left = t[r - p], right = t[r], width = right - left, old = lower[r];

        /* quotients first: at either end they are exactly 0 and 1 */
        value[r] = from_left + (right - x) / width * old;
        from_left = (x - left) / width * old;
    }
    value[p] = from_left;
}

/* The derivative in the same triangle: from the q-th derivatives of the p functions of
   degree p-1 to the (q+1)-th of the p+1 functions of degree p,
   beta_{j,p}' = p (beta_{j,p-1} / (t_{j+p}-t_j) - beta_{j+1,p-1} / (t_{j+p+1}-t_{j+1})),
   in units of x of length h. */
static inline void raise_derivative(const pair *restrict t, int p, pair h, pair *value)
{
    pair from_left = {0};

    for (int r = 0; r < p; r++) {
        pair share = (double)p * (value[r] * h / (t[r] - t[r - p]));

        value[r] = from_left - share;
        from_left = share;
    }
    value[p] = from_left;
}

/* The derivatives 0 .. r, r <= d, in units of x of length h. Row q begins with the functions of
   degree d-q, raised from those in the row behind it, and differentiates them q times. */
static inline void derivatives(int d, const pair *t, pair x, pair h, int r, pair *value)
{
    pair *row = value + r * (d + 1);

    row[0] = twice(1);
    for (int p = 1; p <= d - r; p++)
        raise_degree(t, p, x, row, row);
    for (int q = r; q >= 0; q--, row -= d + 1) {
        if (q > 0)
            raise_degree(t, d - q + 1, x, row, row - (d + 1));
        for (int p = d - q + 1; p <= d; p++)
            raise_derivative(t, p, h, row);
    }
}

void kw_recursion_one(int d, const double *t, double x, double h, int r, double *value)
{
    pair around[2 * KW_BSPLINE_DEGREE], both[K * K];

    derivatives(d, knots_around(d, t, t, around), twice(x), twice(h), r, both);
    for (int l = 0; l < (r + 1) * (d + 1); l++)
        value[l] = both[l][0];
}

void kw_recursion_two(int d, const double *t, double x, double *at_x, const double *u,
                      double y, double *at_y, int r)
{
    pair around[2 * KW_BSPLINE_DEGREE], both[K * K];

    derivatives(d, knots_around(d, t, u, around), (pair){x, y}, twice(1), r, both);
    for (int l = 0; l < (r + 1) * (d + 1); l++) {
        at_x[l] = both[l][0];
        at_y[l] = both[l][1];
    }
}

void kw_recursion_blossom(int d, const double *t, const double *x, double *value)
{
    pair around[2 * KW_BSPLINE_DEGREE], both[K];
    const pair *knots = knots_around(d, t, t, around);

    both[0] = twice(1);
    for (int p = 1; p <= d; p++)
        raise_degree(knots, p, twice(x[p - 1]), both, both);
    for (int j = 0; j <= d; j++)
        value[j] = both[j][0];
}
