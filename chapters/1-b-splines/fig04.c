/* Figure 4 -- A cubic B-spline and its four pieces; bases of degree 1 and 2.

   What to see: (a) four cubic polynomials, each used on one span only, join to one bump so
   smoothly that no joint shows; (b) on open knots the basis of degree 1 is a row of hats
   and that of degree 2 a row of smooth bumps, and only the first and the last function
   reach 1, at the ends.

   Book: section 1.1, Definition 3.
   Claims: bs.fig4.*
   Chosen here: the uniform knots 0 .. 4 of (a); the four interior knots of (b). */

#include "bspline.h" /* the functions and their polynomial pieces */
#include "claim.h"   /* what we found, for the ledger */
#include "need.h"    /* memory */
#include "out.h"     /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

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

/* Writes the basis of degree d and returns its largest deviation from one in sum. */
static double write_basis(kw_out *f, const char *name, const kw_bspline *s)
{
    double worst = 0;

    kw_out_section(f, name, "x value function");
    for (int j = 0; j < s->n; j++) {
        for (int i = 0; i <= CELLS * SAMPLES; i++) {
            double x = (double)i / (CELLS * SAMPLES);

            if (x < s->t[j] || x > s->t[j + s->d + 1])
                continue; /* outside the support */
            kw_out_number(f, x);
            kw_out_number(f, kw_bspline_one(s, j, 0, x));
            kw_out_number(f, j);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    for (int i = 0; i <= CELLS * SAMPLES; i++) {
        double sum = 0;

        for (int j = 0; j < s->n; j++)
            sum += kw_bspline_one(s, j, 0, (double)i / (CELLS * SAMPLES));
        worst = fmax(worst, fabs(sum - 1));
    }
    return worst;
}

int main(void)
{
    kw_out *f = kw_out_data("fig04"), *report = kw_claim_new("fig04");
    kw_bspline *hats = kw_bspline_new_open_uniform(1, CELLS, 0, 1);
    kw_bspline *bumps = kw_bspline_new_open_uniform(2, CELLS, 0, 1);
    double piece[PIECES][D + 1], jump = 0, kink = 1;
    int different = 1;

    pieces_of_function(piece);
    for (int i = 1; i < PIECES; i++) { /* the joint before piece i */
        double third = polynomial(piece[i], D, 0) - polynomial(piece[i - 1], D, 1);

        for (int r = 0; r < D; r++)
            jump = fmax(
                jump, fabs(polynomial(piece[i], r, 0) - polynomial(piece[i - 1], r, 1)));
        kink = fmin(kink, fabs(third));
        different += third != 0;
    }
    write_pieces(f, piece);
    kw_claim_real(report, "bs.fig4.unity.hats", write_basis(f, "hats", hats));
    kw_claim_real(report, "bs.fig4.unity.bumps", write_basis(f, "bumps", bumps));

    kw_claim_count(report, "bs.fig4.pieces", different);
    kw_claim_real(report, "bs.fig4.joint", jump);
    kw_claim_real(report, "bs.fig4.kink", kink);
    kw_claim_count(report, "bs.fig4.dim.hats", hats->n);
    kw_claim_count(report, "bs.fig4.dim.bumps", bumps->n);

    kw_bspline_free(hats);
    kw_bspline_free(bumps);
    return kw_out_close(f) | kw_out_close(report);
}
