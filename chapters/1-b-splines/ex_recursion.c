/* Definition 3 -- the right end, as printed and as it should be.

   What to see: at the right end of an open knot vector the sentence `beta_{j,1}(t_{n+1}) = 1'
   has three readings, of which two break the partition of unity or hand the end to a wrong
   function.

   Book: section 1.1, Remark 2, Definition 3.
   Claims: bs.def3.end.*, bs.rem2.chain.end
   Chosen here: order 3 on the knots 0,0,0,1,2,3,3,3, and on others with the same domain. */

#include "bspline.h"     /* the corrected recursion */
#include "claim.h"       /* what we found, for the ledger */
#include "definition3.h" /* the printed one */
#include "out.h"         /* columns for gnuplot */
#include <math.h>

static double least_printed(rule how, double x)
{
    double least = INFINITY;

    for (int j = 0; j <= N; j++)
        least = fmin(least, printed(how, j, K, x));
    return least;
}

/* The index of the only function that is not zero at x, or -1. */
static int only_function(rule how, double x)
{
    int index = -1;

    for (int j = 0; j <= N; j++)
        if (printed(how, j, K, x) != 0) {
            if (index >= 0)
                return -1;
            index = j;
        }
    return index;
}

/* The values at the right end of each function: one block for each reading, and one for
   the library's. */
static void write_right_end(kw_out *f, const double *t)
{
    kw_bspline *s = kw_bspline_new(K - 1, N + 1, t);

    kw_out_section(f, "right end", "function value");
    for (int r = 0; r < READINGS; r++) {
        for (int j = 0; j <= N; j++) {
            rule how = {(reading)r, GUARDED, t, NULL};

            kw_out_number(f, j);
            kw_out_number(f, r == NONE ? kw_bspline_one(s, j, 0, t[N + 1])
                                       : printed(how, j, K, t[N + 1]));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    kw_bspline_free(s);
}

/* On open knots only the last function should be one at the end. */
static void report_open(kw_out *report, const double *t)
{
    const rule every = {EVERY_J, GUARDED, t, NULL},
               every_usual = {EVERY_J, USUAL, t, NULL}, n = {J_IS_N, GUARDED, t, NULL},
               n_usual = {J_IS_N, USUAL, t, NULL},
               last = {LAST_OF_ORDER_1, GUARDED, t, NULL},
               last_usual = {LAST_OF_ORDER_1, USUAL, t, NULL};
    const double b = t[N + 1];

    kw_claim_real(report, "bs.def3.end.every", sum_printed(every, b));
    kw_claim_real(report, "bs.def3.end.every.least", least_printed(every_usual, b));
    kw_claim_count(report, "bs.def3.end.n", only_function(n, b));
    kw_claim_count(report, "bs.def3.end.n.usual", only_function(n_usual, b));
    kw_claim_count(report, "bs.def3.end.last", only_function(last, b));
    kw_claim_count(report, "bs.def3.end.last.usual", only_function(last_usual, b));
}

/* On simple knots the functions go on beyond b: what do they add up to there? */
static void report_simple(kw_out *report, const double *t)
{
    const rule none = {NONE, GUARDED, t, NULL}, n = {J_IS_N, GUARDED, t, NULL},
               last = {LAST_OF_ORDER_1, GUARDED, t, NULL},
               every = {EVERY_J, GUARDED, t, NULL};
    const double b = t[N + 1];

    kw_claim_real(report, "bs.def3.end.simple.none", sum_printed(none, b));
    kw_claim_real(report, "bs.def3.end.simple.n", sum_printed(n, b));
    kw_claim_real(report, "bs.def3.end.simple.last", sum_printed(last, b));
    kw_claim_real(report, "bs.def3.end.simple.every", sum_printed(every, b));
}

int main(void)
{
    const double open[KNOTS] = {0, 0, 0, 1, 2, 3, 3, 3};
    const double simple[KNOTS] = {-2, -1, 0, 1, 2, 3, 4, 5}; /* the same domain */
    const double chain[KNOTS] = {0, 0, 0, 1, 2, 3, 3, 7};    /* as Remark 2 allows */
    kw_out *f = kw_out_data("ex_recursion"), *report = kw_claim_new("ex_recursion");

    write_right_end(f, open);
    report_open(report, open);
    report_simple(report, simple);
    kw_claim_real(report, "bs.rem2.chain.end",
                  printed((rule){J_IS_N, USUAL, chain, NULL}, N, K, chain[N + 1]));
    return kw_out_close(f) | kw_out_close(report);
}
