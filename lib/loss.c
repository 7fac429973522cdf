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

/* Target i of all, in rows of `out`: a number, or one of two signs. */
static void need_number(ptrdiff_t i, int out, double target)
{
    KW_NEED(isfinite(target), "the target of output %td of sample %td is %g", i % out,
            i / out, target);
}

static void need_sign(ptrdiff_t i, int out, double target)
{
    KW_NEED(target == 1 || target == -1, "the target of output %td of sample %td is %g",
            i % out, i / out, target);
}

double kw_loss_squared(int count, int out, const double *y, const double *target,
                       double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        double off = y[i] - target[i];

        need_number(i, out, target[i]);
        sum += off * off;
        if (dy)
            dy[i] = 2 * off / count;
    }
    return sum / count;
}

/* The targets of sample i: probabilities. Returns their sum, one up to rounding. */
static double need_probabilities(int i, int out, const double *target)
{
    double total = 0;

    for (int k = 0; k < out; k++) {
        KW_NEED(target[k] >= 0, "the target of class %d of sample %d is %g", k, i,
                target[k]);
        total += target[k];
    }
    KW_NEED(fabs(total - 1) <= 1e-6, "the targets of sample %d add up to %g", i, total);
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
        double most = largest(out, a), total = need_probabilities(i, out, t), scale = 0;
        double off = 0;

        for (int k = 0; k < out; k++) {
            scale += kw_exp(a[k] - most);
            if (t[k] > 0) /* zero times a difference that overflows is NaN */
                off += t[k] * (most - a[k]);
        }
        sum += total * kw_log(scale) + off;
        for (int k = 0; dy && k < out; k++)
            dy[(ptrdiff_t)i * out + k] =
                (total * (kw_exp(a[k] - most) / scale) - t[k]) / count;
    }
    return sum / count;
}

double kw_loss_logistic(int count, int out, const double *y, const double *target,
                        double *dy)
{
    const ptrdiff_t entries = (ptrdiff_t)count * out;
    double sum = 0;

    need_shape(count, out);
    for (ptrdiff_t i = 0; i < entries; i++) {
        need_sign(i, out, target[i]);
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

        need_sign(i, out, target[i]);
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

        need_sign(i, out, target[i]);
        sum += right ? 0 : -target[i] * y[i];
        if (dy)
            dy[i] = right ? 0 : -target[i] / count;
    }
    return sum / count;
}
