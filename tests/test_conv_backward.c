#include "convlayer.h"
#include <float.h>
#include <math.h>

/* --- derivatives, exactly, on integers, over a batch --- */

/* The output is affine in x: dx is what a unit more of each input does to <dy, y>. */
static void dx_is_what_an_input_does(const kw_conv *l, kw_rng *r)
{
    int in = COUNT * l->in, out = COUNT * l->out;
    double *w = new_integers(r, l->parameters), *x = new_integers(r, in);
    double *y = new_numbers(out), *dy = new_integers(r, out);
    double *dx = new_numbers(in + 1), *dw = new_integers(r, l->parameters), before;

    kw_conv_forward(l, w, COUNT, x, y);
    before = dot(out, dy, y);
    kw_conv_backward(l, w, COUNT, x, y, dy, dx, dw);
    CHECK(isnan(dx[in]), "more than %d numbers", in);
    for (int i = 0; i < in; i++) {
        double more;

        x[i] += 1;
        kw_conv_forward(l, w, COUNT, x, y);
        more = dot(out, dy, y) - before;
        CHECK(dx[i] == more, "input %d: %g, not %g", i, dx[i], more);
        x[i] -= 1;
    }
    free(w);
    free(x);
    free(y);
    free(dy);
    free(dx);
    free(dw);
}

/* And affine in each parameter; dw is added to, with dx wanted or not. */
static void dw_is_what_a_parameter_does(const kw_conv *l, kw_rng *r)
{
    int P = l->parameters, out = COUNT * l->out;
    double *w = new_integers(r, P), *x = new_integers(r, COUNT * l->in);
    double *y = new_numbers(out), *dy = new_integers(r, out);
    double *dx = kw_rng_below(r, 2) ? new_numbers(COUNT * l->in) : NULL;
    double *dw = new_numbers(P + 1), before;

    for (int i = 0; i < P; i++)
        dw[i] = 1000 * i;
    kw_conv_forward(l, w, COUNT, x, y);
    before = dot(out, dy, y);
    kw_conv_backward(l, w, COUNT, x, y, dy, dx, dw);
    CHECK(isnan(dw[P]), "more than %d numbers", P);
    for (int i = 0; i < P; i++) {
        double more;

        w[i] += 1;
        kw_conv_forward(l, w, COUNT, x, y);
        more = dot(out, dy, y) - before;
        CHECK(dw[i] - 1000 * i == more, "parameter %d: %g, not %g", i, dw[i] - 1000 * i,
              more);
        w[i] -= 1;
    }
    free(w);
    free(x);
    free(y);
    free(dy);
    free(dx);
    free(dw);
}

/* --- derivatives by central differences ---

   Of f = |y|^2 / 2, so that dy = y. As f is a quadratic function of each number alone, a
   central difference has no error but that of rounding, with the step 1 too. A number of
   the output has K terms and K roundings; f has twice that, a product and the sum over all
   outputs; the derivative has K, a product and the sum over the outputs, or over the filters.
   All are relative to the sum of the absolute values of the terms of f, which is f with all
   numbers positive. */

static double half_square(const kw_conv *l, const double *w, const double *x, double *y)
{
    kw_conv_forward(l, w, 1, x, y);
    return dot(l->out, y, y) / 2;
}

static int roundings(const kw_conv *l)
{
    int filter = l->filter_rows * l->filter_columns;

    return 3 * (l->in_channels * filter + 1) + 2 * l->out + l->out_channels * filter + 4;
}

/* The sum of the absolute values of the terms of f where no number is above 1, but one that
   is at most 2. */
static double size_of(const kw_conv *l)
{
    double K = l->in_channels * l->filter_rows * l->filter_columns + 1;

    return l->out * (2 * K) * (2 * K) / 2;
}

/* a[0..count-1] is the input or the parameters, g the derivatives with respect to it. */
static void check_differences(const kw_conv *l, const double *w, const double *x,
                              double *a, int count, const double *g, double *y)
{
    double most = roundings(l) * (DBL_EPSILON / 2) * size_of(l);

    for (int i = 0; i < count; i++) {
        double kept = a[i], difference;

        a[i] = kept + 1;
        difference = half_square(l, w, x, y);
        a[i] = kept - 1;
        difference = (difference - half_square(l, w, x, y)) / 2;
        a[i] = kept;
        CHECK(fabs(difference - g[i]) <= most, "%d: %.17g, not %.17g", i, g[i],
              difference);
    }
}

static void derivatives_are_central_differences(const kw_conv *l, kw_rng *r)
{
    double *w = new_numbers(l->parameters), *x = new_numbers(l->in);
    double *y = new_numbers(l->out), *dx = new_numbers(l->in);
    double *dw = kw_need_memory((size_t)l->parameters, sizeof *dw);

    /* multiples of 2^-20, so that 1 more or less is no rounding */
    for (int i = 0; i < l->parameters; i++)
        w[i] = ldexp(kw_rng_below(r, 1 << 21), -20) - 1;
    for (int i = 0; i < l->in; i++)
        x[i] = ldexp(kw_rng_below(r, 1 << 21), -20) - 1;
    kw_conv_forward(l, w, 1, x, y);
    kw_conv_backward(l, w, 1, x, y, y, dx, dw);
    check_differences(l, w, x, x, l->in, dx, y);
    check_differences(l, w, x, w, l->parameters, dw, y);
    free(w);
    free(x);
    free(y);
    free(dx);
    free(dw);
}

int main(void)
{
    run_over_layers("conv: dx is what a unit more of an input does, exactly",
                    dx_is_what_an_input_does);
    run_over_layers("conv: dw is what a unit more of a parameter does, exactly",
                    dw_is_what_a_parameter_does);
    run_over_layers("conv: derivatives are central differences",
                    derivatives_are_central_differences);
    return test_end();
}
