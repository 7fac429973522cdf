/* Definitions 1 and 2 -- Pi_d in V in P, by ranks.

   What to see: nothing to look at. The monomials cell by cell have rank L(d+1); adding the
   polynomials to V, or V to P, adds nothing to the rank; V is Pi_d on a single cell, and P if
   every knot appears k times.

   Book: section 1.1, Definitions 1 and 2, (5), and the inclusions behind (6).
   Claims: bs.def1.dim, bs.incl.*
   Chosen here: 150 random cases, degree 0 .. 4, 1 .. 5 cells, every multiplicity up to k. */

#include "bspline.h"   /* the space that the B-splines span */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* reports are files */
#include "partition.h" /* random partitions */
#include "ranks.h"     /* ranks by elimination */

enum {
    CASES = 150,
    K = PARTITION_D + 1,
    POINTS = (K + 1) * PARTITION_L, /* of all cells */
    ROWS = 2 * PARTITION_N          /* functions of P and V, at most */
};

/* The values of functions, one a row, at d+2 points of each cell, one more than a polynomial of
   degree d has coefficients. */
typedef struct values {
    int rows, columns;
    double A[ROWS * POINTS], x[POINTS];
} values;

static values no_functions(const partition *p)
{
    values v = {.rows = 0, .columns = p->L * (p->d + 2)};

    for (int a = 0; a < v.columns; a++) {
        int cell = a / (p->d + 2);
        double share = (a % (p->d + 2) + 0.5) / (p->d + 2);

        v.x[a] = p->tau[cell] + (p->tau[cell + 1] - p->tau[cell]) * share;
    }
    return v;
}

/* The powers of x from low to high, x counted from the middle of [low,high] in units of half
   its length, and zero outside: with the whole interval a basis of Pi_d. */
static void add_monomials(values *v, const partition *p, double low, double high)
{
    double middle = (p->tau[0] + p->tau[p->L]) / 2, half = p->tau[p->L] - middle;

    for (int q = 0; q <= p->d; q++, v->rows++)
        for (int a = 0; a < v->columns; a++)
            v->A[v->rows * v->columns + a] = low <= v->x[a] && v->x[a] < high
                                                 ? power(q, 0, (v->x[a] - middle) / half)
                                                 : 0;
}

/* A basis of P: the monomials cell by cell. */
static void add_pieces(values *v, const partition *p)
{
    for (int i = 0; i < p->L; i++)
        add_monomials(v, p, p->tau[i], p->tau[i + 1]);
}

/* The B-splines. */
static void add_splines(values *v, const partition *p)
{
    kw_bspline *s = partition_space(p);

    for (int j = 0; j < s->n; j++, v->rows++)
        for (int a = 0; a < v->columns; a++)
            v->A[v->rows * v->columns + a] = kw_bspline_one(s, j, 0, v->x[a]);
    kw_bspline_free(s);
}

/* The ranks of P, of V, of V and Pi_d together, and of P and V together. */
typedef struct ranks {
    int P, V, V_and_Pi, P_and_V;
} ranks;

static ranks ranks_of(const partition *p, double *slack)
{
    values of_P = no_functions(p), of_V = of_P, with_Pi = of_P, both = of_P;

    add_pieces(&of_P, p);
    add_splines(&of_V, p);
    add_splines(&with_Pi, p);
    add_monomials(&with_Pi, p, p->tau[0], p->tau[p->L]);
    add_pieces(&both, p);
    add_splines(&both, p);
    return (ranks){rank_of(of_P.rows, of_P.columns, of_P.A, slack),
                   rank_of(of_V.rows, of_V.columns, of_V.A, slack),
                   rank_of(with_Pi.rows, with_Pi.columns, with_Pi.A, slack),
                   rank_of(both.rows, both.columns, both.A, slack)};
}

/* Partitions, of all degrees and numbers of cells with all multiplicities k, in which V is not
   P; and of one cell, in which V is not Pi_d. */
static void count_extremes(int *not_P, int *not_Pi, double *slack)
{
    *not_P = *not_Pi = 0;
    for (int d = 0; d <= PARTITION_D; d++)
        for (int L = 1; L <= PARTITION_L; L++) {
            partition p = {.d = d, .L = L, .m = (L - 1) * (d + 1)};
            ranks r;

            for (int i = 0; i <= L; i++)
                p.tau[i] = i;
            for (int i = 1; i < L; i++)
                p.mu[i - 1] = d + 1;
            r = ranks_of(&p, slack);
            *not_P += r.V != r.P || r.P_and_V != r.P;
            *not_Pi += L == 1 && (r.V != d + 1 || r.V_and_Pi != d + 1);
        }
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_inclusions");
    double slack = 0;
    int pieces = 0, above = 0, below = 0, not_P, not_Pi;

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(1, i);
        ranks r = ranks_of(&p, &slack);

        pieces += r.P != p.L * (p.d + 1);
        below += r.V_and_Pi != r.V;
        above += r.P_and_V != r.P;
    }
    count_extremes(&not_P, &not_Pi, &slack);

    kw_claim_count(report, "bs.def1.dim", pieces);
    kw_claim_count(report, "bs.incl.polynomials", below);
    kw_claim_count(report, "bs.incl.pieces", above);
    kw_claim_count(report, "bs.incl.one-cell", not_Pi);
    kw_claim_count(report, "bs.incl.full-knots", not_P);
    kw_claim_real(report, "bs.incl.slack", slack);
    return kw_out_close(report);
}
