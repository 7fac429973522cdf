/* The perceptron's error -- what it can be, and why the rule does not go down its slope.

   What to see: the square of the printed error is a step. It has no slope to go down; the
   function that the rule does go down is the perceptron criterion.

   Book: section 1.2, (20), (21) and the text around them.
   Claims: mlp.eq20.*, mlp.eq21.decision, mlp.sign.*, mlp.error.*, mlp.rule.*,
           mlp.def10.perceptron
   Chosen here: two features; integers, and biases halfway between two of them, so that nothing
   is rounded and no sum is zero. */

#include "claim.h"      /* what we found, for the ledger */
#include "loss.h"       /* the perceptron criterion */
#include "mlp.h"        /* Definition 10 with L = 1 */
#include "out.h"        /* columns for gnuplot */
#include "perceptron.h" /* (20), (21), the rule */
#include "rng.h"        /* random samples and weights */
#include <stddef.h>

enum {
    M = 2,        /* features */
    PROBES = 1000 /* random samples and weights */
};

static const double RATE = 0.5;

/* For a sample with label +1 and the sum z: the square of the error, and the criterion. */
static void write_errors(kw_out *f)
{
    const double label = 1, one[] = {1, 0}; /* with these weights the sum is z */

    kw_out_section(f, "errors", "sum squared criterion");
    for (int i = -12; i <= 12; i++) {
        /* -2^-60 stands for the limit from below at the step */
        double z = i == -1 ? -0x1p-60 : i / 4.0;
        double error = label - kw_perceptron_decide(1, one, &z);

        kw_out_number(f, z);
        kw_out_number(f, error * error);
        kw_out_number(f, kw_loss_perceptron(1, 1, &z, &label, NULL));
        kw_out_row(f);
        if (i == -1)
            kw_out_gap(f);
    }
}

/* (20) is not additive, and not zero at zero: affine, not linear. */
static void report_affine(kw_out *report)
{
    const double w[] = {2, -1, 3}, p[] = {1, 2}, q[] = {0, 1}, sum[] = {1, 3},
                 zero[] = {0, 0};

    kw_claim_real(report, "mlp.eq20.parts",
                  kw_perceptron_sum(M, w, p) + kw_perceptron_sum(M, w, q));
    kw_claim_real(report, "mlp.eq20.whole", kw_perceptron_sum(M, w, sum));
    kw_claim_real(report, "mlp.eq20.zero", kw_perceptron_sum(M, w, zero));
}

/* sign(0), and that of minus zero. */
static void report_sign(kw_out *report)
{
    const double one[] = {1, 0}, zero = 0, minus = -zero;

    kw_claim_count(report, "mlp.sign.zero", kw_perceptron_decide(1, one, &zero));
    kw_claim_count(report, "mlp.sign.minus-zero", kw_perceptron_decide(1, one, &minus));
}

/* A sample p with label x, and weights w. */
typedef struct sample {
    double w[M + 1], p[M], x;
} sample;

/* The two functions of the weights. */
static double squared_error(const sample *s)
{
    double error = s->x - kw_perceptron_decide(M, s->w, s->p);

    return error * error;
}

static double criterion(const sample *s)
{
    double sum = kw_perceptron_sum(M, s->w, s->p);

    return kw_loss_perceptron(1, 1, &sum, &s->x, NULL);
}

/* The slope of f in direction of weight j by a central difference. */
static double slope(double (*f)(const sample *), sample s, int j)
{
    const double h = 0x1p-10, at = s.w[j];
    double up, down;

    s.w[j] = at + h;
    up = f(&s);
    s.w[j] = at - h;
    down = f(&s);
    return (up - down) / (2 * h);
}

static double random_integer(kw_rng *r)
{
    return kw_rng_below(r, 11) - 5;
}

/* Integer weights and points, but a bias halfway between two integers: the sum is at least
   1/2 from zero, no difference reaches across, and all of them are exact. */
static sample random_sample(kw_rng *r)
{
    sample s;

    for (int j = 0; j < M; j++) {
        s.w[j] = random_integer(r);
        s.p[j] = random_integer(r);
    }
    s.w[M] = random_integer(r) + 0.5;
    s.x = kw_rng_below(r, 2) ? 1 : -1;
    return s;
}

/* Over random samples: how many different errors there are; at how many mistakes the squared
   error has a slope; and at how many the rule goes against the slope of the error, and of the
   criterion. */
static void report_rule(kw_out *report)
{
    kw_rng r = kw_rng_at(42, 0, 0, 0);
    int seen[5] = {0}, values = 0, mistakes = 0, sloped = 0, against_error = 0,
        against_criterion = 0;

    for (int i = 0; i < PROBES; i++) {
        sample s = random_sample(&r), moved = s;
        int error = kw_perceptron_update(M, RATE, s.p, s.x, moved.w);
        int slopes = 0, with_error = 1, with_criterion = 1;

        seen[error + 2] = 1;
        for (int j = 0; j <= M; j++) {
            double step = moved.w[j] - s.w[j];

            slopes += slope(squared_error, s, j) != 0;
            with_error &= step == -slope(squared_error, s, j);
            with_criterion &= step == -slope(criterion, s, j);
        }
        mistakes += error != 0;
        sloped += error != 0 && slopes > 0;
        against_error += error != 0 && with_error;
        against_criterion += error != 0 && with_criterion;
    }
    for (int i = 0; i < 5; i++)
        values += seen[i];
    kw_claim_count(report, "mlp.error.values", values);
    kw_claim_count(report, "mlp.error.slope", sloped);
    kw_claim_true(report, "mlp.rule.error", against_error == mistakes);
    kw_claim_true(report, "mlp.rule.criterion", against_criterion == mistakes);
}

/* Definition 10 with L = 1, on the weights of (20) above and the point (1,1): it has no
   sigma_L, so it gives the sum where the perceptron gives its sign. */
static void report_definition10(kw_out *report)
{
    static const int width[] = {M, 1};
    static const kw_activation_kind none[] = {KW_IDENTITY};
    const double w[] = {2, -1, 3}, p[] = {1, 1};
    kw_net *n = kw_mlp_new(1, width, none);
    kw_net_work *work = kw_net_work_new(n, 1);
    double y;

    kw_net_forward(n, w, 1, p, work, &y);
    kw_claim_real(report, "mlp.def10.perceptron", y);
    kw_claim_count(report, "mlp.eq21.decision", kw_perceptron_decide(M, w, p));
    kw_net_work_free(work);
    kw_net_free(n);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_rule"), *report = kw_claim_new("ex_rule");

    write_errors(f);
    report_affine(report);
    report_sign(report);
    report_rule(report);
    report_definition10(report);
    return kw_out_close(f) | kw_out_close(report);
}
