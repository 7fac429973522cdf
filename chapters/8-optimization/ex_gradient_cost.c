/* The cost of a gradient -- counted in multiply-adds, from the shapes of the layers.

   What to see: (a) by backpropagation a gradient costs less than three values, however many
   parameters there are; by differences it costs two values for each of them. (b) Why: it is a
   sum over all paths through the graph, but every edge is passed three times at most.

   Book: section 1.2, Optimization.
   Claims: opt.cost.*, opt.batch.*
   Chosen here: all architectures, and what is counted (cost.h). */

#include "claim.h"      /* what we found, for the ledger */
#include "cost.h"       /* the counts */
#include "mlp.h"        /* networks */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include "rng.h"        /* architectures, weights */
#include "supervised.h" /* gradients of batches */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NETS = 1000, LAYERS = 6, WIDEST = 64, SAMPLES = 32, BATCH = 8 };

/* --- the layers count for themselves --- */

static double sum_of(int count, const double *a)
{
    double sum = 0;

    for (int i = 0; i < count; i++)
        sum += a[i];
    return sum;
}

/* With inputs, weights and derivatives of one and no bias every product is one, and the sum
   of the results is their number. Is the count another? n has one layer, affine or
   convolutional, whose last parameters are the biases; it is freed. */
static int is_miscounted(kw_net *n, int biases)
{
    kw_net_work *work = kw_net_work_new(n, 1);
    int weights = n->parameters - biases, most = n->parameters + n->in + n->out, wrong;
    double *a = kw_need_memory(4 * (size_t)most, sizeof *a);
    double *w = a, *one = w + most, *dw = one + most, *dx = dw + n->parameters;
    double *y = dw + most;
    cost c = layer_cost(&n->layer[0]);

    for (int i = 0; i < most; i++) {
        w[i] = i < weights;
        one[i] = 1;
    }
    kw_net_forward(n, w, 1, one, work, y);
    kw_net_backward(n, w, 1, one, y, one, work, dx, dw);
    wrong = sum_of(n->out, y) != c.forward || sum_of(n->in, dx) != c.inputs ||
            sum_of(weights, dw) != c.weights;
    free(a);
    kw_net_work_free(work);
    kw_net_free(n);
    return wrong;
}

/* An integer, uniform in 1..n. */
static int up_to(kw_rng *r, int n)
{
    return 1 + kw_rng_below(r, n);
}

static kw_conv random_conv(kw_rng *r)
{
    kw_conv l = {.padding = (kw_conv_padding)kw_rng_below(r, 3)};

    l.in_channels = up_to(r, 3);
    l.rows = up_to(r, 8);
    l.columns = up_to(r, 8);
    l.out_channels = up_to(r, 3);
    l.filter_rows = up_to(r, l.rows);
    l.filter_columns = up_to(r, l.columns);
    l.stride = up_to(r, 3);
    return kw_conv_layer(l);
}

/* Random layers whose count is not what they do. */
static int count_miscounted(void)
{
    int wrong = 0;

    for (uint64_t sample = 0; sample < NETS; sample++) {
        kw_rng r = kw_rng_at(81, 0, sample, 0);
        kw_conv conv = random_conv(&r);
        kw_net *affine = kw_net_new(up_to(&r, WIDEST)), *grid = kw_net_new(conv.in);

        kw_net_add_affine(affine, up_to(&r, WIDEST));
        kw_net_add_conv(grid, &conv);
        wrong += is_miscounted(affine, affine->out);
        wrong += is_miscounted(grid, conv.out_channels);
    }
    return wrong;
}

/* --- gradients against values --- */

static kw_net *new_mlp(int L, const int *width)
{
    kw_activation_kind sigma[LAYERS];

    for (int l = 0; l < L; l++)
        sigma[l] = l < L - 1 ? KW_TANH : KW_IDENTITY;
    return kw_mlp_new(L, width, sigma);
}

/* The least and the most that a gradient costs, in values, over random architectures. */
static void report_ratios(kw_out *report)
{
    double least = INFINITY, most = 0;

    for (uint64_t sample = 0; sample < NETS; sample++) {
        kw_rng r = kw_rng_at(82, 0, sample, 0);
        int width[LAYERS + 1], L = up_to(&r, LAYERS);
        kw_net *n;
        totals t;

        for (int l = 0; l <= L; l++)
            width[l] = up_to(&r, WIDEST);
        n = new_mlp(L, width);
        t = net_cost(n);
        least = fmin(least, t.gradient / t.value);
        most = fmax(most, t.gradient / t.value);
        kw_net_free(n);
    }
    kw_claim_real(report, "opt.cost.mlp.least", least);
    kw_claim_real(report, "opt.cost.mlp.most", most);
}

/* A convolutional network on images of 32 x 32. */
static kw_net *new_cnn(void)
{
    const kw_conv first = kw_conv_layer((kw_conv){.in_channels = 1,
                                                  .rows = 32,
                                                  .columns = 32,
                                                  .out_channels = 8,
                                                  .filter_rows = 3,
                                                  .filter_columns = 3,
                                                  .stride = 1,
                                                  .padding = KW_CONV_SAME});
    const kw_pool pool = kw_pool_layer((kw_pool){.kind = KW_POOL_MAX,
                                                 .channels = 8,
                                                 .rows = 32,
                                                 .columns = 32,
                                                 .window_rows = 2,
                                                 .window_columns = 2,
                                                 .stride = 2});
    const kw_conv second = kw_conv_layer((kw_conv){.in_channels = 8,
                                                   .rows = 16,
                                                   .columns = 16,
                                                   .out_channels = 16,
                                                   .filter_rows = 3,
                                                   .filter_columns = 3,
                                                   .stride = 1,
                                                   .padding = KW_CONV_SAME});
    kw_net *n = kw_net_new(first.in);

    kw_net_add_conv(n, &first);
    kw_net_add_activation(n, KW_RELU);
    kw_net_add_pool(n, &pool);
    kw_net_add_conv(n, &second);
    kw_net_add_activation(n, KW_RELU);
    kw_net_add_affine(n, 10);
    return n;
}

/* Two Chebyshev layers of degree 3 on a circle of 100 nodes. */
static double gcn_ratio(void)
{
    enum { NODES = 100, CHANNELS = 16 };
    int end[2 * NODES];
    kw_graph *g;
    kw_gcn *first, *second;
    kw_net *n;
    totals t;

    for (int i = 0; i < NODES; i++) {
        end[2 * i] = i;
        end[2 * i + 1] = (i + 1) % NODES;
    }
    g = kw_graph_new(NODES, NODES, end, NULL);
    first = kw_gcn_new_chebyshev(g, 1, CHANNELS, 3);
    second = kw_gcn_new_chebyshev(g, CHANNELS, CHANNELS, 3);
    n = kw_net_new(first->in);
    kw_net_add_gcn(n, first);
    kw_net_add_activation(n, KW_RELU);
    kw_net_add_gcn(n, second);
    t = net_cost(n);
    kw_net_free(n);
    kw_gcn_free(first);
    kw_gcn_free(second);
    kw_graph_free(g);
    return t.gradient / t.value;
}

/* One net: its costs, and that of a gradient by central differences, two values for each
   parameter. The net is freed. */
static void report_net(kw_out *report, const char *name, kw_net *n)
{
    static const char *const what[] = {"parameters", "value", "gradient", "differences"};
    totals t = net_cost(n);
    const long long count[] = {n->parameters, (long long)t.value, (long long)t.gradient,
                               2LL * n->parameters};
    char id[40];

    for (int i = 0; i < 4; i++) {
        snprintf(id, sizeof id, "opt.cost.%s.%s", name, what[i]);
        kw_claim_count(report, id, count[i]);
    }
    kw_net_free(n);
}

static void report_nets(kw_out *report)
{
    kw_net *cnn = new_cnn();
    totals t = net_cost(cnn);

    report_net(report, "small", new_mlp(3, (const int[]){2, 64, 64, 1}));
    report_net(report, "large", new_mlp(3, (const int[]){10000, 10000, 10000, 1000}));
    kw_claim_real(report, "opt.cost.cnn", t.gradient / t.value);
    kw_claim_real(report, "opt.cost.gcn", gcn_ratio());
    kw_net_free(cnn);
}

static void write_widths(kw_out *f)
{
    kw_out_section(f, "widths", "parameters value gradient differences");
    for (int width = 1; width <= 1024; width *= 2) {
        kw_net *n = new_mlp(3, (const int[]){2, width, width, 1});
        totals t = net_cost(n);

        kw_out_number(f, n->parameters);
        kw_out_number(f, t.value);
        kw_out_number(f, t.gradient);
        kw_out_number(f, 2.0 * n->parameters * t.value);
        kw_out_row(f);
        kw_net_free(n);
    }
}

/* Four units a layer: edges and paths, as the network grows deeper. */
static void write_depths(kw_out *f)
{
    enum { WIDTH = 4 };
    double paths = WIDTH;

    kw_out_section(f, "depths", "L edges paths");
    for (int L = 1; L <= 10; L++) {
        paths *= WIDTH;
        kw_out_number(f, L);
        kw_out_number(f, L * WIDTH * WIDTH);
        kw_out_number(f, paths);
        kw_out_row(f);
    }
}

/* --- many examples --- */

/* The gradient of the mean over all samples is the mean of the gradients of the batches that
   they are cut into: entries where it is not. *alone: entries where that of the first batch is
   another. */
static int count_batches_off(int *alone)
{
    enum { IN = 3, PARAMETERS = IN + 1, BATCHES = SAMPLES / BATCH };
    kw_rng r = kw_rng_at(84, 0, 0, 0);
    double x[SAMPLES * IN], target[SAMPLES], w[PARAMETERS], all[PARAMETERS];
    double sum[PARAMETERS] = {0}, part[PARAMETERS];
    int sample[SAMPLES], off = 0;
    kw_net *n = new_mlp(1, (const int[]){IN, 1});
    kw_supervised *s;

    for (int i = 0; i < SAMPLES * IN; i++)
        x[i] = kw_rng_below(&r, 19) - 9;
    for (int i = 0; i < SAMPLES; i++) {
        target[i] = kw_rng_below(&r, 19) - 9;
        sample[i] = i;
    }
    for (int i = 0; i < PARAMETERS; i++)
        w[i] = kw_rng_below(&r, 19) - 9;
    s = kw_supervised_new(n, kw_loss_squared, SAMPLES, x, target, SAMPLES);
    kw_supervised_mean(s, SAMPLES, sample, w, all);
    *alone = 0;
    for (int b = 0; b < BATCHES; b++) {
        kw_supervised_mean(s, BATCH, sample + b * BATCH, w, part);
        for (int i = 0; i < PARAMETERS; i++) {
            sum[i] += part[i] / BATCHES;
            *alone += b == 0 && part[i] != all[i];
        }
    }
    for (int i = 0; i < PARAMETERS; i++)
        off += sum[i] != all[i];
    kw_supervised_free(s);
    kw_net_free(n);
    return off;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_gradient_cost"),
           *report = kw_claim_new("ex_gradient_cost");
    int alone;

    write_widths(f);
    write_depths(f);

    kw_claim_count(report, "opt.cost.miscounted", count_miscounted());
    report_ratios(report);
    report_nets(report);
    kw_claim_count(report, "opt.batch.mean", count_batches_off(&alone));
    kw_claim_count(report, "opt.batch.alone", alone);
    return kw_out_close(f) | kw_out_close(report);
}
