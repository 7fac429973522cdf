/* bench_gen.c -- what it costs to make binary sets: processor time of the program gen, against
   writing as many bytes from memory and against the sums that it takes of its files. Making is
   what is left of the whole without the sums. Files go to $TMPDIR and are removed. */
#include "bench.h"
#include "need.h"
#include "out.h"
#include "sha256.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { RUNS = 3, PATH = 600 };

static char folder[500];

static double seconds_of_children(void)
{
    struct rusage u;

    getrusage(RUSAGE_CHILDREN, &u);
    return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
           1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

/* Processor seconds of a command of the shell. */
static double run(const char *command)
{
    double before = seconds_of_children();
    int status = system(command);

    KW_NEED(status == 0, "%s: status %d", command, status);
    return seconds_of_children() - before;
}

static double set(void *with)
{
    char command[4 * PATH];

    snprintf(command, sizeof command,
             "rm -rf %s/set && %s/bin/gen %s --format npy --out %s/set", folder, KW_BUILD,
             (const char *)with, folder);
    return run(command);
}

/* The least of several runs: whatever disturbs them makes them slower. */
static double least(double (*work)(void *), void *with)
{
    double best = work(with);

    for (int i = 1; i < RUNS; i++) {
        double time = work(with);

        best = time < best ? time : best;
    }
    return best;
}

static double sums(void *with)
{
    char text[KW_SHA256_TEXT];
    double begin = bench_now();

    KW_NEED(kw_sha256_file(with, text, NULL) == 0, "cannot read %s", (const char *)with);
    return 1e-9 * (bench_now() - begin);
}

/* Writes as many bytes as a file has, from memory. */
static double copy(void *with)
{
    enum { PART = 1 << 16 };
    const uint64_t bytes = *(const uint64_t *)with;
    unsigned char *part = kw_need_memory(PART, 1);
    char path[PATH];
    double begin = bench_now();
    kw_out *f;

    snprintf(path, sizeof path, "%s/copy", folder);
    f = kw_out_new(path);
    for (uint64_t done = 0; done < bytes; done += PART)
        kw_out_bytes(f, part, PART);
    KW_NEED(kw_out_close(f) == 0, "%s", path);
    free(part);
    return 1e-9 * (bench_now() - begin);
}

static void show(const char *call)
{
    char path[PATH], text[KW_SHA256_TEXT], words[PATH];
    uint64_t bytes;
    double whole, summing, writing, megabytes;

    snprintf(words, sizeof words, "%s", call);
    whole = least(set, words);
    snprintf(path, sizeof path, "%s/set/points/train-00000-of-00001.npy", folder);
    KW_NEED(kw_sha256_file(path, text, &bytes) == 0, "cannot read %s", path);
    summing = least(sums, path);
    writing = least(copy, &bytes);
    megabytes = 1e-6 * (double)bytes;
    printf("%-40s %7.0f %8.0f %8.0f %8.0f %8.1f\n", call, megabytes / whole,
           megabytes / (whole - summing), megabytes / summing, megabytes / writing,
           (whole - summing) / writing);
    fflush(stdout);
}

int main(void)
{
    const char *place = getenv("TMPDIR");
    char command[PATH];

    snprintf(folder, sizeof folder, "%s/knotwork.XXXXXX",
             place && *place ? place : "/tmp");
    KW_NEED(mkdtemp(folder), "no folder %s", folder);
    printf("Sets in NPY, MB a second of processor time; the last column is making / "
           "writing\n"
           "%-40s %7s %8s %8s %8s %8s\n",
           "gen", "whole", "making", "sums", "writing", "ratio");
    show("curve --count 20000");
    show("curve --count 20000 --noise 0");
    show("curve --count 20000 --parameters equal");
    show("scatter --count 2500");
    show("scatter --count 2500 --surface peak");
    snprintf(command, sizeof command, "rm -rf %s", folder);
    run(command);
    return 0;
}
