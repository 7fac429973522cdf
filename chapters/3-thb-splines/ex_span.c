/* Span -- HB- and THB-splines span the same space, each family is a basis of it, and spaces of
   different degree are nested only with more knots.

   Book: section 1.1, Remark 7, (12), Definition 4, (18).
   Claims: hb.rank, thb.rank, thb.span, hb.nested.*, thb.coefficients
   Chosen here: 60 random meshes in D = 1 and 2. */

#include "claim.h"   /* what we found, for the ledger */
#include "dense.h"   /* ranks */
#include "elevate.h" /* the knots that make spaces of higher degree contain lower ones */
#include "hiergeo.h" /* both bases, coefficients */
#include "insert.h"  /* finer spaces */
#include "meshes.h"  /* meshes */
#include "need.h"    /* memory */
#include "out.h"     /* reports */
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MESHES = 30 };

/* Values of all functions at points that tell splines of the finest level apart: d+1 in each
   direction of each active cell. */
typedef struct values {
    int points, functions;
    double *a; /* points x functions */
} values;

/* The coordinate of point q of d+1 inside a cell. */
static double inner_point(const kw_mesh *m, int level, int h, int cell, int q)
{
    double low, high;

    cell_ends(m, level, h, cell, &low, &high);
    return low + (high - low) * (q + 0.5) / (m->level[0].s[h]->d + 1);
}

static void append_cell(const kw_hier *b, kw_hier_kind kind, int level, const int *cell,
                        values *v)
{
    const kw_mesh *m = b->active->mesh;

    for (int p = 0; p < b->active->local; p++) {
        double x[KW_TENSOR_D];

        for (int h = m->D - 1, rest = p; h >= 0; h--) {
            int k = m->level[0].s[h]->d + 1;

            x[h] = inner_point(m, level, h, cell[h], rest % k);
            rest /= k;
        }
        for (int i = 0; i < v->functions; i++)
            v->a[v->points * v->functions + i] = kw_hier_one(b, kind, i, NULL, x);
        v->points++;
    }
}

static values new_values(const kw_hier *b, kw_hier_kind kind)
{
    const kw_mesh *m = b->active->mesh;
    values v = {0, b->active->size, NULL};
    long long cells = 0;

    for (int level = 0; level < m->levels; level++)
        cells += kw_mesh_active(m, level);
    v.a = kw_need_memory((size_t)cells * (size_t)b->active->local * (size_t)v.functions,
                         sizeof *v.a);
    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];

            kw_mesh_multi(m, level, list[i], cell);
            if (!kw_mesh_refined(m, level, cell))
                append_cell(b, kind, level, cell, &v);
        }
        free(list);
    }
    return v;
}

/* The rank of two families together; b may be the same as a. */
static int rank_together(const values *a, const values *b, double *slack)
{
    int n = a->functions + b->functions, rank;
    double *both = kw_need_memory((size_t)a->points * (size_t)n, sizeof *both), gap;

    for (int p = 0; p < a->points; p++) {
        memcpy(both + p * n, a->a + p * a->functions,
               (size_t)a->functions * sizeof *both);
        memcpy(both + p * n + a->functions, b->a + p * b->functions,
               (size_t)b->functions * sizeof *both);
    }
    rank = kw_dense_rank(a->points, n, both, &gap);
    *slack = fmax(*slack, 1 / gap);
    free(both);
    return rank;
}

typedef struct findings {
    int hb, thb, together; /* meshes where a rank is not the number of functions */
    double slack;
} findings;

static void look_at(const kw_hier *b, findings *all)
{
    values hb = new_values(b, KW_HB), thb = new_values(b, KW_THB);
    int n = b->active->size;

    all->hb += rank_together(&hb, &hb, &all->slack) != n;
    all->thb += rank_together(&thb, &thb, &all->slack) != n;
    all->together += rank_together(&hb, &thb, &all->slack) != n;
    free(hb.a);
    free(thb.a);
}

/* How many dimensions the functions of `coarse` add to those of `fine`, both on [0,1]: 0 if
   the spaces are nested. */
static int dimensions_added(const kw_bspline *coarse, const kw_bspline *fine)
{
    enum { POINTS = 64 };
    int n = coarse->n + fine->n;
    double *a = kw_need_memory((size_t)POINTS * (size_t)n, sizeof *a), gap;
    int rank;

    for (int p = 0; p < POINTS; p++)
        for (int j = 0; j < n; j++)
            a[p * n + j] =
                j < fine->n ? kw_bspline_one(fine, j, 0, (p + 0.5) / POINTS)
                            : kw_bspline_one(coarse, j - fine->n, 0, (p + 0.5) / POINTS);
    rank = kw_dense_rank(POINTS, n, a, &gap);
    free(a);
    return rank - fine->n;
}

/* Remark 7: degree 2 and degree 3 on the same simple knots, on dyadic ones, and with every
   knot once more. */
static void report_nesting(kw_out *report)
{
    kw_bspline *two = kw_bspline_new_open_uniform(2, 4, 0, 1);
    kw_bspline *three = kw_bspline_new_open_uniform(3, 4, 0, 1);
    kw_bspline *dyadic = kw_insert_new_dyadic(two), *finer = kw_insert_new_dyadic(three);
    kw_bspline *elevated = kw_elevate_new(two);

    kw_claim_count(report, "hb.nested.dyadic", dimensions_added(two, dyadic));
    kw_claim_count(report, "hb.nested.degree", dimensions_added(two, three));
    kw_claim_count(report, "hb.nested.degree-dyadic", dimensions_added(two, finer));
    kw_claim_count(report, "hb.nested.elevated", dimensions_added(two, elevated));
    kw_bspline_free(two);
    kw_bspline_free(three);
    kw_bspline_free(dyadic);
    kw_bspline_free(finer);
    kw_bspline_free(elevated);
}

/* A spline of level 0 has, as THB coefficient of beta_j^l, its B-spline coefficient there: the
   identity x_0 has the Greville points. The largest difference. */
static double coefficient_error(const kw_hier *b)
{
    const kw_mesh *m = b->active->mesh;
    kw_hier *start;
    kw_mesh *plain;
    kw_bspline *const *s = m->level[0].s;
    kw_tensor *g = kw_tensor_new(m->D, (const kw_bspline *const *)s);
    double *c, *fine = kw_need_memory((size_t)b->active->size, sizeof *fine), most = 0;

    plain = kw_mesh_new(g);
    start = kw_hier_new(plain);
    c = kw_need_memory((size_t)start->active->size, sizeof *c);
    for (int i = 0; i < start->active->size; i++) {
        int level, j[KW_TENSOR_D];

        kw_active_function(start->active, i, &level, j);
        c[i] = kw_bspline_greville(s[0], j[0]);
    }
    kw_hiergeo_refine(start, b, 1, c, fine);
    for (int i = 0; i < b->active->size; i++) {
        int level, j[KW_TENSOR_D];

        kw_active_function(b->active, i, &level, j);
        most =
            fmax(most, fabs(fine[i] - kw_bspline_greville(m->level[level].s[0], j[0])));
    }
    free(c);
    free(fine);
    kw_hier_free(start);
    kw_mesh_free(plain);
    kw_tensor_free(g);
    return most;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_span");
    findings all = {0, 0, 0, 0};
    double coefficients = 0;

    for (int D = 1; D <= 2; D++)
        for (uint64_t i = 0; i < MESHES / (uint64_t)(D * D * D); i++) {
            kw_mesh *m = random_mesh(24, i, D);
            kw_hier *b = kw_hier_new(m);

            if (b->active->size < 260)
                look_at(b, &all);
            coefficients = fmax(coefficients, coefficient_error(b));
            kw_hier_free(b);
            kw_mesh_free(m);
        }
    kw_claim_count(report, "hb.rank", all.hb);
    kw_claim_count(report, "thb.rank", all.thb);
    kw_claim_count(report, "thb.span", all.together);
    kw_claim_real(report, "thb.span.slack", all.slack);
    kw_claim_real(report, "thb.coefficients", coefficients);
    report_nesting(report);
    return kw_out_close(report);
}
