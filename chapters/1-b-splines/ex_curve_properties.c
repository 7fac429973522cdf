/* Curve properties -- affine invariance and convex hulls.

   What to see: each span of the curve stays inside the hull of its own k control points, and
   two neighbouring spans share all of these points but one.

   Book: section 1.1, (9), the three properties of B-spline curves.
   Claims: bs.list2.affine, bs.list2.convex, bs.list2.hull
   Chosen here: 200 random open spaces with random control points; the cubic in the picture. */

#include "bspline.h"   /* the functions */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* the curves */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random knots */
#include <math.h>

enum {
    CASES = 200,
    K = PARTITION_D + 1,
    POINTS = 20, /* of one span */
    PLANE = 2
};

/* What should hold everywhere, and how far it fails at most. */
typedef struct findings {
    double affine, convex, hull;
} findings;

/* Random control points in [-1,1]^2. */
static void random_points(uint64_t i, int n, double *c)
{
    kw_rng r = kw_rng_at(5, 0, i, 0);

    for (int j = 0; j < n * PLANE; j++)
        c[j] = 2 * kw_rng_uniform(&r) - 1;
}

/* y = A x + v */
static void affine_map(const double *x, double *y)
{
    y[0] = 2 * x[0] - 3 * x[1] + 5;
    y[1] = x[0] + 4 * x[1] - 7;
}

static double affine_error(const kw_bspline *s, const double *c, double x)
{
    double mapped[PARTITION_N * PLANE], point[PLANE], first[PLANE], then[PLANE];

    for (int j = 0; j < s->n; j++)
        affine_map(c + j * PLANE, mapped + j * PLANE);
    kw_curve_point(s, PLANE, c, x, point);
    affine_map(point, first);
    kw_curve_point(s, PLANE, mapped, x, then);
    return fmax(fabs(first[0] - then[0]), fabs(first[1] - then[1]));
}

/* How far the point lies outside the hull of the k control points of span i: the largest
   excess over them in 31 directions. */
static double outside_hull(const kw_bspline *s, const double *c, int i,
                           const double *point)
{
    double excess = -INFINITY;

    for (int a = -8; a < 8; a++)
        for (int side = -1; side <= 1; side += 2) {
            double u = a, v = side * (8 - fabs((double)a)), most = -INFINITY;

            for (int j = i - s->d; j <= i; j++)
                most = fmax(most, u * c[j * PLANE] + v * c[j * PLANE + 1]);
            excess = fmax(excess, u * point[0] + v * point[1] - most);
        }
    return excess;
}

static void look_at_span(const kw_bspline *s, const double *c, int i, findings *all)
{
    for (int q = 0; q < POINTS; q++) {
        double x = s->t[i] + (s->t[i + 1] - s->t[i]) * (q + 0.5) / POINTS;
        double value[K], point[PLANE], sum = 0, least = 0;

        kw_bspline_basis(s, x, value);
        for (int j = 0; j <= s->d; j++) {
            sum += value[j];
            least = fmin(least, value[j]);
        }
        kw_curve_point(s, PLANE, c, x, point);
        all->affine = fmax(all->affine, affine_error(s, c, x));
        all->convex = fmax(all->convex, fmax(fabs(sum - 1), -least));
        all->hull = fmax(all->hull, outside_hull(s, c, i, point));
    }
}

/* The picture: a cubic with five spans; the hull of four points is the union of the
   triangles that they form. */
static void write_picture(kw_out *f)
{
    enum { D = 3, CELLS = 5, N = CELLS + D };
    static const double c[N * PLANE] = {0,   0,   0.5, 1.8, 1.7, 2.6, 3.1, 1.9,
                                        3.6, 0.3, 5,   0,   6.2, 1.1, 6.6, 2.6};
    kw_bspline *s = kw_bspline_new_open_uniform(D, CELLS, 0, 1);

    kw_out_section(f, "triangles", "x y span");
    for (int i = D; i < N; i++)
        for (int without = 0; without <= D; without++) {
            for (int j = 0; j <= D; j++) {
                if (j == without)
                    continue;
                kw_out_number(f, c[(i - D + j) * PLANE]);
                kw_out_number(f, c[(i - D + j) * PLANE + 1]);
                kw_out_number(f, i - D);
                kw_out_row(f);
            }
            kw_out_gap(f);
        }
    kw_out_section(f, "curve", "x y span");
    for (int i = D; i < N; i++) {
        for (int q = 0; q <= POINTS; q++) {
            double x = fmin(s->t[i] + (s->t[i + 1] - s->t[i]) * q / POINTS, 1);
            double point[PLANE];

            kw_curve_point(s, PLANE, c, x, point);
            kw_out_number(f, point[0]);
            kw_out_number(f, point[1]);
            kw_out_number(f, i - D);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    kw_out_section(f, "polygon", "x y");
    for (int j = 0; j < N; j++) {
        kw_out_number(f, c[j * PLANE]);
        kw_out_number(f, c[j * PLANE + 1]);
        kw_out_row(f);
    }
    kw_bspline_free(s);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_curve_properties");
    kw_out *report = kw_claim_new("ex_curve_properties");
    findings all = {.affine = 0, .hull = -INFINITY};
    double c[PARTITION_N * PLANE] = {0};

    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(6, i);
        kw_bspline *s = partition_space(&p);

        random_points(i, s->n, c);
        for (int span = s->d; span < s->n; span++)
            if (s->t[span] < s->t[span + 1])
                look_at_span(s, c, span, &all);
        kw_bspline_free(s);
    }
    write_picture(f);

    kw_claim_real(report, "bs.list2.affine", all.affine);
    kw_claim_real(report, "bs.list2.convex", all.convex);
    kw_claim_real(report, "bs.list2.hull", all.hull);
    return kw_out_close(f) | kw_out_close(report);
}
