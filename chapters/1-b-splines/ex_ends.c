/* Ends -- where a curve begins and ends, and how it closes.

   What to see: nothing to look at. On open knots a curve runs from the first control point to
   the last; on periodic knots one with repeated control points closes smoothly.

   Book: section 1.1, the properties named behind the list of curve properties.
   Claims: bs.ends.open, bs.periodic.seam
   Chosen here: 200 random open spaces with random control points; a closed cubic. */

#include "bspline.h"   /* the spaces */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* the curves */
#include "out.h"       /* reports are files */
#include "partition.h" /* random knots */
#include <math.h>

enum { CASES = 200, PLANE = 2 };

/* Random control points in [-1,1]^2. */
static void random_points(uint64_t i, int n, double *c)
{
    kw_rng r = kw_rng_at(5, 0, i, 0);

    for (int j = 0; j < n * PLANE; j++)
        c[j] = 2 * kw_rng_uniform(&r) - 1;
}

/* The largest distance of an end of the curve from its end control point. */
static double end_distance(const kw_bspline *s, const double *c)
{
    double start[PLANE], end[PLANE], most = 0;

    kw_curve_point(s, PLANE, c, s->t[s->d], start);
    kw_curve_point(s, PLANE, c, s->t[s->n], end);
    for (int a = 0; a < PLANE; a++) {
        most = fmax(most, fabs(start[a] - c[a]));
        most = fmax(most, fabs(end[a] - c[(s->n - 1) * PLANE + a]));
    }
    return most;
}

/* A closed cubic curve: the largest difference of a derivative of order 0 .. 2 at the seam. */
static double seam(void)
{
    const double tau[] = {0, 1, 3, 4, 6, 7};
    kw_bspline *s = kw_bspline_new_periodic(3, 5, tau, NULL);
    double c[PARTITION_N * PLANE], start[3 * PLANE], end[3 * PLANE], most = 0;

    random_points(0, s->n, c);
    kw_curve_close(s, PLANE, c);
    kw_curve_derivatives(s, PLANE, c, tau[0], 2, start);
    kw_curve_derivatives(s, PLANE, c, tau[5], 2, end);
    for (int i = 0; i < 3 * PLANE; i++)
        most = fmax(most, fabs(start[i] - end[i]));
    kw_bspline_free(s);
    return most;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_ends");
    double c[PARTITION_N * PLANE] = {0}, ends = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(6, i);
        kw_bspline *s = partition_space(&p);

        random_points(i, s->n, c);
        ends = fmax(ends, end_distance(s, c));
        kw_bspline_free(s);
    }
    kw_claim_real(report, "bs.ends.open", ends);
    kw_claim_real(report, "bs.periodic.seam", seam());
    return kw_out_close(report);
}
