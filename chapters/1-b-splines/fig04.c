/* Figure 4 -- A cubic B-spline and its four pieces; bases of degree 1 and 2.

   What to see: (a) four cubic polynomials, each used on one span only, join to one bump so
   smoothly that no joint shows; (b) on open knots the basis of degree 1 is a row of hats
   and that of degree 2 a row of smooth bumps, of which only the first and the last
   reach 1, at the ends.

   Book: section 1.1, Definition 3.
   Claims: bs.fig4.*
   Chosen here: the uniform knots 0 .. 4 of (a); the four interior knots of (b). */

#include "../univariate.h" /* how a basis is written */
#include "bspline.h"       /* the functions and their polynomial pieces */
#include "claim.h"         /* what we found, for the ledger */
#include "out.h"           /* columns for gnuplot */
#include <math.h>

enum {
    D = 3,          /* degree of (a) */
    PIECES = D + 1, /* spans of its support */
    CELLS = 5,      /* cells of (b): four interior knots */
    SAMPLES = 60    /* points on a span */
};

/* The pieces of one function: piece[i] holds its polynomial on span i of the support,
   in powers of u, the position in the span from 0 to 1. */
static void pieces_of_function(double piece[PIECES][D + 1])
{
    const double t[] = {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7}; /* beta_3 lives on [0,4] */
    kw_bspline *s = kw_bspline_new(D, 7, t);
    double local[PIECES * PIECES];

    for (int i = 0; i < PIECES; i++) {
        kw_bspline_pieces(s, D + i, local);
        for (int q = 0; q <= D; q++)
            piece[i][q] = local[(D - i) * PIECES + q];
    }
    kw_bspline_free(s);
}

/* the r-th derivative of a polynomial with coefficients p[0..D] at u */
static double polynomial(const double *p, int r, double u)
{
    double value = 0;

    for (int q = D; q >= r; q--) {
        double falling = 1; /* q (q-1) .. (q-r+1) */

        for (int i = 0; i < r; i++)
            falling *= q - i;
        value = value * u + falling * p[q];
    }
    return value;
}

static void write_pieces(kw_out *f, double piece[PIECES][D + 1])
{
    kw_out_section(f, "pieces", "x value piece");
    for (int i = 0; i < PIECES; i++) {
        for (int j = 0; j <= PIECES * SAMPLES; j++) {
            double x = (double)j / SAMPLES;

            kw_out_number(f, x);
            kw_out_number(f, polynomial(piece[i], 0, x - i));
            kw_out_number(f, i);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
}

/* The largest deviation of the sum of all functions from one. */
static double unity_error(const kw_bspline *s)
{
    double worst = 0;

    for (int i = 0; i <= CELLS * SAMPLES; i++) {
        double sum = 0;

        for (int j = 0; j < s->n; j++)
            sum += kw_bspline_one(s, j, 0, (double)i / (CELLS * SAMPLES));
        worst = fmax(worst, fabs(sum - 1));
    }
    return worst;
}

/* What the pieces are and how they meet. */
static void report_pieces(kw_out *report, double piece[PIECES][D + 1])
{
    double jump = 0, kink = INFINITY;
    int different = 1;

    for (int i = 1; i < PIECES; i++) { /* the joint before piece i */
        double third = polynomial(piece[i], D, 0) - polynomial(piece[i - 1], D, 1);

        for (int r = 0; r < D; r++)
            jump = fmax(
                jump, fabs(polynomial(piece[i], r, 0) - polynomial(piece[i - 1], r, 1)));
        kink = fmin(kink, fabs(third));
        different += third != 0;
    }
    kw_claim_count(report, "bs.fig4.pieces", different);
    kw_claim_real(report, "bs.fig4.piece.1", polynomial(piece[0], 0, 0.5));
    kw_claim_real(report, "bs.fig4.piece.2", polynomial(piece[1], 0, 0.5));
    kw_claim_real(report, "bs.fig4.piece.3", polynomial(piece[2], 0, 0.5));
    kw_claim_real(report, "bs.fig4.piece.4", polynomial(piece[3], 0, 0.5));
    kw_claim_real(report, "bs.fig4.joint", jump);
    kw_claim_real(report, "bs.fig4.kink", kink);
}

int main(void)
{
    kw_out *f = kw_out_data("fig04"), *report = kw_claim_new("fig04");
    kw_bspline *hats = kw_bspline_new_open_uniform(1, CELLS, 0, 1);
    kw_bspline *bumps = kw_bspline_new_open_uniform(2, CELLS, 0, 1);
    double piece[PIECES][D + 1];

    pieces_of_function(piece);
    write_pieces(f, piece);
    write_univariate(f, "hats", hats, CELLS * SAMPLES);
    write_univariate(f, "bumps", bumps, CELLS * SAMPLES);

    report_pieces(report, piece);
    kw_claim_real(report, "bs.fig4.unity.hats", unity_error(hats));
    kw_claim_real(report, "bs.fig4.unity.bumps", unity_error(bumps));
    kw_claim_count(report, "bs.fig4.dim.hats", hats->n);
    kw_claim_count(report, "bs.fig4.dim.bumps", bumps->n);

    kw_bspline_free(hats);
    kw_bspline_free(bumps);
    return kw_out_close(f) | kw_out_close(report);
}
