/* Figure 6 -- A bivariate tensor-product basis from two univariate ones.

   What to see: (a) the two univariate bases; (b) two of their products, each a bump on k_1 x k_2
   cells; (c) the grid of knot lines; (d) all products at once: at every point the largest.

   Book: section 1.1, (10) and the text around Figure 6.
   Claims: tp.fig6.*, tp.eq10.*, tp.grid.cells
   Chosen here: five interior knots in both directions, which gives the printed
   number of functions; the caption's five and four do not (ERRATA.md, ER-10). */

#include "../univariate.h" /* how a univariate basis is written */
#include "bspline.h"       /* the univariate bases */
#include "claim.h"         /* what we found, for the ledger */
#include "out.h"           /* columns for gnuplot */
#include "picture.h"       /* knot lines, the largest function */
#include "tensor.h"        /* their products */

enum {
    D1 = 3,
    D2 = 2,     /* the degrees */
    KNOTS1 = 5, /* interior knots in either direction, as drawn */
    KNOTS2 = 5,
    CAPTION2 = 4, /* and in the second as the caption has it */
    CURVE = 120,  /* points of a curve */
    SURFACE = 36, /* cells of a surface in either direction: six a knot span */
    BUMP = 12     /* the same for one function, on its support */
};

static kw_tensor *new_product(int interior1, int interior2)
{
    kw_bspline *s[2] = {kw_bspline_new_open_uniform(D1, interior1 + 1, 0, 1),
                        kw_bspline_new_open_uniform(D2, interior2 + 1, 0, 1)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);

    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return g;
}

/* The function with multi-index j on its support. */
static void write_function(kw_out *f, const char *name, const kw_tensor *g, const int *j)
{
    kw_out_section(f, name, "x y value");
    for (int a = 0; a <= BUMP; a++) {
        for (int b = 0; b <= BUMP; b++) {
            const int at[2] = {a, b};
            double x[2];

            for (int h = 0; h < 2; h++) {
                const double *t = g->s[h]->t + j[h];

                x[h] = t[0] + (t[g->s[h]->d + 1] - t[0]) * at[h] / BUMP;
            }
            write_row3(f, x[0], x[1], kw_tensor_one(g, j, NULL, x));
        }
        kw_out_gap(f);
    }
}

/* How many multi-indices (10) has with j_h from 1, as printed, and what their functions add
   up to at the corner where they all begin. */
static void report_index_set(kw_out *report, const kw_tensor *g)
{
    const double corner[2] = {0, 0};
    int count = 0;
    double sum = 0;

    for (int flat = 0; flat < kw_tensor_dimension(g); flat++) {
        int j[2];

        kw_tensor_multi(g, flat, j);
        if (j[0] >= 1 && j[1] >= 1) {
            count++;
            sum += kw_tensor_one(g, j, NULL, corner);
        }
    }
    kw_claim_count(report, "tp.eq10.from-one", count);
    kw_claim_real(report, "tp.eq10.from-one.corner", sum);
}

/* Is there a function with the multi-index j? */
static int exists(const kw_tensor *g, const int *j)
{
    return j[0] < g->s[0]->n && j[1] < g->s[1]->n;
}

int main(void)
{
    static const int upper[2] = {4, 1}, lower[2] = {3, 5}; /* the two printed products */
    kw_out *f = kw_out_data("fig06"), *report = kw_claim_new("fig06");
    kw_tensor *g = new_product(KNOTS1, KNOTS2), *caption = new_product(KNOTS1, CAPTION2);

    write_univariate(f, "degree 3", g->s[0], CURVE);
    write_univariate(f, "degree 2", g->s[1], CURVE);
    write_function(f, "upper", g, upper);
    write_function(f, "lower", g, lower);
    write_knot_lines(f, "grid", g);
    write_largest(f, "largest", g, SURFACE);

    kw_claim_count(report, "tp.fig6.functions", kw_tensor_dimension(g));
    kw_claim_count(report, "tp.fig6.caption", kw_tensor_dimension(caption));
    kw_claim_true(report, "tp.fig6.named", exists(g, upper) && exists(g, lower));
    kw_claim_true(report, "tp.fig6.named.caption",
                  exists(caption, upper) && exists(caption, lower));
    kw_claim_count(report, "tp.grid.cells", count_cells(g));
    report_index_set(report, g);

    kw_tensor_free(g);
    kw_tensor_free(caption);
    return kw_out_close(f) | kw_out_close(report);
}
