#include "pool.h"
#include "need.h"
#include <math.h>
#include <stddef.h>

enum { MOST = 1 << 28 }; /* numbers of a sample */

static int outputs(const char *name, int size, int window, int stride)
{
    KW_NEED(1 <= size && size <= MOST, "%d %s", size, name);
    KW_NEED(1 <= window && window <= size, "a window of %d %s, not in 1 .. %d", window,
            name, size);
    return (size - window) / stride + 1;
}

kw_pool kw_pool_layer(kw_pool shape)
{
    kw_pool *l = &shape;

    KW_NEED(l->kind == KW_POOL_MAX || l->kind == KW_POOL_MEAN, "kind %d", (int)l->kind);
    KW_NEED(l->channels >= 1, "%d channels", l->channels);
    KW_NEED(1 <= l->stride && l->stride <= MOST, "stride %d", l->stride);
    l->out_rows = outputs("rows", l->rows, l->window_rows, l->stride);
    l->out_columns = outputs("columns", l->columns, l->window_columns, l->stride);
    KW_NEED(l->columns <= MOST / l->rows && l->channels <= MOST / (l->rows * l->columns),
            "%d channels of %d x %d numbers, more than %d in all", l->channels, l->rows,
            l->columns, MOST);
    l->in = l->channels * l->rows * l->columns;
    l->out = l->channels * l->out_rows * l->out_columns;
    l->parameters = 0;
    return shape;
}

/* The first place of the window of output i. */
static int corner(const kw_pool *l, int i)
{
    int column = i % l->out_columns, row = i / l->out_columns % l->out_rows,
        channel = i / (l->out_columns * l->out_rows);

    return (channel * l->rows + row * l->stride) * l->columns + column * l->stride;
}

/* The place of the largest number of the window that begins at `first`. */
static int largest(const kw_pool *l, const double *x, int first)
{
    int best = first;

    for (int a = 0; a < l->window_rows; a++)
        for (int b = 0; b < l->window_columns; b++) {
            int i = first + a * l->columns + b;

            if (x[i] > x[best] || isnan(x[i]))
                best = i;
        }
    return best;
}

static double mean(const kw_pool *l, const double *x, int first)
{
    double sum = 0;

    for (int a = 0; a < l->window_rows; a++)
        for (int b = 0; b < l->window_columns; b++)
            sum += x[first + a * l->columns + b];
    return sum / (l->window_rows * l->window_columns);
}

static void add_mean_gradient(const kw_pool *l, double dy, int first, double *dx)
{
    double share = dy / (l->window_rows * l->window_columns);

    for (int a = 0; a < l->window_rows; a++)
        for (int b = 0; b < l->window_columns; b++)
            dx[first + a * l->columns + b] += share;
}

static void need_samples(const kw_pool *l, int count)
{
    KW_NEED(l->in >= 1 && l->out >= 1,
            "a layer that kw_pool_layer has not made: %d inputs, %d outputs", l->in,
            l->out);
    KW_NEED(count >= 1, "%d samples", count);
}

void kw_pool_forward(const kw_pool *l, const double *w, int count, const double *x,
                     double *y)
{
    (void)w;
    need_samples(l, count);
    for (int s = 0; s < count; s++, x += l->in, y += l->out)
        for (int i = 0; i < l->out; i++) {
            int first = corner(l, i);

            y[i] = l->kind == KW_POOL_MAX ? x[largest(l, x, first)] : mean(l, x, first);
        }
}

void kw_pool_backward(const kw_pool *l, const double *w, int count, const double *x,
                      const double *y, const double *dy, double *dx, double *dw)
{
    (void)w, (void)y, (void)dw;
    need_samples(l, count);
    if (!dx)
        return;
    for (int s = 0; s < count; s++, x += l->in, dy += l->out, dx += l->in) {
        for (int i = 0; i < l->in; i++)
            dx[i] = 0;
        for (int i = 0; i < l->out; i++) {
            int first = corner(l, i);

            if (l->kind == KW_POOL_MAX)
                dx[largest(l, x, first)] += dy[i];
            else
                add_mean_gradient(l, dy[i], first, dx);
        }
    }
}
