/* conv.h -- convolutional layers on signals (1D) and images (2D), and their operators.

   A sample is a stack of in_channels grids of rows x columns numbers, the place (channel,
   row, column) in row-major order; a signal is a grid of one row. A layer has a stack of
   filters,
     w   out_channels x in_channels x filter_rows x filter_columns,
   and gives a stack of out_channels grids of out_rows x out_columns numbers, its feature
   maps. Output (r, c) sees the inputs (r*stride + a - A, c*stride + b - B), where (a, b) is
   a place in the filter, in rows and columns by the same rule:
     valid     A = 0                      the filter stays inside:
                                          out_rows = (rows - filter_rows) / stride + 1
     same      A = (filter_rows - 1) / 2  there are zeros around the grid:
                                          out_rows = (rows - 1) / stride + 1
     circular  A as before                behind the last row comes the first;
                                          out_rows as before
   (divisions of integers, rounded down). So with `same' and stride 1 there are as many
   outputs as inputs.

   Every sum runs over the channels, then the rows, then the columns of the filter, whatever
   the place of the output, so that equal inputs give equal bits. A NaN is passed on to
   the outputs that see it. Arrays do not overlap; nothing is allocated.
   [source text, Definition 11, (22) and the text on Figure 16; Dumoulin, Visin: A guide to
   convolution arithmetic for deep learning, 2016] */
#ifndef KW_CONV_H
#define KW_CONV_H

typedef enum kw_conv_padding {
    KW_CONV_VALID,
    KW_CONV_SAME,
    KW_CONV_CIRCULAR
} kw_conv_padding;

typedef struct kw_conv {
    int in_channels, rows, columns;                /* the input */
    int out_channels, filter_rows, filter_columns; /* the filters */
    int stride;                                    /* the same for rows and columns */
    kw_conv_padding padding;
    /* the rest is set by kw_conv_layer */
    int out_rows, out_columns;
    int in, out;    /* numbers of a sample before and behind the layer */
    int parameters; /* filters, then one bias for each output channel */
} kw_conv;

/* The layer of this shape, all members set. Sizes and stride are at least 1. The filter has
   no more rows than the grid (valid), or fewer than twice as many (same, circular), so that
   each of its rows meets an input; the same for columns. in, out, parameters and stride are
   at most 2^28.
     kw_conv_layer((kw_conv){.in_channels = 1, .rows = 1, .columns = 32,
                             .out_channels = 4, .filter_rows = 1, .filter_columns = 3,
                             .stride = 1, .padding = KW_CONV_VALID}) */
kw_conv kw_conv_layer(kw_conv shape);

/* --- the operators: filters w on one sample x, without bias; y has l->out numbers --- */

/* The sum of the element-wise products of each filter with what it sees, what the book's
   prose on Figure 16 describes; a cross-correlation. */
void kw_conv_correlate(const kw_conv *l, const double *w, const double *x, double *y);

/* The same with every filter turned by half a turn, which makes it a convolution. With a
   filter of the size of the grid and `valid' it gives one number, that of (22). Turning an
   even filter moves its place (A, B) to the next one, so with `same' and `circular' the result
   is that of the usual convention, which moves (A, B) along, one place earlier: the filter
   (1,10) takes (1,2,3) to (12,23,30), and there to (1,12,23). */
void kw_conv_convolve(const kw_conv *l, const double *w, const double *x, double *y);

/* --- the layer: y = b + the correlation of x with the filters --- */

/* w: the filters, then the biases b, one for each output channel. x: count x in; y: count x
   out; count >= 1. */
void kw_conv_forward(const kw_conv *l, const double *w, int count, const double *x,
                     double *y);

/* From dy, count x out, the derivative of a number with respect to y, to those with respect
   to x and w: dx, count x in, is set (NULL: not wanted); to dw, of the shape of w, it is
   added. y is what kw_conv_forward wrote; it is not needed here. */
void kw_conv_backward(const kw_conv *l, const double *w, int count, const double *x,
                      const double *y, const double *dy, double *dx, double *dw);

#endif
