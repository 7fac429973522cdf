/* Figure 9 -- The same refinement by tensor products and by a hierarchy.

   What to see: left the smallest tensor-product mesh that has all knot lines of the mesh on the
   right, below each a mark at the Greville point of every function; the hierarchy puts its
   functions where they are wanted, the tensor product in the whole cross of rows and columns.

   Book: section 1.1, the text around Figure 9.
   Claims: hb.fig9.*
   Chosen here: the mesh, 8 x 8 cells of bi-degree (2,2); Omega^1 the cells with i+j = 4 or 5;
   Omega^2 the cells of level 1 in it with |i-j| <= 9. The book prints both counts and no
   mesh; this one gives both (ex_fig9_readings looks at others). */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* the basis */
#include "meshes.h" /* the mesh to begin with, cells for the picture */
#include "out.h"    /* columns for gnuplot */
#include "../2-tensor-product/picture.h" /* a tensor-product mesh */
#include <stdlib.h>

enum { DEGREE = 2, CELLS = 8, FIRST = 4, LAST = 5, BAND = 9, LEVELS = 3 };

static kw_mesh *new_mesh(void)
{
    kw_mesh *m = uniform_mesh(2, DEGREE, CELLS);

    for (int i = 0; i < CELLS; i++)
        for (int j = 0; j < CELLS; j++)
            if (FIRST <= i + j && i + j <= LAST)
                refine_cell(m, 0, i, j);
    for (int i = 0; i < 2 * CELLS; i++)
        for (int j = 0; j < 2 * CELLS; j++)
            if (abs(i - j) <= BAND)
                refine_cell(m, 1, i, j);
    return m;
}

/* The smallest tensor product that has all knot lines. */
static kw_tensor *new_tensor(const kw_mesh *m)
{
    kw_bspline *s[2] = {kw_mesh_new_direction(m, 0), kw_mesh_new_direction(m, 1)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);

    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return g;
}

static void write_tensor(kw_out *f, const kw_tensor *g)
{
    write_knot_lines(f, "tensor lines", g);
    kw_out_section(f, "tensor functions", "x y");
    for (int flat = 0; flat < kw_tensor_dimension(g); flat++) {
        int j[2];

        kw_tensor_multi(g, flat, j);
        for (int h = 0; h < 2; h++)
            kw_out_number(f, kw_bspline_greville(g->s[h], j[h]));
        kw_out_row(f);
    }
}

static void write_functions(kw_out *f, const kw_active *a)
{
    kw_out_section(f, "functions", "x y level");
    for (int i = 0; i < a->size; i++) {
        int level, j[KW_TENSOR_D];

        kw_active_function(a, i, &level, j);
        for (int h = 0; h < 2; h++)
            kw_out_number(f, kw_bspline_greville(a->mesh->level[level].s[h], j[h]));
        kw_out_number(f, level);
        kw_out_row(f);
    }
}

/* How many cells and functions: a row for the tensor product, then one for each level. */
static void write_counts(kw_out *f, const kw_tensor *g, const kw_active *a)
{
    kw_out_section(f, "counts", "count_cells count_functions");
    kw_out_number(f, count_cells(g));
    kw_out_number(f, kw_tensor_dimension(g));
    kw_out_row(f);
    for (int level = 0; level < LEVELS; level++) {
        kw_out_number(f, (double)kw_mesh_active(a->mesh, level));
        kw_out_number(f, a->start[level + 1] - a->start[level]);
        kw_out_row(f);
    }
}

int main(void)
{
    static const char *const of_level[LEVELS] = {"hb.fig9.level0", "hb.fig9.level1",
                                                 "hb.fig9.level2"};
    kw_out *f = kw_out_data("fig09"), *report = kw_claim_new("fig09");
    kw_mesh *m = new_mesh();
    kw_hier *b = kw_hier_new(m);
    const kw_active *a = b->active;
    kw_tensor *g = new_tensor(m);

    write_counts(f, g, a);
    write_tensor(f, g);
    write_cells(f, "cells", b, NULL);
    write_functions(f, a);

    kw_claim_count(report, "hb.fig9.tensor", kw_tensor_dimension(g));
    kw_claim_count(report, "hb.fig9.hierarchical", a->size);
    kw_claim_count(report, "hb.fig9.kraft", kw_active_kraft(m));
    kw_claim_count(report, "hb.fig9.levels", m->levels);
    for (int level = 0; level < LEVELS; level++)
        kw_claim_count(report, of_level[level], a->start[level + 1] - a->start[level]);
    kw_claim_count(report, "hb.fig9.split",
                   (kw_mesh_active(m, 1) + m->level[1].count) / m->level[0].count);

    kw_tensor_free(g);
    kw_hier_free(b);
    kw_mesh_free(m);
    return kw_out_close(f) | kw_out_close(report);
}
