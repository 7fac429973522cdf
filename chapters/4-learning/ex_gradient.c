/* Gradient -- parameters that a gradient can set, and those that it cannot.

   What to see: nothing to look at. Two networks of the same shape and with the same parameters; one
   has tanh in its hidden layer, the other the sign. Both are almost everywhere differentiable, as
   Definition 7 asks. But below the sign every derivative is zero, so a gradient-based method
   sets the output layer alone, and what Definition 8 asks cannot be done.

   Book: section 1.2, Definition 8.
   Claims: learn.gradient.*
   Chosen here: nine inputs, eight hidden units, 16 random samples, the squared error. */

#include "claim.h" /* what we found, for the ledger */
#include "loss.h"  /* something to take the gradient of */
#include "mlp.h"   /* the networks */
#include "need.h"  /* memory */
#include "out.h"   /* reports are files */
#include "rng.h"   /* random samples */
#include <stdlib.h>

enum { SIZE = 9, HIDDEN = 8, SAMPLES = 16 };

static const uint64_t SEED = 425;

/* Uniform in [-1, 1). */
static void fill_random(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = 2 * kw_rng_uniform(r) - 1;
}

/* The parameters whose derivative is not zero, and how many there are at all. */
static int count_derivatives(kw_activation_kind hidden, int *parameters)
{
    const int width[] = {SIZE, HIDDEN, 1};
    const kw_activation_kind sigma[] = {hidden, KW_IDENTITY};
    kw_net *n = kw_mlp_new(2, width, sigma);
    kw_net_work *work = kw_net_work_new(n, SAMPLES);
    double *w = kw_need_memory((size_t)n->parameters, sizeof *w);
    double *dw = kw_need_memory((size_t)n->parameters, sizeof *dw);
    double x[SAMPLES * SIZE], target[SAMPLES], y[SAMPLES], dy[SAMPLES];
    kw_rng r = kw_rng_at(SEED, 1, 0, 0);
    int count = 0;

    fill_random(&r, SAMPLES * SIZE, x);
    fill_random(&r, SAMPLES, target);
    kw_net_init(n, SEED, w);
    kw_net_forward(n, w, SAMPLES, x, work, y);
    kw_loss_squared(SAMPLES, 1, y, target, dy);
    kw_net_backward(n, w, SAMPLES, x, y, dy, work, NULL, dw);
    for (int i = 0; i < n->parameters; i++)
        count += dw[i] != 0;
    *parameters = n->parameters;
    kw_net_work_free(work);
    kw_net_free(n);
    free(w);
    free(dw);
    return count;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_gradient");
    int parameters;

    kw_claim_count(report, "learn.gradient.tanh",
                   count_derivatives(KW_TANH, &parameters));
    kw_claim_count(report, "learn.gradient.sign",
                   count_derivatives(KW_SIGN, &parameters));
    kw_claim_count(report, "learn.gradient.parameters", parameters);
    return kw_out_close(report);
}
