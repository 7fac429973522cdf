#include "bspline.h"
#include "need.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the table of spans ---

   The domain is cut into as many equal buckets as there are spans of simple knots. A point of
   bucket b lies in a span from before[b] to before[b+1]: before[b] is the last span that begins
   in an earlier bucket. The bucket of a point is computed in one way alone, which never
   decreases with x whatever the rounding, and so the table is right to the last bit. */

static int bucket_of(const kw_bspline *s, double x)
{
    int b = (int)((x - s->t[s->d]) * s->scale);

    return b < s->buckets ? b : s->buckets - 1;
}

static void make_table(kw_bspline *s)
{
    int next = s->d, span = next; /* the next span to begin; the last that has begun */

    s->buckets = s->n - s->d;
    s->scale = s->buckets / (s->t[s->n] - s->t[s->d]);
    if (!isfinite(s->scale))
        s->scale = 0; /* a domain of next to no length: one bucket is in use */
    s->before = kw_need_memory((size_t)s->buckets + 1, sizeof *s->before);
    for (int b = 0; b <= s->buckets; b++) {
        while (next < s->n && bucket_of(s, s->t[next]) < b) {
            span = next++;
            while (next < s->n && s->t[next] == s->t[next + 1])
                next++;
        }
        s->before[b] = span;
    }
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
    for (int i = 0; i <= n + d; i++)
        KW_NEED(isfinite(t[i]), "t[%d] = %g", i, t[i]);
    for (int i = 0; i < n + d; i++)
        KW_NEED(t[i] <= t[i + 1], "knots decrease: t[%d] = %.17g, t[%d] = %.17g", i, t[i],
                i + 1, t[i + 1]);
    for (int i = 0; i < n; i++)
        KW_NEED(t[i] < t[i + d + 1], "knot %.17g appears more than %d times (from t[%d])",
                t[i], d + 1, i);
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

int kw_bspline_span(const kw_bspline *s, double x)
{
    int low, high, b; /* t[low] <= x < t[high], or x is the right end */

    KW_NEED(s->t[s->d] <= x && x <= s->t[s->n],
            "x = %.17g outside the domain [%.17g, %.17g]", x, s->t[s->d], s->t[s->n]);
    b = bucket_of(s, x);
    low = s->before[b];
    high = s->before[b + 1] + 1;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;

        if (x < s->t[middle])
            high = middle;
        else
            low = middle;
    }
    return low;
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

/* One step of the recursion of Definition 3 on span i: from the p local functions of
   degree p-1, value[0..p-1], to the p+1 of degree p, value[0..p]. No denominator is zero,
   because every one of these supports contains the span. */
static void raise_degree(const double *t, int i, int p, double x, double *value)
{
    double from_left = 0;

    for (int r = 0; r < p; r++) {
        double left = t[i + 1 + r - p], right = t[i + 1 + r], width = right - left;
        double old = value[r];

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
static void raise_derivative(const double *t, int i, int p, double h, double *value)
{
    double from_left = 0;

    for (int r = 0; r < p; r++) {
        double left = t[i + 1 + r - p], right = t[i + 1 + r];
        double share = p * (value[r] * h / (right - left));

        value[r] = from_left - share;
        from_left = share;
    }
    value[p] = from_left;
}

static void need_span(const kw_bspline *s, int i)
{
    KW_NEED(s->d <= i && i < s->n && s->t[i] < s->t[i + 1], "%d is no span", i);
}

int kw_bspline_basis(const kw_bspline *s, double x, double *value)
{
    int i = kw_bspline_span(s, x);

    value[0] = 1;
    for (int p = 1; p <= s->d; p++)
        raise_degree(s->t, i, p, x, value);
    return i - s->d;
}

void kw_bspline_derivatives_on(const kw_bspline *s, int i, double x, int r, double *value)
{
    int d = s->d;

    need_span(s, i);
    KW_NEED(isfinite(x), "x = %g", x);
    KW_NEED(r >= 0, "derivative %d", r);
    for (int q = 0; q <= r; q++, value += d + 1) {
        if (q > d) {
            memset(value, 0, ((size_t)d + 1) * sizeof *value);
            continue;
        }
        value[0] = 1;
        for (int p = 1; p <= d - q; p++)
            raise_degree(s->t, i, p, x, value);
        for (int p = d - q + 1; p <= d; p++)
            raise_derivative(s->t, i, p, 1, value);
    }
}

int kw_bspline_derivatives(const kw_bspline *s, double x, int r, double *value)
{
    int i = kw_bspline_span(s, x);

    kw_bspline_derivatives_on(s, i, x, r, value);
    return i - s->d;
}

void kw_bspline_pieces(const kw_bspline *s, int i, double *piece)
{
    int d = s->d;
    double value[KW_BSPLINE_DEGREE + 1], factorial = 1, h;

    need_span(s, i);
    h = s->t[i + 1] - s->t[i];
    for (int q = 0; q <= d; q++) {
        value[0] = 1;
        for (int p = 1; p <= d - q; p++)
            raise_degree(s->t, i, p, s->t[i], value);
        for (int p = d - q + 1; p <= d; p++)
            raise_derivative(s->t, i, p, h, value); /* with respect to u */
        for (int j = 0; j <= d; j++)
            piece[j * (d + 1) + q] = value[j] / factorial;
        factorial *= q + 1;
    }
}

void kw_bspline_blossom(const kw_bspline *s, int i, const double *u, double *value)
{
    need_span(s, i);
    value[0] = 1;
    for (int p = 1; p <= s->d; p++) {
        KW_NEED(isfinite(u[p - 1]), "u[%d] = %g", p - 1, u[p - 1]);
        raise_degree(s->t, i, p, u[p - 1], value);
    }
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
    double value[KW_BSPLINE_DEGREE + 1] = {0}; /* of the functions j, j+1, .. */
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

void kw_bspline_basis_many(const kw_bspline *s, int count, const double *x, int *first,
                           double *value)
{
    need_count(count);
    for (int i = 0; i < count; i++)
        first[i] = kw_bspline_basis(s, x[i], value + (size_t)i * (size_t)(s->d + 1));
}

void kw_bspline_derivatives_many(const kw_bspline *s, int count, const double *x, int r,
                                 int *first, double *value)
{
    size_t size = (size_t)(r + 1) * (size_t)(s->d + 1);

    need_count(count);
    for (int i = 0; i < count; i++)
        first[i] = kw_bspline_derivatives(s, x[i], r, value + (size_t)i * size);
}

void kw_bspline_one_many(const kw_bspline *s, int j, int r, int count, const double *x,
                         double *value)
{
    need_count(count);
    for (int i = 0; i < count; i++)
        value[i] = kw_bspline_one(s, j, r, x[i]);
}
