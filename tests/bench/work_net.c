#include "work_net.h"
#include "need.h"
#include <stdlib.h>

static double *new_filled(int count)
{
    double *a = kw_need_memory((size_t)count, sizeof *a);

    for (int i = 0; i < count; i++)
        a[i] = 0.01 * (i % 100) - 0.5;
    return a;
}

net_work *net_work_new(const int *width)
{
    const kw_activation_kind sigma[WORK_LAYERS] = {KW_TANH, KW_TANH, KW_IDENTITY};
    net_work *t = kw_need_memory(1, sizeof *t);

    t->n = kw_mlp_new(WORK_LAYERS, width, sigma);
    t->k = kw_net_work_new(t->n, WORK_BATCH);
    t->w = new_filled(t->n->parameters);
    t->dw = new_filled(t->n->parameters);
    t->x = new_filled(WORK_BATCH * t->n->in);
    t->y = new_filled(WORK_BATCH * t->n->out);
    t->dy = new_filled(WORK_BATCH * t->n->out);
    kw_net_init(t->n, 1, t->w);
    return t;
}

void net_work_free(net_work *t)
{
    kw_net_work_free(t->k);
    kw_net_free(t->n);
    free(t->w);
    free(t->dw);
    free(t->x);
    free(t->y);
    free(t->dy);
    free(t);
}

void work_forward(void *with)
{
    const net_work *t = with;

    kw_net_forward(t->n, t->w, WORK_BATCH, t->x, t->k, t->y);
}

void work_step(void *with)
{
    const net_work *t = with;

    work_forward(with);
    kw_net_backward(t->n, t->w, WORK_BATCH, t->x, t->y, t->dy, t->k, NULL, t->dw);
}

double net_multiply_adds(const net_work *t)
{
    double sum = 0;

    for (int l = 1; l <= WORK_LAYERS; l++)
        sum += (l > 1 ? 3.0 : 2.0) * kw_mlp_count_weights(t->n, l);
    return sum;
}
