/* net.h -- a chain of layers, each fed by the one before.

   The chain is the directed acyclic graph of Definition 7 in which every vertex has one edge
   in and one out. [source text, Definition 7] Layers are those of affine.h, activation.h,
   conv.h, pool.h and gcn.h. All parameters are one array w of the caller, those of a layer
   behind those of the layer before it. Samples are rows: x is count x in, y count x out.

     kw_net *n = kw_net_new(2);
     kw_net_add_affine(n, 64);
     kw_net_add_activation(n, KW_TANH);
     kw_net_add_affine(n, 1); */
#ifndef KW_NET_H
#define KW_NET_H

#include "activation.h"
#include "affine.h"
#include "conv.h"
#include "gcn.h"
#include "pool.h"
#include <stdint.h>

typedef enum kw_layer_kind {
    KW_LAYER_AFFINE,
    KW_LAYER_ACTIVATION,
    KW_LAYER_CONV,
    KW_LAYER_POOL,
    KW_LAYER_GCN
} kw_layer_kind;

typedef struct kw_layer {
    kw_layer_kind kind;
    int in, out, parameters;
    int first; /* where its parameters begin in w */
    union {
        kw_affine affine;
        kw_activation activation;
        kw_conv conv;
        kw_pool pool;
        const kw_gcn *gcn; /* the caller's */
    } is;
} kw_layer;

typedef struct kw_net {
    int in, out;     /* of the first layer and of the last */
    int parameters;  /* of all layers */
    int layers;      /* how many */
    kw_layer *layer; /* owned */
} kw_net;

/* --- building; the caller frees; never NULL --- */

/* No layer yet: out = in >= 1. */
kw_net *kw_net_new(int in);
void kw_net_free(kw_net *n);

/* Appends a layer. Affine and activation layers fit what is there; the others must take as
   many numbers as there are, n->out. A graph layer stays the caller's and outlives the net.
   What feeds a convolution or a graph layer is read in their order: channel, row, column;
   node, channel. */
void kw_net_add_affine(kw_net *n, int out);
void kw_net_add_activation(kw_net *n, kw_activation_kind kind);
void kw_net_add_conv(kw_net *n, const kw_conv *l);
void kw_net_add_pool(kw_net *n, const kw_pool *l);
void kw_net_add_gcn(kw_net *n, const kw_gcn *l);

/* --- parameters --- */

/* Fills w: biases 0, weights uniform in [-a, a) with a = sqrt(6 / (i + o)), where i is how many
   numbers a unit of the layer takes and o how many take what a unit gives. The numbers of
   layer l depend on (seed, l) alone.
   [Glorot, Bengio: Understanding the difficulty of training deep feedforward neural
   networks, 2010, (16)] */
void kw_net_init(const kw_net *n, uint64_t seed, double *w);

/* --- forward and backward --- */

/* Memory for what lies between the layers, for batches of at most `count` samples. The net
   is complete. */
typedef struct kw_net_work {
    int layers, count;
    int *out;              /* of each layer; owned */
    int used;              /* samples that were last sent forward */
    double **value;        /* value[l]: what layer l gives, all but the last; owned */
    double *derivative[2]; /* with respect to what two neighbouring layers give; owned */
} kw_net_work;

kw_net_work *kw_net_work_new(const kw_net *n, int count);
void kw_net_work_free(kw_net_work *k);

/* y of the samples x, which are finite. The net has a layer; 1 <= count <= k->count. k was
   made for this net or for one whose layers give as many numbers each. */
void kw_net_forward(const kw_net *n, const double *w, int count, const double *x,
                    kw_net_work *k, double *y);

/* From dy, count x out, the derivative of a number with respect to y, to those with respect
   to x and w: dx, count x in, is set (NULL: not wanted); to dw, n->parameters, it is added.
   w, x, y and k are as kw_net_forward left them. [Rumelhart, Hinton, Williams: Learning
   representations by back-propagating errors, 1986] */
void kw_net_backward(const kw_net *n, const double *w, int count, const double *x,
                     const double *y, const double *dy, kw_net_work *k, double *dx,
                     double *dw);

#endif
