/* Regularity -- how smooth B-splines are at a knot, from one-sided derivatives.

   What to see: at a knot of multiplicity mu the space has d - mu continuous derivatives, but a
   single function may have more: what counts for it is how often the knot is among its own
   k+1 knots.

   Book: section 1.1, Remark 1, Definition 2, and the text behind Definition 3.
   Claims: bs.regularity.*, bs.repeat.*, bs.rem1.jump, bs.piece.degree, bs.def2.polynomials
   Chosen here: 150 random open knot vectors; degree 2 and the knot 1 of [0,2] in the picture. */

#include "bspline.h"   /* derivatives from both sides */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* splines with given coefficients */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random knots */
#include <float.h>
#include <math.h>

enum { CASES = 150, K = PARTITION_D + 1, MOST_N = K + K * PARTITION_L, SAMPLES = 80 };

/* The largest jump taken for zero and the smallest taken for a jump. Between them lie many
   powers of ten, or the counts below mean nothing. */
typedef struct jumps {
    double zero, least;
} jumps;

/* Jumps of the r-th derivative below this are rounding: derivatives grow by at most 2d a
   step here (no cell is shorter than 1), and about 3d roundings go into each. */
static double rounding(int d, int r)
{
    double bound = 3 * (d + 1) * DBL_EPSILON;

    for (int i = 0; i < r; i++)
        bound *= 2 * d;
    return bound;
}

/* How many derivatives of beta_j, from the value on, are continuous at the breakpoint
   between spans `left' and `right', minus one: the regularity, -1 for a jump. */
static int regularity(const kw_bspline *s, int j, int left, int right, jumps *seen)
{
    double before[K * K], behind[K * K];
    int d = s->d, k = d + 1, first_left = left - d, first_right = right - d;

    kw_bspline_derivatives_on(s, left, s->t[right], d, before);
    kw_bspline_derivatives_on(s, right, s->t[right], d, behind);
    for (int r = 0; r <= d; r++) {
        double a = j >= first_left && j <= left ? before[r * k + j - first_left] : 0;
        double b = j >= first_right && j <= right ? behind[r * k + j - first_right] : 0;
        double jump = fabs(a - b);

        if (jump > rounding(d, r)) {
            seen->least = fmin(seen->least, jump);
            return r - 1;
        }
        seen->zero = fmax(seen->zero, jump);
    }
    return d;
}

/* How often x is among the k+1 knots of beta_j. */
static int own_multiplicity(const kw_bspline *s, int j, double x)
{
    int count = 0;

    for (int i = j; i <= j + s->d + 1; i++)
        count += s->t[i] == x;
    return count;
}

typedef struct counts {
    int own, printed, space, global;
} counts;

static void count_regularity(const partition *p, counts *off, jumps *seen)
{
    kw_bspline *s = partition_space(p);
    int lowest = p->d, highest_mu = 0;

    for (int left = p->d, c = 1; c < p->L; c++) {
        int mu = p->mu[c - 1], right = left + mu, least = p->d;
        double x = p->tau[c];

        for (int j = 0; j < s->n; j++) {
            int own = own_multiplicity(s, j, x);
            int r = regularity(s, j, left, right, seen);

            off->own += own > 0 && r != p->d - own;
            off->printed += own > 0 && r != p->d - mu;
            least = r < least ? r : least;
        }
        off->space += least != p->d - mu;
        lowest = least < lowest ? least : lowest;
        highest_mu = mu > highest_mu ? mu : highest_mu;
        left = right;
    }
    off->global += p->L > 1 && lowest != p->d - highest_mu;
    kw_bspline_free(s);
}

/* The (d+1)-th difference over d+2 points inside a span, which is zero for a polynomial of
   degree d; the largest over the functions. */
static double difference_in_spans(const kw_bspline *s)
{
    double most = 0;

    for (int i = s->d; i < s->n; i++)
        for (int j = 0; s->t[i] < s->t[i + 1] && j < s->n; j++) {
            double sum = 0, binomial = 1, h = s->t[i + 1] - s->t[i];

            for (int q = 0; q <= s->d + 1; q++) {
                double x = s->t[i] + h * (q + 0.5) / (s->d + 2);

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
    double c[MOST_N], error = 0, b = s->t[s->n];

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

/* The lowest regularity at the interior knot of [0,2] with multiplicity mu. */
static int lowest_at_middle(int d, int mu, jumps *seen)
{
    const double tau[] = {0, 1, 2};
    kw_bspline *s = kw_bspline_new_open(d, 2, tau, &mu);
    int lowest = d;

    for (int j = 0; j < s->n; j++) {
        int r = regularity(s, j, d, d + mu, seen);

        lowest = r < lowest ? r : lowest;
    }
    kw_bspline_free(s);
    return lowest;
}

/* Values and first derivatives of the quadratic functions with the knot 1 mu times, cell by
   cell, so that a jump stays a gap. */
static void write_functions(kw_out *f, const char *name, int mu)
{
    const double tau[] = {0, 1, 2};
    kw_bspline *s = kw_bspline_new_open(2, 2, tau, &mu);

    kw_out_section(f, name, "x value derivative function");
    for (int j = 0; j < s->n; j++)
        for (int cell = 0; cell < 2; cell++) {
            int span = cell == 0 ? 2 : 2 + mu;

            if (j < span - 2 || j > span)
                continue;
            for (int q = 0; q <= SAMPLES; q++) {
                double value[2 * 3], x = cell + (double)q / SAMPLES;

                kw_bspline_derivatives_on(s, span, x, 1, value);
                kw_out_number(f, x);
                kw_out_number(f, value[j - span + 2]);
                kw_out_number(f, value[3 + j - span + 2]);
                kw_out_number(f, j);
                kw_out_row(f);
            }
            kw_out_gap(f);
        }
    kw_bspline_free(s);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_regularity"), *report = kw_claim_new("ex_regularity");
    const double double_knot[] = {0, 0, 0, 1, 1, 2, 2, 2};
    kw_bspline *example = kw_bspline_new(2, 5, double_knot);
    counts off = {0, 0, 0, 0};
    jumps seen = {0, 1};
    double difference = 0, polynomials = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(2, i);
        kw_bspline *s = partition_space(&p);

        count_regularity(&p, &off, &seen);
        difference = fmax(difference, difference_in_spans(s));
        polynomials = fmax(polynomials, polynomial_error(s));
        kw_bspline_free(s);
    }
    write_functions(f, "simple", 1);
    write_functions(f, "double", 2);
    write_functions(f, "triple", 3);

    kw_claim_count(report, "bs.regularity.own", off.own);
    kw_claim_count(report, "bs.regularity.printed", off.printed);
    kw_claim_count(report, "bs.regularity.space", off.space);
    kw_claim_count(report, "bs.regularity.global", off.global);
    kw_claim_count(report, "bs.regularity.example", regularity(example, 0, 2, 4, &seen));
    kw_claim_count(report, "bs.repeat.hat", lowest_at_middle(1, 2, &seen));
    kw_claim_count(report, "bs.repeat.quadratic", lowest_at_middle(2, 2, &seen));
    kw_claim_real(report, "bs.regularity.zero", seen.zero);
    kw_claim_real(report, "bs.regularity.least", seen.least);
    kw_claim_real(report, "bs.rem1.jump", jump_of_indicator());
    kw_claim_real(report, "bs.piece.degree", difference);
    kw_claim_real(report, "bs.def2.polynomials", polynomials);

    kw_bspline_free(example);
    return kw_out_close(f) | kw_out_close(report);
}
