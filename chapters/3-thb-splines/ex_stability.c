/* Stability -- condition numbers of the two bases as levels are added.

   What to see: refined again and again around one point, the HB basis gets worse with every
   level, if by smaller and smaller factors; the THB basis does so less and soon hardly at all. On
   the square the fine functions are few among all, and less is at stake.

   Book: section 1.1, the properties of THB-splines in front of (15).
   Claims: thb.stability.*
   Chosen here: D = 1 and 2, eight cells a direction, degree 2 and 3, the two middle cells of
   every level (2 x 2 for D = 2) refined. The matrix G has the integrals of products of two
   functions, each divided by its L2 norm; its condition number is that in the row-sum norm,
   |G| |G^-1|. It is at least the ratio of the extreme eigenvalues. */

#include "claim.h"  /* what we found, for the ledger */
#include "dense.h"  /* the inverse */
#include "gauss.h"  /* integrals */
#include "hier.h"   /* both bases */
#include "meshes.h" /* the mesh to begin with */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CELLS = 8, LEVELS = 8 };

/* The largest error of the rules for the integrals of 1, x, .., x^(2d) on [0,1]. */
static double gauss_error(void)
{
    double most = 0;

    for (int d = 2; d <= 3; d++) {
        double node[GAUSS_NODES], weight[GAUSS_NODES], power[GAUSS_NODES] = {1, 1, 1, 1};

        gauss(d + 1, node, weight);
        for (int p = 0; p <= 2 * d; p++) {
            double sum = 0;

            for (int i = 0; i <= d; i++) {
                sum += weight[i] * power[i];
                power[i] *= node[i];
            }
            most = fmax(most, fabs(sum - 1.0 / (p + 1)));
        }
    }
    return most;
}

static kw_hier *new_bases(int D, int degree, int levels)
{
    kw_mesh *m = uniform_mesh(D, degree, CELLS);
    kw_hier *b;

    for (int level = 0; level + 1 < levels; level++) {
        int middle = m->level[level].cells[0] / 2;
        const int low[2] = {middle - 1, middle - 1}, high[2] = {middle + 1, middle + 1};

        kw_mesh_refine(m, level, low, high);
    }
    b = kw_hier_new(m);
    kw_mesh_free(m);
    return b;
}

/* The matrix G, and room for the functions at a point. */
typedef struct gram {
    const kw_hier *b;
    kw_hier_kind kind;
    double *G; /* n x n */
    int *index;
    double *value;
} gram;

/* Adds the products of all functions at x, times the weight of x. */
static void add_point(const gram *g, const double *x, double weight)
{
    int n = g->b->active->size;
    int count = kw_hier_at(g->b, g->kind, NULL, x, g->index, g->value);

    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            g->G[g->index[i] * n + g->index[j]] += weight * (g->value[i] * g->value[j]);
}

/* Adds the integrals over an active cell. */
static void add_cell(const gram *g, int level, const int *cell)
{
    const kw_mesh *m = g->b->active->mesh;
    double node[GAUSS_NODES], weight[GAUSS_NODES];
    int nodes = m->level[0].s[0]->d + 1, points = 1;

    gauss(nodes, node, weight);
    for (int h = 0; h < m->D; h++)
        points *= nodes;
    for (int p = 0; p < points; p++) {
        double x[KW_TENSOR_D], volume = 1;

        for (int h = 0, rest = p; h < m->D; h++, rest /= nodes) {
            double low, high;

            cell_ends(m, level, h, cell[h], &low, &high);
            x[h] = low + (high - low) * node[rest % nodes];
            volume *= (high - low) * weight[rest % nodes];
        }
        add_point(g, x, volume);
    }
}

/* Divides each function by its norm. */
static void scale(int n, double *G)
{
    double *norm = kw_need_memory((size_t)n, sizeof *norm);

    for (int i = 0; i < n; i++)
        norm[i] = sqrt(G[i * n + i]);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            G[i * n + j] /= norm[i] * norm[j];
    free(norm);
}

static double *new_gram(const kw_hier *b, kw_hier_kind kind)
{
    const kw_mesh *m = b->active->mesh;
    int n = b->active->size;
    gram g = {b, kind, kw_need_memory((size_t)n * (size_t)n, sizeof *g.G),
              kw_need_memory((size_t)b->most, sizeof *g.index),
              kw_need_memory((size_t)b->most, sizeof *g.value)};

    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];

            kw_mesh_multi(m, level, list[i], cell);
            if (!kw_mesh_refined(m, level, cell))
                add_cell(&g, level, cell);
        }
        free(list);
    }
    scale(n, g.G);
    free(g.index);
    free(g.value);
    return g.G;
}

/* The largest row sum of absolute values. */
static double row_norm(int n, const double *A)
{
    double most = 0;

    for (int i = 0; i < n; i++) {
        double sum = 0;

        for (int j = 0; j < n; j++)
            sum += fabs(A[i * n + j]);
        most = fmax(most, sum);
    }
    return most;
}

static double condition(const kw_hier *b, kw_hier_kind kind)
{
    int n = b->active->size;
    double *G = new_gram(b, kind), norm = row_norm(n, G);
    double *inverse = kw_need_memory((size_t)n * (size_t)n, sizeof *inverse);

    for (int i = 0; i < n; i++)
        inverse[i * n + i] = 1;
    KW_NEED(kw_dense_solve(n, n, G, inverse) == 0, "no inverse of %d functions", n);
    norm *= row_norm(n, inverse);
    free(G);
    free(inverse);
    return norm;
}

/* The sum of all functions in the middle of the domain. */
static double sum_in_middle(const kw_hier *b, kw_hier_kind kind)
{
    static const double middle[KW_TENSOR_D] = {0.5, 0.5, 0.5};
    double sum = 0;

    for (int i = 0; i < b->active->size; i++)
        sum += kw_hier_one(b, kind, i, NULL, middle);
    return sum;
}

/* The condition numbers on 1 .. LEVELS levels, as a section; reports the last ones, divided by
   that on one level. */
static void write_condition(kw_out *f, kw_out *report, int D, int degree)
{
    static const char *const KIND[2] = {"hb", "thb"};
    double first = 0, last[2] = {0, 0};
    char name[64];

    snprintf(name, sizeof name, "D = %d, degree %d", D, degree);
    kw_out_section(f, name, "levels hb thb");
    for (int levels = 1; levels <= LEVELS; levels++) {
        kw_hier *b = new_bases(D, degree, levels);

        kw_out_number(f, levels);
        for (int kind = KW_HB; kind <= KW_THB; kind++) {
            last[kind] = condition(b, (kw_hier_kind)kind);
            kw_out_number(f, last[kind]);
        }
        if (levels == 1)
            first = last[KW_HB]; /* nothing is truncated: the bases are the same */
        kw_out_row(f);
        kw_hier_free(b);
    }
    for (int kind = KW_HB; kind <= KW_THB; kind++) {
        snprintf(name, sizeof name, "thb.stability.D%d.degree%d.%s", D, degree,
                 KIND[kind]);
        kw_claim_real(report, name, last[kind] / first);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_stability"), *report = kw_claim_new("ex_stability");
    kw_hier *b = new_bases(1, 2, LEVELS);

    kw_claim_real(report, "thb.stability.gauss", gauss_error());
    for (int D = 1; D <= 2; D++)
        for (int degree = 2; degree <= 3; degree++)
            write_condition(f, report, D, degree);
    kw_claim_real(report, "thb.stability.sum.hb", sum_in_middle(b, KW_HB));
    kw_claim_real(report, "thb.stability.sum.thb", sum_in_middle(b, KW_THB));
    kw_hier_free(b);
    return kw_out_close(f) | kw_out_close(report);
}
