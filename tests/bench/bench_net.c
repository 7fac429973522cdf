/* bench_net.c -- what a training step costs: forward and backward through a net of affine and
   tanh layers in double precision. The last columns compare a step with the time of its
   products at the peak, the most that a loop of multiplications, each followed by an
   addition, reaches in the same run, and at the peak of fused ones, which round once. */
#include "bench.h"
#include "elementary.h"
#include "machine.h"
#include "work_net.h"
#include <stdio.h>

enum { NUMBERS = 4096, SHAPES = 3 };

typedef struct numbers {
    double x[NUMBERS], y[NUMBERS];
} numbers;

static void work_tanh(void *with)
{
    numbers *v = with;

    kw_tanh_many(NUMBERS, v->x, v->y);
}

int main(void)
{
    enum { TANH, PLAIN, FUSED, NETS, TASKS = NETS + 2 * SHAPES };
    static const int width[SHAPES][WORK_LAYERS + 1] = {
        {2, 64, 64, 1}, {2, 32, 32, 1}, {16, 128, 128, 4}};
    static numbers v;
    machine *m = machine_new();
    net_work *net[SHAPES];
    bench_task task[TASKS] = {
        [TANH] = {.work = work_tanh, .with = &v, .per = NUMBERS},
        [PLAIN] = {.work = machine_multiply_add, .with = m, .per = MACHINE_MULTIPLY_ADDS},
        [FUSED] = {.work = machine_fused, .with = m, .per = MACHINE_MULTIPLY_ADDS}};

    for (int i = 0; i < NUMBERS; i++)
        v.x[i] = 4.0 * (i * 37 % NUMBERS) / NUMBERS - 2;
    for (int i = 0; i < SHAPES; i++) {
        bench_task ahead = {.work = work_forward, .per = WORK_BATCH}, both = ahead;

        ahead.with = both.with = net[i] = net_work_new(width[i]);
        both.work = work_step;
        task[NETS + 2 * i] = ahead;
        task[NETS + 2 * i + 1] = both;
    }
    bench_run(TASKS, task);
    printf("\ntanh nets, %d samples; tanh alone takes %.2f ns a number, multiply-adds "
           "%.1f in a nanosecond, fused %.1f\n",
           WORK_BATCH, task[TANH].median, 1 / task[PLAIN].median, 1 / task[FUSED].median);
    printf("shape             forward   both ways, ns a sample   multiply-adds   of "
           "their time at the peak   fused\n");
    for (int i = 0; i < SHAPES; i++) {
        const bench_task *both = &task[NETS + 2 * i + 1];
        double products = net_multiply_adds(net[i]);

        printf("%2d-%3d-%3d-%d %12.0f %11.0f %29.0f %15.2f %16.2f\n", width[i][0],
               width[i][1], width[i][2], width[i][3], task[NETS + 2 * i].median,
               both->median, products, both->median / products / task[PLAIN].median,
               both->median / products / task[FUSED].median);
        net_work_free(net[i]);
    }
    machine_free(m);
    return 0;
}
