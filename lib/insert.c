#include "insert.h"
#include "combine.h"
#include "need.h"
#include "recursion.h"
#include <stdlib.h>
#include <string.h>

kw_bspline *kw_insert_new_knot(const kw_bspline *s, double x)
{
    int knots = s->n + s->d + 1, before = kw_bspline_span(s, x) + 1;
    double *t = kw_need_memory((size_t)knots + 1, sizeof *t);
    kw_bspline *fine;

    KW_NEED(s->t[s->d] < x && x < s->t[s->n], "x = %.17g is not inside [%.17g, %.17g]", x,
            s->t[s->d], s->t[s->n]);
    memcpy(t, s->t, (size_t)before * sizeof *t);
    t[before] = x;
    memcpy(t + before + 1, s->t + before, (size_t)(knots - before) * sizeof *t);
    fine = kw_bspline_new(s->d, s->n + 1, t);
    free(t);
    return fine;
}

kw_bspline *kw_insert_new_dyadic(const kw_bspline *s)
{
    int knots = s->n + s->d + 1, count = 0, first = 0, last = 0;
    double *t = kw_need_memory(2 * (size_t)knots, sizeof *t);
    kw_bspline *fine;

    for (int i = 0; i < knots; i++) {
        if (i == s->d)
            first = count;
        if (i == s->n)
            last = count;
        t[count++] = s->t[i];
        if (i + 1 < knots && s->t[i] < s->t[i + 1]) {
            double middle = s->t[i] + (s->t[i + 1] - s->t[i]) / 2;

            KW_NEED(s->t[i] < middle && middle < s->t[i + 1],
                    "no number between the knots %.17g and %.17g", s->t[i], s->t[i + 1]);
            t[count++] = middle;
        }
    }
    /* the domain begins at t[first] and ends at t[last]; d auxiliary knots on either side */
    fine = kw_bspline_new(s->d, last - first + s->d, t + first - s->d);
    free(t);
    return fine;
}

void kw_insert_boehm(const kw_bspline *s, double x, int N, const double *c, double *fine)
{
    int i = kw_bspline_span(s, x), d = s->d;
    const double *t = s->t;

    KW_NEED(t[d] < x && x < t[s->n], "x = %.17g is not inside [%.17g, %.17g]", x, t[d],
            t[s->n]);
    KW_NEED(N >= 1, "N = %d", N);
    for (int j = 0; j <= s->n; j++) {
        /* the share of c_j: 1 before the span, 0 behind it */
        double w = j <= i - d ? 1 : j > i ? 0 : (x - t[j]) / (t[j + d] - t[j]);

        for (int a = 0; a < N; a++) {
            double here = w > 0 ? w * c[j * N + a] : 0;
            double before = w < 1 ? (1 - w) * c[(j - 1) * N + a] : 0;

            fine[j * N + a] = here + before;
        }
    }
}

static void need_same_domain(const kw_bspline *coarse, const kw_bspline *fine)
{
    KW_NEED(coarse->d == fine->d, "degrees %d and %d", coarse->d, fine->d);
    KW_NEED(coarse->t[coarse->d] == fine->t[fine->d] &&
                coarse->t[coarse->n] == fine->t[fine->n],
            "domains [%.17g, %.17g] and [%.17g, %.17g]", coarse->t[coarse->d],
            coarse->t[coarse->n], fine->t[fine->d], fine->t[fine->n]);
}

void kw_insert_need_nested(const kw_bspline *coarse, const kw_bspline *fine)
{
    need_same_domain(coarse, fine);
    /* walk through the fine knots; every coarse one must be met in turn */
    for (int i = coarse->d + 1, j = fine->d + 1; i < coarse->n; i++, j++) {
        while (j < fine->n && fine->t[j] < coarse->t[i])
            j++;
        KW_NEED(j < fine->n && fine->t[j] == coarse->t[i],
                "the coarse knot %.17g (t[%d]) is missing in the fine space",
                coarse->t[i], i);
    }
}

/* out = w after + (1-w) before, N numbers each; out may be `after`. Pairs keep compilers from
   putting the end of one coefficient and the beginning of the next into one register: what has
   just been stored as two is slow to load as one. */
static inline void average(int N, double w, const double *after, const double *before,
                           double *out)
{
    int a = 0;

    for (; a + 2 <= N; a += 2) {
        kw_pair x, y;

        memcpy(&x, after + a, sizeof x);
        memcpy(&y, before + a, sizeof y);
        x = w * x + (1 - w) * y;
        memcpy(out + a, &x, sizeof x);
    }
    if (a < N)
        out[a] = w * after[a] + (1 - w) * before[a];
}

/* Boehm's rule for a knot x. t and f are the last knot before x and the coefficient with its
   number, from there on to the left those of the space that has all knots before x; right[0] is
   the first knot after x. f[1] becomes f[0]; then f[0] and the d-1 before it become averages. */
static inline void insert_next(int d, int N, const double *t, const double *right,
                               double x, double *f)
{
    memcpy(f + N, f, (size_t)N * sizeof *f);
    for (int j = 0; j > -d; j--) {
        double w = (x - t[j]) / (right[j + d - 1] - t[j]);

        average(N, w, f + j * N, f + (j - 1) * N, f + j * N);
    }
}

/* A walk through the fine knots: each that is a coarse one brings a coarse coefficient. */
static inline void insert_all(int d, int N, const kw_bspline *coarse,
                              const kw_bspline *fine, const double *restrict c,
                              double *restrict out)
{
    const double *t = fine->t, *next = coarse->t;

    for (int i = 0; i < fine->n; i++) {
        if (t[i] != *next) {
            insert_next(d, N, t + i - 1, next, t[i], out + (i - 1) * N);
            continue;
        }
        memcpy(out + i * N, c, (size_t)N * sizeof *c);
        c += N;
        next++;
    }
    KW_NEED(next == coarse->t + coarse->n,
            "the coarse knot %.17g (t[%d]) is missing in the fine space", *next,
            (int)(next - coarse->t));
}

void kw_insert_boehm_all(const kw_bspline *coarse, const kw_bspline *fine, int N,
                         const double *c, double *out)
{
    int d = fine->d;

    need_same_domain(coarse, fine);
    KW_NEED(N >= 1, "N = %d", N);
    for (int j = 0; j <= d; j++)
        KW_NEED(coarse->t[j] == fine->t[j] &&
                    coarse->t[coarse->n + j] == fine->t[fine->n + j],
                "other auxiliary knots: %.17g and %.17g, %.17g and %.17g", coarse->t[j],
                fine->t[j], coarse->t[coarse->n + j], fine->t[fine->n + j]);
    if (d == 3 && N == 3) /* the usual sizes, where compilers see them */
        insert_all(3, 3, coarse, fine, c, out);
    else
        insert_all(d, N, coarse, fine, c, out);
}

/* A fine coefficient is the blossom of a coarse piece at the d inner knots of the fine
   function; the row of the matrix are the weights of that blossom. */
int kw_insert_oslo_row(const kw_bspline *coarse, const kw_bspline *fine, int i,
                       double *alpha)
{
    int span;

    need_same_domain(coarse, fine);
    span = kw_bspline_span(coarse, fine->t[kw_bspline_first_span(fine, i)]);
    kw_bspline_blossom_knots(coarse, span, fine->t + i + 1, alpha);
    return span - coarse->d;
}

void kw_insert_oslo(const kw_bspline *coarse, const kw_bspline *fine, int N,
                    const double *c, double *out)
{
    double alpha[KW_BSPLINE_DEGREE + 1];

    kw_insert_need_nested(coarse, fine);
    KW_NEED(N >= 1, "N = %d", N);
    for (int i = 0; i < fine->n; i++) {
        int first = kw_insert_oslo_row(coarse, fine, i, alpha);

        kw_combine(coarse->d + 1, N, alpha, c + first * N, out + i * N);
    }
}

/* The first function that is not yet non-zero before x. */
static int first_fine_function(const kw_bspline *fine, double x)
{
    int low = 0, high = fine->n; /* functions below low lie before x, from high on not */

    while (low < high) {
        int middle = low + (high - low) / 2;

        if (fine->t[kw_bspline_first_span(fine, middle)] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

int kw_insert_two_scale(const kw_bspline *coarse, const kw_bspline *fine, int j,
                        int *first, double *coefficient)
{
    double alpha[KW_BSPLINE_DEGREE + 1];
    int count = 0, d = coarse->d;

    need_same_domain(coarse, fine);
    KW_NEED(0 <= j && j < coarse->n, "function %d, not in 0 .. %d", j, coarse->n - 1);
    *first = 0;
    for (int i = first_fine_function(fine, coarse->t[kw_bspline_first_span(coarse, j)]);
         i < fine->n; i++) {
        int from = kw_insert_oslo_row(coarse, fine, i, alpha);

        if (from > j)
            break;
        if (j > from + d || alpha[j - from] == 0)
            continue;
        if (count == 0)
            *first = i;
        while (count < i - *first) /* a zero between two coefficients */
            coefficient[count++] = 0;
        coefficient[count++] = alpha[j - from];
    }
    return count;
}
