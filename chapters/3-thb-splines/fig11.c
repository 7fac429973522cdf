/* Figure 11 -- The HB and the THB basis of the same mesh.

   What to see: (b), (c) the functions along the dashed line of the mesh (a): coarse HB-splines run
   on below the fine ones, THB-splines step aside. (d), (e) in each cell inside the frame the
   number of functions that are not zero there: truncation takes the coarse ones out of the
   refined region.

   Book: section 1.1, (17), (18), the text around Figure 11.
   Claims: thb.fig11.*
   Chosen here: bi-degree (2,2) on 8 x 8 cells, refined twice towards the middle; the
   line and the frame. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* both bases */
#include "meshes.h" /* the mesh to begin with, cells for the picture */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <stdlib.h>

enum { DEGREE = 2, CELLS = 8, SAMPLES = 192 };

static const double LINE =
    0.53125; /* x_2 of the dashed line, inside cells of all levels */

static kw_mesh *new_mesh(void)
{
    static const int low0[2] = {2, 2}, high0[2] = {6, 6};
    static const int low1[2] = {6, 6}, high1[2] = {10, 10};
    kw_mesh *m = uniform_mesh(2, DEGREE, CELLS);

    kw_mesh_refine(m, 0, low0, high0);
    kw_mesh_refine(m, 1, low1, high1);
    return m;
}

/* Functions that are not zero at the middle of a cell, and so on all of it. */
static int overlap(const kw_hier *b, kw_hier_kind kind, int level, const int *cell)
{
    int *index = kw_need_memory((size_t)b->most, sizeof *index), count, nonzero = 0;
    double *value = kw_need_memory((size_t)b->most, sizeof *value), x[2];

    for (int h = 0; h < 2; h++) {
        double low, high;

        cell_ends(b->active->mesh, level, h, cell[h], &low, &high);
        x[h] = (low + high) / 2;
    }
    count = kw_hier_at(b, kind, NULL, x, index, value);
    for (int i = 0; i < count; i++)
        nonzero += value[i] != 0;
    free(index);
    free(value);
    return nonzero;
}

static double overlap_hb(const kw_hier *b, int level, const int *cell)
{
    return overlap(b, KW_HB, level, cell);
}

static double overlap_thb(const kw_hier *b, int level, const int *cell)
{
    return overlap(b, KW_THB, level, cell);
}

/* The largest overlap over all active cells, and the sum of all overlaps. */
static int overlaps(const kw_hier *b, kw_hier_kind kind, long long *sum)
{
    const kw_mesh *m = b->active->mesh;
    int most = 0;

    *sum = 0;
    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D], here;

            kw_mesh_multi(m, level, list[i], cell);
            if (kw_mesh_refined(m, level, cell))
                continue;
            here = overlap(b, kind, level, cell);
            most = here > most ? here : most;
            *sum += here;
        }
        free(list);
    }
    return most;
}

static void write_point(kw_out *f, int q, double value, int level)
{
    kw_out_number(f, (double)q / SAMPLES);
    kw_out_number(f, value);
    kw_out_number(f, level);
    kw_out_row(f);
}

/* Every function that is not zero on the line, as a curve from zero to zero. */
static void write_line(kw_out *f, const char *name, const kw_hier *b, kw_hier_kind kind)
{
    kw_out_section(f, name, "x value level");
    for (int i = 0; i < b->active->size; i++) {
        int level, j[KW_TENSOR_D], written = 0;
        double before = 0;

        kw_active_function(b->active, i, &level, j);
        for (int q = 0; q <= SAMPLES; q++) {
            const double x[2] = {(double)q / SAMPLES, LINE};
            double value = kw_hier_one(b, kind, i, NULL, x);

            if (q > 0 && before == 0 && value != 0)
                write_point(f, q - 1, before, level);
            if (before != 0 || value != 0)
                write_point(f, q, value, level);
            written |= value != 0;
            before = value;
        }
        if (written)
            kw_out_gap(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("fig11"), *report = kw_claim_new("fig11");
    kw_mesh *m = new_mesh();
    kw_hier *b = kw_hier_new(m);
    long long sum_hb, sum_thb;

    write_cells(f, "HB", b, overlap_hb);
    write_cells(f, "THB", b, overlap_thb);
    write_line(f, "HB line", b, KW_HB);
    write_line(f, "THB line", b, KW_THB);
    kw_out_section(f, "line", "height");
    kw_out_number(f, LINE);
    kw_out_row(f);

    kw_claim_count(report, "thb.fig11.functions", b->active->size);
    kw_claim_count(report, "thb.fig11.most.hb", overlaps(b, KW_HB, &sum_hb));
    kw_claim_count(report, "thb.fig11.most.thb", overlaps(b, KW_THB, &sum_thb));
    kw_claim_true(report, "thb.fig11.less", sum_thb < sum_hb);
    kw_claim_count(report, "thb.fig11.reduced", sum_hb - sum_thb);

    kw_hier_free(b);
    kw_mesh_free(m);
    return kw_out_close(f) | kw_out_close(report);
}
