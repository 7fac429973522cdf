#include "out.h"
#include "need.h"
#include "npy.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct kw_out {
    FILE *file;      /* NULL if it could not be opened */
    char *path;      /* where it will be */
    char *temporary; /* where it is until then */
    int error;       /* errno of the first failure, 0 while all is well */
    int columns;     /* numbers in a row of the present section; 0 before the first */
    int column;      /* numbers in the present row so far */
};

static char *join(const char *a, const char *b, const char *c)
{
    size_t size = strlen(a) + strlen(b) + strlen(c) + 1;
    char *s = kw_need_memory(size, 1);

    snprintf(s, size, "%s%s%s", a, b, c);
    return s;
}

/* remembers why, once; a failure without an errno counts as an I/O error */
static void note_failure(kw_out *f)
{
    if (f->error == 0)
        f->error = errno != 0 ? errno : EIO;
}

kw_out *kw_out_new(const char *path)
{
    kw_out *f = kw_need_memory(1, sizeof *f);

    f->path = join(path, "", "");
    f->temporary = join(path, ".tmp", "");
    errno = 0;
    f->file = fopen(f->temporary, "wb");
    if (!f->file)
        note_failure(f);
    return f;
}

void kw_out_bytes(kw_out *f, const void *bytes, size_t count)
{
    errno = 0;
    if (f->error == 0 && fwrite(bytes, 1, count, f->file) != count)
        note_failure(f);
}

void kw_out_text(kw_out *f, const char *format, ...)
{
    va_list values;

    if (f->error != 0)
        return;
    errno = 0;
    va_start(values, format);
    if (vfprintf(f->file, format, values) < 0)
        note_failure(f);
    va_end(values);
}

void kw_out_begin_with(kw_out *f, const void *bytes, size_t count)
{
    if (f->error != 0)
        return;
    errno = 0;
    if (fseek(f->file, 0, SEEK_SET) != 0)
        note_failure(f);
    kw_out_bytes(f, bytes, count);
    errno = 0;
    if (f->error == 0 && fseek(f->file, 0, SEEK_END) != 0)
        note_failure(f);
}

int kw_out_failed(const kw_out *f)
{
    return f->error != 0;
}

static void forget(kw_out *f)
{
    free(f->path);
    free(f->temporary);
    free(f);
}

void kw_out_drop(kw_out *f)
{
    if (f->file) {
        fclose(f->file);
        remove(f->temporary);
    }
    forget(f);
}

int kw_out_close(kw_out *f)
{
    int failed;

    KW_NEED(f->column == 0, "%s: a row of %d columns ends after %d", f->path, f->columns,
            f->column);
    errno = 0;
    if (f->file && fclose(f->file) != 0) /* flushes: a full disk may show only here */
        note_failure(f);
    if (f->error == 0 && rename(f->temporary, f->path) != 0)
        note_failure(f);
    failed = f->error != 0;
    if (failed) {
        fprintf(stderr, "cannot write %s: %s\n", f->path, strerror(f->error));
        if (f->file)
            remove(f->temporary);
    }
    forget(f);
    return failed;
}

kw_out *kw_out_data(const char *driver)
{
    char *path = join(KW_BUILD "/data/", driver, ".dat");
    kw_out *f = kw_out_new(path);

    free(path);
    return f;
}

static int count_words(const char *s)
{
    int words = 0;

    for (int inside = 0; *s; s++) {
        words += *s != ' ' && !inside;
        inside = *s != ' ';
    }
    return words;
}

void kw_out_section(kw_out *f, const char *name, const char *columns)
{
    KW_NEED(f->column == 0, "%s: a row of %d columns ends after %d", f->path, f->columns,
            f->column);
    kw_out_text(f, "%s# %s\n# %s\n", f->columns > 0 ? "\n\n" : "", name, columns);
    f->columns = count_words(columns);
}

void kw_out_number(kw_out *f, double value)
{
    KW_NEED(isfinite(value), "%s: %g", f->path, value);
    KW_NEED(f->column < f->columns, "%s: more than %d columns", f->path, f->columns);
    kw_out_text(f, "%s%.17g", f->column > 0 ? " " : "", value);
    f->column++;
}

void kw_out_row(kw_out *f)
{
    KW_NEED(f->column == f->columns, "%s: a row of %d columns ends after %d", f->path,
            f->columns, f->column);
    kw_out_text(f, "\n");
    f->column = 0;
}

void kw_out_gap(kw_out *f)
{
    KW_NEED(f->column == 0, "%s: a row of %d columns ends after %d", f->path, f->columns,
            f->column);
    kw_out_text(f, "\n");
}

int kw_out_csv(const char *path, const char *header, size_t rows, size_t columns,
               const double *a)
{
    kw_out *f = kw_out_new(path);

    kw_out_text(f, "%s\n", header);
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++)
            kw_out_text(f, "%.17g%c", a[i * columns + j], j + 1 < columns ? ',' : '\n');
    return kw_out_close(f);
}

int kw_out_npy(const char *path, int dimensions, const size_t *shape, const double *a)
{
    enum { PART = 512 };
    unsigned char header[KW_NPY_HEADER], bytes[PART * sizeof *a];
    kw_out *f = kw_out_new(path);
    size_t count = 1, length = kw_npy_header("<f8", dimensions, shape, header);

    kw_out_bytes(f, header, length);
    for (int i = 0; i < dimensions; i++)
        count *= shape[i];
    for (size_t i = 0; i < count; i += PART) {
        size_t part = count - i < PART ? count - i : PART;

        kw_npy_doubles(part, a + i, bytes);
        kw_out_bytes(f, bytes, part * sizeof *a);
    }
    return kw_out_close(f);
}
