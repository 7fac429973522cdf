/* pool.h -- pooling: the largest number, or the mean, of each window of a grid.

   A sample is a stack of `channels` grids of rows x columns numbers (conv.h); each is pooled
   by itself. The window of output (r, c) has its first corner at (r*stride, c*stride); only
   windows that lie inside are taken:
     out_rows = (rows - window_rows) / stride + 1, rounded down, and so for columns.
   Windows may overlap (stride smaller than the window) or leave gaps.

   The derivative of a largest number belongs to its place, and to the first in row-major
   order if it stands in several. A NaN is passed on to the outputs whose windows hold it.
   Arrays do not overlap; nothing is allocated.
   [Goodfellow, Bengio, Courville: Deep Learning, 2016, section 9.3] */
#ifndef KW_POOL_H
#define KW_POOL_H

typedef enum kw_pool_kind { KW_POOL_MAX, KW_POOL_MEAN } kw_pool_kind;

typedef struct kw_pool {
    kw_pool_kind kind;
    int channels, rows, columns; /* the input */
    int window_rows, window_columns, stride;
    /* the rest is set by kw_pool_layer */
    int out_rows, out_columns;
    int in, out;    /* numbers of a sample before and behind the layer */
    int parameters; /* 0 */
} kw_pool;

/* The layer of this shape, all members set. Sizes and stride are at least 1, the window is
   not larger than the grid, in, out and stride are at most 2^28.
     kw_pool_layer((kw_pool){.kind = KW_POOL_MAX, .channels = 4, .rows = 1, .columns = 30,
                             .window_rows = 1, .window_columns = 2, .stride = 2}) */
kw_pool kw_pool_layer(kw_pool shape);

/* x: count x in; y: count x out; count >= 1. w is ignored. */
void kw_pool_forward(const kw_pool *l, const double *w, int count, const double *x,
                     double *y);

/* From dy, count x out, the derivative of a number with respect to y, to that with respect
   to x: dx, count x in, is set (NULL: not wanted). y is what kw_pool_forward wrote. w and dw
   are ignored. */
void kw_pool_backward(const kw_pool *l, const double *w, int count, const double *x,
                      const double *y, const double *dy, double *dx, double *dw);

#endif
