/* Exercise 8 -- the price of a gradient in a network whose layers have the same width.

   What to see: nothing to look at. A value with its gradient takes a little less than three
   values: the first layer passes no derivatives on. Asked to do so, it takes three.

   Book: section 1.2, Optimization.
   Claims: opt.predict.*
   Chosen here: five affine layers, all widths up to 64. */

#include "claim.h" /* what we found, for the ledger */
#include "cost.h"  /* multiply-adds */
#include "mlp.h"   /* the networks */
#include "out.h"   /* reports are files */

enum { LAYERS = 5, WIDEST = 64 };

static kw_net *new_net(int units)
{
    int width[LAYERS + 1];
    kw_activation_kind sigma[LAYERS];

    for (int l = 0; l <= LAYERS; l++)
        width[l] = units;
    for (int l = 0; l < LAYERS; l++)
        sigma[l] = l < LAYERS - 1 ? KW_TANH : KW_IDENTITY;
    return kw_mlp_new(LAYERS, width, sigma);
}

/* What a value with its gradient costs, in values; *all: with the derivatives with respect to
   the input as well. */
static double price(int units, double *all)
{
    kw_net *n = new_net(units);
    const totals t = net_cost(n);

    *all = (t.gradient + layer_cost(&n->layer[0]).inputs) / t.value;
    kw_net_free(n);
    return t.gradient / t.value;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_predict_gradient");
    double all, other_all, gradient = price(WIDEST, &all);
    int differ = 0;

    for (int units = 1; units < WIDEST; units++)
        differ += price(units, &other_all) != gradient || other_all != all;

    kw_claim_real(report, "opt.predict.gradient", gradient);
    kw_claim_real(report, "opt.predict.all", all);
    kw_claim_count(report, "opt.predict.differ", differ);
    return kw_out_close(report);
}
