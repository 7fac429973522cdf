/* shard.c -- one shard of a set: its files, then their sums. */
#include "gen.h"
#include "out.h"
#include "set.h"
#include "sha256.h"
#include <string.h>

/* What is needed to make the samples of a shard. */
typedef struct maker {
    const gen_call *call;
    const gen_plan *plan;
    void *work;
    gen_sample sample;
    gen_table *table[GEN_ARRAYS][GEN_OWN_FORMAT];
    gen_progress *progress;
} maker;

/* --- tables of one split --- */

static void open_tables(maker *m, gen_split split, int shard)
{
    char relative[GEN_PATH], path[GEN_PATH];

    for (int a = 0; a < m->plan->arrays; a++)
        for (int f = GEN_CSV; f <= GEN_NPY; f++) {
            m->table[a][f] = NULL;
            if (!m->call->format[f])
                continue;
            gen_path_table(m->call, &m->plan->array[a], split, shard, f, relative);
            gen_path_join(m->call, relative, path);
            m->table[a][f] = gen_table_new(&m->plan->array[a], f, path);
        }
}

static int add_to_tables(maker *m)
{
    const gen_sample *s = &m->sample;
    int failed = 0;

    for (int a = 0; a < m->plan->arrays; a++)
        for (int f = GEN_CSV; f <= GEN_NPY; f++)
            if (m->table[a][f])
                failed |=
                    gen_table_add(m->table[a][f], s->index, s->rows[a], s->value[a]);
    return failed;
}

/* After a failure the tables that are well are given up; the others say what it was. */
static int close_tables(maker *m, int failed)
{
    for (int a = 0; a < m->plan->arrays; a++)
        for (int f = GEN_CSV; f <= GEN_NPY; f++) {
            gen_table *t = m->table[a][f];

            if (t && failed && !gen_table_failed(t))
                gen_table_drop(t);
            else if (t)
                failed |= gen_table_close(t);
        }
    return failed;
}

/* --- samples --- */

static int write_own_files(maker *m, gen_split split)
{
    const gen_call *c = m->call;
    char relative[GEN_PATH], path[GEN_PATH];
    int failed = 0;

    for (int f = GEN_OWN_FORMAT; f < GEN_FORMATS && !failed; f++)
        if (c->format[f]) {
            gen_path_sample(c, split, f, m->sample.index, relative);
            gen_path_join(c, relative, path);
            failed = c->family->write(c, &m->sample, f - GEN_OWN_FORMAT, path);
        }
    return failed;
}

static int make_samples(maker *m, gen_split split, int shard)
{
    uint64_t begin, end;
    int failed = 0;

    gen_range(m->call, split, shard, &begin, &end);
    open_tables(m, split, shard);
    for (uint64_t i = begin; i < end && !failed; i++) {
        m->sample.index = i;
        m->call->family->make(m->call, m->work, &m->sample);
        failed = add_to_tables(m) || write_own_files(m, split);
        gen_progress_step(m->progress);
    }
    return close_tables(m, failed);
}

static int make_files(const gen_call *c, const gen_plan *p, int shard, gen_progress *g)
{
    const gen_family *family = c->family;
    maker m = {.call = c, .plan = p, .sample = {.plan = p}, .progress = g};
    int failed = 0;

    m.work = family->work_new ? family->work_new(c) : NULL;
    for (gen_split s = GEN_TRAIN; s < GEN_SPLITS && !failed; s++)
        if (c->part[s] > 0)
            failed = make_samples(&m, s, shard);
    if (family->work_free)
        family->work_free(m.work);
    gen_sample_free(&m.sample);
    return failed;
}

/* --- sums --- */

typedef struct summer {
    const gen_call *call;
    kw_out *file;
    uint64_t bytes;
} summer;

static int add_sum(void *with, const char *relative)
{
    summer *s = with;
    char path[GEN_PATH], sum[KW_SHA256_TEXT];
    uint64_t bytes;
    int error;

    gen_path_join(s->call, relative, path);
    error = kw_sha256_file(path, sum, &bytes);
    if (error != 0)
        return gen_say(1, "cannot read %s: %s", path, strerror(error));
    kw_out_text(s->file, "%s  %s\n", sum, relative);
    s->bytes += bytes;
    return 0;
}

static int write_sums(const gen_call *c, const gen_plan *p, int shard)
{
    char relative[GEN_PATH], path[GEN_PATH];
    summer s = {.call = c};

    gen_path_stamp(c, shard, "done", relative);
    gen_path_join(c, relative, path);
    s.file = kw_out_new(path);
    kw_out_text(s.file, "# %s\n", c->text);
    if (gen_each_file(c, p, shard, add_sum, &s) != 0) {
        kw_out_drop(s.file);
        return 1;
    }
    kw_out_text(s.file, "# %llu bytes\n", (unsigned long long)s.bytes);
    return kw_out_close(s.file);
}

/* --- a shard --- */

int gen_shard_make(const gen_call *c, const gen_plan *p, int shard, gen_progress *g)
{
    int lock, failed = 0;

    if (gen_folder_complete(c, shard) && !gen_folder_begun(c, shard))
        return GEN_GOOD;
    lock = gen_folder_lock(c, shard);
    if (lock < 0)
        return GEN_BAD_INPUT;
    if (!gen_folder_complete(
            c, shard)) /* somebody may have been faster, or killed behind it */
        failed = make_files(c, p, shard, g) || write_sums(c, p, shard);
    gen_folder_unlock(c, shard, lock, !failed);
    return failed ? GEN_BAD_INPUT : GEN_GOOD;
}
