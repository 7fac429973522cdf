/* Span -- HB- and THB-splines span the same space, each family is a basis of it, and spaces of
   different degree are nested only with more knots.

   Book: section 1.1, Remark 7, (12), Definition 4, (18).
   Claims: hb.rank, hb.larger, thb.rank, thb.span*, hb.nested.*, thb.coefficients
   Chosen here: 20, 10 and 3 random meshes in D = 1, 2 and 3, of degrees 1 to 3 in turn, on 8, 4
   and 2 cells a direction, with up to three levels. */

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

static const uint64_t MESHES[KW_TENSOR_D] = {20, 10, 3};

/* The values of all functions at the Greville points of the finest level. They tell all splines
   of that level apart, as each point lies inside the support of its function (Schoenberg and
   Whitney's condition), so a rank of values is the rank of the functions. */
typedef struct values {
    int points, functions;
    double *a; /* points x functions */
} values;

static values new_values(const kw_hier *b, kw_hier_kind kind)
{
    const kw_mesh *m = b->active->mesh;
    kw_bspline *const *s = m->level[m->levels - 1].s;
    kw_tensor *finest = kw_tensor_new(m->D, (const kw_bspline *const *)s);
    values v = {kw_tensor_dimension(finest), b->active->size, NULL};
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value);

    v.a = kw_need_memory((size_t)v.points * (size_t)v.functions, sizeof *v.a);
    for (int p = 0; p < v.points; p++) {
        int j[KW_TENSOR_D], count;
        double x[KW_TENSOR_D];

        kw_tensor_multi(finest, p, j);
        for (int h = 0; h < m->D; h++)
            x[h] = kw_bspline_greville(s[h], j[h]);
        count = kw_hier_at(b, kind, NULL, x, index, value);
        for (int i = 0; i < count; i++)
            v.a[p * v.functions + index[i]] = value[i];
    }
    free(index);
    free(value);
    kw_tensor_free(finest);
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
    int meshes, hb, thb,
        together; /* meshes where a rank is not the number of functions */
    int larger;   /* meshes with more functions than the finest level has */
    double slack, coefficients;
} findings;

static void look_at(const kw_hier *b, findings *all)
{
    values hb = new_values(b, KW_HB), thb = new_values(b, KW_THB);
    int n = b->active->size;

    all->meshes++;
    all->larger += n > hb.points; /* a point for each function of the finest level */
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

/* The Greville points of function i, point[0..D-1]. */
static void greville(const kw_active *a, int i, double *point)
{
    int level, j[KW_TENSOR_D];

    kw_active_function(a, i, &level, j);
    for (int h = 0; h < a->mesh->D; h++)
        point[h] = kw_bspline_greville(a->mesh->level[level].s[h], j[h]);
}

/* A spline of level 0 has, as THB coefficient of beta_j^l, its B-spline coefficient there: the
   identity has the Greville points. The largest difference in any coordinate. */
static double coefficient_error(const kw_hier *b)
{
    const kw_mesh *m = b->active->mesh;
    kw_tensor *g = kw_tensor_new(m->D, (const kw_bspline *const *)m->level[0].s);
    kw_mesh *plain = kw_mesh_new(g);
    kw_hier *start = kw_hier_new(plain);
    int D = m->D, n = b->active->size;
    double *c = kw_need_memory((size_t)start->active->size * (size_t)D, sizeof *c);
    double *fine = kw_need_memory((size_t)n * (size_t)D, sizeof *fine), most = 0;

    for (int i = 0; i < start->active->size; i++)
        greville(start->active, i, c + i * D);
    kw_hiergeo_refine(start, b, KW_THB, D, c, fine);
    for (int i = 0; i < n; i++) {
        double point[KW_TENSOR_D];

        greville(b->active, i, point);
        for (int h = 0; h < D; h++)
            most = fmax(most, fabs(fine[i * D + h] - point[h]));
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
    findings all = {0, 0, 0, 0, 0, 0, 0};

    for (int D = 1; D <= KW_TENSOR_D; D++)
        for (uint64_t i = 0; i < MESHES[D - 1]; i++) {
            kw_mesh *m = dyadic_mesh(34, i, D, 1 + (int)(i % 3));
            kw_hier *b = kw_hier_new(m);

            look_at(b, &all);
            all.coefficients = fmax(all.coefficients, coefficient_error(b));
            kw_hier_free(b);
            kw_mesh_free(m);
        }
    kw_claim_count(report, "thb.span.meshes", all.meshes);
    kw_claim_count(report, "hb.rank", all.hb);
    kw_claim_count(report, "hb.larger", all.larger);
    kw_claim_count(report, "thb.rank", all.thb);
    kw_claim_count(report, "thb.span", all.together);
    kw_claim_real(report, "thb.span.slack", all.slack);
    kw_claim_real(report, "thb.coefficients", all.coefficients);
    report_nesting(report);
    return kw_out_close(report);
}
