/* The functions of elementary.h against the 80-bit ones of libm, where long double has more
   bits than double (not under valgrind, and not on every system). */
#include "elementary.h"
#include "test.h"
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 20000 };

typedef double function(double x);
typedef long double reference(long double x);

/* The bounds in ulp that the header states; domain is the largest |x|. */
static const struct subject {
    const char *name;
    function *f;
    reference *exact;
    double ulp, domain;
} SUBJECTS[] = {
    {"exp", kw_exp, expl, 1.0, INFINITY},    {"expm1", kw_expm1, expm1l, 1.5, INFINITY},
    {"log", kw_log, logl, 0.9, INFINITY},    {"log1p", kw_log1p, log1pl, 0.9, INFINITY},
    {"tanh", kw_tanh, tanhl, 1.4, INFINITY}, {"erf", kw_erf, erfl, 2.0, INFINITY},
    {"erfc", kw_erfc, erfcl, 7, INFINITY},   {"sin", kw_sin, sinl, 0.8, 0x1p19},
    {"cos", kw_cos, cosl, 0.8, 0x1p19},
};
enum { COUNT = sizeof SUBJECTS / sizeof *SUBJECTS };

static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double from_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

static int same(double a, double b)
{
    return bits_of(a) == bits_of(b) || (isnan(a) && isnan(b));
}

/* Whether long double is more than double where this runs, not only where it was compiled. */
static int has_a_reference(void)
{
    volatile long double one = 1, small = 0x1p-60L;

    return LDBL_MANT_DIG >= 64 && one + small > one;
}

/* --- accuracy --- */

/* |y - exact| in units in the last place of exact; what overflows must be infinite, what has
   no value NaN. */
static double error(double y, long double exact)
{
    double near = fabs((double)exact);

    if (isnan(near))
        return isnan(y) ? 0 : INFINITY;
    if (isinf(near))
        return y == (double)exact ? 0 : INFINITY;
    return (double)(fabsl(y - exact) / (nextafter(near, INFINITY) - near));
}

static void check_one(const struct subject *s, double x)
{
    double y, e;

    if (!(fabs(x) <= s->domain) && !(isnan(x) && isinf(s->domain)))
        return;
    y = s->f(x);
    e = error(y, s->exact(x));
    CHECK(e <= s->ulp, "%s(%.17g) = %.17g is off by %g ulp", s->name, x, y, e);
}

static void accurate_where_it_is_used(void)
{
    const double ranges[][2] = {{-1, 1},   {-3, 3},      {0.4, 0.8},    {-0.001, 0.001},
                                {-30, 30}, {-746, -700}, {700, 711},    {0, 30},
                                {26, 28},  {0.99, 1.01}, {-1.01, -0.99}};
    kw_rng r = kw_rng_at(61, 0, 0, 0);

    for (size_t i = 0; i < sizeof ranges / sizeof *ranges && has_a_reference(); i++)
        for (int f = 0; f < COUNT; f++)
            for (int p = 0; p < POINTS; p++)
                check_one(&SUBJECTS[f], test_random_in(&r, ranges[i][0], ranges[i][1]));
}

/* All exponents alike: subnormal numbers, numbers that overflow, infinities, NaNs. */
static void accurate_over_the_whole_range(void)
{
    kw_rng r = kw_rng_at(62, 0, 0, 0);

    for (int f = 0; f < COUNT && has_a_reference(); f++)
        for (int p = 0; p < 10 * POINTS; p++)
            check_one(&SUBJECTS[f], from_bits(kw_rng_word(&r)));
}

/* Close to n pi/2, where nearly all digits of the angle cancel. */
static void accurate_at_multiples_of_a_right_angle(void)
{
    const long double right = 1.57079632679489661923132169163975144L;

    for (int n = -300000; n <= 300000 && has_a_reference(); n += 7) {
        double x = (double)(n * right);

        check_one(&SUBJECTS[7], x);
        check_one(&SUBJECTS[8], x);
    }
}

static void the_yardstick_measures(void)
{
    CHECK(error(1, 1) == 0, "%g", error(1, 1));
    CHECK(error(1 + DBL_EPSILON, 1) == 1, "%g", error(1 + DBL_EPSILON, 1));
    CHECK(error(0x1p-1074, 0x1p-1073L) == 1, "%g", error(0x1p-1074, 0x1p-1073L));
    CHECK(error(1, NAN) == INFINITY && error(NAN, NAN) == 0, "NaN");
    CHECK(isnan(error(NAN, 1)) && !(error(NAN, 1) <= 1), "%g", error(NAN, 1));
    CHECK(error(1, INFINITY) == INFINITY, "%g", error(1, INFINITY));
    CHECK(error(-INFINITY, INFINITY) == INFINITY, "%g", error(-INFINITY, INFINITY));
}

/* --- exact values --- */

static void special_values(void)
{
    const struct {
        function *f;
        double x, y;
    } known[] = {
        {kw_exp, 0.0, 1},
        {kw_exp, -0.0, 1},
        {kw_exp, INFINITY, INFINITY},
        {kw_exp, -INFINITY, 0},
        {kw_exp, 710, INFINITY},
        {kw_exp, -746, 0},
        {kw_exp, 1e300, INFINITY},
        {kw_exp, -1e300, 0},
        {kw_exp, -745, 0x1p-1074},
        {kw_expm1, 0.0, 0},
        {kw_expm1, -0.0, -0.0},
        {kw_expm1, -INFINITY, -1},
        {kw_expm1, 710, INFINITY},
        {kw_expm1, -50, -1},
        {kw_expm1, 5e-324, 5e-324},
        {kw_log, 1, 0},
        {kw_log, 0.0, -INFINITY},
        {kw_log, -0.0, -INFINITY},
        {kw_log, -1, NAN},
        {kw_log, INFINITY, INFINITY},
        {kw_log, -INFINITY, NAN},
        {kw_log1p, 0.0, 0},
        {kw_log1p, -0.0, -0.0},
        {kw_log1p, -1, -INFINITY},
        {kw_log1p, -1.5, NAN},
        {kw_log1p, INFINITY, INFINITY},
        {kw_log1p, 5e-324, 5e-324},
        {kw_tanh, 0.0, 0},
        {kw_tanh, -0.0, -0.0},
        {kw_tanh, INFINITY, 1},
        {kw_tanh, -INFINITY, -1},
        {kw_tanh, 20, 1},
        {kw_tanh, -5e-324, -5e-324},
        {kw_erf, 0.0, 0},
        {kw_erf, -0.0, -0.0},
        {kw_erf, INFINITY, 1},
        {kw_erf, -INFINITY, -1},
        {kw_erf, 7, 1},
        {kw_erfc, 0.0, 1},
        {kw_erfc, INFINITY, 0},
        {kw_erfc, -INFINITY, 2},
        {kw_erfc, 28, 0},
        {kw_erfc, -7, 2},
        {kw_sin, 0.0, 0},
        {kw_sin, -0.0, -0.0},
        {kw_sin, 5e-324, 5e-324},
        {kw_cos, 0.0, 1},
        {kw_cos, -0.0, 1},
    };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double y = known[i].f(known[i].x);

        CHECK(same(y, known[i].y), "line %zu: at %g it is %g, not %g", i, known[i].x, y,
              known[i].y);
    }
}

static void nan_gives_nan(void)
{
    for (int f = 0; f < COUNT; f++)
        if (isinf(SUBJECTS[f].domain))
            CHECK(isnan(SUBJECTS[f].f(NAN)) && isnan(SUBJECTS[f].f(-NAN)), "%s",
                  SUBJECTS[f].name);
}

static void odd_and_even_functions(void)
{
    kw_rng r = kw_rng_at(63, 0, 0, 0);

    for (int p = 0; p < POINTS; p++) {
        double x = test_random_in(&r, 0, 1) * (double)(1 << kw_rng_below(&r, 16));

        CHECK(same(kw_tanh(-x), -kw_tanh(x)), "tanh at %.17g", x);
        CHECK(same(kw_erf(-x), -kw_erf(x)), "erf at %.17g", x);
        CHECK(same(kw_sin(-x), -kw_sin(x)), "sin at %.17g", x);
        CHECK(same(kw_cos(-x), kw_cos(x)), "cos at %.17g", x);
    }
}

/* --- the same bits --- */

static void many_are_as_one_by_one(void)
{
    enum { MOST = 70 };
    kw_rng r = kw_rng_at(64, 0, 0, 0);
    double x[MOST + 1], y[MOST + 1];

    for (int n = 0; n <= MOST; n++) {
        for (int i = 0; i <= n; i++)
            x[i] = i % 3 ? test_random_in(&r, -25, 25) : from_bits(kw_rng_word(&r));
        y[n] = 17;
        kw_exp_many(n, x, y);
        for (int i = 0; i < n; i++)
            CHECK(same(y[i], kw_exp(x[i])), "exp, number %d of %d, %g", i, n, x[i]);
        kw_tanh_many(n, x, y);
        for (int i = 0; i < n; i++)
            CHECK(same(y[i], kw_tanh(x[i])), "tanh, number %d of %d, %g", i, n, x[i]);
        CHECK(y[n] == 17, "n = %d: %g behind the end", n, y[n]);
    }
}

/* [Fowler, Noll, Vo: FNV-1a] of the results at points that are exact. Any other number means
   that this build makes other data than the one that was looked at. */
static void every_build_has_the_same_bits(void)
{
    const uint64_t known[COUNT] = {
        0xfc87273154f80572, 0x0c3e75a2dc6eeac6, 0x0cfbbe77065efb13,
        0xea7562b7440c30f6, 0x2ebcfe538a6fb863, 0x94c5255f3e40de3a,
        0xb3ce547d74a8e0dc, 0x6ef50790a160d743, 0x071a3204aa60733b};

    for (int f = 0; f < COUNT; f++) {
        kw_rng r = kw_rng_at(65, 0, (uint64_t)f, 0);
        uint64_t hash = 0xcbf29ce484222325;

        for (int p = 0; p < POINTS; p++) {
            double x = test_random_in(&r, -32, 32);

            hash = (hash ^ bits_of(SUBJECTS[f].f(p % 2 ? x : x * x))) * 0x100000001b3;
        }
        CHECK(hash == known[f], "%s: %016" PRIx64, SUBJECTS[f].name, hash);
    }
}

/* --- misuse --- */

static void large_angle(void)
{
    kw_sin(524289);
}

static void infinite_angle(void)
{
    kw_cos(-INFINITY);
}

static void no_angle(void)
{
    kw_sin(NAN);
}

static void angles_are_limited(void)
{
    test_aborts("angle 524289, not in -2^19 .. 2^19", large_angle);
    test_aborts("angle -inf", infinite_angle);
    test_aborts("angle nan", no_angle);
}

int main(void)
{
    if (!has_a_reference())
        printf("# long double is no wider than double here: accuracy is not measured\n");
    test_run("elementary: the yardstick measures", the_yardstick_measures);
    test_run("elementary: accurate where it is used", accurate_where_it_is_used);
    test_run("elementary: accurate over the whole range", accurate_over_the_whole_range);
    test_run("elementary: accurate at multiples of a right angle",
             accurate_at_multiples_of_a_right_angle);
    test_run("elementary: zeros, ones, infinities", special_values);
    test_run("elementary: a NaN gives a NaN", nan_gives_nan);
    test_run("elementary: odd and even functions, bit by bit", odd_and_even_functions);
    test_run("elementary: many numbers are as one by one", many_are_as_one_by_one);
    test_run("elementary: every build has the same bits", every_build_has_the_same_bits);
    test_run("elementary: angles are limited", angles_are_limited);
    return test_end();
}
