/* Knot insertion and degree elevation -- more control points, the same curve.

   What to see: halving every span pulls the control polygon to the curve about four times
   closer each time; raising the degree does so too, but slowly.

   Book: section 1.1, the algorithms named behind the curve properties.
   Claims: bs.insert.factor, bs.elevate.factor
   Chosen here: the cubic. */

#include "claim.h"   /* what we found, for the ledger */
#include "control.h" /* splines, halved and elevated */
#include "curve.h"   /* the curves */
#include "out.h"     /* columns for gnuplot */
#include <math.h>

enum { SAMPLES = 60, ROUNDS = 8 };

/* The largest distance of a control point from the curve at its Greville point. */
static double polygon_distance(spline f)
{
    double most = 0;

    for (int j = 0; j < f.s->n; j++) {
        double p[PLANE], u, v;

        kw_curve_point(f.s, PLANE, f.c, kw_bspline_greville(f.s, j), p);
        u = p[0] - f.c[j * PLANE];
        v = p[1] - f.c[j * PLANE + 1];
        most = fmax(most, sqrt(u * u + v * v));
    }
    return most;
}

static void write_polygon(kw_out *f, const char *name, spline g)
{
    kw_out_section(f, name, "x y");
    for (int j = 0; j < g.s->n; j++) {
        kw_out_number(f, g.c[j * PLANE]);
        kw_out_number(f, g.c[j * PLANE + 1]);
        kw_out_row(f);
    }
}

static void write_curve(kw_out *f, spline g)
{
    kw_out_section(f, "curve", "x y");
    for (int q = 0; q <= 2 * SAMPLES; q++) {
        double p[PLANE];

        kw_curve_point(g.s, PLANE, g.c, (double)q / (2 * SAMPLES), p);
        kw_out_number(f, p[0]);
        kw_out_number(f, p[1]);
        kw_out_row(f);
    }
}

/* Writes the polygons of the first rounds; returns by what factor the distance of the
   polygon shrinks in the last one. */
static double write_rounds(kw_out *f, const char *const *name, spline f0,
                           spline step(spline))
{
    double before = 0, now = polygon_distance(f0);
    spline g = step(f0);

    for (int round = 1; round <= ROUNDS; round++) {
        spline next = step(g);

        if (round <= 2)
            write_polygon(f, name[round - 1], g);
        before = now;
        now = polygon_distance(g);
        free_spline(g);
        g = next;
    }
    free_spline(g);
    return before / now;
}

int main(void)
{
    enum { D = 3, CELLS = 3, N = CELLS + D };
    static const double points[N * PLANE] = {0,   0,    0.4, 2, 2.4, 2.6,
                                             3.2, -0.4, 5,   0, 5.4, 2.4};
    const char *const dyadic[] = {"halved once", "halved twice"};
    const char *const degree[] = {"degree 4", "degree 5"};
    kw_out *f = kw_out_data("ex_knot_insertion");
    kw_out *report = kw_claim_new("ex_knot_insertion");
    spline example = new_spline(kw_bspline_new_open_uniform(D, CELLS, 0, 1));

    for (int j = 0; j < N * PLANE; j++)
        example.c[j] = points[j];
    write_curve(f, example);
    write_polygon(f, "polygon", example);
    kw_claim_real(report, "bs.insert.factor",
                  write_rounds(f, dyadic, example, insert_dyadic));
    kw_claim_real(report, "bs.elevate.factor", write_rounds(f, degree, example, elevate));

    free_spline(example);
    return kw_out_close(f) | kw_out_close(report);
}
