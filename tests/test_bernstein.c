/* Bernstein polynomials and de Casteljau's algorithm.

   Roundings: binomials up to degree 31 are exact, x^j has j, (1-x)^(d-j) has 2(d-j) with
   those of 1-x, the products 2: a value has at most 2d+2, one product, so the bound is
   relative, inside [0,1] and outside. */
#include "bernstein.h"
#include "rational.h"
#include "spline.h"

enum { SAMPLES = 300 };

static kw_rng sample_rng(uint64_t seed, int sample)
{
    return kw_rng_at(seed, 0, (uint64_t)sample, 0);
}

static rational power(rational x, int p)
{
    rational y = {1, 1};

    while (p-- > 0)
        y = rational_mul(y, x);
    return y;
}

static rational exact_bernstein(int d, int j, rational x)
{
    rational y =
        rational_mul(power(x, j), power(rational_sub((rational){1, 1}, x), d - j));

    for (int i = 1; i <= j; i++) /* times binomial(d, j) */
        y = rational_mul(y, rational_new(d - j + i, i));
    return y;
}

/* Points are eighths, in a double exact. */
static void exact_formula(void)
{
    double value[K + GUARD];

    for (int d = 0; d <= 12; d++)
        for (int p = -8; p <= 16; p++) {
            poison(value, d + 1);
            kw_bernstein_basis(d, p / 8.0, value);
            CHECK(written(value, d + 1), "d = %d, x = %d/8", d, p);
            for (int j = 0; j <= d; j++) {
                double want = rational_double(exact_bernstein(d, j, rational_new(p, 8)));

                CHECK(fabs(value[j] - want) <= bound(2 * d + 3, fabs(want)),
                      "d = %d, j = %d, x = %d/8: %.17g, %.17g", d, j, p, value[j], want);
            }
        }
}

static void unity(void)
{
    double value[K + GUARD];

    for (int sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = sample_rng(31, sample);
        int d = kw_rng_below(&r, K);
        double x = test_random_in(&r, -0.5, 1.5), sum = 0, size = 0;

        poison(value, d + 1);
        kw_bernstein_basis(d, x, value);
        CHECK(written(value, d + 1), "d = %d", d);
        for (int j = 0; j <= d; j++) {
            CHECK(value[j] >= 0 || x < 0 || x > 1, "d = %d, j = %d, x = %.17g", d, j, x);
            sum += value[j];
            size += fabs(value[j]);
        }
        CHECK(fabs(sum - 1) <= bound(3 * d + 2, size), "d = %d, x = %.17g: %.17g", d, x,
              sum);
    }
}

static void exact_ends(void)
{
    double value[K], c[2 * K], point[2];

    for (int d = 0; d < K; d++) {
        kw_rng r = sample_rng(32, d);

        for (int j = 0; j < 2 * (d + 1); j++)
            c[j] = test_random_in(&r, -9, 9);
        for (int end = 0; end <= 1; end++) {
            kw_bernstein_basis(d, end, value);
            for (int j = 0; j <= d; j++)
                CHECK(value[j] == (j == end * d), "d = %d, x = %d, j = %d: %g", d, end, j,
                      value[j]);
            kw_bernstein_casteljau(d, 2, c, end, point);
            CHECK(same_bits(point, c + 2 * d * end, 2), "d = %d, x = %d: %.17g", d, end,
                  point[0]);
        }
    }
}

/* b_j(x) = b_{d-j}(1-x); x is a multiple of 2^-20, so 1-x is exact. */
static void symmetry(void)
{
    double at[K], mirrored[K];

    for (int sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = sample_rng(33, sample);
        int d = kw_rng_below(&r, K);
        double x = kw_rng_below(&r, (1 << 20) + 1) / (double)(1 << 20);

        kw_bernstein_basis(d, x, at);
        kw_bernstein_basis(d, 1 - x, mirrored);
        for (int j = 0; j <= d; j++)
            CHECK(fabs(at[j] - mirrored[d - j]) <= bound(4 * d + 4, at[j]),
                  "d = %d, j = %d, x = %.17g", d, j, x);
    }
}

/* A step of de Casteljau has three roundings, and doubles no more than |1-x| + |x| what it
   averages; the sum of products has 2d+2 of the values and d+1. */
static void casteljau_is_the_sum(void)
{
    double value[K], c[3 * K] = {0}, point[3 + GUARD];

    for (int sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = sample_rng(34, sample);
        int d = kw_rng_below(&r, K), N = 1 + kw_rng_below(&r, 3);
        double x = test_random_in(&r, -0.25, 1.25), growth = 1;

        for (int j = 0; j < N * (d + 1); j++)
            c[j] = test_random_in(&r, -9, 9);
        for (int p = 0; p < d; p++)
            growth *= fabs(1 - x) + fabs(x);
        poison(point, N);
        kw_bernstein_casteljau(d, N, c, x, point);
        CHECK(written(point, N), "d = %d, N = %d", d, N);
        kw_bernstein_basis(d, x, value);
        for (int a = 0; a < N; a++) {
            double sum = 0, size = 0, largest = 0;

            for (int j = 0; j <= d; j++) {
                sum += value[j] * c[j * N + a];
                size += fabs(value[j] * c[j * N + a]);
                largest = fmax(largest, fabs(c[j * N + a]));
            }
            CHECK(fabs(point[a] - sum) <=
                      bound(3 * d, growth * largest) + bound(3 * d + 3, size),
                  "d = %d, x = %.17g: %.17g, %.17g", d, x, point[a], sum);
        }
    }
}

/* On open knots without an interior one: 2d+2 roundings here, 5d there. */
static void bernstein_is_bspline(void)
{
    const double tau[] = {0, 1};
    double value[K], local[K];

    for (int sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = sample_rng(35, sample);
        int d = kw_rng_below(&r, K);
        kw_bspline *s = kw_bspline_new_open(d, 1, tau, NULL);
        double x = test_random_point(&r, s);

        kw_bernstein_basis(d, x, value);
        CHECK(kw_bspline_basis(s, x, local) == 0 && s->n == d + 1, "n = %d", s->n);
        for (int j = 0; j <= d; j++)
            CHECK(fabs(value[j] - local[j]) <= bound(7 * d + 2, local[j]),
                  "d = %d, j = %d, x = %.17g: %.17g, %.17g", d, j, x, value[j], local[j]);
        kw_bspline_free(s);
    }
}

/* --- bad input --- */

static double scratch[K];

static void degree_below(void)
{
    kw_bernstein_basis(-1, 0.5, scratch);
}

static void degree_above(void)
{
    kw_bernstein_basis(K, 0.5, scratch);
}

static void basis_at_nan(void)
{
    kw_bernstein_basis(2, NAN, scratch);
}

static void casteljau_degree(void)
{
    kw_bernstein_casteljau(-3, 1, scratch, 0.5, scratch);
}

static void casteljau_at_infinity(void)
{
    kw_bernstein_casteljau(2, 1, scratch, HUGE_VAL, scratch);
}

static void casteljau_of_nothing(void)
{
    kw_bernstein_casteljau(2, 0, scratch, 0.5, scratch);
}

static void bad_input(void)
{
    test_aborts("degree -1,", degree_below);
    test_aborts("degree 32,", degree_above);
    test_aborts("x = nan", basis_at_nan);
    test_aborts("degree -3,", casteljau_degree);
    test_aborts("x = inf", casteljau_at_infinity);
    test_aborts("N = 0", casteljau_of_nothing);
}

int main(void)
{
    test_run("bernstein: the formula, against exact fractions", exact_formula);
    test_run("bernstein: positive on [0,1], and the sum is 1 everywhere", unity);
    test_run("bernstein: at 0 and 1 all is exact", exact_ends);
    test_run("bernstein: symmetric", symmetry);
    test_run("bernstein: de Casteljau gives the sum", casteljau_is_the_sum);
    test_run("bernstein: the B-splines on open knots without an interior one",
             bernstein_is_bspline);
    test_run("bernstein: bad input aborts and names the value", bad_input);
    return test_end();
}
