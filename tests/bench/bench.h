/* bench.h -- time, as the median of several runs. Only ratios within one run mean much. */
#ifndef BENCH_H
#define BENCH_H

#include <stdlib.h>
#include <time.h>

enum { BENCH_RUNS = 3 };

/* What is timed. It returns a number that depends on all it computes, so that no compiler
   leaves anything out. */
typedef double bench_work(void *with);

static inline double bench_now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static inline int bench_ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

/* The median time of work(with) in nanoseconds, after a run that warms up. */
static inline double bench_median(bench_work *work, void *with)
{
    volatile double kept;
    double time[BENCH_RUNS];

    kept = work(with);
    for (int i = 0; i < BENCH_RUNS; i++) {
        double start = bench_now();

        kept = work(with);
        time[i] = 1e9 * (bench_now() - start);
    }
    (void)kept;
    qsort(time, BENCH_RUNS, sizeof *time, bench_ascending);
    return time[BENCH_RUNS / 2];
}

#endif
