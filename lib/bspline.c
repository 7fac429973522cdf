#include "bspline.h"
#include "need.h"
#include "recursion.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { K = KW_BSPLINE_DEGREE + 1 };

/* --- the table of spans ---

   The domain is cut into equal buckets, as wide as a span is on average; those at the ends are
   half as wide, so that with equal spans each knot lies in the middle of a bucket and each
   bucket meets two spans, whatever the rounding. A point of bucket b lies in one of the
   `candidates` spans from before[b] on, the last span that begins in an earlier bucket. The bucket
   of a point is computed in one way alone, which never decreases with x, and so the table is
   right to the last bit. */

static int bucket_of(const kw_bspline *s, double x)
{
    return (int)((x - s->t[s->d]) * s->scale + 0.5);
}

static void make_table(kw_bspline *s)
{
    const int d = s->d, n = s->n;
    int *restrict before, last = d, most = 0; /* spans from one bucket to the next */

    s->buckets = n - d + 1;
    s->scale = (n - d) / (s->t[n] - s->t[d]);
    if (!isfinite(s->scale))
        s->scale = 0; /* a domain of next to no length: one bucket is in use */
    s->before = before = kw_need_memory((size_t)s->buckets + 1, sizeof *before);
    for (int i = d; i < n; i++)
        if (s->t[i] < s->t[i + 1])
            before[bucket_of(s, s->t[i]) + 1] = i;
    before[0] = d;
    for (int b = 1; b <= s->buckets; b++) {
        int next = before[b] > 0 ? before[b] : last; /* 0: no span begins there */

        most = next - last > most ? next - last : most;
        before[b] = last = next;
    }
    s->candidates = most + 1;
    /* every bucket has as many, inside the domain */
    for (int b = s->buckets; before[b] > n - s->candidates; b--)
        before[b] = n - s->candidates;
}

/* --- spaces --- */

static void need_degree(int d)
{
    KW_NEED(0 <= d && d <= KW_BSPLINE_DEGREE, "degree %d, not in 0 .. %d", d,
            KW_BSPLINE_DEGREE);
}

kw_bspline *kw_bspline_new(int d, int n, const double *t)
{
    need_degree(d);
    KW_NEED(n >= d + 1, "%d functions of degree %d (%d knots) are too few", n, d,
            n + d + 1);
    for (int i = 0; i <= n + d; i++) {
        KW_NEED(isfinite(t[i]), "t[%d] = %g", i, t[i]);
        KW_NEED(i == 0 || t[i - 1] <= t[i],
                "knots decrease: t[%d] = %.17g, t[%d] = %.17g", i - 1, t[i - 1], i, t[i]);
        KW_NEED(i <= d || t[i - d - 1] < t[i],
                "knot %.17g appears more than %d times (from t[%d])", t[i], d + 1,
                i - d - 1);
    }
    KW_NEED(isfinite(t[n + d] - t[0]), "knots from %g to %g are too far apart", t[0],
            t[n + d]);
    KW_NEED(t[d] < t[d + 1] && t[n - 1] < t[n],
            "an empty span at an end of the domain [t[%d], t[%d]] = [%.17g, %.17g]", d, n,
            t[d], t[n]);

    kw_bspline *s = kw_need_memory(1, sizeof *s);
    s->d = d;
    s->n = n;
    s->t = kw_need_memory((size_t)n + (size_t)d + 1, sizeof *s->t);
    memcpy(s->t, t, ((size_t)n + (size_t)d + 1) * sizeof *t);
    make_table(s);
    return s;
}

kw_bspline *kw_bspline_new_copy(const kw_bspline *s)
{
    return kw_bspline_new(s->d, s->n, s->t);
}

/* The partition with the multiplicities mu, behind `ends` copies of tau[0] and before as
   many of tau[L]: the knots (caller frees) and their number. */
static double *repeat_knots(int d, int L, const double *tau, const int *mu, int ends,
                            int *count)
{
    double *t;
    int last = 0;

    need_degree(d);
    KW_NEED(L >= 1, "L = %d", L);
    *count = 2 * ends;
    for (int i = 1; i < L; i++) {
        KW_NEED(!mu || (1 <= mu[i - 1] && mu[i - 1] <= d + 1), "mu[%d] = %d, degree %d",
                i - 1, mu[i - 1], d);
        *count += mu ? mu[i - 1] : 1;
    }
    t = kw_need_memory((size_t)*count, sizeof *t);
    for (int i = 0; i <= L; i++) {
        int copies = i == 0 || i == L ? ends : mu ? mu[i - 1] : 1;

        KW_NEED(i == 0 || tau[i - 1] < tau[i], "tau[%d] = %.17g, tau[%d] = %.17g", i - 1,
                tau[i - 1], i, tau[i]);
        for (int c = 0; c < copies; c++)
            t[last++] = tau[i];
    }
    return t;
}

kw_bspline *kw_bspline_new_open(int d, int L, const double *tau, const int *mu)
{
    int count;
    double *t = repeat_knots(d, L, tau, mu, d + 1, &count);
    kw_bspline *s = kw_bspline_new(d, count - d - 1, t);

    free(t);
    return s;
}

/* `cells` equal cells of [a,b]; the ends are exact */
static double *equal_cells(int cells, double a, double b)
{
    KW_NEED(cells >= 1, "%d cells", cells);
    KW_NEED(cells <= INT_MAX - 2 * KW_BSPLINE_DEGREE - 1, "%d cells", cells);
    KW_NEED(a < b && isfinite(b - a), "[%g, %g]", a, b);
    double *tau = kw_need_memory((size_t)cells + 1, sizeof *tau);
    for (int i = 0; i <= cells; i++)
        tau[i] = i == cells ? b : a + (b - a) * i / cells;
    return tau;
}

kw_bspline *kw_bspline_new_open_uniform(int d, int cells, double a, double b)
{
    double *tau = equal_cells(cells, a, b);
    kw_bspline *s = kw_bspline_new_open(d, cells, tau, NULL);

    free(tau);
    return s;
}

kw_bspline *kw_bspline_new_uniform(int d, int cells, double a, double b)
{
    double *tau = equal_cells(cells, a, b), *t;
    kw_bspline *s;

    need_degree(d);
    t = kw_need_memory((size_t)cells + 2 * (size_t)d + 1, sizeof *t);
    for (int i = 0; i <= cells + 2 * d; i++) {
        int cell = i - d;

        t[i] = 0 <= cell && cell <= cells ? tau[cell] : a + (b - a) * cell / cells;
    }
    s = kw_bspline_new(d, cells + d, t);
    free(t);
    free(tau);
    return s;
}

kw_bspline *kw_bspline_new_periodic(int d, int L, const double *tau, const int *mu)
{
    int count;
    double *t0 = repeat_knots(d, L, tau, mu, 1, &count); /* t[d] .. t[n] */
    int period = count - 1, n = d + period;
    double width = tau[L] - tau[0];
    double *t = kw_need_memory((size_t)n + (size_t)d + 1, sizeof *t);
    kw_bspline *s;

    for (int i = 0; i < count; i++)
        t[d + i] = t0[i];
    for (int i = d - 1; i >= 0; i--)
        t[i] = t[i + period] - width;
    for (int i = n + 1; i <= n + d; i++)
        t[i] = t[i - period] + width;
    s = kw_bspline_new(d, n, t);
    free(t);
    free(t0);
    return s;
}

void kw_bspline_free(kw_bspline *s)
{
    if (!s)
        return;
    free(s->t);
    free(s->before);
    free(s);
}

/* --- knots --- */

static void need_function(const kw_bspline *s, int j)
{
    KW_NEED(0 <= j && j < s->n, "function %d, not in 0 .. %d", j, s->n - 1);
}

static inline int span_of(const kw_bspline *s, double x)
{
    int low; /* t[low] <= x, and the span is one of `count` from low on */

    KW_NEED(s->t[s->d] <= x && x <= s->t[s->n],
            "x = %.17g outside the domain [%.17g, %.17g]", x, s->t[s->d], s->t[s->n]);
    low = s->before[bucket_of(s, x)];
    for (int count = s->candidates; count > 1; count -= count / 2) {
        /* a choice, not a branch: no processor can guess which half it is */
        const int half[] = {low, low + count / 2};

        low = half[s->t[half[1]] <= x];
    }
    return low;
}

int kw_bspline_span(const kw_bspline *s, double x)
{
    return span_of(s, x);
}

int kw_bspline_first_span(const kw_bspline *s, int j)
{
    int i = j > s->d ? j : s->d;

    need_function(s, j);
    while (s->t[i] == s->t[i + 1])
        i++;
    return i;
}

int kw_bspline_multiplicity(const kw_bspline *s, double x)
{
    int count = 0;

    KW_NEED(!isnan(x), "x = %g", x);
    for (int i = 0; i <= s->n + s->d; i++)
        count += s->t[i] == x;
    return count;
}

double kw_bspline_greville(const kw_bspline *s, int j)
{
    const double *t;
    double sum = 0;

    need_function(s, j);
    t = s->t + j;
    if (s->d == 0)
        return t[0] + (t[1] - t[0]) / 2;
    for (int i = 1; i <= s->d; i++)
        sum += t[i];
    /* rounding must not carry the mean out of [t[1], t[d]], which may end the domain */
    return fmin(fmax(sum / s->d, t[1]), t[s->d]);
}

/* --- the local functions --- */

static void need_span(const kw_bspline *s, int i)
{
    KW_NEED(s->d <= i && i < s->n && s->t[i] < s->t[i + 1], "%d is no span", i);
}

static void need_order(int r)
{
    KW_NEED(r >= 0, "derivative %d", r);
}

/* how many rows of derivatives 0 .. r are not zero */
static int rows_of(const kw_bspline *s, int r)
{
    return r < s->d ? r + 1 : s->d + 1;
}

/* Fills the rows beyond the degree of (r+1) x (d+1) derivatives. */
static void zero_rows(const kw_bspline *s, int r, double *value)
{
    int k = s->d + 1;

    for (int j = rows_of(s, r) * k; j < (r + 1) * k; j++)
        value[j] = 0;
}

int kw_bspline_basis(const kw_bspline *s, double x, double *value)
{
    int i = span_of(s, x);

    kw_recursion_one(s->d, s->t + i + 1, x, 1, 0, value);
    return i - s->d;
}

void kw_bspline_derivatives_on(const kw_bspline *s, int i, double x, int r, double *value)
{
    need_span(s, i);
    KW_NEED(isfinite(x), "x = %g", x);
    need_order(r);
    kw_recursion_one(s->d, s->t + i + 1, x, 1, rows_of(s, r) - 1, value);
    zero_rows(s, r, value);
}

void kw_bspline_derivative_on(const kw_bspline *s, int i, double x, int r, double *value)
{
    double all[K * K];
    int k = s->d + 1;

    if (r <= 0) { /* the values, or an abort */
        kw_bspline_derivatives_on(s, i, x, r, value);
        return;
    }
    kw_bspline_derivatives_on(s, i, x, r < k ? r : 0, all);
    for (int j = 0; j < k; j++)
        value[j] = r < k ? all[r * k + j] : 0;
}

int kw_bspline_derivatives(const kw_bspline *s, double x, int r, double *value)
{
    int i = span_of(s, x);

    kw_bspline_derivatives_on(s, i, x, r, value);
    return i - s->d;
}

void kw_bspline_pieces(const kw_bspline *s, int i, double *piece)
{
    double value[K * K], factorial = 1;
    const double *t = s->t + i;
    int d = s->d;

    need_span(s, i);
    kw_recursion_one(d, t + 1, t[0], t[1] - t[0], d, value); /* with respect to u */
    for (int q = 0; q <= d; q++) {
        for (int j = 0; j <= d; j++)
            piece[j * (d + 1) + q] = value[q * (d + 1) + j] / factorial;
        factorial *= q + 1;
    }
}

void kw_bspline_blossom(const kw_bspline *s, int i, const double *u, double *value)
{
    need_span(s, i);
    for (int p = 0; p < s->d; p++)
        KW_NEED(isfinite(u[p]), "u[%d] = %g", p, u[p]);
    kw_recursion_blossom(s->d, s->t + i + 1, u, value);
}

void kw_bspline_blossom_knots(const kw_bspline *s, int i, const double *u, double *value)
{
    double outwards[KW_BSPLINE_DEGREE];
    int left = 0; /* arguments up to the span */

    need_span(s, i);
    while (left < s->d && u[left] <= s->t[i])
        left++;
    for (int q = 0; q < s->d; q++)
        outwards[q] = u[q < left ? left - 1 - q : q];
    kw_bspline_blossom(s, i, outwards, value);
}

/* --- one function anywhere --- */

/* a / b where b > 0, and 0 where b = 0: the convention of the recursion for a function of
   lower order whose support is empty */
static double ratio(double a, double b)
{
    return b > 0 ? a / b : 0;
}

/* Which of the k spans of function j holds x, or -1. At the right end of the domain it is
   the span to the left. */
static int span_of_support(const kw_bspline *s, int j, double x)
{
    const double *t = s->t + j;

    for (int i = 0; i <= s->d; i++)
        if (x == s->t[s->n] ? t[i] < x && x <= t[i + 1] : t[i] <= x && x < t[i + 1])
            return i;
    return -1;
}

double kw_bspline_one(const kw_bspline *s, int j, int r, double x)
{
    const double *t;
    double value[K] = {0}; /* of the functions j, j+1, .. */
    int d = s->d, span;

    need_function(s, j);
    t = s->t + j;
    KW_NEED(r >= 0, "derivative %d", r);
    KW_NEED(isfinite(x), "x = %g", x);
    span = span_of_support(s, j, x);
    if (span < 0 || r > d)
        return 0;
    value[span] = 1;
    for (int p = 1; p <= d; p++)
        for (int i = 0; i <= d - p; i++) {
            double width = t[i + p] - t[i], next_width = t[i + p + 1] - t[i + 1];

            value[i] =
                p <= d - r
                    ? ratio(x - t[i], width) * value[i] +
                          ratio(t[i + p + 1] - x, next_width) * value[i + 1]
                    : p * (ratio(value[i], width) - ratio(value[i + 1], next_width));
        }
    return value[0];
}

/* --- many points --- */

static void need_count(int count)
{
    KW_NEED(count >= 0, "%d points", count);
}

void kw_bspline_span_many(const kw_bspline *s, int count, const double *x, int *span)
{
    need_count(count);
    for (int i = 0; i < count; i++)
        span[i] = span_of(s, x[i]);
}

void kw_bspline_basis_many(const kw_bspline *s, int count, const double *x, int *first,
                           double *value)
{
    kw_bspline_derivatives_many(s, count, x, 0, first, value);
}

void kw_bspline_derivatives_many(const kw_bspline *s, int count, const double *x, int r,
                                 int *first, double *value)
{
    enum { BATCH = 64 }; /* spans are found ahead of the values, which wait for them */
    size_t size = ((size_t)r + 1) * (size_t)(s->d + 1);
    int rows;

    need_count(count);
    need_order(r);
    rows = rows_of(s, r);
    for (int done = 0, end; done < count; done = end) {
        end = count - done < BATCH ? count : done + BATCH;
        kw_bspline_span_many(s, end - done, x + done, first + done);
        for (int i = done; i < end; i += 2) {
            const double *t = s->t + first[i] + 1;
            double *at = value + (size_t)i * size;

            if (i + 1 < end)
                kw_recursion_two(s->d, t, x[i], at, s->t + first[i + 1] + 1, x[i + 1],
                                 at + size, rows - 1);
            else
                kw_recursion_one(s->d, t, x[i], 1, rows - 1, at);
        }
        for (int i = done; i < end && r > s->d; i++)
            zero_rows(s, r, value + (size_t)i * size);
        for (int i = done; i < end; i++)
            first[i] -= s->d;
    }
}
