/* graphs.h -- what the tests of graphs share: random graphs, each with a table of its
   weights, and the graphs whose eigenvalues are known. */
#ifndef GRAPHS_H
#define GRAPHS_H

#include "graph.h"
#include "test.h"
#include <string.h>

enum { MOST = 12 }; /* nodes of a random graph */

/* A random graph of 2 .. MOST nodes: a pair is joined with a probability of 1/2 to 1/5, by an
   integer weight 1 .. 9; table[i*n + j] is the weight, or 0. Without `isolated`, each node is
   also joined with the one before. Edges come in random order and direction. The caller
   frees. */
static inline kw_graph *graphs_random(kw_rng *r, int isolated, double *table)
{
    int n = 2 + kw_rng_below(r, MOST - 1), rare = 2 + kw_rng_below(r, 4), edges = 0;
    int end[MOST * MOST] = {0};
    double weight[MOST * MOST / 2] = {0};

    memset(table, 0, MOST * MOST * sizeof *table);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            if (kw_rng_below(r, rare) == 0 || (!isolated && j == i - 1)) {
                int at = kw_rng_below(r, edges + 1), turn = kw_rng_below(r, 2);

                /* the edge takes the place `at`, and the one there goes to the end */
                end[2 * edges] = end[2 * at];
                end[2 * edges + 1] = end[2 * at + 1];
                weight[edges] = weight[at];
                end[2 * at] = turn ? i : j;
                end[2 * at + 1] = turn ? j : i;
                weight[at] = 1 + kw_rng_below(r, 9);
                table[i * n + j] = table[j * n + i] = weight[at];
                edges++;
            }
    return kw_graph_new(n, edges, end, weight);
}

/* A random permutation of 0 .. n-1. */
static inline void graphs_shuffle(kw_rng *r, int n, int *to)
{
    for (int i = 0; i < n; i++) {
        int at = kw_rng_below(r, i + 1);

        to[i] = i; /* if `at` is i, it stays there */
        to[i] = to[at];
        to[at] = i;
    }
}

/* 0 - 1 - .. - n-1; the same with the last one joined to the first (n >= 3); all pairs, n at
   most 2 MOST. */
static inline kw_graph *graphs_path(int n)
{
    int end[4 * MOST];

    for (int i = 0; i + 1 < n; i++) {
        end[2 * i] = i;
        end[2 * i + 1] = i + 1;
    }
    return kw_graph_new(n, n - 1, end, NULL);
}

static inline kw_graph *graphs_cycle(int n)
{
    int end[4 * MOST];

    for (int i = 0; i < n; i++) {
        end[2 * i] = i;
        end[2 * i + 1] = (i + 1) % n;
    }
    return kw_graph_new(n, n, end, NULL);
}

static inline kw_graph *graphs_complete(int n)
{
    int end[4 * MOST * MOST], edges = 0;

    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            end[2 * edges] = i;
            end[2 * edges++ + 1] = j;
        }
    return kw_graph_new(n, edges, end, NULL);
}

#endif
