#include "activation.h"
#include "elementary.h"
#include "need.h"
#include "wide.h"
#include <limits.h>
#include <math.h>

static const double SLOPE = 0.01; /* of the leaky ReLU below zero */

static void need_kind(kw_activation_kind kind)
{
    KW_NEED((int)kind >= 0 && (int)kind < KW_ACTIVATION_KINDS, "activation %d",
            (int)kind);
}

const char *kw_activation_name(kw_activation_kind kind)
{
    static const char *const name[KW_ACTIVATION_KINDS] = {
        "identity",   "sign", "step",     "logistic", "tanh", "ReLU",
        "leaky ReLU", "ELU",  "softplus", "GELU",     "SiLU"};

    need_kind(kind);
    return name[kind];
}

/* --- one number --- */

static double logistic(double z)
{
    double e = kw_exp(-fabs(z)); /* does not overflow */

    return z < 0 ? e / (1 + e) : 1 / (1 + e);
}

/* Phi(z), without cancellation at the left end */
static double normal(double z)
{
    const double root = 0x1.6a09e667f3bcdp-1; /* sqrt(1/2) */

    return 0.5 * kw_erfc(-z * root);
}

/* Phi'(z) */
static double bell(double z)
{
    const double height = 0x1.9884533d43651p-2; /* 1 / sqrt(2 pi) */

    return height * kw_exp(-0.5 * z * z);
}

static inline double value(kw_activation_kind kind, double z)
{
    switch (kind) {
    case KW_SIGN:
        return z >= 0 ? 1 : z < 0 ? -1 : z;
    case KW_STEP:
        return z >= 0 ? 1 : z < 0 ? 0 : z;
    case KW_LOGISTIC:
        return logistic(z);
    case KW_TANH:
        return kw_tanh(z);
    case KW_RELU:
        return z < 0 ? 0 : z;
    case KW_LEAKY_RELU:
        return z < 0 ? SLOPE * z : z;
    case KW_ELU:
        return z < 0 ? kw_expm1(z) : z;
    case KW_SOFTPLUS:
        return (z < 0 ? 0 : z) + kw_log1p(kw_exp(-fabs(z)));
    case KW_GELU:
        return z * normal(z);
    case KW_SILU:
        return z * logistic(z);
    case KW_IDENTITY:
        break;
    }
    return z;
}

/* The derivative at z, where the value is y. */
static inline double derivative(kw_activation_kind kind, double z, double y)
{
    double s;

    switch (kind) {
    case KW_SIGN:
    case KW_STEP:
        return 0;
    case KW_LOGISTIC:
        return y * (1 - y);
    case KW_TANH:
        return (1 - y) * (1 + y);
    case KW_RELU:
        return z > 0 ? 1 : 0;
    case KW_LEAKY_RELU:
        return z > 0 ? 1 : SLOPE;
    case KW_ELU:
        return z > 0 ? 1 : 1 + y;
    case KW_SOFTPLUS:
        return logistic(z);
    case KW_GELU:
        return normal(z) + z * bell(z);
    case KW_SILU:
        s = logistic(z);
        return s + y * (1 - s);
    case KW_IDENTITY:
        break;
    }
    return 1;
}

double kw_activation_value(kw_activation_kind kind, double z)
{
    need_kind(kind);
    return value(kind, z);
}

double kw_activation_derivative(kw_activation_kind kind, double z)
{
    need_kind(kind);
    return derivative(kind, z, value(kind, z));
}

/* --- many: loops for one kind have no choice to make, and compilers vectorize them --- */

static inline void values(kw_activation_kind kind, int n, const double *restrict z,
                          double *restrict y)
{
    for (int i = 0; i < n; i++)
        y[i] = value(kind, z[i]);
}

void kw_activation_many(kw_activation_kind kind, int n, const double *z, double *y)
{
    need_kind(kind);
    if (kind == KW_TANH)
        kw_tanh_many(n, z, y);
    else if (kind == KW_RELU)
        values(KW_RELU, n, z, y);
    else
        values(kind, n, z, y);
}

/* --- the layer --- */

kw_activation kw_activation_layer(kw_activation_kind kind, int width)
{
    need_kind(kind);
    KW_NEED(width >= 1, "width %d", width);
    return (kw_activation){.kind = kind, .in = width, .out = width};
}

static int need_batch(const kw_activation *l, int count)
{
    KW_NEED(1 <= count && count <= INT_MAX / l->in, "%d samples of %d numbers", count,
            l->in);
    return count * l->in;
}

void kw_activation_forward(const kw_activation *l, const double *w, int count,
                           const double *x, double *y)
{
    (void)w;
    kw_activation_many(l->kind, need_batch(l, count), x, y);
}

static inline void chain(kw_activation_kind kind, int n, const double *restrict x,
                         const double *restrict y, const double *restrict dy,
                         double *restrict dx)
{
    for (int i = 0; i < n; i++)
        dx[i] = dy[i] * derivative(kind, x[i], y[i]);
}

KW_WIDE static void chain_tanh(int n, const double *restrict x, const double *restrict y,
                               const double *restrict dy, double *restrict dx)
{
    chain(KW_TANH, n, x, y, dy, dx);
}

void kw_activation_backward(const kw_activation *l, const double *w, int count,
                            const double *x, const double *y, const double *dy,
                            double *dx, double *dw)
{
    int n = need_batch(l, count);

    (void)w;
    (void)dw;
    if (!dx)
        return;
    if (l->kind == KW_TANH)
        chain_tanh(n, x, y, dy, dx);
    else if (l->kind == KW_RELU)
        chain(KW_RELU, n, x, y, dy, dx);
    else
        chain(l->kind, n, x, y, dy, dx);
}
