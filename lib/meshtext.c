#include "meshtext.h"
#include "active.h"
#include "need.h"
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int kw_meshtext_wrong(kw_meshtext *r, const char *format, ...)
{
    va_list values;
    int used =
        r->line > 0
            ? snprintf(r->message, KW_MESHFILE_MESSAGE, "%.200s:%d: ", r->name, r->line)
            : snprintf(r->message, KW_MESHFILE_MESSAGE, "%.200s: ", r->name);

    va_start(values, format);
    vsnprintf(r->message + used, (size_t)(KW_MESHFILE_MESSAGE - used), format, values);
    va_end(values);
    return 1;
}

/* The next word of the line, ended by a zero, or NULL. */
static char *next_word(char **rest)
{
    char *word = *rest + strspn(*rest, " \t\r");

    if (*word == 0)
        return NULL;
    *rest = word + strcspn(word, " \t\r");
    if (**rest)
        *(*rest)++ = 0;
    return word;
}

/* A whole number low .. high. */
static int read_int(kw_meshtext *r, const char *word, const char *what, int low, int high,
                    int *value)
{
    char *end;
    long v;

    if (!word)
        return kw_meshtext_wrong(r, "%s is missing", what);
    errno = 0;
    v = strtol(word, &end, 10);
    if (end == word || *end)
        return kw_meshtext_wrong(r, "%s `%.40s` is no whole number", what, word);
    if (errno == ERANGE || v < low || v > high)
        return kw_meshtext_wrong(r, "%s %.40s is not in %d .. %d", what, word, low, high);
    *value = (int)v;
    return 0;
}

static int read_degree(kw_meshtext *r, char *rest)
{
    char *word;
    int local = 1;

    if (r->D > 0)
        return kw_meshtext_wrong(
            r, "a second `degree` line; the degree is the same on all levels, "
               "because spaces of different degree on dyadic knots are not "
               "nested");
    while ((word = next_word(&rest))) {
        if (r->D == KW_TENSOR_D)
            return kw_meshtext_wrong(r, "more than %d degrees", KW_TENSOR_D);
        if (read_int(r, word, "degree", 0, KW_BSPLINE_DEGREE, &r->degree[r->D]))
            return 1;
        r->D++;
    }
    if (r->D == 0)
        return kw_meshtext_wrong(r, "`degree` without a number");
    for (int h = 0; h < r->D; h++)
        local *= r->degree[h] + 1;
    if (local > KW_ACTIVE_LOCAL)
        return kw_meshtext_wrong(r, "%d functions on a cell, more than %d", local,
                                 KW_ACTIVE_LOCAL);
    return 0;
}

/* What kw_bspline_new would abort on. */
static int check_knots(kw_meshtext *r, int d, int count, const double *t)
{
    int n = count - d - 1;

    if (n < d + 1)
        return kw_meshtext_wrong(r, "%d knots are too few for degree %d; at least %d",
                                 count, d, 2 * d + 2);
    for (int i = 1; i < count; i++)
        if (t[i] < t[i - 1])
            return kw_meshtext_wrong(r, "knots decrease: %.17g after %.17g", t[i],
                                     t[i - 1]);
    if (!isfinite(t[count - 1] - t[0]))
        return kw_meshtext_wrong(r, "knots from %g to %g are too far apart", t[0],
                                 t[count - 1]);
    for (int i = 0; i < n; i++)
        if (t[i] == t[i + d + 1])
            return kw_meshtext_wrong(r, "knot %.17g appears more than %d times", t[i],
                                     d + 1);
    if (t[d] == t[d + 1] || t[n - 1] == t[n])
        return kw_meshtext_wrong(
            r, "the domain [%.17g, %.17g] begins or ends with an empty span", t[d], t[n]);
    return 0;
}

static int read_knots(kw_meshtext *r, char *rest)
{
    size_t most = strlen(rest) / 2 + 1; /* words of one character and a blank */
    double *t;
    char *word;
    int count = 0, failed = 0;

    if (r->D == 0)
        return kw_meshtext_wrong(r, "`knots` before `degree`");
    if (r->directions == r->D)
        return kw_meshtext_wrong(r, "more `knots` lines than the %d degrees", r->D);
    t = kw_need_memory(most, sizeof *t);
    while (!failed && (word = next_word(&rest))) {
        char *end;

        t[count] = strtod(word, &end);
        if (end == word || *end || !isfinite(t[count]))
            failed = kw_meshtext_wrong(r, "knot `%.40s` is no finite number", word);
        count++;
    }
    failed = failed || check_knots(r, r->degree[r->directions], count, t);
    if (!failed) {
        int d = r->degree[r->directions];

        r->s[r->directions++] = kw_bspline_new(d, count - d - 1, t);
    }
    free(t);
    return failed;
}

/* Remembers a refine line; boxes are checked and used when all lines are known, level by
   level. */
static int read_refine(kw_meshtext *r, char *rest)
{
    int *box;

    if (r->D == 0 || r->directions < r->D)
        return kw_meshtext_wrong(r, "`refine` before %s",
                                 r->D == 0 ? "`degree`" : "all `knots`");
    if (r->boxes == r->room) {
        r->room = r->room > 0 ? 2 * r->room : 16;
        r->box = realloc(r->box, r->room * sizeof *r->box);
        r->box_line = realloc(r->box_line, r->room * sizeof *r->box_line);
        KW_NEED(r->box && r->box_line, "memory for %zu boxes", r->room);
    }
    box = r->box[r->boxes];
    r->box_line[r->boxes] = r->line;
    if (read_int(r, next_word(&rest), "level", 0, KW_MESH_LEVELS - 2, &box[0]))
        return 1;
    for (int c = 0; c < 2 * r->D; c++)
        if (read_int(r, next_word(&rest), c < r->D ? "low corner" : "high corner", 0,
                     INT_MAX, &box[1 + c]))
            return 1;
    if (next_word(&rest))
        return kw_meshtext_wrong(r, "more than a level and two corners of %d numbers",
                                 r->D);
    r->boxes++;
    return 0;
}

static int read_line(kw_meshtext *r, char *line)
{
    char *rest = line, *word;

    line[strcspn(line, "#")] = 0;
    word = next_word(&rest);
    if (!word)
        return 0;
    if (strcmp(word, "degree") == 0)
        return read_degree(r, rest);
    if (strcmp(word, "knots") == 0)
        return read_knots(r, rest);
    if (strcmp(word, "refine") == 0)
        return read_refine(r, rest);
    return kw_meshtext_wrong(r, "`%.40s` is none of degree, knots, refine", word);
}

int kw_meshtext_read(kw_meshtext *r, const char *text, size_t size)
{
    char *line = kw_need_memory(size + 1, 1);
    int failed = 0;

    for (size_t at = 0; at < size && !failed;) {
        const char *end = memchr(text + at, '\n', size - at);
        size_t length = end ? (size_t)(end - text) - at : size - at;

        memcpy(line, text + at, length);
        line[length] = 0;
        r->line++;
        if (strlen(line) < length)
            failed = kw_meshtext_wrong(r, "a zero byte; this is no text");
        else
            failed = read_line(r, line);
        at += length + 1;
    }
    free(line);
    r->line = 0; /* complaints on the file as a whole */
    if (!failed && (r->D == 0 || r->directions < r->D))
        failed = kw_meshtext_wrong(r, r->D == 0 ? "no `degree` line"
                                                : "fewer `knots` lines than degrees");
    return failed;
}

void kw_meshtext_clear(kw_meshtext *r)
{
    for (int h = 0; h < r->directions; h++)
        kw_bspline_free(r->s[h]);
    free(r->box);
    free(r->box_line);
}
