#include "bench.h"
#include "need.h"
#include <math.h>
#include <stdlib.h>
#include <time.h>

/* A run takes at least so long, in nanoseconds: neither the clock itself counts then, nor that the
   work before has left the caches full of its own. */
static const double LEAST = 2e7;

/* Processor time in nanoseconds. */
static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* The time of one call of the work. */
static double timed(const bench_task *t, int calls)
{
    double begin = now();

    for (int i = 0; i < calls; i++)
        t->work(t->with);
    return (now() - begin) / calls;
}

static int ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

void bench_run(int tasks, bench_task *task)
{
    double *time = kw_need_memory((size_t)tasks * BENCH_RUNS, sizeof *time);
    int *calls = kw_need_memory((size_t)tasks, sizeof *calls);

    for (int i = 0; i < tasks; i++) {
        timed(&task[i], 1);
        calls[i] = (int)ceil(LEAST / fmax(timed(&task[i], 1), 1));
    }
    for (int run = 0; run < BENCH_RUNS; run++)
        for (int i = 0; i < tasks; i++)
            time[i * BENCH_RUNS + run] = timed(&task[i], calls[i]) / task[i].per;
    for (int i = 0; i < tasks; i++) {
        double *of = time + i * BENCH_RUNS;

        qsort(of, BENCH_RUNS, sizeof *of, ascending);
        task[i].min = of[0];
        task[i].median = of[BENCH_RUNS / 2];
        task[i].max = of[BENCH_RUNS - 1];
    }
    free(time);
    free(calls);
}

double bench_ratio(const bench_task *a, const bench_task *b)
{
    return a->median / b->median;
}
