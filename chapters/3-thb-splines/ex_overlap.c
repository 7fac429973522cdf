/* Overlap -- how many functions are not zero at a point, HB against THB.

   What to see: each dot is a mesh; the mean number of THB-splines at a point is never above
   that of HB-splines, and the more levels there are, the further below it stays.

   Book: section 1.1, the text around Figure 11.
   Claims: thb.overlap.*
   Chosen here: meshes refined again and again around the middle, and 60 random ones, D = 2. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* both bases */
#include "meshes.h" /* meshes */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <stdlib.h>

enum { MESHES = 60, LEVELS = 7 };

/* Degree 2, 4 x 4 cells, the 2 x 2 cells in the middle of each level refined again. */
static kw_mesh *middle_mesh(int levels)
{
    kw_mesh *m = uniform_mesh(2, 2, 4);

    for (int level = 0; level + 1 < levels; level++) {
        int middle = m->level[level].cells[0] / 2;
        const int low[2] = {middle - 1, middle - 1}, high[2] = {middle + 1, middle + 1};

        kw_mesh_refine(m, level, low, high);
    }
    return m;
}

typedef struct overlap {
    double hb, thb;
    int above;
} overlap;

static int count_nonzero(const kw_hier *b, kw_hier_kind kind, const double *x, int *index,
                         double *value)
{
    int count = kw_hier_at(b, kind, NULL, x, index, value), nonzero = 0;

    for (int i = 0; i < count; i++)
        nonzero += value[i] != 0;
    return nonzero;
}

/* Means over random points of cells, each active cell as likely as any other; `above` counts
   points with more THB- than HB-splines. */
static overlap mean_overlap(const kw_hier *b, uint64_t sample)
{
    const kw_mesh *m = b->active->mesh;
    kw_rng r = kw_rng_at(26, 0, sample, 0);
    int *index = kw_need_memory((size_t)b->most, sizeof *index), points = 0;
    double *value = kw_need_memory((size_t)b->most, sizeof *value);
    overlap o = {0, 0, 0};

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
            points++;
        }
        free(list);
    }
    free(index);
    free(value);
    o.hb /= points;
    o.thb /= points;
    return o;
}

static overlap write_mesh(kw_out *f, kw_mesh *m, uint64_t sample, double number)
{
    kw_hier *b = kw_hier_new(m);
    overlap o = mean_overlap(b, sample);

    kw_out_number(f, number);
    kw_out_number(f, o.hb);
    kw_out_number(f, o.thb);
    kw_out_row(f);
    kw_hier_free(b);
    kw_mesh_free(m);
    return o;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_overlap"), *report = kw_claim_new("ex_overlap");
    overlap middle = {0, 0, 0};
    int above = 0;

    kw_out_section(f, "random", "degree hb thb");
    for (uint64_t i = 0; i < MESHES; i++) {
        kw_mesh *m = random_mesh(25, i, 2);
        int degree = m->level[0].s[0]->d;

        above += write_mesh(f, m, i, degree).above;
    }
    kw_out_section(f, "middle", "levels hb thb");
    for (int levels = 1; levels <= LEVELS; levels++) {
        middle = write_mesh(f, middle_mesh(levels), 0, levels);
        above += middle.above;
    }

    kw_claim_count(report, "thb.overlap.above", above);
    kw_claim_real(report, "thb.overlap.middle.hb", middle.hb);
    kw_claim_real(report, "thb.overlap.middle.thb", middle.thb);
    return kw_out_close(f) | kw_out_close(report);
}
