/* Figure 12 -- A perceptron with m input units and one output unit.

   What to see: the smallest net there is. Each input is an edge with a weight; the output
   unit adds up, adds its bias, and keeps the sign.

   Book: section 1.2, (20), (21) and Figure 12.
   Claims: mlp.fig12.*, mlp.eq21.*
   Chosen here: m = 5. */

#include "claim.h"      /* what we found, for the ledger */
#include "diagram.h"    /* units and edges */
#include "mlp.h"        /* a perceptron is a net with L = 1 */
#include "out.h"        /* columns for gnuplot */
#include "perceptron.h" /* (21) by itself */
#include "rng.h"        /* random points and weights */

enum { INPUTS = 5, PROBES = 1000, SIZE = 4 }; /* m; numbers are -SIZE .. SIZE */

/* Random integer weights and points at which the net does not give what (21) says, and
   those at which the sum is zero. */
static void compare(const kw_net *n, int *differ, int *zeros)
{
    kw_net_work *work = kw_net_work_new(n, 1);
    kw_rng r = kw_rng_at(51, 0, 0, 0);

    *differ = *zeros = 0;
    for (int i = 0; i < PROBES; i++) {
        double w[INPUTS + 1], p[INPUTS], x;

        for (int j = 0; j <= INPUTS; j++)
            w[j] = kw_rng_below(&r, 2 * SIZE + 1) - SIZE;
        for (int j = 0; j < INPUTS; j++)
            p[j] = kw_rng_below(&r, 2 * SIZE + 1) - SIZE;
        kw_net_forward(n, w, 1, p, work, &x);
        *differ += x != kw_perceptron_decide(INPUTS, w, p);
        *zeros += kw_perceptron_sum(INPUTS, w, p) == 0;
    }
    kw_net_work_free(work);
}

int main(void)
{
    const int width[] = {INPUTS, 1};
    const kw_activation_kind sign[] = {KW_SIGN};
    kw_out *f = kw_out_data("fig12"), *report = kw_claim_new("fig12");
    kw_net *n = kw_mlp_new(1, width, sign);
    int differ, zeros;

    kw_claim_count(report, "mlp.fig12.edges", write_diagram(f, n));
    kw_claim_count(report, "mlp.fig12.parameters", kw_mlp_count(n));
    compare(n, &differ, &zeros);
    kw_claim_count(report, "mlp.eq21.net", differ);
    kw_claim_count(report, "mlp.eq21.zeros", zeros);

    kw_net_free(n);
    return kw_out_close(f) | kw_out_close(report);
}
