/* tanh -- its operations, and what part of a step of training they are.

   What to see: one quotient and a few dozen sums and products, the same for every argument, so that
   many can be done at once; a small part of the products of the matrices around it.

   Book: section 1.2 (activation functions, training).
   Claims: cost.tanh.*
   Chosen here: a network with 2, 64, 64, 1 units; arguments in [-25, 25] and in [-1, 1]. */

#include "claim.h"      /* what we found, for the ledger */
#include "counted.h"    /* arithmetic that counts itself */
#include "elementary.h" /* what it is compared with */
#include "mlp.h"        /* the weights of a network */
#include "rng.h"        /* arguments */
#include <math.h>

enum { ARGUMENTS = 1000, LAYERS = 3 };

/* From lib/elementary.c: C - 1, where e^2h = (C + h) / (C - h) and C = h coth h, from u = h^2. */
static double counted_excess(tally *t, double u)
{
    static const double c[] = {0x1.5555555555554p-2,  -0x1.6c16c16c157fcp-6,
                               0x1.1566abbe1ccf1p-9,  -0x1.bbd776e100a4bp-13,
                               0x1.66a84518c6e1ap-16, -0x1.2264b61adedbdp-19,
                               0x1.d1f1502f778bbp-23, -0x1.4272c5a192638p-26};
    double square = times(t, u, u), sum = plus(t, c[6], times(t, u, c[7]));

    for (int i = 4; i >= 0; i -= 2)
        sum = plus(t, plus(t, c[i], times(t, u, c[i + 1])), times(t, square, sum));
    return times(t, u, sum);
}

/* 2x = n log 2 + 2h; a choice between two numbers is no operation, but both are computed. */
static double counted_tanh(tally *t, double signed_x)
{
    const double shift = 0x1.8p52, inverse_ln2 = 0x1.71547652b82fep+0;
    const double ln2_high = 0x1.62e42fef00000p-1, ln2_low = 0x1.473de6af278edp-34;
    double size = fabs(signed_x), x = minus(t, 20, size) < 0 ? 20 : size;
    int small = minus(t, x, 0.65) < 0;
    double quotient = times(t, x, 2 * inverse_ln2);
    double n = minus(t, plus(t, small ? 0 : quotient, shift), shift);
    double h =
        minus(t, minus(t, x, times(t, n, 0.5 * ln2_high)), times(t, n, 0.5 * ln2_low));
    double v = counted_excess(t, times(t, h, h)), one = plus(t, 1, v);
    double upper = plus(t, one, h), lower = minus(t, one, h);
    double near_zero = times(t, h, v), part = small ? near_zero : lower;
    double denominator = plus(t, times(t, ldexp(1, (int)n), upper), lower);

    return copysign(minus(t, small ? h : 1, over(t, times(t, 2, part), denominator)),
                    signed_x);
}

/* The multiply-adds of a value and its gradient for one sample: the first layer has no layer
   before it that waits for a derivative. */
static double multiply_adds(const kw_net *n)
{
    double sum = 0;

    for (int l = 1; l <= LAYERS; l++)
        sum += (l > 1 ? 3.0 : 2.0) * kw_mlp_count_weights(n, l);
    return sum;
}

int main(void)
{
    const int units[] = {2, 64, 64, 1};
    const kw_activation_kind sigma[] = {KW_TANH, KW_TANH, KW_IDENTITY};
    kw_net *n = kw_mlp_new(LAYERS, units, sigma);
    kw_out *report = kw_claim_new("ex_tanh");
    kw_rng r = kw_rng_at(100, 0, 0, 0);
    double x[ARGUMENTS], ours[ARGUMENTS], lib[ARGUMENTS];
    tally t = {0};

    for (int i = 0; i < ARGUMENTS; i++) {
        x[i] = (i % 2 ? 25 : 1) * (2 * kw_rng_uniform(&r) - 1);
        t = (tally){0}; /* the same for each */
        ours[i] = counted_tanh(&t, x[i]);
    }
    kw_tanh_many(ARGUMENTS, x, lib);
    kw_claim_count(report, "cost.tanh.operations", operations(&t));
    kw_claim_count(report, "cost.tanh.quotients", t.quotients);
    kw_claim_count(report, "cost.tanh.bits", differing(ARGUMENTS, ours, lib));
    kw_claim_real(report, "cost.tanh.part",
                  (double)operations(&t) * (units[1] + units[2]) /
                      (2 * multiply_adds(n)));
    kw_net_free(n);
    return kw_out_close(report);
}
