/* Figure 13 -- A multi-layer perceptron with five layers.

   What to see: input, three hidden layers, output; every unit of a layer is joined to every
   unit of the next, and to no other.

   Book: section 1.2, the text around Figure 13.
   Claims: mlp.fig13.*
   Chosen here: the widths m = 4, m_1 = 6, m_2 = 5, m_3 = 4, n = 3; random parameters. */

#include "claim.h"   /* what we found, for the ledger */
#include "diagram.h" /* units and edges */
#include "mlp.h"     /* the net */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include <stdlib.h>

enum { L = 4, FIRST = 6 }; /* layers behind the input; units of the first hidden one */

/* How many different values the first unit of layer 2 receives from those of layer 1: each
   sends one to all units of layer 2. */
static int count_received(const kw_net *n, const double *p)
{
    double *w = kw_need_memory((size_t)n->parameters, sizeof *w), y[FIRST];
    kw_net_work *work = kw_net_work_new(n, 1);
    const double *sent;
    int different = 0;

    kw_net_init(n, 52, w);
    kw_net_forward(n, w, 1, p, work, y);
    sent = work->value[1]; /* layer 0 of the chain is affine, layer 1 its activation */
    for (int j = 0; j < FIRST; j++) {
        int earlier = 0;

        for (int i = 0; i < j; i++)
            earlier |= sent[i] == sent[j];
        different += !earlier;
    }
    kw_net_work_free(work);
    free(w);
    return different;
}

int main(void)
{
    const int width[L + 1] = {4, FIRST, 5, 4, 3};
    const kw_activation_kind sigma[L] = {KW_TANH, KW_TANH, KW_TANH, KW_IDENTITY};
    const double p[] = {1, -1, 0.5, 2};
    kw_out *f = kw_out_data("fig13"), *report = kw_claim_new("fig13");
    kw_net *n = kw_mlp_new(L, width, sigma);

    kw_claim_count(report, "mlp.fig13.edges", write_diagram(f, n));
    kw_claim_count(report, "mlp.fig13.layers", kw_mlp_depth(n) + 1);
    kw_claim_count(report, "mlp.fig13.hidden", kw_mlp_depth(n) - 1);
    kw_claim_count(report, "mlp.fig13.parameters", kw_mlp_count(n));
    kw_claim_count(report, "mlp.fig13.received", count_received(n, p));

    kw_net_free(n);
    return kw_out_close(f) | kw_out_close(report);
}
