#include "activation.h"
#include "test.h"
#include <math.h>
#include <string.h>

static const double u = 0x1p-53; /* half a unit in the last place of 1 */

static kw_activation_kind kind_at(int i)
{
    return (kw_activation_kind)i;
}

/* The formulas of the header with the functions of libm. */
static double formula(kw_activation_kind kind, double z)
{
    switch (kind) {
    case KW_SIGN:
        return z >= 0 ? 1 : -1;
    case KW_STEP:
        return z >= 0 ? 1 : 0;
    case KW_LOGISTIC:
        return 1 / (1 + exp(-z));
    case KW_TANH:
        return tanh(z);
    case KW_RELU:
        return fmax(0, z);
    case KW_LEAKY_RELU:
        return fmax(0.01 * z, z);
    case KW_ELU:
        return z > 0 ? z : expm1(z);
    case KW_SOFTPLUS:
        return z > 30 ? z + exp(-z) : log1p(exp(z));
    case KW_GELU:
        return z * erfc(-z / sqrt(2)) / 2;
    case KW_SILU:
        return z / (1 + exp(-z));
    default:
        return z;
    }
}

/* Each side takes at most six functions and operations, with errors of at most 6 ulp (erfc) and
   else of one or two, on factors that are not larger than the result: 20 ulp. An error of the
   argument, half an ulp twice, counts up to z^2 times in Phi and |z| times in e^z. */
static void values_are_those_of_the_formulas(void)
{
    for (int i = 0; i < KW_ACTIVATION_KINDS; i++)
        for (int step = -1280; step <= 1280; step++) {
            double z = step / 64.0;
            double y = kw_activation_value(kind_at(i), z), other = formula(kind_at(i), z);

            CHECK(fabs(y - other) <= (40 + 2 * z * z) * 2 * u * fabs(other),
                  "%s(%g) = %.17g, not %.17g", kw_activation_name(kind_at(i)), z, y,
                  other);
        }
}

static void known_values(void)
{
    const struct {
        kw_activation_kind kind;
        double z, y;
    } known[] = {
        {KW_IDENTITY, -3.5, -3.5},
        {KW_SIGN, 0.0, 1},
        {KW_SIGN, -0.0, 1},
        {KW_SIGN, -5e-324, -1},
        {KW_SIGN, 5e-324, 1},
        {KW_STEP, 0.0, 1},
        {KW_STEP, -0.0, 1},
        {KW_STEP, -5e-324, 0},
        {KW_LOGISTIC, 0, 0.5},
        {KW_LOGISTIC, 800, 1},
        {KW_LOGISTIC, -800, 0},
        {KW_TANH, 0, 0},
        {KW_TANH, 800, 1},
        {KW_RELU, -2, 0},
        {KW_RELU, 0, 0},
        {KW_RELU, 2, 2},
        {KW_LEAKY_RELU, -2, -0.02},
        {KW_LEAKY_RELU, 2, 2},
        {KW_ELU, 2, 2},
        {KW_ELU, 0, 0},
        {KW_ELU, -800, -1},
        {KW_SOFTPLUS, 800, 800},
        {KW_SOFTPLUS, -800, 0},
        {KW_GELU, 0, 0},
        {KW_GELU, 40, 40},
        {KW_GELU, -40, 0},
        {KW_SILU, 0, 0},
        {KW_SILU, 800, 800},
        {KW_SILU, -800, 0},
    };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double y = kw_activation_value(known[i].kind, known[i].z);

        CHECK(y == known[i].y, "%s(%g) = %.17g", kw_activation_name(known[i].kind),
              known[i].z, y);
    }
}

/* Far out, where 1 + exp would lose them. */
static void small_values_keep_their_digits(void)
{
    double e = exp(-700);

    CHECK(fabs(kw_activation_value(KW_LOGISTIC, -700) / e - 1) <= 8 * u, "logistic");
    CHECK(fabs(kw_activation_value(KW_SOFTPLUS, -700) / e - 1) <= 8 * u, "softplus");
    CHECK(fabs(kw_activation_value(KW_SILU, -700) / (-700 * e) - 1) <= 8 * u, "SiLU");
    CHECK(fabs(kw_activation_value(KW_ELU, -1e-20) / -1e-20 - 1) <= 8 * u, "ELU");
}

/* Central differences with the step h are off by h^2/6 times a third derivative, here below 2,
   and by an error of the value, at most 8 ulp of a number below 8, over h. With h = 2^-17
   both are below 1e-9. Kinks and jumps are at 0 and not met. */
static void derivatives_are_limits_of_differences(void)
{
    const double h = 0x1p-17;

    for (int i = 0; i < KW_ACTIVATION_KINDS; i++)
        for (int step = -768; step < 768; step++) {
            double z = (step + 0.5) / 128;
            double d = kw_activation_derivative(kind_at(i), z);
            double ahead = kw_activation_value(kind_at(i), z + h);
            double behind = kw_activation_value(kind_at(i), z - h);

            CHECK(fabs(d - (ahead - behind) / (2 * h)) <= 1e-9, "%s' (%g) = %.17g",
                  kw_activation_name(kind_at(i)), z, d);
        }
}

static void derivatives_at_zero_are_from_the_left(void)
{
    const double left[KW_ACTIVATION_KINDS] = {1,    0, 0,   0.25, 1,  0,
                                              0.01, 1, 0.5, 0.5,  0.5};

    for (int i = 0; i < KW_ACTIVATION_KINDS; i++)
        for (int sign = 0; sign < 2; sign++) {
            double d = kw_activation_derivative(kind_at(i), sign ? -0.0 : 0.0);

            CHECK(d == left[i], "%s'(0) = %.17g", kw_activation_name(kind_at(i)), d);
        }
}

static void derivatives_far_out(void)
{
    const double right[KW_ACTIVATION_KINDS] = {1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    const double left[KW_ACTIVATION_KINDS] = {1, 0, 0, 0, 0, 0, 0.01, 0, 0, 0, 0};

    for (int i = 0; i < KW_ACTIVATION_KINDS; i++) {
        double d = kw_activation_derivative(kind_at(i), 800);
        double e = kw_activation_derivative(kind_at(i), -800);

        CHECK(d == right[i], "%s' at 800: %g", kw_activation_name(kind_at(i)), d);
        CHECK(fabs(e - left[i]) <= 1e-300, "%s' at -800: %g",
              kw_activation_name(kind_at(i)), e);
    }
}

static void nan_gives_nan(void)
{
    for (int i = 0; i < KW_ACTIVATION_KINDS; i++) {
        double y = kw_activation_value(kind_at(i), NAN), z = NAN;

        CHECK(isnan(y), "%s(NaN) = %g", kw_activation_name(kind_at(i)), y);
        kw_activation_many(kind_at(i), 1, &z, &y);
        CHECK(isnan(y), "%s(NaN) = %g", kw_activation_name(kind_at(i)), y);
    }
}

/* Made of constant pieces, a derivative is that of the left piece. */
static void nan_has_the_derivative_that_is_promised(void)
{
    for (int i = 0; i < KW_ACTIVATION_KINDS; i++) {
        double d = kw_activation_derivative(kind_at(i), NAN);

        switch (kind_at(i)) {
        case KW_IDENTITY:
        case KW_SIGN:
        case KW_STEP:
        case KW_RELU:
        case KW_LEAKY_RELU:
            CHECK(d == kw_activation_derivative(kind_at(i), -1), "%s'(NaN) = %g",
                  kw_activation_name(kind_at(i)), d);
            break;
        default:
            CHECK(isnan(d), "%s'(NaN) = %g", kw_activation_name(kind_at(i)), d);
        }
    }
}

static void names_are_different(void)
{
    for (int i = 0; i < KW_ACTIVATION_KINDS; i++)
        for (int j = 0; j < i; j++)
            CHECK(strcmp(kw_activation_name(kind_at(i)),
                         kw_activation_name(kind_at(j))) != 0,
                  "%s twice", kw_activation_name(kind_at(i)));
}

/* --- the layer --- */

enum { COUNT = 9, WIDTH = 5, ALL = COUNT * WIDTH };

static void the_layer_is_the_function(void)
{
    kw_rng r = kw_rng_at(81, 0, 0, 0);
    double x[ALL], y[ALL + 1], dy[ALL], dx[ALL + 1];

    for (int k = 0; k < KW_ACTIVATION_KINDS; k++) {
        kw_activation l = kw_activation_layer(kind_at(k), WIDTH);

        CHECK(l.in == WIDTH && l.out == WIDTH && l.parameters == 0, "%d %d %d", l.in,
              l.out, l.parameters);
        for (int i = 0; i < ALL; i++) {
            x[i] = test_random_in(&r, -3, 3);
            dy[i] = test_random_in(&r, -3, 3);
        }
        y[ALL] = dx[ALL] = 17;
        kw_activation_forward(&l, NULL, COUNT, x, y);
        kw_activation_backward(&l, NULL, COUNT, x, y, dy, dx, NULL);
        kw_activation_backward(&l, NULL, COUNT, x, y, dy, NULL, NULL);
        for (int i = 0; i < ALL; i++) {
            double d = kw_activation_derivative(l.kind, x[i]);

            CHECK(y[i] == kw_activation_value(l.kind, x[i]), "%s(%g) = %g",
                  kw_activation_name(l.kind), x[i], y[i]);
            CHECK(dx[i] == dy[i] * d, "%s'(%g) times %g = %g", kw_activation_name(l.kind),
                  x[i], dy[i], dx[i]);
        }
        CHECK(y[ALL] == 17 && dx[ALL] == 17, "%g %g behind the end", y[ALL], dx[ALL]);
    }
}

/* --- misuse --- */

static double number[1];

static void unknown_kind(void)
{
    kw_activation_value(kind_at(KW_ACTIVATION_KINDS), 0);
}

static void negative_kind(void)
{
    kw_activation_name(kind_at(-1));
}

static void no_units(void)
{
    kw_activation_layer(KW_TANH, 0);
}

static void no_samples(void)
{
    kw_activation l = kw_activation_layer(KW_TANH, 1);

    kw_activation_forward(&l, NULL, 0, number, number);
}

static void too_many(void)
{
    kw_activation l = kw_activation_layer(KW_TANH, 65536);

    kw_activation_backward(&l, NULL, 32768, number, number, number, number, NULL);
}

static void misuse_aborts(void)
{
    test_aborts("activation 11", unknown_kind);
    test_aborts("activation -1", negative_kind);
    test_aborts("width 0", no_units);
    test_aborts("0 samples", no_samples);
    test_aborts("32768 samples of 65536 numbers", too_many);
}

int main(void)
{
    test_run("activation: values are those of the formulas",
             values_are_those_of_the_formulas);
    test_run("activation: known values", known_values);
    test_run("activation: small values keep their digits",
             small_values_keep_their_digits);
    test_run("activation: derivatives are limits of differences",
             derivatives_are_limits_of_differences);
    test_run("activation: derivatives at zero are from the left",
             derivatives_at_zero_are_from_the_left);
    test_run("activation: derivatives far out", derivatives_far_out);
    test_run("activation: a NaN gives a NaN", nan_gives_nan);
    test_run("activation: NaN has the derivative that is promised",
             nan_has_the_derivative_that_is_promised);
    test_run("activation: names are different", names_are_different);
    test_run("activation: the layer is the function", the_layer_is_the_function);
    test_run("activation: misuse aborts", misuse_aborts);
    return test_end();
}
