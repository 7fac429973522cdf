#include "train.h"
#include "need.h"
#include "rng.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int compare(const void *a, const void *b)
{
    int left = *(const int *)a, right = *(const int *)b;

    return (left > right) - (left < right);
}

/* No validation sample is among the training samples; t->order is scratch. */
static void need_disjoint(kw_train *t)
{
    const kw_train_plan *p = &t->plan;
    const size_t count = (size_t)p->training;

    memcpy(t->order, p->training_sample, count * sizeof *t->order);
    qsort(t->order, count, sizeof *t->order, compare);
    for (int i = 0; i < p->validation; i++)
        KW_NEED(!bsearch(p->validation_sample + i, t->order, count, sizeof *t->order,
                         compare),
                "sample %d is in training and in validation", p->validation_sample[i]);
}

kw_train *kw_train_new(const kw_train_plan *plan)
{
    kw_train *t;
    size_t values;

    KW_NEED(plan->objective, "no objective");
    KW_NEED(plan->training_sample, "no list of training samples");
    KW_NEED(plan->validation_sample || plan->validation == 0,
            "no list of %d validation samples", plan->validation);
    KW_NEED(plan->parameters >= 1, "%d parameters", plan->parameters);
    KW_NEED(plan->training >= 1, "%d training samples", plan->training);
    KW_NEED(plan->validation >= 0, "%d validation samples", plan->validation);
    KW_NEED(plan->epochs >= 0, "%d epochs", plan->epochs);
    KW_NEED(plan->batch >= 1, "batches of %d", plan->batch);
    KW_NEED(plan->patience == 0 || (plan->patience > 0 && plan->validation > 0),
            "patience %d with %d validation samples", plan->patience, plan->validation);
    values = (size_t)plan->epochs + 1;
    t = kw_need_memory(1, sizeof *t);
    t->plan = *plan;
    t->on_training = kw_need_memory(values, sizeof *t->on_training);
    t->on_validation = kw_need_memory(values, sizeof *t->on_validation);
    t->order = kw_need_memory((size_t)plan->training, sizeof *t->order);
    t->dw = kw_need_memory((size_t)plan->parameters, sizeof *t->dw);
    t->kept = kw_need_memory((size_t)plan->parameters, sizeof *t->kept);
    need_disjoint(t);
    return t;
}

void kw_train_free(kw_train *t)
{
    if (!t)
        return;
    free(t->on_training);
    free(t->on_validation);
    free(t->order);
    free(t->dw);
    free(t->kept);
    free(t);
}

/* How many of `count` samples the batch that begins with number `first` has. */
static int batch_size(const kw_train_plan *p, int count, int first)
{
    return count - first < p->batch ? count - first : p->batch;
}

/* The objective over all these samples, batch by batch. */
static double mean(const kw_train_plan *p, int count, const int *sample, const double *w)
{
    double sum = 0;

    for (int first = 0, size; first < count; first += size) {
        size = batch_size(p, count, first);
        sum += p->objective(p->problem, size, sample + first, w, NULL) *
               ((double)size / count);
    }
    return sum;
}

/* Says so and returns 1 if a value of the objective is not finite. */
static int is_lost(double value, int e)
{
    if (isfinite(value))
        return 0;
    fprintf(stderr, "training ends in epoch %d: the objective is %g\n", e, value);
    return 1;
}

/* Writes the history of epoch e; 1 if the training is lost. */
static int measure(kw_train *t, int e, const double *w)
{
    const kw_train_plan *p = &t->plan;

    t->on_training[e] = mean(p, p->training, p->training_sample, w);
    t->on_validation[e] = mean(p, p->validation, p->validation_sample, w);
    return is_lost(t->on_training[e], e) || is_lost(t->on_validation[e], e);
}

/* The training samples in the order of epoch e: each of the remaining ones may come last.
   [Knuth: The Art of Computer Programming, vol. 2, section 3.4.2, algorithm P] */
static void shuffle(kw_train *t, int e)
{
    const kw_train_plan *p = &t->plan;
    kw_rng r = kw_rng_at(p->seed, 0, (uint64_t)e, 0);

    memcpy(t->order, p->training_sample, (size_t)p->training * sizeof *t->order);
    for (int last = p->training - 1; last > 0 && p->batch < p->training; last--) {
        int other = kw_rng_below(&r, last + 1), kept = t->order[last];

        t->order[last] = t->order[other];
        t->order[other] = kept;
    }
}

/* The steps of epoch e; 1 if the training is lost. */
static int run_epoch(kw_train *t, int e, kw_optimizer *o, double *w)
{
    const kw_train_plan *p = &t->plan;

    shuffle(t, e);
    for (int first = 0, size; first < p->training; first += size) {
        size = batch_size(p, p->training, first);
        if (is_lost(p->objective(p->problem, size, t->order + first, w, t->dw), e))
            return 1;
        kw_optimizer_step(o, t->dw, w);
    }
    return 0;
}

/* Is w after epoch e the best so far? */
static int is_better(const kw_train *t, int e)
{
    return t->plan.validation == 0 || t->on_validation[e] < t->on_validation[t->best];
}

int kw_train_run(kw_train *t, kw_optimizer *o, double *w)
{
    const kw_train_plan *p = &t->plan;
    const size_t bytes = (size_t)p->parameters * sizeof *w;
    int failed;

    KW_NEED(o->parameters == p->parameters,
            "the optimizer has %d parameters, the plan %d", o->parameters, p->parameters);
    t->epochs = t->best = 0;
    memcpy(t->kept, w, bytes);
    failed = measure(t, 0, w);
    for (int e = 1; e <= p->epochs && !failed; e++) {
        failed = run_epoch(t, e, o, w) || measure(t, e, w);
        if (failed)
            break;
        t->epochs = e;
        if (is_better(t, e)) {
            t->best = e;
            memcpy(t->kept, w, bytes);
        }
        if (p->patience > 0 && e - t->best >= p->patience)
            break;
    }
    memcpy(w, t->kept, bytes);
    return failed;
}
