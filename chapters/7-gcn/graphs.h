/* graphs.h -- what the drivers of this lesson share: a few graphs, and graphs as pictures. */
#ifndef GRAPHS_H
#define GRAPHS_H

#include "eigen.h"
#include "graph.h"
#include "graphmatrix.h"
#include "need.h"
#include "out.h"
#include "rng.h"
#include <stdlib.h>

/* n nodes in a circle, each joined with the next; the caller frees. */
static inline kw_graph *new_cycle(int n)
{
    int *end = kw_need_memory(2 * (size_t)n, sizeof *end);
    kw_graph *g;

    for (int i = 0; i < n; i++) {
        end[2 * i] = i;
        end[2 * i + 1] = (i + 1) % n;
    }
    g = kw_graph_new(n, n, end, NULL);
    free(end);
    return g;
}

/* The sweeps (eigen.h) for the eigenvectors of the normalized Laplacian, as in a spectral
   layer. */
static inline int count_sweeps(const kw_graph *g)
{
    const size_t n = (size_t)g->n;
    kw_graphmatrix *L = kw_graphmatrix_new_normalized(g);
    double *dense = kw_need_memory(n * n, sizeof *dense);
    double *value = kw_need_memory(n, sizeof *value);
    double *vector = kw_need_memory(n * n, sizeof *vector);
    int sweeps;

    kw_graphmatrix_dense(L, dense);
    sweeps = kw_eigen_symmetric(g->n, dense, value, vector);
    kw_graphmatrix_free(L);
    free(dense);
    free(value);
    free(vector);
    return sweeps;
}

/* x, n x 2: points of the unit square that keep away from each other, each of them the one of
   40 random points that is the farthest from all before it. */
static inline void scatter(uint64_t seed, uint64_t sample, int n, double *x)
{
    kw_rng r = kw_rng_at(seed, 0, sample, 0);

    for (int i = 0; i < n; i++) {
        double best = -1;

        for (int trial = 0; trial < 40; trial++) {
            double p = kw_rng_uniform(&r), q = kw_rng_uniform(&r), least = 2;

            for (int j = 0; j < i; j++) {
                double dx = p - x[2 * j], dy = q - x[2 * j + 1];

                if (dx * dx + dy * dy < least)
                    least = dx * dx + dy * dy;
            }
            if (least > best) {
                best = least;
                x[2 * i] = p;
                x[2 * i + 1] = q;
            }
        }
    }
}

/* A random permutation of 0 .. n-1. */
static inline void shuffle(kw_rng *r, int n, int *to)
{
    for (int i = 0; i < n; i++) {
        int at = kw_rng_below(r, i + 1);

        to[i] = i; /* if `at` is i, it stays there */
        to[i] = to[at];
        to[at] = i;
    }
}

/* The section `name` with the edges as lines between the nodes' places x, n x 2. */
static inline void write_edges(kw_out *f, const char *name, const kw_graph *g,
                               const double *x)
{
    kw_out_section(f, name, "x y");
    for (int i = 0; i < g->n; i++)
        for (int e = g->start[i]; e < g->start[i + 1]; e++) {
            const int end[2] = {i, g->to[e]};

            if (end[1] < i)
                continue;
            for (int q = 0; q < 2; q++) {
                kw_out_number(f, x[2 * end[q]]);
                kw_out_number(f, x[2 * end[q] + 1]);
                kw_out_row(f);
            }
            kw_out_gap(f);
        }
}

/* The section `name` with a row a node: its place and a value. */
static inline void write_nodes(kw_out *f, const char *name, int n, const double *x,
                               const double *value)
{
    kw_out_section(f, name, "x y value");
    for (int i = 0; i < n; i++) {
        kw_out_number(f, x[2 * i]);
        kw_out_number(f, x[2 * i + 1]);
        kw_out_number(f, value[i]);
        kw_out_row(f);
    }
}

#endif
