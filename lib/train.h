/* train.h -- training: steps of an optimizer over mini-batches, and early stopping.

   What is minimized is an objective: a mean over samples that depends on parameters. A sample
   is known by its number alone; what it is only the objective knows.

   An epoch goes once through the training samples, in an order that is shuffled anew and
   depends on the seed and the number of the epoch alone, `batch` samples a step (the last
   step of an epoch may have fewer). If one batch holds all samples there is nothing to
   shuffle: plain steps along the whole gradient.

   Early stopping: after each epoch the objective is taken over validation samples, which no
   step has used. The parameters that did best there are kept, and they are the result.
   [Goodfellow, Bengio, Courville: Deep Learning, 2016, sections 7.8 and 8.1] */
#ifndef KW_TRAIN_H
#define KW_TRAIN_H

#include "optimizer.h"
#include <stdint.h>

/* The mean over the samples sample[0..count-1], count >= 1, of what is to be small, at the
   parameters w. dw: an entry a parameter, set to the derivative of this mean; NULL: not
   wanted. `problem` is handed through from the plan. */
typedef double kw_objective(void *problem, int count, const int *sample, const double *w,
                            double *dw);

typedef struct kw_train_plan {
    kw_objective *objective;
    void *problem;
    int parameters;               /* >= 1 */
    int training, validation;     /* samples: >= 1; >= 0, 0 for no early stopping */
    const int *training_sample;   /* their numbers */
    const int *validation_sample; /* their numbers, none of them in training */
    int epochs;                   /* at most so many, >= 0 */
    int batch;                    /* samples a step, >= 1; no objective gets more */
    int patience; /* it stops after so many epochs without a better validation value; 0: never */
    uint64_t seed; /* of the shuffling */
} kw_train_plan;

typedef struct kw_train {
    kw_train_plan plan; /* the lists of samples stay the caller's */
    int epochs;         /* that were run */
    int best;           /* the epoch after which w was as it is at the end */
    /* the objective after epoch e, e = 0 .. epochs (0: before the first), over all training
       samples and over all validation samples; these are 0 if there are none */
    double *on_training, *on_validation;
    int *order;        /* the training samples as shuffled last */
    double *dw, *kept; /* a gradient; the best parameters so far */
} kw_train;

/* A training with its own memory; the plan is copied, not its lists. A plan that cannot be
   carried out aborts, so does a sample that is in both lists. */
kw_train *kw_train_new(const kw_train_plan *plan);
void kw_train_free(kw_train *t);

/* Trains w, with plan.parameters entries, from where it is, and writes the history. The
   optimizer goes on from where it is. Afterwards w is as it was after epoch `best`: the
   first with the least value on the validation samples, or without these the last.

   Returns 0. If a value of the objective is not a finite number, a line on stderr says in
   which epoch, and 1 is returned: the training ends as if before that epoch. A smaller rate
   may help, unless it was epoch 0. */
int kw_train_run(kw_train *t, kw_optimizer *o, double *w);

#endif
