/* Stopping -- the validation set has a part in the training.

   What to see: from the networks that a training passes through early stopping takes the one with
   the least loss on a validation set. So this loss is no fair estimate: on average it is less than
   the true one. On a test set of the same size it is the true one.

   Book: section 1.2, the validation and the test set.
   Claims: learn.stop.*
   Chosen here: the task (noisy.h), ten training sets with a training of 100 epochs each; for each of
   them 200 validation sets and as many test sets, of 25, 100 and 400 new samples. */

#include "claim.h" /* what we found, for the ledger */
#include "noisy.h" /* the task, the network, true means */
#include "out.h"   /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { TRAININGS = 10, EPOCHS = 100, DRAWS = 200, SIZES = 3, MOST = 400, SHOWN = 9 };

static const int SIZE[SIZES] = {25, 100, MOST};
static const double RATE = 0.01;
static const uint64_t SEED = 471;

/* The networks of one training, epoch by epoch: their losses on every input with either label,
   and the true mean. */
typedef struct path {
    double loss[EPOCHS + 1][2 * INPUTS], risk[EPOCHS + 1];
} path;

/* loss[i], i < INPUTS: at input i with its own label; loss[INPUTS + i]: with the other one. */
static void write_losses(const noisy *t, const double *w, double *loss)
{
    double y[INPUTS];

    kw_net_forward(t->net, w, INPUTS, t->x + RIGHT * BITS, t->loss->work, y);
    for (int i = 0; i < INPUTS; i++) {
        loss[i] = kw_loss_logistic(1, 1, y + i, t->label + RIGHT + i, NULL);
        loss[INPUTS + i] = kw_loss_logistic(1, 1, y + i, t->label + WRONG + i, NULL);
    }
}

static void train(uint64_t seed, path *p)
{
    noisy *t = new_noisy(seed);
    const int parameters = t->net->parameters;
    double *w = kw_need_memory((size_t)parameters, sizeof *w);
    kw_train_plan one_epoch = noisy_plan(t, 1, 0);
    kw_train *training = kw_train_new(&one_epoch);
    kw_optimizer *adam = kw_optimizer_new(KW_ADAM, parameters, RATE);

    kw_net_init(t->net, seed + 1000, w);
    for (int e = 0; e <= EPOCHS; e++) {
        int failed = e > 0 ? kw_train_run(training, adam, w) : 0;

        KW_NEED(!failed, "epoch %d of seed %llu", e, (unsigned long long)seed);
        write_losses(t, w, p->loss[e]);
        p->risk[e] = noisy_risk(t, w);
    }
    kw_train_free(training);
    kw_optimizer_free(adam);
    free_noisy(t);
    free(w);
}

/* m random samples: inputs below INPUTS have their own label, the others are turned. */
static void draw(kw_rng *r, int m, int *sample)
{
    for (int i = 0; i < m; i++) {
        int input = kw_rng_below(r, INPUTS);

        sample[i] = kw_rng_uniform(r) < TURNED ? INPUTS + input : input;
    }
}

static double mean_loss(const double *loss, int m, const int *sample)
{
    double sum = 0;

    for (int i = 0; i < m; i++)
        sum += loss[sample[i]];
    return sum / m;
}

/* The epoch with the least loss on the samples, the first of them. */
static int best_epoch(const path *p, int m, const int *sample)
{
    double least = INFINITY;
    int best = 0;

    for (int e = 0; e <= EPOCHS; e++) {
        double value = mean_loss(p->loss[e], m, sample);

        if (value < least) {
            least = value;
            best = e;
        }
    }
    return best;
}

/* Of one size, means over all draws: what the selected network has on the validation set, on a
   test set and in truth; the least that any network on its path has in truth. */
typedef struct findings {
    double validation, test, risk, least_risk;
} findings;

static void try_draws(const path *p, uint64_t seed, int size, findings *all)
{
    const double share = 1.0 / (TRAININGS * DRAWS);
    const int m = SIZE[size];
    int validation[MOST], test[MOST];
    double least_risk = INFINITY;

    for (int e = 0; e <= EPOCHS; e++)
        least_risk = fmin(least_risk, p->risk[e]);
    for (uint64_t d = 0; d < DRAWS; d++) {
        kw_rng r = kw_rng_at(seed, 3, d, (uint64_t)size);
        int e;

        draw(&r, m, validation);
        draw(&r, m, test);
        e = best_epoch(p, m, validation);
        all->validation += share * mean_loss(p->loss[e], m, validation);
        all->test += share * mean_loss(p->loss[e], m, test);
        all->risk += share * p->risk[e];
        all->least_risk += share * least_risk;
    }
}

/* --- columns --- */

/* One path: its risk, what SHOWN validation sets make of it, and where these are least. */
static void write_path(kw_out *f, const path *p)
{
    int validation[SHOWN][MOST];

    for (int d = 0; d < SHOWN; d++) {
        kw_rng r = kw_rng_at(SEED, 4, (uint64_t)d, 0);

        draw(&r, SIZE[0], validation[d]);
    }
    kw_out_section(f, "risk", "epoch risk");
    for (int e = 0; e <= EPOCHS; e++) {
        kw_out_number(f, e);
        kw_out_number(f, p->risk[e]);
        kw_out_row(f);
    }
    kw_out_section(f, "validation", "epoch loss");
    for (int d = 0; d < SHOWN; d++) {
        for (int e = 0; e <= EPOCHS; e++) {
            kw_out_number(f, e);
            kw_out_number(f, mean_loss(p->loss[e], SIZE[0], validation[d]));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    kw_out_section(f, "least", "epoch loss risk");
    for (int d = 0; d < SHOWN; d++) {
        int e = best_epoch(p, SIZE[0], validation[d]);

        kw_out_number(f, e);
        kw_out_number(f, mean_loss(p->loss[e], SIZE[0], validation[d]));
        kw_out_number(f, p->risk[e]);
        kw_out_row(f);
    }
}

static void write_means(kw_out *f, const findings *all)
{
    kw_out_section(f, "means", "samples validation test risk least-risk");
    for (int s = 0; s < SIZES; s++) {
        kw_out_number(f, SIZE[s]);
        kw_out_number(f, all[s].validation);
        kw_out_number(f, all[s].test);
        kw_out_number(f, all[s].risk);
        kw_out_number(f, all[s].least_risk);
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_stopping"), *report = kw_claim_new("ex_stopping");
    static path p;
    static findings all[SIZES];
    int above = 0;

    for (uint64_t seed = SEED; seed < SEED + TRAININGS; seed++) {
        train(seed, &p);
        if (seed == SEED)
            write_path(f, &p);
        for (int s = 0; s < SIZES; s++)
            try_draws(&p, seed, s, &all[s]);
    }
    for (int s = 0; s < SIZES; s++)
        above += all[s].validation >= all[s].least_risk;
    write_means(f, all);

    kw_claim_real(report, "learn.stop.25", all[0].validation - all[0].risk);
    kw_claim_real(report, "learn.stop.100", all[1].validation - all[1].risk);
    kw_claim_real(report, "learn.stop.400", all[2].validation - all[2].risk);
    kw_claim_real(report, "learn.stop.test.25", all[0].test - all[0].risk);
    kw_claim_real(report, "learn.stop.test.100", all[1].test - all[1].risk);
    kw_claim_real(report, "learn.stop.test.400", all[2].test - all[2].risk);
    kw_claim_count(report, "learn.stop.above", above);
    return kw_out_close(f) | kw_out_close(report);
}
