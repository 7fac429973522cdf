/* table.c -- rows of one array into a CSV or a NPY file. */
#include "need.h"
#include "npy.h"
#include "out.h"
#include "set.h"
#include <stdlib.h>
#include <string.h>

enum { PART = 1 << 13 /* numbers that are turned into bytes at once */, SIZE = 8 };

struct gen_table {
    gen_array array;
    int format;
    kw_out *file;
    uint64_t samples, rows; /* so far */
    size_t filled;          /* numbers that wait in `bytes` */
    unsigned char bytes[PART * SIZE];
};

/* The header of a NPY file of so many samples and rows. */
static size_t npy_header(const gen_table *t, uint64_t samples, uint64_t rows,
                         unsigned char *header)
{
    const gen_array *a = &t->array;
    const size_t columns = (size_t)a->columns;
    const size_t equal[] = {(size_t)samples, (size_t)a->rows, columns};
    const size_t ragged[] = {(size_t)rows, columns};

    return kw_npy_header(a->integer ? "<i8" : "<f8", a->rows > 0 ? 3 : 2,
                         a->rows > 0 ? equal : ragged, header);
}

/* The number of rows is known at the end; nothing takes more digits than the largest. */
static void begin_npy(gen_table *t)
{
    unsigned char header[KW_NPY_HEADER];
    size_t length = npy_header(t, UINT64_MAX, UINT64_MAX, header);

    kw_out_bytes(t->file, header, length);
}

static void begin_csv(gen_table *t)
{
    kw_out_text(t->file, "sample,row,");
    for (const char *at = t->array.column; *at; at++)
        kw_out_text(t->file, "%c", *at == ' ' ? ',' : *at);
    kw_out_text(t->file, "\n");
}

gen_table *gen_table_new(const gen_array *a, int format, const char *path)
{
    gen_table *t = kw_need_memory(1, sizeof *t);

    t->array = *a;
    t->format = format;
    t->file = kw_out_new(path);
    if (format == GEN_NPY)
        begin_npy(t);
    else
        begin_csv(t);
    return t;
}

static void flush(gen_table *t)
{
    kw_out_bytes(t->file, t->bytes, t->filled * SIZE);
    t->filled = 0;
}

static void put_integers(size_t count, const double *value, unsigned char *bytes)
{
    for (size_t i = 0; i < count; i++) {
        int64_t number = (int64_t)value[i];

        kw_npy_integers(1, &number, bytes + SIZE * i);
    }
}

static void add_npy(gen_table *t, size_t count, const double *value)
{
    while (count > 0) {
        size_t part = PART - t->filled < count ? PART - t->filled : count;
        unsigned char *bytes = t->bytes + SIZE * t->filled;

        if (t->array.integer)
            put_integers(part, value, bytes);
        else
            kw_npy_doubles(part, value, bytes);
        t->filled += part;
        value += part;
        count -= part;
        if (t->filled == PART)
            flush(t);
    }
}

static void add_csv(gen_table *t, uint64_t index, int rows, const double *value)
{
    const char *format = t->array.integer ? ",%.0f" : ",%.17g";

    for (int i = 0; i < rows; i++) {
        kw_out_text(t->file, "%llu,%d", (unsigned long long)index, i);
        for (int j = 0; j < t->array.columns; j++)
            kw_out_text(t->file, format, *value++);
        kw_out_text(t->file, "\n");
    }
}

int gen_table_add(gen_table *t, uint64_t index, int rows, const double *value)
{
    if (t->format == GEN_NPY)
        add_npy(t, (size_t)rows * (size_t)t->array.columns, value);
    else
        add_csv(t, index, rows, value);
    t->samples++;
    t->rows += (uint64_t)rows;
    return kw_out_failed(t->file);
}

int gen_table_failed(const gen_table *t)
{
    return kw_out_failed(t->file);
}

int gen_table_close(gen_table *t)
{
    int failed;

    if (t->format == GEN_NPY) {
        unsigned char header[KW_NPY_HEADER];
        size_t length = npy_header(t, UINT64_MAX, UINT64_MAX, header);

        flush(t);
        KW_NEED(npy_header(t, t->samples, t->rows, header) == length, "header of %s",
                t->array.name);
        kw_out_begin_with(t->file, header, length);
    }
    failed = kw_out_close(t->file);
    free(t);
    return failed;
}

void gen_table_drop(gen_table *t)
{
    kw_out_drop(t->file);
    free(t);
}
