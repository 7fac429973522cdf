/* Bad input to the curves: each call aborts, and its message names the value. */
#include "curve.h"
#include "spline.h"
#include <stddef.h>

static kw_bspline *space; /* quadratic on 0, 1 (twice), 2, open: span 3 is empty */
static double c[10], scratch[ROOM];

/* what the calls below are given; N, order, span and x are good but for one of them */
static struct arguments {
    int N, order, span;
    double x;
} now;

static void point(void)
{
    kw_curve_point(space, now.N, c, now.x, scratch);
}

static void deboor(void)
{
    kw_curve_deboor(space, now.N, c, now.x, scratch);
}

static void derivatives(void)
{
    kw_curve_derivatives(space, now.N, c, now.x, now.order, scratch);
}

static void point_many(void)
{
    const double x[] = {0.5, now.x};

    kw_curve_point_many(space, now.N, c, 2, x, scratch);
}

static void deboor_many(void)
{
    const double x[] = {0.5, now.x};

    kw_curve_deboor_many(space, now.N, c, 2, x, scratch);
}

static void derivatives_many(void)
{
    const double x[] = {0.5, now.x};

    kw_curve_derivatives_many(space, now.N, c, 2, x, now.order, scratch);
}

static void blossom(void)
{
    kw_curve_blossom(space, now.span, now.N, c, space->t, scratch);
}

static void closed(void)
{
    kw_curve_close(space, now.N, c);
}

static void (*const AT_A_POINT[])(void) = {point,      deboor,      derivatives,
                                           point_many, deboor_many, derivatives_many};

enum { CALLS = sizeof AT_A_POINT / sizeof *AT_A_POINT };

static void outside_the_domain(void)
{
    for (int i = 0; i < CALLS; i++) {
        now = (struct arguments){.N = 2, .x = -0.25};
        test_aborts("x = -0.25 outside the domain [0, 2]", AT_A_POINT[i]);
        now.x = nextafter(2, 3);
        test_aborts("x = 2.0000000000000004 outside the domain [0, 2]", AT_A_POINT[i]);
        now.x = NAN;
        test_aborts("x = nan outside", AT_A_POINT[i]);
        now.x = HUGE_VAL;
        test_aborts("x = inf outside", AT_A_POINT[i]);
    }
}

static void no_coordinates(void)
{
    now = (struct arguments){.N = 0, .span = 2, .x = 1};
    for (int i = 0; i < CALLS; i++)
        test_aborts("N = 0", AT_A_POINT[i]);
    now.N = -1;
    test_aborts("N = -1", point);
    test_aborts("N = -1", blossom);
    test_aborts("N = -1", closed);
}

static void no_order(void)
{
    now = (struct arguments){.N = 2, .order = -1, .x = 1};
    test_aborts("derivative -1", derivatives);
    test_aborts("derivative -1", derivatives_many);
}

static void fewer_than_no_points(void)
{
    kw_curve_point_many(space, 2, c, -1, space->t, scratch);
}

static void fewer_than_no_averages(void)
{
    kw_curve_deboor_many(space, 2, c, -2, space->t, scratch);
}

static void fewer_than_no_derivatives(void)
{
    kw_curve_derivatives_many(space, 2, c, -3, space->t, 0, scratch);
}

static void no_count(void)
{
    test_aborts("-1 points", fewer_than_no_points);
    test_aborts("-2 points", fewer_than_no_averages);
    test_aborts("-3 points", fewer_than_no_derivatives);
}

static void no_span(void)
{
    now = (struct arguments){.N = 2, .span = 3}; /* empty */
    test_aborts("3 is no span", blossom);
    now.span = 1;
    test_aborts("1 is no span", blossom);
    now.span = 5;
    test_aborts("5 is no span", blossom);
}

int main(void)
{
    const double t[] = {0, 0, 0, 1, 1, 2, 2, 2};

    space = kw_bspline_new(2, 5, t);
    test_run("curve: a point outside the domain aborts and is named", outside_the_domain);
    test_run("curve: so is a space of no coordinates", no_coordinates);
    test_run("curve: so is a negative order", no_order);
    test_run("curve: so is a negative number of points", no_count);
    test_run("curve: so is a span that is none", no_span);
    kw_bspline_free(space);
    return test_end();
}
