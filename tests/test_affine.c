#include "affine.h"
#include "test.h"
#include <stddef.h>

enum { COUNT = 5, MOST = 9, ROOM = MOST * MOST + MOST };

/* Whole numbers so small that all sums are exact. */
static void whole(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = kw_rng_below(r, 19) - 9;
}

/* The sum over a batch of c_si y_si with y = W x + b, straight from the definition. */
static double weighted_sum(const kw_affine *l, const double *w, const double *x,
                           const double *c)
{
    double sum = 0;

    for (int s = 0; s < COUNT; s++)
        for (int i = 0; i < l->out; i++) {
            double y = w[kw_affine_bias(l, i)];

            for (int j = 0; j < l->in; j++)
                y += w[kw_affine_weight(l, i, j)] * x[s * l->in + j];
            sum += c[s * l->out + i] * y;
        }
    return sum;
}

typedef struct batch {
    kw_affine l;
    double w[ROOM], x[COUNT * MOST], y[COUNT * MOST], dy[COUNT * MOST];
} batch;

static batch random_batch(kw_rng *r, int in, int out)
{
    batch b = {.l = kw_affine_layer(in, out)};

    whole(r, b.l.parameters, b.w);
    whole(r, COUNT * in, b.x);
    whole(r, COUNT * out, b.dy);
    kw_affine_forward(&b.l, b.w, COUNT, b.x, b.y);
    return b;
}

static void forward_is_the_definition(void)
{
    kw_rng r = kw_rng_at(91, 0, 0, 0);

    for (int in = 1; in <= MOST; in++)
        for (int out = 1; out <= MOST; out++) {
            batch b = random_batch(&r, in, out);

            for (int s = 0; s < COUNT; s++)
                for (int i = 0; i < out; i++) {
                    double one[COUNT * MOST] = {0};

                    one[s * out + i] = 1;
                    CHECK(b.y[s * out + i] == weighted_sum(&b.l, b.w, b.x, one),
                          "%d -> %d: y_%d of sample %d is %g", in, out, i, s,
                          b.y[s * out + i]);
                }
        }
}

/* y is linear in w and in x by itself, so a difference with the step 1 is the derivative; in
   whole numbers it is exact. */
static void backward_is_the_derivative(void)
{
    kw_rng r = kw_rng_at(92, 0, 0, 0);

    for (int in = 1; in <= MOST; in++)
        for (int out = 1; out <= MOST; out++) {
            batch b = random_batch(&r, in, out);
            double before = weighted_sum(&b.l, b.w, b.x, b.dy), dx[COUNT * MOST];
            double dw[ROOM], there[ROOM] = {0};

            whole(&r, b.l.parameters, dw);
            for (int p = 0; p < b.l.parameters; p++)
                there[p] = dw[p];
            test_poison(dx, COUNT * MOST);
            kw_affine_backward(&b.l, b.w, COUNT, b.x, b.y, b.dy, dx, dw);
            for (int p = 0; p < b.l.parameters; p++) {
                b.w[p] += 1;
                CHECK(dw[p] - there[p] == weighted_sum(&b.l, b.w, b.x, b.dy) - before,
                      "%d -> %d: parameter %d", in, out, p);
                b.w[p] -= 1;
            }
            for (int i = 0; i < COUNT * in; i++) {
                b.x[i] += 1;
                CHECK(dx[i] == weighted_sum(&b.l, b.w, b.x, b.dy) - before,
                      "%d -> %d: input %d", in, out, i);
                b.x[i] -= 1;
            }
        }
}

static void derivatives_of_inputs_are_not_always_wanted(void)
{
    kw_rng r = kw_rng_at(93, 0, 0, 0);
    batch b = random_batch(&r, 4, 3);
    double dx[COUNT * 4], with[15] = {0}, without[15] = {0};

    kw_affine_backward(&b.l, b.w, COUNT, b.x, b.y, b.dy, dx, with);
    kw_affine_backward(&b.l, b.w, COUNT, b.x, b.y, b.dy, NULL, without);
    for (int p = 0; p < 15; p++)
        CHECK(with[p] == without[p], "parameter %d: %g and %g", p, with[p], without[p]);
}

static void every_parameter_has_its_place(void)
{
    kw_affine l = kw_affine_layer(4, 3);
    int at = 0;

    CHECK(l.in == 4 && l.out == 3 && l.parameters == 15, "%d %d %d", l.in, l.out,
          l.parameters);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            CHECK(kw_affine_weight(&l, i, j) == at++, "weight %d %d", i, j);
    for (int i = 0; i < 3; i++)
        CHECK(kw_affine_bias(&l, i) == at++, "bias %d", i);
}

/* --- misuse --- */

static double number[1];

static void no_input(void)
{
    kw_affine_layer(0, 3);
}

static void no_output(void)
{
    kw_affine_layer(3, -1);
}

static void too_large(void)
{
    kw_affine_layer(65536, 32768);
}

static void no_samples(void)
{
    kw_affine l = kw_affine_layer(1, 1);

    kw_affine_forward(&l, number, 0, number, number);
}

static void no_samples_back(void)
{
    kw_affine l = kw_affine_layer(1, 1);

    kw_affine_backward(&l, number, -2, number, number, number, NULL, number);
}

static void weight_beyond(void)
{
    kw_affine l = kw_affine_layer(4, 3);

    kw_affine_weight(&l, 2, 4);
}

static void bias_beyond(void)
{
    kw_affine l = kw_affine_layer(4, 3);

    kw_affine_bias(&l, 3);
}

static void misuse_aborts(void)
{
    const kw_affine largest = kw_affine_layer(65535, 32767);

    CHECK(largest.parameters == 65536 * 32767, "%d", largest.parameters);
    test_aborts("in = 0, out = 3", no_input);
    test_aborts("in = 3, out = -1", no_output);
    test_aborts("more than 2147483647", too_large);
    test_aborts("0 samples", no_samples);
    test_aborts("-2 samples", no_samples_back);
    test_aborts("weight (2, 4) of 3 x 4 weights", weight_beyond);
    test_aborts("bias 3 of 3 biases", bias_beyond);
}

int main(void)
{
    test_run("affine: forward is the definition", forward_is_the_definition);
    test_run("affine: backward is the derivative, exactly, and is added",
             backward_is_the_derivative);
    test_run("affine: derivatives of inputs are not always wanted",
             derivatives_of_inputs_are_not_always_wanted);
    test_run("affine: every parameter has its place", every_parameter_has_its_place);
    test_run("affine: misuse aborts", misuse_aborts);
    return test_end();
}
