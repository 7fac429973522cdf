/* graphmatrix.h -- the matrices of a graph, in compressed rows.

   With A the adjacency matrix (the weight of the edge between i and j, or 0) and D the
   diagonal matrix of the degrees:
     A                                adjacency
     D - A                            combinatorial Laplacian
     I - D^-1/2 A D^-1/2              normalized Laplacian, eigenvalues in [0,2]
     D^-1 A                           mean over the neighbours, rows add up to one
     (D+I)^-1/2 (A+I) (D+I)^-1/2      renormalized adjacency, eigenvalues in (-1,1]
   [Chung: Spectral Graph Theory, 1997, ch. 1; the last one Kipf, Welling: Semi-supervised
   classification with graph convolutional networks, 2017, (2)]

   A node without neighbours has neither a mean nor a normalized row: where D^-1 or D^-1/2
   enters, it is the caller's mistake (need.h). All but the mean are symmetric, bit by bit.

   A row holds the neighbours of its node and the node itself, even where the entry is zero.
   A signal x on the graph is n x channels, row-major: a node a row. */
#ifndef KW_GRAPHMATRIX_H
#define KW_GRAPHMATRIX_H

#include "graph.h"

typedef struct kw_graphmatrix {
    int n;         /* rows and columns */
    int *start;    /* n+1: the entries of row i are start[i] .. start[i+1]-1; owned */
    int *column;   /* start[n], ascending in each row, i itself among them; owned */
    double *value; /* start[n]; owned */
} kw_graphmatrix;

/* --- matrices; the caller frees them; never NULL --- */

kw_graphmatrix *kw_graphmatrix_new_adjacency(const kw_graph *g);
kw_graphmatrix *kw_graphmatrix_new_laplacian(const kw_graph *g);
kw_graphmatrix *kw_graphmatrix_new_normalized(const kw_graph *g);
kw_graphmatrix *kw_graphmatrix_new_mean(const kw_graph *g);
kw_graphmatrix *kw_graphmatrix_new_renormalized(const kw_graph *g);

/* Frees M; NULL is fine. */
void kw_graphmatrix_free(kw_graphmatrix *M);

/* --- using them --- */

/* Adds c to every diagonal entry. */
void kw_graphmatrix_shift(kw_graphmatrix *M, double c);

/* y = M x and y = M^T x, both n x channels; terms are added in ascending order of the nodes
   that they come from. */
void kw_graphmatrix_multiply(const kw_graphmatrix *M, int channels, const double *x,
                             double *y);
void kw_graphmatrix_multiply_transposed(const kw_graphmatrix *M, int channels,
                                        const double *x, double *y);

/* All entries, also those outside the rows' lists: dense, n x n. */
void kw_graphmatrix_dense(const kw_graphmatrix *M, double *dense);

#endif
