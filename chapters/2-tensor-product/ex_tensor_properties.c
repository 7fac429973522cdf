/* Tensor-product geometries -- what they have in common with curves.

   What to see: nothing to look at. A point is an average of k_1 k_2 control points, so affine
   maps, hulls and corners behave as for curves.

   Book: section 1.1, (11) and the text behind Remark 6.
   Claims: tp.product, tp.eq11.sum, tp.patch.*
   Chosen here: the surface of ex_patch at 300 random points. */

#include "claim.h"  /* what we found, for the ledger */
#include "out.h"    /* reports are files */
#include "patch.h"  /* the example */
#include "rng.h"    /* points in general position */
#include "tensor.h" /* geometries */
#include <math.h>

enum { RANDOM = 300, LOCAL = 3 * 3 };

typedef struct findings {
    double product, sum, affine, hull;
    int active;
} findings;

/* How far p lies outside the hull of the control points c[0..count-1]: the largest excess
   over them in 124 directions. */
static double outside_hull(int count, const double *const *c, const double *p)
{
    double excess = -INFINITY;

    for (int direction = 0; direction < 125; direction++) {
        const int step[SPACE] = {direction / 25, direction / 5 % 5, direction % 5};
        const double u[SPACE] = {step[0] - 2, step[1] - 2, step[2] - 2};
        double most = -INFINITY;

        if (u[0] == 0 && u[1] == 0 && u[2] == 0)
            continue;
        for (int i = 0; i < count; i++)
            most = fmax(most, u[0] * c[i][0] + u[1] * c[i][1] + u[2] * c[i][2]);
        excess = fmax(excess, u[0] * p[0] + u[1] * p[1] + u[2] * p[2] - most);
    }
    return excess;
}

/* An affine map into the line. */
static double map(const double *p)
{
    return 2 * p[0] - 3 * p[1] + p[2] + 7;
}

/* The point at x against the sum over all functions: the control points that count, their
   hull, and their images under an affine map. */
static void look_at(const kw_tensor *g, const double *x, findings *all)
{
    const double *active[POINTS];
    double p[SPACE], sum[SPACE] = {0}, mapped = 0;
    int count = 0;

    kw_tensor_point(g, SPACE, points, NULL, x, p);
    for (int flat = 0; flat < POINTS; flat++) {
        const double *c = points + flat * SPACE;
        int j[2];
        double value;

        kw_tensor_multi(g, flat, j);
        value = kw_tensor_one(g, j, NULL, x);
        if (value == 0)
            continue;
        active[count++] = c;
        mapped += value * map(c);
        for (int a = 0; a < SPACE; a++)
            sum[a] += value * c[a];
    }
    all->active = count > all->active ? count : all->active;
    all->affine = fmax(all->affine, fabs(mapped - map(p)));
    all->hull = fmax(all->hull, outside_hull(count, active, p));
    for (int a = 0; a < SPACE; a++)
        all->sum = fmax(all->sum, fabs(sum[a] - p[a]));
}

/* A function of the basis is the product of its factors, each in its own direction. */
static double product_difference(const kw_tensor *g, const double *x)
{
    double local[LOCAL], most = 0;
    int first[2];

    kw_tensor_basis(g, NULL, x, first, local);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            most = fmax(most, fabs(local[a * 3 + b] -
                                   kw_bspline_one(g->s[0], first[0] + a, 0, x[0]) *
                                       kw_bspline_one(g->s[1], first[1] + b, 0, x[1])));
    return most;
}

/* The corner points of the surface are corner control points. */
static double corner_distance(const kw_tensor *g)
{
    double most = 0;

    for (int corner = 0; corner < 4; corner++) {
        const int end[2] = {corner / 2, corner % 2};
        const double x[2] = {end[0], end[1]};
        const int j[2] = {end[0] * (N1 - 1), end[1] * (N2 - 1)};
        double p[SPACE];

        kw_tensor_point(g, SPACE, points, NULL, x, p);
        for (int a = 0; a < SPACE; a++)
            most = fmax(most, fabs(p[a] - points[kw_tensor_flat(g, j) * SPACE + a]));
    }
    return most;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_tensor_properties");
    kw_tensor *g = new_patch(1);
    kw_rng r = kw_rng_at(10, 0, 0, 0);
    findings all = {.hull = -INFINITY};

    for (int i = 0; i < RANDOM; i++) {
        const double x[2] = {kw_rng_uniform(&r), kw_rng_uniform(&r)};

        look_at(g, x, &all);
        all.product = fmax(all.product, product_difference(g, x));
    }
    kw_claim_real(report, "tp.product", all.product);
    kw_claim_real(report, "tp.eq11.sum", all.sum);
    kw_claim_real(report, "tp.patch.affine", all.affine);
    kw_claim_real(report, "tp.patch.hull", all.hull);
    kw_claim_count(report, "tp.patch.active", all.active);
    kw_claim_real(report, "tp.patch.corners", corner_distance(g));

    kw_tensor_free(g);
    return kw_out_close(report);
}
