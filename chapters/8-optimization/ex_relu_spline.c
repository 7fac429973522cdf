/* Where the two halves meet -- a ReLU network is a linear spline, knots and all.

   What to see: the same function as a sum of (a) linear B-splines, each of which lives on two
   cells, and (b) ReLU units, each of which begins at a knot and never ends. On the right
   the units are far larger than their sum, and cancel each other.

   Book: section 1.1, (9), and section 1.2, Definition 10, Remark 9.
   Claims: opt.relu.*
   Chosen here: six knots and coefficients for the picture. Where results are exact, all numbers are
   integers over powers of two, cells too. */

#include "claim.h"  /* what we found, for the ledger */
#include "curve.h"  /* the spline */
#include "hinges.h" /* the network */
#include "out.h"    /* columns for gnuplot */
#include "rng.h"    /* random splines and networks */
#include <math.h>
#include <stdlib.h>

enum {
    DRAWN = 6, /* coefficients of the spline of the picture */
    CASES = 200,
    MOST = 24,    /* coefficients of a random spline at most */
    UNITS = 16,   /* of a random network */
    GRID = 64,    /* its knots are multiples of 1/GRID */
    SAMPLES = 200 /* random points */
};

/* The function through (t_i, c_i), as a spline and as a network. */
typedef struct pair {
    kw_bspline *s;
    const double *c;
    kw_net *net;
    double w[3 * MOST];
    kw_net_work *work;
} pair;

static pair new_pair(int n, const double *t, const double *c)
{
    pair p = {
        .s = kw_bspline_new_open(1, n - 1, t, NULL), .c = c, .net = new_relu_net(n - 1)};

    hinges_of(n, t, c, p.w);
    p.work = kw_net_work_new(p.net, 1);
    return p;
}

static void free_pair(pair p)
{
    kw_bspline_free(p.s);
    kw_net_free(p.net);
    kw_net_work_free(p.work);
}

static double net_at(const pair *p, const double *w, double x)
{
    double y;

    kw_net_forward(p->net, w, 1, &x, p->work, &y);
    return y;
}

static double spline_at(const pair *p, double x)
{
    double y;

    kw_curve_point(p->s, 1, p->c, x, &y);
    return y;
}

/* --- from the spline to the network --- */

/* Cells of 1/8, 1/4 or 1/2 and integer slopes. Points, multiples of 1/64, at which the network is
   not the spline; *scaled: at which it is another if the weight and bias of each unit are
   multiplied by some power of two, and its output is divided by it. */
static int count_unequal(int *scaled)
{
    int unequal = 0;

    *scaled = 0;
    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(85, 0, sample, 0);
        int n = 2 + kw_rng_below(&r, MOST - 1), hidden = n - 1;
        double t[MOST] = {0}, c[MOST] = {0}, w[3 * MOST] = {0};
        pair p;

        c[0] = kw_rng_below(&r, 19) - 9;
        for (int i = 1; i < n; i++) {
            t[i] = t[i - 1] + (1 << kw_rng_below(&r, 3)) / 8.0;
            c[i] = c[i - 1] + (t[i] - t[i - 1]) * (kw_rng_below(&r, 19) - 9);
        }
        p = new_pair(n, t, c);
        for (int i = 0; i < p.net->parameters; i++)
            w[i] = p.w[i];
        for (int i = 0; i < hidden; i++) {
            double scale = ldexp(1, kw_rng_below(&r, 9) - 4);

            w[i] *= scale;
            w[hidden + i] *= scale;
            w[2 * hidden + i] /= scale;
        }
        for (int i = 0; i <= 64 * t[n - 1]; i++) {
            double y = net_at(&p, p.w, i / 64.0);

            unequal += y != spline_at(&p, i / 64.0);
            *scaled += y != net_at(&p, w, i / 64.0);
        }
        free_pair(p);
    }
    return unequal;
}

static int ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

/* What a network adds up at x, with every sign positive and every slope counted twice: its
   roundings are relative to this. */
static double size_at(int n, const double *t, const double *c, double x)
{
    double sum = fabs(c[0]), before = 0;

    for (int i = 0; i < n - 1; i++) {
        double slope = fabs((c[i + 1] - c[i]) / (t[i + 1] - t[i]));

        sum += (slope + before) * fmax(0, x - t[i]);
        before = slope;
    }
    return sum;
}

/* Any knots and coefficients: the largest difference of the two, relative to what is added
   up. */
static double largest_difference(void)
{
    double most = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(86, 0, sample, 0);
        double t[MOST] = {0, 1}, c[MOST];
        pair p;

        for (int i = 2; i < MOST; i++)
            t[i] = kw_rng_uniform(&r);
        qsort(t, MOST, sizeof *t, ascending);
        for (int i = 0; i < MOST; i++)
            c[i] = 2 * kw_rng_uniform(&r) - 1;
        p = new_pair(MOST, t, c);
        for (int i = 0; i < SAMPLES; i++) {
            double x = kw_rng_uniform(&r),
                   difference = net_at(&p, p.w, x) - spline_at(&p, x);

            most = fmax(most, fabs(difference) / size_at(MOST, t, c, x));
        }
        free_pair(p);
    }
    return most;
}

/* --- from the network to the spline --- */

/* Random units that bend at multiples of 1/GRID inside (0,1): w is +-1/2, +-1 or +-2. bend[i]: by
   how much the slope of the network should change at i/GRID. */
static void random_units(kw_rng *r, double *w, double *bend)
{
    for (int i = 0; i <= GRID; i++)
        bend[i] = 0;
    for (int i = 0; i < UNITS; i++) {
        int at = 1 + kw_rng_below(r, GRID - 1);

        w[i] = (1 << kw_rng_below(r, 3)) / 2.0;
        w[i] = kw_rng_below(r, 2) ? w[i] : -w[i];
        w[UNITS + i] = -w[i] * at / GRID;
        w[2 * UNITS + i] = kw_rng_below(r, 19) - 9;
        bend[at] += w[2 * UNITS + i] * fabs(w[i]);
    }
    w[3 * UNITS] = kw_rng_below(r, 19) - 9;
}

/* What is seen of the networks as functions. */
typedef struct findings {
    int bends,
        astray; /* places on the grid: with a bend; with another than the units have */
    double difference; /* the largest from the spline, over its largest coefficient */
} findings;

static void look_at(kw_rng *r, const double *w, const double *bend, findings *all)
{
    double t[GRID + 1], c[GRID + 1], largest = 0, difference = 0;
    int n = 0;
    pair p = {.net = new_relu_net(UNITS)};

    p.work = kw_net_work_new(p.net, 1);
    for (int i = 0; i <= GRID; i++) {
        double h = 1.0 / GRID, x = i * h, y = net_at(&p, w, x);
        double change = (net_at(&p, w, x + h) - 2 * y + net_at(&p, w, x - h)) / h;
        int inside = 0 < i && i < GRID;

        all->bends += inside && change != 0;
        all->astray += inside && change != bend[i];
        if (!inside || change != 0) {
            t[n] = x;
            c[n++] = y;
            largest = fmax(largest, fabs(y));
        }
    }
    p.s = kw_bspline_new_open(1, n - 1, t, NULL);
    p.c = c;
    for (int i = 0; i < SAMPLES; i++) { /* multiples of 2^-20, exact in the network */
        double x = kw_rng_below(r, 1 << 20) / (double)(1 << 20);

        difference = fmax(difference, fabs(net_at(&p, w, x) - spline_at(&p, x)));
    }
    all->difference = fmax(all->difference, difference / largest);
    free_pair(p);
}

static void report_networks(kw_out *report)
{
    findings all = {0};

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(87, 0, sample, 0);
        double w[3 * UNITS + 1], bend[GRID + 1];

        random_units(&r, w, bend);
        look_at(&r, w, bend, &all);
    }
    kw_claim_count(report, "opt.relu.bends", all.bends);
    kw_claim_count(report, "opt.relu.bends.astray", all.astray);
    kw_claim_real(report, "opt.relu.back", all.difference);
}

/* --- the picture --- */

/* x, the sum, and its terms: c_j beta_j, or c_0 and the weighted units. */
static void write_terms(kw_out *f, const pair *p, const double *t)
{
    const double *weight = p->w + 2 * (DRAWN - 1);

    kw_out_section(f, "hats", "x sum b0 b1 b2 b3 b4 b5");
    for (int i = 0; i <= GRID; i++) {
        double x = (double)i / GRID;

        kw_out_number(f, x);
        kw_out_number(f, spline_at(p, x));
        for (int j = 0; j < DRAWN; j++)
            kw_out_number(f, p->c[j] * kw_bspline_one(p->s, j, 0, x));
        kw_out_row(f);
    }
    kw_out_section(f, "units", "x sum bias u0 u1 u2 u3 u4");
    for (int i = 0; i <= GRID; i++) {
        double x = (double)i / GRID;

        kw_out_number(f, x);
        kw_out_number(f, net_at(p, p->w, x));
        kw_out_number(f, p->c[0]);
        for (int j = 0; j < DRAWN - 1; j++)
            kw_out_number(f, weight[j] * fmax(0, x - t[j]));
        kw_out_row(f);
    }
    kw_out_section(f, "knots", "t c");
    for (int j = 0; j < DRAWN; j++) {
        kw_out_number(f, t[j]);
        kw_out_number(f, p->c[j]);
        kw_out_row(f);
    }
}

int main(void)
{
    static const double t[DRAWN] = {0, 0.125, 0.375, 0.5, 0.75, 1};
    static const double c[DRAWN] = {0.5, 1, 0.25, 0.75, 0.5, 1};
    kw_out *f = kw_out_data("ex_relu_spline"), *report = kw_claim_new("ex_relu_spline");
    pair p = new_pair(DRAWN, t, c);
    int unequal, scaled;

    write_terms(f, &p, t);

    unequal = count_unequal(&scaled);
    kw_claim_count(report, "opt.relu.exact", unequal);
    kw_claim_count(report, "opt.relu.scaled", scaled);
    kw_claim_real(report, "opt.relu.rounded", largest_difference());
    report_networks(report);
    kw_claim_count(report, "opt.relu.parameters", kw_mlp_count(p.net));
    kw_claim_count(report, "opt.relu.parameters.spline", p.s->n + (p.s->n - 2));

    free_pair(p);
    return kw_out_close(f) | kw_out_close(report);
}
