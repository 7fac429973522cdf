/* plan.c -- arrays, samples, ranges of shards, paths. */
#include "need.h"
#include "set.h"
#include <stdlib.h>
#include <stdio.h>
#include <string.h>

const char *const gen_split_name[GEN_SPLITS] = {"train", "validation", "test"};

/* --- arrays --- */

static int add(gen_plan *p, const char *name, int rows, const char *columns,
               const char *about, int integer)
{
    gen_array *a = &p->array[p->arrays];

    KW_NEED(p->arrays < GEN_ARRAYS, "more than %d arrays", GEN_ARRAYS);
    *a = (gen_array){.about = about, .integer = integer, .rows = rows, .columns = 1};
    snprintf(a->name, sizeof a->name, "%s", name);
    snprintf(a->column, sizeof a->column, "%s", columns);
    for (const char *at = a->column; *at; at++)
        a->columns += *at == ' ';
    return p->arrays++;
}

int gen_plan_add(gen_plan *p, const char *name, int rows, const char *columns,
                 const char *about)
{
    return add(p, name, rows, columns, about, 0);
}

int gen_plan_add_integers(gen_plan *p, const char *name, int rows, const char *columns,
                          const char *about)
{
    return add(p, name, rows, columns, about, 1);
}

void gen_plan_numbered(const char *letter, int count, const char *rest, char *text)
{
    size_t length = 0;

    for (int i = 1; i <= count; i++)
        length += (size_t)snprintf(text + length, GEN_TEXT - length, "%s%s%d",
                                   i > 1 ? " " : "", letter, i);
    KW_NEED(length + strlen(rest) < GEN_TEXT, "%d columns", count);
    snprintf(text + length, GEN_TEXT - length, "%s", rest);
}

double *gen_rows(gen_sample *s, int array, int rows)
{
    const gen_array *a = &s->plan->array[array];
    size_t count = (size_t)rows * (size_t)a->columns;

    KW_NEED(a->rows == 0 || rows == a->rows, "%s: %d rows, not %d", a->name, rows,
            a->rows);
    if (count > s->room[array]) {
        free(s->value[array]);
        s->room[array] = count + count / 2;
        s->value[array] = kw_need_memory(s->room[array], sizeof *s->value[array]);
    }
    s->rows[array] = rows;
    return s->value[array];
}

void gen_sample_free(gen_sample *s)
{
    for (int a = 0; a < GEN_ARRAYS; a++)
        free(s->value[a]);
}

kw_rng gen_rng(const gen_call *c, const gen_sample *s, uint64_t field)
{
    return kw_rng_at(c->seed, c->family->stream, s->index, field);
}

/* --- ranges --- */

/* n * shard / shards, rounded down, without overflow */
static uint64_t cut(uint64_t n, uint64_t shard, uint64_t shards)
{
    return n / shards * shard + n % shards * shard / shards;
}

void gen_range(const gen_call *c, gen_split split, int shard, uint64_t *begin,
               uint64_t *end)
{
    uint64_t first = c->first;

    for (int s = 0; s < (int)split; s++)
        first += c->part[s];
    *begin = first + cut(c->part[split], (uint64_t)shard, (uint64_t)c->shards);
    *end = first + cut(c->part[split], (uint64_t)shard + 1, (uint64_t)c->shards);
}

/* --- paths --- */

void gen_path_table(const gen_call *c, const gen_array *a, gen_split split, int shard,
                    int format, char *path)
{
    snprintf(path, GEN_PATH, "%s/%s-%05d-of-%05d.%s", a->name, gen_split_name[split],
             shard, c->shards, gen_format_name(c, format));
}

void gen_path_sample(const gen_call *c, gen_split split, int format, uint64_t index,
                     char *path)
{
    const char *name = gen_format_name(c, format);

    snprintf(path, GEN_PATH, "%s/%s-%019llu.%s", name, gen_split_name[split],
             (unsigned long long)index, name);
}

void gen_path_stamp(const gen_call *c, int shard, const char *state, char *path)
{
    snprintf(path, GEN_PATH, "shards/%05d-of-%05d.%s", shard, c->shards, state);
}

void gen_path_join(const gen_call *c, const char *relative, char *path)
{
    snprintf(path, GEN_PATH, "%s/%s", c->out, relative);
}

/* --- files of a shard --- */

static int each_table(const gen_call *c, const gen_plan *p, gen_split split, int shard,
                      int (*visit)(void *with, const char *relative), void *with)
{
    char path[GEN_PATH];
    int result = 0;

    for (int a = 0; a < p->arrays; a++)
        for (int f = GEN_CSV; f <= GEN_NPY && result == 0; f++)
            if (c->format[f]) {
                gen_path_table(c, &p->array[a], split, shard, f, path);
                result = visit(with, path);
            }
    return result;
}

static int each_sample(const gen_call *c, gen_split split, int shard,
                       int (*visit)(void *with, const char *relative), void *with)
{
    uint64_t begin, end;
    char path[GEN_PATH];
    int result = 0;

    gen_range(c, split, shard, &begin, &end);
    for (int f = GEN_OWN_FORMAT; f < GEN_FORMATS; f++)
        for (uint64_t i = begin; c->format[f] && i < end && result == 0; i++) {
            gen_path_sample(c, split, f, i, path);
            result = visit(with, path);
        }
    return result;
}

int gen_each_file(const gen_call *c, const gen_plan *p, int shard,
                  int (*visit)(void *with, const char *relative), void *with)
{
    int result = 0;

    for (gen_split s = GEN_TRAIN; s < GEN_SPLITS && result == 0; s++) {
        if (c->part[s] == 0)
            continue;
        result = each_table(c, p, s, shard, visit, with);
        if (result == 0)
            result = each_sample(c, s, shard, visit, with);
    }
    return result;
}
