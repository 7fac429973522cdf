/* Growth -- what one more knot line costs, and how fast tensor-product dimensions grow.

   What to see: on a logarithmic scale the dimension under repeated halving tends to straight
   lines whose slopes are 1, 2 and 3 doublings a step: the price of a fine grid everywhere.

   Book: section 1.1, the limits of tensor products before Figure 7.
   Claims: tp.growth.*
   Chosen here: degree 2 in every direction, four cells to begin with; random spaces. */

#include "bspline.h" /* univariate spaces */
#include "claim.h"   /* what we found, for the ledger */
#include "insert.h"  /* one more knot line */
#include "out.h"     /* columns for gnuplot */
#include "rng.h"     /* random spaces */
#include "tensor.h"  /* their products */

enum { CASES = 200, DEGREE = 2, CELLS = 4, STEPS = 6 };

/* The product of D spaces of random degree 0 .. 4 and 1 .. 6 cells. */
static kw_tensor *random_product(kw_rng *r, int D)
{
    kw_bspline *s[KW_TENSOR_D] = {NULL};
    kw_tensor *g;

    for (int h = 0; h < D; h++) {
        int d = kw_rng_below(r, 5), cells = 1 + kw_rng_below(r, 6);

        s[h] = kw_bspline_new_open_uniform(d, cells, 0, cells);
    }
    g = kw_tensor_new(D, (const kw_bspline *const *)s);
    for (int h = 0; h < D; h++)
        kw_bspline_free(s[h]);
    return g;
}

/* By how much the dimension grows with one more knot in direction h. */
static int increment(const kw_tensor *g, int h)
{
    kw_bspline *finer = kw_insert_new_knot(g->s[h], 0.5);
    kw_tensor *more = kw_tensor_new_direction(g, h, finer);
    int grown = kw_tensor_dimension(more) - kw_tensor_dimension(g);

    kw_bspline_free(finer);
    kw_tensor_free(more);
    return grown;
}

/* Random cases in which the increment is not the product of the other dimensions, and those
   in which the new dimension is not that many times the old one. */
static void try_increments(int *increments_off, int *factors_off)
{
    kw_rng r = kw_rng_at(11, 0, 0, 0);

    for (int i = 0; i < CASES; i++) {
        int D = 1 + kw_rng_below(&r, KW_TENSOR_D), h = kw_rng_below(&r, D);
        kw_tensor *g = random_product(&r, D);
        int n = kw_tensor_dimension(g), others = n / g->s[h]->n, grown = increment(g, h);

        *increments_off += grown != others;
        *factors_off += n + grown != n * others;
        kw_tensor_free(g);
    }
}

/* The dimension in D directions after `steps` halvings. */
static int dimension(int D, int steps)
{
    kw_bspline *s = kw_bspline_new_open_uniform(DEGREE, CELLS, 0, 1);
    const kw_bspline *all[KW_TENSOR_D] = {s, s, s};
    kw_tensor *g = kw_tensor_new(D, all);
    int n;

    for (int i = 0; i < steps; i++) {
        kw_tensor *fine = kw_tensor_new_dyadic(g);

        kw_tensor_free(g);
        g = fine;
    }
    n = kw_tensor_dimension(g);
    kw_tensor_free(g);
    kw_bspline_free(s);
    return n;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_tensor_growth"),
           *report = kw_claim_new("ex_tensor_growth");
    int increments_off = 0, factors_off = 0;

    try_increments(&increments_off, &factors_off);
    kw_out_section(f, "dimensions", "step D1 D2 D3");
    for (int steps = 0; steps <= STEPS; steps++) {
        kw_out_number(f, steps);
        for (int D = 1; D <= KW_TENSOR_D; D++)
            kw_out_number(f, dimension(D, steps));
        kw_out_row(f);
    }

    kw_claim_count(report, "tp.growth.increment", increments_off);
    kw_claim_count(report, "tp.growth.times", factors_off);
    kw_claim_count(report, "tp.growth.D1", dimension(1, STEPS));
    kw_claim_count(report, "tp.growth.D2", dimension(2, STEPS));
    kw_claim_count(report, "tp.growth.D3", dimension(3, STEPS));
    return kw_out_close(f) | kw_out_close(report);
}
