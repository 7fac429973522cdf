/* Figure 14 -- One step of the realization of a multi-layer perceptron, with numbers.

   What to see: what the units of a layer give goes along the edges, times their weights, and
   is added up with the bias at each unit of the next layer; then the activation is applied. A
   negative sum becomes zero, and nothing flows on from that unit.

   Book: section 1.2, Definition 10 and Figure 14.
   Claims: mlp.fig14.*, mlp.def10.loop
   Chosen here: the net, its numbers, ReLU; they are multiples of 1/4, so nothing is
   rounded. The step is that from layer 1 to layer 2 of four. */

#include "claim.h"   /* what we found, for the ledger */
#include "diagram.h" /* where units stand */
#include "mlp.h"     /* the net */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "rng.h"     /* random nets */
#include <math.h>
#include <stdlib.h>

enum { L = 3, SHOWN = 3, NETS = 200, DEEPEST = 5, WIDEST = 6 };

static const int WIDTH[L + 1] = {2, SHOWN, SHOWN, 2};

/* For l = 1, 2, 3: W^(l), a row each unit of layer l, then b^(l). */
static const double W[] = {
    1,   0,    0,     1,    1,   2,    0,   0, 0,     /* from 2 to 3 units */
    1,   -2,   0.5,   -1.5, 1,   -0.5, 0.5, 1, -0.25, /* from 3 to 3: what is drawn, */
    0.5, 0.75, -0.25,                                 /* and its biases */
    1,   -1,   2,     0.5,  0.5, 1,    0,   -1};      /* from 3 to 2 */

/* Writes the step from layer 1 to layer 2; the net has put its numbers into `work`. */
static void write_step(kw_out *f, const kw_net *n, const kw_net_work *work)
{
    /* the chain is affine, ReLU, affine, ReLU, affine */
    const double *given = work->value[1], *sum = work->value[2], *next = work->value[3];
    int first;
    const kw_affine *a = kw_mlp_affine(n, 2, &first);

    kw_out_section(f, "layer", "y value");
    for (int j = 0; j < a->in; j++) {
        kw_out_number(f, unit_height(a->in, j));
        kw_out_number(f, given[j]);
        kw_out_row(f);
    }
    kw_out_section(f, "edges", "y y weight");
    for (int i = 0; i < a->out; i++)
        for (int j = 0; j < a->in; j++) {
            kw_out_number(f, unit_height(a->in, j));
            kw_out_number(f, unit_height(a->out, i));
            kw_out_number(f, W[first + kw_affine_weight(a, i, j)]);
            kw_out_row(f);
        }
    kw_out_section(f, "next", "y bias sum value");
    for (int i = 0; i < a->out; i++) {
        kw_out_number(f, unit_height(a->out, i));
        kw_out_number(f, W[first + kw_affine_bias(a, i)]);
        kw_out_number(f, sum[i]);
        kw_out_number(f, next[i]);
        kw_out_row(f);
    }
}

/* Phi(p) by Definition 10, word for word: weights and biases one after the other in w, ReLU
   between the layers. */
static void realize(int layers, const int *width, const double *w, const double *p,
                    double *y)
{
    double given[WIDEST];

    for (int j = 0; j < width[0]; j++)
        given[j] = p[j];
    for (int l = 1; l <= layers; l++) {
        const double *bias = w + width[l] * width[l - 1];

        for (int i = 0; i < width[l]; i++) {
            y[i] = bias[i];
            for (int j = 0; j < width[l - 1]; j++)
                y[i] += w[i * width[l - 1] + j] * given[j];
        }
        for (int i = 0; i < width[l]; i++)
            given[i] = fmax(0, y[i]);
        w = bias + width[l];
    }
}

/* The largest difference between the library and the definition over random nets with
   integer parameters and inputs: both are exact. */
static double largest_difference(void)
{
    kw_rng r = kw_rng_at(53, 0, 0, 0);
    double most = 0;

    for (int round = 0; round < NETS; round++) {
        int layers = 1 + kw_rng_below(&r, DEEPEST), width[DEEPEST + 1] = {0};
        kw_activation_kind sigma[DEEPEST];
        double p[WIDEST], y[WIDEST] = {0}, z[WIDEST] = {0}, *w;
        kw_net_work *work;
        kw_net *n;

        for (int l = 0; l <= layers; l++)
            width[l] = 1 + kw_rng_below(&r, WIDEST);
        for (int l = 0; l < layers; l++)
            sigma[l] = l + 1 < layers ? KW_RELU : KW_IDENTITY;
        n = kw_mlp_new(layers, width, sigma);
        work = kw_net_work_new(n, 1);
        w = kw_need_memory((size_t)n->parameters, sizeof *w);
        for (int i = 0; i < n->parameters; i++)
            w[i] = kw_rng_below(&r, 7) - 3;
        for (int j = 0; j < width[0]; j++)
            p[j] = kw_rng_below(&r, 7) - 3;
        kw_net_forward(n, w, 1, p, work, y);
        realize(layers, width, w, p, z);
        for (int i = 0; i < n->out; i++)
            most = fmax(most, fabs(y[i] - z[i]));
        free(w);
        kw_net_work_free(work);
        kw_net_free(n);
    }
    return most;
}

int main(void)
{
    const kw_activation_kind sigma[L] = {KW_RELU, KW_RELU, KW_IDENTITY};
    const double p[] = {1, 0.5};
    kw_out *f = kw_out_data("fig14"), *report = kw_claim_new("fig14");
    kw_net *n = kw_mlp_new(L, WIDTH, sigma);
    kw_net_work *work = kw_net_work_new(n, 1);
    double y[2];

    kw_net_forward(n, W, 1, p, work, y);
    write_step(f, n, work);
    kw_claim_real(report, "mlp.fig14.sum.1", work->value[2][0]);
    kw_claim_real(report, "mlp.fig14.sum.2", work->value[2][1]);
    kw_claim_real(report, "mlp.fig14.value.2", work->value[3][1]);
    kw_claim_real(report, "mlp.def10.loop", largest_difference());

    kw_net_work_free(work);
    kw_net_free(n);
    return kw_out_close(f) | kw_out_close(report);
}
