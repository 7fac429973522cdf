/* Definitions 1 and 2 -- the dimension of a spline space, as a rank.

   What to see: the dimension found by elimination from the contact conditions always lies on
   the line L(d+1) - sum of (d - mu_i + 1) = k + m; the form printed between the two, with
   (m+1) for (d+1), lies off it nearly everywhere.

   Book: section 1.1, Definitions 1 and 2, Remark 2, (5), (6) and the line on the dimension.
   Claims: bs.def1.*, bs.def2.*, bs.dim.*, bs.basis.*, bs.knots.*, bs.rem2.auxiliary
   Chosen here: 150 random cases, degree 0 .. 4, 1 .. 5 cells, every multiplicity up to k. */

#include "bspline.h"   /* the space that the B-splines span */
#include "claim.h"     /* what we found, for the ledger */
#include "dense.h"     /* ranks */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random partitions */
#include <math.h>
#include <string.h>

enum {
    CASES = 150,
    MOST = PARTITION_L * (PARTITION_D + 1), /* dimension of P, at most */
    EXAMPLE_POWERS = 8
};

/* The r-th derivative of u^q at u. */
static double power(int q, int r, double u)
{
    double value = 1;

    for (int i = 0; i < r; i++)
        value *= q - i;
    for (int i = 0; i < q - r; i++)
        value *= u;
    return q < r ? 0 : value;
}

/* The conditions of (6) on an element of P, which has the coefficients of
   (x - tau_i)^q on cell i: row by row, f^(r)(tau_i-) - f^(r)(tau_i+) = 0. */
static int contact_conditions(const partition *p, double *A)
{
    int k = p->d + 1, columns = p->L * k, rows = 0;

    for (int i = 1; i < p->L; i++)
        for (int r = 0; r <= p->d - p->mu[i - 1]; r++, rows++)
            for (int q = 0; q < k; q++) {
                A[rows * columns + (i - 1) * k + q] =
                    power(q, r, p->tau[i] - p->tau[i - 1]);
                A[rows * columns + i * k + q] = -power(q, r, 0);
            }
    return rows;
}

/* The rank of the conditions; *slack grows to the largest number taken for zero, over the
   smallest pivot. */
static int contact_rank(const partition *p, double *slack)
{
    double A[MOST * MOST] = {0}, gap;
    int rows = contact_conditions(p, A);
    int rank = kw_dense_rank(rows, p->L * (p->d + 1), A, &gap);

    *slack = fmax(*slack, 1 / gap);
    return rank;
}

/* The rank of the values of all functions of s at d+1 points inside each span. */
static int rank_of_functions(const kw_bspline *s, double *slack)
{
    double A[MOST * MOST], gap;
    int rows = 0;

    for (int i = s->d; i < s->n; i++)
        for (int q = 0; s->t[i] < s->t[i + 1] && q <= s->d; q++, rows++) {
            double x = s->t[i] + (s->t[i + 1] - s->t[i]) * (q + 0.5) / (s->d + 1);

            for (int j = 0; j < s->n; j++)
                A[rows * s->n + j] = kw_bspline_one(s, j, 0, x);
        }
    gap = 1;
    rows = kw_dense_rank(rows, s->n, A, &gap);
    *slack = fmax(*slack, 1 / gap);
    return rows;
}

/* The rank of P itself: its monomials, cell by cell, at d+1 points of each cell. */
static int rank_of_pieces(const partition *p, double *slack)
{
    double A[MOST * MOST] = {0}, gap;
    int k = p->d + 1, columns = p->L * k, rank;

    for (int i = 0; i < p->L; i++)
        for (int a = 0; a < k; a++)
            for (int q = 0; q < k; q++)
                A[(i * k + a) * columns + i * k + q] = power(q, 0, (a + 0.5) / k);
    rank = kw_dense_rank(columns, columns, A, &gap);
    *slack = fmax(*slack, 1 / gap);
    return rank;
}

/* The same space with random auxiliary knots, in order. */
static kw_bspline *with_auxiliary_knots(const kw_bspline *s, uint64_t i)
{
    double t[2 * (MOST + PARTITION_D + 1)];
    kw_rng r = kw_rng_at(4, 0, i, 0);

    memcpy(t, s->t, (size_t)(s->n + s->d + 1) * sizeof *t);
    for (int j = 1; j <= s->d; j++) {
        t[s->d - j] = t[s->d - j + 1] - kw_rng_below(&r, 3);
        t[s->n + j] = t[s->n + j - 1] + kw_rng_below(&r, 3);
    }
    return kw_bspline_new(s->d, s->n, t);
}

/* In how many of the cells gamma_i does x lie? (all half open, the last one closed) */
static int cells_with(const partition *p, double x)
{
    int count = 0;

    for (int i = 0; i < p->L; i++)
        count +=
            p->tau[i] <= x && (x < p->tau[i + 1] || (i == p->L - 1 && x == p->tau[p->L]));
    return count;
}

/* The powers x^0 .. x^7 meet every contact condition at the knot 1 of [0,2], whatever the
   degree of the space: (6) as printed does not ask f to be piecewise of degree d. */
static int rank_of_powers(double *slack)
{
    double A[EXAMPLE_POWERS * EXAMPLE_POWERS], gap;
    int rank;

    for (int a = 0; a < EXAMPLE_POWERS; a++)
        for (int q = 0; q < EXAMPLE_POWERS; q++)
            A[a * EXAMPLE_POWERS + q] = power(q, 0, 2.0 * a / (EXAMPLE_POWERS - 1));
    rank = kw_dense_rank(EXAMPLE_POWERS, EXAMPLE_POWERS, A, &gap);
    *slack = fmax(*slack, 1 / gap);
    return rank;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_dimension"), *report = kw_claim_new("ex_dimension");
    const partition example = {.d = 2, .L = 2, .mu = {1}, .m = 1, .tau = {0, 1, 2}};
    double slack = 0;
    int cells = 0, pieces = 0, sum_form = 0, m_form = 0, km_form = 0;
    int knots = 0, basis = 0, auxiliary = 0, nested = 0;

    kw_out_section(f, "cases", "dimension k+m printed");
    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(1, i);
        kw_bspline *s = partition_space(&p), *other = with_auxiliary_knots(s, i);
        int k = p.d + 1, dim = p.L * k - contact_rank(&p, &slack), sum = p.L * k;

        for (int j = 0; j < p.L - 1; j++)
            sum -= p.d - p.mu[j] + 1;
        for (int q = 0; q <= 60; q++) /* hits every breakpoint */
            cells += cells_with(&p, p.tau[0] + (p.tau[p.L] - p.tau[0]) * q / 60) != 1;
        for (int j = 0; j <= p.L; j++)
            cells += cells_with(&p, p.tau[j]) != 1;
        pieces += rank_of_pieces(&p, &slack) != p.L * k;
        sum_form += sum != dim;
        m_form += p.m + 1 + p.m != dim;
        km_form += k + p.m != dim;
        nested += dim < k || dim > p.L * k;
        knots += s->n != k + p.m || kw_bspline_multiplicity(s, p.tau[0]) != k ||
                 kw_bspline_multiplicity(s, p.tau[p.L]) != k;
        basis += rank_of_functions(s, &slack) != dim;
        auxiliary += rank_of_functions(other, &slack) != dim;

        kw_out_number(f, dim);
        kw_out_number(f, k + p.m);
        kw_out_number(f, p.m + 1 + p.m);
        kw_out_row(f);
        kw_bspline_free(s);
        kw_bspline_free(other);
    }

    kw_claim_count(report, "bs.cells", cells);
    kw_claim_count(report, "bs.def1.dim", pieces);
    kw_claim_count(report, "bs.dim.sum", sum_form);
    kw_claim_count(report, "bs.dim.m+1", m_form);
    kw_claim_count(report, "bs.dim.k+m", km_form);
    kw_claim_count(report, "bs.dim.between", nested);
    kw_claim_count(report, "bs.dim.example", 2 * 3 - contact_rank(&example, &slack));
    kw_claim_count(report, "bs.def2.literal", rank_of_powers(&slack));
    kw_claim_count(report, "bs.knots.count", knots);
    kw_claim_count(report, "bs.basis.rank", basis);
    kw_claim_count(report, "bs.rem2.auxiliary", auxiliary);
    kw_claim_real(report, "bs.dim.slack", slack);
    return kw_out_close(f) | kw_out_close(report);
}
