/* Overfitting -- what a fit with many parameters takes from the noise.

   What to see: polynomials with p coefficients are fitted to twelve values with noise. The error on
   these values falls with every coefficient and ends at zero. The error on new values at the same
   places falls, and rises again: what the fit has taken for a law was noise.

   Book: section 1.2, the training set and overfitting.
   Claims: learn.fit.*
   Chosen here: places, function and noise. The noise is +1/4 or -1/4 at each place, and all 4096
   patterns of signs are tried, so means are no estimates. */

#include "claim.h"      /* what we found, for the ledger */
#include "dense.h"      /* least squares */
#include "elementary.h" /* the function */
#include "need.h"       /* the fits exist */
#include "out.h"        /* columns for gnuplot */
#include <math.h>

enum { PLACES = 12, PATTERNS = 1 << PLACES, SAMPLES = 200, PATTERN = 2739 };

static const double NOISE = 0.25;

static double place(int i)
{
    return -1 + 2.0 * i / (PLACES - 1);
}

static double law(double x)
{
    return kw_sin(3 * x + 1);
}

/* Value i of a pattern: the law, and noise whose sign is bit i. */
static double value(int pattern, int i)
{
    return law(place(i)) + (pattern >> i & 1 ? NOISE : -NOISE);
}

/* The Chebyshev polynomials T_0 .. T_{p-1} at x. */
static void basis(int p, double x, double *T)
{
    for (int j = 0; j < p; j++)
        T[j] = j == 0 ? 1 : j == 1 ? x : 2 * x * T[j - 1] - T[j - 2];
}

static double polynomial(int p, const double *c, double x)
{
    double T[PLACES], sum = 0;

    basis(p, x, T);
    for (int j = 0; j < p; j++)
        sum += c[j] * T[j];
    return sum;
}

/* X, PLACES x columns, becomes the coefficients of the fits, p x columns, to its columns. */
static void fit(int p, int columns, double *X)
{
    double A[PLACES * PLACES];
    int dependent;

    for (int i = 0; i < PLACES; i++)
        basis(p, place(i), A + i * p);
    dependent = kw_dense_least_squares(PLACES, p, columns, A, X);
    KW_NEED(!dependent, "the first %d polynomials are dependent", p);
}

/* --- errors of the fits with p coefficients --- */

typedef struct errors {
    double training,
        fresh;   /* on the values fitted, and on new ones; means over all patterns */
    double bias; /* of the fit to the law itself, without noise */
} errors;

static double squared(double a)
{
    return a * a;
}

static errors measure(int p)
{
    static double X[PLACES * PATTERNS], c[PLACES];
    double clean[PLACES];
    errors e = {0, 0, 0};

    for (int i = 0; i < PLACES; i++) {
        clean[i] = law(place(i));
        for (int q = 0; q < PATTERNS; q++)
            X[i * PATTERNS + q] = value(q, i);
    }
    fit(p, PATTERNS, X);
    fit(p, 1, clean);
    for (int q = 0; q < PATTERNS; q++) {
        double training = 0, fresh = 0;

        for (int j = 0; j < p; j++)
            c[j] = X[j * PATTERNS + q];
        for (int i = 0; i < PLACES; i++) {
            double y = polynomial(p, c, place(i)), off = y - law(place(i));

            training += squared(y - value(q, i));
            fresh += (squared(off - NOISE) + squared(off + NOISE)) / 2;
        }
        e.training += training / PLACES;
        e.fresh += fresh / PLACES;
    }
    for (int i = 0; i < PLACES; i++)
        e.bias += squared(polynomial(p, clean, place(i)) - law(place(i))) / PLACES;
    e.training /= PATTERNS;
    e.fresh /= PATTERNS;
    return e;
}
/* --- columns --- */

static void write_errors(kw_out *f, const errors *e)
{
    kw_out_section(f, "errors", "coefficients training new bias");
    for (int p = 1; p <= PLACES; p++) {
        kw_out_number(f, p);
        kw_out_number(f, e[p].training);
        kw_out_number(f, e[p].fresh);
        kw_out_number(f, e[p].bias);
        kw_out_row(f);
    }
}

/* One pattern, the law, and the fits with 2, 5 and all 12 coefficients. */
static void write_fits(kw_out *f)
{
    static const int shown[] = {2, 5, PLACES};
    double c[3][PLACES];

    kw_out_section(f, "values", "x y");
    for (int i = 0; i < PLACES; i++) {
        for (int k = 0; k < 3; k++)
            c[k][i] = value(PATTERN, i);
        kw_out_number(f, place(i));
        kw_out_number(f, value(PATTERN, i));
        kw_out_row(f);
    }
    for (int k = 0; k < 3; k++)
        fit(shown[k], 1, c[k]);
    kw_out_section(f, "fits", "x law 2 5 12");
    for (int i = 0; i <= SAMPLES; i++) {
        double x = -1 + 2.0 * i / SAMPLES;

        kw_out_number(f, x);
        kw_out_number(f, law(x));
        for (int k = 0; k < 3; k++)
            kw_out_number(f, polynomial(shown[k], c[k], x));
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_overfitting"), *report = kw_claim_new("ex_overfitting");
    const double variance = NOISE * NOISE;
    errors e[PLACES + 1] = {{0, 0, 0}};
    double training_off = 0, fresh_off = 0;
    int best = 1;

    for (int p = 1; p <= PLACES; p++) {
        double share = (double)p / PLACES;

        e[p] = measure(p);
        training_off =
            fmax(training_off, fabs(e[p].training - e[p].bias - variance * (1 - share)));
        fresh_off =
            fmax(fresh_off, fabs(e[p].fresh - e[p].bias - variance * (1 + share)));
        best = e[p].fresh < e[best].fresh ? p : best;
    }
    write_fits(f);
    write_errors(f, e);

    kw_claim_real(report, "learn.fit.training", training_off);
    kw_claim_real(report, "learn.fit.new", fresh_off);
    kw_claim_count(report, "learn.fit.best", best);
    kw_claim_real(report, "learn.fit.best.new", e[best].fresh);
    kw_claim_real(report, "learn.fit.all.training", e[PLACES].training);
    kw_claim_real(report, "learn.fit.all.new", e[PLACES].fresh);
    return kw_out_close(f) | kw_out_close(report);
}
