/* Tensor-product geometries -- a planar patch and a surface.

   What to see: left a patch in the plane, right a surface in space, both bi-quadratic; their
   corners are corner control points, and the net of control points foreshadows the shape.

   Book: section 1.1, (11).
   Claims: tp.eq11.grid
   Chosen here: bi-degree (2,2), the knots and all control points (patch.h). */

#include "claim.h"   /* what we found, for the ledger */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "patch.h"   /* the example */
#include "picture.h" /* rows of three numbers */
#include "tensor.h"  /* the geometries */
#include <math.h>
#include <stdlib.h>

enum { LINES = 10, FINE = 40 };

/* Lines of constant x_1, then of constant x_2, of the patch in the plane. */
static void write_lines(kw_out *f, const kw_tensor *g)
{
    kw_out_section(f, "lines", "x y z");
    for (int h = 0; h < 2; h++)
        for (int line = 0; line <= LINES; line++) {
            for (int i = 0; i <= FINE; i++) {
                double x[2], p[SPACE];

                x[h] = (double)line / LINES;
                x[1 - h] = (double)i / FINE;
                kw_tensor_point(g, SPACE, points, NULL, x, p);
                write_row3(f, p[0], p[1], p[2]);
            }
            kw_out_gap(f);
        }
}

static void write_net(kw_out *f, const kw_tensor *g)
{
    kw_out_section(f, "net", "x y z");
    for (int h = 0; h < 2; h++)
        for (int line = 0; line < g->s[h]->n; line++) {
            for (int i = 0; i < g->s[1 - h]->n; i++) {
                int j[2];
                const double *p;

                j[h] = line;
                j[1 - h] = i;
                p = points + kw_tensor_flat(g, j) * SPACE;
                write_row3(f, p[0], p[1], p[2]);
            }
            kw_out_gap(f);
        }
}

/* Writes the surface on a grid, by sum factorization; returns how far that is from the sum
   point by point. */
static double write_grid(kw_out *f, const kw_tensor *g)
{
    enum { M = 2 * LINES + 1 };
    const int count[2] = {M, M};
    double x1[M], grid[M * M * SPACE], most = 0;
    const double *const x[2] = {x1, x1};
    double *work = kw_need_memory(kw_tensor_grid_work(g, SPACE, count), sizeof *work);

    for (int i = 0; i < M; i++)
        x1[i] = (double)i / (M - 1);
    kw_tensor_grid(g, SPACE, points, NULL, count, x, work, grid);
    kw_out_section(f, "surface", "x y z");
    for (int i = 0; i < M; i++) {
        for (int k = 0; k < M; k++) {
            const double at[2] = {x1[i], x1[k]}, *q = grid + (i * M + k) * SPACE;
            double p[SPACE];

            write_row3(f, q[0], q[1], q[2]);
            kw_tensor_point(g, SPACE, points, NULL, at, p);
            for (int a = 0; a < SPACE; a++)
                most = fmax(most, fabs(p[a] - q[a]));
        }
        kw_out_gap(f);
    }
    free(work);
    return most;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_patch"), *report = kw_claim_new("ex_patch");
    kw_tensor *g = new_patch(1);

    write_lines(f, g);
    write_net(f, g);
    kw_claim_real(report, "tp.eq11.grid", write_grid(f, g));

    kw_tensor_free(g);
    return kw_out_close(f) | kw_out_close(report);
}
