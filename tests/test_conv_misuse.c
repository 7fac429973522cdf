#include "conv.h"
#include "test.h"
#include <limits.h>
#include <stddef.h>

/* A layer that is right: one channel of 4 x 5, two filters of 3 x 2. */
static kw_conv right(void)
{
    return (kw_conv){.in_channels = 1,
                     .rows = 4,
                     .columns = 5,
                     .out_channels = 2,
                     .filter_rows = 3,
                     .filter_columns = 2,
                     .stride = 1};
}

static void the_example_is_right(void)
{
    kw_conv l = kw_conv_layer(right());

    CHECK(l.in == 20 && l.out == 2 * 2 * 4 && l.parameters == 2 * (6 + 1), "%d, %d, %d",
          l.in, l.out, l.parameters);
}

static void no_channel(void)
{
    kw_conv l = right();

    l.in_channels = 0;
    kw_conv_layer(l);
}

static void no_filter(void)
{
    kw_conv l = right();

    l.out_channels = -1;
    kw_conv_layer(l);
}

static void no_stride(void)
{
    kw_conv l = right();

    l.stride = 0;
    kw_conv_layer(l);
}

static void endless_stride(void)
{
    kw_conv l = right();

    l.stride = INT_MAX;
    kw_conv_layer(l);
}

static void no_row(void)
{
    kw_conv l = right();

    l.rows = 0;
    kw_conv_layer(l);
}

static void no_filter_column(void)
{
    kw_conv l = right();

    l.filter_columns = 0;
    kw_conv_layer(l);
}

static void a_filter_larger_than_the_grid(void)
{
    kw_conv l = right();

    l.filter_rows = 5;
    kw_conv_layer(l);
}

static void a_filter_that_goes_around_twice(void)
{
    kw_conv l = right();

    l.padding = KW_CONV_CIRCULAR;
    l.filter_columns = 10;
    kw_conv_layer(l);
}

static void no_such_padding(void)
{
    kw_conv l = right();

    l.padding = (kw_conv_padding)3;
    kw_conv_layer(l);
}

static void impossible_shapes_abort(void)
{
    test_aborts("0 input channels", no_channel);
    test_aborts("-1 output channels", no_filter);
    test_aborts("stride 0", no_stride);
    test_aborts("stride 2147483647", endless_stride);
    test_aborts("0 rows", no_row);
    test_aborts("a filter of 0 columns, not in 1 .. 5", no_filter_column);
    test_aborts("a filter of 5 rows, not in 1 .. 4", a_filter_larger_than_the_grid);
    test_aborts("a filter of 10 columns, not in 1 .. 9", a_filter_that_goes_around_twice);
    test_aborts("padding 3", no_such_padding);
}

static void too_many_inputs(void)
{
    kw_conv l = right();

    l.rows = l.columns = 1 << 14;
    l.in_channels = 2;
    kw_conv_layer(l);
}

static void too_many_outputs(void)
{
    kw_conv l = right();

    l.rows = l.columns = 1 << 13;
    l.out_channels = 5;
    kw_conv_layer(l);
}

static void too_many_parameters(void)
{
    kw_conv l = right();

    l.rows = l.columns = l.filter_rows = l.filter_columns = 1 << 14;
    kw_conv_layer(l);
}

static void sizes_beyond_the_limit_abort(void)
{
    test_aborts("268435456 times 2 inputs, more than 268435456", too_many_inputs);
    test_aborts("outputs, more than 268435456", too_many_outputs);
    test_aborts("parameters, more than 268435456", too_many_parameters);
}

static const double NUMBERS[20] = {0};

static void forward(kw_conv l, int count)
{
    double y[16];

    kw_conv_forward(&l, NUMBERS, count, NUMBERS, y);
}

static void no_sample(void)
{
    forward(kw_conv_layer(right()), 0);
}

static void a_shape_that_is_no_layer_yet(void)
{
    forward(right(), 1);
}

static void no_sample_backward(void)
{
    kw_conv l = kw_conv_layer(right());
    double dw[14];

    kw_conv_backward(&l, NUMBERS, -1, NUMBERS, NUMBERS, NUMBERS, NULL, dw);
}

static void operator_of_no_layer(void)
{
    kw_conv l = right();
    double y[16];

    kw_conv_convolve(&l, NUMBERS, NUMBERS, y);
}

static void calls_that_make_no_sense_abort(void)
{
    test_aborts("0 samples", no_sample);
    test_aborts("-1 samples", no_sample_backward);
    test_aborts("kw_conv_layer has not made", a_shape_that_is_no_layer_yet);
    test_aborts("kw_conv_layer has not made", operator_of_no_layer);
}

int main(void)
{
    test_run("conv: the layer that the others differ from is right",
             the_example_is_right);
    test_run("conv: impossible shapes abort", impossible_shapes_abort);
    test_run("conv: sizes beyond the limit abort", sizes_beyond_the_limit_abort);
    test_run("conv: no samples, and a shape that is no layer, abort",
             calls_that_make_no_sense_abort);
    return test_end();
}
