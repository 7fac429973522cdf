/* Spatial convolution -- what a node is, and what its neighbours are on average.

   What to see: one layer spreads a signal along the edges; renumber the nodes, and the same
   layer gives the same values at the same places, though every number in its arrays has
   moved.

   Book: section 1.2, on spatial methods.
   Claims: gcn.*.renumbered, gcn.spatial.rings.*
   Chosen here: twelve points, each joined with its two nearest; weights 1/4 for the node
   and 3/4 for its neighbours. Random graphs whose nodes all have three or four neighbours,
   signals and weights of small integers, so that all arithmetic is exact. */

#include "claim.h"  /* what we found, for the ledger */
#include "gcn.h"    /* the layers */
#include "graphs.h" /* graphs and their pictures */
#include "out.h"    /* columns for gnuplot */
#include "rng.h"    /* random graphs */
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 12, NEAREST = 2, CASES = 200, NODES = 16, IN = 2, OUT = 3, DEGREE = 3 };

/* --- any numbering of the nodes gives the same --- */

/* A random graph of NODES nodes with `degree` neighbours each: as many random pairings of all
   nodes, no pair twice. */
static kw_graph *random_regular(kw_rng *r, int degree)
{
    int end[NODES * NODES], edges = 0, order[NODES];
    char joined[NODES][NODES] = {{0}};

    while (edges < degree * NODES / 2) {
        int clash = 0;

        shuffle(r, NODES, order);
        for (int i = 0; i < NODES; i += 2)
            clash |= joined[order[i]][order[i + 1]];
        for (int i = 0; !clash && i < NODES; i += 2) {
            int a = order[i], b = order[i + 1];

            joined[a][b] = joined[b][a] = 1;
            end[2 * edges] = a;
            end[2 * edges++ + 1] = b;
        }
    }
    return kw_graph_new(NODES, edges, end, NULL);
}

static void random_integers(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = kw_rng_below(r, 19) - 9;
}

/* Row i of x, n x channels, becomes row to[i] of y. */
static void move_rows(int n, int channels, const int *to, const double *x, double *y)
{
    for (int i = 0; i < n; i++)
        memcpy(y + to[i] * channels, x + i * channels, (size_t)channels * sizeof *x);
}

static double largest_difference(int count, const double *a, const double *b)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

typedef kw_gcn *layer_maker(const kw_graph *g, int in_channels, int out_channels);

static kw_gcn *new_chebyshev(const kw_graph *g, int in_channels, int out_channels)
{
    return kw_gcn_new_chebyshev(g, in_channels, out_channels, DEGREE);
}

/* Over random graphs of one degree: the largest difference of `layer, then renumber' and
   `renumber, then layer'. */
static double renumbering_error(layer_maker *new_layer, int degree)
{
    double most = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(701, (uint64_t)degree, sample, 0);
        kw_graph *g = random_regular(&r, degree), *moved;
        double x[NODES * IN], x_moved[NODES * IN], w[(DEGREE + 1) * IN * OUT + OUT];
        double y[NODES * OUT], y_moved[NODES * OUT], want[NODES * OUT];
        kw_gcn *layer, *layer_moved;
        int to[NODES];

        shuffle(&r, NODES, to);
        moved = kw_graph_new_renumbered(g, to);
        layer = new_layer(g, IN, OUT);
        layer_moved = new_layer(moved, IN, OUT);
        random_integers(&r, layer->parameters, w);
        random_integers(&r, NODES * IN, x);
        move_rows(NODES, IN, to, x, x_moved);
        kw_gcn_forward(layer, w, 1, x, y);
        kw_gcn_forward(layer_moved, w, 1, x_moved, y_moved);
        move_rows(NODES, OUT, to, y, want);
        most = fmax(most, largest_difference(NODES * OUT, y_moved, want));
        kw_gcn_free(layer);
        kw_gcn_free(layer_moved);
        kw_graph_free(g);
        kw_graph_free(moved);
    }
    return most;
}

/* The same for a layer that knows no graph, y = W x with any matrix W: cases in which the
   order does not matter. */
static int dense_layers_that_commute(void)
{
    int commute = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(702, 0, sample, 0);
        double x[NODES], x_moved[NODES], W[NODES * NODES], want[NODES];
        double y[NODES] = {0}, y_moved[NODES] = {0};
        int to[NODES];

        shuffle(&r, NODES, to);
        random_integers(&r, NODES * NODES, W);
        random_integers(&r, NODES, x);
        move_rows(NODES, 1, to, x, x_moved);
        for (int i = 0; i < NODES * NODES; i++) {
            y[i / NODES] += W[i] * x[i % NODES];
            y_moved[i / NODES] += W[i] * x_moved[i % NODES];
        }
        move_rows(NODES, 1, to, y, want);
        commute += largest_difference(NODES, y_moved, want) == 0;
    }
    return commute;
}

/* --- what a node cannot see --- */

/* Two spatial layers with a ReLU in between, one channel that is 1 everywhere. */
static void two_layers(const kw_graph *g, const double *w, double *y)
{
    kw_gcn *first = kw_gcn_new_spatial(g, 1, OUT),
           *second = kw_gcn_new_spatial(g, OUT, 1);
    double ones[6] = {1, 1, 1, 1, 1, 1}, hidden[6 * OUT];

    kw_gcn_forward(first, w, 1, ones, hidden);
    for (int i = 0; i < 6 * OUT; i++)
        hidden[i] = fmax(0, hidden[i]);
    kw_gcn_forward(second, w + first->parameters, 1, hidden, y);
    kw_gcn_free(first);
    kw_gcn_free(second);
}

/* A ring of six against two rings of three: the largest difference at any node. */
static void report_rings(kw_out *report)
{
    static const int two[] = {0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3};
    kw_graph *hexagon = new_cycle(6), *triangles = kw_graph_new(6, 6, two, NULL);
    int work[6], component[6];
    double most = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(703, 0, sample, 0);
        double w[2 * OUT + OUT + 2 * OUT + 1], y[6], y_two[6];

        random_integers(&r, 2 * OUT + OUT + 2 * OUT + 1, w);
        two_layers(hexagon, w, y);
        two_layers(triangles, w, y_two);
        most = fmax(most, largest_difference(6, y, y_two));
    }
    kw_claim_real(report, "gcn.spatial.rings", most);
    kw_claim_count(report, "gcn.spatial.rings.components",
                   kw_graph_components(triangles, work, component));
    kw_graph_free(hexagon);
    kw_graph_free(triangles);
}

/* --- the picture --- */

/* A row a node: its place, its value, its number. */
static void write_signal(kw_out *f, const char *name, const double *x, const int *number,
                         const double *value)
{
    kw_out_section(f, name, "x y value number");
    for (int i = 0; i < POINTS; i++) {
        kw_out_number(f, x[2 * i]);
        kw_out_number(f, x[2 * i + 1]);
        kw_out_number(f, value[number[i]]);
        kw_out_number(f, number[i]);
        kw_out_row(f);
    }
}

/* A signal, what the layer makes of it, and what the layer makes of it on the graph whose
   nodes have other numbers. */
static void write_picture(kw_out *f)
{
    const double w[] = {0.25, 0.75, 0}; /* own, neighbours', bias */
    double x[2 * POINTS] = {0}, signal[POINTS] = {0}, moved_signal[POINTS], y[POINTS];
    int number[POINTS], other[POINTS] = {0};
    kw_rng r = kw_rng_at(704, 0, 0, 0);
    kw_graph *g, *moved;
    kw_gcn *layer, *layer_moved;

    scatter(705, 0, POINTS, x);
    for (int i = 0; i < POINTS; i++)
        number[i] = i;
    shuffle(&r, POINTS, other);
    g = kw_graph_new_nearest(POINTS, 2, x, NEAREST);
    moved = kw_graph_new_renumbered(g, other);
    layer = kw_gcn_new_spatial(g, 1, 1);
    layer_moved = kw_gcn_new_spatial(moved, 1, 1);
    signal[0] = signal[1] = 1;
    move_rows(POINTS, 1, other, signal, moved_signal);

    write_edges(f, "edges", g, x);
    write_signal(f, "signal", x, number, signal);
    kw_gcn_forward(layer, w, 1, signal, y);
    write_signal(f, "layer", x, number, y);
    kw_gcn_forward(layer_moved, w, 1, moved_signal, y);
    write_signal(f, "renumbered", x, other, y);
    kw_gcn_free(layer);
    kw_gcn_free(layer_moved);
    kw_graph_free(g);
    kw_graph_free(moved);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_spatial"), *report = kw_claim_new("ex_spatial");

    write_picture(f);
    kw_claim_real(report, "gcn.spatial.renumbered",
                  renumbering_error(kw_gcn_new_spatial, 4));
    kw_claim_real(report, "gcn.chebyshev.renumbered",
                  renumbering_error(new_chebyshev, 4));
    kw_claim_real(report, "gcn.first-order.renumbered",
                  renumbering_error(kw_gcn_new_first_order, 3));
    kw_claim_count(report, "gcn.dense.renumbered", dense_layers_that_commute());
    report_rings(report);
    return kw_out_close(f) | kw_out_close(report);
}
