/* cost.h -- what a value and a gradient of a net cost, in multiply-adds counted from the shapes.

   Counted is what a weight or an entry of a graph's matrix is multiplied with. Activations and
   pooling, which take each number once on either way, are left out. */
#ifndef COST_H
#define COST_H

#include "need.h"
#include "net.h"

/* Multiply-adds of one sample. */
typedef struct cost {
    double forward;
    double inputs, weights; /* on the way back: derivatives with respect to either */
} cost;

/* How many pairs of an output and a place of the filter there are along one direction, not
   counting those outside the grid. */
static inline double pairs(const kw_conv *l, int size, int filter, int outputs)
{
    int before = l->padding == KW_CONV_VALID ? 0 : (filter - 1) / 2, count = 0;

    for (int r = 0; r < outputs; r++)
        for (int a = 0; a < filter; a++) {
            int at = r * l->stride + a - before;

            count += l->padding == KW_CONV_CIRCULAR || (0 <= at && at < size);
        }
    return count;
}

static inline cost conv_cost(const kw_conv *l)
{
    double products = (double)l->in_channels * l->out_channels *
                      pairs(l, l->rows, l->filter_rows, l->out_rows) *
                      pairs(l, l->columns, l->filter_columns, l->out_columns);

    return (cost){products, products, products};
}

/* A product with S for each degree, and one with a matrix of weights for each term (gcn.h); on
   the way back the products with S serve inputs and weights. */
static inline cost gcn_cost(const kw_gcn *l)
{
    KW_NEED(l->S, "a spectral layer of %d nodes", l->n);
    double entries = l->S->start[l->n], terms = l->last - l->first + 1;
    double weights = terms * l->n * l->in_channels * l->out_channels;

    return (cost){l->last * entries * l->in_channels + weights, weights,
                  l->last * entries * l->out_channels + weights};
}

static inline cost layer_cost(const kw_layer *l)
{
    double products = (double)l->in * l->out;

    switch (l->kind) {
    case KW_LAYER_AFFINE:
        return (cost){products, products, products};
    case KW_LAYER_CONV:
        return conv_cost(&l->is.conv);
    case KW_LAYER_GCN:
        return gcn_cost(l->is.gcn);
    case KW_LAYER_ACTIVATION:
    case KW_LAYER_POOL:
        break;
    }
    return (cost){0, 0, 0};
}

/* The value of a net alone, and its gradient with respect to all parameters, the value being
   found on the way. The first layer needs no derivatives with respect to its inputs. */
typedef struct totals {
    double value, gradient;
} totals;

static inline totals net_cost(const kw_net *n)
{
    totals t = {0};

    for (int i = 0; i < n->layers; i++) {
        cost c = layer_cost(&n->layer[i]);

        t.value += c.forward;
        t.gradient += c.forward + c.weights + (i > 0 ? c.inputs : 0);
    }
    return t;
}

#endif
