#include "optimizer.h"
#include "test.h"
#include <math.h>
#include <stddef.h>

enum { N = 5, STEPS = 50 };

/* The gradient of f(w) = sum of a_i w_i^2 / 2. */
static const double A[N] = {1, 0.5, 2, 4, 0.25};

static void gradient(const double *w, double *dw)
{
    for (int i = 0; i < N; i++)
        dw[i] = A[i] * w[i];
}

/* w becomes (1 - rate a)^steps w, exactly for powers of two. */
static void descent_contracts(void)
{
    kw_optimizer *o = kw_optimizer_new(KW_DESCENT, N, 0.25);
    double w[N] = {1, 1, 1, 1, 1}, dw[N];

    for (int step = 1; step <= 10; step++) {
        gradient(w, dw);
        kw_optimizer_step(o, dw, w);
        for (int i = 0; i < N; i++) {
            double expected = pow(1 - 0.25 * A[i], step);

            CHECK(i > 2 || w[i] == expected, "entry %d: %g, not %g", i, w[i], expected);
        }
    }
    CHECK(w[3] == 0, "%g", w[3]); /* rate a = 1: one step */
    CHECK(o->steps == 10, "%lld", o->steps);
    kw_optimizer_free(o);
}

/* v = g, then v/2 + g: powers of two again. */
static void momentum_remembers(void)
{
    kw_optimizer *o = kw_optimizer_new(KW_MOMENTUM, 1, 1);
    const double g[] = {8};
    double w[] = {0};

    o->momentum = 0.5;
    kw_optimizer_step(o, g, w);
    CHECK(w[0] == -8, "%g", w[0]);
    kw_optimizer_step(o, g, w);
    CHECK(w[0] == -8 - 12, "%g", w[0]);
    o->rate = 2;
    kw_optimizer_step(o, g, w);
    CHECK(w[0] == -8 - 12 - 2 * 14, "%g", w[0]);
    kw_optimizer_free(o);
}

static void without_memory_momentum_is_descent(void)
{
    kw_optimizer *a = kw_optimizer_new(KW_DESCENT, N, 0.3);
    kw_optimizer *b = kw_optimizer_new(KW_MOMENTUM, N, 0.3);
    double u[N] = {1, -2, 3, 0.1, 5}, w[N] = {1, -2, 3, 0.1, 5}, dw[N];

    b->momentum = 0;
    for (int step = 0; step < STEPS; step++) {
        gradient(u, dw);
        kw_optimizer_step(a, dw, u);
        gradient(w, dw);
        kw_optimizer_step(b, dw, w);
        for (int i = 0; i < N; i++)
            CHECK(u[i] == w[i], "%g and %g", u[i], w[i]);
    }
    kw_optimizer_free(a);
    kw_optimizer_free(b);
}

/* Algorithm 1 of Kingma and Ba, with sums in place of recursions: v_t is the sum of
   0.1 0.9^(t-k) g_k, s_t that of 0.001 0.999^(t-k) g_k^2. A recursion of t steps has 4t
   roundings, pow and the sums no more; the quotient and its root add a few: 10t u covers
   each part, and 40 t u their combination. No cancellation in s; v is a sum of mixed signs, so
   the error is relative to the same sum of absolute values, which is at most sqrt(s_t) times a
   constant: by Cauchy and Schwarz the sum of 0.1 0.9^(t-k) |g_k| is at most
   sqrt(sum of (0.01/0.001) (0.81/0.999)^(t-k)) sqrt(s_t) <= 7.3 sqrt(s_t). */
static void adam_is_the_published_one(void)
{
    const double rate = 0.01, u = 0x1p-53;
    kw_optimizer *o = kw_optimizer_new(KW_ADAM, 1, rate);
    kw_rng r = kw_rng_at(74, 0, 0, 0);
    double g[STEPS], w[] = {0};

    for (int t = 1; t <= STEPS; t++) {
        double v = 0, s = 0, before = w[0], expected, bound;

        g[t - 1] = test_random_in(&r, -1, 1);
        kw_optimizer_step(o, &g[t - 1], w);
        for (int k = 1; k <= t; k++) {
            v += 0.1 * pow(0.9, t - k) * g[k - 1];
            s += 0.001 * pow(0.999, t - k) * g[k - 1] * g[k - 1];
        }
        v /= 1 - pow(0.9, t);
        s /= 1 - pow(0.999, t);
        expected = rate * v / (sqrt(s) + 1e-8);
        /* 1 - 0.999^t has lost a factor of 1/0.001 of its digits, 1 - 0.9^t one of 10 */
        bound = rate * 7.3 * (40 * t + 1000 * t) * u + 2 * u;
        CHECK(fabs(before - w[0] - expected) <= bound, "step %d: %.17g, not %.17g", t,
              before - w[0], expected);
    }
    kw_optimizer_free(o);
}

/* The first step is rate g / (|g| + 1e-8), whatever the size of g. */
static void adam_begins_with_the_rate(void)
{
    const double g[] = {1e-3, 1, -1e6, 0};
    kw_optimizer *o = kw_optimizer_new(KW_ADAM, 4, 0.5);
    double w[] = {0, 0, 0, 7};

    kw_optimizer_step(o, g, w);
    for (int i = 0; i < 4; i++) {
        double expected = -0.5 * g[i] / (fabs(g[i]) + 1e-8) + (i == 3 ? 7 : 0);

        /* 1 - 0.999 is the same number in both places; at most ten roundings below one */
        CHECK(fabs(w[i] - expected) <= 10 * 0x1p-53, "%.17g, not %.17g", w[i], expected);
    }
    kw_optimizer_free(o);
}

/* No gradient, no step: zero over zero is none. A gradient that is NaN stays one. */
static void adam_without_floor(void)
{
    const double g[] = {0, 4, -1e-200, NAN};
    kw_optimizer *o = kw_optimizer_new(KW_ADAM, 4, 0.5);
    double w[] = {7, 0, 7, 0};

    o->floor = 0;
    kw_optimizer_step(o, g, w);
    CHECK(w[0] == 7, "%g", w[0]);
    /* 0.5 up to the ten roundings of the step */
    CHECK(fabs(w[1] + 0.5) <= 10 * 0x1p-53, "%.17g", w[1]);
    CHECK(w[2] == 7, "%g", w[2]); /* its square is zero */
    CHECK(isnan(w[3]), "%g", w[3]);
    kw_optimizer_free(o);
}

/* Convergence on a quadratic with the condition number 16. */
static void all_of_them_descend(void)
{
    const double rate[] = {0.4, 0.1, 0.05};

    for (int method = KW_DESCENT; method <= KW_ADAM; method++) {
        kw_optimizer *o = kw_optimizer_new((kw_method)method, N, rate[method]);
        double w[N] = {1, -2, 3, 0.1, 5}, dw[N];

        for (int step = 0; step < 2000; step++) {
            gradient(w, dw);
            kw_optimizer_step(o, dw, w);
        }
        for (int i = 0; i < N; i++)
            CHECK(fabs(w[i]) < 1e-6, "method %d: %g", method, w[i]);
        kw_optimizer_free(o);
    }
}

static void free_of_nothing(void)
{
    kw_optimizer_free(NULL);
}

/* --- misuse --- */

static void strange_method(void)
{
    kw_optimizer_new((kw_method)3, 1, 1);
}

static void no_parameters(void)
{
    kw_optimizer_new(KW_ADAM, 0, 1);
}

static void negative_rate(void)
{
    kw_optimizer_new(KW_DESCENT, 1, -0.5);
}

static void step_with(double rate, double momentum, double memory, double floor)
{
    kw_optimizer *o = kw_optimizer_new(KW_ADAM, 1, 1);
    const double g[] = {1};
    double w[] = {0};

    o->rate = rate;
    o->momentum = momentum;
    o->memory = memory;
    o->floor = floor;
    kw_optimizer_step(o, g, w);
    kw_optimizer_free(o);
}

static void nan_rate(void)
{
    step_with(NAN, 0.9, 0.999, 0);
}

static void full_momentum(void)
{
    step_with(1, 1, 0.999, 0);
}

static void full_memory(void)
{
    step_with(1, 0.9, 1, 0);
}

static void nan_floor(void)
{
    step_with(1, 0.9, 0.999, NAN);
}

static void negative_floor(void)
{
    step_with(1, 0.9, 0.999, -1e-8);
}

static void infinite_floor(void)
{
    step_with(1, 0.9, 0.999, INFINITY);
}

static void misuse_aborts(void)
{
    test_aborts("method 3", strange_method);
    test_aborts("0 parameters", no_parameters);
    test_aborts("rate -0.5", negative_rate);
    test_aborts("rate nan", nan_rate);
    test_aborts("momentum 1", full_momentum);
    test_aborts("memory 1", full_memory);
    test_aborts("floor nan", nan_floor);
    test_aborts("floor -1e-08", negative_floor);
    test_aborts("floor inf", infinite_floor);
}

int main(void)
{
    test_run("optimizer: descent contracts a quadratic", descent_contracts);
    test_run("optimizer: momentum remembers", momentum_remembers);
    test_run("optimizer: without memory momentum is descent",
             without_memory_momentum_is_descent);
    test_run("optimizer: Adam is the published one", adam_is_the_published_one);
    test_run("optimizer: Adam's first step is the rate", adam_begins_with_the_rate);
    test_run("optimizer: Adam without floor", adam_without_floor);
    test_run("optimizer: all of them descend", all_of_them_descend);
    test_run("optimizer: freeing NULL is fine", free_of_nothing);
    test_run("optimizer: misuse aborts and names the value", misuse_aborts);
    return test_end();
}
