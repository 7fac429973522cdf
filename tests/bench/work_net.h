/* work_net.h -- what is done with a net: forward, and backward to the derivatives with respect
   to all parameters. */
#ifndef WORK_NET_H
#define WORK_NET_H

#include "mlp.h"

enum { WORK_BATCH = 256, WORK_LAYERS = 3 };

typedef struct net_work {
    kw_net *n;
    kw_net_work *k;
    double *w, *dw, *x, *y, *dy;
} net_work;

/* width[0..WORK_LAYERS]; tanh in all layers but the last. */
net_work *net_work_new(const int *width);
void net_work_free(net_work *t);

/* WORK_BATCH samples */
void work_forward(void *with);
void work_step(void *with); /* forward and backward */

/* Multiply-adds of a step and a sample: each weight has one forward, one for its derivative,
   and one for the derivative that goes on to the layer before, unless that is the input. */
double net_multiply_adds(const net_work *t);

#endif
