/* Stability -- condition numbers of the two bases as levels are added.

   What to see: refined again and again around one point, the mass matrix of the HB basis grows
   worse with every level, that of the THB basis stays as it is after the first few.

   Book: section 1.1, the properties of THB-splines in front of (15).
   Claims: thb.stability.*
   Chosen here: D = 1, eight cells, the two middle cells of every level refined; each function scaled
   to norm one; integrals by sums over eight midpoints a cell. */

#include "claim.h"  /* what we found, for the ledger */
#include "dense.h"  /* the inverse */
#include "hier.h"   /* both bases */
#include "meshes.h" /* the mesh to begin with */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { CELLS = 8, LEVELS = 8, MIDPOINTS = 8 };

static kw_hier *new_bases(int degree, int levels)
{
    kw_mesh *m = uniform_mesh(1, degree, CELLS);
    kw_hier *b;

    for (int level = 0; level + 1 < levels; level++) {
        int middle = m->level[level].cells[0] / 2;

        refine_interval(m, level, middle - 1, middle + 1);
    }
    b = kw_hier_new(m);
    kw_mesh_free(m);
    return b;
}

/* Adds the products of all functions at x, times the weight of x, to the matrix G. */
static void add_point(const kw_hier *b, kw_hier_kind kind, double x, double weight,
                      double *G)
{
    int index[128], n = b->active->size, count;
    double value[128];

    KW_NEED(b->most <= 128, "%d functions at a point", b->most);
    count = kw_hier_at(b, kind, NULL, &x, index, value);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            G[index[i] * n + index[j]] += weight * value[i] * value[j];
}

/* The mass matrix of the functions, each divided by its norm. */
static double *new_mass(const kw_hier *b, kw_hier_kind kind)
{
    const kw_mesh *m = b->active->mesh;
    int n = b->active->size;
    double *G = kw_need_memory((size_t)n * (size_t)n, sizeof *G);
    double *norm = kw_need_memory((size_t)n, sizeof *norm);

    for (int level = 0; level < m->levels; level++)
        for (int c = 0; c < m->level[level].cells[0]; c++) {
            double low, high;

            if (!kw_mesh_inside(m, level, &c) || kw_mesh_refined(m, level, &c))
                continue;
            cell_ends(m, level, 0, c, &low, &high);
            for (int q = 0; q < MIDPOINTS; q++)
                add_point(b, kind, low + (high - low) * (q + 0.5) / MIDPOINTS,
                          (high - low) / MIDPOINTS, G);
        }
    for (int i = 0; i < n; i++)
        norm[i] = sqrt(G[i * n + i]);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            G[i * n + j] /= norm[i] * norm[j];
    free(norm);
    return G;
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

/* The condition number of the scaled mass matrix in the row-sum norm. */
static double condition(const kw_hier *b, kw_hier_kind kind)
{
    int n = b->active->size;
    double *G = new_mass(b, kind), norm = row_norm(n, G);
    double *inverse = kw_need_memory((size_t)n * (size_t)n, sizeof *inverse);

    for (int i = 0; i < n; i++)
        inverse[i * n + i] = 1;
    KW_NEED(kw_dense_solve(n, n, G, inverse) == 0, "no inverse of %d functions", n);
    norm *= row_norm(n, inverse);
    free(G);
    free(inverse);
    return norm;
}

int main(void)
{
    static const char *const id[2][2] = {
        {"thb.stability.hb.degree2", "thb.stability.thb.degree2"},
        {"thb.stability.hb.degree3", "thb.stability.thb.degree3"}};
    kw_out *f = kw_out_data("ex_stability"), *report = kw_claim_new("ex_stability");

    for (int degree = 2; degree <= 3; degree++) {
        double first[2] = {0, 0}, last[2] = {0, 0}; /* levels 4 and 8, HB and THB */

        kw_out_section(f, degree == 2 ? "degree 2" : "degree 3", "levels hb thb");
        for (int levels = 1; levels <= LEVELS; levels++) {
            kw_hier *b = new_bases(degree, levels);

            kw_out_number(f, levels);
            for (int kind = KW_HB; kind <= KW_THB; kind++) {
                last[kind] = condition(b, (kw_hier_kind)kind);
                kw_out_number(f, last[kind]);
                if (levels == LEVELS / 2)
                    first[kind] = last[kind];
            }
            kw_out_row(f);
            kw_hier_free(b);
        }
        for (int kind = KW_HB; kind <= KW_THB; kind++)
            kw_claim_real(report, id[degree - 2][kind], last[kind] / first[kind]);
    }
    return kw_out_close(f) | kw_out_close(report);
}
