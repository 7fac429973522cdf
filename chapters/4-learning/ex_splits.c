/* Splits -- three sets of samples, and what each is for.

   What to see: the loss on the training set falls as long as one trains, far below what the law
   itself has there, while the loss on new samples rises again. The validation set, which no step
   has used, says when to stop. (The test set, looked at once, at the end, is not in the picture.)

   Book: section 1.2, training, validation and test sets, overfitting, early stopping.
   Claims: learn.split.*
   Chosen here: the task (noisy.h) and 100 samples for each set; a network of 16 hidden units; 20
   times other samples and initial parameters; training ends after 20 epochs without a better
   validation loss, or after 200. */

#include "claim.h" /* what we found, for the ledger */
#include "noisy.h" /* the task, the network, true means */
#include "out.h"   /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { REPEATS = 20, EPOCHS = 200, PATIENCE = 20, SHOWN = 1, CASES = 200, MOST = 1000 };

static const double RATE = 0.01;
static const uint64_t SEED = 441;

/* --- pairwise disjoint --- */

/* Random data sets of up to MOST samples, cut into three sets of random sizes after a shuffle:
   samples that are not in exactly one set. */
static int misplaced_samples(void)
{
    int misplaced = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        kw_rng r = kw_rng_at(SEED, 3, i, 0);
        int count = SETS + kw_rng_below(&r, MOST - SETS + 1);
        int first = 1 + kw_rng_below(&r, count - 2);
        int second = 1 + kw_rng_below(&r, count - first - 1);
        const int end[SETS] = {first, first + second, count};
        int order[MOST] = {0}, sets[MOST] = {0};

        shuffle(&r, count, order);
        for (int set = 0, k = 0; set < SETS; set++) {
            char inside[MOST] = {0};

            for (; k < end[set]; k++)
                inside[order[k]] = 1;
            for (int sample = 0; sample < count; sample++)
                sets[sample] += inside[sample];
        }
        for (int sample = 0; sample < count; sample++)
            misplaced += sets[sample] != 1;
    }
    return misplaced;
}

/* MOST / 5 training and as many test samples of MOST, either drawn without regard to the other:
   the mean number of samples that are in both. */
static double shared_samples(void)
{
    double shared = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        kw_rng r = kw_rng_at(SEED, 4, i, 0);
        int training[MOST], test[MOST];
        char trained[MOST] = {0};

        shuffle(&r, MOST, training);
        shuffle(&r, MOST, test);
        for (int k = 0; k < MOST / 5; k++)
            trained[training[k]] = 1;
        for (int k = 0; k < MOST / 5; k++)
            shared += trained[test[k]];
    }
    return shared / CASES;
}

/* --- trainings --- */

/* Trains from the start and leaves the parameters in w; the caller frees what is returned. */
static kw_train *train(noisy *t, const kw_train_plan *plan, double *w)
{
    kw_train *training = kw_train_new(plan);
    kw_optimizer *adam = kw_optimizer_new(KW_ADAM, t->net->parameters, RATE);
    int failed;

    kw_net_init(t->net, t->seed + 1000, w);
    failed = kw_train_run(training, adam, w);
    KW_NEED(!failed, "seed %llu", (unsigned long long)t->seed);
    kw_optimizer_free(adam);
    return training;
}

/* The loss of the law, which knows the task and the noise, on the training set: -log(1 - TURNED)
   for a sample with its own label, -log(TURNED) for one whose label is turned. */
static double law_on_training(const noisy *t)
{
    double sum = 0;

    for (int i = 0; i < PART; i++) {
        int sample = t->set[TRAINING][i];
        int own = t->label[sample] == majority(BITS, t->x + sample * BITS);

        sum -= kw_log(own ? 1 - TURNED : TURNED);
    }
    return sum / PART;
}

/* Of the network where it stops and of the one after EPOCHS epochs. */
typedef struct result {
    int best, epochs;  /* where it stops, and when it knows */
    double risk, test; /* there */
    double end_training, end_risk;
    double law; /* its loss on the training set */
} result;

static result stop_and_go_on(uint64_t seed)
{
    noisy *t = new_noisy(seed);
    double *w = kw_need_memory((size_t)t->net->parameters, sizeof *w);
    const kw_train_plan stopping = noisy_plan(t, EPOCHS, PATIENCE);
    const kw_train_plan to_the_end = noisy_plan(t, EPOCHS, 0);
    kw_train *training = train(t, &stopping, w);
    result all = {.best = training->best,
                  .epochs = training->epochs,
                  .risk = noisy_risk(t, w),
                  .test = kw_supervised_mean(t->loss, PART, t->set[TEST], w, NULL),
                  .law = law_on_training(t)};

    kw_train_free(training);
    training = train(t, &to_the_end, w);
    all.end_training = training->on_training[EPOCHS];
    all.end_risk = noisy_risk(t, w);
    kw_train_free(training);
    free_noisy(t);
    free(w);
    return all;
}

/* One training to the end, with the losses on all three sets and in truth. As the validation set
   has no part in the steps, any set can take its place, to be measured alone. */
static void write_epochs(kw_out *f, uint64_t seed)
{
    noisy *t = new_noisy(seed);
    double *w = kw_need_memory((size_t)t->net->parameters, sizeof *w);
    kw_train_plan plan = noisy_plan(t, EPOCHS, 0);
    kw_train *on[4];

    for (int k = 0; k < 4; k++) {
        const int *const set[] = {t->set[VALIDATION], t->set[TEST], t->all,
                                  t->all + INPUTS};

        plan.validation = k < 2 ? PART : INPUTS;
        plan.validation_sample = set[k];
        on[k] = train(t, &plan, w);
    }
    kw_out_section(f, "epochs", "epoch training validation test risk");
    for (int e = 0; e <= EPOCHS; e++) {
        kw_out_number(f, e);
        kw_out_number(f, on[0]->on_training[e]);
        for (int k = 0; k < 2; k++)
            kw_out_number(f, on[k]->on_validation[e]);
        kw_out_number(f, (1 - TURNED) * on[2]->on_validation[e] +
                             TURNED * on[3]->on_validation[e]);
        kw_out_row(f);
    }
    for (int k = 0; k < 4; k++)
        kw_train_free(on[k]);
    free_noisy(t);
    free(w);
}

static void write_results(kw_out *f, const result *all)
{
    kw_out_section(f, "floor", "risk");
    kw_out_number(f, noisy_floor());
    kw_out_row(f);
    kw_out_section(f, "stops", "repeat stop risk end-training end-risk");
    for (int k = 0; k < REPEATS; k++) {
        kw_out_number(f, k + 1);
        kw_out_number(f, all[k].best);
        kw_out_number(f, all[k].risk);
        kw_out_number(f, all[k].end_training);
        kw_out_number(f, all[k].end_risk);
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_splits"), *report = kw_claim_new("ex_splits");
    result all[REPEATS], mean = {.best = 0};
    int early = 0, overfitted = 0, below_law = 0;

    for (int k = 0; k < REPEATS; k++) {
        all[k] = stop_and_go_on(SEED + (uint64_t)k);
        early += all[k].epochs < EPOCHS;
        overfitted += all[k].end_risk > all[k].risk;
        below_law += all[k].end_training < all[k].law;
        mean.risk += all[k].risk / REPEATS;
        mean.test += all[k].test / REPEATS;
        mean.end_training += all[k].end_training / REPEATS;
        mean.end_risk += all[k].end_risk / REPEATS;
    }
    write_epochs(f, SEED + SHOWN);
    write_results(f, all);

    kw_claim_count(report, "learn.split.misplaced", misplaced_samples());
    kw_claim_real(report, "learn.split.shared", shared_samples());
    kw_claim_real(report, "learn.split.floor", noisy_floor());
    kw_claim_count(report, "learn.split.early", early);
    kw_claim_count(report, "learn.split.overfitted", overfitted);
    kw_claim_count(report, "learn.split.below-law", below_law);
    kw_claim_real(report, "learn.split.stop.risk", mean.risk);
    kw_claim_real(report, "learn.split.stop.test", mean.test - mean.risk);
    kw_claim_real(report, "learn.split.end.training", mean.end_training);
    kw_claim_real(report, "learn.split.end.risk", mean.end_risk);
    return kw_out_close(f) | kw_out_close(report);
}
