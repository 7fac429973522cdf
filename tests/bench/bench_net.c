/* bench_net.c -- what a training step costs: forward and backward through a net of affine and
   tanh layers in double precision. Beside it stands the peak, the most multiply-adds a
   nanosecond that a plain loop reaches in the same run, which follows the clock of the
   processor; the last column compares a step with the time its products take at the peak.

   The aim is a net 2-64-64-1, at -O3: both ways in at most AIM nanoseconds a sample, in the
   least disturbed of the runs. */
#include "bench.h"
#include "elementary.h"
#include "mlp.h"
#include "need.h"
#include "wide.h"
#include <stdio.h>

enum { ROUNDS = 50000, SUMS = 96, NUMBERS = 4096, L = 3, BATCH = 256, AIM = 2000 };

/* --- the peak --- */

/* So many sums side by side that none waits for itself. */
KW_WIDE static double side_by_side(double factor)
{
    double sum[SUMS], total = 0;

    for (int i = 0; i < SUMS; i++)
        sum[i] = i;
    for (int k = 0; k < ROUNDS; k++)
        for (int i = 0; i < SUMS; i++)
            sum[i] = sum[i] * factor + factor;
    for (int i = 0; i < SUMS; i++)
        total += sum[i];
    return total;
}

static double run_peak(void *with)
{
    return side_by_side(*(const double *)with);
}

/* Multiply-adds in a nanosecond. */
static double peak(void)
{
    double factor = 0.5;

    return (double)ROUNDS * SUMS / bench_median(run_peak, &factor);
}

/* --- tanh --- */

typedef struct numbers {
    double x[NUMBERS], y[NUMBERS];
} numbers;

static double run_tanh(void *with)
{
    numbers *v = with;

    kw_tanh_many(NUMBERS, v->x, v->y);
    return v->y[NUMBERS - 1];
}

/* --- a step --- */

typedef struct task {
    kw_net *n;
    kw_net_work *k;
    double *w, *dw, *x, *y, *dy;
} task;

static double forward(void *with)
{
    const task *t = with;

    kw_net_forward(t->n, t->w, BATCH, t->x, t->k, t->y);
    return t->y[0];
}

static double step(void *with)
{
    const task *t = with;

    kw_net_forward(t->n, t->w, BATCH, t->x, t->k, t->y);
    kw_net_backward(t->n, t->w, BATCH, t->x, t->y, t->dy, t->k, NULL, t->dw);
    return t->dw[0];
}

/* Multiply-adds of a step and a sample: each weight has one forward, one for its derivative,
   and one for the derivative that goes on to the layer before, unless that is the input. */
static double products(const kw_net *n)
{
    double sum = 0;

    for (int l = 1; l <= L; l++)
        sum += (l > 1 ? 3.0 : 2.0) * kw_mlp_count_weights(n, l);
    return sum;
}

static double *filled(int count)
{
    double *a = kw_need_memory((size_t)count, sizeof *a);

    for (int i = 0; i < count; i++)
        a[i] = 0.01 * (i % 100) - 0.5;
    return a;
}

static void measure(const int *width)
{
    const kw_activation_kind sigma[L] = {KW_TANH, KW_TANH, KW_IDENTITY};
    task t = {.n = kw_mlp_new(L, width, sigma)};
    bench_time ahead, both;
    double most = peak();

    t.k = kw_net_work_new(t.n, BATCH);
    t.w = filled(t.n->parameters);
    t.dw = filled(t.n->parameters);
    t.x = filled(BATCH * t.n->in);
    t.y = filled(BATCH * t.n->out);
    t.dy = filled(BATCH * t.n->out);
    kw_net_init(t.n, 1, t.w);
    ahead = bench_run(forward, &t);
    both = bench_run(step, &t);
    printf("%2d-%3d-%3d-%d %6.0f %6.0f %8.0f %6.0f %15.0f %9.1f %10.0f %%\n", width[0],
           width[1], width[2], width[3], ahead.least / BATCH, ahead.median / BATCH,
           both.least / BATCH, both.median / BATCH, products(t.n), most,
           100 * products(t.n) * BATCH / both.median / most);
    fflush(stdout);
    kw_net_work_free(t.k);
    kw_net_free(t.n);
    free(t.w);
    free(t.dw);
    free(t.x);
    free(t.y);
    free(t.dy);
}

int main(void)
{
    const int shapes[][L + 1] = {{2, 64, 64, 1}, {2, 32, 32, 1}, {16, 128, 128, 4}};
    static numbers v;

    for (int i = 0; i < NUMBERS; i++)
        v.x[i] = 4.0 * (i * 37 % NUMBERS) / NUMBERS - 2;
    printf("tanh nets, %d samples, per sample; tanh alone takes %.2f ns a number\n",
           BATCH, bench_median(run_tanh, &v) / NUMBERS);
    printf("in nanoseconds, the least and the median of the runs; the aim for 2-64-64-1, "
           "both "
           "ways: at most %d\n",
           AIM);
    printf("shape           forward       both ways   multiply-adds   peak/ns  of the "
           "peak\n");
    for (int i = 0; i < 3; i++)
        measure(shapes[i]);
    return 0;
}
