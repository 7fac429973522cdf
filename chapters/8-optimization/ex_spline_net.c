/* A spline and a network fit the same function -- error against parameters.

   What to see: (a) with seven parameters the network is nearer than the cubic spline. (b) The
   error of the splines falls as there are more coefficients, and jumps: with an odd number of
   them a knot is at the peak. The networks are ahead of the cubic spline at first and behind it
   later, where their error depends on how long they are trained.

   Book: section 1.1, (9), and section 1.2, the text before Figure 15, Optimization.
   Claims: opt.fit.*
   Chosen here: the function of ex_runge, 65 equal samples without noise, splines on equal cells,
   networks 1-H-1 with tanh, Adam and its rates, five seeds (fit.h). */

#include "claim.h" /* what we found, for the ledger */
#include "fit.h"   /* both fits */
#include "out.h"   /* columns for gnuplot */
#include <stdio.h>

enum { CUBIC = 3, SEEDS = 5, WIDTHS = 4, DRAWN = 2, DRAWN_SEED = 3, EVERY = 5 };

static const int WIDTH[WIDTHS] = {2, 4, 8, 16};

/* The error of the spline of degree d with n coefficients; y: its values. */
static double spline_error(int d, int n, double *y)
{
    kw_bspline *s = kw_bspline_new_open_uniform(d, n - d, -1, 1);

    fit_spline(s, y);
    kw_bspline_free(s);
    return error_of(y);
}

static double net_error(int hidden, int seed, double *y)
{
    kw_net *net = new_net(hidden);

    fit_net(net, (uint64_t)seed, y);
    kw_net_free(net);
    return error_of(y);
}

/* The function and two fits with as many parameters. */
static void write_example(kw_out *f)
{
    static double spline[POINTS], net[POINTS];

    spline_error(CUBIC, 3 * DRAWN + 1, spline);
    net_error(DRAWN, DRAWN_SEED, net);
    kw_out_section(f, "example", "x function spline net");
    for (int i = 0; i < POINTS; i += EVERY) {
        kw_out_number(f, point_at(i));
        kw_out_number(f, fitted(point_at(i)));
        kw_out_number(f, spline[i]);
        kw_out_number(f, net[i]);
        kw_out_row(f);
    }
}

static void write_splines(kw_out *f, const char *name, int d)
{
    double y[POINTS];

    kw_out_section(f, name, "parameters error");
    for (int n = d + 1; n <= MOST; n++) {
        kw_out_number(f, n);
        kw_out_number(f, spline_error(d, n, y));
        kw_out_row(f);
    }
}

/* The error of an affine function, which is that of the best constant: this one is even. */
static double constant_error(void)
{
    double y[POINTS];

    return spline_error(1, 2, y);
}

static void report_spline(kw_out *report, const char *name, int d, int n)
{
    double y[POINTS];
    char id[32];

    snprintf(id, sizeof id, "opt.fit.%s.%d", name, n);
    kw_claim_real(report, id, spline_error(d, n, y));
}

static void report_net(kw_out *report, int parameters, double best, double worst)
{
    char id[32];

    snprintf(id, sizeof id, "opt.fit.net.%d.best", parameters);
    kw_claim_real(report, id, best);
    snprintf(id, sizeof id, "opt.fit.net.%d.worst", parameters);
    kw_claim_real(report, id, worst);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_spline_net"), *report = kw_claim_new("ex_spline_net");
    double y[POINTS];

    write_example(f);
    write_splines(f, "linear", 1);
    write_splines(f, "cubic", CUBIC);
    kw_out_section(f, "net", "parameters error");
    for (int i = 0; i < WIDTHS; i++) {
        int parameters = 3 * WIDTH[i] + 1;
        double best = INFINITY, worst = 0;

        for (int seed = 1; seed <= SEEDS; seed++) {
            double error = net_error(WIDTH[i], seed, y);

            best = fmin(best, error);
            worst = fmax(worst, error);
            kw_out_number(f, parameters);
            kw_out_number(f, error);
            kw_out_row(f);
        }
        report_spline(report, "linear", 1, parameters);
        report_spline(report, "cubic", CUBIC, parameters);
        report_net(report, parameters, best, worst);
    }
    report_spline(report, "cubic", CUBIC, 14);
    kw_claim_real(report, "opt.fit.constant", constant_error());
    return kw_out_close(f) | kw_out_close(report);
}
