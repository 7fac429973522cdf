/* Locality -- how many coefficients a point of a curve depends on.

   What to see: nothing to look at. Inside a span k functions are non-zero, at a knot of
   multiplicity mu <= d only k - mu; there the closed interval of property 2 may be used, at
   a knot that appears k times it may not.

   Book: section 1.1, the second property of B-spline curves.
   Claims: bs.list2.more-than-k, bs.list2.inside, bs.list2.knot, bs.list2.closed*
   Chosen here: 200 random open spaces. */

#include "bspline.h"   /* the functions */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* reports are files */
#include "partition.h" /* random knots */
#include <float.h>
#include <math.h>

enum { CASES = 200, POINTS = 20 /* of one span */ };

/* How often it fails. */
typedef struct findings {
    int more_than_k, not_k, knot, closed;
} findings;

static int count_nonzero(const kw_bspline *s, double x)
{
    int count = 0;

    for (int j = 0; j < s->n; j++)
        count += kw_bspline_one(s, j, 0, x) != 0;
    return count;
}

/* The sum of the functions i-d .. i at x, which (9) restricted to a span needs to be 1. */
static double sum_of_local(const kw_bspline *s, int i, double x)
{
    double sum = 0;

    for (int j = i - s->d; j <= i; j++)
        sum += kw_bspline_one(s, j, 0, x);
    return sum;
}

static void look_at_span(const kw_bspline *s, int i, findings *all)
{
    for (int q = 0; q < POINTS; q++) {
        int count =
            count_nonzero(s, s->t[i] + (s->t[i + 1] - s->t[i]) * (q + 0.5) / POINTS);

        all->more_than_k += count > s->d + 1;
        all->not_k += count != s->d + 1;
    }
}

/* At the interior breakpoints of multiplicity mu <= d: k - mu functions are non-zero, and the
   closed span to the left may be used as well; its sum has 5d + k roundings. */
static void look_at_knots(const partition *p, const kw_bspline *s, findings *all)
{
    for (int left = p->d, c = 1; c < p->L; left += p->mu[c++ - 1]) {
        if (p->mu[c - 1] > p->d)
            continue;
        all->knot += count_nonzero(s, p->tau[c]) != p->d + 1 - p->mu[c - 1];
        all->closed += fabs(sum_of_local(s, left, p->tau[c]) - 1) >
                       (5 * s->d + s->d + 1) * DBL_EPSILON / 2;
    }
}

/* Property 2 on a closed interval with a knot k times: hats on 0,0,1,1,2,2, x = t_2 = 1 taken
   into [t_1, t_2]: the sum of the weights j = 0, 1. */
static double closed_interval_example(void)
{
    const double tau[] = {0, 1, 2};
    const int mu[] = {2};
    kw_bspline *s = kw_bspline_new_open(1, 2, tau, mu);
    double sum = sum_of_local(s, 1, 1);

    kw_bspline_free(s);
    return sum;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_locality");
    findings all = {0, 0, 0, 0};

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(6, i);
        kw_bspline *s = partition_space(&p);

        for (int span = s->d; span < s->n; span++)
            if (s->t[span] < s->t[span + 1])
                look_at_span(s, span, &all);
        look_at_knots(&p, s, &all);
        kw_bspline_free(s);
    }
    kw_claim_count(report, "bs.list2.more-than-k", all.more_than_k);
    kw_claim_count(report, "bs.list2.inside", all.not_k);
    kw_claim_count(report, "bs.list2.knot", all.knot);
    kw_claim_count(report, "bs.list2.closed.simple", all.closed);
    kw_claim_real(report, "bs.list2.closed", closed_interval_example());
    return kw_out_close(report);
}
