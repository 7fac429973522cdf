/* Exercise 7 -- what depends on the number of nodes, and how far a signal walks.

   What to see: nothing to look at. Only the layer whose filter is a polynomial keeps its number
   of parameters when a node is added. A one at a single node tells a ring of six from two
   rings of three: two layers carry it to more nodes.

   Book: section 1.2, on spatial and spectral methods.
   Claims: gcn.predict.*
   Chosen here: six and seven nodes in a circle, one channel to two, degree 2; all weights of
   the spatial layers one, all biases zero. */

#include "affine.h" /* the fully connected layer */
#include "claim.h"  /* what we found, for the ledger */
#include "gcn.h"    /* the others */
#include "graphs.h" /* the circles */
#include "out.h"    /* reports are files */
#include <stdio.h>

enum { NODES = 6, IN = 1, OUT = 2, DEGREE = 2, LAYERS = 2 };

/* The parameters of three layers on a circle of n nodes. */
static void report_parameters(kw_out *report, int n)
{
    kw_graph *g = new_cycle(n);
    kw_gcn *chebyshev = kw_gcn_new_chebyshev(g, IN, OUT, DEGREE);
    kw_gcn *spectral = kw_gcn_new_spectral(g, IN, OUT);
    char id[40];

    snprintf(id, sizeof id, "gcn.predict.chebyshev.%d", n);
    kw_claim_count(report, id, chebyshev->parameters);
    snprintf(id, sizeof id, "gcn.predict.spectral.%d", n);
    kw_claim_count(report, id, spectral->parameters);
    snprintf(id, sizeof id, "gcn.predict.full.%d", n);
    kw_claim_count(report, id, kw_affine_layer(n * IN, n * OUT).parameters);
    kw_gcn_free(chebyshev);
    kw_gcn_free(spectral);
    kw_graph_free(g);
}

/* The nodes to which `layers` spatial layers carry a one at node 0. */
static int count_reached(const kw_graph *g, int layers)
{
    static const double w[] = {1, 1, 0}; /* own, neighbours', bias */
    kw_gcn *layer = kw_gcn_new_spatial(g, 1, 1);
    double signal[LAYERS + 1][NODES] = {{1}};
    int count = 0;

    for (int l = 0; l < layers; l++)
        kw_gcn_forward(layer, w, 1, signal[l], signal[l + 1]);
    for (int i = 0; i < NODES; i++)
        count += signal[layers][i] != 0;
    kw_gcn_free(layer);
    return count;
}

int main(void)
{
    static const int two[] = {0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3};
    kw_out *report = kw_claim_new("ex_predict_nodes");
    kw_graph *ring = new_cycle(NODES), *rings = kw_graph_new(NODES, NODES, two, NULL);

    report_parameters(report, NODES);
    report_parameters(report, NODES + 1);

    kw_claim_count(report, "gcn.predict.ring.1", count_reached(ring, 1));
    kw_claim_count(report, "gcn.predict.ring.2", count_reached(ring, LAYERS));
    kw_claim_count(report, "gcn.predict.rings.1", count_reached(rings, 1));
    kw_claim_count(report, "gcn.predict.rings.2", count_reached(rings, LAYERS));
    kw_graph_free(ring);
    kw_graph_free(rings);
    return kw_out_close(report);
}
