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

/* Which cells are marked, by row and column. */
typedef int marking(int, int);

static int diagonal(int row, int column)
{
    return row == column;
}

/* The diagonal without its third cell. */
static int diagonal_with_a_gap(int row, int column)
{
    return row == column && row != 2;
}

static int one_cell(int row, int column)
{
    return row == 2 && column == 2;
}

/* The space with a new knot in the middle of each cell of direction h that a marked element
   lies in. */
static kw_bspline *refined(const kw_bspline *s, marking is_marked, int h)
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

static void write_marked(kw_out *f)
{
    kw_out_section(f, "marked", "x y x_low x_high y_low y_high");
    for (int row = 0; row < CELLS; row++)
        for (int column = 0; column < CELLS; column++) {
            if (!diagonal(row, column))
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

/* The smallest tensor-product refinement of s x s that splits every marked cell. */
static kw_tensor *new_refined(const kw_bspline *s, marking is_marked)
{
    kw_bspline *halved[2] = {refined(s, is_marked, 0), refined(s, is_marked, 1)};
    kw_tensor *fine = kw_tensor_new(2, (const kw_bspline *const *)halved);

    kw_bspline_free(halved[0]);
    kw_bspline_free(halved[1]);
    return fine;
}

static int count_refined_cells(const kw_bspline *s, marking is_marked)
{
    kw_tensor *fine = new_refined(s, is_marked);
    int cells = count_cells(fine);

    kw_tensor_free(fine);
    return cells;
}

static int count_marked(marking is_marked)
{
    int marked = 0;

    for (int row = 0; row < CELLS; row++)
        for (int column = 0; column < CELLS; column++)
            marked += is_marked(row, column);
    return marked;
}

/* Functions whose support meets no marked cell in more than its border. */
static int count_far(const kw_tensor *g)
{
    int far = 0;

    for (int flat = 0; flat < kw_tensor_dimension(g); flat++) {
        int j[2], meets = 0;

        kw_tensor_multi(g, flat, j);
        for (int cell = 0; cell < CELLS; cell++) { /* the diagonal */
            int overlap = 1;

            for (int h = 0; h < 2; h++)
                overlap &= g->s[h]->t[j[h]] < (cell + 1.0) / CELLS &&
                           g->s[h]->t[j[h] + D + 1] > (double)cell / CELLS;
            meets |= overlap;
        }
        far += !meets;
    }
    return far;
}

int main(void)
{
    kw_out *f = kw_out_data("fig07"), *report = kw_claim_new("fig07");
    kw_bspline *s = kw_bspline_new_open_uniform(D, CELLS, 0, 1);
    kw_bspline *both[2] = {s, s};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)both);
    kw_tensor *fine = new_refined(s, diagonal);

    write_knot_lines(f, "mesh", g);
    write_marked(f);
    write_knot_lines(f, "refined mesh", fine);
    write_largest(f, "basis", g, 4 * CELLS);
    write_largest(f, "refined basis", fine, 6 * CELLS);

    kw_claim_count(report, "tp.fig7.marked", count_marked(diagonal));
    kw_claim_count(report, "tp.fig7.cells", count_cells(g));
    kw_claim_count(report, "tp.fig7.cells.refined", count_cells(fine));
    kw_claim_count(report, "tp.fig7.functions", kw_tensor_dimension(g));
    kw_claim_count(report, "tp.fig7.functions.refined", kw_tensor_dimension(fine));
    kw_claim_true(report, "tp.fig7.global", count_cells(fine) == 4 * count_cells(g));
    kw_claim_count(report, "tp.fig7.cells.gap",
                   count_refined_cells(s, diagonal_with_a_gap));
    kw_claim_count(report, "tp.fig7.cells.one", count_refined_cells(s, one_cell));
    kw_claim_count(report, "tp.fig7.far", count_far(g));
    kw_claim_count(report, "tp.fig7.far.refined", count_far(fine));
    kw_claim_real(report, "tp.fig7.moved", moved(g, fine));

    kw_tensor_free(g);
    kw_tensor_free(fine);
    kw_bspline_free(s);
    return kw_out_close(f) | kw_out_close(report);
}
