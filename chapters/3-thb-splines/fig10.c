/* Figure 10 -- Truncation of one B-spline of degree 4.

   What to see: the coarse function (dashed) is the sum of its five finer ones (thin), each times
   its coefficient; the two that live in Omega^1 (dotted; their supports are seen below) are left
   out, and the rest is the truncated function (thick), which is the old one outside the domain
   and lower inside.

   Book: section 1.1, Definition 5, (15).
   Claims: thb.fig10.*
   Chosen here: the function next to the left end whose knots are 0,0,1,2,3,4, and
   Omega^1 = [1,4]. It has five finer functions, as the book prints; one in the interior has six
   (ERRATA.md, ER-16). */

#include "claim.h"   /* what we found, for the ledger */
#include "hiergeo.h" /* the truncated function in finer ones */
#include "insert.h"  /* the finer functions of a coarse one */
#include "meshes.h"  /* the mesh to begin with */
#include "out.h"     /* columns for gnuplot */
#include <math.h>

enum {
    DEGREE = 4,
    CELLS = 8,
    LOW = 1,
    HIGH = 4,
    BOUNDARY = 3,
    INTERIOR = 5,
    SAMPLES = 320
};

/* The mesh on [0, CELLS] with Omega^1 = [LOW, HIGH]. */
static kw_mesh *new_mesh(void)
{
    kw_bspline *s = kw_bspline_new_open_uniform(DEGREE, CELLS, 0, CELLS);
    kw_tensor *g = kw_tensor_new(1, (const kw_bspline *const *)&s);
    kw_mesh *m = kw_mesh_new(g);

    refine_interval(m, 0, LOW, HIGH);
    kw_tensor_free(g);
    kw_bspline_free(s);
    return m;
}

static void write_value(kw_out *f, double x, double value, double number)
{
    kw_out_number(f, x);
    kw_out_number(f, value);
    kw_out_number(f, number);
    kw_out_row(f);
}

/* The finer functions, each times its coefficient; `left` of them are not truncated. */
static void write_children(kw_out *f, const kw_bspline *fine, int first, int count,
                           const double *c, int left)
{
    kw_out_section(f, "children", "x value truncated");
    for (int i = 0; i < count; i++) {
        for (int q = 0; q <= SAMPLES; q++) {
            double x = (double)CELLS * q / SAMPLES;

            if (fine->t[first + i] <= x && x <= fine->t[first + i + DEGREE + 1])
                write_value(f, x, c[i] * kw_bspline_one(fine, first + i, 0, x),
                            i >= left);
        }
        kw_out_gap(f);
    }
}

/* Where the finer functions live, and their coefficients. */
static void write_supports(kw_out *f, const kw_bspline *fine, int first, int count,
                           const double *c, int left)
{
    kw_out_section(f, "supports", "number low high coefficient truncated");
    for (int i = 0; i < count; i++) {
        kw_out_number(f, i);
        kw_out_number(f, fine->t[first + i]);
        kw_out_number(f, fine->t[first + i + DEGREE + 1]);
        kw_out_number(f, c[i]);
        kw_out_number(f, i >= left);
        kw_out_row(f);
    }
}

int main(void)
{
    static const char *const id[] = {"thb.fig10.c0", "thb.fig10.c1", "thb.fig10.c2",
                                     "thb.fig10.c3", "thb.fig10.c4"};
    kw_out *f = kw_out_data("fig10"), *report = kw_claim_new("fig10");
    kw_mesh *m = new_mesh();
    kw_hier *b = kw_hier_new(m);
    const kw_bspline *coarse = m->level[0].s[0], *fine = m->level[1].s[0];
    double c[DEGREE + 2], unused[DEGREE + 2], *truncated, changed = 0;
    int boundary = BOUNDARY, function, first, other, count, left_first, left;

    count = kw_insert_two_scale(coarse, fine, BOUNDARY, &first, c);
    function = kw_active_find(b->active, 0, &boundary);
    kw_hiergeo_new_representation(b, function, &left_first, &left, &truncated);
    while (left > 0 && truncated[left - 1] == 0)
        left--;
    write_children(f, fine, first, count, c, left);
    write_supports(f, fine, first, count, c, left);
    kw_out_section(f, "function", "x coarse truncated");
    for (int q = 0; q <= SAMPLES; q++) {
        double x = (double)CELLS * q / SAMPLES,
               old = kw_bspline_one(coarse, BOUNDARY, 0, x);
        double new = kw_hier_one(b, KW_THB, function, NULL, &x);

        if (x <= LOW)
            changed = fmax(changed, fabs(new - old));
        if (x <= coarse->t[BOUNDARY + DEGREE + 1])
            write_value(f, x, old, new);
    }
    kw_out_section(f, "domain", "low high");
    kw_out_number(f, LOW);
    kw_out_number(f, HIGH);
    kw_out_row(f);

    kw_claim_count(report, "thb.fig10.children", count);
    kw_claim_count(report, "thb.fig10.truncated", count - left);
    for (int i = 0; i < count; i++)
        kw_claim_real(report, id[i], c[i]);
    kw_claim_real(report, "thb.fig10.outside", changed);
    kw_claim_count(report, "thb.fig10.interior",
                   kw_insert_two_scale(coarse, fine, INTERIOR, &other, unused));

    free(truncated);
    kw_hier_free(b);
    kw_mesh_free(m);
    return kw_out_close(f) | kw_out_close(report);
}
