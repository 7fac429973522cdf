#include "elevate.h"
#include "need.h"
#include <stdlib.h>

/* How often knot i of s is written in the elevated space: the last of its value twice. */
static int copies(const kw_bspline *s, int i)
{
    return i == s->n + s->d || s->t[i] < s->t[i + 1] ? 2 : 1;
}

/* The copies between which the domain lies, [t[first], t[last]]. */
static void place_domain(const kw_bspline *s, int *first, int *last)
{
    int count = 0;

    *first = 0;
    for (int i = 0; i < s->n; i++) {
        count += copies(s, i);
        if (i == s->d)
            *first = count - 1;
    }
    *last = count;
}

kw_bspline *kw_elevate_new(const kw_bspline *s)
{
    int d = s->d + 1, knots = s->n + s->d + 1, count = 0, first, last;
    double *t = kw_need_memory(2 * (size_t)knots, sizeof *t);
    kw_bspline *elevated;

    KW_NEED(d <= KW_BSPLINE_DEGREE, "degree %d, not in 0 .. %d", d, KW_BSPLINE_DEGREE);
    for (int i = 0; i < knots; i++)
        for (int c = 0; c < copies(s, i); c++)
            t[count++] = s->t[i];
    place_domain(s, &first, &last);
    /* d auxiliary knots on either side of the domain */
    elevated = kw_bspline_new(d, last - first + d, t + first - d);
    free(t);
    return elevated;
}

/* Aborts unless `elevated` is kw_elevate_new(s). */
static void need_elevated(const kw_bspline *s, const kw_bspline *elevated)
{
    int d = s->d + 1, first, last, place;

    KW_NEED(elevated->d == d, "degrees %d and %d", s->d, elevated->d);
    place_domain(s, &first, &last);
    KW_NEED(elevated->n == last - first + d, "%d functions, not the %d of kw_elevate_new",
            elevated->n, last - first + d);
    place = d - first; /* of the present copy among the knots of elevated */
    for (int i = 0; i <= s->n + s->d; i++)
        for (int c = 0; c < copies(s, i); c++, place++)
            KW_NEED(place < 0 || place > elevated->n + d || elevated->t[place] == s->t[i],
                    "t[%d] = %.17g, not the %.17g of kw_elevate_new", place,
                    elevated->t[place], s->t[i]);
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

    need_elevated(s, elevated);
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
