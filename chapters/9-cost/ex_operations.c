/* Operations -- additions, multiplications and divisions of a point, counted while they are done.

   What to see: (a) Definition 3 word by word more than doubles its work with every degree; all
   functions together, degree by degree, take work that grows with the square. (b) A point of a
   bicubic surface costs nearly three points of a curve; on a grid, one direction after the other,
   less than one.

   Book: section 1.1, Definition 3, equations (9) to (11).
   Claims: cost.basis.*, cost.curve.*, cost.surface.*, cost.bits
   Chosen here: the spaces, the points, curves and surfaces in R^3. */

#include "claim.h"   /* what we found, for the ledger */
#include "counted.h" /* arithmetic that counts itself */
#include "curve.h"   /* what it is compared with */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include "rng.h"     /* points and coefficients */
#include "tensor.h"  /* surfaces */
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 7, K = MOST + 1, SPANS = 20, POINTS = 100, N = 3, GRID = 200, ORDERS = 2 };

static double *new_coefficients(int count)
{
    kw_rng r = kw_rng_at(93, 0, 0, 0);
    double *c = kw_need_memory((size_t)count, sizeof *c);

    for (int i = 0; i < count; i++)
        c[i] = kw_rng_uniform(&r);
    return c;
}

/* What one point costs. Knots are equally spaced, also beyond the domain, so that every
   point costs the same; `differ` counts numbers that are not the library's. */
typedef struct costs {
    tally definition, triangle, sum, deboor, derivatives, surface;
    int differ;
} costs;

static void count_basis(const kw_bspline *s, double x, costs *c)
{
    double ours[K], lib[K];
    int first = kw_bspline_basis(s, x, lib);

    c->definition = c->triangle = (tally){0};
    for (int j = 0; j <= s->d; j++)
        ours[j] =
            basis_by_definition(&c->definition, s, first + s->d, first + j, s->d, x);
    c->differ += differing(s->d + 1, ours, lib);
    basis_by_triangle(&c->triangle, s, first + s->d, x, ours);
    c->differ += differing(s->d + 1, ours, lib);
}

/* De Boor's algorithm averages the coefficients of each coordinate. */
static void average(tally *t, const kw_bspline *s, int i, const double *c, double x,
                    double *point)
{
    const double *knot = s->t + i - s->d;
    int d = s->d;

    for (int a = 0; a < N; a++) {
        double b[K] = {0};

        for (int j = 0; j <= d; j++)
            b[j] = c[(i - d + j) * N + a];
        for (int p = 1; p <= d; p++)
            for (int j = d; j >= p; j--) {
                double left = knot[j], right = knot[j + d + 1 - p];
                double width = minus(t, right, left);

                b[j] = plus(t, times(t, over(t, minus(t, right, x), width), b[j - 1]),
                            times(t, over(t, minus(t, x, left), width), b[j]));
            }
        point[a] = b[d];
    }
}

static void count_curve(const kw_bspline *s, const double *c, double x, costs *count)
{
    double value[K], ours[N] = {0}, lib[N];
    int i = kw_bspline_span(s, x), d = s->d;

    count->sum = count->deboor = (tally){0};
    basis_by_triangle(&count->sum, s, i, x, value);
    add_combination(&count->sum, d + 1, N, value, c + (i - d) * N, N, ours);
    kw_curve_point(s, N, c, x, lib);
    count->differ += differing(N, ours, lib);
    average(&count->deboor, s, i, c, x, ours);
    kw_curve_deboor(s, N, c, x, lib);
    count->differ += differing(N, ours, lib);
}

/* A point with its derivatives of order 1 and 2, or 1 if there are no more. */
static void count_derivatives(const kw_bspline *s, const double *c, double x,
                              costs *count)
{
    double value[(ORDERS + 1) * K], ours[(ORDERS + 1) * N] = {0}, lib[(ORDERS + 1) * N];
    int i = kw_bspline_span(s, x), d = s->d, r = d < ORDERS ? d : ORDERS;

    count->derivatives = (tally){0};
    derivatives_by_triangle(&count->derivatives, s, i, x, r, value);
    for (int q = 0; q <= r; q++)
        add_combination(&count->derivatives, d + 1, N, value + q * (d + 1),
                        c + (i - d) * N, N, ours + q * N);
    kw_curve_derivatives(s, N, c, x, r, lib);
    count->differ += differing((r + 1) * N, ours, lib);
}

static void count_surface(const kw_tensor *g, const double *c, const double *x,
                          costs *count)
{
    double value[2][K] = {{0}}, product[K], ours[N] = {0}, lib[N];
    int first[2], d = g->s[0]->d;

    count->surface = (tally){0};
    for (int h = 0; h < 2; h++) {
        int i = kw_bspline_span(g->s[h], x[h]);

        first[h] = i - d;
        basis_by_triangle(&count->surface, g->s[h], i, x[h], value[h]);
    }
    for (int j = 0; j <= d; j++) {
        for (int k = 0; k <= d; k++)
            product[k] = times(&count->surface, value[0][j], value[1][k]);
        add_combination(&count->surface, d + 1, N, product,
                        c + ((first[0] + j) * g->s[1]->n + first[1]) * N, N, ours);
    }
    kw_tensor_point(g, N, c, NULL, x, lib);
    count->differ += differing(N, ours, lib);
}

/* A grid of GRID x GRID points: all lines of coefficients are summed up in the first direction,
   then what came of it in the second. *per_point: operations of a point of the grid. */
static int count_grid(const kw_tensor *g, const double *c, double *per_point)
{
    const int size[] = {GRID, GRID}, n = g->s[0]->n, d = g->s[0]->d;
    double x[GRID], *line = kw_need_memory((size_t)GRID * (size_t)n * N, sizeof *line);
    double *ours = kw_need_memory((size_t)GRID * GRID * N, sizeof *ours);
    double *lib = kw_need_memory((size_t)GRID * GRID * N, sizeof *lib);
    double *room = kw_need_memory(kw_tensor_grid_work(g, N, size), sizeof *room);
    const double *both[] = {x, x};
    tally t = {0};
    int differ;

    for (int i = 0; i < GRID; i++)
        x[i] = (double)i / (GRID - 1);
    for (int h = 0; h < 2; h++)
        for (int i = 0; i < GRID; i++) {
            double value[K];
            int span = kw_bspline_span(g->s[h], x[i]), first = span - d;

            basis_by_triangle(&t, g->s[h], span, x[i], value);
            if (h == 0)
                add_combination(&t, d + 1, n * N, value, c + first * n * N, n * N,
                                line + i * n * N);
            for (int p = 0; h == 1 && p < GRID; p++)
                add_combination(&t, d + 1, N, value, line + (p * n + first) * N, N,
                                ours + (p * GRID + i) * N);
        }
    kw_tensor_grid(g, N, c, NULL, size, both, room, lib);
    differ = differing(GRID * GRID * N, ours, lib);
    *per_point = (double)operations(&t) / (GRID * GRID);
    free(line);
    free(ours);
    free(lib);
    free(room);
    return differ;
}

static void report_tally(kw_out *report, const char *what, int d, const tally *t)
{
    char id[60];

    snprintf(id, sizeof id, "cost.%s.%d", what, d);
    kw_claim_count(report, id, operations(t));
}

int main(void)
{
    kw_out *f = kw_out_data("ex_operations"), *report = kw_claim_new("ex_operations");
    costs count = {.differ = 0};

    kw_out_section(f, "degrees", "d definition triangle sum deboor surface grid");
    for (int d = 1; d <= MOST; d++) {
        kw_bspline *s = kw_bspline_new_uniform(d, SPANS, 0, 1);
        const kw_bspline *both[] = {s, s};
        kw_tensor *g = kw_tensor_new(2, both);
        double *c = new_coefficients(s->n * s->n * N), grid;
        kw_rng r = kw_rng_at(94, 0, 0, 0);

        for (int p = 0; p < POINTS; p++) {
            const double x[] = {kw_rng_uniform(&r), kw_rng_uniform(&r)};

            count_basis(s, x[0], &count);
            count_curve(s, c, x[0], &count);
            count_derivatives(s, c, x[0], &count);
            count_surface(g, c, x, &count);
        }
        count.differ += count_grid(g, c, &grid);
        {
            const double row[] = {d,
                                  (double)operations(&count.definition),
                                  (double)operations(&count.triangle),
                                  (double)operations(&count.sum),
                                  (double)operations(&count.deboor),
                                  (double)operations(&count.surface),
                                  grid};

            for (size_t i = 0; i < sizeof row / sizeof *row; i++)
                kw_out_number(f, row[i]);
            kw_out_row(f);
        }
        report_tally(report, "basis.definition", d, &count.definition);
        report_tally(report, "basis.triangle", d, &count.triangle);
        report_tally(report, "curve.sum", d, &count.sum);
        report_tally(report, "curve.deboor", d, &count.deboor);
        report_tally(report, "surface.point", d, &count.surface);
        if (d == 3) {
            kw_claim_real(report, "cost.surface.grid", grid);
            kw_claim_count(report, "cost.curve.derivatives",
                           operations(&count.derivatives));
            kw_claim_count(report, "cost.basis.divisions", count.triangle.quotients);
        }
        free(c);
        kw_tensor_free(g);
        kw_bspline_free(s);
    }
    kw_claim_count(report, "cost.bits", count.differ);
    return kw_out_close(f) | kw_out_close(report);
}
