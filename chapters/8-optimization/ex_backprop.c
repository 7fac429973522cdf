/* Backpropagation -- every layer type and every loss against central differences.

   What to see: (a) a central difference is off by the square of its step, and by a rounding over
   its step; between the two it agrees with backpropagation in ten digits. (b) Its distance
   from backpropagation for every layer and loss; where the arithmetic is exact there is none.

   Book: section 1.2, Optimization; Definition 8.
   Claims: opt.backprop.*
   Chosen here: layers of 16 inputs, batches of four samples. Inputs, parameters and targets are odd
   multiples of 1/8, so that no difference crosses a kink, and the inputs of a sample are all
   different, so that none crosses a change of the largest. */

#include "claim.h"     /* what we found, for the ledger */
#include "loss.h"      /* every loss */
#include "net.h"       /* every layer, forward and backward */
#include "objective.h" /* gradients and central differences */
#include "out.h"       /* columns for gnuplot */
#include <math.h>

enum {
    IN = 16,
    NODES = 8 /* of a graph, two channels each */
};

static const double COARSE = 0x1p-4; /* the step where arithmetic is exact */
static const double FINE = 0x1p-17;  /* and where it is not */

/* --- the comparison --- */

typedef struct findings {
    int slopes;      /* entries of the gradient that are not zero */
    int differ;      /* entries in which it is not the central difference */
    double relative; /* the largest distance of an entry, over the largest entry */
} findings;

static findings compare(const objective *o, double h)
{
    findings found = {0};
    double dz[MOST], distance = 0, largest = 0;

    value(o, o->z, dz);
    for (int i = 0; i < o->numbers; i++) {
        double slope = difference(o, i, h);

        found.slopes += dz[i] != 0;
        found.differ += slope != dz[i];
        distance = fmax(distance, fabs(slope - dz[i]));
        largest = fmax(largest, fabs(dz[i]));
    }
    found.relative = largest > 0 ? distance / largest : distance;
    return found;
}

/* All subjects together. */
typedef struct tally {
    int subjects, exact; /* how many; of those, how many in exact arithmetic */
    int slopes, differ;  /* entries of these: not zero; not equal */
    double relative;     /* the largest of the others */
} tally;

/* exact: nothing is rounded, and as a function of any one of its numbers the loss is at most
   quadratic near the point, so that a central difference is the slope. */
static void examine(kw_out *f, tally *all, const char *name, kw_net *net, kw_loss *loss,
                    int exact)
{
    objective o = new_objective(net, loss, (uint64_t)all->subjects);
    findings found = compare(&o, exact ? COARSE : FINE);

    kw_out_section(f, name, "relative");
    kw_out_number(f, found.relative);
    kw_out_row(f);
    all->subjects++;
    all->exact += exact;
    all->slopes += exact ? found.slopes : 0;
    all->differ += exact ? found.differ : 0;
    all->relative = exact ? all->relative : fmax(all->relative, found.relative);
    kw_net_work_free(o.work);
    kw_net_free(net);
}

/* --- the subjects --- */

static void examine_dense(kw_out *f, tally *all)
{
    kw_net *affine = kw_net_new(IN);

    kw_net_add_affine(affine, 3);
    examine(f, all, "affine", affine, kw_loss_squared, 1);
    for (int kind = 0; kind < KW_ACTIVATION_KINDS; kind++) {
        int exact = kind <= KW_STEP || kind == KW_RELU; /* identity, sign, step */
        kw_net *n = kw_net_new(IN);

        kw_net_add_activation(n, (kw_activation_kind)kind);
        examine(f, all, kw_activation_name((kw_activation_kind)kind), n, kw_loss_squared,
                exact);
    }
}

static kw_conv image_layer(kw_conv_padding padding)
{
    return kw_conv_layer((kw_conv){.in_channels = 1,
                                   .rows = 4,
                                   .columns = 4,
                                   .out_channels = 2,
                                   .filter_rows = 3,
                                   .filter_columns = 2,
                                   .stride = 1,
                                   .padding = padding});
}

static kw_pool image_pool(kw_pool_kind kind, int channels)
{
    return kw_pool_layer((kw_pool){.kind = kind,
                                   .channels = channels,
                                   .rows = 4,
                                   .columns = 4,
                                   .window_rows = 2,
                                   .window_columns = 2,
                                   .stride = 2});
}

static void examine_grids(kw_out *f, tally *all)
{
    static const char *const padding[] = {"convolution, valid", "convolution, zeros",
                                          "convolution, circular"};
    static const char *const pool[] = {"pooling, largest", "pooling, mean"};
    const kw_conv signal = kw_conv_layer((kw_conv){.in_channels = 2,
                                                   .rows = 1,
                                                   .columns = 8,
                                                   .out_channels = 2,
                                                   .filter_rows = 1,
                                                   .filter_columns = 3,
                                                   .stride = 2});
    kw_net *n = kw_net_new(IN);

    kw_net_add_conv(n, &signal);
    examine(f, all, "convolution, signal", n, kw_loss_squared, 1);
    for (int i = 0; i < 3; i++) {
        const kw_conv l = image_layer((kw_conv_padding)i);

        n = kw_net_new(IN);
        kw_net_add_conv(n, &l);
        examine(f, all, padding[i], n, kw_loss_squared, 1);
    }
    for (int i = 0; i < 2; i++) {
        const kw_pool l = image_pool((kw_pool_kind)i, 1);

        n = kw_net_new(IN);
        kw_net_add_pool(n, &l);
        examine(f, all, pool[i], n, kw_loss_squared, 1);
    }
}

/* A circle of NODES nodes, each joined with those up to `reach` places away and, if `across`,
   with the one on the other side: as many neighbours for all. */
static kw_graph *new_ring(int reach, int across)
{
    int end[2 * NODES * 3], edges = 0;

    for (int i = 0; i < NODES; i++)
        for (int step = 1; step <= NODES / 2; step++)
            if (step <= reach || (across && step == NODES / 2 && i < NODES / 2)) {
                end[2 * edges] = i;
                end[2 * edges++ + 1] = (i + step) % NODES;
            }
    return kw_graph_new(NODES, edges, end, NULL);
}

/* With four neighbours, or with three and the node itself, all entries of the matrices are
   multiples of 1/4; eigenvectors are rounded. */
static void examine_graphs(kw_out *f, tally *all)
{
    static const char *const name[] = {"graph, spatial", "graph, Chebyshev",
                                       "graph, first order", "graph, spectral"};
    kw_graph *four = new_ring(2, 0), *three = new_ring(1, 1);
    kw_gcn *layer[] = {
        kw_gcn_new_spatial(four, 2, 2), kw_gcn_new_chebyshev(four, 2, 2, 3),
        kw_gcn_new_first_order(three, 2, 2), kw_gcn_new_spectral(four, 2, 2)};

    for (int i = 0; i < 4; i++) {
        kw_net *n = kw_net_new(IN);

        kw_net_add_gcn(n, layer[i]);
        examine(f, all, name[i], n, kw_loss_squared, i < 3);
    }
    for (int i = 0; i < 4; i++)
        kw_gcn_free(layer[i]);
    kw_graph_free(four);
    kw_graph_free(three);
}

static void examine_losses(kw_out *f, tally *all)
{
    static const char *const name[] = {"squared error", "hinge", "perceptron criterion",
                                       "cross-entropy", "cross-entropy, two classes"};
    kw_loss *const loss[] = {kw_loss_squared, kw_loss_hinge, kw_loss_perceptron,
                             kw_loss_cross_entropy, kw_loss_logistic};

    for (int i = 0; i < 5; i++) {
        kw_net *n = kw_net_new(IN);

        kw_net_add_activation(n, KW_IDENTITY);
        examine(f, all, name[i], n, loss[i], i < 3);
    }
}

/* A whole convolutional network. */
static kw_net *new_network(void)
{
    const kw_conv conv = image_layer(KW_CONV_SAME);
    const kw_pool pool = image_pool(KW_POOL_MEAN, 2);
    kw_net *n = kw_net_new(IN);

    kw_net_add_conv(n, &conv);
    kw_net_add_activation(n, KW_TANH);
    kw_net_add_pool(n, &pool);
    kw_net_add_affine(n, 4);
    kw_net_add_activation(n, KW_SOFTPLUS);
    kw_net_add_affine(n, 3);
    return n;
}

/* The distance for one network and steps of all sizes. */
static void write_steps(kw_out *f)
{
    kw_net *n = new_network();
    objective o = new_objective(n, kw_loss_cross_entropy, 100);

    kw_out_section(f, "steps", "h relative");
    for (int q = 1; q <= 44; q++) {
        double h = ldexp(1, -q);

        kw_out_number(f, h);
        kw_out_number(f, compare(&o, h).relative);
        kw_out_row(f);
    }
    kw_net_work_free(o.work);
    kw_net_free(n);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_backprop"), *report = kw_claim_new("ex_backprop");
    tally all = {0};

    examine_dense(f, &all);
    examine_grids(f, &all);
    examine_graphs(f, &all);
    examine_losses(f, &all);
    examine(f, &all, "a whole network", new_network(), kw_loss_cross_entropy, 0);
    write_steps(f);

    kw_claim_count(report, "opt.backprop.subjects", all.subjects);
    kw_claim_count(report, "opt.backprop.exact", all.exact);
    kw_claim_count(report, "opt.backprop.slopes", all.slopes);
    kw_claim_count(report, "opt.backprop.differ", all.differ);
    kw_claim_real(report, "opt.backprop.relative", all.relative);
    return kw_out_close(f) | kw_out_close(report);
}
