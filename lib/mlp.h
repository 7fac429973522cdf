/* mlp.h -- multi-layer perceptrons: fully connected nets.

   Layers 0 .. L have m_0 .. m_L units; layer 0 is the input. Layer l = 1 .. L has the
   weights W^(l), m_l x m_{l-1}, the biases b^(l), m_l of them, and the activation sigma_l.
   (The book's Definition 10 has no sigma_L: say KW_IDENTITY. Its perceptron (21) is L = 1
   with KW_SIGN.) [source text, Definitions 9 and 10] */
#ifndef KW_MLP_H
#define KW_MLP_H

#include "net.h"

/* width[0..L] are m_0 .. m_L, all >= 1; sigma[0..L-1] are sigma_1 .. sigma_L; L >= 1. The net
   has an affine layer for each l and an activation layer for each that is not the identity.
   The caller frees it with kw_net_free. */
kw_net *kw_mlp_new(int L, const int *width, const kw_activation_kind *sigma);

/* L of such a net. */
int kw_mlp_depth(const kw_net *n);

/* The affine map of layer l = 1 .. L: W^(l) stands in w from `first` on, b^(l) behind it. */
const kw_affine *kw_mlp_affine(const kw_net *n, int l, int *first);

/* The parameters of layer l that exist, counted one by one along the graph: the edges from
   the units of layer l-1 to those of layer l, a weight each; the units with a bias. */
int kw_mlp_count_weights(const kw_net *n, int l);
int kw_mlp_count_biases(const kw_net *n, int l);

/* #LP, their sum over all layers. */
int kw_mlp_count(const kw_net *n);

#endif
