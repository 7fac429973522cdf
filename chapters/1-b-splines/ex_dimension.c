/* Definitions 1 and 2 -- the dimension of a spline space, as a rank.

   What to see: the dimension found by elimination from the contact conditions always lies on
   the line L(d+1) - sum of (d - mu_i + 1) = k + m; the form printed between the two, with
   (m+1) for (d+1), lies off it nearly everywhere.

   Book: section 1.1, Definition 2, (6) and the line on the dimension.
   Claims: bs.def2.literal, bs.def2.both, bs.dim.*
   Chosen here: 150 random cases, degree 0 .. 4, 1 .. 5 cells, every multiplicity up to k. */

#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random partitions */
#include "ranks.h"     /* ranks by elimination */

enum { CASES = 150 };

/* --- by the contact conditions --- */

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

/* dim P less the rank of the conditions. */
static int dimension(const partition *p, double *slack)
{
    double A[PARTITION_N * PARTITION_N] = {0};
    int columns = p->L * (p->d + 1), rows = contact_conditions(p, A);

    return columns - rank_of(rows, columns, A, slack);
}

/* --- (6) as printed --- */

/* Candidates on [0,2] with the knot 1: x^0 .. x^7, and (x-1)_+^0 .. (x-1)_+^2. */
enum { POWERS = 8, CANDIDATES = POWERS + 3, DEGREE = 2 };

/* The r-th derivative of candidate c at x, from the piece that holds left or right of 1. */
static double candidate(int c, int r, double x, int right)
{
    if (c < POWERS)
        return power(c, r, x);
    return right ? power(c - POWERS, r, x - 1) : 0;
}

/* The rank of those candidates that meet (6) for d = 2, mu = 1: contact of order 0 and 1 at 1.
   With `inside' only of those that are of degree 2 on each cell, as Definition 1 wants. */
static int rank_of_contact(int inside, double *slack)
{
    double A[CANDIDATES * 2 * CANDIDATES];
    int rows = 0, columns = 2 * CANDIDATES;

    for (int c = 0; c < CANDIDATES; c++) {
        int meets = !inside || c <= DEGREE || c >= POWERS;

        for (int r = 0; r <= DEGREE - 1; r++)
            meets &= candidate(c, r, 1, 0) - candidate(c, r, 1, 1) == 0;
        if (!meets)
            continue;
        for (int a = 0; a < columns; a++) {
            double x = (a + 0.5) / CANDIDATES;

            A[rows * columns + a] = candidate(c, 0, x, x >= 1);
        }
        rows++;
    }
    return rank_of(rows, columns, A, slack);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_dimension"), *report = kw_claim_new("ex_dimension");
    const partition example = {.d = 2, .L = 2, .mu = {1}, .m = 1, .tau = {0, 1, 2}};
    const partition smallest = {.d = 1, .L = 1, .tau = {0, 1}};
    const partition one_knot = {.d = 0, .L = 2, .mu = {1}, .m = 1, .tau = {0, 1, 2}};
    double slack = 0;
    int sum_form = 0, m_form = 0, km_form = 0;

    kw_out_section(f, "cases", "dimension k+m printed");
    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(1, i);
        int k = p.d + 1, dim = dimension(&p, &slack), sum = p.L * k;

        for (int j = 0; j < p.L - 1; j++)
            sum -= p.d - p.mu[j] + 1;
        sum_form += sum != dim;
        m_form += p.m + 1 + p.m != dim;
        km_form += k + p.m != dim;

        kw_out_number(f, dim);
        kw_out_number(f, k + p.m);
        kw_out_number(f, p.m + 1 + p.m);
        kw_out_row(f);
    }

    kw_claim_count(report, "bs.dim.sum", sum_form);
    kw_claim_count(report, "bs.dim.m+1", m_form);
    kw_claim_count(report, "bs.dim.k+m", km_form);
    kw_claim_count(report, "bs.dim.example", dimension(&example, &slack));
    kw_claim_count(report, "bs.dim.smallest", dimension(&smallest, &slack));
    kw_claim_count(report, "bs.dim.smallest.knot", dimension(&one_knot, &slack));
    kw_claim_count(report, "bs.def2.literal", rank_of_contact(0, &slack));
    kw_claim_count(report, "bs.def2.both", rank_of_contact(1, &slack));
    kw_claim_real(report, "bs.dim.slack", slack);
    return kw_out_close(f) | kw_out_close(report);
}
