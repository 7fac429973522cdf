/* about.c -- what lies beside a set: DATASHEET.md, datapackage.json, SHA256SUMS. All of it
   follows from the call and the files; there is no time, machine or version in it. */
#include "gen.h"
#include "out.h"
#include "set.h"
#include "sha256.h"
#include <string.h>
#include <sys/stat.h>

static kw_out *file_of(const gen_call *c, const char *name)
{
    char path[GEN_PATH];

    gen_path_join(c, name, path);
    return kw_out_new(path);
}

/* --- DATASHEET.md --- */

static void write_splits(const gen_call *c, kw_out *f)
{
    kw_out_text(f, "## Splits\n\nRanges of the index, one behind the other.\n\n"
                   "| split | first sample | samples |\n|---|---|---|\n");
    for (gen_split s = GEN_TRAIN; s < GEN_SPLITS; s++) {
        uint64_t begin, end;

        gen_range(c, s, 0, &begin, &end);
        kw_out_text(f, "| %s | %llu | %llu |\n", gen_split_name[s],
                    (unsigned long long)begin, (unsigned long long)c->part[s]);
    }
}

static void write_columns(const gen_array *a, kw_out *f)
{
    for (const char *at = a->column; *at; at++)
        kw_out_text(f, *at == ' ' ? ", " : "%c", *at);
}

static void write_arrays(const gen_plan *p, kw_out *f)
{
    kw_out_text(f, "\n## Arrays\n\n"
                   "| array | rows of a sample | columns | numbers | what they are |\n"
                   "|---|---|---|---|---|\n");
    for (int i = 0; i < p->arrays; i++) {
        const gen_array *a = &p->array[i];

        kw_out_text(f, "| %s | ", a->name);
        if (a->rows > 0)
            kw_out_text(f, "%d", a->rows);
        else
            kw_out_text(f, "`counts`: %s", a->name);
        kw_out_text(f, " | ");
        write_columns(a, f);
        kw_out_text(f, " | %s | %s |\n", a->integer ? "integers" : "doubles", a->about);
    }
}

static const char *const files =
    "\n## Files\n\n"
    "`ARRAY/SPLIT-K-of-S.csv` and `.npy`: shard K of S, counted from 0. CSV has the "
    "index of the\n"
    "sample and the number of the row before the columns. NPY has the shape (samples, "
    "rows,\n"
    "columns), or (rows of all samples, columns) where a sample has its own number of "
    "rows, which\n"
    "stands in `counts`. Shards are joined by concatenation in the order of their "
    "numbers.\n"
    "`FORMAT/SPLIT-INDEX.FORMAT` is a file of one sample: `ply` the noisy points with "
    "their\n"
    "parameters, `mesh` the boxes, `vtu` the cells with their levels, `xml` the spline "
    "or the mesh "
    "as\n"
    "G+Smo reads it. `gen FAMILY --help` says what each option of the call means. "
    "`SHA256SUMS` is checked by\n"
    "`sha256sum -c SHA256SUMS`, and all by `gen verify` and the name of this folder. "
    "Every file was\n"
    "renamed to its name when it was whole, but not forced to the disk: after a power "
    "failure remove\n"
    "the files that `gen verify` names, and the call above makes them again.\n"
    "\n## Use\n\n"
    "Every sample depends on the seed, its index and the options above alone. The "
    "samples are\n"
    "drawn as described, for tests and for learning; they stand for no population of "
    "anything,\n"
    "and hold nothing about people. They belong to nobody and are in the public domain:\n"
    "CC0 1.0, https://creativecommons.org/publicdomain/zero/1.0/\n";

static int write_datasheet(const gen_call *c, const gen_plan *p)
{
    kw_out *f = file_of(c, "DATASHEET.md");

    kw_out_text(
        f, "    %s --out DIR\n\nmakes this data set, to the byte.\n\n# %s: %s\n\n%s\n",
        c->text, c->family->name, c->family->summary, c->family->about);
    write_splits(c, f);
    write_arrays(p, f);
    kw_out_text(f, "%s", files);
    return kw_out_close(f);
}

/* --- datapackage.json, Frictionless 2.0 --- */

typedef struct package {
    const gen_call *call;
    const gen_plan *plan;
    kw_out *file;
    int resources;
} package;

static const gen_array *array_of(const gen_plan *p, const char *relative)
{
    for (int a = 0; a < p->arrays; a++) {
        size_t length = strlen(p->array[a].name);

        if (strncmp(p->array[a].name, relative, length) == 0 && relative[length] == '/')
            return &p->array[a];
    }
    return NULL;
}

static void write_field(kw_out *f, const char *name, int length, const char *type)
{
    kw_out_text(f, ",\n       {\"name\": \"%.*s\", \"type\": \"%s\"}", length, name,
                type);
}

static void write_schema(const gen_array *a, kw_out *f)
{
    const char *at = a->column;

    kw_out_text(f, ",\n     \"schema\": {\"fields\": [\n"
                   "       {\"name\": \"sample\", \"type\": \"integer\"}");
    write_field(f, "row", 3, "integer");
    while (*at) {
        size_t length = strcspn(at, " ");

        write_field(f, at, (int)length, a->integer ? "integer" : "number");
        at += length + (at[length] == ' ');
    }
    kw_out_text(f, "],\n       \"primaryKey\": [\"sample\", \"row\"]}");
}

static void write_name(kw_out *f, const char *relative)
{
    for (const char *at = relative; *at; at++)
        kw_out_text(f, "%c", *at == '/' ? '-' : *at);
}

static int write_resource(void *with, const char *sum, const char *relative)
{
    package *k = with;
    kw_out *f = k->file;
    const gen_array *a = array_of(k->plan, relative);
    const char *format = strrchr(relative, '.') + 1;
    char path[GEN_PATH];
    struct stat status;

    gen_path_join(k->call, relative, path);
    if (stat(path, &status) != 0)
        return gen_say(1, "%s is not there", path);
    kw_out_text(f, "%s\n    {\"name\": \"", k->resources++ > 0 ? "," : "");
    write_name(f, relative);
    kw_out_text(f, "\", \"path\": \"%s\", \"format\": \"%s\",\n     \"bytes\": %llu, ",
                relative, format, (unsigned long long)status.st_size);
    kw_out_text(f, "\"hash\": \"sha256:%s\"", sum);
    if (a)
        kw_out_text(f, ",\n     \"description\": \"%s\"", a->about);
    if (a && strcmp(format, "csv") == 0) {
        kw_out_text(f, ",\n     \"type\": \"table\", \"mediatype\": \"text/csv\", "
                       "\"encoding\": \"utf-8\"");
        write_schema(a, f);
    }
    kw_out_text(f, "}");
    return 0;
}

static int write_package(const gen_call *c, const gen_plan *p)
{
    package k = {.call = c, .plan = p, .file = file_of(c, "datapackage.json")};
    int failed = 0;

    kw_out_text(k.file,
                "{\n  \"$schema\": "
                "\"https://datapackage.org/profiles/2.0/datapackage.json\",\n"
                "  \"name\": \"knotwork-%s\",\n  \"title\": \"%s\",\n",
                c->family->name, c->family->summary);
    kw_out_text(k.file,
                "  \"licenses\": [{\"name\": \"CC0-1.0\", \"path\": "
                "\"https://creativecommons.org/publicdomain/zero/1.0/\"}],\n"
                "  \"sources\": [{\"title\": \"%s\"}],\n  \"resources\": [",
                c->text);
    for (int shard = 0; shard < c->shards && !failed; shard++)
        failed = gen_folder_each(c, shard, write_resource, &k, NULL);
    kw_out_text(k.file, "\n  ]\n}\n");
    if (failed) {
        kw_out_drop(k.file);
        return gen_say(1, "%s: not all shards are complete", c->out);
    }
    return kw_out_close(k.file);
}

/* --- SHA256SUMS --- */

static int copy_sum(void *with, const char *sum, const char *relative)
{
    kw_out_text(with, "%s  %s\n", sum, relative);
    return 0;
}

static int sum_of(const gen_call *c, const char *name, kw_out *f)
{
    char path[GEN_PATH], sum[KW_SHA256_TEXT];
    int error;

    gen_path_join(c, name, path);
    error = kw_sha256_file(path, sum, NULL);
    if (error != 0)
        return gen_say(1, "cannot read %s: %s", path, strerror(error));
    return copy_sum(f, sum, name);
}

static int write_sums(const gen_call *c)
{
    kw_out *f = file_of(c, "SHA256SUMS");
    int failed = sum_of(c, "DATASHEET.md", f) || sum_of(c, "datapackage.json", f);

    for (int shard = 0; shard < c->shards && !failed; shard++)
        failed = gen_folder_each(c, shard, copy_sum, f, NULL);
    if (failed) {
        kw_out_drop(f);
        return 1;
    }
    return kw_out_close(f);
}

/* Two calls that end at the same time would write into the same temporary. */
int gen_about(const gen_call *c, const gen_plan *p)
{
    int failed, lock = gen_folder_lock(c, c->shards);

    if (lock < 0)
        return GEN_BAD_INPUT;
    failed = write_datasheet(c, p) || write_package(c, p) || write_sums(c);
    gen_folder_unlock(c, c->shards, lock, 1);
    return failed ? GEN_BAD_INPUT : GEN_GOOD;
}
