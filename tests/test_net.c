#include "netcheck.h"

/* 3 - 5 - 4 - 2 with an activation behind the first two affine layers */
static kw_net *new_net(kw_activation_kind kind)
{
    kw_net *n = kw_net_new(3);

    kw_net_add_affine(n, 5);
    kw_net_add_activation(n, kind);
    kw_net_add_affine(n, 4);
    kw_net_add_activation(n, kind);
    kw_net_add_affine(n, 2);
    return n;
}

static void layers_and_parameters_are_in_order(void)
{
    const int out[] = {5, 5, 4, 4, 2}, first[] = {0, 20, 20, 44, 44};
    kw_net *n = new_net(KW_TANH);

    CHECK(n->in == 3 && n->out == 2 && n->layers == 5 && n->parameters == 54,
          "%d -> %d, %d layers, %d parameters", n->in, n->out, n->layers, n->parameters);
    for (int l = 0; l < n->layers; l++) {
        CHECK(n->layer[l].in == (l > 0 ? out[l - 1] : 3), "layer %d", l);
        CHECK(n->layer[l].out == out[l] && n->layer[l].first == first[l], "layer %d", l);
        CHECK(n->layer[l].kind == (l % 2 ? KW_LAYER_ACTIVATION : KW_LAYER_AFFINE),
              "layer %d", l);
    }
    kw_net_free(n);
}

static void forward_is_layer_after_layer(void)
{
    kw_net *n = new_net(KW_ELU);
    netcheck t = netcheck_new(n, 101);
    double a[SAMPLES * 5], b[SAMPLES * 5];

    netcheck_sum(&t);
    kw_affine_forward(&n->layer[0].is.affine, t.w, SAMPLES, t.x, a);
    kw_activation_forward(&n->layer[1].is.activation, NULL, SAMPLES, a, b);
    kw_affine_forward(&n->layer[2].is.affine, t.w + 20, SAMPLES, b, a);
    kw_activation_forward(&n->layer[3].is.activation, NULL, SAMPLES, a, b);
    kw_affine_forward(&n->layer[4].is.affine, t.w + 44, SAMPLES, b, a);
    for (int i = 0; i < SAMPLES * 2; i++)
        CHECK(t.y[i] == a[i], "output %d: %.17g and %.17g", i, t.y[i], a[i]);
    netcheck_free(&t);
    kw_net_free(n);
}

/* Sign and step have no derivative to be seen; they come next. */
static void gradients_are_limits_of_differences(void)
{
    for (int i = 0; i < KW_ACTIVATION_KINDS; i++) {
        kw_activation_kind kind = (kw_activation_kind)i;
        kw_net *n = new_net(kind);

        if (kind != KW_SIGN && kind != KW_STEP)
            netcheck_gradient(kw_activation_name(kind), n, 102 + (uint64_t)i);
        kw_net_free(n);
    }
}

/* What lies before a jump has the derivative zero, what lies behind it has not. */
static void nothing_comes_back_through_a_jump(void)
{
    kw_net *n = new_net(KW_SIGN);
    netcheck t = netcheck_new(n, 113);
    double dw[54] = {0}, dx[SAMPLES * 3];

    netcheck_sum(&t);
    kw_net_backward(n, t.w, SAMPLES, t.x, t.y, t.c, t.k, dx, dw);
    for (int p = 0; p < 54; p++)
        CHECK((dw[p] != 0) == (p >= 44), "parameter %d: %g", p, dw[p]);
    for (int i = 0; i < SAMPLES * 3; i++)
        CHECK(dx[i] == 0, "input %d: %g", i, dx[i]);
    netcheck_free(&t);
    kw_net_free(n);
}

static void a_batch_is_one_sample_after_the_other(void)
{
    kw_net *n = new_net(KW_GELU);
    netcheck t = netcheck_new(n, 114);
    double all[54], each[54], y[2], dx[SAMPLES * 3], one[3];

    for (int p = 0; p < 54; p++)
        all[p] = each[p] = p; /* the gradient is added to what is there */
    netcheck_sum(&t);
    kw_net_backward(n, t.w, SAMPLES, t.x, t.y, t.c, t.k, dx, all);
    for (int s = 0; s < SAMPLES; s++) {
        kw_net_forward(n, t.w, 1, t.x + 3 * s, t.k, y);
        kw_net_backward(n, t.w, 1, t.x + 3 * s, y, t.c + 2 * s, t.k, one, each);
        CHECK(netcheck_unlike(2, y, t.y + 2 * s) == 0, "outputs of sample %d", s);
        CHECK(netcheck_unlike(3, one, dx + 3 * s) == 0, "derivatives, sample %d", s);
    }
    CHECK(netcheck_unlike(54, all, each) == 0, "the gradients differ");
    netcheck_sum(&t);
    kw_net_backward(n, t.w, SAMPLES, t.x, t.y, t.c, t.k, NULL, each);
    /* once more on top: two times three roundings of numbers below 64 = 2^6 */
    for (int p = 0; p < 54; p++)
        CHECK(fabs(each[p] - all[p] - (all[p] - p)) <= 8 * 64 * 0x1p-53 &&
                  each[p] != all[p],
              "parameter %d without dx: %g after %g", p, each[p], all[p]);
    netcheck_free(&t);
    kw_net_free(n);
}

/* --- initial parameters --- */

static void initial_weights_are_even_and_biases_zero(void)
{
    enum { IN = 30, OUT = 70, WEIGHTS = IN * OUT };
    kw_net *n = kw_net_new(IN);
    double w[WEIGHTS + OUT], a = sqrt(6.0 / (IN + OUT)), sum = 0, square = 0, most = 0;

    kw_net_add_affine(n, OUT);
    kw_net_init(n, 5, w);
    for (int i = 0; i < WEIGHTS; i++) {
        CHECK(-a <= w[i] && w[i] < a, "weight %d: %g", i, w[i]);
        sum += w[i] / a;
        square += w[i] * w[i] / (a * a);
        most = fmax(most, fabs(w[i]));
    }
    /* six standard deviations of a mean of numbers uniform in [-1,1), or of their squares:
       1/sqrt(3) and 2/sqrt(45) */
    CHECK(fabs(sum / WEIGHTS) <= 6 / sqrt(3.0 * WEIGHTS), "mean %g", sum / WEIGHTS);
    CHECK(fabs(square / WEIGHTS - 1.0 / 3) <= 12 / sqrt(45.0 * WEIGHTS), "square %g",
          square / WEIGHTS);
    CHECK(most > 0.95 * a, "at most %g", most); /* else a chance of 0.95^2100 */
    for (int i = 0; i < OUT; i++)
        CHECK(w[WEIGHTS + i] == 0, "bias %d: %g", i, w[WEIGHTS + i]);
    kw_net_free(n);
}

/* Layers and seeds have numbers of their own; later layers change nothing in earlier ones. */
static void initial_weights_depend_on_seed_and_layer(void)
{
    kw_net *n = kw_net_new(4), *longer = kw_net_new(4);
    double w[40], again[40], other[40], more[60];

    for (int l = 0; l < 2; l++)
        kw_net_add_affine(n, 4);
    for (int l = 0; l < 3; l++)
        kw_net_add_affine(longer, 4);
    kw_net_init(n, 1, w);
    kw_net_init(n, 1, again);
    kw_net_init(n, 2, other);
    kw_net_init(longer, 1, more);
    CHECK(netcheck_unlike(40, w, again) == 0, "one seed, two results");
    CHECK(netcheck_unlike(40, w, more) == 0, "a later layer changes earlier ones");
    for (int i = 0; i < 16; i++) {
        CHECK(w[i] != other[i], "weight %d is the same for two seeds", i);
        CHECK(w[i] != w[20 + i], "weight %d is the same in two layers", i);
    }
    kw_net_free(n);
    kw_net_free(longer);
}

/* --- misuse --- */

static double number[100];

static void forward(int count, int work, int at, double value)
{
    kw_net *n = new_net(KW_TANH);
    double x[30] = {0}, y[20];

    x[at] = value;
    kw_net_forward(n, number, count, x, kw_net_work_new(n, work), y);
}

static void nan_at_the_input(void)
{
    forward(2, 2, 4, NAN);
}

static void infinity_at_the_input(void)
{
    forward(1, 1, 0, -INFINITY);
}

static void inputs_are_finite(void)
{
    test_aborts("input 1 of sample 1 is nan", nan_at_the_input);
    test_aborts("input 0 of sample 0 is -inf", infinity_at_the_input);
}

/* Only the samples of the batch are looked at. */
static void what_lies_behind_the_batch_may_be_nan(void)
{
    kw_net *n = new_net(KW_TANH);
    netcheck t = netcheck_new(n, 115);
    double x[] = {1, 2, 3, NAN}, y[2];

    kw_net_forward(n, t.w, 1, x, t.k, y);
    CHECK(isfinite(y[0]) && isfinite(y[1]), "%g %g", y[0], y[1]);
    netcheck_free(&t);
    kw_net_free(n);
}

static void no_samples(void)
{
    forward(0, 2, 0, 0);
}

static void too_many_samples(void)
{
    forward(3, 2, 0, 0);
}

static void memory_for_none(void)
{
    forward(1, 0, 0, 0);
}

static void memory_of_another_net(void)
{
    kw_net *n = new_net(KW_TANH);
    kw_net_work *k = kw_net_work_new(n, 1);

    kw_net_add_activation(n, KW_TANH);
    kw_net_forward(n, number, 1, number, k, number);
}

/* 1 - out - 1 */
static kw_net *as_wide_as(int out)
{
    kw_net *n = kw_net_new(1);

    kw_net_add_affine(n, out);
    kw_net_add_affine(n, 1);
    return n;
}

static void memory_of_a_narrow_net(void)
{
    kw_net_forward(as_wide_as(20), number, 1, number, kw_net_work_new(as_wide_as(2), 1),
                   number);
}

static void back_with_the_memory_of_a_narrow_net(void)
{
    kw_net *narrow = as_wide_as(2);
    kw_net_work *k = kw_net_work_new(narrow, 1);
    double dw[61];

    kw_net_forward(narrow, number, 1, number, k, number);
    kw_net_backward(as_wide_as(20), number, 1, number, number, number, k, NULL, dw);
}

static void back_without_forth(void)
{
    kw_net *n = new_net(KW_TANH);

    kw_net_backward(n, number, 1, number, number, number, kw_net_work_new(n, 1), NULL,
                    number);
}

static void no_layers(void)
{
    kw_net_work_new(kw_net_new(1), 1);
}

static void no_inputs(void)
{
    kw_net_new(0);
}

static void a_pool_that_does_not_fit(void)
{
    kw_pool l = kw_pool_layer((kw_pool){.kind = KW_POOL_MAX,
                                        .channels = 1,
                                        .rows = 1,
                                        .columns = 4,
                                        .window_rows = 1,
                                        .window_columns = 2,
                                        .stride = 2});

    kw_net_add_pool(new_net(KW_TANH), &l);
}

static void too_many_parameters(void)
{
    kw_net *n = kw_net_new(32768);

    kw_net_add_affine(n, 32768);
    kw_net_add_affine(n, 32768);
}

static void misuse_aborts(void)
{
    test_aborts("0 samples, not in 1 .. 2", no_samples);
    test_aborts("3 samples, not in 1 .. 2", too_many_samples);
    test_aborts("0 samples", memory_for_none);
    test_aborts("6 layers, memory for 5", memory_of_another_net);
    test_aborts("layer 0 gives 20 numbers, memory for 2", memory_of_a_narrow_net);
    test_aborts("layer 0 gives 20 numbers, memory for 2",
                back_with_the_memory_of_a_narrow_net);
    test_aborts("1 samples back, 0 forward", back_without_forth);
    test_aborts("0 layers", no_layers);
    test_aborts("in = 0", no_inputs);
    test_aborts("layer 5 takes 4 numbers, but there are 2", a_pool_that_does_not_fit);
    test_aborts("1073774592 and 1073774592 parameters, more than 2147483647",
                too_many_parameters);
}

static void nothing_may_be_freed(void)
{
    kw_net_free(NULL);
    kw_net_work_free(NULL);
}

int main(void)
{
    test_run("net: layers and parameters are in order",
             layers_and_parameters_are_in_order);
    test_run("net: forward is layer after layer", forward_is_layer_after_layer);
    test_run("net: gradients are limits of differences",
             gradients_are_limits_of_differences);
    test_run("net: nothing comes back through a jump", nothing_comes_back_through_a_jump);
    test_run("net: a batch is one sample after the other",
             a_batch_is_one_sample_after_the_other);
    test_run("net: initial weights are even, biases zero",
             initial_weights_are_even_and_biases_zero);
    test_run("net: initial weights depend on seed and layer",
             initial_weights_depend_on_seed_and_layer);
    test_run("net: NaN and infinite inputs abort", inputs_are_finite);
    test_run("net: what lies behind the batch may be NaN",
             what_lies_behind_the_batch_may_be_nan);
    test_run("net: misuse aborts", misuse_aborts);
    test_run("net: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
