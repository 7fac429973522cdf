#include "bernstein.h"
#include "bspline.h" /* the largest degree */
#include "need.h"
#include <math.h>

static void need_arguments(int d, double x)
{
    KW_NEED(0 <= d && d <= KW_BSPLINE_DEGREE, "degree %d, not in 0 .. %d", d,
            KW_BSPLINE_DEGREE);
    KW_NEED(isfinite(x), "x = %g", x);
}

void kw_bernstein_basis(int d, double x, double *value)
{
    double power = 1, binomial = 1;

    need_arguments(d, x);
    for (int j = 0; j <= d; j++) { /* binomial(d,j) x^j */
        value[j] = binomial * power;
        power *= x;
        binomial = binomial * (d - j) / (j + 1);
    }
    power = 1;
    for (int j = d; j >= 0; j--) { /* times (1-x)^(d-j) */
        value[j] *= power;
        power *= 1 - x;
    }
}

void kw_bernstein_casteljau(int d, int N, const double *c, double x, double *point)
{
    double b[KW_BSPLINE_DEGREE + 1]; /* one coordinate of the d+1 points */

    need_arguments(d, x);
    KW_NEED(N >= 1, "N = %d", N);
    for (int a = 0; a < N; a++) {
        for (int j = 0; j <= d; j++)
            b[j] = c[j * N + a];
        for (int p = 1; p <= d; p++)
            for (int j = 0; j <= d - p; j++)
                b[j] = (1 - x) * b[j] + x * b[j + 1];
        point[a] = b[0];
    }
}
