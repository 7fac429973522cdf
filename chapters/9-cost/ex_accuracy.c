/* Accuracy -- how far the library's values are from the exact ones.

   What to see: the errors are a few units of rounding, u = 2^-53 relative to the number or, where
   terms of both signs meet, to the sum of the absolute values of the terms; they stay far below
   the number of roundings.

   Book: section 1.1, Definitions 3 and 5, equations (9) and (11).
   Claims: cost.accuracy.*
   Chosen here: knots at whole numbers, inner ones of all multiplicities, points at eighths (of
   surfaces at halves), all knots and both ends among them, whole coefficients. So fractions fit,
   and differences of knots and points are exact. THB-splines on a line, refined towards its end. */

#include "../../tests/rational.h" /* exact fractions, and B-splines in them */
#include "claim.h"                /* what we found, for the ledger */
#include "curve.h"                /* curve points */
#include "line.h"                 /* THB-splines on a line, exactly too */
#include "need.h"                 /* memory */
#include "rng.h"                  /* coefficients */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    MOST = 4, /* degree */
    K = MOST + 1,
    ORDERS = 2, /* of derivatives */
    SPANS = 4,
    KNOTS = (SPANS + 1) * K,
    PARTS = 8,         /* points in [j, j+1) */
    SURFACE_PARTS = 2, /* the same for a surface */
    LINE_PARTS = 16,   /* and on the line */
    LARGEST = 999      /* coefficient */
};

/* What is computed: derivatives of order 0, 1, 2, and what is made of them. */
enum { BASIS, FIRST, SECOND, SUM, DEBOOR, SURFACE, THB, WORKS };

static const char *const WORK[WORKS] = {"basis",  "first",   "second", "sum",
                                        "deboor", "surface", "thb"};

/* --- in units of rounding --- */

static double whole(long long a)
{
    const long long exact = 1LL << 53;

    KW_NEED(-exact <= a && a <= exact, "%lld", a);
    return (double)a;
}

/* |got - want| over u size. The difference is that of got * q and p, rounded once: here a fused
   multiply-add is what one wants. */
static double roundings(double got, rational want, rational size)
{
    double off = fabs(fma(got, whole(want.q), -whole(want.p)));

    if (size.p == 0)
        return got == 0 ? 0 : INFINITY;
    return off / whole(want.q) / rational_double(size) * 0x1p53;
}

static void keep_most(double *most, double error)
{
    if (!(error <= *most)) /* NaN too */
        *most = error;
}

/* How many roundings lie between the data and the result, at most. A step of the recursion or of
   a derivative has a quotient, a product and a sum, a sum of k terms k products and k-1 sums. On a
   line a THB-spline is such a sum on its cell, and so is its coefficient after each level. */
static int bound(int work, int d)
{
    const int step = 3 * d, k = d + 1;
    const int count[WORKS] = {step,
                              step,
                              step,
                              step + k,
                              step,
                              2 * step + k * k + 1,
                              (LINE_TOP + 1) * (step + k)};

    return count[work];
}

/* --- B-splines, curves and surfaces --- */

typedef struct space {
    kw_bspline *s;
    rational t[KNOTS];
} space;

/* Inner knots of multiplicity m, 1, d+2-m; knots at the ends repeated or simple. */
static space new_space(int d, int m, int simple)
{
    static const double tau[SPANS + 1] = {0, 1, 4, 6, 7};
    const int mu[SPANS - 1] = {m, 1, d + 2 - m};
    space e = {.s = simple ? kw_bspline_new_periodic(d, SPANS, tau, mu)
                           : kw_bspline_new_open(d, SPANS, tau, mu)};

    KW_NEED(e.s->n + d + 1 <= KNOTS, "%d knots", e.s->n + d + 1);
    for (int i = 0; i <= e.s->n + d; i++)
        e.t[i] = (rational){(long long)e.s->t[i], 1};
    return e;
}

/* The r-th derivatives of the local functions at x, or with sign 1 the sums of the absolute
   values of their terms. */
static void exact_local(const space *e, int first, rational x, int r, int sign,
                        rational *value)
{
    int from_left = !rational_less(x, e->t[e->s->n]);

    for (int j = 0; j <= e->s->d; j++)
        value[j] = rational_terms(e->t + first + j, e->s->d, r, x, from_left, sign);
}

static void functions(const space *e, rational x, double *most)
{
    double value[(ORDERS + 1) * K];
    rational want[K] = {{0}}, size[K] = {{0}};
    int d = e->s->d, r = d < ORDERS ? d : ORDERS;
    int first = kw_bspline_derivatives(e->s, rational_double(x), r, value);

    for (int q = 0; q <= r; q++) {
        exact_local(e, first, x, q, -1, want);
        exact_local(e, first, x, q, 1, size);
        if (q == 0)
            kw_bspline_basis(e->s, rational_double(x), value);
        for (int j = 0; j <= d; j++)
            keep_most(&most[BASIS + q],
                      roundings(value[q * (d + 1) + j], want[j], size[j]));
    }
}

/* Gives the local functions at x one denominator, which is returned. */
static long long whole_local(const space *e, int first, rational x, long long *value)
{
    rational v[K] = {{0}};
    long long scale = 1;

    exact_local(e, first, x, 0, -1, v);
    for (int j = 0; j <= e->s->d; j++)
        scale = rational_product(scale, rational_new(v[j].q, scale).p);
    for (int j = 0; j <= e->s->d; j++)
        value[j] = rational_product(v[j].p, scale / v[j].q);
    return scale;
}

/* A sum and that of the absolute values of its terms, over `scale`. Weights add up to one, so
   neither is more than LARGEST. */
typedef struct total {
    long long sum, size, scale;
} total;

static void add(total *t, double coefficient, long long weight)
{
    long long term = rational_product((long long)coefficient, weight);

    t->sum += term;
    t->size += llabs(term);
}

static double roundings_of(double got, const total *t)
{
    rational_product(LARGEST, t->scale); /* fits */
    return roundings(got, rational_new(t->sum, t->scale),
                     rational_new(t->size, t->scale));
}

static void curve(const space *e, const double *c, rational x, double *most)
{
    double at = rational_double(x), point;
    int first = kw_bspline_span(e->s, at) - e->s->d;
    long long value[K] = {0};
    total want = {.scale = whole_local(e, first, x, value)};

    for (int j = 0; j <= e->s->d; j++)
        add(&want, c[first + j], value[j]);
    kw_curve_point(e->s, 1, c, at, &point);
    keep_most(&most[SUM], roundings_of(point, &want));
    kw_curve_deboor(e->s, 1, c, at, &point);
    keep_most(&most[DEBOOR], roundings_of(point, &want));
}

static void surface(const space *e, const kw_tensor *g, const double *c,
                    const rational *x, double *most)
{
    const double at[] = {rational_double(x[0]), rational_double(x[1])};
    long long value[2][K] = {{0}}, scale[2];
    int d = e->s->d, first[2];
    total want = {.sum = 0};
    double point;

    for (int h = 0; h < 2; h++) {
        first[h] = kw_bspline_span(e->s, at[h]) - d;
        scale[h] = whole_local(e, first[h], x[h], value[h]);
    }
    want.scale = rational_product(scale[0], scale[1]);
    for (int j = 0; j <= d; j++)
        for (int k = 0; k <= d; k++)
            add(&want, c[(first[0] + j) * e->s->n + first[1] + k],
                rational_product(value[0][j], value[1][k]));
    kw_tensor_point(g, 1, c, NULL, at, &point);
    keep_most(&most[SURFACE], roundings_of(point, &want));
}

static void over_points(const space *e, double *most)
{
    const kw_bspline *both[] = {e->s, e->s};
    kw_tensor *g = kw_tensor_new(2, both);
    double c[KNOTS * KNOTS] = {0};
    kw_rng r = kw_rng_at(97, 0, 0, 0);
    int length = (int)e->s->t[e->s->n];

    for (int i = 0; i < e->s->n * e->s->n; i++)
        c[i] = kw_rng_below(&r, 2 * LARGEST + 1) - LARGEST;
    for (int p = 0; p <= length * PARTS; p++) {
        functions(e, rational_new(p, PARTS), most);
        curve(e, c, rational_new(p, PARTS), most);
    }
    for (int p = 0; p <= length * SURFACE_PARTS; p++)
        for (int q = 0; q <= length * SURFACE_PARTS; q++) {
            const rational x[] = {rational_new(p, SURFACE_PARTS),
                                  rational_new(q, SURFACE_PARTS)};

            surface(e, g, c, x, most);
        }
    kw_tensor_free(g);
}

/* --- THB-splines --- */

static void truncated(int d, double *most)
{
    kw_hier *b = new_line(d);
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value);

    for (int p = 0; p <= LINE_CELLS * LINE_WIDTH * LINE_PARTS; p++) {
        const double x = (double)p / LINE_PARTS;
        int found = kw_hier_at(b, KW_THB, NULL, &x, index, value);

        for (int i = 0; i < found; i++) {
            rational want =
                exact_on_line(b->active, index[i], rational_new(p, LINE_PARTS));

            keep_most(&most[THB], roundings(value[i], want, want));
        }
    }
    free(index);
    free(value);
    kw_hier_free(b);
}

static double to_next_hundredth(double a)
{
    return ceil(100 * a) / 100;
}

static void report_error(kw_out *report, int work, int d, double most)
{
    char id[60];

    snprintf(id, sizeof id, "cost.accuracy.%s.%d", WORK[work], d);
    kw_claim_real(report, id, to_next_hundredth(most));
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_accuracy");
    double part = 0;

    for (int d = 1; d <= MOST; d++) {
        double most[WORKS] = {0};

        for (int m = 1; m <= d + 1; m++)
            for (int simple = 0; simple <= 1; simple++) {
                space e = new_space(d, m, simple);

                over_points(&e, most);
                kw_bspline_free(e.s);
            }
        truncated(d, most);
        for (int w = 0; w < WORKS; w++) {
            if (w == SECOND && d < ORDERS)
                continue; /* zero */
            report_error(report, w, d, most[w]);
            keep_most(&part, most[w] / bound(w, d));
        }
    }
    kw_claim_real(report, "cost.accuracy.part", to_next_hundredth(part));
    return kw_out_close(report);
}
