#include "net.h"
#include "need.h"
#include "rng.h"
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* --- building --- */

kw_net *kw_net_new(int in)
{
    kw_net *n = kw_need_memory(1, sizeof *n);

    KW_NEED(in >= 1, "in = %d", in);
    n->in = n->out = in;
    return n;
}

void kw_net_free(kw_net *n)
{
    if (!n)
        return;
    free(n->layer);
    free(n);
}

static void append(kw_net *n, kw_layer l)
{
    kw_layer *longer = kw_need_memory((size_t)n->layers + 1, sizeof *longer);

    KW_NEED(l.in == n->out, "layer %d takes %d numbers, but there are %d", n->layers,
            l.in, n->out);
    KW_NEED(l.parameters <= INT_MAX - n->parameters, "%d and %d parameters, more than %d",
            n->parameters, l.parameters, INT_MAX);
    for (int i = 0; i < n->layers; i++)
        longer[i] = n->layer[i];
    free(n->layer);
    n->layer = longer;
    l.first = n->parameters;
    n->layer[n->layers++] = l;
    n->parameters += l.parameters;
    n->out = l.out;
}

void kw_net_add_affine(kw_net *n, int out)
{
    kw_affine l = kw_affine_layer(n->out, out);

    append(n, (kw_layer){.kind = KW_LAYER_AFFINE,
                         .in = l.in,
                         .out = l.out,
                         .parameters = l.parameters,
                         .is.affine = l});
}

void kw_net_add_activation(kw_net *n, kw_activation_kind kind)
{
    kw_activation l = kw_activation_layer(kind, n->out);

    append(n, (kw_layer){.kind = KW_LAYER_ACTIVATION,
                         .in = l.in,
                         .out = l.out,
                         .is.activation = l});
}

void kw_net_add_conv(kw_net *n, const kw_conv *l)
{
    append(n, (kw_layer){.kind = KW_LAYER_CONV,
                         .in = l->in,
                         .out = l->out,
                         .parameters = l->parameters,
                         .is.conv = *l});
}

void kw_net_add_pool(kw_net *n, const kw_pool *l)
{
    append(n,
           (kw_layer){.kind = KW_LAYER_POOL, .in = l->in, .out = l->out, .is.pool = *l});
}

void kw_net_add_gcn(kw_net *n, const kw_gcn *l)
{
    append(n, (kw_layer){.kind = KW_LAYER_GCN,
                         .in = l->in,
                         .out = l->out,
                         .parameters = l->parameters,
                         .is.gcn = l});
}

/* --- parameters --- */

/* How many numbers a unit takes, how many take what a unit gives; the biases. */
typedef struct meeting {
    double takes, gives;
    int biases;
} meeting;

static meeting meeting_at(const kw_layer *l)
{
    const kw_conv *c = &l->is.conv;
    const kw_gcn *g = l->is.gcn;
    double many;

    switch (l->kind) {
    case KW_LAYER_AFFINE:
        return (meeting){l->in, l->out, l->out};
    case KW_LAYER_CONV:
        many = (double)c->filter_rows * c->filter_columns;
        return (meeting){c->in_channels * many, c->out_channels * many, c->out_channels};
    case KW_LAYER_GCN:
        /* W_first .. W_last meet at a node, but each frequency has its own */
        many = g->S ? g->last - g->first + 1 : 1;
        return (meeting){g->in_channels * many, g->out_channels * many, g->out_channels};
    case KW_LAYER_ACTIVATION:
    case KW_LAYER_POOL:
        break;
    }
    return (meeting){1, 1, 0};
}

void kw_net_init(const kw_net *n, uint64_t seed, double *w)
{
    for (int i = 0; i < n->layers; i++) {
        const kw_layer *l = &n->layer[i];
        meeting m = meeting_at(l);
        double a = sqrt(6 / (m.takes + m.gives));
        kw_rng r = kw_rng_at(seed, 0, (uint64_t)i, 0);

        for (int j = 0; j < l->parameters; j++)
            w[l->first + j] =
                j < l->parameters - m.biases ? a * (2 * kw_rng_uniform(&r) - 1) : 0;
    }
}

/* --- forward and backward --- */

kw_net_work *kw_net_work_new(const kw_net *n, int count)
{
    kw_net_work *k = kw_need_memory(1, sizeof *k);
    size_t widest = 0;

    KW_NEED(n->layers >= 1, "%d layers", n->layers);
    KW_NEED(count >= 1, "%d samples", count);
    k->layers = n->layers;
    k->count = count;
    k->out = kw_need_memory((size_t)n->layers, sizeof *k->out);
    for (int l = 0; l < n->layers; l++)
        k->out[l] = n->layer[l].out;
    k->value = kw_need_memory((size_t)n->layers, sizeof(double *));
    for (int l = 0; l + 1 < n->layers; l++) {
        size_t size = (size_t)count * (size_t)n->layer[l].out;

        k->value[l] = kw_need_numbers(size);
        widest = size > widest ? size : widest;
    }
    for (int i = 0; i < 2; i++)
        k->derivative[i] = kw_need_numbers(widest);
    return k;
}

void kw_net_work_free(kw_net_work *k)
{
    if (!k)
        return;
    for (int l = 0; l < k->layers; l++)
        free(k->value[l]);
    free(k->value);
    free(k->out);
    free(k->derivative[0]);
    free(k->derivative[1]);
    free(k);
}

static void need_memory_for(const kw_net_work *k, const kw_net *n)
{
    KW_NEED(n->layers == k->layers, "%d layers, memory for %d", n->layers, k->layers);
    for (int l = 0; l < n->layers; l++)
        KW_NEED(n->layer[l].out == k->out[l], "layer %d gives %d numbers, memory for %d",
                l, n->layer[l].out, k->out[l]);
}

static void layer_forward(const kw_layer *l, const double *w, int count, const double *x,
                          double *y)
{
    switch (l->kind) {
    case KW_LAYER_AFFINE:
        kw_affine_forward(&l->is.affine, w + l->first, count, x, y);
        break;
    case KW_LAYER_ACTIVATION:
        kw_activation_forward(&l->is.activation, NULL, count, x, y);
        break;
    case KW_LAYER_CONV:
        kw_conv_forward(&l->is.conv, w + l->first, count, x, y);
        break;
    case KW_LAYER_POOL:
        kw_pool_forward(&l->is.pool, NULL, count, x, y);
        break;
    case KW_LAYER_GCN:
        kw_gcn_forward(l->is.gcn, w + l->first, count, x, y);
        break;
    }
}

static void layer_backward(const kw_layer *l, const double *w, int count, const double *x,
                           const double *y, const double *dy, double *dx, double *dw)
{
    int first = l->first;

    switch (l->kind) {
    case KW_LAYER_AFFINE:
        kw_affine_backward(&l->is.affine, w + first, count, x, y, dy, dx, dw + first);
        break;
    case KW_LAYER_ACTIVATION:
        kw_activation_backward(&l->is.activation, NULL, count, x, y, dy, dx, NULL);
        break;
    case KW_LAYER_CONV:
        kw_conv_backward(&l->is.conv, w + first, count, x, y, dy, dx, dw + first);
        break;
    case KW_LAYER_POOL:
        kw_pool_backward(&l->is.pool, NULL, count, x, y, dy, dx, NULL);
        break;
    case KW_LAYER_GCN:
        kw_gcn_backward(l->is.gcn, w + first, count, x, y, dy, dx, dw + first);
        break;
    }
}

void kw_net_forward(const kw_net *n, const double *w, int count, const double *x,
                    kw_net_work *k, double *y)
{
    const double *from = x;

    need_memory_for(k, n);
    KW_NEED(1 <= count && count <= k->count, "%d samples, not in 1 .. %d", count,
            k->count);
    for (int s = 0; s < count; s++)
        for (int i = 0; i < n->in; i++) {
            double number = x[(size_t)s * (size_t)n->in + (size_t)i];

            KW_NEED(isfinite(number), "input %d of sample %d is %g", i, s, number);
        }
    for (int l = 0; l < n->layers; l++) {
        double *to = l + 1 < n->layers ? k->value[l] : y;

        layer_forward(&n->layer[l], w, count, from, to);
        from = to;
    }
    k->used = count;
}

void kw_net_backward(const kw_net *n, const double *w, int count, const double *x,
                     const double *y, const double *dy, kw_net_work *k, double *dx,
                     double *dw)
{
    const double *from = dy; /* with respect to what layer l gives */

    need_memory_for(k, n);
    KW_NEED(count == k->used, "%d samples back, %d forward", count, k->used);
    for (int l = n->layers - 1; l >= 0; l--) {
        const double *given = l + 1 < n->layers ? k->value[l] : y;
        const double *taken = l > 0 ? k->value[l - 1] : x;
        double *to = l > 0 ? k->derivative[l % 2] : dx;

        layer_backward(&n->layer[l], w, count, taken, given, from, to, dw);
        from = to;
    }
}
