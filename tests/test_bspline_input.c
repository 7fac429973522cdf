/* Bad input to the splines: each call aborts, and its message names the value. The calls
   that take the same arguments share a table; `now` points at the line under test. */
#include "spline.h"
#include <limits.h>
#include <stddef.h>

static kw_bspline *space; /* quadratic on 0, 1 (twice), 2, open: span 3 is empty */
static double scratch[ROOM];

/* --- knots --- */

static const struct knots {
    const char *text;
    int d, n;
    double t[10];
} KNOTS[] = {
    {"t[3] = 1.25, t[4] = 0.75", 1, 4, {0, 0, 1, 1.25, 0.75, 2}},
    {"t[0] = 0.5, t[1] = 0", 1, 3, {0.5, 0, 1, 2, 2}},
    {"t[3] = 2, t[4] = 1.5", 1, 3, {0, 0, 1, 2, 1.5}},
    {"knot 0.5 appears more than 3 times (from t[3])",
     2,
     7,
     {0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1}},
    {"knot 7 appears more than 1 times (from t[1])", 0, 2, {5, 7, 7}},
    {"knot -2 appears more than 2 times (from t[0])", 1, 3, {-2, -2, -2, 0, 0}},
    {"2 functions of degree 2 (5 knots)", 2, 2, {0, 0, 0, 1, 1}},
    {"0 functions of degree 0 (1 knots)", 0, 0, {0}},
    {"degree -1,", -1, 2, {0, 1}},
    {"degree 32,", 32, 33, {0, 1}},
    {"t[2] = nan", 1, 3, {0, 0, NAN, 1, 1}},
    {"t[4] = inf", 1, 3, {0, 0, 1, 2, HUGE_VAL}},
    {"t[0] = -inf", 1, 3, {-HUGE_VAL, 0, 1, 2, 2}},
    {"[t[1], t[3]] = [0.5, 1]", 1, 3, {0, 0.5, 0.5, 1, 2}},  /* the first span is empty */
    {"[t[1], t[3]] = [0, 1.5]", 1, 3, {-1, 0, 1.5, 1.5, 2}}, /* the last */
};

static const struct knots *now_knots;

static void new_space(void)
{
    kw_bspline_new(now_knots->d, now_knots->n, now_knots->t);
}

static void bad_knots(void)
{
    for (size_t i = 0; i < sizeof KNOTS / sizeof *KNOTS; i++) {
        now_knots = KNOTS + i;
        test_aborts(now_knots->text, new_space);
    }
}

/* --- partitions; no mu stands for NULL --- */

typedef kw_bspline *constructor(int d, int L, const double *tau, const int *mu);

static const struct partition {
    const char *text;
    int d, L;
    double tau[4];
    int has_mu, mu[2];
} PARTITIONS[] = {
    {"mu[1] = 0, degree 2", 2, 3, {0, 1, 2, 3}, 1, {1, 0}},
    {"mu[0] = 4, degree 2", 2, 3, {0, 1, 2, 3}, 1, {4, 1}},
    {"mu[0] = -1, degree 0", 0, 2, {0, 1, 2}, 1, {-1}},
    {"L = 0", 2, 0, {0, 1}, 0, {0}},
    {"L = -2", 2, -2, {0, 1}, 0, {0}},
    {"tau[1] = 2, tau[2] = 1.5", 2, 3, {0, 2, 1.5, 3}, 0, {0}},
    {"tau[0] = 0.25, tau[1] = 0.25", 2, 2, {0.25, 0.25, 3}, 0, {0}},
    {"tau[1] = nan", 2, 2, {0, NAN, 3}, 0, {0}},
    {"inf", 2, 1, {0, HUGE_VAL}, 0, {0}},
    {"degree -1,", -1, 1, {0, 1}, 0, {0}},
    {"degree 32,", 32, 1, {0, 1}, 0, {0}},
};

static const struct partition *now_partition;
static constructor *now_constructor;

static void new_partition(void)
{
    const struct partition *p = now_partition;

    now_constructor(p->d, p->L, p->tau, p->has_mu ? p->mu : NULL);
}

static void over_partitions(constructor *construct)
{
    now_constructor = construct;
    for (size_t i = 0; i < sizeof PARTITIONS / sizeof *PARTITIONS; i++) {
        now_partition = PARTITIONS + i;
        test_aborts(now_partition->text, new_partition);
    }
}

static void bad_open(void)
{
    over_partitions(kw_bspline_new_open);
}

static void bad_periodic(void)
{
    over_partitions(kw_bspline_new_periodic);
}

/* --- equal cells --- */

static const struct cells {
    const char *text;
    int d, cells;
    double a, b;
} CELLS[] = {
    {"0 cells", 2, 0, 0, 1},         {"-1 cells", 2, -1, 0, 1},
    {"[2, 1]", 2, 3, 2, 1},          {"[3, 3]", 2, 3, 3, 3},
    {"[0, nan]", 2, 3, 0, NAN},      {"degree -1,", -1, 3, 0, 1},
    {"degree 32,", 32, 3, 0, 1},     {"[-1e+308, 1e+308]", 2, 3, -1e308, 1e308},
    {"[0, inf]", 2, 3, 0, HUGE_VAL}, {"2147483647 cells", 2, INT_MAX, 0, 1},
};

static const struct cells *now_cells;

static void new_uniform(void)
{
    kw_bspline_new_uniform(now_cells->d, now_cells->cells, now_cells->a, now_cells->b);
}

static void new_open_uniform(void)
{
    kw_bspline_new_open_uniform(now_cells->d, now_cells->cells, now_cells->a,
                                now_cells->b);
}

static void bad_cells(void)
{
    for (size_t i = 0; i < sizeof CELLS / sizeof *CELLS; i++) {
        now_cells = CELLS + i;
        test_aborts(now_cells->text, new_uniform);
        test_aborts(now_cells->text, new_open_uniform);
    }
}

/* --- points --- */

static void span_at(double x)
{
    kw_bspline_span(space, x);
}

static void basis_at(double x)
{
    kw_bspline_basis(space, x, scratch);
}

static void basis_many_at(double x)
{
    const double points[] = {1, x};
    int first[2];

    kw_bspline_basis_many(space, 2, points, first, scratch);
}

static void derivatives_at(double x)
{
    kw_bspline_derivatives(space, x, 1, scratch);
}

static void derivatives_many_at(double x)
{
    int first;

    kw_bspline_derivatives_many(space, 1, &x, 0, &first, scratch);
}

static void on_at(double x)
{
    kw_bspline_derivatives_on(space, 2, x, 1, scratch);
}

static void alone_at(double x)
{
    kw_bspline_derivative_on(space, 2, x, 1, scratch);
}

static void one_at(double x)
{
    kw_bspline_one(space, 1, 0, x);
}

static void (*now_point)(double x);
static double now_x;

static void call_point(void)
{
    now_point(now_x);
}

static void aborts_at(void (*call)(double), double x, const char *text)
{
    now_point = call;
    now_x = x;
    test_aborts(text, call_point);
}

static void outside_the_domain(void)
{
    void (*const calls[])(double) = {span_at, basis_at, basis_many_at, derivatives_at,
                                     derivatives_many_at};

    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        aborts_at(calls[i], -0.25, "x = -0.25 outside the domain [0, 2]");
        aborts_at(calls[i], nextafter(2, 3),
                  "x = 2.0000000000000004 outside the domain [0, 2]");
        aborts_at(calls[i], NAN, "x = nan");
        aborts_at(calls[i], -HUGE_VAL, "x = -inf outside the domain [0, 2]");
    }
}

static void no_number(void)
{
    void (*const calls[])(double) = {on_at, one_at, alone_at};

    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        aborts_at(calls[i], NAN, "x = nan");
        aborts_at(calls[i], HUGE_VAL, "x = inf");
        aborts_at(calls[i], -HUGE_VAL, "x = -inf");
    }
}

/* --- functions, orders, spans --- */

static void one_of(int j)
{
    kw_bspline_one(space, j, 0, 1);
}

static void first_span_of(int j)
{
    kw_bspline_first_span(space, j);
}

static void greville_of(int j)
{
    kw_bspline_greville(space, j);
}

static void one_order(int r)
{
    kw_bspline_one(space, 1, r, 1);
}

static void order(int r)
{
    kw_bspline_derivatives(space, 1, r, scratch);
}

static void on_order(int r)
{
    kw_bspline_derivatives_on(space, 2, 1, r, scratch);
}

static void alone_order(int r)
{
    kw_bspline_derivative_on(space, 2, 1, r, scratch);
}

static void alone_span(int i)
{
    kw_bspline_derivative_on(space, i, 1, 0, scratch);
}

static void on_span(int i)
{
    kw_bspline_derivatives_on(space, i, 1, 0, scratch);
}

static void pieces_on(int i)
{
    kw_bspline_pieces(space, i, scratch);
}

static void blossom_on(int i)
{
    kw_bspline_blossom(space, i, space->t, scratch);
}

static void knots_blossom_on(int i)
{
    kw_bspline_blossom_knots(space, i, space->t, scratch);
}

static void basis_many(int count)
{
    int first;

    kw_bspline_basis_many(space, count, space->t, &first, scratch);
}

static void derivatives_many(int count)
{
    int first;

    kw_bspline_derivatives_many(space, count, space->t, 0, &first, scratch);
}

static void span_many(int count)
{
    int span;

    kw_bspline_span_many(space, count, space->t, &span);
}

static const struct index {
    const char *text;
    void (*call)(int i);
    int i;
} INDICES[] = {
    {"function 5, not in 0 .. 4", one_of, 5},
    {"function -1, not in 0 .. 4", one_of, -1},
    {"function 5, not in 0 .. 4", first_span_of, 5},
    {"function -2, not in 0 .. 4", first_span_of, -2},
    {"function 6, not in 0 .. 4", greville_of, 6},
    {"function -1, not in 0 .. 4", greville_of, -1},
    {"derivative -1", one_order, -1},
    {"derivative -1", order, -1},
    {"derivative -3", on_order, -3},
    {"derivative -4", alone_order, -4},
    {"3 is no span", alone_span, 3},
    {"3 is no span", on_span, 3}, /* empty */
    {"1 is no span", on_span, 1}, /* below the domain */
    {"5 is no span", on_span, 5}, /* above it */
    {"3 is no span", pieces_on, 3},
    {"-1 is no span", pieces_on, -1},
    {"5 is no span", pieces_on, 5},
    {"3 is no span", blossom_on, 3},
    {"1 is no span", blossom_on, 1},
    {"5 is no span", blossom_on, 5},
    {"3 is no span", knots_blossom_on, 3},
    {"-1 is no span", knots_blossom_on, -1},
    {"-1 points", basis_many, -1},
    {"-2 points", derivatives_many, -2},
    {"-4 points", span_many, -4},
};

static const struct index *now_index;

static void call_index(void)
{
    now_index->call(now_index->i);
}

static void bad_indices(void)
{
    for (size_t i = 0; i < sizeof INDICES / sizeof *INDICES; i++) {
        now_index = INDICES + i;
        test_aborts(now_index->text, call_index);
    }
}

int main(void)
{
    const double t[] = {0, 0, 0, 1, 1, 2, 2, 2};

    space = kw_bspline_new(2, 5, t);
    test_run("bspline: bad knots and degrees abort and are named", bad_knots);
    test_run("bspline: so are bad partitions of open spaces", bad_open);
    test_run("bspline: so are those of periodic spaces", bad_periodic);
    test_run("bspline: so are no cells and empty intervals", bad_cells);
    test_run("bspline: so is a point outside the domain", outside_the_domain);
    test_run("bspline: so is what is no number", no_number);
    test_run("bspline: so are functions, orders, spans and counts that are none",
             bad_indices);
    kw_bspline_free(space);
    return test_end();
}
