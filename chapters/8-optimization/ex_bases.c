/* Two bases of one space -- why a network learns slowly what a spline knows at once.

   What to see: (a) the condition number of the linear B-splines stays below six, that of the ReLU
   units that span the same space grows with the fourth power of the cells. (b) One function,
   one method, the best rate for either: after 20 steps the B-splines have it, and the
   units are far off after 2000.

   Book: section 1.1, on B-splines as a basis, and section 1.2, Optimization.
   Claims: opt.bases.*
   Chosen here: equal cells of [0,1]; least squares in the mean over [0,1]; units that begin at the
   knots, and a constant; eight cells and the coefficients for the picture. */

#include "claim.h"      /* what we found, for the ledger */
#include "eigen.h"      /* condition numbers */
#include "elementary.h" /* logarithms */
#include "matrix.h"     /* products */
#include "out.h"        /* columns for gnuplot */
#include <math.h>
#include <string.h>

enum { CELLS_MOST = 32, MOST = CELLS_MOST + 1, DRAWN = 8, FEW = 20, MANY = 2000 };

/* --- the matrices of the integrals of all products of two functions --- */

/* Hats: on each cell of length h the integrals are h/3 and h/6. */
static void gram_of_hats(int cells, double *G)
{
    int n = cells + 1;

    memset(G, 0, (size_t)(n * n) * sizeof *G);
    for (int i = 0; i < cells; i++) {
        G[i * n + i] += 1.0 / (3 * cells);
        G[(i + 1) * n + i + 1] += 1.0 / (3 * cells);
        G[i * n + i + 1] += 1.0 / (6 * cells);
        G[(i + 1) * n + i] += 1.0 / (6 * cells);
    }
}

/* Unit j = 1 .. cells begins at (j-1)/cells; 0 is the constant. With l what is left from the
   later of two beginnings on, and q from the earlier to the later one, the integral of two
   units is l^3/3 + q l^2/2. */
static void gram_of_units(int cells, double *G)
{
    int n = cells + 1;

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int low = i < j ? i : j, high = i < j ? j : i;
            double l = (double)(cells + 1 - high) / cells,
                   q = (double)(high - low) / cells;

            G[i * n + j] = high == 0  ? 1
                           : low == 0 ? l * l / 2
                                      : l * l * l / 3 + q * l * l / 2;
        }
}

/* The hats' coefficients of all units, a column each: their values at the knots. */
static void values_at_knots(int cells, double *M)
{
    int n = cells + 1;

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            M[i * n + j] = j == 0 ? 1 : fmax(0, (double)(i - (j - 1)) / cells);
}

/* The functions of the units are those of the hats: the largest difference between the integrals
   of products of units, and the same by way of the hats. */
static double difference_of_spaces(int cells)
{
    int n = cells + 1;
    double G[MOST * MOST], M[MOST * MOST], GM[MOST * MOST] = {0}, MGM[MOST * MOST] = {0};
    double most = 0;

    gram_of_hats(cells, G);
    values_at_knots(cells, M);
    kw_matrix_add_ab(n, n, n, G, M, GM);
    kw_matrix_add_atb(n, n, n, M, GM, MGM);
    gram_of_units(cells, G);
    for (int i = 0; i < n * n; i++)
        most = fmax(most, fabs(MGM[i] - G[i]));
    return most;
}

/* --- condition numbers --- */

typedef void gram(int cells, double *G);

static void extremes(gram *fill, int cells, double *least, double *largest)
{
    double G[MOST * MOST], value[MOST], vector[MOST * MOST];

    fill(cells, G);
    kw_eigen_symmetric(cells + 1, G, value, vector);
    *least = value[0];
    *largest = value[cells];
}

static double condition(gram *fill, int cells)
{
    double least, largest;

    extremes(fill, cells, &least, &largest);
    return largest / least;
}

/* Steps of gradient descent at the best rate for a thousandth of the error (ex_descent). */
static double steps_for(double condition)
{
    return ceil(kw_log(1000) / (kw_log1p(1 / condition) - kw_log1p(-1 / condition)));
}

/* --- the picture --- */

/* Gradient descent from 0 to the coefficients `to`: half the integral of the squared error has
   the gradient G (a - to). */
static void descend(gram *fill, const double *to, int steps, double *a)
{
    enum { N = DRAWN + 1 };
    double G[N * N], least, largest;

    fill(DRAWN, G);
    extremes(fill, DRAWN, &least, &largest);
    memset(a, 0, N * sizeof *a);
    for (int step = 0; step < steps; step++) {
        double error[N], slope[N] = {0};

        for (int i = 0; i < N; i++)
            error[i] = a[i] - to[i];
        kw_matrix_add_ab(N, 1, N, G, error, slope);
        for (int i = 0; i < N; i++)
            a[i] -= 2 / (least + largest) * slope[i];
    }
}

/* The function through the values c at the knots, and where descent is in either basis. */
static void write_descents(kw_out *f)
{
    enum { N = DRAWN + 1 };
    const double c[N] = {0.25, 1, 0.5, 0.75, -0.5, -0.25, -1, 0.5, 0};
    double units[N], a[N], M[N * N], hats[N], few[N] = {0}, many[N] = {0};

    units[0] = c[0];
    for (int i = 0; i < DRAWN; i++)
        units[i + 1] = DRAWN * (c[i + 1] - c[i] - (i > 0 ? c[i] - c[i - 1] : 0));
    values_at_knots(DRAWN, M);
    descend(gram_of_hats, c, FEW, hats);
    descend(gram_of_units, units, FEW, a);
    kw_matrix_add_ab(N, 1, N, M, a, few);
    descend(gram_of_units, units, MANY, a);
    kw_matrix_add_ab(N, 1, N, M, a, many);
    kw_out_section(f, "descents", "x function hats few many");
    for (int i = 0; i < N; i++) {
        kw_out_number(f, (double)i / DRAWN);
        kw_out_number(f, c[i]);
        kw_out_number(f, hats[i]);
        kw_out_number(f, few[i]);
        kw_out_number(f, many[i]);
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_bases"), *report = kw_claim_new("ex_bases");
    double most = 0, same = 0, hats, units;

    kw_out_section(f, "conditions", "cells hats units");
    for (int cells = 1; cells <= CELLS_MOST; cells *= 2) {
        hats = condition(gram_of_hats, cells);
        most = fmax(most, hats);
        same = fmax(same, difference_of_spaces(cells));
        kw_out_number(f, cells);
        kw_out_number(f, hats);
        kw_out_number(f, condition(gram_of_units, cells));
        kw_out_row(f);
    }
    write_descents(f);

    hats = condition(gram_of_hats, CELLS_MOST);
    units = condition(gram_of_units, CELLS_MOST);
    kw_claim_real(report, "opt.bases.same", same);
    kw_claim_real(report, "opt.bases.hats", most);
    kw_claim_real(report, "opt.bases.units", units);
    kw_claim_real(report, "opt.bases.growth",
                  units / condition(gram_of_units, CELLS_MOST / 2));
    kw_claim_real(report, "opt.bases.steps.hats", steps_for(hats));
    kw_claim_real(report, "opt.bases.steps.units", steps_for(units));
    return kw_out_close(f) | kw_out_close(report);
}
