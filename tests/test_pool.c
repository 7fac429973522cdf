#include "pool.h"
#include "need.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>

enum { ROUNDS = 300, SIDE = 7, CHANNELS = 3, MOST = CHANNELS * SIDE * SIDE, COUNT = 3 };

static kw_pool random_layer(kw_rng *r, kw_pool_kind kind)
{
    kw_pool l = {.kind = kind,
                 .channels = 1 + kw_rng_below(r, CHANNELS),
                 .rows = kw_rng_below(r, 3) ? 1 + kw_rng_below(r, SIDE) : 1,
                 .columns = 1 + kw_rng_below(r, SIDE),
                 .stride = 1 + kw_rng_below(r, 3)};

    l.window_rows = 1 + kw_rng_below(r, l.rows);
    l.window_columns = 1 + kw_rng_below(r, l.columns);
    return kw_pool_layer(l);
}

/* --- against the numbers of each window, collected one by one --- */

/* The window of output (channel, r, c): its numbers and their places; returns how many. */
static int collect(const kw_pool *l, const double *x, int channel, int r, int c,
                   double *number, int *place)
{
    int count = 0;

    for (int i = 0; i < l->rows; i++)
        for (int j = 0; j < l->columns; j++) {
            int a = i - r * l->stride, b = j - c * l->stride;

            if (a < 0 || a >= l->window_rows || b < 0 || b >= l->window_columns)
                continue;
            place[count] = (channel * l->rows + i) * l->columns + j;
            number[count] = x[place[count]];
            count++;
        }
    return count;
}

/* What forward and backward should give for one sample, by definition; the sum of a window
   is taken in the same order, so that the mean is the same to the bit. */
static void reference(const kw_pool *l, const double *x, const double *dy, double *y,
                      double *dx)
{
    double number[SIDE * SIDE] = {0};
    int place[SIDE * SIDE] = {0}, out = 0;

    for (int i = 0; i < l->in; i++)
        dx[i] = 0;
    for (int channel = 0; channel < l->channels; channel++)
        for (int r = 0; r < l->out_rows; r++)
            for (int c = 0; c < l->out_columns; c++, out++) {
                int size = collect(l, x, channel, r, c, number, place), best = 0;
                double sum = 0;

                CHECK(size == l->window_rows * l->window_columns, "window of %d", size);
                for (int i = 0; i < size; i++) {
                    sum += number[i];
                    if (number[i] > number[best])
                        best = i;
                }
                y[out] = l->kind == KW_POOL_MAX ? number[best] : sum / size;
                if (l->kind == KW_POOL_MAX)
                    dx[place[best]] += dy[out];
                for (int i = 0; i < size && l->kind == KW_POOL_MEAN; i++)
                    dx[place[i]] += dy[out] / size;
            }
}

static void check_layer(const kw_pool *l, kw_rng *r)
{
    double x[COUNT * MOST], y[COUNT * MOST + 1], dy[COUNT * MOST], dx[COUNT * MOST + 1];
    double wanted_y[MOST], wanted_dx[MOST];

    for (int i = 0; i < COUNT * MOST; i++) {
        x[i] = kw_rng_below(r, 9) - 4; /* often the same number twice in a window */
        dy[i] = kw_rng_below(r, 9) - 4;
    }
    test_poison(y, COUNT * MOST + 1);
    test_poison(dx, COUNT * MOST + 1);
    kw_pool_forward(l, NULL, COUNT, x, y);
    kw_pool_backward(l, NULL, COUNT, x, y, dy, dx, NULL);
    CHECK(isnan(y[COUNT * l->out]) && isnan(dx[COUNT * l->in]), "written behind");
    for (int s = 0; s < COUNT; s++) {
        reference(l, x + s * l->in, dy + s * l->out, wanted_y, wanted_dx);
        for (int i = 0; i < l->out; i++)
            CHECK(y[s * l->out + i] == wanted_y[i], "output %d: %g, not %g", i,
                  y[s * l->out + i], wanted_y[i]);
        for (int i = 0; i < l->in; i++)
            CHECK(dx[s * l->in + i] == wanted_dx[i], "derivative %d: %g, not %g", i,
                  dx[s * l->in + i], wanted_dx[i]);
    }
    kw_pool_backward(l, NULL, COUNT, x, y, dy, NULL, NULL); /* nothing wanted */
}

static void pooling_is_its_definition(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        kw_rng r = kw_rng_at(95, 0, (uint64_t)round, 0);
        kw_pool l = random_layer(&r, round % 2 ? KW_POOL_MAX : KW_POOL_MEAN);

        check_layer(&l, &r);
    }
}

/* --- by central differences --- */

/* f = <dy, y>. A mean is linear, and a largest number too as long as it stays the largest:
   the inputs are a shuffled 0, 4, 8, .., so a step of 1 exchanges none. Windows of 1, 2
   or 4 numbers only, so that all is exact. */
static void derivatives_are_central_differences(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        kw_rng r = kw_rng_at(96, 0, (uint64_t)round, 0);
        kw_pool l =
            kw_pool_layer((kw_pool){.kind = round % 2 ? KW_POOL_MAX : KW_POOL_MEAN,
                                    .channels = 2,
                                    .rows = 2 + kw_rng_below(&r, 4),
                                    .columns = 2 + kw_rng_below(&r, 4),
                                    .window_rows = 1 + kw_rng_below(&r, 2),
                                    .window_columns = 1 + kw_rng_below(&r, 2),
                                    .stride = 1 + kw_rng_below(&r, 2)});
        double x[MOST], y[MOST], dy[MOST], dx[MOST];

        for (int i = 0; i < l.in; i++) {
            int j = kw_rng_below(&r, i + 1);

            x[i] = x[j];
            x[j] = 4 * i;
        }
        for (int i = 0; i < l.out; i++)
            dy[i] = kw_rng_below(&r, 9) - 4;
        kw_pool_forward(&l, NULL, 1, x, y);
        kw_pool_backward(&l, NULL, 1, x, y, dy, dx, NULL);
        for (int i = 0; i < l.in; i++) {
            double difference = 0;

            for (int sign = 1; sign >= -1; sign -= 2) {
                x[i] += sign;
                kw_pool_forward(&l, NULL, 1, x, y);
                for (int j = 0; j < l.out; j++)
                    difference += sign * dy[j] * y[j] / 2;
                x[i] -= sign;
            }
            CHECK(dx[i] == difference, "input %d: %g, not %g", i, dx[i], difference);
        }
    }
}

/* --- small ones by hand --- */

static kw_pool line_of(kw_pool_kind kind, int columns, int window, int stride)
{
    return kw_pool_layer((kw_pool){.kind = kind,
                                   .channels = 1,
                                   .rows = 1,
                                   .columns = columns,
                                   .window_rows = 1,
                                   .window_columns = window,
                                   .stride = stride});
}

static void the_first_of_equals_has_the_derivative(void)
{
    const double x[] = {1, 3, 3, 3, 0}, dy[] = {10, 100};
    kw_pool l = line_of(KW_POOL_MAX, 5, 3, 2);
    double y[2], dx[5];

    kw_pool_forward(&l, NULL, 1, x, y);
    kw_pool_backward(&l, NULL, 1, x, y, dy, dx, NULL);
    CHECK(y[0] == 3 && y[1] == 3, "%g, %g", y[0], y[1]);
    CHECK(dx[0] == 0 && dx[1] == 10 && dx[2] == 100 && dx[3] == 0 && dx[4] == 0,
          "%g %g %g %g %g", dx[0], dx[1], dx[2], dx[3], dx[4]);
}

static void windows_that_do_not_fit_are_left_out(void)
{
    const double x[] = {1, 2, 3, 4, 50}, dy[] = {1, 1};
    kw_pool l = line_of(KW_POOL_MEAN, 5, 2, 2);
    double y[2], dx[5];

    CHECK(l.out == 2 && l.in == 5 && l.parameters == 0, "%d outputs", l.out);
    kw_pool_forward(&l, NULL, 1, x, y);
    kw_pool_backward(&l, NULL, 1, x, y, dy, dx, NULL);
    CHECK(y[0] == 1.5 && y[1] == 3.5, "%g, %g", y[0], y[1]);
    CHECK(dx[3] == 0.5 && dx[4] == 0, "%g, %g", dx[3], dx[4]);
}

/* Wherever it stands in the window. */
static void a_nan_is_passed_on(void)
{
    for (int kind = 0; kind < 2; kind++)
        for (int at = 0; at < 4; at++) {
            double x[] = {5, -1, 5, 7}, y[3];
            kw_pool l = line_of((kw_pool_kind)kind, 4, 2, 1);

            x[at] = NAN;
            kw_pool_forward(&l, NULL, 1, x, y);
            for (int i = 0; i < 3; i++)
                CHECK(!isnan(y[i]) == !(i == at || i + 1 == at), "NaN at %d: y[%d] = %g",
                      at, i, y[i]);
        }
}

/* --- misuse --- */

static void a_window_larger_than_the_grid(void)
{
    line_of(KW_POOL_MAX, 3, 4, 1);
}

static void no_window(void)
{
    line_of(KW_POOL_MAX, 3, 0, 1);
}

static void no_stride(void)
{
    line_of(KW_POOL_MEAN, 3, 1, 0);
}

static void no_column(void)
{
    line_of(KW_POOL_MEAN, 0, 1, 1);
}

static void no_channel(void)
{
    kw_pool_layer((kw_pool){
        .rows = 1, .columns = 1, .window_rows = 1, .window_columns = 1, .stride = 1});
}

static void no_such_kind(void)
{
    line_of((kw_pool_kind)7, 3, 1, 1);
}

static void too_many_inputs(void)
{
    kw_pool_layer((kw_pool){.channels = 2,
                            .rows = 1 << 14,
                            .columns = 1 << 14,
                            .window_rows = 1,
                            .window_columns = 1,
                            .stride = 1});
}

static void no_sample(void)
{
    kw_pool l = line_of(KW_POOL_MAX, 3, 1, 1);
    double x[3] = {0}, y[3];

    kw_pool_forward(&l, NULL, 0, x, y);
}

static void a_shape_that_is_no_layer_yet(void)
{
    const kw_pool l = {.channels = 1, .rows = 1, .columns = 1};
    double x[1] = {0}, dx[1];

    kw_pool_backward(&l, NULL, 1, x, x, x, dx, NULL);
}

static void misuse_aborts(void)
{
    test_aborts("a window of 4 columns, not in 1 .. 3", a_window_larger_than_the_grid);
    test_aborts("a window of 0 columns, not in 1 .. 3", no_window);
    test_aborts("stride 0", no_stride);
    test_aborts("0 columns", no_column);
    test_aborts("0 channels", no_channel);
    test_aborts("kind 7", no_such_kind);
    test_aborts("2 channels of 16384 x 16384 numbers, more than 268435456",
                too_many_inputs);
    test_aborts("0 samples", no_sample);
    test_aborts("kw_pool_layer has not made", a_shape_that_is_no_layer_yet);
}

int main(void)
{
    test_run("pool: values and derivatives are those of the definition",
             pooling_is_its_definition);
    test_run("pool: derivatives are central differences, exactly",
             derivatives_are_central_differences);
    test_run("pool: the first of equal numbers has the derivative",
             the_first_of_equals_has_the_derivative);
    test_run("pool: windows that do not fit are left out",
             windows_that_do_not_fit_are_left_out);
    test_run("pool: a NaN is passed on", a_nan_is_passed_on);
    test_run("pool: misuse aborts", misuse_aborts);
    return test_end();
}
