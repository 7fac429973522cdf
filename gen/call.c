/* call.c -- the command line of a family: its options, read and explained. */
#include "gen.h"
#include "need.h"
#include "set.h"
#include "value.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const uint64_t MOST = (uint64_t)1 << 63; /* samples end here */

enum { MOST_SHARDS = 99999, MOST_WORDS = 2 * (GEN_PARAMETERS + 10) };

/* The options of every family, in the order of the text. */
enum {
    SEED,
    FIRST,
    COUNT,
    VALIDATION,
    TEST,
    SHARDS,
    FORMAT, /* the set */
    SHARD,
    JOBS,
    OUT, /* how it is made */
    OPTIONS,
    NAMED = SHARD /* those that name the set */
};

static const struct option {
    const char *name, *standard, *about;
} option[OPTIONS] = {
    [SEED] = {"--seed", "0", "an integer below 2^64"},
    [FIRST] = {"--first", "0", "the index of the first sample"},
    [COUNT] = {"--count", NULL, "how many samples; needed"},
    [VALIDATION] = {"--validation", "0", "how many of them, behind those to train with"},
    [TEST] = {"--test", "0", "how many of them, at the end"},
    [SHARDS] = {"--shards", "1", "files that each split is cut into"},
    [FORMAT] = {"--format", "csv,npy", "which files are written"},
    [SHARD] = {"--shard", NULL, "make this shard alone, counted from 0"},
    [JOBS] = {"--jobs", "1", "processes that share the shards"},
    [OUT] = {"--out", NULL, "the folder of the set; needed"},
};

/* --- formats --- */

const char *gen_format_name(const gen_call *c, int format)
{
    return format == GEN_CSV   ? "csv"
           : format == GEN_NPY ? "npy"
                               : c->family->format[format - GEN_OWN_FORMAT];
}

static int find_format(const gen_call *c, const char *word, size_t length)
{
    for (int f = 0; f < GEN_FORMATS; f++) {
        const char *name = gen_format_name(c, f);

        if (name && strlen(name) == length && strncmp(name, word, length) == 0)
            return f;
    }
    return -1;
}

static int read_formats(gen_call *c, const char *text)
{
    KW_NEED(text, "--format has no value");
    for (const char *at = text;; at++) {
        size_t length = strcspn(at, ",");
        int f = find_format(c, at, length);

        if (f < 0)
            return gen_say(GEN_BAD_CALL, "%s has no format `%.*s'; see gen %s --help",
                           c->family->name, (int)length, at, c->family->name);
        c->format[f] = 1;
        at += length;
        if (*at == 0)
            return GEN_GOOD;
    }
}

/* --- options --- */

typedef struct words {
    const char *option[OPTIONS], *parameter[GEN_PARAMETERS]; /* NULL where left out */
} words;

static const char **place_of(words *w, const gen_family *family, const char *name)
{
    for (int o = 0; o < OPTIONS; o++)
        if (strcmp(option[o].name, name) == 0)
            return &w->option[o];
    for (int p = 0; p < GEN_PARAMETERS && family->parameter[p].name; p++)
        if (strcmp(family->parameter[p].name, name) == 0)
            return &w->parameter[p];
    return NULL;
}

static int sort_words(const gen_family *family, int count, char *const *word, words *w)
{
    for (int i = 0; i < count; i += 2) {
        const char **place = place_of(w, family, word[i]);

        if (!place)
            return gen_say(GEN_BAD_CALL, "%s has no option `%s'; see gen %s --help",
                           family->name, word[i], family->name);
        if (*place)
            return gen_say(GEN_BAD_CALL, "%s is given twice", word[i]);
        if (i + 1 == count || strncmp(word[i + 1], "--", 2) == 0)
            return gen_say(GEN_BAD_CALL, "%s has no value", word[i]);
        *place = word[i + 1];
    }
    for (int o = 0; o < OPTIONS; o++)
        if (!w->option[o])
            w->option[o] = option[o].standard;
    if (!w->option[COUNT])
        return gen_say(GEN_BAD_CALL, "%s needs --count; see gen %s --help", family->name,
                       family->name);
    return GEN_GOOD;
}

static int read_splits(gen_call *c, const words *w)
{
    uint64_t *part = c->part;

    if (gen_value_integer("--first", w->option[FIRST], MOST - 1, &c->first) != GEN_GOOD ||
        gen_value_integer("--count", w->option[COUNT], MOST, &c->count) != GEN_GOOD ||
        gen_value_integer("--validation", w->option[VALIDATION], MOST,
                          &part[GEN_VALIDATION]) != GEN_GOOD ||
        gen_value_integer("--test", w->option[TEST], MOST, &part[GEN_TEST]) != GEN_GOOD)
        return GEN_BAD_CALL;
    if (c->count == 0)
        return gen_say(GEN_BAD_CALL, "--count is 0; a set has at least one sample");
    if (c->count > MOST - c->first)
        return gen_say(GEN_BAD_CALL,
                       "--first %s and --count %s: the index goes past 2^63",
                       w->option[FIRST], w->option[COUNT]);
    if (part[GEN_VALIDATION] > c->count ||
        part[GEN_TEST] > c->count - part[GEN_VALIDATION])
        return gen_say(GEN_BAD_CALL,
                       "--validation %s and --test %s are more than --count %s",
                       w->option[VALIDATION], w->option[TEST], w->option[COUNT]);
    part[GEN_TRAIN] = c->count - part[GEN_VALIDATION] - part[GEN_TEST];
    return GEN_GOOD;
}

static int read_shards(gen_call *c, const words *w)
{
    uint64_t shards, shard = 0, jobs;

    if (gen_value_integer("--shards", w->option[SHARDS], MOST_SHARDS, &shards) !=
            GEN_GOOD ||
        gen_value_integer("--jobs", w->option[JOBS], GEN_JOBS, &jobs) != GEN_GOOD)
        return GEN_BAD_CALL;
    if (shards == 0 || jobs == 0)
        return gen_say(GEN_BAD_CALL, "%s is 0", shards == 0 ? "--shards" : "--jobs");
    if (w->option[SHARD] &&
        gen_value_integer("--shard", w->option[SHARD], MOST_SHARDS, &shard) != GEN_GOOD)
        return GEN_BAD_CALL;
    if (shard >= shards)
        return gen_say(GEN_BAD_CALL, "--shard %s of --shards %s: they count from 0",
                       w->option[SHARD], w->option[SHARDS]);
    if (jobs > 1 && w->option[SHARD])
        return gen_say(GEN_BAD_CALL, "--jobs share shards; --shard is a single one");
    if (jobs > shards)
        return gen_say(GEN_BAD_CALL, "--jobs %s share --shards %s: there are too few",
                       w->option[JOBS], w->option[SHARDS]);
    c->shards = (int)shards;
    c->shard = w->option[SHARD] ? (int)shard : -1;
    c->jobs = (int)jobs;
    return GEN_GOOD;
}

static int read_parameters(gen_call *c, const words *w)
{
    const gen_parameter *parameter = c->family->parameter;

    for (int p = 0; p < GEN_PARAMETERS && parameter[p].name; p++) {
        const char *text = w->parameter[p] ? w->parameter[p] : parameter[p].standard;
        int status = gen_value_read(&parameter[p], text, &c->low[p], &c->high[p]);

        if (status != GEN_GOOD)
            return status;
    }
    return c->family->check ? c->family->check(c) : GEN_GOOD;
}

/* --- reading a call --- */

static int read_call(gen_call *c, const gen_family *family, int count, char *const *word,
                     words *w)
{
    *c = (gen_call){.family = family};
    if (sort_words(family, count, word, w) != GEN_GOOD ||
        gen_value_integer("--seed", w->option[SEED], UINT64_MAX, &c->seed) != GEN_GOOD ||
        read_splits(c, w) != GEN_GOOD || read_shards(c, w) != GEN_GOOD ||
        read_formats(c, w->option[FORMAT]) != GEN_GOOD ||
        read_parameters(c, w) != GEN_GOOD)
        return GEN_BAD_CALL;
    gen_call_write_text(c);
    return GEN_GOOD;
}

int gen_call_read(gen_call *c, const gen_family *family, int count, char *const *word)
{
    words w = {0};
    int status = read_call(c, family, count, word, &w);

    if (status != GEN_GOOD)
        return status;
    if (!w.option[OUT])
        return gen_say(GEN_BAD_CALL, "%s needs --out; see gen %s --help", family->name,
                       family->name);
    if (strlen(w.option[OUT]) >= sizeof c->out || w.option[OUT][0] == 0)
        return gen_say(GEN_BAD_CALL, "--out: `%.40s' has 0 or more than %zu characters",
                       w.option[OUT], sizeof c->out - 1);
    snprintf(c->out, sizeof c->out, "%s", w.option[OUT]);
    return GEN_GOOD;
}

int gen_call_read_text(gen_call *c, const char *text, const char *path)
{
    char copy[GEN_TEXT], *word[MOST_WORDS], *rest = copy;
    const gen_family *family = NULL;
    words w = {0};
    int count = 0;

    snprintf(copy, sizeof copy, "%s", text);
    while (*rest && count < MOST_WORDS) {
        word[count++] = rest;
        rest += strcspn(rest, " ");
        if (*rest)
            *rest++ = 0;
    }
    if (count > 2 && strcmp(word[0], "gen") == 0)
        family = gen_family_find(word[1]);
    if (!family || read_call(c, family, count - 2, word + 2, &w) != GEN_GOOD)
        return gen_say(GEN_BAD_INPUT, "%s: `%.80s' is not the call of a set", path, text);
    return GEN_GOOD;
}

/* --- asking --- */

int gen_whole(const gen_call *c, int p)
{
    return (int)c->low[p];
}

int gen_draw(const gen_call *c, int p, kw_rng *r)
{
    return (int)c->low[p] + kw_rng_below(r, (int)(c->high[p] - c->low[p]) + 1);
}

int gen_is_standard(const gen_call *c, int p)
{
    const gen_parameter *parameter = &c->family->parameter[p];
    double low, high;

    return gen_value_read(parameter, parameter->standard, &low, &high) == GEN_GOOD &&
           low == c->low[p] && high == c->high[p];
}

/* --- help --- */

static void print_list(const char *list)
{
    printf(": ");
    for (; *list; list++)
        printf(*list == ' ' ? ", " : "%c", *list);
}

static void print_parameter(const gen_parameter *p)
{
    printf("  %-14s %s", p->name, p->about);
    if (p->kind == GEN_WORD)
        print_list(p->words);
    else
        printf(", %.10g .. %.10g%s", p->least, p->most,
               p->kind == GEN_RANGE ? ", or a range, as 4-8" : "");
    printf("; %s if left out\n", p->standard);
}

void gen_call_help(const gen_family *family)
{
    printf("usage: gen %s --count N --out DIR [--option VALUE ...]\n\n%s\n", family->name,
           family->about);
    for (int p = 0; p < GEN_PARAMETERS && family->parameter[p].name; p++)
        print_parameter(&family->parameter[p]);
    printf("\nOf every set:\n\n");
    for (int o = 0; o < OPTIONS; o++) {
        printf("  %-14s %s", option[o].name, option[o].about);
        if (o == FORMAT) {
            printf(": csv, npy");
            for (int f = 0; f < GEN_FORMATS - GEN_OWN_FORMAT && family->format[f]; f++)
                printf(", %s", family->format[f]);
        }
        if (option[o].standard)
            printf("; %s if left out", option[o].standard);
        printf("\n");
    }
    printf("\nFor example\n\n  gen %s --seed 1 --count 10 --test 2 %s --out %s\n\n"
           "makes 8 samples to train with and 2 to test, with DATASHEET.md, which says "
           "what\n"
           "is in the files.\n%s%s",
           family->name, family->example, family->name, family->recipes ? "\n" : "",
           family->recipes ? family->recipes : "");
}
