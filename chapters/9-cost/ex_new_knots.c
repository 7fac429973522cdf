/* New knots -- operations of a curve that gets one in the middle of every span.

   What to see: the knots one after the other, by Boehm's rule, take as many operations each as an
   average of two neighbours, d times; each coefficient on its own, by the Oslo algorithm, takes a
   triangle.

   Book: section 1.1 (knot insertion is what makes spline spaces nested).
   Claims: cost.refine.*
   Chosen here: a cubic curve in R^3 on 1000 random spans, open knots. */

#include "claim.h"   /* what we found, for the ledger */
#include "counted.h" /* arithmetic that counts itself */
#include "insert.h"  /* what it is compared with */
#include "need.h"    /* memory */
#include "rng.h"     /* knots and coefficients */
#include <stdlib.h>
#include <string.h>

enum { D = 3, SPANS = 1000, N = 3 };

static kw_bspline *new_spans(void)
{
    double tau[SPANS + 1] = {0};
    kw_rng r = kw_rng_at(98, 0, 0, 0);

    for (int i = 0; i < SPANS; i++)
        tau[i + 1] = tau[i] + kw_rng_uniform(&r) + 0x1p-20;
    return kw_bspline_new_open(D, SPANS, tau, NULL);
}

static double *new_coefficients(int count)
{
    double *c = kw_need_memory((size_t)count, sizeof *c);
    kw_rng r = kw_rng_at(99, 0, 0, 0);

    for (int i = 0; i < count; i++)
        c[i] = kw_rng_uniform(&r);
    return c;
}

/* Boehm's rule for the knot x, n coefficients so far, t[0..last] the knots up to x, right[0] the
   first one behind it: d coefficients become averages, those behind them move on. */
static void insert_one(tally *t, int n, const double *knot, int last, const double *right,
                       double x, double *c)
{
    memmove(c + (last + 1) * N, c + last * N, (size_t)(n - last) * N * sizeof *c);
    for (int j = last; j > last - D; j--) {
        double w =
            over(t, minus(t, x, knot[j]), minus(t, right[j - last + D - 1], knot[j]));
        double rest = minus(t, 1, w);

        for (int a = 0; a < N; a++)
            c[j * N + a] =
                plus(t, times(t, w, c[j * N + a]), times(t, rest, c[(j - 1) * N + a]));
    }
}

/* All knots of `fine` that `coarse` has not, from left to right; c has room for fine->n x N. */
static void insert_by_boehm(tally *t, const kw_bspline *coarse, const kw_bspline *fine,
                            double *c)
{
    const double *next = coarse->t;
    int n = coarse->n;

    for (int i = 0; i < fine->n; i++)
        if (fine->t[i] == *next)
            next++;
        else
            insert_one(t, n++, fine->t, i - 1, next, fine->t[i], c);
}

/* Each fine coefficient is the polar form of its piece at the inner knots of its function. */
static void insert_by_oslo(tally *t, const kw_bspline *coarse, const kw_bspline *fine,
                           const double *c, double *out)
{
    memset(out, 0, (size_t)fine->n * N * sizeof *out);
    for (int i = 0; i < fine->n; i++) {
        double alpha[D + 1];
        int span = kw_bspline_span(coarse, fine->t[kw_bspline_first_span(fine, i)]);

        blossom_by_triangle(t, coarse, span, fine->t + i + 1, alpha);
        add_combination(t, D + 1, N, alpha, c + (span - D) * N, N, out + i * N);
    }
}

static void report_way(kw_out *report, const char *id, const char *quotients,
                       const tally *t)
{
    kw_claim_real(report, id, (double)operations(t) / SPANS);
    kw_claim_real(report, quotients, (double)t->quotients / SPANS);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_new_knots");
    kw_bspline *coarse = new_spans(), *fine = kw_insert_new_dyadic(coarse);
    int numbers = fine->n * N, differ;
    double *c = new_coefficients(coarse->n * N);
    double *ours = kw_need_memory((size_t)numbers, sizeof *ours);
    double *lib = kw_need_memory((size_t)numbers, sizeof *lib);
    tally boehm = {0}, oslo = {0};

    memcpy(ours, c, (size_t)coarse->n * N * sizeof *c);
    insert_by_boehm(&boehm, coarse, fine, ours);
    kw_insert_boehm_all(coarse, fine, N, c, lib);
    differ = differing(numbers, ours, lib);
    insert_by_oslo(&oslo, coarse, fine, c, ours);
    kw_insert_oslo(coarse, fine, N, c, lib);
    differ += differing(numbers, ours, lib);

    report_way(report, "cost.refine.boehm", "cost.refine.boehm.quotients", &boehm);
    report_way(report, "cost.refine.oslo", "cost.refine.oslo.quotients", &oslo);
    kw_claim_count(report, "cost.refine.bits", differ);

    free(c);
    free(ours);
    free(lib);
    kw_bspline_free(fine);
    kw_bspline_free(coarse);
    return kw_out_close(report);
}
