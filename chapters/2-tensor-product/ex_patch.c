/* Tensor-product geometries -- a planar patch and a surface, and what curves have too.

   What to see: left a patch in the plane, right a surface in space, both bi-quadratic; their
   corners are corner control points, and the net of control points foreshadows the shape.

   Book: section 1.1, (11) and the text behind Remark 6.
   Claims: tp.product, tp.eq11.*, tp.patch.*, tp.regularity
   Chosen here: bi-degree (2,2), the knots and all control points. */

#include "claim.h"   /* what we found, for the ledger */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "picture.h" /* rows of three numbers */
#include "rng.h"     /* points in general position */
#include "tensor.h"  /* the geometries */
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { N1 = 5, N2 = 4, POINTS = N1 * N2, LINES = 10, FINE = 40, SPACE = 3, RANDOM = 300 };

/* Control points of the patch in the plane and, with their heights, of the surface. */
static const double points[POINTS * SPACE] = {
    0,   0,    0,   -0.3, 1,   0.4, -0.2, 2,   0.6, 0.2, 3,   0.2, /* j_1 = 0 */
    1,   -0.4, 0.6, 0.9,  0.8, 1.6, 1.1,  2.1, 1.4, 1.2, 3.3, 0.6, /* j_1 = 1 */
    2.1, -0.5, 0.4, 2,    0.9, 0.2, 2.2,  2.2, 0.4, 2.1, 3.5, 0.8, /* j_1 = 2 */
    3.2, -0.1, 0.8, 3,    1,   1.2, 3.1,  2,   1.6, 3.3, 3.2, 1,   /* j_1 = 3 */
    4,   0.3,  0.2, 4.3,  1.2, 0.6, 4.4,  2.1, 0.4, 4.1, 2.8, 0};  /* j_1 = 4 */

static kw_tensor *new_space(void)
{
    const double knots1[] = {0, 0.4, 0.7, 1}, knots2[] = {0, 0.5, 1};
    kw_bspline *s[2] = {kw_bspline_new_open(2, 3, knots1, NULL),
                        kw_bspline_new_open(2, 2, knots2, NULL)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);

    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    return g;
}

/* Lines of constant x_1, then of constant x_2, of the patch in the plane. */
static void write_lines(kw_out *f, const kw_tensor *g)
{
    kw_out_section(f, "lines", "x y z");
    for (int h = 0; h < 2; h++)
        for (int line = 0; line <= LINES; line++) {
            for (int i = 0; i <= FINE; i++) {
                double x[2], p[SPACE];

                x[h] = (double)line / LINES;
                x[1 - h] = (double)i / FINE;
                kw_tensor_point(g, SPACE, points, NULL, x, p);
                write_row3(f, p[0], p[1], p[2]);
            }
            kw_out_gap(f);
        }
}

static void write_net(kw_out *f, const kw_tensor *g)
{
    kw_out_section(f, "net", "x y z");
    for (int h = 0; h < 2; h++)
        for (int line = 0; line < g->s[h]->n; line++) {
            for (int i = 0; i < g->s[1 - h]->n; i++) {
                int j[2];
                const double *p;

                j[h] = line;
                j[1 - h] = i;
                p = points + kw_tensor_flat(g, j) * SPACE;
                write_row3(f, p[0], p[1], p[2]);
            }
            kw_out_gap(f);
        }
}

/* The control points that count at x are those of 3 x 3 functions: the point lies between
   their least and largest coordinates, and it is their sum with weights. */
typedef struct findings {
    double sum, affine, box;
    int active;
} findings;

static void look_at(const kw_tensor *g, const double *x, findings *all)
{
    double p[SPACE], sum[SPACE] = {0}, mapped = 0, low[SPACE], high[SPACE];
    int active = 0;

    for (int a = 0; a < SPACE; a++) {
        low[a] = DBL_MAX;
        high[a] = -DBL_MAX;
    }
    kw_tensor_point(g, SPACE, points, NULL, x, p);
    for (int flat = 0; flat < POINTS; flat++) {
        const double *c = points + flat * SPACE;
        int j[2];
        double value;

        kw_tensor_multi(g, flat, j);
        value = kw_tensor_one(g, j, NULL, x);
        if (value == 0)
            continue;
        active++;
        mapped += value * (2 * c[0] - 3 * c[1] + c[2] + 7); /* an affine map of c */
        for (int a = 0; a < SPACE; a++) {
            sum[a] += value * c[a];
            low[a] = fmin(low[a], c[a]);
            high[a] = fmax(high[a], c[a]);
        }
    }
    all->active = active > all->active ? active : all->active;
    all->affine = fmax(all->affine, fabs(mapped - (2 * p[0] - 3 * p[1] + p[2] + 7)));
    for (int a = 0; a < SPACE; a++) {
        all->sum = fmax(all->sum, fabs(sum[a] - p[a]));
        all->box = fmax(all->box, fmax(low[a] - p[a], p[a] - high[a]));
    }
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

/* Writes the surface on a grid, by sum factorization; returns how far that is from the sum
   point by point. */
static double write_grid(kw_out *f, const kw_tensor *g)
{
    enum { M = 2 * LINES + 1 };
    const int count[2] = {M, M};
    double x1[M], grid[M * M * SPACE], most = 0;
    const double *const x[2] = {x1, x1};
    double *work = kw_need_memory(kw_tensor_grid_work(g, SPACE, count), sizeof *work);

    for (int i = 0; i < M; i++)
        x1[i] = (double)i / (M - 1);
    kw_tensor_grid(g, SPACE, points, NULL, count, x, work, grid);
    kw_out_section(f, "surface", "x y z");
    for (int i = 0; i < M; i++) {
        for (int k = 0; k < M; k++) {
            const double at[2] = {x1[i], x1[k]}, *q = grid + (i * M + k) * SPACE;
            double p[SPACE];

            write_row3(f, q[0], q[1], q[2]);
            kw_tensor_point(g, SPACE, points, NULL, at, p);
            for (int a = 0; a < SPACE; a++)
                most = fmax(most, fabs(p[a] - q[a]));
        }
        kw_out_gap(f);
    }
    free(work);
    return most;
}

/* A function of the basis is the product of its factors, each in its own direction. */
static double product_difference(const kw_tensor *g, const double *x)
{
    double local[3 * 3], most = 0;
    int first[2];

    kw_tensor_basis(g, NULL, x, first, local);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            most = fmax(most, fabs(local[a * 3 + b] -
                                   kw_bspline_one(g->s[0], first[0] + a, 0, x[0]) *
                                       kw_bspline_one(g->s[1], first[1] + b, 0, x[1])));
    return most;
}

/* Across the simple knot line x_1 = 0.4 the surface has d - 1 = 1 continuous derivatives in
   that direction: how many of the orders 0, 1, 2 jump? */
static int jumping_orders(const kw_tensor *g)
{
    const kw_bspline *s = g->s[0];
    double left[3 * 3], right[3 * 3];
    int jumping = 0, line = 3;

    kw_bspline_derivatives_on(s, line - 1, s->t[line], 2, left);
    kw_bspline_derivatives_on(s, line, s->t[line], 2, right);
    for (int r = 0; r <= 2; r++) {
        double jump = 0;

        for (int j2 = 0; j2 < N2; j2++) { /* coefficient j2 of the curve x_1 = const */
            double a = 0, b = 0;

            for (int i = 0; i < 3; i++) {
                a += left[r * 3 + i] *
                     points[((line - 1 - s->d + i) * N2 + j2) * SPACE + 2];
                b += right[r * 3 + i] * points[((line - s->d + i) * N2 + j2) * SPACE + 2];
            }
            jump = fmax(jump, fabs(a - b));
        }
        jumping += jump > 1e-12;
    }
    return jumping;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_patch"), *report = kw_claim_new("ex_patch");
    kw_tensor *g = new_space();
    kw_rng r = kw_rng_at(10, 0, 0, 0);
    findings all = {0, 0, 0, 0};
    double product = 0;

    for (int i = 0; i < RANDOM; i++) {
        const double x[2] = {kw_rng_uniform(&r), kw_rng_uniform(&r)};

        look_at(g, x, &all);
        product = fmax(product, product_difference(g, x));
    }
    write_lines(f, g);
    write_net(f, g);

    kw_claim_real(report, "tp.product", product);
    kw_claim_real(report, "tp.eq11.sum", all.sum);
    kw_claim_real(report, "tp.eq11.grid", write_grid(f, g));
    kw_claim_real(report, "tp.patch.affine", all.affine);
    kw_claim_real(report, "tp.patch.hull", all.box);
    kw_claim_count(report, "tp.patch.active", all.active);
    kw_claim_real(report, "tp.patch.corners", corner_distance(g));
    kw_claim_count(report, "tp.regularity", jumping_orders(g));

    kw_tensor_free(g);
    return kw_out_close(f) | kw_out_close(report);
}
