/* Pieces and polynomials -- what lies in the spaces.

   What to see: nothing to look at. On each span a B-spline is a polynomial of degree d; sums of
   B-splines give every polynomial of degree d (Marsden's identity); and with k-fold knots
   they give the indicator of a cell, which jumps.

   Book: section 1.1, Remark 1, Definition 2, and the text behind Definition 3.
   Claims: bs.rem1.jump, bs.piece.degree, bs.def2.polynomials
   Chosen here: 150 random open knot vectors. */

#include "bspline.h"   /* the functions */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* splines with given coefficients */
#include "out.h"       /* reports are files */
#include "partition.h" /* random knots */
#include <math.h>

enum { CASES = 150, SAMPLES = 80, EIGHTHS = 8 };

/* The (d+1)-th difference over d+2 points inside a span, which is zero for a polynomial of
   degree d; the largest over the functions. The points are eighths of the span, which are
   exact: its ends are small integers. */
static double difference_in_spans(const kw_bspline *s)
{
    double most = 0;

    for (int i = s->d; i < s->n; i++)
        for (int j = 0; s->t[i] < s->t[i + 1] && j < s->n; j++) {
            double sum = 0, binomial = 1, h = s->t[i + 1] - s->t[i];

            for (int q = 0; q <= s->d + 1; q++) {
                double x = s->t[i] + h * (q + 1) / EIGHTHS;

                sum += (q % 2 ? -1 : 1) * binomial * kw_bspline_one(s, j, 0, x);
                binomial = binomial * (s->d + 1 - q) / (q + 1);
            }
            most = fmax(most, fabs(sum));
        }
    return most;
}

/* Marsden's identity: (y-x)^d = sum over j of prod_i (y - t_{j+i}) beta_j(x). The powers
   for d+1 different y span all polynomials of degree d. The largest relative error. */
static double polynomial_error(const kw_bspline *s)
{
    double c[PARTITION_N], error = 0, b = s->t[s->n];

    for (int a = 0; a <= s->d; a++) {
        double y = b + 1 + a; /* behind the domain: all products are positive */

        for (int j = 0; j < s->n; j++) {
            c[j] = 1;
            for (int i = 1; i <= s->d; i++)
                c[j] *= y - s->t[j + i];
        }
        for (int q = 0; q <= SAMPLES; q++) {
            double x = s->t[s->d] + (b - s->t[s->d]) * q / SAMPLES, value, power = 1;

            x = x < b ? x : b;
            kw_curve_point(s, 1, c, x, &value);
            for (int i = 0; i < s->d; i++)
                power *= y - x;
            error = fmax(error, fabs(value / power - 1));
        }
    }
    return error;
}

/* The indicator of the cell [1,2) of [0,3] as a spline of degree 1 with every interior knot
   double, so that the space is P: the jump at 1. */
static double jump_of_indicator(void)
{
    const double tau[] = {0, 1, 2, 3}, c[] = {0, 0, 1, 1, 0, 0};
    const int mu[] = {2, 2};
    kw_bspline *s = kw_bspline_new_open(1, 3, tau, mu);
    double left[2], right;

    kw_bspline_derivatives_on(s, 1, 1, 0, left);
    kw_curve_point(s, 1, c, 1, &right);
    kw_bspline_free(s);
    return right - (left[0] * c[0] + left[1] * c[1]);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_reproduction");
    double difference = 0, polynomials = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(2, i);
        kw_bspline *s = partition_space(&p);

        difference = fmax(difference, difference_in_spans(s));
        polynomials = fmax(polynomials, polynomial_error(s));
        kw_bspline_free(s);
    }
    kw_claim_real(report, "bs.rem1.jump", jump_of_indicator());
    kw_claim_real(report, "bs.piece.degree", difference);
    kw_claim_real(report, "bs.def2.polynomials", polynomials);
    return kw_out_close(report);
}
