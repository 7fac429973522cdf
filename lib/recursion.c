#include "recursion.h"
#include "bspline.h"

enum { K = KW_BSPLINE_DEGREE + 1 };

/* The derivative in the same triangle: from the q-th derivatives of the p functions of
   degree p-1 to the (q+1)-th of the p+1 functions of degree p,
   beta_{j,p}' = p (beta_{j,p-1} / (t_{j+p}-t_j) - beta_{j+1,p-1} / (t_{j+p+1}-t_{j+1})),
   in units of x of length h. */
static inline void raise_derivative(int p, const double *t, const double *u, kw_pair h,
                                    kw_pair *value)
{
    kw_pair from_left = {0};

    for (int r = 0; r < p; r++) {
        kw_pair left = {t[r - p], u[r - p]}, right = {t[r], u[r]};
        kw_pair share = (double)p * (value[r] * h / (right - left));

        value[r] = from_left - share;
        from_left = share;
    }
    value[p] = from_left;
}

/* The derivatives 0 .. r, r <= d, in units of x of length h. Row q begins with the functions of
   degree d-q, raised from those in the row behind it, and differentiates them q times. */
static inline void derivatives(int d, const double *t, const double *u, kw_pair x,
                               kw_pair h, int r, kw_pair *value)
{
    kw_pair *row = value + r * (d + 1);

    row[0] = (kw_pair){1, 1};
    for (int p = 1; p <= d - r; p++)
        kw_recursion_raise_both(p, t, u, x, row, row);
    for (int q = r; q >= 0; q--, row -= d + 1) {
        if (q > 0)
            kw_recursion_raise_both(d - q + 1, t, u, x, row, row - (d + 1));
        for (int p = d - q + 1; p <= d; p++)
            raise_derivative(p, t, u, h, row);
    }
}

void kw_recursion_one(int d, const double *t, double x, double h, int r, double *value)
{
    kw_pair both[K * K];

    if (r == 0) {
        value[0] = 1;
        for (int p = 1; p <= d; p++)
            kw_recursion_raise(p, t, x, value);
        return;
    }
    derivatives(d, t, t, (kw_pair){x, x}, (kw_pair){h, h}, r, both);
    for (int l = 0; l < (r + 1) * (d + 1); l++)
        value[l] = both[l][0];
}

void kw_recursion_two(int d, const double *t, double x, double *at_x, const double *u,
                      double y, double *at_y, int r)
{
    kw_pair both[K * K];

    derivatives(d, t, u, (kw_pair){x, y}, (kw_pair){1, 1}, r, both);
    for (int l = 0; l < (r + 1) * (d + 1); l++) {
        at_x[l] = both[l][0];
        at_y[l] = both[l][1];
    }
}

void kw_recursion_blossom(int d, const double *t, const double *x, double *value)
{
    value[0] = 1;
    for (int p = 1; p <= d; p++)
        kw_recursion_raise(p, t, x[p - 1], value);
}
