/* Figure 7 -- Refining a tensor-product space along a diagonal refines it everywhere.

   What to see: the marked cells lie on a diagonal, so every row and every column of cells holds
   one of them; as a knot line runs through the whole domain, all cells are split.

   Book: section 1.1, the text around Figure 7.
   Claims: tp.fig7.*
   Chosen here: bi-degree (2,2) on 6 x 6 equal cells; the diagonal from corner to corner. */

#include "bspline.h" /* univariate spaces */
#include "claim.h"   /* what we found, for the ledger */
#include "insert.h"  /* knot lines where a cell is marked */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "picture.h" /* knot lines, the largest function */
#include "tensor.h"  /* the two spaces */
#include <math.h>
#include <stdlib.h>

enum { D = 2, CELLS = 6, SAMPLES = 40 };

static int is_marked(int row, int column)
{
    return row == column;
}

/* The space with a new knot in the middle of each cell of direction h that a marked element
   lies in. */
static kw_bspline *refined(const kw_bspline *s, int h)
{
    kw_bspline *fine = kw_bspline_new_copy(s);

    for (int i = 0; i < CELLS; i++) {
        int marked = 0;

        for (int other = 0; other < CELLS; other++)
            marked |= h == 0 ? is_marked(i, other) : is_marked(other, i);
        if (marked) {
            kw_bspline *next = kw_insert_new_knot(fine, (i + 0.5) / CELLS);

            kw_bspline_free(fine);
            fine = next;
        }
    }
    return fine;
}

static int count_cells(const kw_tensor *g)
{
    int cells = 1;

    for (int h = 0; h < g->D; h++) {
        int spans = 0;

        for (int i = g->s[h]->d; i < g->s[h]->n; i++)
            spans += g->s[h]->t[i] < g->s[h]->t[i + 1];
        cells *= spans;
    }
    return cells;
}

static void write_marked(kw_out *f)
{
    kw_out_section(f, "marked", "x y x_low x_high y_low y_high");
    for (int row = 0; row < CELLS; row++)
        for (int column = 0; column < CELLS; column++) {
            if (!is_marked(row, column))
                continue;
            kw_out_number(f, (row + 0.5) / CELLS);
            kw_out_number(f, (column + 0.5) / CELLS);
            kw_out_number(f, (double)row / CELLS);
            kw_out_number(f, (row + 1.0) / CELLS);
            kw_out_number(f, (double)column / CELLS);
            kw_out_number(f, (column + 1.0) / CELLS);
            kw_out_row(f);
        }
}

/* How far a geometry with the coefficients 0, 1, 2, .. moves when it is refined. */
static double moved(const kw_tensor *g, const kw_tensor *fine)
{
    int n = kw_tensor_dimension(g);
    double *c = kw_need_memory((size_t)n, sizeof *c), most = 0;
    double *to = kw_need_memory((size_t)kw_tensor_dimension(fine), sizeof *to);
    double *work = kw_need_memory(kw_tensor_refine_work(g, fine, 1), sizeof *work);

    for (int j = 0; j < n; j++)
        c[j] = (double)j / n;
    kw_tensor_refine(g, fine, 1, c, work, to);
    for (int a = 0; a <= SAMPLES; a++)
        for (int b = 0; b <= SAMPLES; b++) {
            const double x[2] = {(double)a / SAMPLES, (double)b / SAMPLES};
            double before, after;

            kw_tensor_point(g, 1, c, NULL, x, &before);
            kw_tensor_point(fine, 1, to, NULL, x, &after);
            most = fmax(most, fabs(before - after));
        }
    free(c);
    free(to);
    free(work);
    return most;
}

int main(void)
{
    kw_out *f = kw_out_data("fig07"), *report = kw_claim_new("fig07");
    kw_bspline *s = kw_bspline_new_open_uniform(D, CELLS, 0, 1);
    kw_bspline *both[2] = {s, s}, *halved[2] = {refined(s, 0), refined(s, 1)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)both);
    kw_tensor *fine = kw_tensor_new(2, (const kw_bspline *const *)halved);
    int marked = 0;

    for (int row = 0; row < CELLS; row++)
        for (int column = 0; column < CELLS; column++)
            marked += is_marked(row, column);
    write_knot_lines(f, "mesh", g);
    write_marked(f);
    write_knot_lines(f, "refined mesh", fine);
    write_largest(f, "basis", g, 4 * CELLS);
    write_largest(f, "refined basis", fine, 6 * CELLS);

    kw_claim_count(report, "tp.fig7.marked", marked);
    kw_claim_count(report, "tp.fig7.cells", count_cells(g));
    kw_claim_count(report, "tp.fig7.cells.refined", count_cells(fine));
    kw_claim_count(report, "tp.fig7.functions", kw_tensor_dimension(g));
    kw_claim_count(report, "tp.fig7.functions.refined", kw_tensor_dimension(fine));
    kw_claim_true(report, "tp.fig7.global", count_cells(fine) == 4 * count_cells(g));
    kw_claim_real(report, "tp.fig7.moved", moved(g, fine));

    kw_tensor_free(g);
    kw_tensor_free(fine);
    kw_bspline_free(halved[0]);
    kw_bspline_free(halved[1]);
    kw_bspline_free(s);
    return kw_out_close(f) | kw_out_close(report);
}
