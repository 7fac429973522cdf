#include "need.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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
