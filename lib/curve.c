#include "curve.h"
#include "combine.h"
#include "need.h"
#include <math.h>

static void need_dimension(int N)
{
    KW_NEED(N >= 1, "N = %d", N);
}

/* the control points of function `first` and after */
static const double *from(const double *c, int first, int N)
{
    return c + first * N;
}

void kw_curve_point(const kw_bspline *s, int N, const double *c, double x, double *point)
{
    kw_curve_derivatives_many(s, N, c, 1, &x, 0, point);
}

void kw_curve_blossom(const kw_bspline *s, int i, int N, const double *c, const double *u,
                      double *point)
{
    const double *t = s->t;
    double b[KW_BSPLINE_DEGREE + 1]; /* one coordinate of the d+1 points */
    int d = s->d, first = i - d;

    KW_NEED(d <= i && i < s->n && t[i] < t[i + 1], "%d is no span", i);
    need_dimension(N);
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
    kw_curve_derivatives_many(s, N, c, 1, &x, r, value);
}

void kw_curve_close(const kw_bspline *s, int N, double *c)
{
    int period = (s->n - s->d) * N;

    need_dimension(N);
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
    kw_curve_derivatives_many(s, N, c, count, x, 0, point);
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
    enum { ROOM = (KW_BSPLINE_DEGREE + 1) * (KW_BSPLINE_DEGREE + 1) };
    double basis[ROOM];
    int first[ROOM], k = s->d + 1, rows, batch;

    need_count(count);
    need_dimension(N);
    KW_NEED(r >= 0, "derivative %d", r);
    rows = r < k ? r + 1 : k; /* the others are zero */
    batch = ROOM / (k * rows);
    for (int done = 0; done < count; done += batch) {
        int points = count - done < batch ? count - done : batch;
        const double *row = basis;

        kw_bspline_derivatives_many(s, points, x + done, rows - 1, first, basis);
        for (int i = 0; i < points; i++) {
            for (int q = 0; q < rows; q++, row += k, value += N)
                kw_combine(k, N, row, from(c, first[i], N), value);
            for (int zeros = (r + 1 - rows) * N; zeros > 0; zeros--)
                *value++ = 0;
        }
    }
}
