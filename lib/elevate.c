#include "elevate.h"
#include "need.h"
#include <stdlib.h>

kw_bspline *kw_elevate_new(const kw_bspline *s)
{
    int d = s->d + 1, knots = s->n + s->d + 1, count = 0, first = 0, last = 0;
    double *t = kw_need_memory(2 * (size_t)knots, sizeof *t);
    kw_bspline *elevated;

    KW_NEED(d <= KW_BSPLINE_DEGREE, "degree %d, not in 0 .. %d", d, KW_BSPLINE_DEGREE);
    for (int i = 0; i < knots; i++) {
        if (i == s->n)
            last = count;
        t[count++] = s->t[i];
        if (i + 1 == knots || s->t[i] < s->t[i + 1])
            t[count++] = s->t[i];
        if (i == s->d)
            first = count - 1;
    }
    /* the domain is [t[first], t[last]]; d auxiliary knots on either side */
    elevated = kw_bspline_new(d, last - first + d, t + first - d);
    free(t);
    return elevated;
}

/* The blossom of the elevated piece at its d+1 arguments is the mean of the blossoms of the
   piece itself at all but one of them, and a coefficient is the blossom at the d+1 inner
   knots of its function. weight[0..d] belongs to the coefficients of the span of s. */
static void mean_blossom(const kw_bspline *s, int span, const double *inner,
                         double *weight)
{
    double u[KW_BSPLINE_DEGREE], value[KW_BSPLINE_DEGREE + 1];
    int d = s->d;

    for (int j = 0; j <= d; j++)
        weight[j] = 0;
    for (int without = 0; without <= d; without++) {
        for (int q = 0; q < d; q++)
            u[q] = inner[q < without ? q : q + 1];
        kw_bspline_blossom_knots(s, span, u, value);
        for (int j = 0; j <= d; j++)
            weight[j] += value[j] / (d + 1);
    }
}

void kw_elevate(const kw_bspline *s, const kw_bspline *elevated, int N, const double *c,
                double *out)
{
    double weight[KW_BSPLINE_DEGREE + 1];
    int d = s->d;

    KW_NEED(elevated->d == d + 1, "degrees %d and %d", d, elevated->d);
    KW_NEED(N >= 1, "N = %d", N);
    for (int i = 0; i < elevated->n; i++) {
        int start = kw_bspline_first_span(elevated, i);
        int span = kw_bspline_span(s, elevated->t[start]);

        mean_blossom(s, span, elevated->t + i + 1, weight);
        for (int a = 0; a < N; a++) {
            double sum = 0;

            for (int j = 0; j <= d; j++)
                sum += weight[j] * c[(span - d + j) * N + a];
            out[i * N + a] = sum;
        }
    }
}
