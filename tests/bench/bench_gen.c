/* bench_gen.c -- what it costs to make binary sets with the program gen: processor time against
   writing as many bytes from memory, time on the clock with one process and with two, and memory.
   Files go to $TMPDIR, up to half a GB at a time, and are removed. */
#include "need.h"
#include "out.h"
#include "sha256.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { RUNS = 5, PATH = 600 };

static char folder[500];

/* --- clocks, in seconds --- */

static double seconds(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Processor time of this program. */
static double own(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

/* Processor time of all programs that it has run. */
static double of_children(void)
{
    struct rusage u;

    getrusage(RUSAGE_CHILDREN, &u);
    return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
           1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

/* --- sets --- */

static void run(const char *command)
{
    int status = system(command);

    KW_NEED(status == 0, "%s: status %d", command, status);
}

/* Seconds that a set took: on the clock, and of processor time. */
typedef struct cost {
    double clock, processor;
} cost;

/* Makes a set in an empty folder; what emptying it costs is not counted. */
static cost make(const char *call)
{
    char command[2 * PATH];
    cost begin;

    snprintf(command, sizeof command, "rm -rf %s/set", folder);
    run(command);
    snprintf(command, sizeof command, "exec %s/bin/gen %s --format npy --out %s/set",
             KW_BUILD, call, folder);
    begin = (cost){seconds(CLOCK_MONOTONIC), of_children()};
    run(command);
    return (cost){seconds(CLOCK_MONOTONIC) - begin.clock,
                  of_children() - begin.processor};
}

/* --- processor time --- */

/* Processor seconds of the sum of a file; *bytes is its length. */
static double sum(const char *path, uint64_t *bytes)
{
    char text[KW_SHA256_TEXT];
    double begin = own();

    KW_NEED(kw_sha256_file(path, text, bytes) == 0, "cannot read %s", path);
    return own() - begin;
}

/* The same of writing so many bytes from memory. */
static double copy(uint64_t bytes)
{
    enum { SIZE = 1 << 16 };
    unsigned char *from = kw_need_memory(SIZE, 1);
    char path[PATH];
    double begin = own();
    kw_out *f;

    snprintf(path, sizeof path, "%s/copy", folder);
    f = kw_out_new(path);
    for (uint64_t done = 0; done < bytes; done += SIZE)
        kw_out_bytes(f, from, bytes - done < SIZE ? (size_t)(bytes - done) : SIZE);
    KW_NEED(kw_out_close(f) == 0, "%s", path);
    free(from);
    return own() - begin;
}

static void show_speed(const char *call)
{
    double whole = 1e9, summing = 1e9, writing = 1e9, megabytes;
    uint64_t bytes = 0;
    char path[PATH];

    snprintf(path, sizeof path, "%s/set/points/train-00000-of-00001.npy", folder);
    for (int i = 0; i < RUNS; i++) { /* the least: what disturbs a run makes it slower */
        whole = least(whole, make(call).processor);
        summing = least(summing, sum(path, &bytes));
        writing = least(writing, copy(bytes));
    }
    megabytes = 1e-6 * (double)bytes;
    printf("%-40s %7.0f %8.0f %8.0f %8.0f %8.1f\n", call, megabytes / whole,
           megabytes / (whole - summing), megabytes / summing, megabytes / writing,
           whole / writing);
    fflush(stdout);
}

/* --- processes --- */

/* The least of several runs by one process and by two, in turns. */
static void show_jobs(const char *call)
{
    cost best[2] = {{1e9, 1e9}, {1e9, 1e9}};
    char words[PATH];

    for (int i = 0; i < 2 * RUNS; i++) {
        cost *b = &best[i % 2], c;

        snprintf(words, sizeof words, "%s --jobs %d", call, i % 2 + 1);
        c = make(words);
        b->clock = least(b->clock, c.clock);
        b->processor = least(b->processor, c.processor);
    }
    printf("%-40s %7.2f %8.2f %8.2f %8.2f\n", call, best[0].clock, best[1].clock,
           best[0].clock / best[1].clock, best[1].processor / best[0].processor);
    fflush(stdout);
}

/* --- memory --- */

/* By a process of its own, whose children have run nothing else before. */
static void show_memory(const char *call)
{
    struct rusage u;
    pid_t child = fork();
    int status = 0;

    KW_NEED(child >= 0, "no process for %s", call);
    if (child == 0) {
        make(call);
        getrusage(RUSAGE_CHILDREN, &u);
        printf("%-40s %7.1f\n", call, 1.024e-3 * (double)u.ru_maxrss);
        fflush(stdout);
        _exit(0);
    }
    KW_NEED(waitpid(child, &status, 0) == child && status == 0, "%s: status %d", call,
            status);
}

int main(void)
{
    const char *place = getenv("TMPDIR");
    char command[PATH];

    snprintf(folder, sizeof folder, "%s/knotwork.XXXXXX",
             place && *place ? place : "/tmp");
    KW_NEED(mkdtemp(folder), "no folder %s", folder);
    printf(
        "Sets in NPY, MB a second of processor time: making and writing them, the sums, "
        "the whole of\n"
        "both, and writing as many bytes from memory; the last column is time of the "
        "whole / writing\n"
        "%-40s %7s %8s %8s %8s %8s\n",
        "gen", "whole", "making", "sums", "writing", "ratio");
    show_speed("curve --count 20000");
    show_speed("curve --count 20000 --noise 0");
    show_speed("curve --count 20000 --parameters equal");
    show_speed("scatter --count 2500");
    show_speed("scatter --count 2500 --surface peak");
    printf(
        "\nSeconds on the clock by one process and by two, one / two, and processor time "
        "two / one\n"
        "%-40s %7s %8s %8s %8s\n",
        "gen", "one", "two", "ratio", "time");
    show_jobs("curve --count 40000 --shards 8");
    show_jobs("scatter --count 5000 --shards 8");
    printf("\nMemory, MB at most\n%-40s %7s\n", "gen", "");
    fflush(stdout);
    show_memory("curve --count 10000");
    show_memory("curve --count 100000");
    show_memory("scatter --count 1000");
    show_memory("scatter --count 10000");
    show_memory("scatter --count 10 --points 1000000");
    snprintf(command, sizeof command, "rm -rf %s", folder);
    run(command);
    return 0;
}
