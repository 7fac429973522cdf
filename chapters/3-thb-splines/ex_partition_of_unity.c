/* Partition of unity -- HB-splines lose it, THB-splines keep it.

   What to see: the sum of all HB-splines rises above one wherever functions of two levels
   overlap; the sum of all THB-splines is one everywhere.

   Book: section 1.1, the text behind Figure 9 and before (18).
   Claims: hb.unity.*, hb.nonnegative, thb.unity, thb.nonnegative, thb.below,
   thb.dimensions
   Chosen here: 60 random meshes in D = 1, 2, 3; 4 x 4 cells of bi-degree (2,2), refined
   twice, in the picture. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* both bases */
#include "meshes.h" /* meshes */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { MESHES = 20, POINTS = 60, SURFACE = 40 };

typedef struct findings {
    double hb_most, hb_least, thb_unity, hb_value, thb_value, above_mother;
} findings;

static kw_mesh *new_mesh(void)
{
    static const int low0[2] = {1, 1}, high0[2] = {4, 4};
    static const int low1[2] = {4, 4}, high1[2] = {8, 8};
    kw_mesh *m = uniform_mesh(2, 2, 4);

    kw_mesh_refine(m, 0, low0, high0);
    kw_mesh_refine(m, 1, low1, high1);
    return m;
}

/* Sum, least value, and for THB how far a function rises above its mother, at one point.
   index and value have room for b->most. */
static double sum_at(const kw_hier *b, kw_hier_kind kind, const double *x, int *index,
                     double *value, double *least)
{
    int count = kw_hier_at(b, kind, NULL, x, index, value);
    double sum = 0;

    for (int i = 0; i < count; i++) {
        sum += value[i];
        *least = fmin(*least, value[i]);
    }
    return sum;
}

/* Truncated functions lie between zero and the function that they come from. */
static double above_mother(const kw_hier *b, const double *x, const int *index,
                           const double *value, int count)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, value[i] - kw_hier_one(b, KW_HB, index[i], NULL, x));
    return most;
}

static void look_at(const kw_hier *b, uint64_t sample, findings *all)
{
    const kw_mesh *m = b->active->mesh;
    kw_rng r = kw_rng_at(21, 0, sample, (uint64_t)m->D);
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value), most = 0;

    for (int p = 0; p < POINTS; p++) {
        double x[KW_TENSOR_D], hb;
        int count;

        for (int h = 0; h < m->D; h++) /* the first point is the right end */
            x[h] = p == 0 ? 1 : kw_rng_uniform(&r);
        hb = sum_at(b, KW_HB, x, index, value, &all->hb_value);
        most = fmax(most, hb);
        all->hb_least = fmin(all->hb_least, hb);
        all->thb_unity =
            fmax(all->thb_unity,
                 fabs(sum_at(b, KW_THB, x, index, value, &all->thb_value) - 1));
        count = kw_hier_at(b, KW_THB, NULL, x, index, value);
        all->above_mother =
            fmax(all->above_mother, above_mother(b, x, index, value, count));
    }
    all->hb_most = fmax(all->hb_most, most);
    free(index);
    free(value);
}

static void write_sums(kw_out *f, const char *name, const kw_hier *b, kw_hier_kind kind)
{
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value), least = 0;

    kw_out_section(f, name, "x y sum");
    for (int i = 0; i <= SURFACE; i++) {
        for (int j = 0; j <= SURFACE; j++) {
            const double x[2] = {(double)i / SURFACE, (double)j / SURFACE};

            kw_out_number(f, x[0]);
            kw_out_number(f, x[1]);
            kw_out_number(f, sum_at(b, kind, x, index, value, &least));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    free(index);
    free(value);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_partition_of_unity");
    kw_out *report = kw_claim_new("ex_partition_of_unity");
    findings all = {0, 2, 0, 0, 0, 0};
    kw_mesh *m = new_mesh();
    kw_hier *b = kw_hier_new(m);
    int least_D = 0;

    write_sums(f, "HB", b, KW_HB);
    write_sums(f, "THB", b, KW_THB);
    kw_hier_free(b);
    kw_mesh_free(m);
    for (int D = KW_TENSOR_D; D >= 1; D--) {
        for (uint64_t i = 0; i < MESHES; i++) {
            m = random_mesh(20, i, D);
            b = kw_hier_new(m);
            look_at(b, i, &all);
            kw_hier_free(b);
            kw_mesh_free(m);
        }
        if (all.thb_unity < 1e-10) /* rounding, or about 1 */
            least_D = D;
    }

    kw_claim_real(report, "hb.unity.most", all.hb_most);
    kw_claim_real(report, "hb.unity.least", all.hb_least);
    kw_claim_real(report, "hb.nonnegative", all.hb_value);
    kw_claim_real(report, "thb.unity", all.thb_unity);
    kw_claim_real(report, "thb.nonnegative", all.thb_value);
    kw_claim_count(report, "thb.dimensions", least_D);
    kw_claim_real(report, "thb.below", all.above_mother);
    return kw_out_close(f) | kw_out_close(report);
}
