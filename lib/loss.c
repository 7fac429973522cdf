#include "loss.h"
#include "activation.h"
#include "elementary.h"
#include "need.h"
#include <math.h>
#include <stddef.h>

static void need_shape(int count, int out)
{
    KW_NEED(count >= 1, "%d samples", count);
    KW_NEED(out >= 1, "%d outputs", out);
}

double kw_loss_squared(int count, int out, const double *y, const double *target,
                       double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        double off = y[i] - target[i];

        KW_NEED(isfinite(target[i]), "target %td is %g", i, target[i]);
        sum += off * off;
        if (dy)
            dy[i] = 2 * off / count;
    }
    return sum / count;
}

/* The targets of one sample: probabilities. Returns their sum, one up to rounding. */
static double need_probabilities(int out, const double *target)
{
    double total = 0;

    for (int k = 0; k < out; k++) {
        KW_NEED(target[k] >= 0, "the target of class %d is %g", k, target[k]);
        total += target[k];
    }
    KW_NEED(fabs(total - 1) <= 1e-6, "the targets of a sample add up to %g", total);
    return total;
}

static double largest(int count, const double *a)
{
    double most = a[0];

    for (int i = 1; i < count; i++)
        most = a[i] > most ? a[i] : most;
    return most;
}

/* With the largest logit taken off all of them no exponential overflows, and their sum is at
   least one. */
double kw_loss_cross_entropy(int count, int out, const double *y, const double *target,
                             double *dy)
{
    double sum = 0;

    need_shape(count, out);
    KW_NEED(out >= 2, "%d classes", out);
    for (int i = 0; i < count; i++) {
        const double *a = y + (ptrdiff_t)i * out, *t = target + (ptrdiff_t)i * out;
        double most = largest(out, a), total = need_probabilities(out, t), scale = 0;
        double off = 0;

        for (int k = 0; k < out; k++) {
            scale += kw_exp(a[k] - most);
            off += t[k] * (most - a[k]);
        }
        sum += total * kw_log(scale) + off;
        for (int k = 0; dy && k < out; k++)
            dy[(ptrdiff_t)i * out + k] =
                (total * (kw_exp(a[k] - most) / scale) - t[k]) / count;
    }
    return sum / count;
}

static void need_sign(ptrdiff_t i, double target)
{
    KW_NEED(target == 1 || target == -1, "target %td is %g", i, target);
}

double kw_loss_logistic(int count, int out, const double *y, const double *target,
                        double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        need_sign(i, target[i]);
        sum += kw_activation_value(KW_SOFTPLUS, -target[i] * y[i]);
        if (dy)
            dy[i] =
                -target[i] * kw_activation_value(KW_LOGISTIC, -target[i] * y[i]) / count;
    }
    return sum / count;
}

/* Both written so that the NaN of a prediction comes out as a NaN. */
double kw_loss_hinge(int count, int out, const double *y, const double *target,
                     double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        int safe = target[i] * y[i] >= 1;

        need_sign(i, target[i]);
        sum += safe ? 0 : 1 - target[i] * y[i];
        if (dy)
            dy[i] = safe ? 0 : -target[i] / count;
    }
    return sum / count;
}

double kw_loss_perceptron(int count, int out, const double *y, const double *target,
                          double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        int right = (y[i] >= 0 && target[i] == 1) || (y[i] < 0 && target[i] == -1);

        need_sign(i, target[i]);
        sum += right ? 0 : -target[i] * y[i];
        if (dy)
            dy[i] = right ? 0 : -target[i] / count;
    }
    return sum / count;
}
