#include "gcn.h"
#include "eigen.h"
#include "matrix.h"
#include "need.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* --- layers --- */

static kw_gcn *new_layer(const kw_graph *g, int in_channels, int out_channels, int first,
                         int last)
{
    kw_gcn *l = kw_need_memory(1, sizeof *l);
    int most = in_channels > out_channels ? in_channels : out_channels;

    KW_NEED(in_channels >= 1 && out_channels >= 1, "%d channels in, %d channels out",
            in_channels, out_channels);
    KW_NEED(most <= INT_MAX / 3 / g->n, "%d channels on %d nodes", most, g->n);
    KW_NEED(in_channels + 1.0 <= (double)INT_MAX / out_channels / (last - first + 1),
            "%d matrices of %d x %d weights", last - first + 1, in_channels,
            out_channels);
    l->n = g->n;
    l->in_channels = in_channels;
    l->out_channels = out_channels;
    l->first = first;
    l->last = last;
    l->in = g->n * in_channels;
    l->out = g->n * out_channels;
    l->parameters = (last - first + 1) * in_channels * out_channels + out_channels;
    l->work = kw_need_memory(3 * (size_t)g->n * (size_t)most, sizeof *l->work);
    return l;
}

kw_gcn *kw_gcn_new_spatial(const kw_graph *g, int in_channels, int out_channels)
{
    kw_gcn *l = new_layer(g, in_channels, out_channels, 0, 1);

    l->S = kw_graphmatrix_new_mean(g);
    return l;
}

kw_gcn *kw_gcn_new_spectral(const kw_graph *g, int in_channels, int out_channels)
{
    kw_gcn *l = new_layer(g, in_channels, out_channels, 0, g->n - 1);
    kw_graphmatrix *L = kw_graphmatrix_new_normalized(g);
    double *dense;

    KW_NEED(g->n <= INT_MAX / g->n, "%d nodes", g->n);
    dense = kw_need_memory((size_t)g->n * (size_t)g->n, sizeof *dense);
    l->frequency = kw_need_memory((size_t)g->n, sizeof *l->frequency);
    l->vector = kw_need_memory((size_t)g->n * (size_t)g->n, sizeof *l->vector);
    kw_graphmatrix_dense(L, dense);
    kw_eigen_symmetric(g->n, dense, l->frequency, l->vector);
    kw_graphmatrix_free(L);
    free(dense);
    return l;
}

kw_gcn *kw_gcn_new_chebyshev(const kw_graph *g, int in_channels, int out_channels,
                             int degree)
{
    kw_gcn *l;

    KW_NEED(0 <= degree && degree < INT_MAX, "degree %d", degree);
    l = new_layer(g, in_channels, out_channels, 0, degree);
    l->S = kw_graphmatrix_new_normalized(g);
    kw_graphmatrix_shift(l->S, -1);
    return l;
}

kw_gcn *kw_gcn_new_first_order(const kw_graph *g, int in_channels, int out_channels)
{
    kw_gcn *l = new_layer(g, in_channels, out_channels, 1, 1);

    l->S = kw_graphmatrix_new_renormalized(g);
    return l;
}

void kw_gcn_free(kw_gcn *l)
{
    if (!l)
        return;
    kw_graphmatrix_free(l->S);
    free(l->frequency);
    free(l->vector);
    free(l->work);
    free(l);
}

/* --- the parts of a layer --- */

/* W_k in an array of the layer's parameters. */
static size_t weights(const kw_gcn *l, int k)
{
    return (size_t)(k - l->first) * (size_t)l->in_channels * (size_t)l->out_channels;
}

static size_t biases(const kw_gcn *l)
{
    return weights(l, l->last + 1);
}

/* Array k mod 3 of the three for intermediate signals. */
static double *work_array(const kw_gcn *l, int k)
{
    return l->work + (size_t)(k % 3) * (size_t)(l->in > l->out ? l->in : l->out);
}

typedef void product(const kw_graphmatrix *S, int channels, const double *x, double *y);

/* T_k(S) x of a signal x, or T_k(S^T) x, as `multiply` says; to be asked for
   k = 0, 1, .. in turn. By T_{k+1}(s) = 2 s T_k(s) - T_{k-1}(s), from T_0 = 1,
   T_1 = s. */
static const double *term(const kw_gcn *l, product *multiply, int k, int channels,
                          const double *x)
{
    const double *one_before = k == 1 ? x : work_array(l, k + 2);
    const double *two_before = k == 2 ? x : work_array(l, k + 1);
    double *now = work_array(l, k);

    if (k == 0)
        return x;
    multiply(l->S, channels, one_before, now);
    for (int i = 0; k > 1 && i < l->n * channels; i++)
        now[i] = 2 * now[i] - two_before[i];
    return now;
}

static void set_biases(const kw_gcn *l, const double *w, double *y)
{
    for (int i = 0; i < l->n; i++)
        memcpy(y + i * l->out_channels, w + biases(l),
               (size_t)l->out_channels * sizeof *y);
}

static void add_bias_gradients(const kw_gcn *l, const double *dy, double *dw)
{
    for (int i = 0; i < l->n; i++)
        for (int c = 0; c < l->out_channels; c++)
            dw[biases(l) + (size_t)c] += dy[i * l->out_channels + c];
}

static void forward_polynomial(const kw_gcn *l, const double *w, const double *x,
                               double *y)
{
    for (int k = 0; k <= l->last; k++) {
        const double *t = term(l, kw_graphmatrix_multiply, k, l->in_channels, x);

        if (k >= l->first)
            kw_matrix_add_ab(l->n, l->out_channels, l->in_channels, t, w + weights(l, k),
                             y);
    }
}

static void backward_polynomial(const kw_gcn *l, const double *w, const double *x,
                                const double *dy, double *dx, double *dw)
{
    for (int k = 0; k <= l->last; k++) {
        const double *t =
            term(l, kw_graphmatrix_multiply_transposed, k, l->out_channels, dy);

        if (k < l->first)
            continue;
        kw_matrix_add_atb(l->in_channels, l->out_channels, l->n, x, t,
                          dw + weights(l, k));
        if (dx)
            kw_matrix_add_abt(l->n, l->in_channels, l->out_channels, t, w + weights(l, k),
                              dx);
    }
}

/* z = U^T x: row k belongs to frequency k. */
static void to_frequencies(const kw_gcn *l, int channels, const double *x, double *z)
{
    memset(z, 0, (size_t)l->n * (size_t)channels * sizeof *z);
    kw_matrix_add_ab(l->n, channels, l->n, l->vector, x, z);
}

static void forward_spectral(const kw_gcn *l, const double *w, const double *x, double *y)
{
    int in = l->in_channels, out = l->out_channels;
    double *z = work_array(l, 0), *v = work_array(l, 1);

    to_frequencies(l, in, x, z);
    memset(v, 0, (size_t)l->out * sizeof *v);
    for (int k = 0; k < l->n; k++)
        kw_matrix_add_ab(1, out, in, z + k * in, w + weights(l, k), v + k * out);
    kw_matrix_add_atb(l->n, out, l->n, l->vector, v, y);
}

static void backward_spectral(const kw_gcn *l, const double *w, const double *x,
                              const double *dy, double *dx, double *dw)
{
    int in = l->in_channels, out = l->out_channels;
    double *z = work_array(l, 0), *dv = work_array(l, 1), *dz = work_array(l, 2);

    to_frequencies(l, in, x, z);
    to_frequencies(l, out, dy, dv);
    memset(dz, 0, (size_t)l->in * sizeof *dz);
    for (int k = 0; k < l->n; k++) {
        kw_matrix_add_atb(in, out, 1, z + k * in, dv + k * out, dw + weights(l, k));
        kw_matrix_add_abt(1, in, out, dv + k * out, w + weights(l, k), dz + k * in);
    }
    if (dx)
        kw_matrix_add_atb(l->n, in, l->n, l->vector, dz, dx);
}

/* --- batches --- */

void kw_gcn_forward(const kw_gcn *l, const double *w, int count, const double *x,
                    double *y)
{
    KW_NEED(count >= 1, "%d samples", count);
    for (int s = 0; s < count; s++, x += l->in, y += l->out) {
        set_biases(l, w, y);
        if (l->vector)
            forward_spectral(l, w, x, y);
        else
            forward_polynomial(l, w, x, y);
    }
}

void kw_gcn_backward(const kw_gcn *l, const double *w, int count, const double *x,
                     const double *y, const double *dy, double *dx, double *dw)
{
    (void)y;
    KW_NEED(count >= 1, "%d samples", count);
    if (dx)
        memset(dx, 0, (size_t)count * (size_t)l->in * sizeof *dx);
    for (int s = 0; s < count; s++, x += l->in, dy += l->out) {
        if (l->vector)
            backward_spectral(l, w, x, dy, dx, dw);
        else
            backward_polynomial(l, w, x, dy, dx, dw);
        add_bias_gradients(l, dy, dw);
        if (dx)
            dx += l->in;
    }
}
