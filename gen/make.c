/* make.c -- all shards of a call, by one process or by several. */
#include "gen.h"
#include "set.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* --- progress --- */

void gen_progress_step(gen_progress *g)
{
    long now;

    g->done++;
    if (g->parent != 0 && getppid() != (pid_t)g->parent)
        _exit(GEN_BAD_INPUT);
    if (!g->shown)
        return;
    now = (long)time(NULL);
    if (now - g->last < 1 + !g->written)
        return;
    /* the cursor goes back: what comes next, a message too, takes the place of the line */
    fprintf(stderr, "gen: %.0f %%\r", 100 * (double)g->done / (double)g->total);
    g->last = now;
    g->written = 1;
}

/* --- shards --- */

static uint64_t samples_of(const gen_call *c, int shard)
{
    uint64_t begin, end, samples = 0;

    for (gen_split s = GEN_TRAIN; s < GEN_SPLITS; s++) {
        gen_range(c, s, shard, &begin, &end);
        samples += end - begin;
    }
    return samples;
}

/* The shards first, first + step, .. */
static int make_shards(const gen_call *c, const gen_plan *p, int first, int step,
                       long parent)
{
    const int speaks = parent == 0 || first == 0; /* one worker does for all */
    gen_progress g = {.shown = speaks && isatty(STDERR_FILENO),
                      .last = (long)time(NULL),
                      .parent = parent};
    uint64_t done = 0;
    int status = GEN_GOOD;

    for (int k = first; k < c->shards; k += step)
        g.total += samples_of(c, k);
    for (int k = first; k < c->shards && status == GEN_GOOD; k += step) {
        status = gen_shard_make(c, p, k, &g);
        done += samples_of(c, k);
        g.done = done; /* a shard that is left alone counts, too */
    }
    if (g.written && status == GEN_GOOD)
        fputs("gen: 100 %\n", stderr);
    return status;
}

static int wait_for(pid_t worker)
{
    int status = 0;

    while (waitpid(worker, &status, 0) < 0)
        if (errno != EINTR)
            return gen_say(GEN_BAD_INPUT, "lost a worker: %s", strerror(errno));
    if (WIFSIGNALED(status))
        return gen_say(GEN_BAD_INPUT, "a worker was ended by signal %d",
                       WTERMSIG(status));
    return WEXITSTATUS(status);
}

/* Each worker has its shards; the first that could not be started ends the row. */
static int share_shards(const gen_call *c, const gen_plan *p)
{
    pid_t worker[GEN_JOBS], parent = getpid();
    int workers = 0, status = GEN_GOOD;

    while (workers < c->jobs && status == GEN_GOOD) {
        pid_t child = fork();

        if (child == 0)
            _exit(make_shards(c, p, workers, c->jobs, (long)parent));
        if (child < 0)
            status = gen_say(GEN_BAD_INPUT, "cannot start a worker: %s", strerror(errno));
        else
            worker[workers++] = child;
    }
    for (int i = 0; i < workers; i++) {
        int ended = wait_for(worker[i]);

        if (status == GEN_GOOD)
            status = ended;
    }
    return status;
}

/* --- a set --- */

int gen_make(const gen_family *family, int count, char *const *word)
{
    gen_plan plan = {0};
    gen_call c;
    int status = gen_call_read(&c, family, count, word);

    if (status != GEN_GOOD)
        return status;
    family->plan(&c, &plan);
    status = gen_folder_begin(&c, &plan);
    if (status != GEN_GOOD)
        return status;
    if (c.shard >= 0)
        return make_shards(&c, &plan, c.shard, c.shards, 0);
    status = c.jobs > 1 ? share_shards(&c, &plan) : make_shards(&c, &plan, 0, 1, 0);
    return status == GEN_GOOD ? gen_about(&c, &plan) : status;
}
