#include "perceptron.h"
#include "test.h"
#include <math.h>
#include <stddef.h>

enum { M = 4, COUNT = 40, PASSES = 20000 };

/* a data set with small integer features, so that all below is exact */
typedef struct data {
    int m, count;
    double P[COUNT * M], x[COUNT];
} data;

static int random_integer(kw_rng *r, int size)
{
    return kw_rng_below(r, 2 * size + 1) - size;
}

/* Points that the separator u[0..m], of integers, decides with |sum| >= 1; what it cannot
   decide is drawn again. */
static data separable(kw_rng *r, double *u)
{
    data d = {.m = 1 + kw_rng_below(r, M), .count = 1 + kw_rng_below(r, COUNT)};

    u[0] = kw_rng_below(r, 2) ? 3 : -2;
    for (int j = 1; j <= d.m; j++)
        u[j] = random_integer(r, 5);
    for (int i = 0; i < d.count; i++) {
        double *p = d.P + (size_t)i * (size_t)d.m, sum;

        do {
            sum = u[d.m];
            for (int j = 0; j < d.m; j++) {
                p[j] = random_integer(r, 6);
                sum += u[j] * p[j];
            }
        } while (sum == 0);
        d.x[i] = sum > 0 ? 1 : -1;
    }
    return d;
}

static int count_wrong(const data *d, const double *w)
{
    int wrong = 0;

    for (int i = 0; i < d->count; i++)
        wrong += kw_perceptron_decide(d->m, w, d->P + i * d->m) != d->x[i];
    return wrong;
}

/* --- the decision --- */

static void zero_counts_as_positive(void)
{
    const double w[] = {1, -1, 0}, p[] = {3, 3}, q[] = {3, 3.0000000000000004};
    const double minus[] = {-1, -0.0}, zero[] = {0};

    CHECK(kw_perceptron_sum(2, w, p) == 0, "%g", kw_perceptron_sum(2, w, p));
    CHECK(kw_perceptron_decide(2, w, p) == 1, "at zero");
    CHECK(kw_perceptron_decide(2, w, q) == -1, "just below");
    CHECK(kw_perceptron_decide(1, minus, zero) == 1, "at minus zero");
}

static void the_sum_is_affine(void)
{
    const double w[] = {2, -1, 3}, p[] = {1, 2};

    CHECK(kw_perceptron_sum(2, w, p) == 3, "%g", kw_perceptron_sum(2, w, p));
}

/* --- the rule --- */

static void a_step_moves_towards_the_label(void)
{
    const double p[] = {2, -3};
    double w[] = {0, 0, 0};

    /* at zero the decision is +1: wrong for -1, right for +1 */
    CHECK(kw_perceptron_update(2, 0.5, p, 1, w) == 0, "right");
    CHECK(w[0] == 0 && w[1] == 0 && w[2] == 0, "%g %g %g", w[0], w[1], w[2]);
    CHECK(kw_perceptron_update(2, 0.5, p, -1, w) == -2, "wrong");
    CHECK(w[0] == -2 && w[1] == 3 && w[2] == -1, "%g %g %g", w[0], w[1], w[2]);
    CHECK(kw_perceptron_update(2, 0.25, p, 1, w) == 2, "wrong again");
    CHECK(w[0] == -1 && w[1] == 1.5 && w[2] == -0.5, "%g %g %g", w[0], w[1], w[2]);
}

static void errors_are_the_three_of_the_book(void)
{
    kw_rng r = kw_rng_at(71, 0, 0, 0);
    int seen[5] = {0};

    for (int round = 0; round < 1000; round++) {
        double w[3], p[2], x = kw_rng_below(&r, 2) ? 1 : -1;
        int error, decision;

        for (int j = 0; j < 3; j++)
            w[j] = random_integer(&r, 3);
        for (int j = 0; j < 2; j++)
            p[j] = random_integer(&r, 3);
        decision = kw_perceptron_decide(2, w, p);
        error = kw_perceptron_update(2, 1, p, x, w);
        CHECK(error == x - decision, "%d", error);
        CHECK(error == -2 || error == 0 || error == 2, "%d", error);
        seen[error + 2]++;
    }
    CHECK(seen[0] > 0 && seen[2] > 0 && seen[4] > 0, "%d %d %d", seen[0], seen[2],
          seen[4]);
}

/* --- training --- */

/* The conjunction of two signs, by hand: one mistake, at the first sample. */
static void a_run_by_hand(void)
{
    const double P[] = {-1, -1, -1, 1, 1, -1, 1, 1}, x[] = {-1, -1, -1, 1};
    double w[] = {0, 0, 0};
    int clean;

    /* then w = (1,1,-1): -1+1-1 and 1-1-1 are negative, 1+1-1 is positive */
    CHECK(kw_perceptron_train(2, 4, P, x, 0.5, 10, w, &clean) == 1, "mistakes");
    CHECK(clean == 2, "clean in pass %d", clean);
    CHECK(w[0] == 1 && w[1] == 1 && w[2] == -1, "%g %g %g", w[0], w[1], w[2]);
}

/* On integers with rate 1/2 the weights are integers, so mistakes are counted exactly. */
static void it_learns_what_is_separable_within_novikoffs_bound(void)
{
    kw_rng r = kw_rng_at(72, 0, 0, 0);

    for (int round = 0; round < 300; round++) {
        double u[M + 1], w[M + 1] = {0}, bound;
        data d = separable(&r, u);
        long long mistakes;
        int clean;

        mistakes = kw_perceptron_train(d.m, d.count, d.P, d.x, 0.5, PASSES, w, &clean);
        bound = kw_perceptron_bound(d.m, d.count, d.P, d.x, u);
        CHECK(clean >= 1, "round %d: %lld mistakes and no end", round, mistakes);
        CHECK(count_wrong(&d, w) == 0, "round %d: %d wrong", round, count_wrong(&d, w));
        CHECK((double)mistakes <= bound, "round %d: %lld mistakes, bound %g", round,
              mistakes, bound);
        CHECK(clean == 1 || kw_perceptron_margin(d.m, d.count, d.P, d.x, w) >= 0,
              "round %d: margin %g", round,
              kw_perceptron_margin(d.m, d.count, d.P, d.x, w));
    }
}

/* From zero, a rate only scales the weights; powers of two do so exactly. */
static void the_rate_does_not_matter(void)
{
    kw_rng r = kw_rng_at(73, 0, 0, 0);

    for (int round = 0; round < 50; round++) {
        double u[M + 1], slow[M + 1] = {0}, fast[M + 1] = {0};
        data d = separable(&r, u);
        long long a, b;
        int clean[2];

        a = kw_perceptron_train(d.m, d.count, d.P, d.x, 0.125, 50, slow, &clean[0]);
        b = kw_perceptron_train(d.m, d.count, d.P, d.x, 16, 50, fast, &clean[1]);
        CHECK(a == b && clean[0] == clean[1], "%lld and %lld mistakes", a, b);
        for (int j = 0; j <= d.m; j++)
            CHECK(fast[j] == 128 * slow[j], "%g and %g", fast[j], slow[j]);
    }
}

static void what_is_not_separable_has_no_clean_pass(void)
{
    const double P[] = {0, 0, 0, 1, 1, 0, 1, 1}, x[] = {-1, 1, 1, -1};
    double w[] = {0, 0, 0};
    int clean;
    long long mistakes = kw_perceptron_train(2, 4, P, x, 0.5, 1000, w, &clean);

    CHECK(clean == 0, "clean in pass %d", clean);
    CHECK(mistakes >= 1000, "%lld mistakes", mistakes);
}

/* (3,4,0) over its length 5 at the distance of 1: sum -2 on the wrong side. */
static void the_margin_is_a_distance(void)
{
    const double P[] = {3, 4, -2, 1}, x[] = {1, 1}, y[] = {1, -1}, w[] = {3, 4, 0};
    double wrong = kw_perceptron_margin(2, 2, P, x, w);
    double right = kw_perceptron_margin(2, 2, P, y, w);

    CHECK(wrong == -2.0 / 5, "%g", wrong);
    CHECK(right == 2.0 / 5, "%g", right);
    /* R = |(3,4,1)| = sqrt(26), so 26 / (4/25) up to the square roots: 4 roundings */
    CHECK(fabs(kw_perceptron_bound(2, 2, P, y, w) - 162.5) <= 162.5 * 8 * 0x1p-53,
          "%.17g", kw_perceptron_bound(2, 2, P, y, w));
}

/* --- misuse --- */

static const double P1[] = {1, 2}, X1[] = {1, -1};

static void no_features(void)
{
    const double w[] = {1};

    kw_perceptron_decide(0, w, P1);
}

static void nan_feature(void)
{
    const double w[] = {0, 1}, p[] = {NAN};

    kw_perceptron_decide(1, w, p);
}

static void infinite_feature(void)
{
    const double w[] = {0, 1}, p[] = {INFINITY};

    kw_perceptron_decide(1, w, p);
}

static void strange_label(void)
{
    double w[] = {0, 1};

    kw_perceptron_update(1, 1, P1, 0, w);
}

static void nan_label(void)
{
    const double x[] = {1, NAN}, w[] = {0, 1};

    kw_perceptron_margin(1, 2, P1, x, w);
}

static void no_rate(void)
{
    double w[] = {0, 1};

    kw_perceptron_update(1, 0, P1, 1, w);
}

static void no_samples(void)
{
    double w[] = {0, 1};
    int clean;

    kw_perceptron_train(1, 0, P1, X1, 1, 1, w, &clean);
}

static void no_passes(void)
{
    double w[] = {0, 1};
    int clean;

    kw_perceptron_train(1, 2, P1, X1, 1, 0, w, &clean);
}

static void train_on(const double *P, const double *x)
{
    double w[] = {0, 1};
    int clean;

    kw_perceptron_train(1, 2, P, x, 1, 1, w, &clean);
}

static void nan_feature_in_a_set(void)
{
    const double P[] = {1, NAN};

    train_on(P, X1);
}

static void infinite_feature_in_a_set(void)
{
    const double P[] = {-INFINITY, 1};

    train_on(P, X1);
}

static void strange_label_in_a_set(void)
{
    const double x[] = {1, 0};

    train_on(P1, x);
}

static void zero_normal(void)
{
    const double w[] = {0, 0};

    kw_perceptron_margin(1, 2, P1, X1, w);
}

static void no_separator(void)
{
    const double u[] = {1, 0};

    kw_perceptron_bound(1, 2, P1, X1, u);
}

static void misuse_aborts(void)
{
    test_aborts("m = 0", no_features);
    test_aborts("the sum is", nan_feature); /* nan or -nan */
    test_aborts("the sum is", infinite_feature);
    test_aborts("label 0", strange_label);
    test_aborts("label 1 is nan", nan_label);
    test_aborts("label 1 is 0", strange_label_in_a_set);
    test_aborts("feature 0 of sample 1 is nan", nan_feature_in_a_set);
    test_aborts("feature 0 of sample 0 is -inf", infinite_feature_in_a_set);
    test_aborts("rate 0", no_rate);
    test_aborts("0 samples", no_samples);
    test_aborts("0 passes", no_passes);
    test_aborts("the norm of w is 0", zero_normal);
    test_aborts("the margin of u is -2", no_separator);
}

int main(void)
{
    test_run("perceptron: zero counts as positive", zero_counts_as_positive);
    test_run("perceptron: the sum is affine", the_sum_is_affine);
    test_run("perceptron: a step moves towards the label",
             a_step_moves_towards_the_label);
    test_run("perceptron: errors are -2, 0 and 2", errors_are_the_three_of_the_book);
    test_run("perceptron: a run by hand", a_run_by_hand);
    test_run("perceptron: it learns what is separable, within Novikoff's bound",
             it_learns_what_is_separable_within_novikoffs_bound);
    test_run("perceptron: the rate only scales", the_rate_does_not_matter);
    test_run("perceptron: what is not separable has no clean pass",
             what_is_not_separable_has_no_clean_pass);
    test_run("perceptron: the margin is a distance", the_margin_is_a_distance);
    test_run("perceptron: misuse aborts and names the value", misuse_aborts);
    return test_end();
}
