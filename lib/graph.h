/* graph.h -- undirected graphs with weighted edges.

   Conventions, stated here once:
     node       0 .. n-1, n >= 1
     edge       a pair of different nodes, at most once; its weight is positive and finite
     neighbour  node j is a neighbour of node i if an edge joins them
     hops       the number of edges on a shortest way from one node to another
   Every edge is stored at both of its ends, in compressed rows. The matrices of a graph are
   in graphmatrix.h. What an edge may not be, and an index or a point that is none, is the
   caller's mistake (need.h). */
#ifndef KW_GRAPH_H
#define KW_GRAPH_H

typedef struct kw_graph {
    int n;
    int *start; /* n+1: the neighbours of i are to[start[i]] .. to[start[i+1]-1]; owned */
    int *to;    /* start[n], twice the number of edges; ascending for each node; owned */
    double *weight; /* start[n]: the weight of the edge; owned */
} kw_graph;

/* --- graphs; the caller frees them; never NULL --- */

/* The graph of `edges` edges; edge e joins the nodes end[2e] and end[2e+1] with
   weight[e]; weight == NULL stands for all ones. */
kw_graph *kw_graph_new(int n, int edges, const int *end, const double *weight);

/* Joins each of n points x (n x D) with the k points nearest to it, 1 <= k < n, by edges of
   weight 1; of two at the same distance the one with the smaller index is the nearer. An
   edge joins i and j if either is among the k nearest of the other, so a node may have more
   than k neighbours. Takes time n^2. */
kw_graph *kw_graph_new_nearest(int n, int D, const double *x, int k);

/* The same graph again. */
kw_graph *kw_graph_new_copy(const kw_graph *g);

/* The same graph, its nodes renumbered: node i of g becomes node to[i], a permutation of
   0 .. n-1. */
kw_graph *kw_graph_new_renumbered(const kw_graph *g, const int *to);

/* Frees g; NULL is fine. */
void kw_graph_free(kw_graph *g);

/* --- asking --- */

/* degree[i], n of them: the sum of the weights of the edges at node i. */
void kw_graph_degrees(const kw_graph *g, double *degree);

/* hops[i], n of them: from node `from` to node i; -1 if there is no way. `work` has n
   numbers. [breadth-first search; Cormen, Leiserson, Rivest, Stein: Introduction to
   Algorithms, section 20.2] */
void kw_graph_hops(const kw_graph *g, int from, int *work, int *hops);

/* component[i], n of them: the number of the connected component of node i, counted from 0
   in the order of their first nodes. Returns how many there are. `work` has n numbers. */
int kw_graph_components(const kw_graph *g, int *work, int *component);

#endif
