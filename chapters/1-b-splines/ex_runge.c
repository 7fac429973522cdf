/* Interpolation -- one polynomial of high degree, or a spline of low degree.

   What to see: through the same equally spaced data the polynomial swings ever wilder near
   the ends as its degree n grows, while the cubic spline settles down.

   Book: section 1.1, the motivation in the first paragraph on B-splines.
   Claims: bs.runge.*
   Chosen here: Runge's function 1/(1+25x^2) on [-1,1]; cubic splines whose knots are the
   data points but for the second and the last but one (`not a knot'). */

#include "bspline.h" /* the spline space */
#include "claim.h"   /* what we found, for the ledger */
#include "curve.h"   /* the interpolating spline */
#include "dense.h"   /* its coefficients */
#include "need.h"    /* there is one and only one spline through the data */
#include "out.h"     /* columns for gnuplot */
#include <math.h>
#include <stdio.h>

enum {
    D = 3,
    MOST = 40,
    CELL = 1000,   /* points of a cell between two nodes, for the largest error */
    SAMPLES = 250, /* points of a curve */
    CASES = 3
};

static double runge(double x)
{
    return 1 / (1 + 25 * x * x);
}

/* Equally spaced point i of n+1. */
static double node(int i, int n)
{
    return -1 + 2.0 * i / n;
}

/* The polynomial of degree n through the data, by the barycentric formula, whose weights for
   equally spaced points are (-1)^i binomial(n,i). [Berrut, Trefethen, SIAM Review 46] */
static double polynomial(int n, double x)
{
    double above = 0, below = 0, weight = 1;

    for (int i = 0; i <= n; i++) {
        if (x == node(i, n))
            return runge(x);
        above += weight / (x - node(i, n)) * runge(node(i, n));
        below += weight / (x - node(i, n));
        weight = -weight * (n - i) / (i + 1);
    }
    return above / below;
}

/* The cubic spline space with as many functions as data. */
static kw_bspline *spline_space(int n)
{
    double t[MOST + D + 2];

    for (int i = 0; i <= D; i++) {
        t[i] = -1;
        t[n + 1 + i] = 1;
    }
    for (int i = D + 1; i <= n; i++)
        t[i] = node(i - D + 1, n);
    return kw_bspline_new(D, n + 1, t);
}

/* The coefficients of the spline through the data. */
static void interpolate(const kw_bspline *s, int n, double *c)
{
    double A[(MOST + 1) * (MOST + 1)] = {0};

    for (int i = 0; i <= n; i++) {
        double value[D + 1];
        int first = kw_bspline_basis(s, node(i, n), value);

        for (int j = 0; j <= D; j++)
            A[i * (n + 1) + first + j] = value[j];
        c[i] = runge(node(i, n));
    }
    KW_NEED(kw_dense_solve(n + 1, 1, A, c) == 0, "no spline through %d points", n + 1);
}

/* The largest errors of both over [-1,1]: the errors are zero at the nodes and rise to a bump in
   every cell between two of them. */
static void errors(int n, double *of_polynomial, double *of_spline)
{
    double c[MOST + 1];
    kw_bspline *s = spline_space(n);

    *of_polynomial = *of_spline = 0;
    interpolate(s, n, c);
    for (int q = 0; q <= n * CELL; q++) {
        double x = node(q, n * CELL), value;

        kw_curve_point(s, 1, c, x, &value);
        *of_polynomial = fmax(*of_polynomial, fabs(polynomial(n, x) - runge(x)));
        *of_spline = fmax(*of_spline, fabs(value - runge(x)));
    }
    kw_bspline_free(s);
}

static void write_curves(kw_out *f)
{
    const int n = 10;
    double c[MOST + 1];
    kw_bspline *s = spline_space(n);

    interpolate(s, n, c);
    kw_out_section(f, "n = 10", "x runge polynomial spline");
    for (int q = 0; q <= SAMPLES; q++) {
        double x = node(q, SAMPLES), value;

        kw_curve_point(s, 1, c, x, &value);
        kw_out_number(f, x);
        kw_out_number(f, runge(x));
        kw_out_number(f, polynomial(n, x));
        kw_out_number(f, value);
        kw_out_row(f);
    }
    kw_bspline_free(s);
}

int main(void)
{
    const int n[CASES] = {10, 20, 40};
    kw_out *f = kw_out_data("ex_runge"), *report = kw_claim_new("ex_runge");
    double p, s;

    write_curves(f);
    kw_out_section(f, "errors", "n polynomial spline");
    for (int m = 4; m <= MOST; m += 2) {
        errors(m, &p, &s);
        kw_out_number(f, m);
        kw_out_number(f, p);
        kw_out_number(f, s);
        kw_out_row(f);
    }
    for (int i = 0; i < CASES; i++) {
        char id[32];

        errors(n[i], &p, &s);
        snprintf(id, sizeof id, "bs.runge.polynomial.%d", n[i]);
        kw_claim_real(report, id, p);
        snprintf(id, sizeof id, "bs.runge.spline.%d", n[i]);
        kw_claim_real(report, id, s);
    }
    return kw_out_close(f) | kw_out_close(report);
}
