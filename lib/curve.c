#include "curve.h"
#include "need.h"
#include <math.h>

/* point = sum of weight[0..d] times the d+1 control points from c on */
static void combine(int d, int N, const double *c, const double *weight, double *point)
{
    KW_NEED(N >= 1, "N = %d", N);
    for (int a = 0; a < N; a++) {
        point[a] = 0;
        for (int j = 0; j <= d; j++)
            point[a] += weight[j] * c[j * N + a];
    }
}

/* the control points of function `first` and after */
static const double *from(const double *c, int first, int N)
{
    return c + first * N;
}

void kw_curve_point(const kw_bspline *s, int N, const double *c, double x, double *point)
{
    double value[KW_BSPLINE_DEGREE + 1];
    int first = kw_bspline_basis(s, x, value);

    combine(s->d, N, from(c, first, N), value, point);
}

void kw_curve_blossom(const kw_bspline *s, int i, int N, const double *c, const double *u,
                      double *point)
{
    const double *t = s->t;
    double b[KW_BSPLINE_DEGREE + 1]; /* one coordinate of the d+1 points */
    int d = s->d, first = i - d;

    KW_NEED(d <= i && i < s->n && t[i] < t[i + 1], "%d is no span", i);
    KW_NEED(N >= 1, "N = %d", N);
    for (int p = 0; p < d; p++)
        KW_NEED(isfinite(u[p]), "u[%d] = %g", p, u[p]);
    for (int a = 0; a < N; a++) {
        for (int j = 0; j <= d; j++)
            b[j] = from(c, first + j, N)[a];
        for (int p = 1; p <= d; p++)
            for (int j = d; j >= p; j--) {
                double left = t[first + j], right = t[first + j + d + 1 - p];
                double width = right - left;

                b[j] = (right - u[p - 1]) / width * b[j - 1] +
                       (u[p - 1] - left) / width * b[j];
            }
        point[a] = b[d];
    }
}

void kw_curve_deboor(const kw_bspline *s, int N, const double *c, double x, double *point)
{
    double u[KW_BSPLINE_DEGREE + 1];

    for (int p = 0; p < s->d; p++)
        u[p] = x;
    kw_curve_blossom(s, kw_bspline_span(s, x), N, c, u, point);
}

void kw_curve_derivatives(const kw_bspline *s, int N, const double *c, double x, int r,
                          double *value)
{
    enum { K = KW_BSPLINE_DEGREE + 1 };
    double basis[K * K];
    int d = s->d, first = kw_bspline_derivatives(s, x, r <= d ? r : d, basis);

    for (int q = 0; q <= r; q++)
        if (q <= d)
            combine(d, N, from(c, first, N), basis + q * (d + 1), value + q * N);
        else
            for (int a = 0; a < N; a++)
                value[q * N + a] = 0;
}

void kw_curve_close(const kw_bspline *s, int N, double *c)
{
    int period = (s->n - s->d) * N;

    KW_NEED(N >= 1, "N = %d", N);
    for (int i = period; i < s->n * N; i++)
        c[i] = c[i - period];
}

static void need_count(int count)
{
    KW_NEED(count >= 0, "%d points", count);
}

void kw_curve_point_many(const kw_bspline *s, int N, const double *c, int count,
                         const double *x, double *point)
{
    need_count(count);
    for (int i = 0; i < count; i++)
        kw_curve_point(s, N, c, x[i], point + (size_t)i * (size_t)N);
}

void kw_curve_deboor_many(const kw_bspline *s, int N, const double *c, int count,
                          const double *x, double *point)
{
    need_count(count);
    for (int i = 0; i < count; i++)
        kw_curve_deboor(s, N, c, x[i], point + (size_t)i * (size_t)N);
}

void kw_curve_derivatives_many(const kw_bspline *s, int N, const double *c, int count,
                               const double *x, int r, double *value)
{
    size_t size = (size_t)(r + 1) * (size_t)N;

    need_count(count);
    for (int i = 0; i < count; i++)
        kw_curve_derivatives(s, N, c, x[i], r, value + (size_t)i * size);
}
