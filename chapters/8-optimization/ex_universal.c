/* What activations can represent -- any continuous function with ReLU, little with a square.

   What to see: nothing to look at. The ReLU network that is the piecewise linear interpolant has
   the error bound of the spline, which falls with the square of the width. In one hidden layer,
   units that square give a quadratic polynomial, however many there are; deeper they give more.

   Book: section 1.2, the sentence before Figure 15.
   Claims: opt.universal.*
   Chosen here: the function of ex_runge, whose second derivative is largest, 50, at 0. */

#include "claim.h"  /* what we found, for the ledger */
#include "fit.h"    /* the function */
#include "hinges.h" /* the network */
#include "out.h"    /* reports are files */
#include "rng.h"    /* random networks */
#include <math.h>

enum {
    WIDEST = 256,
    CELL = 64, /* points of a cell of the interpolant */
    CASES = 200,
    UNITS = 16
};

/* The largest error on [-1,1] of the network that interpolates at hidden + 1 equal steps. */
static double interpolation_error(int hidden)
{
    double t[WIDEST + 1], c[WIDEST + 1] = {0}, w[3 * WIDEST + 1], most = 0;
    kw_net *net = new_relu_net(hidden);
    kw_net_work *work = kw_net_work_new(net, 1);

    for (int i = 0; i <= hidden; i++) {
        t[i] = -1 + 2.0 * i / hidden;
        c[i] = fitted(t[i]);
    }
    hinges_of(hidden + 1, t, c, w);
    for (int i = 0; i <= hidden * CELL; i++) {
        double x = -1 + 2.0 * i / (hidden * CELL), y;

        kw_net_forward(net, w, 1, &x, work, &y);
        most = fmax(most, fabs(y - fitted(x)));
    }
    kw_net_work_free(work);
    kw_net_free(net);
    return most;
}

/* Widths 2, 4, .. for which the error is above h^2/8 times the largest second derivative, h the
   length of a cell. [de Boor, ch. III, (2)] */
static int count_above_bound(void)
{
    int above = 0;

    for (int hidden = 2; hidden <= WIDEST; hidden *= 2) {
        double h = 2.0 / hidden;

        above += interpolation_error(hidden) > h * h / 8 * 50;
    }
    return above;
}

/* A hidden layer of UNITS units with the activation z^2, and an affine output. */
static double squares(const double *w, double x)
{
    double y = w[3 * UNITS];

    for (int i = 0; i < UNITS; i++) {
        double z = w[i] * x + w[UNITS + i];

        y += w[2 * UNITS + i] * z * z;
    }
    return y;
}

/* Third differences of random networks of squares that are not zero: integers, exact. */
static int count_beyond_quadratic(void)
{
    int beyond = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(88, 0, sample, 0);
        double w[3 * UNITS + 1];

        for (int i = 0; i <= 3 * UNITS; i++)
            w[i] = kw_rng_below(&r, 19) - 9;
        for (int x = -20; x <= 20; x++)
            beyond += squares(w, x + 3) - 3 * squares(w, x + 2) + 3 * squares(w, x + 1) -
                          squares(w, x) !=
                      0;
    }
    return beyond;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_universal");

    kw_claim_count(report, "opt.universal.bound", count_above_bound());
    kw_claim_real(report, "opt.universal.error.16", interpolation_error(16));
    kw_claim_real(report, "opt.universal.error.256", interpolation_error(WIDEST));
    kw_claim_count(report, "opt.universal.squares", count_beyond_quadratic());
    return kw_out_close(report);
}
