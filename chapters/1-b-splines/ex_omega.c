/* Definition 3 -- the weights omega, as printed and as they should be.

   What to see: nothing to look at. Transcribed word for word the recursion divides by zero
   on open knots; with x/0 := 0 it is the library's, inside the domain. It asks for more
   functions of order 1 than are defined, and some weights are zero everywhere.

   Book: section 1.1, Remark 2, Definition 3 and the text behind it.
   Claims: bs.def3.nan, bs.def3.guarded, bs.def3.omega*, bs.def3.order1,
           bs.knots.multiplicity, bs.rem2.chain.inside
   Chosen here: order 3 on the knots 0,0,0,1,2,3,3,3. */

#include "bspline.h"     /* the corrected recursion */
#include "claim.h"       /* what we found, for the ledger */
#include "definition3.h" /* the printed one */
#include "out.h"         /* reports are files */
#include <math.h>

/* Functions that are NaN at every sample in [a,b), and functions that are zero at each. */
static void count_odd(rule how, int *nan, int *zero)
{
    *nan = *zero = 0;
    for (int j = 0; j <= N; j++) {
        int bad = 0, none = 0;

        for (int i = 0; i < SAMPLES; i++) {
            double value = printed(how, j, K, sample(how.t, i));

            bad += isnan(value);
            none += value == 0;
        }
        *nan += bad == SAMPLES;
        *zero += none == SAMPLES;
    }
}

/* Weights omega_{j,r} that the recursion asks for, r = 2 .. k, and that are zero everywhere. */
static int count_zero_weights(rule how)
{
    int count = 0;

    for (int r = 2; r <= K; r++)
        for (int j = 0; j <= N + K - r + 1; j++) {
            int zeros = 0;

            for (int i = 0; i < SAMPLES; i++)
                zeros += omega(how, j, r, sample(how.t, i)) == 0;
            count += zeros == SAMPLES;
        }
    return count;
}

/* Functions of order 1 that the recursion asks for. */
static int count_order1(const double *t)
{
    int called[N + K + 1] = {0}, count = 0;

    sum_printed((rule){NONE, USUAL, t, called}, t[K - 1]);
    for (int j = 0; j <= N + K; j++)
        count += called[j];
    return count;
}

/* The largest difference from the library on [a,b) once x/0 counts as 0. */
static double worst_guarded(const double *t)
{
    kw_bspline *s = kw_bspline_new(K - 1, N + 1, t);
    rule how = {NONE, GUARDED, t, NULL};
    double worst = 0;

    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j <= N; j++)
            worst = fmax(worst, fabs(printed(how, j, K, sample(t, i)) -
                                     kw_bspline_one(s, j, 0, sample(t, i))));
    kw_bspline_free(s);
    return worst;
}

/* The largest change inside [a,b) from the knots t to the knots u. */
static double largest_change(const double *t, const double *u)
{
    rule first = {NONE, GUARDED, t, NULL}, then = {NONE, GUARDED, u, NULL};
    double change = 0;

    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j <= N; j++)
            change = fmax(change, fabs(printed(first, j, K, sample(t, i)) -
                                       printed(then, j, K, sample(t, i))));
    return change;
}

/* omega is a polynomial of degree 1 on either side of its right knot: second differences
   on integer points are zero. */
static double bend_of_omega(rule how)
{
    double bend = 0;

    for (int j = 0; j <= N; j++)
        for (int x = -4; x <= 8; x++)
            if (x + 1 < how.t[j + K - 1] || x - 1 >= how.t[j + K - 1])
                bend = fmax(bend, fabs(omega(how, j, K, x - 1) - 2 * omega(how, j, K, x) +
                                       omega(how, j, K, x + 1)));
    return bend;
}

int main(void)
{
    const double open[KNOTS] = {0, 0, 0, 1, 2, 3, 3, 3};
    const double chain[KNOTS] = {0, 0, 0, 1, 2, 3, 3, 7};     /* as Remark 2 allows */
    const double too_often[KNOTS] = {1, 1, 1, 1, 2, 3, 4, 5}; /* 1 k+1 times */
    const rule literal = {NONE, LITERAL, open, NULL},
               guarded = {NONE, GUARDED, open, NULL};
    kw_out *report = kw_claim_new("ex_omega");
    int nan, zero;

    count_odd(literal, &nan, &zero);
    kw_claim_count(report, "bs.def3.nan", nan);
    count_odd((rule){NONE, GUARDED, too_often, NULL}, &nan, &zero);
    kw_claim_count(report, "bs.knots.multiplicity", zero);
    kw_claim_real(report, "bs.def3.guarded", worst_guarded(open));
    kw_claim_real(report, "bs.def3.omega", bend_of_omega(guarded));
    kw_claim_count(report, "bs.def3.omega.zero", count_zero_weights(guarded));
    kw_claim_count(report, "bs.def3.order1", count_order1(open));
    kw_claim_real(report, "bs.rem2.chain.inside", largest_change(open, chain));
    return kw_out_close(report);
}
