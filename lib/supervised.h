/* supervised.h -- supervised learning: a net, a loss, and samples with targets, as the
   objective of a training (train.h). */
#ifndef KW_SUPERVISED_H
#define KW_SUPERVISED_H

#include "loss.h"
#include "net.h"

typedef struct kw_supervised {
    /* the caller's; they outlive this */
    const kw_net *net;
    kw_loss *loss;
    int count;            /* samples, numbered 0 .. count-1 */
    const double *x;      /* count x in */
    const double *target; /* count x out, as the loss wants them */
    /* memory for the samples of one batch; owned */
    int batch; /* at most so many */
    kw_net_work *work;
    double *batch_x, *batch_target, *y, *dy;
} kw_supervised;

/* count, batch >= 1 */
kw_supervised *kw_supervised_new(const kw_net *net, kw_loss *loss, int count,
                                 const double *x, const double *target, int batch);
void kw_supervised_free(kw_supervised *s);

/* A kw_objective of train.h, `problem` being a kw_supervised: the mean loss of the net over
   these samples, 1 <= count <= batch, and its gradient dw (NULL: not wanted). */
double kw_supervised_mean(void *problem, int count, const int *sample, const double *w,
                          double *dw);

#endif
