/* bench_fit.c -- what a fit costs: least squares with a cubic spline, and the training of a
   network with as many parameters, on the samples of chapters/8-optimization. */
#include "../../chapters/8-optimization/fit.h"
#include "bench.h"
#include <stdio.h>

enum { WIDTHS = 4, CUBIC = 3, TRAINED_SEED = 3 };

typedef struct fits {
    kw_bspline *s;
    kw_net *net;
    double y[POINTS];
} fits;

static void run_spline(void *with)
{
    fits *f = with;

    fit_spline(f->s, f->y);
}

static void run_net(void *with)
{
    fits *f = with;

    fit_net(f->net, TRAINED_SEED, f->y);
}

int main(void)
{
    static const int width[WIDTHS] = {2, 4, 8, 16};
    static fits f[WIDTHS];
    bench_task task[2 * WIDTHS];

    for (int i = 0; i < WIDTHS; i++) {
        f[i].net = new_net(width[i]);
        f[i].s = kw_bspline_new_open_uniform(CUBIC, f[i].net->parameters - CUBIC, -1, 1);
        task[2 * i] = (bench_task){.work = run_spline, .with = &f[i], .per = 1e3};
        task[2 * i + 1] = (bench_task){.work = run_net, .with = &f[i], .per = 1e3};
    }
    bench_run(2 * WIDTHS, task);
    printf("\n%d samples, values at %d points\n"
           "parameters   spline us   network us    ratio\n",
           SAMPLES, POINTS);
    for (int i = 0; i < WIDTHS; i++) {
        const bench_task *spline = &task[2 * i], *net = spline + 1;

        printf("%10d %11.0f %12.0f %8.0f\n", f[i].net->parameters, spline->median,
               net->median, bench_ratio(net, spline));
        kw_bspline_free(f[i].s);
        kw_net_free(f[i].net);
    }
    return 0;
}
