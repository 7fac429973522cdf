/* Regularity -- how smooth B-splines are at a knot, from one-sided derivatives.

   What to see: at a knot of multiplicity mu the space has d - mu continuous derivatives, but a
   single function may have more: what counts for it is how often the knot is among its own
   k+1 knots.

   Book: section 1.1, Definition 2, and the text behind Definition 3.
   Claims: bs.regularity.*, bs.repeat.*
   Chosen here: 150 random open knot vectors; degree 2 and the knot 1 of [0,2] in the picture. */

#include "bspline.h"   /* derivatives from both sides */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random knots */
#include <float.h>
#include <math.h>

enum { CASES = 150, K = PARTITION_D + 1, SAMPLES = 80 };

/* The largest jump taken for zero and the smallest taken for a jump. Between them lie many
   powers of ten, or the counts below mean nothing. */
typedef struct jumps {
    double zero, least;
} jumps;

/* Jumps of the r-th derivative below this are rounding: each step of differentiation grows
   the terms by at most 2d here (no cell is shorter than 1), either side has 5d roundings of
   half an epsilon. */
static double rounding(int d, int r)
{
    double bound = 5 * d * DBL_EPSILON;

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
    jumps seen = {0, INFINITY};

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(2, i);

        count_regularity(&p, &off, &seen);
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

    kw_bspline_free(example);
    return kw_out_close(f) | kw_out_close(report);
}
