#include "train.h"
#include "dense.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 23, MOST = 4000 };

/* --- an objective that keeps a diary --- */

typedef struct diary {
    int calls, seen;      /* gradients asked for; samples in them */
    int sample[MOST];     /* these samples, one after the other */
    int size[MOST];       /* how many a call had */
    int largest;          /* the largest call, of any kind */
    double lost;          /* the objective is NaN where w[0] exceeds this */
    const double *target; /* of each sample */
} diary;

/* The mean of (w - target)^2 / 2 over the samples. */
static double distance(void *problem, int count, const int *sample, const double *w,
                       double *dw)
{
    diary *d = problem;
    double sum = 0, slope = 0;

    for (int i = 0; i < count; i++) {
        double off = w[0] - d->target[sample[i]];

        sum += off * off / 2;
        slope += off;
        if (dw)
            d->sample[d->seen++] = sample[i];
    }
    if (dw) {
        d->size[d->calls++] = count;
        dw[0] = slope / count;
    }
    if (count > d->largest)
        d->largest = count;
    return w[0] > d->lost ? NAN : sum / count;
}

static const double ZERO[SAMPLES + 2];
static const int FIRST[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                            12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22};

static kw_train_plan plan_of(diary *d, int epochs, int batch)
{
    return (kw_train_plan){.objective = distance,
                           .problem = d,
                           .parameters = 1,
                           .training = SAMPLES,
                           .training_sample = FIRST,
                           .epochs = epochs,
                           .batch = batch,
                           .seed = 5};
}

/* Runs the plan by descent; returns what kw_train_run does. */
static int run(const kw_train_plan *plan, double rate, double *w, kw_train **t)
{
    kw_optimizer *o = kw_optimizer_new(KW_DESCENT, plan->parameters, rate);
    int failed;

    *t = kw_train_new(plan);
    failed = kw_train_run(*t, o, w);
    kw_optimizer_free(o);
    return failed;
}

/* --- mini-batches --- */

static void every_sample_once_an_epoch(void)
{
    for (int batch = 1; batch <= SAMPLES + 3; batch++) {
        diary d = {.lost = INFINITY, .target = ZERO};
        kw_train_plan plan = plan_of(&d, 3, batch);
        int steps = (SAMPLES + batch - 1) / batch;
        double w[] = {1};
        kw_train *t;

        CHECK(run(&plan, 0.1, w, &t) == 0, "batch %d", batch);
        CHECK(d.calls == 3 * steps, "batch %d: %d steps", batch, d.calls);
        CHECK(d.largest == (batch < SAMPLES ? batch : SAMPLES), "%d", d.largest);
        for (int call = 0; call < d.calls; call++) {
            int last = (call + 1) % steps == 0;
            int expected = last ? SAMPLES - (steps - 1) * d.largest : d.largest;

            CHECK(d.size[call] == expected, "batch %d, step %d: %d samples", batch, call,
                  d.size[call]);
        }
        for (int e = 0; e < 3; e++) {
            int times[SAMPLES] = {0};

            for (int i = 0; i < SAMPLES; i++)
                times[d.sample[e * SAMPLES + i]]++;
            for (int i = 0; i < SAMPLES; i++)
                CHECK(times[i] == 1, "batch %d: sample %d %d times", batch, i, times[i]);
        }
        kw_train_free(t);
    }
}

/* The order hangs on seed and epoch: not on the batch, and not on the epochs before. */
static void the_order_is_of_seed_and_epoch(void)
{
    diary a = {.lost = INFINITY, .target = ZERO}, b = a, c = a;
    kw_train_plan plan = plan_of(&a, 3, 4);
    double w[] = {1};
    int same = 0;
    kw_train *t;

    run(&plan, 0.1, w, &t);
    kw_train_free(t);
    plan.problem = &b;
    plan.batch = 7;
    run(&plan, 0.2, w, &t);
    kw_train_free(t);
    CHECK(memcmp(a.sample, b.sample, sizeof a.sample) == 0, "the order is another one");
    plan.problem = &c;
    plan.seed++;
    run(&plan, 0.1, w, &t);
    kw_train_free(t);
    CHECK(memcmp(a.sample, c.sample, sizeof a.sample) != 0, "the same for two seeds");
    for (int i = 0; i < SAMPLES; i++)
        same += a.sample[i] == a.sample[SAMPLES + i];
    CHECK(same < SAMPLES / 2, "%d places the same in two epochs", same);
}

/* Each of 4 samples comes first about as often: in 6000 epochs 1500 times with standard
   deviation sqrt(6000 3/16) = 33.5; six of these are 201. */
static void shuffling_is_fair(void)
{
    static diary d;
    int first[4] = {0};
    double w[] = {1};

    for (uint64_t seed = 0; seed < 6000; seed++) {
        kw_train_plan plan = plan_of(&d, 1, 1);
        kw_train *t;

        memset(&d, 0, sizeof d);
        d.lost = INFINITY;
        d.target = ZERO;
        plan.training = 4;
        plan.seed = seed;
        run(&plan, 0.1, w, &t);
        first[d.sample[0]]++;
        kw_train_free(t);
    }
    for (int i = 0; i < 4; i++)
        CHECK(abs(first[i] - 1500) <= 201, "sample %d first %d times", i, first[i]);
}

/* --- values --- */

/* All in one batch is plain descent, bit by bit; the history is the objective. */
static void one_batch_is_plain_descent(void)
{
    double target[SAMPLES], w[] = {3}, v = 3;
    diary d = {.lost = INFINITY}, e = d;
    kw_train_plan plan = plan_of(&d, 20, SAMPLES);
    kw_train *t;

    for (int i = 0; i < SAMPLES; i++)
        target[i] = i / 7.0;
    d.target = e.target = target;
    run(&plan, 0.3, w, &t);
    for (int epoch = 0; epoch <= 20; epoch++) {
        double slope, value = distance(&e, SAMPLES, FIRST, &v, &slope);

        CHECK(t->on_training[epoch] == value, "%g, not %g", t->on_training[epoch], value);
        CHECK(epoch == 0 || value < t->on_training[epoch - 1], "epoch %d rises", epoch);
        if (epoch < 20)
            v -= 0.3 * slope;
    }
    CHECK(w[0] == v, "%g, not %g", w[0], v);
    CHECK(t->epochs == 20 && t->best == 20, "%d, %d", t->epochs, t->best);
    kw_train_free(t);
}

/* A line through data by descent is the line of least squares: the slowest direction of the
   normal equations contracts by less than 0.8 a step, 0.8^400 < 1e-38. */
typedef struct line_data {
    double x[SAMPLES], y[SAMPLES];
} line_data;

static double line_error(void *problem, int count, const int *sample, const double *w,
                         double *dw)
{
    const line_data *d = problem;
    double sum = 0, slope[2] = {0, 0};

    for (int i = 0; i < count; i++) {
        double x = d->x[sample[i]], off = w[0] * x + w[1] - d->y[sample[i]];

        sum += off * off / count;
        slope[0] += 2 * off * x / count;
        slope[1] += 2 * off / count;
    }
    if (dw)
        memcpy(dw, slope, sizeof slope);
    return sum;
}

static void a_line_becomes_that_of_least_squares(void)
{
    line_data d;
    kw_train_plan plan = {.objective = line_error,
                          .problem = &d,
                          .parameters = 2,
                          .training = SAMPLES,
                          .training_sample = FIRST,
                          .epochs = 400,
                          .batch = SAMPLES};
    double A[SAMPLES * 2], B[SAMPLES], w[] = {0, 0};
    kw_rng r = kw_rng_at(75, 0, 0, 0);
    kw_train *t;

    for (int i = 0; i < SAMPLES; i++) {
        A[i * 2] = d.x[i] = (i - 11) / 8.0;
        A[i * 2 + 1] = 1;
        B[i] = d.y[i] = 0.5 * d.x[i] - 1 + test_random_in(&r, -0.1, 0.1);
    }
    kw_dense_least_squares(SAMPLES, 2, 1, A, B);
    run(&plan, 0.2, w, &t);
    CHECK(fabs(w[0] - B[0]) < 1e-12 && fabs(w[1] - B[1]) < 1e-12,
          "(%g, %g), not (%g, %g)", w[0], w[1], B[0], B[1]);
    kw_train_free(t);
}

/* --- early stopping --- */

/* Training pulls w to 8, in steps of a half; the validation sample sits at 3. */
enum { AWAY = SAMPLES, STEP_OF_BEST = 1 };

static void early_stopping_keeps_the_best(void)
{
    static const int away[] = {AWAY};
    double target[SAMPLES + 1];
    diary d = {.lost = INFINITY};
    kw_train_plan plan = plan_of(&d, 50, SAMPLES);

    for (int i = 0; i < SAMPLES; i++)
        target[i] = 8;
    target[AWAY] = 3;
    d.target = target;
    plan.validation = 1;
    plan.validation_sample = away;
    for (int patience = 0; patience <= 5; patience++) {
        double w[] = {0};
        kw_train *t;

        plan.patience = patience;
        d.calls = d.seen = 0;
        CHECK(run(&plan, 0.5, w, &t) == 0, "patience %d", patience);
        /* w = 0, 4, 6, 7: at a distance of 3, 1, 3, 4 from the validation sample */
        CHECK(t->best == STEP_OF_BEST && w[0] == 4, "best %d, w = %g", t->best, w[0]);
        CHECK(t->epochs == (patience > 0 ? STEP_OF_BEST + patience : 50), "%d epochs",
              t->epochs);
        CHECK(t->on_validation[0] == 4.5 && t->on_validation[1] == 0.5, "%g, %g",
              t->on_validation[0], t->on_validation[1]);
        CHECK(d.calls == t->epochs, "%d steps", d.calls);
        kw_train_free(t);
    }
}

/* The first of equal values is kept, also that before any step. */
static void the_first_of_equals_is_kept(void)
{
    static const int away[] = {AWAY};
    double target[SAMPLES + 1], w[] = {2};
    diary d = {.lost = INFINITY};
    kw_train_plan plan = plan_of(&d, 9, SAMPLES);
    kw_train *t;

    for (int i = 0; i < SAMPLES; i++)
        target[i] = 4;
    target[AWAY] = 3; /* w = 2 and w = 4 are equally far */
    d.target = target;
    plan.validation = 1;
    plan.validation_sample = away;
    run(&plan, 1, w, &t);
    CHECK(t->best == 0 && w[0] == 2, "best %d, w = %g", t->best, w[0]);
    kw_train_free(t);
}

/* --- a training that runs away --- */

static void a_lost_training_goes_back(void)
{
    diary d = {.lost = 100, .target = ZERO};
    kw_train_plan plan = plan_of(&d, 50, SAMPLES);
    double w[] = {1};
    kw_train *t;

    /* each step multiplies by -4: 1, -4, 16, -64, 256 */
    CHECK(run(&plan, 5, w, &t) == 1, "not lost");
    CHECK(t->epochs == 3 && t->best == 3 && w[0] == -64, "%d epochs, w = %g", t->epochs,
          w[0]);
    kw_train_free(t);

    w[0] = 101;
    CHECK(run(&plan, 5, w, &t) == 1, "not lost");
    CHECK(t->epochs == 0 && t->best == 0 && w[0] == 101, "%d epochs, w = %g", t->epochs,
          w[0]);
    kw_train_free(t);
}

/* In the middle of an epoch: w is as before it. */
static void lost_within_an_epoch(void)
{
    diary d = {.lost = 20, .target = ZERO};
    kw_train_plan plan = plan_of(&d, 50, 8); /* three steps an epoch */
    double w[] = {0.01};
    kw_train *t;

    CHECK(run(&plan, 8, w, &t) == 1, "not lost");
    /* each step multiplies by -7: 0.01 is -3.43 after an epoch, then 24.01 */
    CHECK(d.calls == 5, "%d steps begun", d.calls);
    CHECK(t->epochs == 1 && fabs(w[0] + 3.43) < 1e-14, "%d epochs, w = %g", t->epochs,
          w[0]);
    kw_train_free(t);
}

static void no_epochs_only_measure(void)
{
    diary d = {.lost = INFINITY, .target = ZERO};
    kw_train_plan plan = plan_of(&d, 0, 5);
    double w[] = {2};
    kw_train *t;

    CHECK(run(&plan, 1, w, &t) == 0, "lost");
    /* 2^2/2 in parts of 5, 5, 5, 5 and 3 of 23 samples: five products, four sums */
    CHECK(fabs(t->on_training[0] - 2) <= 2 * 10 * 0x1p-53 && w[0] == 2, "%.17g, w = %g",
          t->on_training[0], w[0]);
    CHECK(d.calls == 0, "%d steps", d.calls);
    kw_train_free(t);
    kw_train_free(NULL);
}

/* --- misuse --- */

static kw_train_plan bad; /* good but for one member */

static void make(void)
{
    kw_train_free(kw_train_new(&bad));
}

static void wrong_optimizer(void)
{
    kw_optimizer *o = kw_optimizer_new(KW_DESCENT, 2, 1);
    kw_train *t = kw_train_new(&bad);
    double w[] = {0, 0};

    kw_train_run(t, o, w);
}

static void misuse_aborts(void)
{
    static const int shared[] = {50, 7};
    diary d = {.lost = INFINITY, .target = ZERO};
    const kw_train_plan good = plan_of(&d, 1, 1);

    bad = good;
    test_aborts("the optimizer has 2 parameters, the plan 1", wrong_optimizer);
    bad.objective = NULL;
    test_aborts("no objective", make);
    bad = good;
    bad.training_sample = NULL;
    test_aborts("no list of training samples", make);
    bad = good;
    bad.validation = 2;
    test_aborts("no list of 2 validation samples", make);
    bad = good;
    bad.parameters = 0;
    test_aborts("0 parameters", make);
    bad = good;
    bad.training = 0;
    test_aborts("0 training samples", make);
    bad = good;
    bad.validation = -1;
    bad.validation_sample = shared;
    test_aborts("-1 validation samples", make);
    bad = good;
    bad.epochs = -2;
    test_aborts("-2 epochs", make);
    bad = good;
    bad.batch = 0;
    test_aborts("batches of 0", make);
    bad = good;
    bad.patience = 3;
    test_aborts("patience 3 with 0 validation samples", make);
    bad.validation = 2;
    bad.validation_sample = shared;
    test_aborts("sample 7 is in training and in validation", make);
}

int main(void)
{
    test_run("train: every sample once an epoch, in batches", every_sample_once_an_epoch);
    test_run("train: the order hangs on seed and epoch", the_order_is_of_seed_and_epoch);
    test_run("train: shuffling is fair", shuffling_is_fair);
    test_run("train: one batch is plain descent", one_batch_is_plain_descent);
    test_run("train: a line becomes that of least squares",
             a_line_becomes_that_of_least_squares);
    test_run("train: early stopping keeps the best", early_stopping_keeps_the_best);
    test_run("train: the first of equals is kept", the_first_of_equals_is_kept);
    test_run("train: a lost training goes back", a_lost_training_goes_back);
    test_run("train: lost within an epoch", lost_within_an_epoch);
    test_run("train: without epochs it only measures", no_epochs_only_measure);
    test_run("train: misuse aborts and names the value", misuse_aborts);
    return test_end();
}
