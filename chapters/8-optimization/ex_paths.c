/* Paths -- a derivative is a sum over all paths, and backpropagation does not walk them.

   What to see: nothing to look at (ex_gradient_cost has the picture). The derivative of an
   output with respect to an input is the sum over all paths between them of the products of
   the weights on each. We walk all 600 of a network of 65 edges, one by one, and find what
   backpropagation finds.

   Book: section 1.2, Optimization.
   Claims: opt.paths.*
   Chosen here: units 3, 5, 4, 5, 2, ReLU, random integer weights. */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* the network */
#include "need.h"  /* memory */
#include "out.h"   /* reports are files */
#include "rng.h"   /* weights */
#include <stdlib.h>

enum { CASES = 32 };

/* The sum over all paths from unit i of layer l (0: the input) to the output `to` of the
   products of their weights. A path through a ReLU that gives zero counts nothing; `work` has
   what the layers gave. Counts the paths in *paths. */
static double over_paths(const kw_net *n, const double *w, const kw_net_work *work, int l,
                         int i, int to, int *paths)
{
    const int L = kw_mlp_depth(n);
    const kw_affine *next;
    double sum = 0;
    int first;

    if (l == L) {
        *paths += i == to;
        return i == to;
    }
    next = kw_mlp_affine(n, l + 1, &first);
    for (int k = 0; k < next->out; k++) {
        double rest = over_paths(n, w, work, l + 1, k, to, paths);

        if (l + 1 == L || work->value[2 * l + 1][k] > 0)
            sum += w[first + kw_affine_weight(next, k, i)] * rest;
    }
    return sum;
}

/* Random integer weights: derivatives of outputs with respect to inputs that are not the sum
   over all paths between the two. */
static void report_paths(kw_out *report)
{
    static const kw_activation_kind sigma[] = {KW_RELU, KW_RELU, KW_RELU, KW_IDENTITY};
    kw_net *n = kw_mlp_new(4, (const int[]){3, 5, 4, 5, 2}, sigma);
    kw_net_work *work = kw_net_work_new(n, 1);
    double *w = kw_need_memory(2 * (size_t)n->parameters, sizeof *w);
    double *dw = w + n->parameters, x[3], y[2], dx[3];
    int differ = 0, paths = 0, edges = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(83, 0, sample, 0);

        for (int i = 0; i < n->parameters; i++)
            w[i] = kw_rng_below(&r, 19) - 9;
        for (int i = 0; i < n->in; i++)
            x[i] = kw_rng_below(&r, 19) - 9;
        kw_net_forward(n, w, 1, x, work, y);
        paths = 0;
        for (int to = 0; to < n->out; to++) {
            const double dy[] = {to == 0, to == 1};

            kw_net_backward(n, w, 1, x, y, dy, work, dx, dw);
            for (int i = 0; i < n->in; i++)
                differ += over_paths(n, w, work, 0, i, to, &paths) != dx[i];
        }
    }
    for (int l = 1; l <= 4; l++)
        edges += kw_mlp_count_weights(n, l);
    kw_claim_count(report, "opt.paths.differ", differ);
    kw_claim_count(report, "opt.paths.paths", paths);
    kw_claim_count(report, "opt.paths.edges", edges);
    free(w);
    kw_net_work_free(work);
    kw_net_free(n);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_paths");

    report_paths(report);
    return kw_out_close(report);
}
