/* signals.h -- an adaptive mesh as a graph, and random signals on its cells. */
#ifndef SIGNALS_H
#define SIGNALS_H

#include "elementary.h"
#include "meshgraph.h"
#include "need.h"
#include "rng.h"
#include <stdlib.h>

enum { CELLS = 5, WAVES = 3 };

static const double NOISE = 0.9, PI = 3.14159265358979323846;

/* CELLS x CELLS cells of the unit square; from the cell (place, place) on, 3 x 3 are refined,
   and of these again 2 x 2. The caller frees. */
static inline kw_meshgraph *new_cells(int place)
{
    kw_bspline *s = kw_bspline_new_open_uniform(1, CELLS, 0, 1);
    const kw_bspline *both[2] = {s, s};
    kw_tensor *g = kw_tensor_new(2, both);
    kw_mesh *m = kw_mesh_new(g);
    kw_meshgraph *cells;

    for (int level = 0; level < 2; level++) {
        const int low[2] = {place << level, place << level};
        const int high[2] = {low[0] + 3 - level, low[1] + 3 - level};

        kw_mesh_refine(m, level, low, high);
    }
    cells = kw_meshgraph_new(m);
    kw_mesh_free(m);
    kw_tensor_free(g);
    kw_bspline_free(s);
    return cells;
}

/* The ends of a cell in direction h. */
static inline void cell_ends(const kw_meshgraph *g, int node, int h, double *low,
                             double *high)
{
    int place = g->cell[2 * node + h], all = CELLS << g->level[node];

    *low = (double)place / all;
    *high = (place + 1.0) / all;
}

/* Signal `sample` of a seed: clean[node], WAVES waves of at most two half periods a direction,
   in the middle of the cell; and noisy[node], with uniform noise in [-NOISE, NOISE]. */
static inline void make_signal(const kw_meshgraph *g, uint64_t seed, uint64_t sample,
                               double *clean, double *noisy)
{
    kw_rng r = kw_rng_at(seed, 0, sample, 0);
    double size[WAVES], phase[WAVES], k[WAVES], l[WAVES];

    for (int i = 0; i < WAVES; i++) {
        size[i] = 2 * kw_rng_uniform(&r) - 1;
        phase[i] = 2 * kw_rng_uniform(&r);
        k[i] = kw_rng_below(&r, 5) - 2;
        l[i] = kw_rng_below(&r, 5) - 2;
    }
    for (int node = 0; node < g->graph->n; node++) {
        double x_low, x_high, y_low, y_high;

        cell_ends(g, node, 0, &x_low, &x_high);
        cell_ends(g, node, 1, &y_low, &y_high);
        clean[node] = 0;
        for (int i = 0; i < WAVES; i++)
            clean[node] +=
                size[i] * kw_cos(PI * (k[i] * (x_low + x_high) / 2 +
                                       l[i] * (y_low + y_high) / 2 + phase[i]));
        noisy[node] = clean[node] + NOISE * (2 * kw_rng_uniform(&r) - 1);
    }
}

/* Pairs of a noisy and a clean signal, a row a pair. */
typedef struct signals {
    double *noisy, *clean;
} signals;

static inline signals signals_new(const kw_meshgraph *g, uint64_t seed, size_t pairs)
{
    size_t n = (size_t)g->graph->n;
    signals s = {kw_need_memory(pairs * n, sizeof(double)),
                 kw_need_memory(pairs * n, sizeof(double))};

    for (size_t i = 0; i < pairs; i++)
        make_signal(g, seed, i, s.clean + i * n, s.noisy + i * n);
    return s;
}

static inline void signals_free(signals *s)
{
    free(s->noisy);
    free(s->clean);
}

#endif
