#include "points.h"
#include "gen.h"
#include "need.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 1000 }; /* characters of a line: far more than three numbers need */

typedef struct reader {
    const char *path;
    FILE *file;
    int D;
    long line; /* the present one, from 1 */
    char text[LONGEST + 1];
} reader;

/* The next line into r->text, without its end. 1, 0 at the end of the file, or -1 after a
   message. Not more than a line is kept, so that no file is too large. */
static int next_line(reader *r)
{
    int length = 0, c;

    r->line++;
    errno = 0;
    while ((c = getc(r->file)) != EOF && c != '\n') {
        if (c == 0)
            return gen_say(-1, "%s:%ld: a zero byte; this is no text", r->path, r->line);
        if (length == LONGEST)
            return gen_say(-1, "%s:%ld: more than %d characters: `%.40s...'", r->path,
                           r->line, LONGEST, r->text);
        r->text[length++] = (char)c;
        r->text[length] = 0;
    }
    if (ferror(r->file)) /* a directory, say */
        return gen_say(-1, "%s: %s", r->path, strerror(errno));
    if (c == EOF && length == 0)
        return 0;
    length -= length > 0 && r->text[length - 1] == '\r';
    r->text[length] = 0;
    return 1;
}

static int read_header(reader *r)
{
    char wanted[3 * KW_TENSOR_D + 1] = "";
    int there = next_line(r);

    for (int h = 0; h < r->D; h++)
        snprintf(wanted + 3 * h, sizeof wanted - 3 * (size_t)h, "x%d,", h + 1);
    wanted[3 * r->D - 1] = 0;
    if (there == 0)
        return gen_say(1, "%s:1: the file is empty; it begins with the line `%s'",
                       r->path, wanted);
    if (there == 1 && strcmp(r->text, wanted) != 0)
        return gen_say(1, "%s:1: the first line is `%.40s', not `%s'", r->path, r->text,
                       wanted);
    return there < 0;
}

/* The number of direction h in the characters up to `end`. */
static int read_number(const reader *r, const kw_mesh *m, int h, char *word, char *end,
                       double *x)
{
    const kw_bspline *s = m->level[0].s[h];
    double a = s->t[s->d], b = s->t[s->n];
    char *stop;
    int found;

    *end = 0;
    *x = strtod(word, &stop);
    found = stop > word; /* not where there are blanks alone */
    stop += strspn(stop, " \t");
    if (!found || *stop || strpbrk(word, "xX"))
        return gen_say(1, "%s:%ld: x%d is `%.40s', which is no number", r->path, r->line,
                       h + 1, word);
    if (!isfinite(*x))
        return gen_say(1, "%s:%ld: x%d is `%.40s', which is not finite", r->path, r->line,
                       h + 1, word);
    if (*x < a || *x > b)
        return gen_say(1, "%s:%ld: x%d is %.40s, outside the domain [%.17g, %.17g]",
                       r->path, r->line, h + 1, word, a, b);
    return 0;
}

static int read_point(reader *r, const kw_mesh *m, double *x)
{
    char *word = r->text;
    int columns = 1;

    for (const char *c = r->text; *c; c++)
        columns += *c == ',';
    if (columns != r->D || !*r->text)
        return gen_say(1, "%s:%ld: `%.40s' has %d columns, not %d", r->path, r->line,
                       r->text, *r->text ? columns : 0, r->D);
    for (int h = 0; h < r->D; h++) {
        char *end = word + strcspn(word, ",");

        if (read_number(r, m, h, word, end, &x[h]))
            return 1;
        word = end + 1;
    }
    return 0;
}

static int read_points(reader *r, const kw_mesh *m, size_t *count, double **x)
{
    size_t room = 0, D = (size_t)r->D;
    int there, failed = read_header(r);

    while (!failed && (there = next_line(r)) != 0) {
        if (*count == room) {
            room = room > 0 ? 2 * room : 256;
            *x = realloc(*x, room * D * sizeof **x);
            KW_NEED(*x, "memory for %zu points", room);
        }
        failed = there < 0 || read_point(r, m, *x + *count * D);
        ++*count;
    }
    return failed;
}

int points_read(const char *path, const kw_mesh *m, size_t *count, double **x)
{
    reader r = {.path = path, .D = m->D, .file = fopen(path, "rb")};
    int failed;

    *count = 0;
    *x = NULL;
    if (!r.file)
        return gen_say(1, "%s: %s", path, strerror(errno));
    failed = read_points(&r, m, count, x);
    fclose(r.file);
    if (failed) {
        free(*x);
        *x = NULL;
    }
    return failed;
}
