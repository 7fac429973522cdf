/* Nets with convolutions, pooling and graph convolutions. */
#include "netcheck.h"

/* --- a convolutional net: 2 x 6 x 5 numbers, 3 feature maps, pooled, 2 outputs --- */

static kw_net *new_images(kw_conv_padding padding, kw_pool_kind kind)
{
    kw_net *n = kw_net_new(2 * 6 * 5);
    kw_conv c = kw_conv_layer((kw_conv){.in_channels = 2,
                                        .rows = 6,
                                        .columns = 5,
                                        .out_channels = 3,
                                        .filter_rows = 3,
                                        .filter_columns = 2,
                                        .stride = 1,
                                        .padding = padding});
    kw_pool p = kw_pool_layer((kw_pool){.kind = kind,
                                        .channels = 3,
                                        .rows = c.out_rows,
                                        .columns = c.out_columns,
                                        .window_rows = 2,
                                        .window_columns = 2,
                                        .stride = 2});

    kw_net_add_conv(n, &c);
    kw_net_add_activation(n, KW_TANH);
    kw_net_add_pool(n, &p);
    kw_net_add_affine(n, 2);
    return n;
}

static void gradients_of_convolutional_nets(void)
{
    const kw_conv_padding paddings[] = {KW_CONV_VALID, KW_CONV_SAME, KW_CONV_CIRCULAR};

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++) {
            kw_net *n = new_images(paddings[i], j ? KW_POOL_MAX : KW_POOL_MEAN);

            netcheck_gradient("convolutional", n, 121 + (uint64_t)(2 * i + j));
            kw_net_free(n);
        }
}

static void a_convolutional_net_is_layer_after_layer(void)
{
    kw_net *n = new_images(KW_CONV_SAME, KW_POOL_MAX);
    const kw_layer *l = n->layer;
    netcheck t = netcheck_new(n, 127);
    double a[SAMPLES * 90], b[SAMPLES * 90];

    CHECK(n->parameters == 2 * 3 * 3 * 2 + 3 + 2 * 3 * 3 * 2 + 2, "%d parameters",
          n->parameters);
    netcheck_sum(&t);
    kw_conv_forward(&l[0].is.conv, t.w, SAMPLES, t.x, a);
    kw_activation_forward(&l[1].is.activation, NULL, SAMPLES, a, b);
    kw_pool_forward(&l[2].is.pool, NULL, SAMPLES, b, a);
    kw_affine_forward(&l[3].is.affine, t.w + l[3].first, SAMPLES, a, b);
    for (int i = 0; i < SAMPLES * 2; i++)
        CHECK(t.y[i] == b[i], "output %d: %.17g and %.17g", i, t.y[i], b[i]);
    netcheck_free(&t);
    kw_net_free(n);
}

/* --- a net on a graph of 6 nodes: a circle and a chord --- */

enum { NODES = 6, LAYERS = 4 };

static void new_layers(kw_gcn **layer, int in, int out)
{
    const int end[] = {0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0, 0, 3};
    kw_graph *g = kw_graph_new(NODES, 7, end, NULL);

    layer[0] = kw_gcn_new_spatial(g, in, out);
    layer[1] = kw_gcn_new_spectral(g, in, out);
    layer[2] = kw_gcn_new_chebyshev(g, in, out, 3);
    layer[3] = kw_gcn_new_first_order(g, in, out);
    kw_graph_free(g);
}

static void gradients_of_graph_nets(void)
{
    kw_gcn *hidden[LAYERS], *last[LAYERS];

    new_layers(hidden, 2, 3);
    new_layers(last, 3, 1);
    for (int i = 0; i < LAYERS; i++) {
        kw_net *n = kw_net_new(NODES * 2);

        kw_net_add_gcn(n, hidden[i]);
        kw_net_add_activation(n, KW_SOFTPLUS);
        kw_net_add_gcn(n, last[i]);
        CHECK(n->out == NODES, "%d outputs", n->out);
        CHECK(n->parameters == hidden[i]->parameters + last[i]->parameters,
              "%d parameters", n->parameters);
        netcheck_gradient("graph", n, 128 + (uint64_t)i);
        kw_net_free(n);
        kw_gcn_free(hidden[i]);
        kw_gcn_free(last[i]);
    }
}

/* --- initial parameters --- */

/* The first l->parameters - biases numbers fill [-a, a), the rest is zero. */
static void check_init(const char *name, const kw_layer *l, int biases, double a,
                       const double *w)
{
    double most = 0;
    int weights = l->parameters - biases;

    for (int i = 0; i < weights; i++)
        most = fmax(most, fabs(w[i]));
    /* that all of at least 100 numbers stay below 0.8 has a chance of 0.8^100 < 1e-9 */
    CHECK(weights >= 100 && 0.8 * a < most && most <= a,
          "%s: %d weights up to %g, not %g", name, weights, most, a);
    for (int i = weights; i < l->parameters; i++)
        CHECK(w[i] == 0, "%s: bias %g", name, w[i]);
}

static void initial_filters_have_the_size_of_their_fans(void)
{
    kw_conv c = kw_conv_layer((kw_conv){.in_channels = 4,
                                        .rows = 3,
                                        .columns = 3,
                                        .out_channels = 7,
                                        .filter_rows = 3,
                                        .filter_columns = 2,
                                        .stride = 1,
                                        .padding = KW_CONV_SAME});
    kw_net *n = kw_net_new(c.in);
    double *w;

    kw_net_add_conv(n, &c);
    w = kw_need_memory((size_t)n->parameters, sizeof *w);
    kw_net_init(n, 1, w);
    check_init("filters", n->layer, 7, sqrt(6.0 / (6 * 4 + 6 * 7)), w);
    free(w);
    kw_net_free(n);
}

/* Two matrices meet at a node of a spatial layer, four at one of a Chebyshev layer of
   degree 3, one at a frequency and in a first-order layer. */
static void initial_graph_weights_have_the_size_of_their_fans(void)
{
    enum { IN = 11, OUT = 13 };
    const double meet[LAYERS] = {2, 1, 4, 1};
    kw_gcn *layer[LAYERS];

    new_layers(layer, IN, OUT);
    for (int i = 0; i < LAYERS; i++) {
        kw_net *n = kw_net_new(NODES * IN);
        double *w = kw_need_memory((size_t)layer[i]->parameters, sizeof *w);

        kw_net_add_gcn(n, layer[i]);
        kw_net_init(n, 1, w);
        check_init("graph", n->layer, OUT, sqrt(6.0 / (meet[i] * (IN + OUT))), w);
        free(w);
        kw_net_free(n);
        kw_gcn_free(layer[i]);
    }
}

int main(void)
{
    test_run("net: gradients of convolutional nets", gradients_of_convolutional_nets);
    test_run("net: a convolutional net is layer after layer",
             a_convolutional_net_is_layer_after_layer);
    test_run("net: gradients of nets on graphs", gradients_of_graph_nets);
    test_run("net: initial filters have the size of their fans",
             initial_filters_have_the_size_of_their_fans);
    test_run("net: initial graph weights have the size of their fans",
             initial_graph_weights_have_the_size_of_their_fans);
    return test_end();
}
