/* Overlap -- how many functions are not zero at a point, HB against THB.

   What to see: left, each mark is a mesh; the mean number of THB-splines on a cell is never above
   that of HB-splines. Right, wide refinement drops coarse functions and truncates those that
   are left, and THB-splines gain much; where only 2 x 2 cells are refined nothing is dropped,
   and they gain less.

   Book: section 1.1, the text around Figure 11.
   Claims: thb.overlap.*
   Chosen here: 60 random meshes, D = 2; and 8 x 8 cells of bi-degree (2,2), of which the 4 x 4 or
   the 2 x 2 in the middle of each level are refined again. Means are over active cells, each
   counting once, however large it is; the functions are counted at a random point of it. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* both bases */
#include "meshes.h" /* meshes */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <stdlib.h>

enum { MESHES = 60, LEVELS = 7, CELLS = 8 };

/* The cells less than `reach` from the middle, in either direction, of each level refined. */
static kw_mesh *middle_mesh(int levels, int reach)
{
    kw_mesh *m = uniform_mesh(2, 2, CELLS);

    for (int level = 0; level + 1 < levels; level++) {
        int middle = m->level[level].cells[0] / 2;
        const int low[2] = {middle - reach, middle - reach};
        const int high[2] = {middle + reach, middle + reach};

        kw_mesh_refine(m, level, low, high);
    }
    return m;
}

/* Sums over active cells; `above` counts points with more THB- than HB-splines. */
typedef struct overlap {
    int cells, hb, thb, above;
} overlap;

static int count_nonzero(const kw_hier *b, kw_hier_kind kind, const double *x, int *index,
                         double *value)
{
    int count = kw_hier_at(b, kind, NULL, x, index, value), nonzero = 0;

    for (int i = 0; i < count; i++)
        nonzero += value[i] != 0;
    return nonzero;
}

/* The functions that are not zero at a random point of each active cell. */
static overlap count_overlap(const kw_hier *b, uint64_t sample)
{
    const kw_mesh *m = b->active->mesh;
    kw_rng r = kw_rng_at(26, 0, sample, 0);
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value);
    overlap o = {0, 0, 0, 0};

    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D], hb, thb;
            double x[KW_TENSOR_D];

            kw_mesh_multi(m, level, list[i], cell);
            if (kw_mesh_refined(m, level, cell))
                continue;
            for (int h = 0; h < m->D; h++) {
                double low, high;

                cell_ends(m, level, h, cell[h], &low, &high);
                x[h] = low + (high - low) * (0.25 + kw_rng_uniform(&r) / 2);
            }
            hb = count_nonzero(b, KW_HB, x, index, value);
            thb = count_nonzero(b, KW_THB, x, index, value);
            o.hb += hb;
            o.thb += thb;
            o.above += thb > hb;
            o.cells++;
        }
        free(list);
    }
    free(index);
    free(value);
    return o;
}

static overlap write_mesh(kw_out *f, kw_mesh *m, uint64_t sample, double number)
{
    kw_hier *b = kw_hier_new(m);
    overlap o = count_overlap(b, sample);

    kw_out_number(f, number);
    kw_out_number(f, (double)o.hb / o.cells);
    kw_out_number(f, (double)o.thb / o.cells);
    kw_out_row(f);
    kw_hier_free(b);
    kw_mesh_free(m);
    return o;
}

int main(void)
{
    static const char *const id[2][3] = {
        {"thb.overlap.wide.cells", "thb.overlap.wide.hb", "thb.overlap.wide.thb"},
        {"thb.overlap.narrow.cells", "thb.overlap.narrow.hb", "thb.overlap.narrow.thb"}};
    kw_out *f = kw_out_data("ex_overlap"), *report = kw_claim_new("ex_overlap");
    int above = 0;

    kw_out_section(f, "random", "degree hb thb");
    for (uint64_t i = 0; i < MESHES; i++) {
        kw_mesh *m = random_mesh(25, i, 2);
        int degree = m->level[0].s[0]->d;

        above += write_mesh(f, m, i, degree).above;
    }
    for (int narrow = 0; narrow <= 1; narrow++) {
        overlap middle = {0, 0, 0, 0};

        kw_out_section(f, narrow ? "narrow" : "wide", "levels hb thb");
        for (int levels = 1; levels <= LEVELS; levels++) {
            middle = write_mesh(f, middle_mesh(levels, narrow ? 1 : 2), 0, levels);
            above += middle.above;
        }
        kw_claim_count(report, id[narrow][0], middle.cells);
        kw_claim_count(report, id[narrow][1], middle.hb);
        kw_claim_count(report, id[narrow][2], middle.thb);
    }
    kw_claim_count(report, "thb.overlap.above", above);
    return kw_out_close(f) | kw_out_close(report);
}
