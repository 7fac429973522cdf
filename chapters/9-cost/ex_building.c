/* Building -- operations of a THB basis, as levels are added along the diagonal of a mesh.

   What to see: cells and operations for each function go to a constant, although every level more
   splits the support of a coarse function into four times as many cells. On some cells functions of
   all levels overlap, but the more of them there are, the fewer are the cells.

   Book: section 1.1, Definition 5, (15), (16).
   Claims: cost.build.*
   Chosen here: meshes of 8 x 8 cells refined where |i-j| <= d, degree 2. */

#include "claim.h"      /* what we found, for the ledger */
#include "counted.h"    /* arithmetic that counts itself */
#include "diagonal.h"   /* meshes */
#include "hier.h"       /* the basis that the library builds */
#include "need.h"       /* memory */
#include "truncation.h" /* its table of a cell, from level to level */
#include <math.h>
#include <stdio.h>

enum {
    D = 2,
    DEGREE = 2,
    K = DEGREE + 1,
    LOCAL = K * K,
    CELLS = 8,
    MOST = 11, /* levels */
    FROM = 13  /* functions that a cell carries: from there on such cells get fewer */
};

/* A walk through the tree of cells as the library makes it, with the table of THB-splines and the
   two-scale matrices of a cell of each level. */
typedef struct walk {
    kw_hier *b;
    kw_truncation *table[MOST];
    kw_twoscale halves[MOST];
    tally t;
    int differ; /* what is not the library's */
} walk;

/* The two-scale matrices of a refined cell: a triangle a row. */
static void count_halves(walk *w, int level, const int *cell)
{
    const kw_mesh_level *coarse = &w->b->active->mesh->level[level], *fine = coarse + 1;
    kw_twoscale *halves = &w->halves[level];

    kw_twoscale_of_cell(w->b->active->mesh, level, cell, halves);
    for (int h = 0; h < D; h++)
        for (int half = 0; half < 2; half++)
            for (int f = 0; f < K; f++) {
                int first = fine->span[h][2 * cell[h] + half] - DEGREE + f;
                double row[K] = {0};

                blossom_by_triangle(&w->t, coarse->s[h], coarse->span[h][cell[h]],
                                    fine->s[h]->t + first + 1, row);
                w->differ += differing(K, row, halves->a[h][half] + f * K);
            }
}

/* Does Definition 5 cut off all that coarser functions have on a cell? Then nothing is computed. */
static int all_cut_off(const int *is)
{
    int cut = 0;

    for (int f = 0; f < LOCAL; f++)
        cut += is[f] >= KW_ACTIVE_COVERED;
    return cut == LOCAL;
}

/* The table of a child: a product and a sum for each number of its parent's table and each entry
   of the matrices that is not zero, one direction after the other. */
static void count_child(walk *w, int level, int child, const int *is)
{
    const kw_truncation *parent = w->table[level - 1];
    const kw_twoscale *halves = &w->halves[level - 1];
    int lines = parent->count * LOCAL / K;

    kw_truncation_refine(parent, halves, child, is, w->table[level]);
    for (int h = 0; h < D && !all_cut_off(is); h++)
        for (int e = 0; e < K * K; e++)
            if (halves->a[h][child >> h & 1][e] != 0) {
                w->t.products += lines;
                w->t.sums += lines;
            }
}

static void descend(walk *w, int node, int level, int child, const int *cell)
{
    int is[LOCAL], first = w->b->tree->node[node].child;

    kw_active_of_cell(w->b->active, level, cell, is);
    w->table[level]->count = 0;
    if (level > 0)
        count_child(w, level, child, is);
    if (first < 0) {
        w->differ += w->table[level]->count != w->b->leaf[-1 - first].carried;
        return;
    }
    kw_truncation_add(w->table[level], is);
    count_halves(w, level, cell);
    for (int c = 0; c < 1 << D; c++) {
        const int at[] = {2 * cell[0] + (c & 1), 2 * cell[1] + (c >> 1)};

        descend(w, first + c, level + 1, c, at);
    }
}

/* Active cells that carry so many THB-splines of coarser levels, or more. */
static int cells_that_carry(const kw_hier *b, int least)
{
    int count = 0;

    for (int i = 0; i < b->tree->leaves; i++)
        count += b->leaf[i].carried >= least;
    return count;
}

/* The most that is left of the cells that carry so many, when three more are asked for. */
static double left_of(const kw_hier *b, int least)
{
    double most = 0;

    for (; cells_that_carry(b, least) > 0; least += 3)
        most = fmax(most,
                    (double)cells_that_carry(b, least + 3) / cells_that_carry(b, least));
    return most;
}

static int most_carried(const kw_hier *b)
{
    int most = 0;

    while (cells_that_carry(b, most + 1) > 0)
        most++;
    return most;
}

static void count_building(walk *w, int levels)
{
    for (int l = 0; l < levels; l++)
        w->table[l] = kw_truncation_new(LOCAL);
    for (int i = 0; i < CELLS * CELLS; i++)
        descend(w, i, 0, 0, (const int[]){i / CELLS, i % CELLS});
    for (int l = 0; l < levels; l++)
        kw_truncation_free(w->table[l]);
}

/* --- reports --- */

enum { ID = 40 };

static const char *id_of(const char *what, int levels, char *id)
{
    snprintf(id, ID, "cost.build.%s.%d", what, levels);
    return id;
}

static void report_building(kw_out *report, int levels, const kw_hier *b, const tally *t)
{
    const double size = b->active->size;
    char id[ID];

    kw_claim_count(report, id_of("functions", levels, id), b->active->size);
    kw_claim_real(report, id_of("cells", levels, id), b->tree->nodes / size);
    kw_claim_real(report, id_of("operations", levels, id), (double)operations(t) / size);
    kw_claim_real(report, id_of("carried", levels, id),
                  (double)b->indices / b->tree->leaves);
    kw_claim_count(report, id_of("most", levels, id), most_carried(b));
    if (levels == MOST)
        kw_claim_real(report, "cost.build.fewer", left_of(b, FROM));
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_building");
    int differ = 0;

    for (int levels = 2; levels <= MOST; levels += 3) {
        kw_mesh *m = new_diagonal(DEGREE, CELLS, levels - 1);
        walk w = {.b = kw_hier_new(m)};

        count_building(&w, levels);
        report_building(report, levels, w.b, &w.t);
        differ += w.differ;
        kw_hier_free(w.b);
        kw_mesh_free(m);
    }
    kw_claim_count(report, "cost.build.differ", differ);
    return kw_out_close(report);
}
