#include "need.h"
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void kw_need_failed(const char *file, int line, const char *condition, const char *format,
                    ...)
{
    va_list values;

    fprintf(stderr, "%s:%d: need `%s`: ", file, line, condition);
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    abort();
}

void *kw_need_memory(size_t count, size_t size)
{
    void *p = calloc(count > 0 ? count : 1, size > 0 ? size : 1);

    KW_NEED(p, "memory for %zu objects of %zu bytes", count, size);
    return p;
}

double *kw_need_numbers(size_t count)
{
    enum { LINE = 64 }; /* bytes; where lines are longer, half of one is as good */
    size_t lines = count / (LINE / sizeof(double)) + 1;
    double *a = lines <= SIZE_MAX / LINE ? aligned_alloc(LINE, lines * LINE) : NULL;

    KW_NEED(a, "memory for %zu numbers", count);
    memset(a, 0, lines * LINE);
    return a;
}
