/* gen graph -- random geometric graphs with signals and labels at their nodes. */
#include "draw.h"
#include "elementary.h"
#include "graph.h"
#include "need.h"
#include "set.h"
#include <stdlib.h>

/* In the order of the parameters and of the arrays. */
enum { NODES_OF, RADIUS, WAVES, NOISE };
enum { COUNTS, NODES, LABELS, EDGES, WAVE };
enum { MOST_NODES = 4096 };

/* Purposes of random numbers. */
enum { HOW_MANY, WHERE, WHICH_WAVES, WHICH_NOISE };

typedef struct work {
    double *x, *clean, *noisy; /* 2, 1 and 1 a node */
    int *end, *component, *queue;
    int room; /* edges that `end` has room for */
} work;

static void plan(const gen_call *c, gen_plan *p)
{
    const int nodes = c->low[NODES_OF] == c->high[NODES_OF] ? gen_whole(c, NODES_OF) : 0;

    gen_plan_add_integers(p, "counts", 1, "nodes labels edges components",
                          "rows of the other arrays, and connected components");
    gen_plan_add(p, "nodes", nodes, "x y signal noisy_signal",
                 "places in the unit square, the signal there, the same with noise");
    gen_plan_add_integers(
        p, "labels", nodes, "label component",
        "1 where the signal is positive, else 0; the connected component");
    gen_plan_add_integers(p, "edges", 0, "from to",
                          "pairs of nodes nearer than the radius, each once, from < to");
    gen_plan_add(
        p, "waves", gen_whole(c, WAVES), "frequency_x frequency_y phase amplitude",
        "the signal is the sum of amplitude sin(2 pi (frequency (x,y) + phase))");
}

static void *work_new(const gen_call *c)
{
    const size_t most = (size_t)c->high[NODES_OF];
    work *w = kw_need_memory(1, sizeof *w);

    w->x = kw_need_memory(2 * most, sizeof *w->x);
    w->clean = kw_need_memory(most, sizeof *w->clean);
    w->noisy = kw_need_memory(most, sizeof *w->noisy);
    w->component = kw_need_memory(most, sizeof *w->component);
    w->queue = kw_need_memory(most, sizeof *w->queue);
    w->room = (int)most;
    w->end = kw_need_memory(2 * most, sizeof *w->end);
    return w;
}

static void work_free(void *work_of)
{
    work *w = work_of;

    free(w->x);
    free(w->clean);
    free(w->noisy);
    free(w->component);
    free(w->queue);
    free(w->end);
    free(w);
}

/* --- edges --- */

static void put_edge(work *w, int edges, int i, int j)
{
    if (edges == w->room) {
        int *more = kw_need_memory((size_t)w->room * 4, sizeof *more);

        for (int k = 0; k < 2 * edges; k++)
            more[k] = w->end[k];
        free(w->end);
        w->end = more;
        w->room *= 2;
    }
    w->end[2 * edges] = i;
    w->end[2 * edges + 1] = j;
}

/* All pairs nearer than the radius. */
static int join(work *w, int n, double radius)
{
    int edges = 0;

    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            double x = w->x[2 * i] - w->x[2 * j], y = w->x[2 * i + 1] - w->x[2 * j + 1];

            if (x * x + y * y < radius * radius)
                put_edge(w, edges++, i, j);
        }
    return edges;
}

static int find_components(work *w, int n, int edges)
{
    kw_graph *g = kw_graph_new(n, edges, w->end, NULL);
    int components = kw_graph_components(g, w->queue, w->component);

    kw_graph_free(g);
    return components;
}

/* --- signals --- */

static void make_waves(const gen_call *c, gen_sample *s)
{
    const int waves = gen_whole(c, WAVES);
    double *row = gen_rows(s, WAVE, waves);
    kw_rng r = gen_rng(c, s, WHICH_WAVES);

    for (int k = 0; k < waves; k++, row += 4) {
        gen_draw_uniform(&r, -2, 2, 2, row);
        row[2] = kw_rng_uniform(&r);
        row[3] = 1.0 / waves;
    }
}

static double signal_at(const double *row, int waves, const double *x)
{
    const double pi = 0x1.921fb54442d18p+1;
    double sum = 0;

    for (int k = 0; k < waves; k++, row += 4)
        sum += row[3] * kw_sin(2 * pi * (row[0] * x[0] + row[1] * x[1] + row[2]));
    return sum;
}

/* --- samples --- */

static void fill_nodes(gen_sample *s, const work *w, int n)
{
    double *node = gen_rows(s, NODES, n), *label = gen_rows(s, LABELS, n);

    for (int i = 0; i < n; i++, node += 4, label += 2) {
        node[0] = w->x[2 * i];
        node[1] = w->x[2 * i + 1];
        node[2] = w->clean[i];
        node[3] = w->noisy[i];
        label[0] = w->clean[i] > 0;
        label[1] = w->component[i];
    }
}

static void make(const gen_call *c, void *work_of, gen_sample *s)
{
    const int waves = gen_whole(c, WAVES);
    work *w = work_of;
    kw_rng r = gen_rng(c, s, HOW_MANY), where = gen_rng(c, s, WHERE);
    kw_rng noise = gen_rng(c, s, WHICH_NOISE);
    const int n = gen_draw(c, NODES_OF, &r);
    double *counts = gen_rows(s, COUNTS, 1), *row;
    int edges;

    gen_draw_uniform(&where, 0, 1, 2 * n, w->x);
    make_waves(c, s);
    for (int i = 0; i < n; i++)
        w->clean[i] = signal_at(s->value[WAVE], waves, w->x + 2 * i);
    gen_draw_noise(&noise, c->low[NOISE], n, w->clean, w->noisy);
    edges = join(w, n, c->low[RADIUS]);
    counts[0] = counts[1] = n;
    counts[2] = edges;
    counts[3] = find_components(w, n, edges);
    fill_nodes(s, w, n);
    row = gen_rows(s, EDGES, edges);
    for (int k = 0; k < 2 * edges; k++)
        row[k] = w->end[k];
}

const gen_family gen_graph = {
    .name = "graph",
    .summary = "random geometric graphs with signals and labels at their nodes",
    .about = "A sample is a random geometric graph: nodes uniform in the unit square, an "
             "edge between\n"
             "any two that are nearer than the radius. Each node has a signal, a sum of "
             "plane waves,\n"
             "exact and with normal noise, and a label, which says where the exact "
             "signal is positive.\n",
    .example = "--nodes 20-40 --radius 0.3",
    .stream = 5,
    .parameter =
        {
            [NODES_OF] = {"--nodes", GEN_RANGE, "100", 1, MOST_NODES, NULL, "nodes"},
            [RADIUS] = {"--radius", GEN_REAL, "0.15", 0, 2, NULL, "of the neighbourhood"},
            [WAVES] = {"--waves", GEN_WHOLE, "3", 1, 20, NULL, "in the signal"},
            [NOISE] = {"--noise", GEN_REAL, "0.1", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .plan = plan,
    .work_new = work_new,
    .work_free = work_free,
    .make = make,
};
