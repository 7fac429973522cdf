/* unit.h -- the smallest thing that learns: one unit x = sigma(w p + b) with two parameters, its
   loss on four samples, and the methods that walk down. Without an activation the loss is a valley, a
   quadratic function; with tanh it has two minima. */
#ifndef UNIT_H
#define UNIT_H

#include "dense.h"
#include "eigen.h"
#include "mlp.h"
#include "need.h"
#include "optimizer.h"
#include "supervised.h"
#include <math.h>

enum { SAMPLES = 4, STEPS = 400, STARTS = 11, METHODS = 3 };

static const double P[SAMPLES] = {1, 1.5, 1.5, 4};
static const double TARGET[SAMPLES] = {0.25, -0.5, -0.75, -0.5};
static const double VALLEY_START[2] = {-0.5, 3}, HILLS_START[2] = {1, 1}; /* w and b */
static const double RATE[METHODS] = {0.1, 0.02, 0.1}; /* of descent, momentum, Adam */

/* The square that is looked at: w from LOW[0], b from LOW[1]. */
static const double LOW[2] = {-3, -1.5}, SIDE = 5;

typedef struct unit {
    kw_net *net;
    kw_supervised *data;
} unit;

static inline unit new_unit(kw_activation_kind sigma)
{
    unit u = {.net = kw_mlp_new(1, (const int[]){1, 1}, &sigma)};

    u.data = kw_supervised_new(u.net, kw_loss_squared, SAMPLES, P, TARGET, SAMPLES);
    return u;
}

static inline void free_unit(unit u)
{
    kw_supervised_free(u.data);
    kw_net_free(u.net);
}

/* The loss at w = (w, b), and its gradient (NULL: not wanted). */
static inline double loss(unit u, const double *w, double *dw)
{
    static const int all[SAMPLES] = {0, 1, 2, 3};

    return kw_supervised_mean(u.data, SAMPLES, all, w, dw);
}

/* --- the methods --- */

static inline void new_optimizers(kw_optimizer **o)
{
    for (int m = 0; m < METHODS; m++)
        o[m] = kw_optimizer_new((kw_method)m, 2, RATE[m]);
}

static inline void free_optimizers(kw_optimizer **o)
{
    for (int m = 0; m < METHODS; m++)
        kw_optimizer_free(o[m]);
}

/* Takes `steps` steps from w. */
static inline void walk(unit u, kw_optimizer *o, int steps, double *w)
{
    for (int i = 0; i < steps; i++) {
        double dw[2];

        loss(u, w, dw);
        kw_optimizer_step(o, dw, w);
    }
}

static inline double distance(const double *p, const double *q)
{
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
}

/* Start number i of STARTS^2, all over the square. */
static inline void start_at(int i, double *w)
{
    int column = i / STARTS, row = i % STARTS;

    w[0] = LOW[0] + SIDE * column / (STARTS - 1);
    w[1] = LOW[1] + SIDE * row / (STARTS - 1);
}

/* --- the valley --- */

typedef struct valley {
    double least, most,
        vector[4]; /* eigenvalues of the second derivatives, eigenvectors */
    double minimum[2];
} valley;

/* The gradient is affine, so its differences over a step of 1 are the second derivatives A,
   exactly on these samples. */
static inline valley survey(unit u)
{
    const double zero[2] = {0, 0};
    double g[2], A[4], copy[4], lambda[2];
    valley v;

    loss(u, zero, g);
    for (int j = 0; j < 2; j++) {
        const double e[2] = {j == 0, j == 1};
        double column[2];

        loss(u, e, column);
        for (int i = 0; i < 2; i++)
            A[2 * i + j] = copy[2 * i + j] = column[i] - g[i];
        v.minimum[j] = -g[j];
    }
    KW_NEED(kw_dense_solve(2, 1, copy, v.minimum) == 0, "gradient %g %g", g[0], g[1]);
    kw_eigen_symmetric(2, A, lambda, v.vector);
    v.least = lambda[0];
    v.most = lambda[1];
    return v;
}

/* The optimizers with the rates that make the largest factor by which an error decays the
   smallest; no such rate is known for Adam. [Polyak 1964] */
static inline void new_best_optimizers(const valley *v, kw_optimizer **o)
{
    double low = sqrt(v->least), high = sqrt(v->most);

    new_optimizers(o);
    o[KW_DESCENT]->rate = 2 / (v->least + v->most);
    o[KW_MOMENTUM]->rate = 4 / ((low + high) * (low + high));
    o[KW_MOMENTUM]->momentum =
        (high - low) / (high + low) * ((high - low) / (high + low));
}

#endif
