/* Tensor-product geometries -- what they have in common with curves.

   What to see: nothing to look at. A point is an average of k_1 k_2 control points, so affine
   maps, hulls and corners behave as for curves; across a knot line of multiplicity mu the
   derivative of order d - mu + 1 is the first that jumps.

   Book: section 1.1, (11) and the text behind (10) and behind Remark 6.
   Claims: tp.product, tp.eq11.sum, tp.patch.*, tp.regularity.*
   Chosen here: the surface of ex_patch at 300 random points; random control points on the
   knot line that is double. */

#include "claim.h"  /* what we found, for the ledger */
#include "out.h"    /* reports are files */
#include "patch.h"  /* the example */
#include "rng.h"    /* points in general position */
#include "tensor.h" /* geometries */
#include <math.h>

enum { RANDOM = 300, MOST = N1 * (N2 + 1), LOCAL = 3 * 3 };

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

/* The derivative of order r in direction h of the piece on span i of that direction, at x. */
static void one_sided(const kw_tensor *g, const double *c, int h, int i, int r,
                      const double *x, double *p)
{
    double factor[2][LOCAL], *along = factor[h] + (size_t)r * 3;
    int first[2];

    first[1 - h] = kw_bspline_basis(g->s[1 - h], x[1 - h], factor[1 - h]);
    first[h] = i - g->s[h]->d;
    kw_bspline_derivatives_on(g->s[h], i, x[h], 2, factor[h]);
    for (int a = 0; a < SPACE; a++)
        p[a] = 0;
    for (int q = 0; q < LOCAL; q++) {
        const int at[2] = {q / 3, q % 3};
        const int j[2] = {first[0] + at[0], first[1] + at[1]};

        for (int a = 0; a < SPACE; a++)
            p[a] += along[at[h]] * factor[1 - h][at[1 - h]] *
                    c[kw_tensor_flat(g, j) * SPACE + a];
    }
}

/* What is taken for no jump at most, and for a jump at least. */
typedef struct jumps {
    double zero, least;
} jumps;

/* The first order of derivative in direction h, from the value on, that jumps across the knot
   line between the spans left and right of that direction, in any coordinate at any of some
   points of the line; 3 if none does. */
static int first_jump(const kw_tensor *g, const double *c, int h, int left, int right,
                      jumps *seen)
{
    const double between = 1e-6; /* see the claims on what lies on either side */

    for (int r = 0; r <= 2; r++) {
        double jump = 0;

        for (int q = 0; q <= 10; q++) {
            double x[2] = {q / 10.0, q / 10.0}, before[SPACE], behind[SPACE];

            x[h] = g->s[h]->t[right];
            one_sided(g, c, h, left, r, x, before);
            one_sided(g, c, h, right, r, x, behind);
            for (int a = 0; a < SPACE; a++)
                jump = fmax(jump, fabs(before[a] - behind[a]));
        }
        if (jump > between) {
            seen->least = fmin(seen->least, jump);
            return r;
        }
        seen->zero = fmax(seen->zero, jump);
    }
    return 3;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_tensor_properties");
    kw_tensor *g = new_patch(1), *line_twice = new_patch(2);
    kw_rng r = kw_rng_at(10, 0, 0, 0);
    findings all = {.hull = -INFINITY};
    jumps seen = {0, INFINITY};
    double c[MOST * SPACE];

    for (int i = 0; i < RANDOM; i++) {
        const double x[2] = {kw_rng_uniform(&r), kw_rng_uniform(&r)};

        look_at(g, x, &all);
        all.product = fmax(all.product, product_difference(g, x));
    }
    for (int i = 0; i < MOST * SPACE; i++)
        c[i] = 2 * kw_rng_uniform(&r) - 1;

    kw_claim_real(report, "tp.product", all.product);
    kw_claim_real(report, "tp.eq11.sum", all.sum);
    kw_claim_real(report, "tp.patch.affine", all.affine);
    kw_claim_real(report, "tp.patch.hull", all.hull);
    kw_claim_count(report, "tp.patch.active", all.active);
    kw_claim_real(report, "tp.patch.corners", corner_distance(g));
    kw_claim_count(report, "tp.regularity.1", first_jump(g, points, 0, 2, 3, &seen));
    kw_claim_count(report, "tp.regularity.2", first_jump(g, points, 1, 2, 3, &seen));
    kw_claim_count(report, "tp.regularity.double",
                   first_jump(line_twice, c, 1, 2, 4, &seen));
    kw_claim_count(report, "tp.regularity.across",
                   first_jump(line_twice, c, 0, 2, 3, &seen));
    kw_claim_real(report, "tp.regularity.zero", seen.zero);
    kw_claim_real(report, "tp.regularity.least", seen.least);

    kw_tensor_free(g);
    kw_tensor_free(line_twice);
    return kw_out_close(report);
}
