/* Learnable parameters -- Remark 10 against counting.

   What to see: nothing to look at. Weights and biases are found by trial: an edge where a change
   of one unit changes another, a bias where a unit gives something for nothing. Parameters that
   the output depends on are found by the gradient. The formula of Remark 10 has the same number.
   With the printed range of the biases, which leaves out the last layer, it would not.

   Book: section 1.2, Definition 10 and Remark 10.
   Claims: mlp.rem10.*, mlp.def10.range.*, mlp.def10.maps
   Chosen here: 200 random architectures and those of the ids; tanh between the layers. */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* nets whose parameters are counted */
#include "need.h"  /* memory */
#include "out.h"   /* reports are files */
#include "rng.h"   /* random architectures */
#include <stdlib.h>

enum { CASES = 200, DEEPEST = 6, WIDEST = 9 };

typedef struct architecture {
    int L, width[DEEPEST + 1];
} architecture;

static const architecture SMALLEST = {1, {3, 1}}, SMALL = {2, {2, 3, 1}},
                          MEDIUM = {4, {4, 5, 3, 2, 2}},
                          DIGITS = {4, {784, 128, 64, 32, 10}};

static kw_net *new_net(const architecture *a)
{
    kw_activation_kind sigma[DEEPEST];

    for (int l = 0; l < a->L; l++)
        sigma[l] = l + 1 < a->L ? KW_TANH : KW_IDENTITY;
    return kw_mlp_new(a->L, a->width, sigma);
}

/* Remark 10. */
static int formula(const architecture *a)
{
    int sum = 0;

    for (int l = 1; l <= a->L; l++)
        sum += a->width[l] * (a->width[l - 1] + 1);
    return sum;
}

/* Found by trial (mlp.h), with biases for l = 1 .. last. */
static int count(const architecture *a, int last)
{
    kw_net *n = new_net(a);
    int sum = 0;

    for (int l = 1; l <= a->L; l++)
        sum += kw_mlp_count_weights(n, l) + (l <= last ? kw_mlp_count_biases(n, l) : 0);
    kw_net_free(n);
    return sum;
}

/* Parameters that a random combination of the outputs depends on at a random input: entries of
   the gradient that are not zero. */
static int count_used(const architecture *a, uint64_t seed)
{
    kw_net *n = new_net(a);
    kw_net_work *work = kw_net_work_new(n, 1);
    const size_t parameters = (size_t)n->parameters;
    double *w = kw_need_memory(parameters, sizeof *w);
    double *dw = kw_need_memory(parameters, sizeof *dw);
    double *p = kw_need_memory((size_t)n->in, sizeof *p);
    double *y = kw_need_memory((size_t)n->out, sizeof *y);
    double *dy = kw_need_memory((size_t)n->out, sizeof *dy);
    kw_rng r = kw_rng_at(54, 0, seed, 0);
    int used = 0;

    for (int j = 0; j < n->in; j++)
        p[j] = kw_rng_uniform(&r) + 0.5;
    for (int i = 0; i < n->out; i++)
        dy[i] = kw_rng_uniform(&r) + 0.5;
    kw_net_init(n, seed, w);
    kw_net_forward(n, w, 1, p, work, y);
    kw_net_backward(n, w, 1, p, y, dy, work, NULL, dw);
    for (int i = 0; i < n->parameters; i++)
        used += dw[i] != 0;
    free(w);
    free(dw);
    free(p);
    free(y);
    free(dy);
    kw_net_work_free(work);
    kw_net_free(n);
    return used;
}

static architecture random_architecture(uint64_t sample)
{
    kw_rng r = kw_rng_at(55, 0, sample, 0);
    architecture a = {.L = 1 + kw_rng_below(&r, DEEPEST)};

    for (int l = 0; l <= a.L; l++)
        a.width[l] = 1 + kw_rng_below(&r, WIDEST);
    return a;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_parameters");
    kw_net *n = new_net(&MEDIUM);
    int off = 0, unused = 0, right = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        architecture a = random_architecture(i);

        off += count(&a, a.L) != formula(&a);
        unused += count_used(&a, i) != formula(&a);
        right += count(&a, a.L - 1) == formula(&a);
    }
    kw_claim_count(report, "mlp.rem10.off", off);
    kw_claim_count(report, "mlp.rem10.unused", unused);
    kw_claim_count(report, "mlp.def10.range", right);

    kw_claim_count(report, "mlp.rem10.2-3-1", count(&SMALL, SMALL.L));
    kw_claim_count(report, "mlp.rem10.4-5-3-2-2", count(&MEDIUM, MEDIUM.L));
    kw_claim_count(report, "mlp.rem10.784-128-64-32-10", count(&DIGITS, DIGITS.L));
    kw_claim_count(report, "mlp.rem10.784-128-64-32-10.used", count_used(&DIGITS, 1));
    kw_claim_count(report, "mlp.def10.range.2-3-1", count(&SMALL, SMALL.L - 1));
    kw_claim_count(report, "mlp.def10.range.3-1", count(&SMALLEST, SMALLEST.L - 1));
    kw_claim_count(report, "mlp.def10.maps", kw_mlp_depth(n));

    kw_net_free(n);
    return kw_out_close(report);
}
