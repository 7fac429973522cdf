#include "loss.h"
#include "perceptron.h"
#include "test.h"
#include <math.h>
#include <stddef.h>

enum { COUNT = 4, OUT = 3, ENTRIES = COUNT * OUT, ROUNDS = 300 };

static const double U = 0x1p-53; /* one rounding, relative */

typedef struct named {
    const char *name;
    kw_loss *loss;
    int kinked;
} named;

static const named LOSS[] = {{"squared", kw_loss_squared, 0},
                             {"cross-entropy", kw_loss_cross_entropy, 0},
                             {"logistic", kw_loss_logistic, 0},
                             {"hinge", kw_loss_hinge, 1},
                             {"perceptron", kw_loss_perceptron, 1}};

enum { CROSS_ENTROPY = 1, LOSSES = sizeof LOSS / sizeof *LOSS };

/* Targets that the loss takes: numbers, probabilities (multiples of 1/8) or signs. */
static void random_targets(kw_rng *r, const named *l, double *target)
{
    for (int i = 0; i < ENTRIES; i++)
        target[i] = l->loss == kw_loss_squared ? (kw_rng_below(r, 33) - 16) / 4.0
                                               : 2 * kw_rng_below(r, 2) - 1;
    for (int i = 0; l->loss == kw_loss_cross_entropy && i < COUNT; i++) {
        int first = kw_rng_below(r, 9), second = kw_rng_below(r, 9 - first);

        target[i * OUT] = first / 8.0;
        target[i * OUT + 1] = second / 8.0;
        target[i * OUT + 2] = (8 - first - second) / 8.0;
    }
}

/* --- derivatives --- */

/* The slope of the loss in entry k of y, by the central difference of four points. Its own error is
   h^4/30 times the fifth derivative, here at most about 1: below 1e-13. A value has an error of
   some 40 roundings of at most 200, 1e-12, and 18/(12 h) times that is 1.5e-9. The
   derivatives are of order one, so this is far below 1e-6 relative to them. */
static const double H = 1e-3, SLOPE_ERROR = 2e-9;

static double slope(kw_loss *loss, double *y, const double *target, int k)
{
    const double at = y[k];
    double value[5] = {0};

    for (int i = -2; i <= 2; i++) {
        y[k] = at + i * H;
        value[i + 2] = loss(COUNT, OUT, y, target, NULL);
    }
    y[k] = at;
    return (8 * (value[3] - value[1]) - (value[4] - value[0])) / (12 * H);
}

static void derivatives_are_central_differences(void)
{
    kw_rng r = kw_rng_at(76, 0, 0, 0);

    for (int i = 0; i < LOSSES; i++)
        for (int round = 0; round < ROUNDS; round++) {
            double y[ENTRIES], target[ENTRIES], dy[ENTRIES];

            random_targets(&r, &LOSS[i], target);
            for (int k = 0; k < ENTRIES; k++) {
                y[k] = test_random_in(&r, -4, 4);
                while (LOSS[i].kinked &&
                       (fabs(y[k]) <= 3 * H || fabs(fabs(y[k]) - 1) <= 3 * H))
                    y[k] = test_random_in(&r, -4, 4);
            }
            test_poison(dy, ENTRIES);
            LOSS[i].loss(COUNT, OUT, y, target, dy);
            for (int k = 0; k < ENTRIES; k++) {
                double expected = slope(LOSS[i].loss, y, target, k);

                CHECK(fabs(dy[k] - expected) <= SLOPE_ERROR, "%s: %.12g, not %.12g",
                      LOSS[i].name, dy[k], expected);
            }
        }
}

/* A mean over samples: each counts the same, and alone. */
static void a_batch_is_the_mean_of_its_samples(void)
{
    kw_rng r = kw_rng_at(77, 0, 0, 0);

    for (int i = 0; i < LOSSES; i++)
        for (int round = 0; round < ROUNDS; round++) {
            double y[ENTRIES], target[ENTRIES], dy[ENTRIES], one[OUT], sum = 0, value;

            random_targets(&r, &LOSS[i], target);
            for (int k = 0; k < ENTRIES; k++)
                y[k] = test_random_in(&r, -4, 4);
            value = LOSS[i].loss(COUNT, OUT, y, target, dy);
            for (int s = 0; s < COUNT; s++) {
                sum += LOSS[i].loss(1, OUT, y + s * OUT, target + s * OUT, one);
                for (int k = 0; k < OUT; k++) /* a division by 4 is exact */
                    CHECK(dy[s * OUT + k] == one[k] / COUNT, "%s: %g, not %g",
                          LOSS[i].name, dy[s * OUT + k], one[k] / COUNT);
            }
            /* ENTRIES + COUNT sums of terms that are not negative */
            CHECK(fabs(value - sum / COUNT) <= 16 * U * value, "%s: %.17g, not %.17g",
                  LOSS[i].name, value, sum / COUNT);
            CHECK(value >= 0, "%s: %g", LOSS[i].name, value);
        }
}

/* --- values --- */

static void squared_is_exact_on_integers(void)
{
    const double y[] = {1, 2, 3, 4}, target[] = {0, 2, 5, 1};
    double dy[4];

    CHECK(kw_loss_squared(2, 2, y, target, dy) == (1 + 0 + 4 + 9) / 2.0, "value");
    CHECK(dy[0] == 1 && dy[1] == 0 && dy[2] == -2 && dy[3] == 3, "%g %g %g %g", dy[0],
          dy[1], dy[2], dy[3]);
}

static void hinge_by_hand(void)
{
    const double y[] = {2, 0.5, -3, 1}, target[] = {1, 1, 1, 1};
    double dy[4];

    CHECK(kw_loss_hinge(4, 1, y, target, dy) == (0 + 0.5 + 4 + 0) / 4, "value");
    CHECK(dy[0] == 0 && dy[1] == -0.25 && dy[2] == -0.25 && dy[3] == 0, "%g %g %g %g",
          dy[0], dy[1], dy[2], dy[3]);
}

/* At zero the decision is +1: right for the one label and wrong for the other. */
static void perceptron_by_hand(void)
{
    const double y[] = {2, -2, 0, 0}, target[] = {1, 1, 1, -1};
    double dy[4];

    CHECK(kw_loss_perceptron(4, 1, y, target, dy) == 2 / 4.0, "value");
    CHECK(dy[0] == 0 && dy[1] == -0.25 && dy[2] == 0 && dy[3] == 0.25, "%g %g %g %g",
          dy[0], dy[1], dy[2], dy[3]);
}

/* The rule w += rate (x - decision) p is 2 rate against the criterion's gradient, which by the
   chain rule is dy (p, 1). On integers both are exact. */
static void the_rule_goes_against_the_criterion(void)
{
    kw_rng r = kw_rng_at(78, 0, 0, 0);
    int moved = 0;

    for (int round = 0; round < 1000; round++) {
        double w[3], p[2], x = kw_rng_below(&r, 2) ? 1 : -1, sum, dy, step[3];

        for (int j = 0; j < 3; j++)
            step[j] = w[j] = kw_rng_below(&r, 7) - 3;
        for (int j = 0; j < 2; j++)
            p[j] = kw_rng_below(&r, 7) - 3;
        sum = kw_perceptron_sum(2, w, p);
        kw_loss_perceptron(1, 1, &sum, &x, &dy);
        moved += kw_perceptron_update(2, 0.5, p, x, w) != 0;
        for (int j = 0; j < 3; j++) {
            step[j] -= dy * (j < 2 ? p[j] : 1);
            CHECK(w[j] == step[j], "%g, not %g", w[j], step[j]);
        }
    }
    CHECK(moved > 100, "only %d mistakes", moved);
}

static void cross_entropy_of_equal_logits_is_a_logarithm(void)
{
    const double y[] = {7, 7, 7, 7}, target[] = {0, 0, 1, 0};
    double dy[4], value = kw_loss_cross_entropy(1, 4, y, target, dy);

    CHECK(fabs(value - log(4)) <= 4 * U * log(4), "%.17g", value);
    CHECK(dy[0] == 0.25 && dy[1] == 0.25 && dy[2] == -0.75 && dy[3] == 0.25,
          "%g %g %g %g", dy[0], dy[1], dy[2], dy[3]);
}

/* A shift of all logits by an integer changes nothing, exactly for multiples of 1/8; the
   derivatives of a row add up to zero, each with an error of about four roundings. */
static void cross_entropy_does_not_see_a_shift(void)
{
    kw_rng r = kw_rng_at(79, 0, 0, 0);

    for (int round = 0; round < ROUNDS; round++) {
        double y[ENTRIES], z[ENTRIES], target[ENTRIES], dy[ENTRIES], dz[ENTRIES], a, b;
        int shift = kw_rng_below(&r, 2001) - 1000;

        random_targets(&r, &LOSS[CROSS_ENTROPY], target);
        for (int k = 0; k < ENTRIES; k++) {
            y[k] = (kw_rng_below(&r, 129) - 64) / 8.0;
            z[k] = y[k] + shift;
        }
        a = kw_loss_cross_entropy(COUNT, OUT, y, target, dy);
        b = kw_loss_cross_entropy(COUNT, OUT, z, target, dz);
        CHECK(a == b, "%g and %g", a, b);
        for (int k = 0; k < ENTRIES; k++)
            CHECK(dy[k] == dz[k], "%g and %g", dy[k], dz[k]);
        for (int i = 0; i < COUNT; i++)
            CHECK(fabs(dy[i * OUT] + dy[i * OUT + 1] + dy[i * OUT + 2]) <= 16 * U, "%g",
                  dy[i * OUT] + dy[i * OUT + 1] + dy[i * OUT + 2]);
    }
}

/* The logistic loss is the cross-entropy of the logits (y, 0), computed in another way. */
static void two_classes_are_a_special_case(void)
{
    kw_rng r = kw_rng_at(80, 0, 0, 0);

    for (int round = 0; round < ROUNDS; round++) {
        double y = test_random_in(&r, -20, 20), x = kw_rng_below(&r, 2) ? 1 : -1;
        const double logits[] = {y, 0}, target[] = {x > 0, x < 0};
        double a, b, da, db[2];

        a = kw_loss_logistic(1, 1, &y, &x, &da);
        b = kw_loss_cross_entropy(1, 2, logits, target, db);
        /* absolute, as log(1 + e) has no digits of e: a few roundings of one, and of y */
        CHECK(fabs(a - b) <= (8 + fabs(y)) * 2 * U, "%.17g and %.17g", a, b);
        CHECK(fabs(da - db[0]) <= 16 * U, "%.17g and %.17g", da, db[0]);
    }
}

/* Logits that would overflow or vanish: a decision that is as sure as wrong costs its size. */
static void large_logits_do_not_overflow(void)
{
    const double y[] = {1000, -1000, 0}, right[] = {1, 0, 0}, wrong[] = {0, 1, 0};
    const double big = 1000, minus = -1;
    double dy[3];

    CHECK(kw_loss_cross_entropy(1, 3, y, right, dy) == 0, "right");
    CHECK(dy[0] == 0 && dy[1] == 0 && dy[2] == 0, "%g %g %g", dy[0], dy[1], dy[2]);
    CHECK(kw_loss_cross_entropy(1, 3, y, wrong, dy) == 2000, "wrong");
    CHECK(dy[0] == 1 && dy[1] == -1 && dy[2] == 0, "%g %g %g", dy[0], dy[1], dy[2]);
    CHECK(kw_loss_logistic(1, 1, &big, &minus, dy) == 1000, "wrong sign");
    CHECK(dy[0] == 1, "%g", dy[0]);
}

/* A difference of logits that overflows counts only where its target is not zero. */
static void huge_logits_have_a_loss(void)
{
    const double y[] = {1e308, -1e308}, right[] = {1, 0}, wrong[] = {0, 1};
    double dy[2];

    CHECK(kw_loss_cross_entropy(1, 2, y, right, dy) == 0, "right");
    CHECK(dy[0] == 0 && dy[1] == 0, "%g %g", dy[0], dy[1]);
    CHECK(kw_loss_cross_entropy(1, 2, y, wrong, dy) == INFINITY, "wrong");
    CHECK(dy[0] == 1 && dy[1] == -1, "%g %g", dy[0], dy[1]);
}

/* The value is what tells; the derivative is -t / count, as promised. */
static void kinked_losses_pass_no_nan_back(void)
{
    const double y[] = {NAN, NAN}, target[] = {1, -1};
    double dy[2];

    for (int i = 0; i < LOSSES; i++)
        if (LOSS[i].kinked) {
            CHECK(isnan(LOSS[i].loss(2, 1, y, target, dy)), "%s", LOSS[i].name);
            CHECK(dy[0] == -0.5 && dy[1] == 0.5, "%s: %g %g", LOSS[i].name, dy[0], dy[1]);
        }
}

static void a_prediction_that_is_nan_shows(void)
{
    for (int i = 0; i < LOSSES; i++)
        for (int at = 0; at < 2; at++) {
            const double y[] = {at == 0 ? NAN : 1, at == 1 ? NAN : 1};
            const double one[] = {1, 1}, two[] = {1, 0}, three[] = {-1, -1};
            const double *target = LOSS[i].loss == kw_loss_cross_entropy ? two : one;

            CHECK(isnan(LOSS[i].loss(1, 2, y, target, NULL)), "%s", LOSS[i].name);
            CHECK(target == two || isnan(LOSS[i].loss(1, 2, y, three, NULL)), "%s",
                  LOSS[i].name);
        }
}

/* --- misuse --- */

static const double Y[] = {1, 2};
static double given[2]; /* the targets below */
static int count = 1, out = 2;
static kw_loss *used;

static void call(void)
{
    used(count, out, Y, given, NULL);
}

static void expect(const char *text, kw_loss *loss, double first, double second)
{
    used = loss;
    given[0] = first;
    given[1] = second;
    test_aborts(text, call);
}

static void misuse_aborts(void)
{
    expect("the target of output 1 of sample 0 is nan", kw_loss_squared, 0, NAN);
    expect("the target of output 0 of sample 0 is -inf", kw_loss_squared, -INFINITY, 0);
    expect("the target of class 1 of sample 0 is -0.5", kw_loss_cross_entropy, 1.5, -0.5);
    expect("the target of class 0 of sample 0 is nan", kw_loss_cross_entropy, NAN, 1);
    expect("the targets of sample 0 add up to 1.5", kw_loss_cross_entropy, 1, 0.5);
    expect("the target of output 1 of sample 0 is 0", kw_loss_logistic, 1, 0);
    expect("the target of output 0 of sample 0 is nan", kw_loss_hinge, NAN, 1);
    expect("the target of output 1 of sample 0 is 2", kw_loss_perceptron, 1, 2);
    for (int i = 0; i < LOSSES; i++) {
        count = 0;
        expect("0 samples", LOSS[i].loss, 1, 1);
        count = 1;
        out = 0;
        expect("0 outputs", LOSS[i].loss, 1, 1);
        out = 2;
    }
    count = 2;
    out = 1;
    expect("the target of output 0 of sample 1 is inf", kw_loss_squared, 0, INFINITY);
    expect("the target of output 0 of sample 1 is 2", kw_loss_hinge, 1, 2);
    count = out = 1;
    expect("1 classes", kw_loss_cross_entropy, 1, 0);
}

int main(void)
{
    test_run("loss: derivatives are central differences",
             derivatives_are_central_differences);
    test_run("loss: a batch is the mean of its samples",
             a_batch_is_the_mean_of_its_samples);
    test_run("loss: squared is exact on integers", squared_is_exact_on_integers);
    test_run("loss: hinge by hand", hinge_by_hand);
    test_run("loss: perceptron by hand", perceptron_by_hand);
    test_run("loss: the perceptron's rule goes against the criterion",
             the_rule_goes_against_the_criterion);
    test_run("loss: cross-entropy of equal logits",
             cross_entropy_of_equal_logits_is_a_logarithm);
    test_run("loss: cross-entropy does not see a shift",
             cross_entropy_does_not_see_a_shift);
    test_run("loss: two classes are a special case", two_classes_are_a_special_case);
    test_run("loss: large logits do not overflow", large_logits_do_not_overflow);
    test_run("loss: huge logits have a loss", huge_logits_have_a_loss);
    test_run("loss: kinked losses pass no NaN back", kinked_losses_pass_no_nan_back);
    test_run("loss: a prediction that is NaN shows", a_prediction_that_is_nan_shows);
    test_run("loss: misuse aborts and names the value", misuse_aborts);
    return test_end();
}
