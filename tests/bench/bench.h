/* bench.h -- processor time of several works, side by side in one run. Only ratios within one run
   of a program mean much. */
#ifndef BENCH_H
#define BENCH_H

enum { BENCH_RUNS = 9 };

/* What is timed. It writes what it computes to memory. */
typedef void bench_work(void *with);

typedef struct bench_task {
    bench_work *work;
    void *with;
    double per; /* how many points, samples .. one call of work deals with */
    /* what bench_run finds: the time of one of them, in nanoseconds */
    double median, min, max;
} bench_task;

/* Each task once to warm up; then BENCH_RUNS rounds, in each of which every task is run in its
   turn, so that what disturbs the machine disturbs all alike. A run of a short work calls it
   several times. */
void bench_run(int tasks, bench_task *task);

/* The median of a over that of b. */
double bench_ratio(const bench_task *a, const bench_task *b);

#endif
