/* bench_fit.c -- what a fit costs: least squares with a cubic spline, and the training of a
   network with as many parameters, on the samples of chapters/8-optimization. */
#include "bench.h"
#include "../../chapters/8-optimization/fit.h"
#include <stdio.h>

enum { WIDTHS = 4, CUBIC = 3, TRAINED_SEED = 3 };

typedef struct fits {
    kw_bspline *s;
    kw_net *net;
    double y[POINTS];
} fits;

static double run_spline(void *with)
{
    fits *f = with;

    fit_spline(f->s, f->y);
    return f->y[0];
}

static double run_net(void *with)
{
    fits *f = with;

    fit_net(f->net, TRAINED_SEED, f->y);
    return f->y[0];
}

int main(void)
{
    static const int width[WIDTHS] = {2, 4, 8, 16};
    static fits f;

    printf("%d samples, values at %d points\n", SAMPLES, POINTS);
    printf("parameters   spline us   network us    ratio\n");
    for (int i = 0; i < WIDTHS; i++) {
        double spline, net;

        f.net = new_net(width[i]);
        f.s = kw_bspline_new_open_uniform(CUBIC, f.net->parameters - CUBIC, -1, 1);
        spline = bench_median(run_spline, &f);
        net = bench_median(run_net, &f);
        printf("%10d %11.0f %12.0f %8.0f\n", f.net->parameters, spline / 1e3, net / 1e3,
               net / spline);
        fflush(stdout);
        kw_bspline_free(f.s);
        kw_net_free(f.net);
    }
    return 0;
}
