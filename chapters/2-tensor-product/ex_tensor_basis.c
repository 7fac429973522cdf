/* Tensor-product bases -- what they inherit from their factors.

   What to see: nothing to look at. The products are non-negative, add up to one in D = 2 and
   3, are local, are polynomials of the multi-degree on each cell, and are a basis, with a
   small condition number at the Greville points.

   Book: section 1.1, the text between (10) and Figure 6, and behind Remark 6.
   Claims: tp.basis.*
   Chosen here: the basis of Figure 6, degrees 3 and 2 on 6 x 6 cells; degrees 1, 2, 3 on
   3 x 2 x 2 cells for D = 3. */

#include "bspline.h" /* the factors */
#include "claim.h"   /* what we found, for the ledger */
#include "dense.h"   /* ranks, and the condition of the basis */
#include "need.h"    /* memory */
#include "out.h"     /* reports are files */
#include "tensor.h"  /* their products */
#include <math.h>
#include <stdlib.h>

enum { GRID = 36, GRID3 = 12, EIGHTHS = 8 };

/* What is seen over a grid of points inside cells, at knots and at all ends. */
typedef struct findings {
    double least, unity;
    int most;
} findings;

static void look_at(const kw_tensor *g, const double *x, findings *all)
{
    double sum = 0;
    int count = 0;

    for (int flat = 0; flat < kw_tensor_dimension(g); flat++) {
        int j[KW_TENSOR_D];
        double value;

        kw_tensor_multi(g, flat, j);
        value = kw_tensor_one(g, j, NULL, x);
        all->least = fmin(all->least, value);
        sum += value;
        count += value > 0;
    }
    all->unity = fmax(all->unity, fabs(sum - 1));
    all->most = count > all->most ? count : all->most;
}

static void report_plane(kw_out *report, const kw_tensor *g)
{
    findings all = {INFINITY, 0, 0};

    for (int a = 0; a <= GRID; a++)
        for (int b = 0; b <= GRID; b++) {
            const double x[2] = {(double)a / GRID, (double)b / GRID};

            look_at(g, x, &all);
        }
    kw_claim_real(report, "tp.basis.nonnegative", all.least);
    kw_claim_real(report, "tp.basis.unity", all.unity);
    kw_claim_count(report, "tp.basis.local", all.most);
}

static void report_space(kw_out *report)
{
    kw_bspline *s[3] = {kw_bspline_new_open_uniform(1, 3, 0, 1),
                        kw_bspline_new_open_uniform(2, 2, 0, 1),
                        kw_bspline_new_open_uniform(3, 2, 0, 1)};
    kw_tensor *g = kw_tensor_new(3, (const kw_bspline *const *)s);
    findings all = {INFINITY, 0, 0};

    for (int a = 0; a <= GRID3; a++)
        for (int b = 0; b <= GRID3; b++)
            for (int c = 0; c <= GRID3; c++) {
                const double x[3] = {(double)a / GRID3, (double)b / GRID3,
                                     (double)c / GRID3};

                look_at(g, x, &all);
            }
    kw_claim_real(report, "tp.basis.space.nonnegative", all.least);
    kw_claim_real(report, "tp.basis.space.unity", all.unity);
    kw_claim_count(report, "tp.basis.space.local", all.most);
    kw_tensor_free(g);
    for (int h = 0; h < 3; h++)
        kw_bspline_free(s[h]);
}

/* The largest (d_h+1)-th difference of a function along direction h inside a cell, which is
   zero for a polynomial of degree d_h in x_h. The knots are integers, so that the points, at
   eighths of the cells, are exact. */
static double difference_in_cells(int h)
{
    enum { CELLS = 4 };
    kw_bspline *s[2] = {kw_bspline_new_open_uniform(3, CELLS, 0, CELLS),
                        kw_bspline_new_open_uniform(2, CELLS, 0, CELLS)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);
    double most = 0;

    for (int flat = 0; flat < kw_tensor_dimension(g); flat++)
        for (int cell = 0; cell < CELLS * CELLS; cell++) {
            const int low[2] = {cell / CELLS, cell % CELLS};
            double sum = 0, binomial = 1;
            int j[2], d = g->s[h]->d;

            kw_tensor_multi(g, flat, j);
            for (int q = 0; q <= d + 1; q++) {
                double x[2] = {low[0] + 0.5, low[1] + 0.5};

                x[h] = low[h] + (q + 1.0) / EIGHTHS;
                sum += (q % 2 ? -1 : 1) * binomial * kw_tensor_one(g, j, NULL, x);
                binomial = binomial * (d + 1 - q) / (q + 1);
            }
            most = fmax(most, fabs(sum));
        }
    kw_tensor_free(g);
    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return most;
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

int main(void)
{
    kw_out *report = kw_claim_new("ex_tensor_basis");
    kw_bspline *s[2] = {kw_bspline_new_open_uniform(3, 6, 0, 1),
                        kw_bspline_new_open_uniform(2, 6, 0, 1)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);

    report_plane(report, g);
    report_space(report);
    kw_claim_real(report, "tp.basis.pieces",
                  fmax(difference_in_cells(0), difference_in_cells(1)));
    report_independence(report, g);

    kw_tensor_free(g);
    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return kw_out_close(report);
}
