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

/* The edges into layer l, found by trial: there is one from unit j of layer l-1 to unit i of
   layer l if a change of the former changes the sum at the latter. edge[i * m_{l-1} + j] is
   set to 1 or 0 (NULL: not wanted). Returns how many there are. The trial sends a sample
   through the layer for each unit of layer l-1, and takes memory for a moment. */
int kw_mlp_edges(const kw_net *n, int l, int *edge);

/* The parameters of layer l that exist, by trial: its edges, a weight each; the units with a
   bias, those with a sum that is not zero when all that they receive is zero. */
int kw_mlp_count_weights(const kw_net *n, int l);
int kw_mlp_count_biases(const kw_net *n, int l);

/* #LP, their sum over all layers; the length of w is n->parameters. */
int kw_mlp_count(const kw_net *n);

#endif
