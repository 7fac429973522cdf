/* Remarks 3 and 4 -- without interior knots B-splines are Bernstein polynomials.

   What to see: left, the five polynomials of degree 4, each with its one maximum at j/4;
   right, de Casteljau's algorithm, which averages neighbours until one point is left, the
   point of the curve.

   Book: section 1.1, (7), (8), Remarks 3 and 4.
   Claims: bs.rem3.*, bs.eq7.knots, bs.eq8, bs.rem4.*
   Chosen here: degrees 0 .. 8; the cubic and x = 0.4 of the picture. */

#include "bernstein.h" /* formula (8), de Casteljau */
#include "bspline.h"   /* Definition 3 */
#include "claim.h"     /* what we found, for the ledger */
#include "curve.h"     /* de Boor */
#include "out.h"       /* columns for gnuplot */
#include "rng.h"       /* control points */
#include <math.h>

enum { HIGHEST = 8, SAMPLES = 40, PLANE = 2 };

typedef struct findings {
    int dimension, knots;
    double formula, casteljau;
} findings;

/* n = k, and the knots are k zeros and k ones. */
static void look_at_knots(const kw_bspline *s, findings *all)
{
    int k = s->d + 1;

    all->dimension += s->n != k;
    all->knots +=
        kw_bspline_multiplicity(s, 0) != k || kw_bspline_multiplicity(s, 1) != k;
}

static void compare_functions(const kw_bspline *s, findings *all)
{
    double spline[HIGHEST + 1], bernstein[HIGHEST + 1];

    for (int i = 0; i <= SAMPLES; i++) {
        double x = (double)i / SAMPLES;

        kw_bspline_basis(s, x, spline);
        kw_bernstein_basis(s->d, x, bernstein);
        for (int j = 0; j <= s->d; j++)
            all->formula = fmax(all->formula, fabs(spline[j] - bernstein[j]));
    }
}

static void compare_algorithms(const kw_bspline *s, findings *all)
{
    double c[(HIGHEST + 1) * PLANE], deboor[PLANE], casteljau[PLANE];
    kw_rng r = kw_rng_at(9, 0, (uint64_t)s->d, 0);

    for (int j = 0; j < s->n * PLANE; j++)
        c[j] = 2 * kw_rng_uniform(&r) - 1;
    for (int i = 0; i <= SAMPLES; i++) {
        double x = (double)i / SAMPLES;

        kw_curve_deboor(s, PLANE, c, x, deboor);
        kw_bernstein_casteljau(s->d, PLANE, c, x, casteljau);
        for (int a = 0; a < PLANE; a++)
            all->casteljau = fmax(all->casteljau, fabs(deboor[a] - casteljau[a]));
    }
}

static void write_functions(kw_out *f)
{
    enum { D = 4 };
    double value[D + 1];

    kw_out_section(f, "functions", "x beta_0 beta_1 beta_2 beta_3 beta_4");
    for (int i = 0; i <= 2 * SAMPLES; i++) {
        double x = (double)i / (2 * SAMPLES);

        kw_bernstein_basis(D, x, value);
        kw_out_number(f, x);
        for (int j = 0; j <= D; j++)
            kw_out_number(f, value[j]);
        kw_out_row(f);
    }
}

/* Step p of de Casteljau at x = 0.4: its points are those of the curves of degree p on p+1
   neighbouring control points. */
static void write_casteljau(kw_out *f)
{
    enum { D = 3 };
    static const double c[(D + 1) * PLANE] = {0, 0, 0.6, 2, 2.6, 2.4, 3.4, 0.2};
    const double at = 0.4;
    double point[PLANE];

    kw_out_section(f, "casteljau", "x y step");
    for (int p = 0; p <= D; p++) {
        for (int j = 0; j <= D - p; j++) {
            kw_bernstein_casteljau(p, PLANE, c + j * PLANE, at, point);
            kw_out_number(f, point[0]);
            kw_out_number(f, point[1]);
            kw_out_number(f, p);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    kw_out_section(f, "curve", "x y");
    for (int i = 0; i <= 2 * SAMPLES; i++) {
        kw_bernstein_casteljau(D, PLANE, c, (double)i / (2 * SAMPLES), point);
        kw_out_number(f, point[0]);
        kw_out_number(f, point[1]);
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_bernstein"), *report = kw_claim_new("ex_bernstein");
    findings all = {0, 0, 0, 0};

    for (int d = 0; d <= HIGHEST; d++) {
        kw_bspline *s = kw_bspline_new_open_uniform(d, 1, 0, 1);

        look_at_knots(s, &all);
        compare_functions(s, &all);
        compare_algorithms(s, &all);
        kw_bspline_free(s);
    }
    write_functions(f);
    write_casteljau(f);

    kw_claim_count(report, "bs.rem3.dimension", all.dimension);
    kw_claim_count(report, "bs.eq7.knots", all.knots);
    kw_claim_real(report, "bs.eq8", all.formula);
    kw_claim_real(report, "bs.rem4.casteljau", all.casteljau);
    return kw_out_close(f) | kw_out_close(report);
}
