/* Levels -- what a point costs on a hierarchical mesh, as levels are added along its diagonal.

   What to see: the operations of a surface point do not depend on the levels at all; for the way
   down there are two comparisons more for each of them.

   Book: section 1.1, equation (19), Definitions 4 and 5.
   Claims: cost.levels.*
   Chosen here: meshes of 8 x 8 cells refined where |i-j| <= d, degree 2, points of which half lie
   anywhere and half on the diagonal, in the finest cells. */

#include "claim.h"      /* what we found, for the ledger */
#include "counted.h"    /* arithmetic that counts itself */
#include "diagonal.h"   /* meshes */
#include "hierpieces.h" /* geometries in THB-splines */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include "rng.h"        /* points and coefficients */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    D = 2,
    DEGREE = 2,
    K = DEGREE + 1,
    LOCAL = K * K,
    CELLS = 8,
    MOST = 8,
    POINTS = 200,
    N = 3
};

/* The leaf of x: from the cell of level 0 down, one comparison a level and direction. */
static int way_down(tally *t, const kw_celltree *tree, const double *x)
{
    int cell[KW_TENSOR_D], node = kw_celltree_root(tree, x, cell);

    while (tree->node[node].child >= 0) {
        const kw_celltree_node *n = &tree->node[node];

        node = n->child;
        for (int h = 0; h < D; h++)
            node += !below(t, x[h], n->middle[h]) << h;
    }
    return -1 - tree->node[node].child;
}

/* The local functions of the leaf. */
static void local_functions(tally *t, const kw_hier *b, int leaf, const double *x,
                            double *value)
{
    const kw_hier_leaf *l = &b->leaf[leaf];
    double factor[D][K] = {{0}};

    for (int h = 0; h < D; h++)
        basis_by_triangle(t, b->active->mesh->level[l->level].s[h], l->span[h], x[h],
                          factor[h]);
    for (int j = 0; j < K; j++)
        for (int k = 0; k < K; k++)
            value[j * K + k] = times(t, factor[0][j], factor[1][k]);
}

/* What a point and the list of its THB-splines cost. */
typedef struct costs {
    tally point, list;
    long long functions; /* in the lists */
    int differ;          /* numbers that are not the library's */
} costs;

static void count_point(const kw_hierpieces *p, const double *x, costs *count)
{
    double value[LOCAL], ours[N] = {0}, lib[N];
    int leaf = way_down(&count->point, p->b->tree, x);

    local_functions(&count->point, p->b, leaf, x, value);
    add_combination(&count->point, LOCAL, N, value, p->c + (size_t)leaf * LOCAL * N, N,
                    ours);
    kw_hierpieces_point(p, NULL, x, lib);
    count->differ += differing(N, ours, lib);
}

/* The THB-splines of the leaf's own level are its local functions; those of coarser levels are
   combinations of the other local functions. Returns how many coarser ones there are. */
static int count_list(const kw_hier *b, const double *x, double *ours, costs *count)
{
    double value[LOCAL], others[LOCAL];
    int leaf = way_down(&count->list, b->tree, x), own = 0, rows = 0;
    const kw_hier_leaf *l = &b->leaf[leaf];
    const kw_hier_own *owns = &b->own[l->node];

    local_functions(&count->list, b, leaf, x, value);
    memset(ours, 0, (size_t)l->carried * sizeof *ours);
    for (int f = 0; f < LOCAL; f++)
        if (own < owns->count && b->function[owns->first + (size_t)own].place == f)
            ours[l->carried + own++] = value[f];
        else
            others[rows++] = value[f];
    if (l->carried > 0)
        add_combination(&count->list, rows, l->carried, others, b->row + l->row,
                        l->carried, ours);
    count->functions += l->carried + own;
    return l->carried + own;
}

static void count_all(const kw_hierpieces *p, costs *count)
{
    const kw_hier *b = p->b;
    kw_rng r = kw_rng_at(95, 0, 0, 0);
    int *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *ours = kw_need_memory((size_t)b->most, sizeof *ours);
    double *lib = kw_need_memory((size_t)b->most, sizeof *lib);

    for (int i = 0; i < POINTS; i++) {
        const double at = kw_rng_uniform(&r), other = kw_rng_uniform(&r);
        const double x[] = {at, i % 2 ? at : other};
        int found;

        count_point(p, x, count);
        found = count_list(b, x, ours, count);
        count->differ += found != kw_hier_at(b, KW_THB, NULL, x, index, lib);
        count->differ += differing(found, ours, lib);
    }
    free(index);
    free(ours);
    free(lib);
}

static void report_levels(kw_out *report, int levels, const char *what, double number)
{
    char id[60];

    snprintf(id, sizeof id, "cost.levels.%s.%d", what, levels);
    kw_claim_real(report, id, number / POINTS);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_levels");
    int differ = 0;

    for (int levels = 2; levels <= MOST; levels += 3) {
        kw_mesh *m = new_diagonal(DEGREE, CELLS, levels - 1);
        kw_hier *b = kw_hier_new(m);
        kw_rng r = kw_rng_at(96, 0, 0, 0);
        double *c = kw_need_memory((size_t)b->active->size * N, sizeof *c);
        costs count = {.differ = 0};
        kw_hierpieces *p;

        for (int i = 0; i < b->active->size * N; i++)
            c[i] = kw_rng_uniform(&r);
        p = kw_hierpieces_new(b, KW_THB, N, c);
        count_all(p, &count);
        differ += count.differ;
        report_levels(report, levels, "point", (double)operations(&count.point));
        report_levels(report, levels, "way", (double)count.point.comparisons);
        report_levels(report, levels, "list", (double)operations(&count.list));
        report_levels(report, levels, "functions", (double)count.functions);
        kw_hierpieces_free(p);
        free(c);
        kw_hier_free(b);
        kw_mesh_free(m);
    }
    kw_claim_count(report, "cost.levels.bits", differ);
    return kw_out_close(report);
}
