/* Figure 5 -- A planar and a spatial B-spline curve with their control polygons.

   What to see: the curve starts at the first control point, ends at the last and follows
   the polygon in between, past the other points; moving one point would move the curve on
   at most k spans.

   Book: section 1.1, (9), Remark 5.
   Claims: bs.eq9.*, bs.fig5.*
   Chosen here: degree 3, open uniform knots, all control points. */

#include "bspline.h" /* the space */
#include "claim.h"   /* what we found, for the ledger */
#include "curve.h"   /* the curve, by sum and by averaging */
#include "out.h"     /* columns for gnuplot */
#include <math.h>

enum { D = 3, CELLS = 5, POINTS = CELLS + D, SAMPLES = 150, PLANE = 2, SPACE = 3 };

static const double planar[POINTS * PLANE] = {0, 0,   0.6, 2.2, 2.2, 2.6, 2.8, 0.4,
                                              4, 0.2, 4.6, 2.4, 6.2, 2.2, 6.6, 0.6};

/* two turns of a square screw */
static const double spatial[POINTS * SPACE] = {1,   0,  0,  1,   1,   0.4, -1,  1,
                                               0.8, -1, -1, 1.2, 1,   -1,  1.6, 1,
                                               1,   2,  -1, 1,   2.4, -1,  0,   2.8};

static void write_points(kw_out *f, const char *name, const char *columns, int count,
                         int N, const double *point)
{
    kw_out_section(f, name, columns);
    for (int i = 0; i < count; i++) {
        for (int a = 0; a < N; a++)
            kw_out_number(f, point[i * N + a]);
        kw_out_row(f);
    }
}

/* The largest distance of two arrays, entry by entry. */
static double distance(int count, const double *a, const double *b)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

int main(void)
{
    kw_out *f = kw_out_data("fig05"), *report = kw_claim_new("fig05");
    kw_bspline *s = kw_bspline_new_open_uniform(D, CELLS, 0, 1);
    double x[SAMPLES + 1], curve[(SAMPLES + 1) * SPACE], again[(SAMPLES + 1) * SPACE];
    double difference, ends;

    for (int i = 0; i <= SAMPLES; i++)
        x[i] = (double)i / SAMPLES;

    kw_curve_point_many(s, PLANE, planar, SAMPLES + 1, x, curve);
    kw_curve_deboor_many(s, PLANE, planar, SAMPLES + 1, x, again);
    difference = distance((SAMPLES + 1) * PLANE, curve, again);
    ends = fmax(distance(PLANE, curve, planar),
                distance(PLANE, curve + SAMPLES * PLANE, planar + (POINTS - 1) * PLANE));
    write_points(f, "planar polygon", "x y", POINTS, PLANE, planar);
    write_points(f, "planar curve", "x y", SAMPLES + 1, PLANE, curve);

    kw_curve_point_many(s, SPACE, spatial, SAMPLES + 1, x, curve);
    kw_curve_deboor_many(s, SPACE, spatial, SAMPLES + 1, x, again);
    difference = fmax(difference, distance((SAMPLES + 1) * SPACE, curve, again));
    ends = fmax(ends, distance(SPACE, curve, spatial));
    ends = fmax(ends,
                distance(SPACE, curve + SAMPLES * SPACE, spatial + (POINTS - 1) * SPACE));
    write_points(f, "spatial polygon", "x y z", POINTS, SPACE, spatial);
    write_points(f, "spatial curve", "x y z", SAMPLES + 1, SPACE, curve);

    kw_claim_real(report, "bs.eq9.deboor", difference);
    kw_claim_real(report, "bs.fig5.ends", ends);
    kw_claim_count(report, "bs.fig5.points", s->n);

    kw_bspline_free(s);
    return kw_out_close(f) | kw_out_close(report);
}
