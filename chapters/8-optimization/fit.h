/* fit.h -- one function, fitted to the same samples in two ways: by a spline with least squares
   and by a net that is trained. */
#ifndef FIT_H
#define FIT_H

#include "curve.h"
#include "dense.h"
#include "mlp.h"
#include "need.h"
#include "supervised.h"
#include "train.h"
#include <math.h>

enum {
    SAMPLES = 65,
    POINTS = 1000, /* between which and the samples the error is taken */
    MOST = 49,     /* parameters */
    PHASES = 3,    /* of a training; the rate of each is a quarter of that before */
    EPOCHS = 1500,  /* in each of them */
    BATCH = 33
};

static const double FIRST_RATE = 0.05;

/* The function of ex_runge, on [-1,1]. */
static inline double fitted(double x)
{
    return 1 / (1 + 25 * x * x);
}

/* Sample i of SAMPLES; point i of POINTS, the middle of one of as many equal cells. */
static inline double sample_at(int i)
{
    return -1 + 2.0 * i / (SAMPLES - 1);
}

static inline double point_at(int i)
{
    return -1 + (2.0 * i + 1) / POINTS;
}

/* The root of the mean of the squared errors of y, one for each point. */
static inline double error_of(const double *y)
{
    double sum = 0;

    for (int i = 0; i < POINTS; i++)
        sum += (y[i] - fitted(point_at(i))) * (y[i] - fitted(point_at(i)));
    return sqrt(sum / POINTS);
}

/* --- splines --- */

/* The spline of degree d with n <= MOST coefficients on equal cells that has the least squares,
   as values y at all points. The caller's s is of that dimension. */
static inline void fit_spline(const kw_bspline *s, double *y)
{
    double A[SAMPLES * MOST] = {0}, c[SAMPLES], value[KW_BSPLINE_DEGREE + 1];

    for (int i = 0; i < SAMPLES; i++) {
        int first = kw_bspline_basis(s, sample_at(i), value);

        for (int j = 0; j <= s->d; j++)
            A[i * s->n + first + j] = value[j];
        c[i] = fitted(sample_at(i));
    }
    KW_NEED(kw_dense_least_squares(SAMPLES, s->n, 1, A, c) == 0, "%d coefficients", s->n);
    for (int i = 0; i < POINTS; i++)
        kw_curve_point(s, 1, c, point_at(i), &y[i]);
}

/* --- nets --- */

/* 1-hidden-1, tanh, 3 hidden + 1 parameters. */
static inline kw_net *new_net(int hidden)
{
    static const kw_activation_kind sigma[] = {KW_TANH, KW_IDENTITY};

    return kw_mlp_new(2, (const int[]){1, hidden, 1}, sigma);
}

static inline void take_samples(double *x, double *target, int *sample)
{
    for (int i = 0; i < SAMPLES; i++) {
        x[i] = sample_at(i);
        target[i] = fitted(x[i]);
        sample[i] = i;
    }
}

/* Trains the net by Adam from the parameters of `seed`, which become w. */
static inline void train_net(const kw_net *net, uint64_t seed, double *w)
{
    double x[SAMPLES], target[SAMPLES], rate = FIRST_RATE;
    int sample[SAMPLES];
    kw_supervised *s;
    kw_optimizer *o = kw_optimizer_new(KW_ADAM, net->parameters, rate);
    kw_train_plan plan = {.objective = kw_supervised_mean,
                          .parameters = net->parameters,
                          .training = SAMPLES,
                          .training_sample = sample,
                          .epochs = EPOCHS,
                          .batch = BATCH};

    take_samples(x, target, sample);
    s = kw_supervised_new(net, kw_loss_squared, SAMPLES, x, target, BATCH);
    plan.problem = s;
    kw_net_init(net, seed, w);
    for (int phase = 0; phase < PHASES; phase++, rate /= 4) {
        kw_train *t;

        plan.seed = seed * PHASES + (uint64_t)phase;
        o->rate = rate;
        t = kw_train_new(&plan);
        KW_NEED(kw_train_run(t, o, w) == 0, "training with seed %d failed", (int)seed);
        kw_train_free(t);
    }
    kw_optimizer_free(o);
    kw_supervised_free(s);
}

/* The trained net's values y at all points. */
static inline void fit_net(const kw_net *net, uint64_t seed, double *y)
{
    double w[MOST], x[POINTS];
    kw_net_work *work = kw_net_work_new(net, POINTS);

    for (int i = 0; i < POINTS; i++)
        x[i] = point_at(i);
    train_net(net, seed, w);
    kw_net_forward(net, w, POINTS, x, work, y);
    kw_net_work_free(work);
}

#endif
