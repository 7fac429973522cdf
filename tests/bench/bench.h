/* bench.h -- processor time, as the median and the least of several runs. Only ratios within one run of
   the program mean much. */
#ifndef BENCH_H
#define BENCH_H

#include <stdlib.h>
#include <time.h>

/* Runs go on until there are enough of them or enough time has passed. */
enum { BENCH_FEWEST = 3, BENCH_MOST = 25 };
static const double bench_enough = 1e9; /* nanoseconds */

/* What is timed. It returns a number that depends on all it computes, so that no compiler
   leaves anything out. */
typedef double bench_work(void *with);

static inline double bench_now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static inline int bench_ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

/* Times in nanoseconds. The least is that of the run that was disturbed least. */
typedef struct bench_time {
    double least, median;
} bench_time;

/* The times of work(with), after a run that warms up. */
static inline bench_time bench_run(bench_work *work, void *with)
{
    volatile double kept = work(with);
    double time[BENCH_MOST], begin = bench_now(), start = begin;
    int runs = 0;

    while (runs < BENCH_FEWEST || (runs < BENCH_MOST && start - begin < bench_enough)) {
        double end;

        kept = work(with);
        end = bench_now();
        time[runs++] = end - start;
        start = end;
    }
    (void)kept;
    qsort(time, (size_t)runs, sizeof *time, bench_ascending);
    return (bench_time){.least = time[0], .median = time[runs / 2]};
}

static inline double bench_median(bench_work *work, void *with)
{
    return bench_run(work, with).median;
}

#endif
