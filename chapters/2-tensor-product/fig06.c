/* Figure 6 -- A bivariate tensor-product basis from two univariate ones.

   What to see: (a) the two univariate bases; (b) two of their products, each a bump on k_1 x k_2
   cells; (c) the grid of knot lines; (d) all products at once: at every point the largest.

   Book: section 1.1, (10) and the text around Figure 6.
   Claims: tp.fig6.*, tp.eq10.*, tp.basis.*
   Chosen here: five interior knots in both directions, which gives the printed
   number of functions; the caption's five and four do not (ERRATA.md, ER-10). */

#include "bspline.h" /* the univariate bases */
#include "claim.h"   /* what we found, for the ledger */
#include "dense.h"   /* ranks, and the condition of the basis */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "picture.h" /* knot lines, the largest function */
#include "tensor.h"  /* their products */
#include <math.h>
#include <stdlib.h>

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

static void write_univariate(kw_out *f, const char *name, const kw_bspline *s)
{
    kw_out_section(f, name, "x value function");
    for (int j = 0; j < s->n; j++) {
        for (int i = 0; i <= CURVE; i++) {
            double x = (double)i / CURVE;

            if (x < s->t[j] || x > s->t[j + s->d + 1])
                continue; /* outside the support */
            kw_out_number(f, x);
            kw_out_number(f, kw_bspline_one(s, j, 0, x));
            kw_out_number(f, j);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
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

/* Sum, sign and number of the functions over a grid of points; the points lie inside cells,
   at knots and at all four ends. */
static void report_basis(kw_out *report, const kw_tensor *g)
{
    double least = 0, unity = 0;
    int most = 0, n = kw_tensor_dimension(g);

    for (int a = 0; a <= SURFACE; a++)
        for (int b = 0; b <= SURFACE; b++) {
            const double x[2] = {(double)a / SURFACE, (double)b / SURFACE};
            double sum = 0;
            int count = 0;

            for (int flat = 0; flat < n; flat++) {
                int j[2];
                double value;

                kw_tensor_multi(g, flat, j);
                value = kw_tensor_one(g, j, NULL, x);
                least = fmin(least, value);
                sum += value;
                count += value > 0;
            }
            unity = fmax(unity, fabs(sum - 1));
            most = count > most ? count : most;
        }
    kw_claim_real(report, "tp.basis.nonnegative", least);
    kw_claim_real(report, "tp.basis.unity", unity);
    kw_claim_count(report, "tp.basis.local", most);
}

/* The matrix of all functions at all pairs of Greville points. */
static void collocation(const kw_tensor *g, double *A)
{
    int n = kw_tensor_dimension(g);

    for (int row = 0; row < n; row++) {
        int at[2], j[2];

        kw_tensor_multi(g, row, at);
        const double x[2] = {kw_bspline_greville(g->s[0], at[0]),
                             kw_bspline_greville(g->s[1], at[1])};
        for (int column = 0; column < n; column++) {
            kw_tensor_multi(g, column, j);
            A[row * n + column] = kw_tensor_one(g, j, NULL, x);
        }
    }
}

/* The functions are independent, and well so: a spline that is at most one at the Greville
   points has coefficients of at most the norm of the inverse matrix. */
static void report_independence(kw_out *report, const kw_tensor *g)
{
    int n = kw_tensor_dimension(g);
    size_t size = (size_t)n * (size_t)n;
    double *A = kw_need_memory(size, sizeof *A), *inverse, gap, norm = 0;

    collocation(g, A);
    kw_claim_count(report, "tp.basis.rank", kw_dense_rank(n, n, A, &gap));
    collocation(g, A);
    inverse = kw_need_memory(size, sizeof *inverse);
    for (int i = 0; i < n; i++)
        inverse[i * n + i] = 1;
    KW_NEED(kw_dense_solve(n, n, A, inverse) == 0, "no inverse of %d functions", n);
    for (int i = 0; i < n; i++) {
        double sum = 0;

        for (int j = 0; j < n; j++)
            sum += fabs(inverse[i * n + j]);
        norm = fmax(norm, sum);
    }
    kw_claim_real(report, "tp.basis.condition", norm);
    free(A);
    free(inverse);
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

int main(void)
{
    static const int upper[2] = {4, 1}, lower[2] = {3, 5}; /* the two printed products */
    kw_out *f = kw_out_data("fig06"), *report = kw_claim_new("fig06");
    kw_tensor *g = new_product(KNOTS1, KNOTS2), *caption = new_product(KNOTS1, CAPTION2);

    write_univariate(f, "degree 3", g->s[0]);
    write_univariate(f, "degree 2", g->s[1]);
    write_function(f, "upper", g, upper);
    write_function(f, "lower", g, lower);
    write_knot_lines(f, "grid", g);
    write_largest(f, "largest", g, SURFACE);

    kw_claim_count(report, "tp.fig6.functions", kw_tensor_dimension(g));
    kw_claim_count(report, "tp.fig6.caption", kw_tensor_dimension(caption));
    report_index_set(report, g);
    report_basis(report, g);
    report_independence(report, g);

    kw_tensor_free(g);
    kw_tensor_free(caption);
    return kw_out_close(f) | kw_out_close(report);
}
