#include "mlp.h"
#include "need.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>

enum { MOST = 7 };

static const kw_activation_kind TANH[MOST] = {KW_TANH, KW_TANH, KW_TANH, KW_TANH,
                                              KW_TANH, KW_TANH, KW_TANH};

/* The widths in [..] of the examples, counted. */
static void parameters_are_counted(void)
{
    const struct {
        int L, width[5], parameters;
    } known[] = {{1, {3, 1}, 4},
                 {2, {2, 3, 1}, 13},
                 {4, {4, 5, 3, 2, 2}, 57},
                 {4, {784, 128, 64, 32, 10}, 111146}};

    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        kw_net *n = kw_mlp_new(known[i].L, known[i].width, TANH);

        CHECK(kw_mlp_count(n) == known[i].parameters, "%d, not %d", kw_mlp_count(n),
              known[i].parameters);
        CHECK(n->parameters == known[i].parameters, "%d, not %d", n->parameters,
              known[i].parameters);
        CHECK(kw_mlp_depth(n) == known[i].L, "L = %d, not %d", kw_mlp_depth(n),
              known[i].L);
        kw_net_free(n);
    }
}

/* What a layer says of its number of parameters has no part in the count. */
static void the_count_is_a_trial(void)
{
    const int width[] = {2, 3, 1};
    kw_net *n = kw_mlp_new(2, width, TANH);

    n->layer[0].is.affine.parameters = n->layer[0].parameters = 20;
    n->parameters = 24;
    CHECK(kw_mlp_count(n) == 13, "%d", kw_mlp_count(n));
    kw_net_free(n);
}

static void edges_are_those_of_all_units_with_all(void)
{
    const int width[] = {4, 3};
    kw_net *n = kw_mlp_new(1, width, TANH);
    int edge[12 + 1] = {0};

    edge[12] = 17;
    CHECK(kw_mlp_edges(n, 1, edge) == 12, "%d", kw_mlp_edges(n, 1, edge));
    for (int e = 0; e < 12; e++)
        CHECK(edge[e] == 1, "edge %d: %d", e, edge[e]);
    CHECK(edge[12] == 17, "%d behind the end", edge[12]);
    kw_net_free(n);
}

static void random_widths(kw_rng *r, int *L, int *width)
{
    *L = 1 + kw_rng_below(r, MOST);
    for (int l = 0; l <= *L; l++)
        width[l] = 1 + kw_rng_below(r, 6);
}

/* Each weight and each bias has a place of its own, and all places are taken. */
static void every_parameter_has_its_place(void)
{
    kw_rng r = kw_rng_at(141, 0, 0, 0);

    for (int turn = 0; turn < 100; turn++) {
        int L, width[MOST + 1], first, count = 0;
        kw_net *n;
        int *uses;

        random_widths(&r, &L, width);
        n = kw_mlp_new(L, width, TANH);
        uses = kw_need_memory((size_t)n->parameters, sizeof *uses);
        for (int l = 1; l <= L; l++) {
            const kw_affine *a = kw_mlp_affine(n, l, &first);

            CHECK(a->in == width[l - 1] && a->out == width[l], "layer %d: %d -> %d", l,
                  a->in, a->out);
            CHECK(kw_mlp_count_weights(n, l) == width[l] * width[l - 1], "layer %d", l);
            CHECK(kw_mlp_count_biases(n, l) == width[l], "layer %d", l);
            for (int i = 0; i < a->out; i++) {
                uses[first + kw_affine_bias(a, i)]++;
                for (int j = 0; j < a->in; j++)
                    uses[first + kw_affine_weight(a, i, j)]++;
            }
            count += kw_mlp_count_weights(n, l) + kw_mlp_count_biases(n, l);
        }
        CHECK(count == n->parameters && count == kw_mlp_count(n), "%d, %d and %d", count,
              n->parameters, kw_mlp_count(n));
        for (int p = 0; p < n->parameters; p++)
            CHECK(uses[p] == 1, "parameter %d is used %d times", p, uses[p]);
        free(uses);
        kw_net_free(n);
    }
}

/* Definition 10 with sigma_l = tanh before the last layer, unit by unit. */
static void realize(const kw_net *n, const double *w, const double *p, double *out)
{
    int L = kw_mlp_depth(n), first;
    double phi[MOST] = {0}, next[MOST] = {0};

    for (int j = 0; j < n->in; j++)
        phi[j] = p[j];
    for (int l = 1; l <= L; l++) {
        const kw_affine *a = kw_mlp_affine(n, l, &first);

        for (int i = 0; i < a->out; i++) {
            next[i] = w[first + kw_affine_bias(a, i)];
            for (int j = 0; j < a->in; j++)
                next[i] += w[first + kw_affine_weight(a, i, j)] * phi[j];
        }
        for (int i = 0; i < a->out; i++)
            phi[i] = l < L ? kw_activation_value(KW_TANH, next[i]) : next[i];
    }
    for (int i = 0; i < n->out; i++)
        out[i] = phi[i];
}

static void forward_is_definition_10(void)
{
    enum { COUNT = 4 };
    kw_rng r = kw_rng_at(142, 0, 0, 0);

    for (int turn = 0; turn < 100; turn++) {
        int L, width[MOST + 1];
        double x[COUNT * MOST] = {0}, y[COUNT * MOST], phi[MOST], *w;
        kw_activation_kind sigma[MOST];
        kw_net_work *k;
        kw_net *n;

        random_widths(&r, &L, width);
        for (int l = 1; l <= L; l++)
            sigma[l - 1] = l < L ? KW_TANH : KW_IDENTITY;
        n = kw_mlp_new(L, width, sigma);
        k = kw_net_work_new(n, COUNT);
        CHECK(n->layers == 2 * L - 1, "%d layers, L = %d", n->layers, L);
        w = kw_need_memory((size_t)n->parameters, sizeof *w);
        for (int p = 0; p < n->parameters; p++)
            w[p] = test_random_in(&r, -1, 1);
        for (int i = 0; i < COUNT * n->in; i++)
            x[i] = test_random_in(&r, -1, 1);
        kw_net_forward(n, w, COUNT, x, k, y);
        for (int s = 0; s < COUNT; s++) {
            realize(n, w, x + s * n->in, phi);
            for (int i = 0; i < n->out; i++)
                CHECK(y[s * n->out + i] == phi[i], "output %d: %.17g, not %.17g", i,
                      y[s * n->out + i], phi[i]);
        }
        free(w);
        kw_net_work_free(k);
        kw_net_free(n);
    }
}

/* (21): the sign of an affine function, +1 where that is zero. */
static void a_perceptron_is_one_layer(void)
{
    const int width[] = {2, 1};
    const kw_activation_kind sign = KW_SIGN;
    const double w[] = {2, -1, 3}, x[] = {0, 0, 0, 3, 0, 4, -2, -1};
    kw_net *n = kw_mlp_new(1, width, &sign);
    kw_net_work *k = kw_net_work_new(n, 4);
    double y[4];

    kw_net_forward(n, w, 4, x, k, y);
    CHECK(y[0] == 1 && y[1] == 1 && y[2] == -1 && y[3] == 1, "%g %g %g %g", y[0], y[1],
          y[2], y[3]); /* 3, 0, -1, 0 */
    kw_net_work_free(k);
    kw_net_free(n);
}

/* --- misuse --- */

static kw_net *small(void)
{
    const int width[] = {2, 3, 1};

    return kw_mlp_new(2, width, TANH);
}

static void no_layer(void)
{
    const int width[] = {2};

    kw_mlp_new(0, width, TANH);
}

static void no_unit(void)
{
    const int width[] = {2, 0, 1};

    kw_mlp_new(2, width, TANH);
}

static void layer_zero(void)
{
    int first;

    kw_mlp_affine(small(), 0, &first);
}

static void layer_three(void)
{
    kw_mlp_count_weights(small(), 3);
}

static void no_perceptron(void)
{
    kw_net *n = small();
    kw_pool l = kw_pool_layer((kw_pool){.channels = 1,
                                        .rows = 1,
                                        .columns = 1,
                                        .window_rows = 1,
                                        .window_columns = 1,
                                        .stride = 1});

    kw_net_add_pool(n, &l);
    kw_mlp_count(n);
}

static void misuse_aborts(void)
{
    test_aborts("L = 0", no_layer);
    test_aborts("in = 2, out = 0", no_unit);
    test_aborts("layer 0, not in 1 .. 2", layer_zero);
    test_aborts("layer 3, not in 1 .. 2", layer_three);
    test_aborts("layer 4 is no layer of a perceptron", no_perceptron);
}

int main(void)
{
    test_run("mlp: parameters are counted", parameters_are_counted);
    test_run("mlp: the count is a trial", the_count_is_a_trial);
    test_run("mlp: edges are those of all units with all",
             edges_are_those_of_all_units_with_all);
    test_run("mlp: every parameter has its place", every_parameter_has_its_place);
    test_run("mlp: forward is Definition 10", forward_is_definition_10);
    test_run("mlp: a perceptron is one layer", a_perceptron_is_one_layer);
    test_run("mlp: misuse aborts", misuse_aborts);
    return test_end();
}
