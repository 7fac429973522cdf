#include "meshfile.h"
#include "active.h"
#include "need.h"
#include "out.h"
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a file may ask for, so that no short text takes the whole machine. */
enum {
    MOST_BYTES = 1 << 28,
    MOST_IN_DIRECTION = 1 << 20, /* cells of a direction on one level */
    MOST_CELLS = 1 << 26         /* on level 0; gone through by all refine lines */
};

/* A text that is being read, and what is known of the mesh so far. */
typedef struct reader {
    const char *name; /* of the file */
    int line;         /* the present one, from 1 */
    char *message;    /* where complaints go */
    int D;            /* directions, 0 before `degree` */
    int degree[KW_TENSOR_D];
    int directions;                  /* of which the knots are known */
    kw_bspline *s[KW_TENSOR_D];      /* their spaces */
    int (*box)[1 + 2 * KW_TENSOR_D]; /* level, low, high of each refine line */
    int *box_line;                   /* the line it stands in */
    size_t boxes, room;
    double walked; /* cells that the boxes used so far went through */
} reader;

/* Notes what is wrong in the present line; always 1. */
static int complain(reader *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static int complain(reader *r, const char *format, ...)
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
static int read_int(reader *r, const char *word, const char *what, int low, int high,
                    int *value)
{
    char *end;
    long v;

    if (!word)
        return complain(r, "%s is missing", what);
    errno = 0;
    v = strtol(word, &end, 10);
    if (end == word || *end)
        return complain(r, "%s `%.40s` is no whole number", what, word);
    if (errno == ERANGE || v < low || v > high)
        return complain(r, "%s %.40s is not in %d .. %d", what, word, low, high);
    *value = (int)v;
    return 0;
}

static int read_degree(reader *r, char *rest)
{
    char *word;
    int local = 1;

    if (r->D > 0)
        return complain(r,
                        "a second `degree` line; the degree is the same on all levels, "
                        "because spaces of different degree on dyadic knots are not "
                        "nested");
    while ((word = next_word(&rest))) {
        if (r->D == KW_TENSOR_D)
            return complain(r, "more than %d degrees", KW_TENSOR_D);
        if (read_int(r, word, "degree", 0, KW_BSPLINE_DEGREE, &r->degree[r->D]))
            return 1;
        r->D++;
    }
    if (r->D == 0)
        return complain(r, "`degree` without a number");
    for (int h = 0; h < r->D; h++)
        local *= r->degree[h] + 1;
    if (local > KW_ACTIVE_LOCAL)
        return complain(r, "%d functions on a cell, more than %d", local,
                        KW_ACTIVE_LOCAL);
    return 0;
}

/* What kw_bspline_new would abort on. */
static int check_knots(reader *r, int d, int count, const double *t)
{
    int n = count - d - 1;

    if (n < d + 1)
        return complain(r, "%d knots are too few for degree %d; at least %d", count, d,
                        2 * d + 2);
    for (int i = 1; i < count; i++)
        if (t[i] < t[i - 1])
            return complain(r, "knots decrease: %.17g after %.17g", t[i], t[i - 1]);
    if (!isfinite(t[count - 1] - t[0]))
        return complain(r, "knots from %g to %g are too far apart", t[0], t[count - 1]);
    for (int i = 0; i < n; i++)
        if (t[i] == t[i + d + 1])
            return complain(r, "knot %.17g appears more than %d times", t[i], d + 1);
    if (t[d] == t[d + 1] || t[n - 1] == t[n])
        return complain(r, "the domain [%.17g, %.17g] begins or ends with an empty span",
                        t[d], t[n]);
    return 0;
}

static int read_knots(reader *r, char *rest)
{
    size_t most = strlen(rest) / 2 + 1; /* words of one character and a blank */
    double *t;
    char *word;
    int count = 0, failed = 0;

    if (r->D == 0)
        return complain(r, "`knots` before `degree`");
    if (r->directions == r->D)
        return complain(r, "more `knots` lines than the %d degrees", r->D);
    t = kw_need_memory(most, sizeof *t);
    while (!failed && (word = next_word(&rest))) {
        char *end;

        t[count] = strtod(word, &end);
        if (end == word || *end || !isfinite(t[count]))
            failed = complain(r, "knot `%.40s` is no finite number", word);
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
static int read_refine(reader *r, char *rest)
{
    int *box;

    if (r->D == 0 || r->directions < r->D)
        return complain(r, "`refine` before %s", r->D == 0 ? "`degree`" : "all `knots`");
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
        return complain(r, "more than a level and two corners of %d numbers", r->D);
    r->boxes++;
    return 0;
}

static int read_line(reader *r, char *line)
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
    return complain(r, "`%.40s` is none of degree, knots, refine", word);
}

/* --- from lines to a mesh --- */

/* Is there room for the level below `level` to be halved once more? Knots must have a number
   between them, and indices must stay small. */
static int check_next_level(reader *r, const kw_mesh *m, int level)
{
    const kw_mesh_level *l = &m->level[level];
    double functions = 1;

    for (int h = 0; h < m->D; h++) {
        const double *t = l->s[h]->t;

        if (l->cells[h] > MOST_IN_DIRECTION / 2)
            return complain(r,
                            "level %d would have %d cells in direction %d, more than %d",
                            level + 1, 2 * l->cells[h], h, MOST_IN_DIRECTION);
        functions *= 2.0 * l->cells[h] + l->s[h]->n;
        for (int i = 0; i < l->s[h]->n + l->s[h]->d; i++) {
            double middle = t[i] + (t[i + 1] - t[i]) / 2;

            if (t[i] < t[i + 1] && !(t[i] < middle && middle < t[i + 1]))
                return complain(r,
                                "level %d: no number between the knots %.17g and %.17g",
                                level + 1, t[i], t[i + 1]);
        }
    }
    if (functions > 0x1p60)
        return complain(r, "level %d would have about %g functions", level + 1,
                        functions);
    return 0;
}

/* Counts the cells that kw_mesh_refine goes through. */
static int check_work(reader *r, const kw_mesh *m, int level, const int *low,
                      const int *high)
{
    double cells = 1;

    for (int h = 0; h < m->D; h++)
        cells *= high[h] - low[h];
    if (level > 0)
        cells = fmin(cells, (double)m->level[level - 1].count * (1 << m->D));
    r->walked += cells;
    if (r->walked > MOST_CELLS)
        return complain(r,
                        "the boxes of level 0 to this one have %.0f cells, more than %d",
                        r->walked, MOST_CELLS);
    return 0;
}

static int use_box(reader *r, kw_mesh *m, const int *box)
{
    int level = box[0];
    const int *low = box + 1, *high = box + 1 + r->D;

    if (level >= m->levels)
        return complain(r, "level %d skips a level: no cell of level %d is refined",
                        level, m->levels - 1);
    for (int h = 0; h < m->D; h++) {
        if (high[h] > m->level[level].cells[h])
            return complain(r,
                            "cell %d of direction %d is outside the %d cells of level %d",
                            high[h] - 1, h, m->level[level].cells[h], level);
        if (low[h] >= high[h])
            return complain(r, "an empty box: cells %d .. %d of direction %d", low[h],
                            high[h] - 1, h);
    }
    if (check_work(r, m, level, low, high) ||
        (level + 1 == m->levels && check_next_level(r, m, level)))
        return 1;
    kw_mesh_refine(m, level, low, high);
    return 0;
}

static kw_mesh *build(reader *r)
{
    kw_tensor *g;
    kw_mesh *m;
    double functions = 1;
    int failed = 0, deepest = 0;

    r->line = 0; /* complaints on the file as a whole */
    if (r->D == 0 || r->directions < r->D) {
        complain(r, r->D == 0 ? "no `degree` line" : "fewer `knots` lines than degrees");
        return NULL;
    }
    for (int h = 0; h < r->D; h++)
        functions *= r->s[h]->n;
    if (functions > MOST_CELLS) {
        complain(r, "%.0f functions on level 0, more than %d", functions, MOST_CELLS);
        return NULL;
    }
    g = kw_tensor_new(r->D, (const kw_bspline *const *)r->s);
    m = kw_mesh_new(g);
    kw_tensor_free(g);
    for (size_t i = 0; i < r->boxes; i++)
        deepest = r->box[i][0] > deepest ? r->box[i][0] : deepest;
    for (int level = 0; level <= deepest && !failed; level++)
        for (size_t i = 0; i < r->boxes && !failed; i++) {
            r->line = r->box_line[i];
            if (r->box[i][0] == level)
                failed = use_box(r, m, r->box[i]);
        }
    if (failed) {
        kw_mesh_free(m);
        return NULL;
    }
    return m;
}

kw_mesh *kw_meshfile_parse(const char *text, size_t size, const char *name, char *message)
{
    reader r = {.name = name, .message = message};
    kw_mesh *m = NULL;
    int failed = 0;
    char *line = kw_need_memory(size + 1, 1);

    message[0] = 0;
    for (size_t at = 0; at < size && !failed;) {
        const char *end = memchr(text + at, '\n', size - at);
        size_t length = end ? (size_t)(end - text) - at : size - at;

        memcpy(line, text + at, length);
        line[length] = 0;
        r.line++;
        if (strlen(line) < length)
            failed = complain(&r, "a zero byte; this is no text");
        else
            failed = read_line(&r, line);
        at += length + 1;
    }
    if (!failed)
        m = build(&r);
    for (int h = 0; h < r.directions; h++)
        kw_bspline_free(r.s[h]);
    free(r.box);
    free(r.box_line);
    free(line);
    return m;
}

/* The whole file in memory, *size characters; NULL with errno set if it cannot be read. */
static char *read_file(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    size_t room = 1 << 16, got;
    char *text;
    int error;

    if (!f)
        return NULL;
    text = kw_need_memory(room, 1);
    *size = 0;
    errno = 0;
    while (*size <= MOST_BYTES && (got = fread(text + *size, 1, room - *size, f)) > 0) {
        *size += got;
        if (*size == room) {
            char *more = realloc(text, room *= 2);

            KW_NEED(more, "memory for %zu bytes", room);
            text = more;
        }
    }
    error = *size > MOST_BYTES ? EFBIG : ferror(f) ? errno : 0;
    fclose(f);
    if (error) { /* a directory, say */
        free(text);
        errno = error;
        return NULL;
    }
    return text;
}

kw_mesh *kw_meshfile_read(const char *path, char *message)
{
    size_t size;
    char *text = read_file(path, &size);
    kw_mesh *m;

    if (!text) {
        snprintf(message, KW_MESHFILE_MESSAGE, "%.200s: %s", path, strerror(errno));
        return NULL;
    }
    m = kw_meshfile_parse(text, size, path, message);
    free(text);
    return m;
}

/* --- writing --- */

/* Cells of one level that follow one another in the last direction go into one box. */
static void write_level(kw_out *f, const kw_mesh *m, int level)
{
    long long count;
    uint64_t *list = kw_mesh_cells(m, level, &count);

    for (long long i = 0; i < count;) {
        int low[KW_TENSOR_D], cell[KW_TENSOR_D];
        long long run = 0;

        kw_mesh_multi(m, level, list[i], low);
        while (i + run < count && list[i + run] == list[i] + (uint64_t)run) {
            kw_mesh_multi(m, level, list[i + run], cell);
            if (!kw_mesh_refined(m, level, cell) ||
                cell[m->D - 1] != low[m->D - 1] + (int)run)
                break;
            run++;
        }
        if (run > 0) {
            kw_out_text(f, "refine %d ", level);
            for (int h = 0; h < m->D; h++)
                kw_out_text(f, " %d", low[h]);
            kw_out_text(f, " ");
            for (int h = 0; h < m->D; h++)
                kw_out_text(f, " %d", low[h] + (h == m->D - 1 ? (int)run : 1));
            kw_out_text(f, "\n");
        }
        i += run > 0 ? run : 1;
    }
    free(list);
}

int kw_meshfile_write(const kw_mesh *m, const char *path)
{
    kw_out *f = kw_out_new(path);

    kw_out_text(f, "degree");
    for (int h = 0; h < m->D; h++)
        kw_out_text(f, " %d", m->level[0].s[h]->d);
    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[0].s[h];

        kw_out_text(f, "\nknots");
        for (int i = 0; i <= s->n + s->d; i++)
            kw_out_text(f, " %.17g", s->t[i]);
    }
    kw_out_text(f, "\n");
    for (int level = 0; level + 1 < m->levels; level++)
        write_level(f, m, level);
    return kw_out_close(f);
}
