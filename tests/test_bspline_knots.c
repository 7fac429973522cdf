/* Knots, Greville points, the constructors, many points at once, the extreme degrees. */
#include "spline.h"
#include <string.h>

/* --- knots --- */

static void first_span(const kw_bspline *s, kw_rng *r)
{
    (void)r;
    for (int j = 0; j < s->n; j++) {
        int first = s->d; /* the first span i with i-d <= j <= i */

        while (s->t[first] == s->t[first + 1] || j > first)
            first++;
        CHECK(kw_bspline_first_span(s, j) == first, "function %d: %d, not %d", j,
              kw_bspline_first_span(s, j), first);
        CHECK(first - s->d <= j && first < s->n, "function %d: span %d", j, first);
        CHECK(kw_bspline_one(s, j, 0, s->t[first] + (s->t[first + 1] - s->t[first]) / 2) >
                  0,
              "function %d is zero on span %d", j, first);
    }
}

static void random_partition(kw_rng *r, int d, int L, double *tau, int *mu)
{
    tau[0] = random_dyadic(r);
    for (int i = 1; i <= L; i++) {
        tau[i] = tau[i - 1] + (1 + kw_rng_below(r, 200)) / 64.0;
        mu[i - 1] = 1 + kw_rng_below(r, d + 1);
    }
}

static void multiplicity(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(21, 0, (uint64_t)sample, 0);
        int d = kw_rng_below(&r, 8), L = 1 + kw_rng_below(&r, 6), mu[6];
        double tau[7];
        kw_bspline *s;

        random_partition(&r, d, L, tau, mu);
        s = kw_bspline_new_open(d, L, tau, mu);
        for (int i = 0; i <= L; i++) {
            int want = i == 0 || i == L ? d + 1 : mu[i - 1];

            CHECK(kw_bspline_multiplicity(s, tau[i]) == want, "tau[%d]: %d, not %d", i,
                  kw_bspline_multiplicity(s, tau[i]), want);
            CHECK(kw_bspline_multiplicity(s, nextafter(tau[i], 100)) == 0, "tau[%d]", i);
            CHECK(kw_bspline_multiplicity(s, nextafter(tau[i], -100)) == 0, "tau[%d]", i);
        }
        kw_bspline_free(s);
    }
}

/* The sum of g_j beta_j(x) is x. With M the largest |t| a Greville point has d roundings of
   at most M, a function 5d, the sum of products d+1. */
static void greville_identity(const kw_bspline *s, kw_rng *r)
{
    double value[K];
    int d = s->d;

    for (int point = 0; point < 10 && d > 0; point++) {
        double x = test_random_point(r, s), sum = 0, largest = 0;
        int first = kw_bspline_basis(s, x, value);

        for (int j = 0; j <= d; j++) {
            for (int i = 0; i <= d + 1; i++)
                largest = fmax(largest, fabs(s->t[first + j + i]));
            sum += kw_bspline_greville(s, first + j) * value[j];
        }
        CHECK(fabs(sum - x) <= bound(7 * d + 1, largest), "d = %d: %.17g, %.17g", d, sum,
              x);
    }
}

static void greville_place(const kw_bspline *s, kw_rng *r)
{
    int d = s->d, n = s->n;
    double a = s->t[d], b = s->t[n], before = -HUGE_VAL;

    (void)r;
    for (int j = 0; j < n; j++) {
        double g = kw_bspline_greville(s, j);

        CHECK(s->t[j] <= g && g <= s->t[j + d + 1], "function %d: %.17g", j, g);
        CHECK(before <= g, "function %d: %.17g behind %.17g", j, g, before);
        /* the middle has four roundings of at most |a| + |b| */
        CHECK(d > 0 ||
                  fabs(g - (s->t[j] + s->t[j + 1]) / 2) <= bound(4, fabs(a) + fabs(b)),
              "middle %d: %.17g", j, g);
        before = g;
        if (s->t[0] < a || b < s->t[n + d])
            continue;
        CHECK(a <= g && g <= b, "function %d: %.17g outside the domain", j, g);
        CHECK(d == 0 || j > 0 || g == a, "%.17g is not the left end %.17g", g, a);
        CHECK(d == 0 || j < n - 1 || g == b, "%.17g is not the right end %.17g", g, b);
    }
}

/* --- constructors --- */

static void open_spaces(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(22, 0, (uint64_t)sample, 0);
        int d = kw_rng_below(&r, 8), L = 1 + kw_rng_below(&r, 6), mu[6], last = 0;
        int simple = kw_rng_below(&r, 2);
        double tau[7];
        kw_bspline *s;

        random_partition(&r, d, L, tau, mu);
        s = kw_bspline_new_open(d, L, tau, simple ? NULL : mu);
        for (int i = 0; i <= L; i++) {
            int copies = i == 0 || i == L ? d + 1 : simple ? 1 : mu[i - 1];

            while (copies-- > 0 && last <= s->n + s->d) {
                CHECK(s->t[last] == tau[i], "t[%d] = %.17g", last, s->t[last]);
                last++;
            }
        }
        CHECK(s->d == d && last == s->n + d + 1, "%d knots, n = %d, d = %d", last, s->n,
              d);
        kw_bspline_free(s);
    }
}

/* A knot a + (b-a) i / cells has four roundings; largest bounds all its terms. */
static void check_equal_cells(const kw_bspline *s, int cells, double a, double b)
{
    double h = (b - a) / cells, largest = fabs(a) + (b - a) * (1 + 2.0 * s->d);

    CHECK(s->n == cells + s->d, "n = %d, d = %d, %d cells", s->n, s->d, cells);
    CHECK(s->t[s->d] == a && s->t[s->n] == b, "[%.17g, %.17g]", s->t[s->d], s->t[s->n]);
    for (int i = s->d; i <= s->n; i++)
        CHECK(fabs(s->t[i] - (a + (i - s->d) * h)) <= bound(8, largest), "t[%d] = %.17g",
              i, s->t[i]);
}

static void uniform_spaces(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(23, 0, (uint64_t)sample, 0);
        int d = kw_rng_below(&r, K), cells = 1 + kw_rng_below(&r, 20);
        double a = test_random_in(&r, -5, 5), b = a + test_random_in(&r, 0.01, 9);
        double largest = fabs(a) + (b - a) * (1 + 2.0 * d);
        kw_bspline *s = kw_bspline_new_open_uniform(d, cells, a, b);

        check_equal_cells(s, cells, a, b);
        for (int i = 0; i <= d; i++)
            CHECK(s->t[i] == a && s->t[s->n + i] == b, "not open: t[%d] = %.17g", i,
                  s->t[i]);
        kw_bspline_free(s);
        s = kw_bspline_new_uniform(d, cells, a, b);
        check_equal_cells(s, cells, a, b);
        for (int i = 0; i < s->n + d; i++)
            CHECK(fabs(s->t[i + 1] - s->t[i] - (b - a) / cells) <= bound(12, 2 * largest),
                  "t[%d] = %.17g, t[%d] = %.17g", i, s->t[i], i + 1, s->t[i + 1]);
        kw_bspline_free(s);
    }
}

/* Where spans are equal, however many, the span of a point is one of two: the knot between them
   lies in the middle of its bucket, and no rounding moves it out. */
static void two_candidates(void)
{
    for (int cells = 1; cells <= 1000; cells++) {
        kw_bspline *s = kw_bspline_new_open_uniform(3, cells, -0.3, 1.7);
        kw_bspline *whole = kw_bspline_new_uniform(3, cells, 0, cells);
        int want = cells > 1 ? 2 : 1;

        CHECK(s->candidates == want && whole->candidates == want,
              "%d cells: %d and %d candidates", cells, s->candidates, whole->candidates);
        kw_bspline_free(s);
        kw_bspline_free(whole);
    }
}

/* Knots are whole numbers and points multiples of 1/64, so all differences are exact, and
   the shifted function goes through the same operations: the same bits. */
static void uniform_shifts(void)
{
    for (int d = 0; d <= 8; d++)
        for (int cells = 1; cells <= 6; cells++) {
            kw_bspline *s = kw_bspline_new_uniform(d, cells, -2, -2 + cells);

            for (int p = 1; p < 64 * (d + 1); p += 6)
                for (int j = 1; j < s->n; j++)
                    for (int q = 0; q <= d; q++) {
                        double x = s->t[0] + p / 64.0;
                        double first = kw_bspline_one(s, 0, q, x);
                        double other = kw_bspline_one(s, j, q, x + j);

                        CHECK(first == other, "d = %d, function %d at %g: %.17g, %.17g",
                              d, j, x, first, other);
                    }
            kw_bspline_free(s);
        }
}

/* The partition is dyadic, so shifts by the period are exact. */
static void periodic_spaces(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(24, 0, (uint64_t)sample, 0);
        int d = kw_rng_below(&r, 12), L = 1 + kw_rng_below(&r, 4), mu[4], period = 1;
        int simple = kw_rng_below(&r, 2), last = d;
        double tau[5];
        kw_bspline *s;

        random_partition(&r, d, L, tau, mu);
        s = kw_bspline_new_periodic(d, L, tau, simple ? NULL : mu);
        for (int i = 1; i < L; i++)
            period += simple ? 1 : mu[i - 1];
        CHECK(s->d == d && s->n == d + period, "n = %d, d = %d, period %d", s->n, d,
              period);
        for (int i = 0; i <= L; i++) {
            int copies = i == 0 || i == L || simple ? 1 : mu[i - 1];

            for (; copies > 0 && last <= s->n; copies--, last++)
                CHECK(s->t[last] == tau[i], "t[%d] = %.17g", last, s->t[last]);
        }
        for (int i = 0; i + period <= s->n + d; i++)
            CHECK(s->t[i + period] - s->t[i] == tau[L] - tau[0], "t[%d] = %.17g", i,
                  s->t[i]);
        kw_bspline_free(s);
    }
}

static void copy_alone(const kw_bspline *s, kw_rng *r)
{
    size_t bytes = (size_t)(s->n + s->d + 1) * sizeof *s->t;
    kw_bspline *first = kw_bspline_new_copy(s), *second = kw_bspline_new_copy(first);

    (void)r;
    CHECK(first->t != s->t && second->t != first->t, "knots are shared");
    for (int i = 0; i <= s->n + s->d; i++)
        first->t[i] = 0;
    kw_bspline_free(first);
    CHECK(second->d == s->d && second->n == s->n, "d = %d, n = %d", second->d, second->n);
    CHECK(memcmp(second->t, s->t, bytes) == 0, "other knots");
    kw_bspline_free(second);
    kw_bspline_free(NULL);
}

/* One order of the derivatives alone, up to two beyond the degree. */
static void one_order_alone(const kw_bspline *s, kw_rng *r)
{
    double x = test_random_point(r, s), all[ROOM], alone[KW_BSPLINE_DEGREE + 1 + GUARD];
    int k = s->d + 1, span = kw_bspline_span(s, x);

    kw_bspline_derivatives_on(s, span, x, k + 1, all);
    for (int order = 0; order <= k + 1; order++) {
        poison(alone, k);
        kw_bspline_derivative_on(s, span, x, order, alone);
        CHECK(written(alone, k) && same_bits(alone, all + order * k, k),
              "d = %d, order %d, x = %.17g", s->d, order, x);
    }
}

/* --- many points --- */

enum { POINTS = 7, UNTOUCHED = -77 };

static void many_points(const kw_bspline *s, kw_rng *r)
{
    double x[POINTS], value[POINTS * ROOM], one[ROOM];
    int first[POINTS + 1], k = s->d + 1, order = kw_rng_below(r, k + 2);
    int size = k * (order + 1);

    first[POINTS] = UNTOUCHED;
    for (int i = 0; i < POINTS; i++)
        x[i] = test_random_point(r, s);
    poison(value, POINTS * k);
    kw_bspline_basis_many(s, POINTS, x, first, value);
    CHECK(written(value, POINTS * k) && first[POINTS] == UNTOUCHED, "d = %d", s->d);
    for (int i = 0; i < POINTS; i++) {
        CHECK(first[i] == kw_bspline_basis(s, x[i], one), "first = %d", first[i]);
        CHECK(same_bits(one, value + i * k, k), "d = %d, x = %.17g", s->d, x[i]);
    }
    poison(value, POINTS * size);
    kw_bspline_derivatives_many(s, POINTS, x, order, first, value);
    CHECK(written(value, POINTS * size) && first[POINTS] == UNTOUCHED, "d = %d", s->d);
    for (int i = 0; i < POINTS; i++) {
        CHECK(first[i] == kw_bspline_derivatives(s, x[i], order, one), "%d", first[i]);
        CHECK(same_bits(one, value + i * size, size), "d = %d, x = %.17g", s->d, x[i]);
    }
}

/* More points than are taken at a time, odd and even counts. */
static void longer_than_a_batch(const kw_bspline *s, kw_rng *r)
{
    enum { FEWEST = 60, MOST = 140 };
    static double value[MOST * 2 * K + GUARD];
    double x[MOST], one[ROOM];
    int first[MOST], span[MOST + 1], count = FEWEST + kw_rng_below(r, MOST - FEWEST + 1);
    int order = kw_rng_below(r, 2), size = (order + 1) * (s->d + 1);

    for (int i = 0; i < count; i++)
        x[i] = i % 10 ? test_random_point(r, s) : s->t[s->n];
    span[count] = UNTOUCHED;
    kw_bspline_span_many(s, count, x, span);
    CHECK(span[count] == UNTOUCHED, "%d points", count);
    poison(value, count * size);
    kw_bspline_derivatives_many(s, count, x, order, first, value);
    CHECK(written(value, count * size), "%d points, d = %d", count, s->d);
    for (int i = 0; i < count; i++) {
        CHECK(span[i] == kw_bspline_span(s, x[i]), "point %d of %d: %d", i, count,
              span[i]);
        CHECK(first[i] == span[i] - s->d, "point %d of %d: %d", i, count, first[i]);
        kw_bspline_derivatives(s, x[i], order, one);
        CHECK(same_bits(one, value + i * size, size), "point %d of %d, d = %d", i, count,
              s->d);
    }
}

static void no_points(const kw_bspline *s, kw_rng *r)
{
    double value[GUARD];
    int first = UNTOUCHED;

    (void)r;
    poison(value, 0);
    kw_bspline_span_many(s, 0, value, &first);
    kw_bspline_basis_many(s, 0, value, &first, value);
    kw_bspline_derivatives_many(s, 0, value, 2, &first, value);
    CHECK(written(value, 0) && first == UNTOUCHED, "first = %d", first);
}

/* --- extreme degrees --- */

static void degree_0(void)
{
    const double tau[] = {-1, 0, 0.5, 3}, point[] = {-1, -0.5, 0, 0.25, 0.5, 1, 3};
    const int span[] = {0, 0, 1, 1, 2, 2, 2};
    kw_bspline *s = kw_bspline_new_open(0, 3, tau, NULL);
    double value[2 + GUARD];

    CHECK(s->n == 3, "n = %d", s->n);
    for (int p = 0; p < 7; p++) {
        poison(value, 2);
        CHECK(kw_bspline_derivatives(s, point[p], 1, value) == span[p], "%g", point[p]);
        CHECK(written(value, 2) && value[0] == 1 && value[1] == 0, "%g, %g", value[0],
              value[1]);
        for (int j = 0; j < 3; j++)
            CHECK(kw_bspline_one(s, j, 0, point[p]) == (j == span[p]), "%d at %g", j,
                  point[p]);
    }
    kw_bspline_free(s);
}

/* One cell of [0,2] with degree 31: the last function is (x/2)^31, so its derivative of
   order q is 31!/(31-q)! x^(31-q) / 2^31; at x = 1 all powers are exact, and the product
   has at most 31 roundings. */
static void degree_31(void)
{
    const double tau[] = {0, 2};
    const int d = KW_BSPLINE_DEGREE;
    kw_bspline *s = kw_bspline_new_open(d, 1, tau, NULL);
    double value[ROOM], size[K] = {0}, want = ldexp(1, -d);

    CHECK(s->n == K, "n = %d", s->n);
    poison(value, (K + 1) * K);
    kw_bspline_derivatives(s, 1, d + 1, value);
    CHECK(written(value, (K + 1) * K), "d = %d", d);
    for (int q = 0; q <= d + 1; q++) {
        derivative_size(s, d, 1, q, size);
        CHECK(fabs(value[q * K + d] - want) <= bound(6 * d, size[d]),
              "derivative %d: %.17g, %.17g", q, value[q * K + d], want);
        want *= d - q; /* 0 at last */
    }
    kw_bspline_free(s);
}

int main(void)
{
    const int all = KW_BSPLINE_DEGREE;

    run_over_spaces("bspline: the first span of a function", all, first_span);
    test_run("bspline: a multiplicity counts equal knots and no others", multiplicity);
    run_over_spaces("bspline: Greville points reproduce the identity", all,
                    greville_identity);
    run_over_spaces("bspline: Greville points ascend, from end to end of open knots", all,
                    greville_place);
    test_run("bspline: open spaces repeat the partition", open_spaces);
    test_run("bspline: uniform spaces have equal cells and exact ends", uniform_spaces);
    test_run("bspline: of equal spans two are looked at", two_candidates);
    test_run("bspline: uniform functions are shifts of one another", uniform_shifts);
    test_run("bspline: periodic spaces repeat their knots, and beyond d",
             periodic_spaces);
    run_over_spaces("bspline: a copy stands alone", all, copy_alone);
    run_over_spaces("bspline: one order of the derivatives alone", 8, one_order_alone);
    run_over_spaces("bspline: many points are points one by one, bit for bit", 8,
                    many_points);
    run_over_spaces("bspline: so at degrees up to 31", all, many_points);
    run_over_spaces("bspline: so are more points than are taken at a time", all,
                    longer_than_a_batch);
    run_over_spaces("bspline: no points, nothing written", 6, no_points);
    test_run("bspline: degree 0 is the indicator of each span", degree_0);
    test_run("bspline: degree 31 on one cell", degree_31);
    return test_end();
}
