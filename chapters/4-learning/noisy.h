/* noisy.h -- what ex_splits and ex_stopping share: a task with noise, and a network that can
   learn the noise by heart.

   Inputs are nine signs, all 512 as likely. The label is what most of them are; one label in five
   is turned around. There are 300 random samples, 100 for each of the three sets. As all inputs
   and the noise are known, so is the true mean of a loss, without any estimate. */
#ifndef NOISY_H
#define NOISY_H

#include "bits.h"
#include "elementary.h"
#include "mlp.h"
#include "need.h"
#include "rng.h"
#include "shuffle.h"
#include "supervised.h"
#include "train.h"
#include <stdlib.h>

enum {
    BITS = 9,
    INPUTS = 1 << BITS,
    HIDDEN = 16,
    PART = 100,
    SAMPLES = 3 * PART,
    RIGHT = SAMPLES,        /* sample RIGHT + i: input i with its own label */
    WRONG = RIGHT + INPUTS, /* sample WRONG + i: input i with the other one */
    ALL = WRONG + INPUTS
};

enum { TRAINING, VALIDATION, TEST, SETS };

static const double TURNED = 0.2;

typedef struct noisy {
    double x[ALL * BITS], label[ALL];
    int set[SETS][PART]; /* sample numbers below SAMPLES */
    int all[2 * INPUTS]; /* RIGHT .. ALL - 1 */
    uint64_t seed;
    kw_net *net;
    kw_supervised *loss; /* the logistic loss over all samples */
} noisy;

static inline void set_sample(noisy *t, int sample, int input, double sign)
{
    for (int j = 0; j < BITS; j++)
        t->x[sample * BITS + j] = t->x[(RIGHT + input) * BITS + j];
    t->label[sample] = sign * t->label[RIGHT + input];
}

/* Samples, their split into three sets, and a network; the caller frees. */
static inline noisy *new_noisy(uint64_t seed)
{
    const int width[] = {BITS, HIDDEN, 1};
    const kw_activation_kind sigma[] = {KW_TANH, KW_IDENTITY};
    noisy *t = kw_need_memory(1, sizeof *t);
    kw_rng r = kw_rng_at(seed, 1, 0, 0), split = kw_rng_at(seed, 2, 0, 0);
    int order[SAMPLES];

    fill_inputs(BITS, t->x + RIGHT * BITS);
    for (int i = 0; i < INPUTS; i++)
        t->label[RIGHT + i] = majority(BITS, t->x + (RIGHT + i) * BITS);
    for (int i = 0; i < INPUTS; i++)
        set_sample(t, WRONG + i, i, -1);
    for (int i = 0; i < SAMPLES; i++) {
        int input = kw_rng_below(&r, INPUTS);

        set_sample(t, i, input, kw_rng_uniform(&r) < TURNED ? -1 : 1);
    }
    shuffle(&split, SAMPLES, order);
    for (int i = 0; i < SAMPLES; i++)
        t->set[i / PART][i % PART] = order[i];
    for (int i = 0; i < 2 * INPUTS; i++)
        t->all[i] = RIGHT + i;
    t->seed = seed;
    t->net = kw_mlp_new(2, width, sigma);
    t->loss = kw_supervised_new(t->net, kw_loss_logistic, ALL, t->x, t->label, INPUTS);
    return t;
}

static inline void free_noisy(noisy *t)
{
    kw_supervised_free(t->loss);
    kw_net_free(t->net);
    free(t);
}

/* Training by Adam along the whole gradient; without a validation set if `patience` is 0. */
static inline kw_train_plan noisy_plan(noisy *t, int epochs, int patience)
{
    return (kw_train_plan){.objective = kw_supervised_mean,
                           .problem = t->loss,
                           .parameters = t->net->parameters,
                           .training = PART,
                           .training_sample = t->set[TRAINING],
                           .validation = patience > 0 ? PART : 0,
                           .validation_sample = t->set[VALIDATION],
                           .epochs = epochs,
                           .batch = PART,
                           .patience = patience};
}

/* The true mean of the loss at the parameters w. */
static inline double noisy_risk(noisy *t, const double *w)
{
    double right = kw_supervised_mean(t->loss, INPUTS, t->all, w, NULL);
    double wrong = kw_supervised_mean(t->loss, INPUTS, t->all + INPUTS, w, NULL);

    return (1 - TURNED) * right + TURNED * wrong;
}

/* The least risk of all functions, that of those who know the task and the noise. */
static inline double noisy_floor(void)
{
    return -(1 - TURNED) * kw_log(1 - TURNED) - TURNED * kw_log(TURNED);
}

#endif
