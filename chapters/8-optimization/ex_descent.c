/* Descent -- the paths of three methods on the loss of a single unit.

   What to see: (a) without an activation the loss is one valley; descent and momentum cross it
   to and fro. (c) Momentum is much sooner at its lowest point. (b) With tanh there are two minima and
   high plains: from the same start descent and Adam end in the worse one, and momentum runs
   past it. (d) Momentum and Adam raise the loss on the way, descent does not.

   Book: section 1.2, Optimization, and `the best function approximation' before Definition 7.
   Claims: opt.valley.rises.*, opt.hills.*
   Chosen here: four samples, the starts, the rates, in (a) the best for descent and momentum;
   every step takes all samples. */

#include "claim.h" /* what we found, for the ledger */
#include "out.h"   /* columns for gnuplot */
#include "unit.h"  /* the unit, its loss, the methods */
#include <math.h>
#include <stdio.h>

enum { GRID = 100, LONG = 4000 };

static const double NEAR = 0.01; /* of the loss: this is at a minimum */

static const char *const METHOD[METHODS] = {"descent", "momentum", "Adam"};

/* --- pictures --- */

static void write_surface(kw_out *f, const char *name, unit u)
{
    kw_out_section(f, name, "w b loss");
    for (int i = 0; i <= GRID; i++) {
        for (int k = 0; k <= GRID; k++) {
            const double w[2] = {LOW[0] + SIDE * i / GRID, LOW[1] + SIDE * k / GRID};

            kw_out_number(f, w[0]);
            kw_out_number(f, w[1]);
            kw_out_number(f, loss(u, w, NULL));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
}

/* A section a method. rises[m]: how many steps of method m raised the loss, by more than the
   rounding of two losses. */
static void write_paths(kw_out *f, const char *name, unit u, kw_optimizer *const *o,
                        const double *start, const double *minimum, int *rises)
{
    for (int m = 0; m < METHODS; m++) {
        double w[2] = {start[0], start[1]}, before = INFINITY;
        char section[32];

        snprintf(section, sizeof section, "%s, %s", name, METHOD[m]);
        kw_out_section(f, section, "step w b loss distance");
        rises[m] = 0;
        for (int i = 0; i <= STEPS; i++) {
            double now = loss(u, w, NULL);

            rises[m] += now > before * (1 + 1e-14);
            before = now;
            kw_out_number(f, i);
            kw_out_number(f, w[0]);
            kw_out_number(f, w[1]);
            kw_out_number(f, now);
            kw_out_number(f, distance(w, minimum));
            kw_out_row(f);
            walk(u, o[m], 1, w);
        }
    }
}

static void write_minimum(kw_out *f, const char *name, const double *w)
{
    kw_out_section(f, name, "w b");
    kw_out_number(f, w[0]);
    kw_out_number(f, w[1]);
    kw_out_row(f);
}

/* --- two minima --- */

/* Where a long walk from `from` ends. */
static void end_of(unit u, kw_method method, const double *from, double *w)
{
    kw_optimizer *o = kw_optimizer_new(method, 2, RATE[method]);

    w[0] = from[0];
    w[1] = from[1];
    walk(u, o, LONG, w);
    kw_optimizer_free(o);
}

static void report_count(kw_out *report, const char *what, kw_method method,
                         const char *end, int count)
{
    char id[40];

    snprintf(id, sizeof id, "opt.%s.%s%s", what, METHOD[method], end);
    kw_claim_count(report, id, count);
}

/* Where the walks of a method from all over the square end, as the loss tells: below that of
   the worse minimum is the basin of the better one; within a hundredth above it is the worse
   one; the rest is high up. */
static void report_ends(kw_out *report, unit u, kw_method method, double worse)
{
    int at_better = 0, at_worse = 0, on_plains = 0;

    for (int i = 0; i < STARTS * STARTS; i++) {
        double from[2], w[2], end;

        start_at(i, from);
        end_of(u, method, from, w);
        end = loss(u, w, NULL);
        at_better += end < worse * (1 - NEAR);
        at_worse += fabs(end - worse) <= worse * NEAR;
        on_plains += end > worse * (1 + NEAR);
    }
    report_count(report, "hills", method, ".better", at_better);
    report_count(report, "hills", method, ".worse", at_worse);
    report_count(report, "hills", method, ".plains", on_plains);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_descent"), *report = kw_claim_new("ex_descent");
    unit straight = new_unit(KW_IDENTITY), bent = new_unit(KW_TANH);
    const valley v = survey(straight);
    kw_optimizer *best[METHODS], *usual[METHODS];
    int rises[METHODS], rises_bent[METHODS];
    double worse[2], better[2], adam[2];

    new_best_optimizers(&v, best);
    new_optimizers(usual);
    write_surface(f, "valley", straight);
    write_paths(f, "valley", straight, best, VALLEY_START, v.minimum, rises);
    write_minimum(f, "valley's minimum", v.minimum);
    end_of(bent, KW_DESCENT, HILLS_START, worse);
    end_of(bent, KW_MOMENTUM, HILLS_START, better);
    end_of(bent, KW_ADAM, HILLS_START, adam);
    write_surface(f, "hills", bent);
    write_paths(f, "hills", bent, usual, HILLS_START, better, rises_bent);
    write_minimum(f, "worse minimum", worse);
    write_minimum(f, "better minimum", better);

    kw_claim_real(report, "opt.hills.worse", loss(bent, worse, NULL));
    kw_claim_real(report, "opt.hills.better", loss(bent, better, NULL));
    kw_claim_real(report, "opt.hills.adam", loss(bent, adam, NULL));
    for (int m = 0; m < METHODS; m++) {
        report_count(report, "valley.rises", (kw_method)m, "", rises[m]);
        report_count(report, "hills.rises", (kw_method)m, "", rises_bent[m]);
        report_ends(report, bent, (kw_method)m, loss(bent, worse, NULL));
    }

    free_optimizers(best);
    free_optimizers(usual);
    free_unit(straight);
    free_unit(bent);
    return kw_out_close(f) | kw_out_close(report);
}
