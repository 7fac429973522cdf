#include "affine.h"
#include "matrix.h"
#include "need.h"
#include "wide.h"
#include <limits.h>
#include <stddef.h>
#include <string.h>

kw_affine kw_affine_layer(int in, int out)
{
    kw_affine l = {in, out, 0};

    KW_NEED(in >= 1 && out >= 1, "in = %d, out = %d", in, out);
    KW_NEED(out <= (INT_MAX - out) / in, "%d x %d weights and %d biases, more than %d",
            out, in, out, INT_MAX);
    l.parameters = out * in + out;
    return l;
}

int kw_affine_weight(const kw_affine *l, int i, int j)
{
    KW_NEED(0 <= i && i < l->out && 0 <= j && j < l->in,
            "weight (%d, %d) of %d x %d weights", i, j, l->out, l->in);
    return i * l->in + j;
}

int kw_affine_bias(const kw_affine *l, int i)
{
    KW_NEED(0 <= i && i < l->out, "bias %d of %d biases", i, l->out);
    return l->out * l->in + i;
}

void kw_affine_forward(const kw_affine *l, const double *w, int count, const double *x,
                       double *y)
{
    const double *b = w + kw_affine_bias(l, 0);

    KW_NEED(count >= 1, "%d samples", count);
    for (size_t s = 0; s < (size_t)count; s++)
        memcpy(y + s * (size_t)l->out, b, (size_t)l->out * sizeof *y);
    kw_matrix_add_abt(count, l->out, l->in, x, w, y);
}

/* db += the sum of the rows of dy, in their order */
KW_WIDE static void add_rows(int count, int out, const double *restrict dy,
                             double *restrict db)
{
    for (size_t s = 0; s < (size_t)count; s++)
        for (int i = 0; i < out; i++)
            db[i] += dy[s * (size_t)out + (size_t)i];
}

void kw_affine_backward(const kw_affine *l, const double *w, int count, const double *x,
                        const double *y, const double *dy, double *dx, double *dw)
{
    double *db = dw + kw_affine_bias(l, 0);

    (void)y;
    KW_NEED(count >= 1, "%d samples", count);
    if (dx) {
        memset(dx, 0, (size_t)count * (size_t)l->in * sizeof *dx);
        kw_matrix_add_ab(count, l->in, l->out, dy, w, dx);
    }
    kw_matrix_add_atb(l->out, l->in, count, dy, x, dw);
    add_rows(count, l->out, dy, db);
}
