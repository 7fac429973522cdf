/* activation.h -- the activation functions of Figure 15, and a layer that applies one.

     KW_IDENTITY    z
     KW_SIGN        +1 if z >= 0, else -1                      [source text, before (21)]
     KW_STEP        1 if z >= 0, else 0
     KW_LOGISTIC    1 / (1 + e^-z), the sigmoid
     KW_TANH        tanh z
     KW_RELU        z if z > 0, else 0                         [source text, Remark 9]
     KW_LEAKY_RELU  z if z > 0, else 0.01 z
     KW_ELU         z if z > 0, else e^z - 1
     KW_SOFTPLUS    log(1 + e^z)
     KW_GELU        z Phi(z), Phi the distribution function of the standard normal law
     KW_SILU        z / (1 + e^-z)

   The derivative at a kink or jump is that from the left: 0 for sign, step and ReLU, 0.01 for the
   leaky ReLU. Functions that have a saturated end take the derivative there from the
   value, so it has an absolute error of some 1e-16. The value of a NaN is a NaN. So is the
   derivative, but where it is constant on pieces (identity, sign, step, ReLU, leaky ReLU) it is as
   for z < 0. What else is said is for finite z. The source text prints no list; this one is
   chosen. [Goodfellow, Bengio, Courville: Deep Learning, 2016, sections 6.2 and 6.3;
   Hendrycks, Gimpel: Gaussian error linear units, 2016] */
#ifndef KW_ACTIVATION_H
#define KW_ACTIVATION_H

typedef enum kw_activation_kind {
    KW_IDENTITY,
    KW_SIGN,
    KW_STEP,
    KW_LOGISTIC,
    KW_TANH,
    KW_RELU,
    KW_LEAKY_RELU,
    KW_ELU,
    KW_SOFTPLUS,
    KW_GELU,
    KW_SILU
} kw_activation_kind;

enum { KW_ACTIVATION_KINDS = KW_SILU + 1 };

/* "identity", "sign", .. */
const char *kw_activation_name(kw_activation_kind kind);

/* sigma(z), and its derivative there. */
double kw_activation_value(kw_activation_kind kind, double z);
double kw_activation_derivative(kw_activation_kind kind, double z);

/* y[i] = sigma(z[i]), i < n. z and y do not overlap. */
void kw_activation_many(kw_activation_kind kind, int n, const double *z, double *y);

/* --- the layer: sigma on each of `in` numbers --- */

typedef struct kw_activation {
    kw_activation_kind kind;
    int in, out;    /* the same number */
    int parameters; /* 0 */
} kw_activation;

/* width >= 1 */
kw_activation kw_activation_layer(kw_activation_kind kind, int width);

/* x, y: count x in, count >= 1; they do not overlap. w is ignored. */
void kw_activation_forward(const kw_activation *l, const double *w, int count,
                           const double *x, double *y);

/* From dy, the derivative of a number with respect to y, to that with respect to x: dx is
   set (NULL: not wanted). y is what kw_activation_forward wrote; w and dw are ignored. */
void kw_activation_backward(const kw_activation *l, const double *w, int count,
                            const double *x, const double *y, const double *dy,
                            double *dx, double *dw);

#endif
