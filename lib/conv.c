#include "conv.h"
#include "need.h"
#include <stddef.h>

enum { MOST = 1 << 28 }; /* numbers of a sample, parameters */

/* --- shapes --- */

/* How many places of the filter may lie outside before the first row or column. */
static int before(const kw_conv *l, int filter)
{
    return l->padding == KW_CONV_VALID ? 0 : (filter - 1) / 2;
}

/* Outputs along one direction, `name`, of `size` inputs. */
static int outputs(const kw_conv *l, const char *name, int size, int filter)
{
    int most = l->padding == KW_CONV_VALID ? size : 2 * size - 1;

    KW_NEED(1 <= size && size <= MOST, "%d %s", size, name);
    KW_NEED(1 <= filter && filter <= most, "a filter of %d %s, not in 1 .. %d", filter,
            name, most);
    return (l->padding == KW_CONV_VALID ? size - filter : size - 1) / l->stride + 1;
}

/* a b, if it is not too large for a layer. */
static int product(int a, int b, const char *what)
{
    KW_NEED(a <= MOST / b, "%d times %d %s, more than %d in all", a, b, what, MOST);
    return a * b;
}

kw_conv kw_conv_layer(kw_conv shape)
{
    kw_conv *l = &shape;
    int filters;

    KW_NEED(l->in_channels >= 1, "%d input channels", l->in_channels);
    KW_NEED(l->out_channels >= 1, "%d output channels", l->out_channels);
    KW_NEED(1 <= l->stride && l->stride <= MOST, "stride %d", l->stride);
    KW_NEED(l->padding == KW_CONV_VALID || l->padding == KW_CONV_SAME ||
                l->padding == KW_CONV_CIRCULAR,
            "padding %d", (int)l->padding);
    l->out_rows = outputs(l, "rows", l->rows, l->filter_rows);
    l->out_columns = outputs(l, "columns", l->columns, l->filter_columns);
    l->in = product(product(l->rows, l->columns, "inputs"), l->in_channels, "inputs");
    l->out = product(product(l->out_rows, l->out_columns, "outputs"), l->out_channels,
                     "outputs");
    filters = product(product(l->filter_rows, l->filter_columns, "weights"),
                      l->in_channels, "weights");
    l->parameters = product(filters + 1, l->out_channels, "parameters");
    return shape;
}

static int count_weights(const kw_conv *l)
{
    return l->parameters - l->out_channels; /* without the biases */
}

/* --- the one loop of all: over the filters, and for each weight over all products ---

   A weight joins outputs with inputs. In one row of outputs the inputs of neighbouring
   outputs are `stride` apart, so that they are done in one run. */

typedef struct arrays {
    const double *w, *x, *dy;
    double *y, *dx, *dw; /* what is added to; NULL but for one of them */
} arrays;

typedef struct run {
    int weight; /* which one */
    int x, y;   /* the first input and the first output */
    int count, stride;
} run;

typedef void kernel(const arrays *at, run r);

/* y += w x */
static void add_to_outputs(const arrays *at, run r)
{
    const double *restrict x = at->x + r.x;
    double *restrict y = at->y + r.y;
    double w = at->w[r.weight];

    for (int i = 0; i < r.count; i++)
        y[i] += w * x[(ptrdiff_t)i * r.stride];
}

/* dx += w dy */
static void add_to_inputs(const arrays *at, run r)
{
    const double *restrict dy = at->dy + r.y;
    double *restrict dx = at->dx + r.x;
    double w = at->w[r.weight];

    for (int i = 0; i < r.count; i++)
        dx[(ptrdiff_t)i * r.stride] += w * dy[i];
}

/* dw += sum of x dy */
static void add_to_weight(const arrays *at, run r)
{
    const double *restrict x = at->x + r.x, *restrict dy = at->dy + r.y;
    double sum = 0;

    for (int i = 0; i < r.count; i++)
        sum += x[(ptrdiff_t)i * r.stride] * dy[i];
    at->dw[r.weight] += sum;
}

/* Place i of a grid with `size` places and zeros (-1) or copies around it. */
static int place(const kw_conv *l, int i, int size)
{
    if (0 <= i && i < size)
        return i;
    if (l->padding == KW_CONV_CIRCULAR)
        return i < 0 ? i + size : i - size;
    return -1;
}

/* The first output of a row, of out_columns at most, whose input, `shift` places behind
   stride times the output, is not before place 0. */
static int first_output(const kw_conv *l, int shift)
{
    int first = shift >= 0 ? 0 : (-shift + l->stride - 1) / l->stride;

    return first < l->out_columns ? first : l->out_columns;
}

/* One weight, from row a of its filter, on all rows of the two grids; r has its columns, as
   places in their first rows. */
static void over_rows(const kw_conv *l, int a, run r, kernel *k, const arrays *at)
{
    run here = r;

    for (int row = 0; row < l->out_rows; row++) {
        int from = place(l, row * l->stride + a - before(l, l->filter_rows), l->rows);

        here.x = r.x + from * l->columns;
        here.y = r.y + row * l->out_columns;
        if (from >= 0)
            k(at, here);
    }
}

/* One weight, place (a, b) of its filter, on the grid of inputs that begins at r.x and the
   grid of outputs at r.y. */
static void over_columns(const kw_conv *l, int a, int b, run r, kernel *k,
                         const arrays *at)
{
    int copies = l->padding == KW_CONV_CIRCULAR;

    for (int q = -copies; q <= copies; q++) { /* copy q of the columns of inputs */
        int shift = b - before(l, l->filter_columns) - q * l->columns;
        int first = first_output(l, shift), behind = first_output(l, shift - l->columns);
        run part = {r.weight, r.x + first * l->stride + shift, r.y + first,
                    behind - first, r.stride};

        if (part.count > 0)
            over_rows(l, a, part, k, at);
    }
}

/* All weights of the layer on one sample; the filters are turned by half a turn if
   `turned`. */
static void over_weights(const kw_conv *l, int turned, kernel *k, const arrays *at)
{
    int size = l->filter_rows * l->filter_columns;
    run r = {.stride = l->stride};

    for (int o = 0; o < l->out_channels; o++)
        for (int c = 0; c < l->in_channels; c++)
            for (int i = 0; i < size; i++) {
                r.weight = (o * l->in_channels + c) * size + (turned ? size - 1 - i : i);
                r.x = c * l->rows * l->columns;
                r.y = o * l->out_rows * l->out_columns;
                over_columns(l, i / l->filter_columns, i % l->filter_columns, r, k, at);
            }
}

/* --- the operators --- */

static void need_layer(const kw_conv *l)
{
    KW_NEED(
        l->in >= 1 && l->out >= 1 && l->parameters >= 2,
        "a layer that kw_conv_layer has not made: %d inputs, %d outputs, %d parameters",
        l->in, l->out, l->parameters);
}

static void apply(const kw_conv *l, int turned, const double *w, const double *x,
                  double *y)
{
    const arrays at = {.w = w, .x = x, .y = y};

    need_layer(l);
    for (int i = 0; i < l->out; i++)
        y[i] = 0;
    over_weights(l, turned, add_to_outputs, &at);
}

void kw_conv_correlate(const kw_conv *l, const double *w, const double *x, double *y)
{
    apply(l, 0, w, x, y);
}

void kw_conv_convolve(const kw_conv *l, const double *w, const double *x, double *y)
{
    apply(l, 1, w, x, y);
}

/* --- the layer --- */

static void need_samples(const kw_conv *l, int count)
{
    need_layer(l);
    KW_NEED(count >= 1, "%d samples", count);
}

void kw_conv_forward(const kw_conv *l, const double *w, int count, const double *x,
                     double *y)
{
    const double *b = w + count_weights(l);
    int map = l->out_rows * l->out_columns;

    need_samples(l, count);
    for (int s = 0; s < count; s++) {
        const arrays at = {.w = w,
                           .x = x + (size_t)s * (size_t)l->in,
                           .y = y + (size_t)s * (size_t)l->out};

        for (int i = 0; i < l->out; i++)
            at.y[i] = b[i / map];
        over_weights(l, 0, add_to_outputs, &at);
    }
}

static void add_to_biases(const kw_conv *l, const double *dy, double *db)
{
    int map = l->out_rows * l->out_columns;

    for (int i = 0; i < l->out; i++)
        db[i / map] += dy[i];
}

void kw_conv_backward(const kw_conv *l, const double *w, int count, const double *x,
                      const double *y, const double *dy, double *dx, double *dw)
{
    (void)y;
    need_samples(l, count);
    for (int s = 0; s < count; s++) {
        const arrays at = {.w = w,
                           .x = x + (size_t)s * (size_t)l->in,
                           .dy = dy + (size_t)s * (size_t)l->out,
                           .dx = dx ? dx + (size_t)s * (size_t)l->in : NULL,
                           .dw = dw};

        over_weights(l, 0, add_to_weight, &at);
        add_to_biases(l, at.dy, dw + count_weights(l));
        if (!dx)
            continue;
        for (int i = 0; i < l->in; i++)
            at.dx[i] = 0;
        over_weights(l, 0, add_to_inputs, &at);
    }
}
