/* The span of a point -- how many knots are looked at to find it.

   What to see: one after the other, the knots are looked at in proportion to their number; by
   bisection, to its logarithm; with a table of equal parts of the domain, hardly any, however many
   there are.

   Book: section 1.1 (any value of a B-spline begins with the span of the point).
   Claims: cost.search.*
   Chosen here: the numbers of spans, equal and random ones, the points. */

#include "bspline.h" /* spans */
#include "claim.h"   /* what we found, for the ledger */
#include "counted.h" /* comparisons that count themselves */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "rng.h"     /* points and knots */
#include <stdio.h>
#include <stdlib.h>

enum { POINTS = 100, SIZES = 6, DEGREE = 3, WAYS = 3 };

/* The table of the library: the part of the domain in which x lies has its candidates, and these
   are halved. */
static int span_by_table(tally *t, const kw_bspline *s, double x)
{
    int part = (int)((x - s->t[s->d]) * s->scale + 0.5);
    int low = s->before[part];

    for (int count = s->candidates; count > 1; count -= count / 2)
        if (!below(t, x, s->t[low + count / 2]))
            low += count / 2;
    return low;
}

static kw_bspline *new_spans(int spans, int random)
{
    kw_bspline *s;
    double *tau = kw_need_memory((size_t)spans + 1, sizeof *tau);
    kw_rng r = kw_rng_at(91, 0, (uint64_t)spans, 0);

    for (int i = 0; i < spans; i++)
        tau[i + 1] = tau[i] + (random ? kw_rng_uniform(&r) + 0x1p-20 : 1);
    s = kw_bspline_new_open(DEGREE, spans, tau, NULL);
    free(tau);
    return s;
}

/* Knots that are looked at for all points, by scan, bisection and table; returns how many spans
   are not the one that the library finds. */
static int look(const kw_bspline *s, tally *t)
{
    kw_rng r = kw_rng_at(92, 0, 0, 0);
    int wrong = 0;

    for (int p = 0; p < POINTS; p++) {
        double x = kw_rng_uniform(&r) * s->t[s->n];
        int i = kw_bspline_span(s, x);

        wrong += span_by_scan(&t[0], s, x) != i;
        wrong += span_by_bisection(&t[1], s, x) != i;
        wrong += span_by_table(&t[2], s, x) != i;
    }
    return wrong;
}

int main(void)
{
    static const char *const way[] = {"scan", "bisection", "table"};
    kw_out *f = kw_out_data("ex_search"), *report = kw_claim_new("ex_search");
    int wrong = 0;

    for (int random = 0; random <= 1; random++) {
        int spans = 10;

        kw_out_section(f, random ? "random" : "equal", "spans scan bisection table");
        for (int i = 0; i < SIZES; i++, spans *= 10) {
            kw_bspline *s = new_spans(spans, random);
            tally t[WAYS] = {{0}};

            wrong += look(s, t);
            kw_out_number(f, spans);
            for (int w = 0; w < WAYS; w++) {
                double mean = (double)t[w].comparisons / POINTS;
                char id[60];

                kw_out_number(f, mean);
                snprintf(id, sizeof id, "cost.search.%s.%s.%d",
                         random ? "random" : "equal", way[w], i + 1);
                if (i == 1 || i == SIZES - 1)
                    kw_claim_real(report, id, mean);
            }
            kw_out_row(f);
            kw_bspline_free(s);
        }
    }
    kw_claim_count(report, "cost.search.wrong", wrong);
    return kw_out_close(f) | kw_out_close(report);
}
