/* objective.h -- what is to be small, as a function of everything it depends on: parameters and
   inputs alike; its gradient by backpropagation, and central differences. */
#ifndef OBJECTIVE_H
#define OBJECTIVE_H

#include "loss.h"
#include "need.h"
#include "net.h"
#include "rng.h"

enum {
    COUNT = 4, /* samples of a batch */
    OUT = 32,  /* outputs at most */
    MOST = 256 /* parameters and inputs of a batch at most */
};

/* The mean loss of a net over a batch. */
typedef struct objective {
    const kw_net *net;
    kw_loss *loss;
    int numbers; /* parameters, then the inputs of the batch */
    double z[MOST], target[COUNT * OUT];
    kw_net_work *work;
} objective;

/* The value at z, and its gradient dz by backpropagation (NULL: not wanted). */
static inline double value(const objective *o, const double *z, double *dz)
{
    const kw_net *n = o->net;
    const double *x = z + n->parameters;
    double y[COUNT * OUT], dy[COUNT * OUT], at;

    kw_net_forward(n, z, COUNT, x, o->work, y);
    at = o->loss(COUNT, n->out, y, o->target, dy);
    if (dz) {
        for (int i = 0; i < n->parameters; i++)
            dz[i] = 0;
        kw_net_backward(n, z, COUNT, x, y, dy, o->work, dz + n->parameters, dz);
    }
    return at;
}

/* The central difference in number i. */
static inline double difference(const objective *o, int i, double h)
{
    double z[MOST], above;

    for (int k = 0; k < o->numbers; k++)
        z[k] = o->z[k];
    z[i] = o->z[i] + h;
    above = value(o, z, NULL);
    z[i] = o->z[i] - h;
    return (above - value(o, z, NULL)) / (2 * h);
}

/* --- its data --- */

/* An odd multiple of 1/8, between -15/8 and 15/8. */
static inline double eighths(kw_rng *r)
{
    return (2 * kw_rng_below(r, 16) - 15) / 8.0;
}

/* All odd multiples of 1/8 from (1-n)/8 to (n-1)/8 in random order; n is even. */
static inline void shuffled_eighths(kw_rng *r, int n, double *x)
{
    for (int i = 0; i < n; i++) {
        int at = kw_rng_below(r, i + 1);

        x[i] = x[at];
        x[at] = (2 * i - n + 1) / 8.0;
    }
}

/* What the loss takes: numbers, the probabilities of one class, or signs. */
static inline void random_targets(kw_rng *r, objective *o)
{
    const int classes = o->loss == kw_loss_cross_entropy, out = o->net->out;

    for (int i = 0; i < COUNT * out; i++)
        o->target[i] = o->loss == kw_loss_squared ? eighths(r)
                       : classes                  ? 0
                                                  : 2 * kw_rng_below(r, 2) - 1;
    for (int s = 0; s < COUNT && classes; s++)
        o->target[s * out + kw_rng_below(r, out)] = 1;
}

static inline objective new_objective(const kw_net *net, kw_loss *loss, uint64_t seed)
{
    kw_rng r = kw_rng_at(80, 0, seed, 0);
    objective o = {.net = net, .loss = loss, .work = kw_net_work_new(net, COUNT)};

    o.numbers = net->parameters + COUNT * net->in;
    KW_NEED(o.numbers <= MOST && net->out <= OUT, "%d numbers, %d outputs", o.numbers,
            net->out);
    for (int i = 0; i < net->parameters; i++)
        o.z[i] = eighths(&r);
    for (int s = 0; s < COUNT; s++)
        shuffled_eighths(&r, net->in, o.z + net->parameters + s * net->in);
    random_targets(&r, &o);
    return o;
}

#endif
