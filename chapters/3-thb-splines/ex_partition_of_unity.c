/* Partition of unity -- HB-splines lose it, THB-splines keep it.

   What to see: the sum of all HB-splines rises above one wherever functions of two levels
   overlap; the sum of all THB-splines is one everywhere.

   Book: section 1.1, the text behind Figure 9 and before (18), (19); (17).
   Claims: hb.unity.*, hb.nonnegative, thb.unity, thb.nonnegative, thb.below,
   thb.dimensions, thb.kept, thb.local, thb.vanishing
   Chosen here: 4 x 4 cells of bi-degree (2,2), refined twice, in the picture. In D = 1, 2, 3
   each 20 random meshes, where roundings are bounded, and 20 dyadic ones of degree 1 and 2 with
   points that are multiples of 1/64, where nothing is rounded and we ask for equality. */

#include "claim.h"      /* what we found, for the ledger */
#include "hierpieces.h" /* both bases, geometries */
#include "meshes.h"     /* meshes */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { MESHES = 20, POINTS = 60, SURFACE = 32, PARTS = 64, N_MOST = 3 };

static kw_mesh *new_mesh(void)
{
    static const int low0[2] = {1, 1}, high0[2] = {4, 4};
    static const int low1[2] = {4, 4}, high1[2] = {8, 8};
    kw_mesh *m = uniform_mesh(2, 2, 4);

    kw_mesh_refine(m, 0, low0, high0);
    kw_mesh_refine(m, 1, low1, high1);
    return m;
}

/* Sum of all functions at x, and the least of the values met so far. */
static double sum_at(const kw_hier *b, kw_hier_kind kind, const double *x, double *least)
{
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value), sum = 0;
    int count = kw_hier_at(b, kind, NULL, x, index, value);

    for (int i = 0; i < count; i++) {
        sum += value[i];
        *least = fmin(*least, value[i]);
    }
    free(index);
    free(value);
    return sum;
}

/* The sums on a grid, as a section; returns the largest. */
static double write_sums(kw_out *f, const char *name, const kw_hier *b, kw_hier_kind kind)
{
    double most = 0, least = 0;

    kw_out_section(f, name, "x y sum");
    for (int i = 0; i <= SURFACE; i++) {
        for (int j = 0; j <= SURFACE; j++) {
            const double x[2] = {(double)i / SURFACE, (double)j / SURFACE};
            double sum = sum_at(b, kind, x, &least);

            most = fmax(most, sum);
            kw_out_number(f, x[0]);
            kw_out_number(f, x[1]);
            kw_out_number(f, sum);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    return most;
}

/* --- with roundings --- */

typedef struct findings {
    double hb_least, thb_unity, hb_value, thb_value, above_mother;
} findings;

/* How far a THB-spline rises above its mother at x. Truncated functions lie between zero and
   the function that they come from. */
static double above_mother(const kw_hier *b, const double *x)
{
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value), most = 0;
    int count = kw_hier_at(b, KW_THB, NULL, x, index, value);

    for (int i = 0; i < count; i++)
        most = fmax(most, value[i] - kw_hier_one(b, KW_HB, index[i], NULL, x));
    free(index);
    free(value);
    return most;
}

static void look_at(const kw_hier *b, uint64_t sample, findings *all)
{
    const kw_mesh *m = b->active->mesh;
    kw_rng r = kw_rng_at(21, 0, sample, (uint64_t)m->D);

    for (int p = 0; p < POINTS; p++) {
        double x[KW_TENSOR_D], sum;

        for (int h = 0; h < m->D; h++) /* the first point is the right end */
            x[h] = p == 0 ? 1 : kw_rng_uniform(&r);
        all->hb_least = fmin(all->hb_least, sum_at(b, KW_HB, x, &all->hb_value));
        sum = sum_at(b, KW_THB, x, &all->thb_value);
        all->thb_unity = fmax(all->thb_unity, fabs(sum - 1));
        all->above_mother = fmax(all->above_mother, above_mother(b, x));
    }
}

static void report_random(kw_out *report)
{
    findings all = {2, 0, 0, 0, 0};

    for (int D = 1; D <= KW_TENSOR_D; D++)
        for (uint64_t i = 0; i < MESHES; i++) {
            kw_mesh *m = random_mesh(20, i, D);
            kw_hier *b = kw_hier_new(m);

            look_at(b, i, &all);
            kw_hier_free(b);
            kw_mesh_free(m);
        }
    kw_claim_real(report, "hb.unity.least", all.hb_least);
    kw_claim_real(report, "hb.nonnegative", all.hb_value);
    kw_claim_real(report, "thb.unity", all.thb_unity);
    kw_claim_real(report, "thb.nonnegative", all.thb_value);
    kw_claim_real(report, "thb.below", all.above_mother);
}

/* --- without roundings --- */

/* An affine map from D to N coordinates, point[0..N-1]. */
static void affine(int D, int N, const double *x, double *point)
{
    for (int a = 0; a < N; a++) {
        point[a] = a + 1;
        for (int h = 0; h < D; h++)
            point[a] += (1 + (a + h) % 3) * x[h];
    }
}

/* Is the geometry (19) with N coordinates, whose coefficients are the images of the Greville
   points under the affine map, that map at all points? */
static int is_affine(const kw_hier *b, int N, int points, const double *x)
{
    const kw_mesh *m = b->active->mesh;
    double *c = kw_need_memory((size_t)b->active->size * (size_t)N, sizeof *c);
    kw_hierpieces *geometry;
    int equal = 1;

    for (int i = 0; i < b->active->size; i++) {
        int level, j[KW_TENSOR_D];
        double greville[KW_TENSOR_D];

        kw_active_function(b->active, i, &level, j);
        for (int h = 0; h < m->D; h++)
            greville[h] = kw_bspline_greville(m->level[level].s[h], j[h]);
        affine(m->D, N, greville, c + i * N);
    }
    geometry = kw_hierpieces_new(b, KW_THB, N, c);
    for (int p = 0; p < points; p++) {
        double point[N_MOST], image[N_MOST];

        kw_hierpieces_point(geometry, NULL, x + p * m->D, point);
        affine(m->D, N, x + p * m->D, image);
        for (int a = 0; a < N; a++)
            equal = equal && point[a] == image[a];
    }
    kw_hierpieces_free(geometry);
    free(c);
    return equal;
}

/* What truncation must not do: change a function where its own level is active, leave something
   where the function is zero, or leave nothing at all. */
typedef struct truncated {
    int changed, outside, vanishing;
} truncated;

/* The functions at x, those of all levels. */
static void look_at_point(const kw_hier *b, const double *x, truncated *all)
{
    int cell[KW_TENSOR_D], here = kw_mesh_locate(b->active->mesh, x, cell);

    for (int i = 0; i < b->active->size; i++) {
        int level, j[KW_TENSOR_D];
        double beta = kw_hier_one(b, KW_HB, i, NULL, x);
        double tau = kw_hier_one(b, KW_THB, i, NULL, x);

        kw_active_function(b->active, i, &level, j);
        all->changed += level == here && tau != beta;
        all->outside += beta == 0 && tau != 0;
    }
}

/* The functions that are zero in the middle of an active cell of their level. */
static int count_vanishing(const kw_hier *b)
{
    int vanishing = 0;

    for (int i = 0; i < b->active->size; i++) {
        int cell[KW_TENSOR_D], level = kw_active_cell(b->active, i, cell);
        double x[KW_TENSOR_D];

        for (int h = 0; h < b->active->mesh->D; h++) {
            double low, high;

            cell_ends(b->active->mesh, level, h, cell[h], &low, &high);
            x[h] = (low + high) / 2;
        }
        vanishing += kw_hier_one(b, KW_THB, i, NULL, x) == 0;
    }
    return vanishing;
}

/* Pairs (D, N) for which (19) holds on all meshes, meshes on which the HB-splines add up to more
   than one somewhere, and what truncation leaves. */
static void report_dyadic(kw_out *report)
{
    int pairs = 0, lost = 0;
    truncated all = {0, 0, 0};

    for (int D = 1; D <= KW_TENSOR_D; D++) {
        int holds[N_MOST] = {1, 1, 1};

        for (uint64_t i = 0; i < MESHES; i++) {
            kw_mesh *m = dyadic_mesh(29, i, D, 1 + (int)(i % 2));
            kw_hier *b = kw_hier_new(m);
            kw_rng r = kw_rng_at(29, 2, i, (uint64_t)D);
            double x[POINTS * KW_TENSOR_D], most = 0, least = 0;

            for (int q = 0; q < POINTS * D; q++)
                x[q] = (double)kw_rng_below(&r, PARTS + 1) / PARTS;
            for (int p = 0; p < POINTS; p++) {
                most = fmax(most, sum_at(b, KW_HB, x + p * D, &least));
                look_at_point(b, x + p * D, &all);
            }
            all.vanishing += count_vanishing(b);
            lost += most > 1;
            for (int N = 1; N <= N_MOST; N++)
                holds[N - 1] = holds[N - 1] && is_affine(b, N, POINTS, x);
            kw_hier_free(b);
            kw_mesh_free(m);
        }
        for (int N = 1; N <= N_MOST; N++)
            pairs += holds[N - 1];
    }
    kw_claim_count(report, "thb.dimensions", pairs);
    kw_claim_count(report, "hb.unity.lost", lost);
    kw_claim_count(report, "thb.kept", all.changed);
    kw_claim_count(report, "thb.local", all.outside);
    kw_claim_count(report, "thb.vanishing", all.vanishing);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_partition_of_unity");
    kw_out *report = kw_claim_new("ex_partition_of_unity");
    kw_mesh *m = new_mesh();
    kw_hier *b = kw_hier_new(m);

    kw_claim_real(report, "hb.unity.most", write_sums(f, "HB", b, KW_HB));
    write_sums(f, "THB", b, KW_THB);
    report_random(report);
    report_dyadic(report);

    kw_hier_free(b);
    kw_mesh_free(m);
    return kw_out_close(f) | kw_out_close(report);
}
