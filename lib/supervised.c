#include "supervised.h"
#include "need.h"
#include <stdlib.h>
#include <string.h>

kw_supervised *kw_supervised_new(const kw_net *net, kw_loss *loss, int count,
                                 const double *x, const double *target, int batch)
{
    kw_supervised *s = kw_need_memory(1, sizeof *s);
    const size_t rows = (size_t)batch, in = (size_t)net->in, out = (size_t)net->out;

    KW_NEED(count >= 1, "%d samples", count);
    KW_NEED(batch >= 1, "batches of %d", batch);
    s->net = net;
    s->loss = loss;
    s->count = count;
    s->x = x;
    s->target = target;
    s->batch = batch;
    s->work = kw_net_work_new(net, batch);
    s->batch_x = kw_need_memory(rows * in, sizeof(double));
    s->batch_target = kw_need_memory(rows * out, sizeof(double));
    s->y = kw_need_memory(rows * out, sizeof(double));
    s->dy = kw_need_memory(rows * out, sizeof(double));
    return s;
}

void kw_supervised_free(kw_supervised *s)
{
    if (!s)
        return;
    kw_net_work_free(s->work);
    free(s->batch_x);
    free(s->batch_target);
    free(s->y);
    free(s->dy);
    free(s);
}

double kw_supervised_mean(void *problem, int count, const int *sample, const double *w,
                          double *dw)
{
    kw_supervised *s = problem;
    const kw_net *n = s->net;
    const size_t in = (size_t)n->in, out = (size_t)n->out;
    double value;

    KW_NEED(1 <= count && count <= s->batch, "%d samples, not 1 .. %d", count, s->batch);
    for (size_t i = 0; i < (size_t)count; i++) {
        size_t from = (size_t)sample[i];

        KW_NEED(0 <= sample[i] && sample[i] < s->count, "sample %d, not 0 .. %d",
                sample[i], s->count - 1);
        memcpy(s->batch_x + i * in, s->x + from * in, in * sizeof(double));
        memcpy(s->batch_target + i * out, s->target + from * out, out * sizeof(double));
    }
    kw_net_forward(n, w, count, s->batch_x, s->work, s->y);
    value = s->loss(count, n->out, s->y, s->batch_target, dw ? s->dy : NULL);
    if (dw) {
        for (int i = 0; i < n->parameters; i++)
            dw[i] = 0;
        kw_net_backward(n, w, count, s->batch_x, s->y, s->dy, s->work, NULL, dw);
    }
    return value;
}
