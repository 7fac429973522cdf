/* Refinement -- knot insertion and degree elevation leave every curve where it is.

   What to see: nothing to look at. Knots one by one by Boehm's rule or all at once by the
   Oslo rows give the same control points and the same curve; so does a degree more.

   Book: section 1.1, the algorithms named behind the curve properties.
   Claims: bs.insert.boehm, .oslo, .dyadic, .rows, .least, bs.elevate.curve
   Chosen here: 100 random spaces with random control points. */

#include "claim.h"     /* what we found, for the ledger */
#include "control.h"   /* splines, halved and elevated */
#include "curve.h"     /* the curves */
#include "out.h"       /* reports are files */
#include "partition.h" /* random knots */
#include <math.h>

enum { CASES = 100, SAMPLES = 60 };

static spline insert_one(spline f, double x)
{
    spline g = new_spline(kw_insert_new_knot(f.s, x));

    kw_insert_boehm(f.s, x, PLANE, f.c, g.c);
    return g;
}

/* The largest distance of two curves over the common domain. */
static double curve_distance(spline f, spline g)
{
    double a = f.s->t[f.s->d], b = f.s->t[f.s->n], most = 0;

    for (int q = 0; q <= SAMPLES; q++) {
        double x = q == SAMPLES ? b : a + (b - a) * q / SAMPLES, p[PLANE], r[PLANE];

        kw_curve_point(f.s, PLANE, f.c, x, p);
        kw_curve_point(g.s, PLANE, g.c, x, r);
        most = fmax(most, fmax(fabs(p[0] - r[0]), fabs(p[1] - r[1])));
    }
    return most;
}

/* What should be zero, and by how much it is not. */
typedef struct findings {
    double boehm, oslo, dyadic, elevated, row_sum, least;
} findings;

/* One knot after the other at the middle of every span, by Boehm's rule; the result must be
   that of all at once, by the Oslo rows. */
static void try_insertion(spline f, findings *all)
{
    spline fine = insert_dyadic(f),
           slow = insert_one(f, (f.s->t[f.s->d] + f.s->t[f.s->d + 1]) / 2);

    for (int i = f.s->d + 1; i < f.s->n; i++)
        if (f.s->t[i] < f.s->t[i + 1]) {
            double middle = f.s->t[i] + (f.s->t[i + 1] - f.s->t[i]) / 2;
            spline next = insert_one(slow, middle);

            free_spline(slow);
            slow = next;
        }
    for (int j = 0; j < fine.s->n * PLANE; j++)
        all->oslo = fmax(all->oslo, fabs(fine.c[j] - slow.c[j]));
    for (int i = 0; i < fine.s->n; i++) {
        double alpha[PARTITION_D + 1], sum = 0;

        kw_insert_oslo_row(f.s, fine.s, i, alpha);
        for (int j = 0; j <= f.s->d; j++) {
            sum += alpha[j];
            all->least = fmin(all->least, alpha[j]);
        }
        all->row_sum = fmax(all->row_sum, fabs(sum - 1));
    }
    all->boehm = fmax(all->boehm, curve_distance(f, slow));
    all->dyadic = fmax(all->dyadic, curve_distance(f, fine));
    free_spline(fine);
    free_spline(slow);
}

static void try_random_spaces(findings *all)
{
    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(7, i);
        kw_rng r = kw_rng_at(8, 0, i, 0);
        spline f = new_spline(partition_space(&p)), higher;

        for (int j = 0; j < f.s->n * PLANE; j++)
            f.c[j] = 2 * kw_rng_uniform(&r) - 1;
        try_insertion(f, all);
        higher = elevate(f);
        all->elevated = fmax(all->elevated, curve_distance(f, higher));
        free_spline(higher);
        free_spline(f);
    }
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_refinement");
    findings all = {.least = INFINITY};

    try_random_spaces(&all);
    kw_claim_real(report, "bs.insert.boehm", all.boehm);
    kw_claim_real(report, "bs.insert.oslo", all.oslo);
    kw_claim_real(report, "bs.insert.dyadic", all.dyadic);
    kw_claim_real(report, "bs.insert.rows", all.row_sum);
    kw_claim_real(report, "bs.insert.least", all.least);
    kw_claim_real(report, "bs.elevate.curve", all.elevated);
    return kw_out_close(report);
}
