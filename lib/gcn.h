/* gcn.h -- graph convolutions: layers on the signals of one graph.

   A sample is a signal X on the n nodes of a graph (graphmatrix.h), n x in_channels,
   row-major: a node a row; the layer makes of it a signal Y, n x out_channels. Every layer
   adds to its Y one bias for each channel of the output. They differ in what comes before:

     spatial      Y = X W_0 + M X W_1, M the mean over the neighbours: what a node is, and
                  what its neighbours are on average. [source text, section 1.2; GraphSAGE
                  with the mean: Hamilton, Ying, Leskovec: Inductive representation learning
                  on large graphs, 2017]
     spectral     Y = U V, row k of V is row k of U^T X times W_k, k = 0 .. n-1. The columns
                  of U are the eigenvectors of the normalized Laplacian, ascending: a free
                  coefficient for each frequency and each pair of channels. [Bruna, Zaremba,
                  Szlam, LeCun: Spectral networks and locally connected networks on graphs,
                  2014]
     Chebyshev    Y = sum of T_k(L - I) X W_k, k = 0 .. degree, where L is the normalized
                  Laplacian and T_k the Chebyshev polynomial. [Defferrard, Bresson,
                  Vandergheynst: Convolutional neural networks on graphs with fast localized
                  spectral filtering, 2016; they have 2 L / lambda_max - I; 2 bounds
                  lambda_max on every graph, so no eigenvalue is needed]
     first order  Y = S X W, S the renormalized adjacency. [Kipf, Welling: Semi-supervised
                  classification with graph convolutional networks, 2017]

   With T_0(S) = I and T_1(S) = S all of them but the spectral one are sums of T_k(S) X W_k
   over a range of k, and are computed so: time and memory follow the edges of the graph.

   Parameters: W_first .. W_last one after the other, each in_channels x out_channels,
   row-major; then the biases.

   A NaN is passed on to the nodes that see it. A layer has arrays for intermediate results;
   one layer cannot be in use twice at the same time. A graph with an isolated node has no
   spatial layer and no normalized Laplacian (graphmatrix.h); the first-order layer takes
   it. */
#ifndef KW_GCN_H
#define KW_GCN_H

#include "graph.h"
#include "graphmatrix.h"

typedef struct kw_gcn {
    int in, out, parameters; /* in = n in_channels, out = n out_channels */
    int n;                   /* nodes */
    int in_channels, out_channels;
    int first, last;   /* the weights are W_first .. W_last */
    kw_graphmatrix *S; /* in T_k(S); NULL in a spectral layer; owned, as all below */
    double *frequency; /* n eigenvalues, ascending; NULL in all other layers */
    double *vector; /* n x n, row k the eigenvector of frequency[k]: U^T; NULL likewise */
    double *work;   /* three signals of the larger number of channels */
} kw_gcn;

/* --- layers; the graph is not kept; the caller frees; never NULL; channels >= 1 --- */

kw_gcn *kw_gcn_new_spatial(const kw_graph *g, int in_channels, int out_channels);
kw_gcn *kw_gcn_new_spectral(const kw_graph *g, int in_channels, int out_channels);
kw_gcn *kw_gcn_new_chebyshev(const kw_graph *g, int in_channels, int out_channels,
                             int degree);
kw_gcn *kw_gcn_new_first_order(const kw_graph *g, int in_channels, int out_channels);

/* Frees l; NULL is fine. */
void kw_gcn_free(kw_gcn *l);

/* --- a batch of count >= 1 signals --- */

/* y, count x out, of x, count x in, under the parameters w. */
void kw_gcn_forward(const kw_gcn *l, const double *w, int count, const double *x,
                    double *y);

/* From dy, count x out, the derivative of a number with respect to y, those with respect to
   x: dx, count x in, set (NULL: not wanted); and to w: dw, l->parameters, ADDED to. y is not
   used.

   As (T_k(S) X)^T dY = X^T (T_k(S)^T dY), one recursion, run on dY with S transposed, serves
   both. */
void kw_gcn_backward(const kw_gcn *l, const double *w, int count, const double *x,
                     const double *y, const double *dy, double *dx, double *dw);

#endif
