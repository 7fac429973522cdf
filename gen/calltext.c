/* calltext.c -- the text of a call, which names a set. */
#include "set.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void append(gen_call *c, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void append(gen_call *c, const char *format, ...)
{
    size_t length = strlen(c->text);
    va_list values;

    va_start(values, format);
    vsnprintf(c->text + length, sizeof c->text - length, format, values);
    va_end(values);
}

/* The fewest digits that give back the same number. */
static void append_number(gen_call *c, double value)
{
    char text[40];

    if (value == (int)value) {
        append(c, "%d", (int)value);
        return;
    }
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    append(c, "%s", text);
}

static void append_word(gen_call *c, const char *list, int place)
{
    for (; place > 0; place--)
        list += strcspn(list, " ") + 1;
    append(c, "%.*s", (int)strcspn(list, " "), list);
}

static void append_parameter(gen_call *c, int p)
{
    const gen_parameter *parameter = &c->family->parameter[p];

    append(c, " %s ", parameter->name);
    if (parameter->kind == GEN_WORD) {
        append_word(c, parameter->words, (int)c->low[p]);
        return;
    }
    append_number(c, c->low[p]);
    if (c->high[p] > c->low[p]) {
        append(c, "-");
        append_number(c, c->high[p]);
    }
}

void gen_call_write_text(gen_call *c)
{
    const char *comma = "";

    append(c,
           "gen %s --seed %llu --first %llu --count %llu --validation %llu --test %llu",
           c->family->name, (unsigned long long)c->seed, (unsigned long long)c->first,
           (unsigned long long)c->count, (unsigned long long)c->part[GEN_VALIDATION],
           (unsigned long long)c->part[GEN_TEST]);
    append(c, " --shards %d --format ", c->shards);
    for (int f = 0; f < GEN_FORMATS; f++)
        if (c->format[f]) {
            append(c, "%s%s", comma, gen_format_name(c, f));
            comma = ",";
        }
    for (int p = 0; p < GEN_PARAMETERS && c->family->parameter[p].name; p++)
        append_parameter(c, p);
}
