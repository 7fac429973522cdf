/* Figure 16 -- A filter slides over a signal and over an image.

   What to see: each number of the feature map is made of the few inputs under the filter
   (shaded, for one of them). Above, their element-wise products with the filter are added up,
   as the prose has it; below, the filter is first turned by half a turn, as (22) has it. The
   two maps differ.

   Book: section 1.2, (22) and the text around Figure 16.
   Claims: cnn.fig16.*
   Chosen here: all numbers, filters that are not their own half turn, stride 1, no
   padding. */

#include "claim.h" /* what we found, for the ledger */
#include "conv.h"  /* both ways to apply a filter */
#include "need.h"  /* examples fit their arrays */
#include "out.h"   /* columns for gnuplot */
#include <stdio.h>

enum { MOST = 25 }; /* cells of a grid */

typedef struct example {
    const char *name;
    kw_conv l;
    double x[MOST], w[MOST];
    int shown; /* the output whose inputs are shaded */
} example;

static const example signal = {
    .name = "signal",
    .l = {.in_channels = 1,
          .rows = 1,
          .columns = 7,
          .out_channels = 1,
          .filter_rows = 1,
          .filter_columns = 3,
          .stride = 1},
    .x = {1, 2, 0, 3, 1, 4, 2},
    .w = {1, 2, -1},
    .shown = 2,
};

static const example image = {
    .name = "image",
    .l = {.in_channels = 1,
          .rows = 5,
          .columns = 5,
          .out_channels = 1,
          .filter_rows = 3,
          .filter_columns = 3,
          .stride = 1},
    .x = {1, 0, 2, 1, 3, 0, 1, 1, 2, 0, 2, 1, 0, 1, 1, 1, 3, 1, 0, 2, 0, 1, 2, 1, 0},
    .w = {1, 0, 0, 2, 1, 0, 0, 0, -1},
    .shown = 1,
};

/* A grid of numbers as a section of cells; local may be NULL: no cell is. */
static void write_cells(kw_out *f, const char *name, const char *part, int rows,
                        int columns, const double *value, const double *local)
{
    char title[40];

    snprintf(title, sizeof title, "%s %s", name, part);
    kw_out_section(f, title, "column row value local");
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            kw_out_number(f, j);
            kw_out_number(f, i);
            kw_out_number(f, value[i * columns + j]);
            kw_out_number(f, local && local[i * columns + j] != 0);
            kw_out_row(f);
        }
}

/* What is counted in an example. */
typedef struct counts {
    int outputs, weights, seen, differ;
} counts;

static counts show(kw_out *f, const example *e)
{
    const kw_conv l = kw_conv_layer(e->l);
    double prose[MOST], equation[MOST], turned[MOST] = {0};
    double ones[MOST] = {0}, one[MOST] = {0}, local[MOST], unused[MOST + 1] = {0};
    counts n = {.outputs = l.out, .weights = l.parameters - l.out_channels};

    KW_NEED(l.in <= MOST, "%d cells", l.in);
    kw_conv_correlate(&l, e->w, e->x, prose);
    kw_conv_convolve(&l, e->w, e->x, equation);
    for (int i = 0; i < n.weights; i++) {
        turned[i] = e->w[n.weights - 1 - i];
        ones[i] = 1;
    }
    /* with weights one, the derivative of an output says which inputs it sees */
    one[e->shown] = 1;
    kw_conv_backward(&l, ones, 1, e->x, prose, one, local, unused);
    for (int i = 0; i < l.in; i++)
        n.seen += local[i] != 0;
    for (int i = 0; i < l.out; i++)
        n.differ += prose[i] != equation[i];

    write_cells(f, e->name, "input", l.rows, l.columns, e->x, local);
    write_cells(f, e->name, "filter", l.filter_rows, l.filter_columns, e->w, NULL);
    write_cells(f, e->name, "turned", l.filter_rows, l.filter_columns, turned, NULL);
    write_cells(f, e->name, "prose", l.out_rows, l.out_columns, prose, one);
    write_cells(f, e->name, "equation", l.out_rows, l.out_columns, equation, one);
    return n;
}

/* How many outputs the signal would have with another padding and stride. */
static int outputs_with(kw_conv_padding padding, int stride)
{
    kw_conv l = signal.l;

    l.padding = padding;
    l.stride = stride;
    return kw_conv_layer(l).out;
}

int main(void)
{
    kw_out *f = kw_out_data("fig16"), *report = kw_claim_new("fig16");
    counts line, grid;

    line = show(f, &signal);
    grid = show(f, &image);

    kw_claim_count(report, "cnn.fig16.1d.outputs", line.outputs);
    kw_claim_count(report, "cnn.fig16.1d.weights", line.weights);
    kw_claim_count(report, "cnn.fig16.1d.seen", line.seen);
    kw_claim_count(report, "cnn.fig16.1d.differ", line.differ);
    kw_claim_count(report, "cnn.fig16.1d.outputs.same", outputs_with(KW_CONV_SAME, 1));
    kw_claim_count(report, "cnn.fig16.1d.outputs.stride", outputs_with(KW_CONV_VALID, 2));
    kw_claim_count(report, "cnn.fig16.2d.outputs", grid.outputs);
    kw_claim_count(report, "cnn.fig16.2d.weights", grid.weights);
    kw_claim_count(report, "cnn.fig16.2d.seen", grid.seen);
    kw_claim_count(report, "cnn.fig16.2d.differ", grid.differ);
    return kw_out_close(f) | kw_out_close(report);
}
