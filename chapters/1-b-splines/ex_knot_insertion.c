/* Knot insertion and degree elevation -- more control points, the same curve.

   What to see: halving every span pulls the control polygon to the curve about four times
   closer each time; raising the degree does so too, but slowly.

   Book: section 1.1, the algorithms named behind the curve properties.
   Claims: bs.insert.*, bs.elevate.*
   Chosen here: 100 random spaces with random control points; the cubic in the picture. */

#include "bspline.h"   /* the spaces */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* the curves */
#include "elevate.h"   /* one degree more */
#include "insert.h"    /* more knots */
#include "need.h"      /* memory */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random knots */
#include <math.h>
#include <stdlib.h>

enum { CASES = 100, SAMPLES = 60, PLANE = 2, ROUNDS = 8 };

/* A spline: a space and its control points in the plane, both owned. */
typedef struct spline {
    kw_bspline *s;
    double *c;
} spline;

static spline new_spline(kw_bspline *s)
{
    spline f = {s, kw_need_memory((size_t)s->n * PLANE, sizeof(double))};

    return f;
}

static void free_spline(spline f)
{
    kw_bspline_free(f.s);
    free(f.c);
}

static spline insert_one(spline f, double x)
{
    spline g = new_spline(kw_insert_new_knot(f.s, x));

    kw_insert_boehm(f.s, x, PLANE, f.c, g.c);
    return g;
}

static spline insert_dyadic(spline f)
{
    spline g = new_spline(kw_insert_new_dyadic(f.s));

    kw_insert_oslo(f.s, g.s, PLANE, f.c, g.c);
    return g;
}

static spline elevate(spline f)
{
    spline g = new_spline(kw_elevate_new(f.s));

    kw_elevate(f.s, g.s, PLANE, f.c, g.c);
    return g;
}

/* The largest distance of two curves over the common domain. */
static double curve_distance(spline f, spline g)
{
    double a = f.s->t[f.s->d], b = f.s->t[f.s->n], most = 0;

    for (int q = 0; q <= SAMPLES; q++) {
        double x = q == SAMPLES ? b : a + (b - a) * q / SAMPLES, p[PLANE], r[PLANE];

        kw_curve_point(f.s, PLANE, f.c, x, p);
        kw_curve_point(g.s, PLANE, g.c, x, r);
        most = fmax(most, fmax(fabs(p[0] - r[0]), fabs(p[1] - r[1])));
    }
    return most;
}

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

/* What should be zero, and by how much it is not. */
typedef struct findings {
    double boehm, oslo, dyadic, elevated, row_sum, least;
} findings;

/* One knot after the other at the middle of every span, by Boehm's rule; the result must be
   that of all at once, by the Oslo rows. */
static void try_insertion(spline f, findings *all)
{
    spline fine = insert_dyadic(f),
           slow = insert_one(f, (f.s->t[f.s->d] + f.s->t[f.s->d + 1]) / 2);

    for (int i = f.s->d + 1; i < f.s->n; i++)
        if (f.s->t[i] < f.s->t[i + 1]) {
            double middle = f.s->t[i] + (f.s->t[i + 1] - f.s->t[i]) / 2;
            spline next = insert_one(slow, middle);

            free_spline(slow);
            slow = next;
        }
    for (int j = 0; j < fine.s->n * PLANE; j++)
        all->oslo = fmax(all->oslo, fabs(fine.c[j] - slow.c[j]));
    for (int i = 0; i < fine.s->n; i++) {
        double alpha[PARTITION_D + 1], sum = 0;

        kw_insert_oslo_row(f.s, fine.s, i, alpha);
        for (int j = 0; j <= f.s->d; j++) {
            sum += alpha[j];
            all->least = fmin(all->least, alpha[j]);
        }
        all->row_sum = fmax(all->row_sum, fabs(sum - 1));
    }
    all->boehm = fmax(all->boehm, curve_distance(f, slow));
    all->dyadic = fmax(all->dyadic, curve_distance(f, fine));
    free_spline(fine);
    free_spline(slow);
}

static void try_random_spaces(findings *all)
{
    for (uint64_t i = 0; i < CASES; i++) {
        partition p = random_partition(7, i);
        kw_rng r = kw_rng_at(8, 0, i, 0);
        spline f = new_spline(partition_space(&p)), higher;

        for (int j = 0; j < f.s->n * PLANE; j++)
            f.c[j] = 2 * kw_rng_uniform(&r) - 1;
        try_insertion(f, all);
        higher = elevate(f);
        all->elevated = fmax(all->elevated, curve_distance(f, higher));
        free_spline(higher);
        free_spline(f);
    }
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
    findings all = {0, 0, 0, 0, 0, 0};

    for (int j = 0; j < N * PLANE; j++)
        example.c[j] = points[j];
    write_curve(f, example);
    write_polygon(f, "polygon", example);
    kw_claim_real(report, "bs.insert.factor",
                  write_rounds(f, dyadic, example, insert_dyadic));
    kw_claim_real(report, "bs.elevate.factor", write_rounds(f, degree, example, elevate));

    try_random_spaces(&all);
    kw_claim_real(report, "bs.insert.boehm", all.boehm);
    kw_claim_real(report, "bs.insert.oslo", all.oslo);
    kw_claim_real(report, "bs.insert.dyadic", all.dyadic);
    kw_claim_real(report, "bs.insert.rows", all.row_sum);
    kw_claim_real(report, "bs.insert.least", all.least);
    kw_claim_real(report, "bs.elevate.curve", all.elevated);

    free_spline(example);
    return kw_out_close(f) | kw_out_close(report);
}
