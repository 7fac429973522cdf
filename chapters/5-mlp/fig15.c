/* Figure 15 -- Activation functions and their derivatives.

   What to see: straight or bent, bounded or not, with a kink, a jump or none. The derivative
   is what a gradient sees: where it is zero, as for sign and step, nothing is learned.

   Book: section 1.2, Figure 15 and Remark 9.
   Claims: mlp.fig15.*, mlp.rem9.*
   Chosen here: the eleven functions; the book prints no list. */

#include "activation.h" /* the functions */
#include "claim.h"      /* what we found, for the ledger */
#include "out.h"        /* columns for gnuplot */
#include <math.h>

enum { HALF = 64, PER_UNIT = 16 }; /* points on either side of 0; points a unit */

/* Values and derivatives on either side of 0, where they may break, and the value at 0. */
static void write_function(kw_out *f, kw_activation_kind kind)
{
    const double nearly = 0x1p-60; /* as good as 0, but on one side */

    kw_out_section(f, kw_activation_name(kind), "z value derivative");
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i <= HALF; i++) {
            double z = side < 0 ? (i - HALF) / (double)PER_UNIT : i / (double)PER_UNIT;

            z = z == 0 ? side * nearly : z;
            kw_out_number(f, z);
            kw_out_number(f, kw_activation_value(kind, z));
            kw_out_number(f, kw_activation_derivative(kind, z));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
}

/* The largest difference between the derivative and a central difference of four points,
   none of them across 0. */
static double derivative_error(kw_activation_kind kind)
{
    const double h = 0x1p-10;
    double most = 0;

    for (int i = -HALF; i <= HALF; i++) {
        double z = (i + 0.5) / PER_UNIT, value[5], slope;

        for (int k = -2; k <= 2; k++)
            value[k + 2] = kw_activation_value(kind, z + k * h);
        slope = (8 * (value[3] - value[1]) - (value[4] - value[0])) / (12 * h);
        most = fmax(most, fabs(slope - kw_activation_derivative(kind, z)));
    }
    return most;
}

/* Places, between neighbours on a grid of integers over 16, where the function bends: where
   it is not exactly straight. *last is the last of them. */
static int count_bends(kw_activation_kind kind, double *last)
{
    int bends = 0;

    for (int i = 1 - HALF; i < HALF; i++) {
        double z = i / (double)PER_UNIT, h = 1.0 / PER_UNIT;

        if (kw_activation_value(kind, z - h) - 2 * kw_activation_value(kind, z) +
                kw_activation_value(kind, z + h) !=
            0) {
            bends++;
            *last = z;
        }
    }
    return bends;
}

int main(void)
{
    kw_out *f = kw_out_data("fig15"), *report = kw_claim_new("fig15");
    double error = 0, kink = NAN, ignored;
    int nonlinear = 0;

    for (int kind = 0; kind < KW_ACTIVATION_KINDS; kind++) {
        write_function(f, (kw_activation_kind)kind);
        error = fmax(error, derivative_error((kw_activation_kind)kind));
        nonlinear += count_bends((kw_activation_kind)kind, &ignored) > 0;
    }
    kw_out_section(f, "jumps", "sign step");
    kw_out_number(f, kw_activation_value(KW_SIGN, 0));
    kw_out_number(f, kw_activation_value(KW_STEP, 0));
    kw_out_row(f);

    kw_claim_count(report, "mlp.fig15.functions", KW_ACTIVATION_KINDS);
    kw_claim_count(report, "mlp.fig15.nonlinear", nonlinear);
    kw_claim_real(report, "mlp.fig15.derivative", error);
    kw_claim_count(report, "mlp.rem9.pieces", count_bends(KW_RELU, &kink) + 1);
    kw_claim_real(report, "mlp.rem9.kink", kink);
    return kw_out_close(f) | kw_out_close(report);
}
