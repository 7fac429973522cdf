/* Knot vectors -- partitions, cells, extended knots, and the basis on them.

   What to see: nothing to look at. Every point lies in one cell; open knots count as the book
   says; and whatever the auxiliary knots, the B-splines are a basis of V on [a,b].

   Book: section 1.1, the text before Definition 2, Remark 2, the text behind Definition 3.
   Claims: bs.cells, bs.knots.count, bs.knots.multiset, bs.basis.*, bs.rem2.auxiliary
   Chosen here: 150 random partitions, degree 0 .. 4, 1 .. 5 cells. */

#include "bspline.h"   /* spans and functions */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* reports are files */
#include "partition.h" /* random partitions */
#include "ranks.h"     /* ranks by elimination */

enum { CASES = 150, SAMPLES = 60 };

/* Does x lie in the cell gamma_i? (all half open, the last one closed) */
static int in_cell(const partition *p, int i, double x)
{
    return p->tau[i] <= x && (x < p->tau[i + 1] || (i == p->L - 1 && x == p->tau[p->L]));
}

/* Whether x lies in one cell only, and in the one that begins where its span does. */
static int cell_is_right(const partition *p, const kw_bspline *s, double x)
{
    int count = 0, cell = 0;

    for (int i = 0; i < p->L; i++)
        if (in_cell(p, i, x)) {
            count++;
            cell = i;
        }
    return count == 1 && s->t[kw_bspline_span(s, x)] == p->tau[cell];
}

static int wrong_cells(const partition *p, const kw_bspline *s)
{
    int wrong = 0;

    for (int q = 0; q <= SAMPLES; q++)
        wrong +=
            !cell_is_right(p, s, p->tau[0] + (p->tau[p->L] - p->tau[0]) * q / SAMPLES);
    for (int i = 0; i <= p->L; i++)
        wrong += !cell_is_right(p, s, p->tau[i]);
    return wrong;
}

/* The rank of the values of all functions of s at d+1 points inside each span. */
static int rank_of_functions(const kw_bspline *s, double *slack)
{
    double A[PARTITION_N * PARTITION_N];
    int rows = 0;

    for (int i = s->d; i < s->n; i++)
        for (int q = 0; s->t[i] < s->t[i + 1] && q <= s->d; q++, rows++) {
            double x = s->t[i] + (s->t[i + 1] - s->t[i]) * (q + 0.5) / (s->d + 1);

            for (int j = 0; j < s->n; j++)
                A[rows * s->n + j] = kw_bspline_one(s, j, 0, x);
        }
    return rank_of(rows, s->n, A, slack);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_knots");
    double slack = 0;
    int cells = 0, knots = 0, multiset = 0, basis = 0, auxiliary = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(1, i);
        kw_bspline *s = partition_space(&p), *other = with_auxiliary_knots(s, i);
        int k = p.d + 1;

        cells += wrong_cells(&p, s);
        knots += s->n != k + p.m || kw_bspline_multiplicity(s, p.tau[0]) != k ||
                 kw_bspline_multiplicity(s, p.tau[p.L]) != k;
        multiset += s->n - p.d + 1 != p.L + 1; /* t_{k-1} .. t_{n+1}, tau_0 .. tau_L */
        basis += rank_of_functions(s, &slack) != k + p.m;
        auxiliary += rank_of_functions(other, &slack) != k + p.m;
        kw_bspline_free(s);
        kw_bspline_free(other);
    }
    kw_claim_count(report, "bs.cells", cells);
    kw_claim_count(report, "bs.knots.count", knots);
    kw_claim_count(report, "bs.knots.multiset", multiset);
    kw_claim_count(report, "bs.basis.rank", basis);
    kw_claim_count(report, "bs.rem2.auxiliary", auxiliary);
    kw_claim_real(report, "bs.basis.slack", slack);
    return kw_out_close(report);
}
