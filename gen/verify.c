/* gen verify -- is a set whole, right, and are its splits disjoint? Every defect is said. */
#include "gen.h"
#include "set.h"
#include "sha256.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 1 << 14 };

typedef struct verifier {
    const gen_call *call;
    const gen_plan *plan;
    int shard;
    kw_sha256 data; /* of the lines "sum  path" of all files of the shards */
    long long files, missing /* shards */, defects;
} verifier;

static void defect(verifier *v)
{
    v->defects++;
}

/* --- sums --- */

static int check_sum(void *with, const char *sum, const char *relative)
{
    verifier *v = with;
    char path[GEN_PATH], found[KW_SHA256_TEXT];
    int error;

    gen_path_join(v->call, relative, path);
    error = kw_sha256_file(path, found, NULL);
    if (error != 0) {
        gen_say(1, "%s: %s", path, strerror(error));
        defect(v);
    } else if (strcmp(found, sum) != 0) {
        gen_say(1, "%s: its sum is not the one it was made with", path);
        defect(v);
    }
    v->files++;
    return 0;
}

static int check_data(void *with, const char *sum, const char *relative)
{
    verifier *v = with;

    kw_sha256_add(&v->data, sum, strlen(sum));
    kw_sha256_add(&v->data, "  ", 2);
    kw_sha256_add(&v->data, relative, strlen(relative));
    kw_sha256_add(&v->data, "\n", 1);
    return check_sum(with, sum, relative);
}

/* Checks the file that the next line of SHA256SUMS names, which is to be `name`. 1 if it is not. */
static int check_beside(verifier *v, FILE *f, const char *name)
{
    char line[LINE], *space;

    if (!fgets(line, sizeof line, f))
        return 1;
    line[strcspn(line, "\n")] = 0;
    space = strstr(line, "  ");
    if (!space || strcmp(space + 2, name) != 0)
        return 1;
    *space = 0;
    return check_sum(v, line, name);
}

/* Has SHA256SUMS the two files that no shard has, and behind them the lines of all shards, whose sum
   is `data`? What a missing shard would have there is not known. */
static int check_sums(verifier *v, FILE *f, const char *data)
{
    char line[LINE], sum[KW_SHA256_TEXT];
    kw_sha256 rest = kw_sha256_begin();

    if (check_beside(v, f, "DATASHEET.md") || check_beside(v, f, "datapackage.json"))
        return 1;
    while (fgets(line, sizeof line, f))
        kw_sha256_add(&rest, line, strlen(line));
    kw_sha256_end(&rest, sum);
    return v->missing == 0 && strcmp(sum, data) != 0;
}

static void check_about(verifier *v, const char *data)
{
    char path[GEN_PATH];
    FILE *f;

    gen_path_join(v->call, "SHA256SUMS", path);
    f = fopen(path, "rb");
    if (!f) {
        gen_say(1, "%s: %s; make it by the call without --shard", path, strerror(errno));
        defect(v);
        return;
    }
    if (check_sums(v, f, data)) {
        gen_say(1, "%s: these are not the sums of the set", path);
        defect(v);
    }
    fclose(f);
}

/* --- counts --- */

typedef struct tally {
    uint64_t lines, samples; /* of a CSV file */
    int disorder;            /* a sample out of the range, or out of order */
} tally;

/* The samples of a CSV file are those of the range, in order, the rows of each from 0 on. */
static int count_lines(FILE *f, uint64_t begin, uint64_t end, tally *t)
{
    char line[LINE];
    unsigned long long sample, last = 0, row, last_row = 0;

    while (fgets(line, sizeof line, f)) {
        if (t->lines++ == 0)
            continue;
        if (sscanf(line, "%llu,%llu,", &sample, &row) != 2 || sample < begin ||
            sample >= end)
            return 1;
        if (t->samples == 0 || sample != last) {
            if (row != 0 || (t->samples > 0 && sample < last))
                return 1;
            t->samples++;
        } else if (row != last_row + 1)
            return 1;
        last = sample;
        last_row = row;
    }
    t->lines -= t->lines > 0;
    return 0;
}

static void check_csv(verifier *v, const gen_array *a, gen_split split, const char *path)
{
    uint64_t begin, end;
    tally t = {0};
    FILE *f = fopen(path, "rb");

    if (!f)
        return; /* said with the sums */
    gen_range(v->call, split, v->shard, &begin, &end);
    t.disorder = count_lines(f, begin, end, &t);
    fclose(f);
    if (t.disorder || (a->rows > 0 && (t.samples != end - begin ||
                                       t.lines != t.samples * (uint64_t)a->rows))) {
        gen_say(1, "%s: these are not the %llu samples from %llu on", path,
                (unsigned long long)(end - begin), (unsigned long long)begin);
        defect(v);
    }
}

/* The first number of the shape of a NPY file, and whether the file is as long as it says. */
static int read_npy(FILE *f, uint64_t *first, uint64_t *size)
{
    unsigned char head[10];
    char text[LINE], *at, *next;
    size_t length;

    if (fread(head, 1, sizeof head, f) != sizeof head)
        return 1;
    length = head[8] + (size_t)256 * head[9];
    if (length >= sizeof text || fread(text, 1, length, f) != length)
        return 1;
    text[length] = 0;
    at = strstr(text, "'shape': (");
    if (!at)
        return 1;
    at += strlen("'shape': (");
    *first = strtoull(at, &next, 10);
    for (*size = 1; *next == ',' || *next == ' ';) {
        *size *= strtoull(next + 1, &at, 10);
        next = at;
    }
    return 0;
}

static void check_npy(verifier *v, const gen_array *a, gen_split split, const char *path)
{
    uint64_t begin, end, first, size;
    FILE *f = fopen(path, "rb");
    int bad;

    if (!f)
        return;
    gen_range(v->call, split, v->shard, &begin, &end);
    bad = read_npy(f, &first, &size);
    if (!bad) {
        long data = ftell(f);

        bad = fseek(f, 0, SEEK_END) != 0 ||
              (uint64_t)(ftell(f) - data) != 8 * first * size ||
              (a->rows > 0 && first != end - begin);
    }
    fclose(f);
    if (bad) {
        gen_say(1, "%s: it has not the %llu samples that belong there", path,
                (unsigned long long)(end - begin));
        defect(v);
    }
}

static void check_tables(verifier *v, gen_split split)
{
    char relative[GEN_PATH], path[GEN_PATH];

    for (int i = 0; i < v->plan->arrays; i++)
        for (int f = GEN_CSV; f <= GEN_NPY; f++) {
            const gen_array *a = &v->plan->array[i];

            if (!v->call->format[f])
                continue;
            gen_path_table(v->call, a, split, v->shard, f, relative);
            gen_path_join(v->call, relative, path);
            if (f == GEN_CSV)
                check_csv(v, a, split, path);
            else
                check_npy(v, a, split, path);
        }
}

/* --- shards --- */

static int count_file(void *with, const char *relative)
{
    (void)relative;
    ++*(long long *)with;
    return 0;
}

static void check_shard(verifier *v)
{
    long long before = v->files, wanted = 0;

    if (gen_folder_each(v->call, v->shard, check_data, v, NULL) != 0) {
        gen_say(1, "%s: shard %d of %d is missing", v->call->out, v->shard,
                v->call->shards);
        v->missing++;
        defect(v);
        return;
    }
    gen_each_file(v->call, v->plan, v->shard, count_file, &wanted);
    if (v->files - before != wanted) {
        gen_say(1, "%s: shard %d has %lld files, not %lld", v->call->out, v->shard,
                v->files - before, wanted);
        defect(v);
    }
    for (gen_split s = GEN_TRAIN; s < GEN_SPLITS; s++)
        if (v->call->part[s] > 0)
            check_tables(v, s);
}

/* --- the command --- */

static int verify(const gen_call *c)
{
    gen_plan plan = {0};
    verifier v = {.call = c, .plan = &plan, .data = kw_sha256_begin()};
    char sum[KW_SHA256_TEXT];

    c->family->plan(c, &plan);
    for (v.shard = 0; v.shard < c->shards; v.shard++)
        check_shard(&v);
    kw_sha256_end(&v.data, sum);
    check_about(&v, sum);
    if (v.defects > 0)
        return gen_say(GEN_BAD_INPUT, "%s: %lld defect%s", c->out, v.defects,
                       v.defects > 1 ? "s" : "");
    printf(
        "%s: %s, %llu samples from %llu on (train %llu, validation %llu, test %llu) in "
        "%d shards, %lld files: all are right\n",
        c->out, c->family->name, (unsigned long long)c->count,
        (unsigned long long)c->first, (unsigned long long)c->part[GEN_TRAIN],
        (unsigned long long)c->part[GEN_VALIDATION],
        (unsigned long long)c->part[GEN_TEST], c->shards, v.files);
    printf("%s is the sum of the sums of its data\n", sum);
    return GEN_GOOD;
}

int gen_verify(int count, char *const *word)
{
    char text[GEN_TEXT];
    gen_call c;

    if (count != 1 || strncmp(word[0], "--", 2) == 0)
        return gen_say(GEN_BAD_CALL,
                       "verify needs the folder of a set, and nothing else");
    if (strlen(word[0]) >= sizeof c.out)
        return gen_say(GEN_BAD_CALL, "the folder `%.40s' has too long a name", word[0]);
    if (!gen_folder_call(word[0], text))
        return gen_say(GEN_BAD_INPUT, "%s holds no set", word[0]);
    if (gen_call_read_text(&c, text, word[0]) != GEN_GOOD)
        return GEN_BAD_INPUT;
    snprintf(c.out, sizeof c.out, "%s", word[0]);
    return verify(&c);
}
