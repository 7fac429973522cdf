/* Rates -- how far a step may go, how many steps there are, and what Adam does not see.

   What to see: nothing to look at (ex_descent has the picture). In the valley of an affine unit
   an error decays along each eigenvector of the second derivatives by the same factor in every
   step. So the loss falls at rates below two over the largest eigenvalue and grows above, and
   how many steps it takes follows from the quotient of the eigenvalues. The first step of
   Adam is as long as its rate, whatever the gradient, and its path is the same if the loss is
   measured in another unit; both but for the constant 1e-8 that it adds, which is zero here.

   Book: section 1.2, Optimization.
   Claims: opt.valley.*, opt.adam.*
   Chosen here: the units and samples of ex_descent (unit.h). */

#include "claim.h" /* what we found, for the ledger */
#include "out.h"   /* reports are files */
#include "unit.h"  /* the unit, its loss, the methods */
#include <math.h>

/* --- the valley --- */

/* An error decays along each eigenvector by the factor 1 - rate * eigenvalue a step: the largest
   distance of the path of descent from this. */
static double path_error(unit u, const valley *v)
{
    kw_optimizer *o = kw_optimizer_new(KW_DESCENT, 2, RATE[KW_DESCENT]);
    const double lambda[2] = {v->least, v->most};
    double w[2] = {VALLEY_START[0], VALLEY_START[1]}, part[2], most = 0;

    for (int k = 0; k < 2; k++)
        part[k] = v->vector[2 * k] * (w[0] - v->minimum[0]) +
                  v->vector[2 * k + 1] * (w[1] - v->minimum[1]);
    for (int i = 0; i < STEPS; i++) {
        double expected[2] = {v->minimum[0], v->minimum[1]};

        walk(u, o, 1, w);
        for (int k = 0; k < 2; k++) {
            part[k] *= 1 - RATE[KW_DESCENT] * lambda[k];
            expected[0] += part[k] * v->vector[2 * k];
            expected[1] += part[k] * v->vector[2 * k + 1];
        }
        most = fmax(most, distance(w, expected));
    }
    kw_optimizer_free(o);
    return most;
}

/* Rates of q/20 of the limit, q = 1 .. 40 but 20, for which it is not true that the loss falls
   if q < 20 and grows if q > 20. */
static int rates_off(unit u, kw_method method, double limit)
{
    int off = 0;

    for (int q = 1; q <= 40; q++) {
        kw_optimizer *o = kw_optimizer_new(method, 2, limit * q / 20);
        double w[2] = {VALLEY_START[0], VALLEY_START[1]};

        walk(u, o, 100, w);
        off += q != 20 && (loss(u, w, NULL) < loss(u, VALLEY_START, NULL)) != (q < 20);
        kw_optimizer_free(o);
    }
    return off;
}

/* Steps until the minimum is a thousand times nearer than at the start. */
static int count_steps(unit u, const valley *v, kw_optimizer *o)
{
    const double near = distance(VALLEY_START, v->minimum) / 1000;
    double w[2] = {VALLEY_START[0], VALLEY_START[1]};
    int steps = 0;

    for (; distance(w, v->minimum) > near; steps++)
        walk(u, o, 1, w);
    return steps;
}

static void report_valley(kw_out *report, unit u, const valley *v)
{
    const double limit = 2 / v->most, keep = 0.9; /* what momentum keeps (optimizer.h) */
    kw_optimizer *o[METHODS];

    kw_claim_real(report, "opt.valley.condition", v->most / v->least);
    kw_claim_real(report, "opt.valley.limit", limit);
    kw_claim_real(report, "opt.valley.path", path_error(u, v));
    kw_claim_count(report, "opt.valley.rates.descent", rates_off(u, KW_DESCENT, limit));
    kw_claim_count(report, "opt.valley.rates.momentum",
                   rates_off(u, KW_MOMENTUM, (1 + keep) * limit));
    new_best_optimizers(v, o);
    kw_claim_count(report, "opt.valley.steps.descent", count_steps(u, v, o[KW_DESCENT]));
    kw_claim_count(report, "opt.valley.steps.momentum",
                   count_steps(u, v, o[KW_MOMENTUM]));
    free_optimizers(o);
}

/* --- Adam --- */

/* The largest difference of the first steps' entries, over the rate, from one in absolute
   value. */
static double first_step_error(unit u)
{
    double most = 0;

    for (int i = 0; i < STARTS * STARTS; i++) {
        kw_optimizer *o = kw_optimizer_new(KW_ADAM, 2, RATE[KW_ADAM]);
        double w[2], from[2];

        o->floor = 0;
        start_at(i, from);
        start_at(i, w);
        walk(u, o, 1, w);
        for (int j = 0; j < 2; j++)
            most = fmax(most, fabs(fabs(w[j] - from[j]) / o->rate - 1));
        kw_optimizer_free(o);
    }
    return most;
}

/* Steps behind which the path is another one if all gradients are 2^10 times as large. Without
   Adam's constant 1e-8, which is of the size of a gradient and is not multiplied. */
static int scale_matters(unit u, kw_method method)
{
    kw_optimizer *o[2];
    double w[2][2], dw[2];
    int differ = 0;

    for (int k = 0; k < 2; k++) {
        o[k] = kw_optimizer_new(method, 2, RATE[method]);
        o[k]->floor = 0;
        w[k][0] = HILLS_START[0];
        w[k][1] = HILLS_START[1];
    }
    for (int i = 0; i < STEPS; i++) {
        for (int k = 0; k < 2; k++) {
            loss(u, w[k], dw);
            dw[0] *= k ? 0x1p10 : 1;
            dw[1] *= k ? 0x1p10 : 1;
            kw_optimizer_step(o[k], dw, w[k]);
        }
        differ += w[0][0] != w[1][0] || w[0][1] != w[1][1];
    }
    for (int k = 0; k < 2; k++)
        kw_optimizer_free(o[k]);
    return differ;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_rates");
    unit straight = new_unit(KW_IDENTITY), bent = new_unit(KW_TANH);
    const valley v = survey(straight);

    report_valley(report, straight, &v);
    kw_claim_real(report, "opt.adam.first", first_step_error(bent));
    kw_claim_count(report, "opt.adam.scale", scale_matters(bent, KW_ADAM));
    kw_claim_count(report, "opt.adam.scale.descent", scale_matters(bent, KW_DESCENT));
    free_unit(straight);
    free_unit(bent);
    return kw_out_close(report);
}
