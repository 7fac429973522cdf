#include "meshfile.h"
#include "box.h"
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

/* Of all refine lines together: cells that kw_mesh_refine goes through. Half a minute. */
enum { MOST_STEPS = 1 << 30 };

/* A mesh within the limits is written with fewer characters, at most 25 for a knot of level 0 and
   30, 48 or 66 for a refined cell, which counts as 2, 4 or 8 cells. */
static const size_t most_bytes = (size_t)1 << 31;

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
    int levels;          /* for which there is room, the knots counted */
    double knots, cells; /* of all levels of the mesh so far */
    double steps;        /* cells that the boxes used so far went through */
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

/* --- limits --- */

static double knots_of_level(const kw_mesh *m, int level)
{
    double knots = 0;

    for (int h = 0; h < m->D; h++)
        knots += m->level[level].s[h]->n + m->level[level].s[h]->d + 1;
    return knots;
}

/* The cells of Omega^level. */
static double cells_of_level(const kw_mesh *m, int level)
{
    return (double)kw_mesh_active(m, level) + m->level[level].count;
}

/* Functions of level 0. */
static double functions_of(int D, kw_bspline *const *s)
{
    double functions = 1;

    for (int h = 0; h < D; h++)
        functions *= s[h]->n;
    return functions;
}

/* Can a file of this mesh be read again? 0, or 1 after a message on stderr. */
static int check_limits(const kw_mesh *m, const char *path)
{
    double functions = functions_of(m->D, m->level[0].s), knots = 0, cells = 0;

    for (int level = 0; level < m->levels; level++) {
        knots += knots_of_level(m, level);
        cells += cells_of_level(m, level);
    }
    if (functions <= KW_MESHFILE_CELLS && cells <= KW_MESHFILE_CELLS &&
        knots <= KW_MESHFILE_KNOTS)
        return 0;
    fprintf(stderr,
            "%s: not written: %.0f cells, %.0f functions on level 0, more than %d, or "
            "%.0f knots, more than %d\n",
            path, cells, functions, KW_MESHFILE_CELLS, knots, KW_MESHFILE_KNOTS);
    return 1;
}

/* --- from lines to a mesh --- */

/* Is there room for the cells of `level` to be halved once more? Knots must have a number
   between them, and indices must stay small. */
static int check_next_level(reader *r, const kw_mesh *m, int level)
{
    const kw_mesh_level *l = &m->level[level];
    double functions = 1, knots = knots_of_level(m, level);

    for (int h = 0; h < m->D; h++) {
        functions *= 2.0 * l->cells[h] + l->s[h]->d;
        knots += l->cells[h];
    }
    r->knots += knots;
    if (r->knots > KW_MESHFILE_KNOTS)
        return complain(r, "with level %d the mesh would have %.0f knots, more than %d",
                        level + 1, r->knots, KW_MESHFILE_KNOTS);
    if (functions >= 0x1p62) /* as in kw_mesh_refine */
        return complain(r, "level %d would have about %g functions", level + 1,
                        functions);
    for (int h = 0; h < m->D; h++) {
        const double *t = l->s[h]->t;

        for (int i = 0; i < l->s[h]->n + l->s[h]->d; i++) {
            double middle = t[i] + (t[i + 1] - t[i]) / 2;

            if (t[i] < t[i + 1] && !(t[i] < middle && middle < t[i + 1]))
                return complain(r,
                                "level %d: no number between the knots %.17g and %.17g",
                                level + 1, t[i], t[i + 1]);
        }
    }
    return 0;
}

/* How many cells of Omega^level a box holds, at most. */
static double cells_of_box(const kw_mesh *m, int level, const int *low, const int *high)
{
    double cells = 1;

    for (int h = 0; h < m->D; h++)
        cells *= high[h] - low[h];
    return fmin(cells, cells_of_level(m, level));
}

/* Counts the cells that a pass through a box goes through. */
static int take_steps(reader *r, double cells)
{
    r->steps += cells;
    if (r->steps > MOST_STEPS)
        return complain(r,
                        "the boxes of level 0 to this one have %.0f cells, more than %d; "
                        "name cells only once, in few large boxes",
                        r->steps, MOST_STEPS);
    return 0;
}

/* The cells of a box that kw_mesh_refine would refine, counted one by one. */
static double new_cells(const kw_mesh *m, int level, const int *low, const int *high)
{
    int cell[KW_TENSOR_D] = {0};
    double box = 1, found = 0;
    long long count;
    uint64_t *list;

    for (int h = 0; h < m->D; h++) {
        cell[h] = low[h];
        box *= high[h] - low[h];
    }
    if (box <= cells_of_level(m, level)) {
        do
            found += kw_mesh_inside(m, level, cell) && !kw_mesh_refined(m, level, cell);
        while (kw_box_next(m->D, low, high, cell));
        return found;
    }
    list = kw_mesh_cells(m, level, &count);
    for (long long i = 0; i < count; i++) {
        int in_box = 1;

        kw_mesh_multi(m, level, list[i], cell);
        for (int h = 0; h < m->D; h++)
            in_box = in_box && low[h] <= cell[h] && cell[h] < high[h];
        found += in_box && !kw_mesh_refined(m, level, cell);
    }
    free(list);
    return found;
}

/* Would too many cells be refined? They are counted only if it might be so. */
static int check_cells(reader *r, const kw_mesh *m, int level, const int *low,
                       const int *high)
{
    const int children = 1 << m->D;
    double most = cells_of_box(m, level, low, high), cells = r->cells;

    if (cells + most * children <= KW_MESHFILE_CELLS)
        return 0;
    if (take_steps(r, most))
        return 1;
    cells += new_cells(m, level, low, high) * children;
    if (cells > KW_MESHFILE_CELLS)
        return complain(r, "with this box the levels would have %.0f cells, more than %d",
                        cells, KW_MESHFILE_CELLS);
    return 0;
}

/* Is it a box of cells of its level? The levels before are complete. */
static int check_box(reader *r, const kw_mesh *m, const int *box)
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
    return take_steps(r, cells_of_box(m, level, low, high));
}

static int use_box(reader *r, kw_mesh *m, const int *box)
{
    int level = box[0];
    const int *low = box + 1, *high = box + 1 + r->D;

    if (check_cells(r, m, level, low, high))
        return 1;
    if (r->levels == level + 1) {
        if (check_next_level(r, m, level))
            return 1;
        r->levels++;
    }
    r->cells += (double)kw_mesh_refine(m, level, low, high) * (1 << m->D);
    return 0;
}

/* All boxes of a level: first they are checked, so that too many steps are not begun. */
static int use_level(reader *r, kw_mesh *m, int level)
{
    int failed = 0;

    for (int use = 0; use < 2; use++)
        for (size_t i = 0; i < r->boxes && !failed; i++) {
            if (r->box[i][0] != level)
                continue;
            r->line = r->box_line[i];
            failed = use ? use_box(r, m, r->box[i]) : check_box(r, m, r->box[i]);
        }
    return failed;
}

static kw_mesh *build(reader *r)
{
    kw_tensor *g;
    kw_mesh *m;
    double functions;
    int failed = 0, deepest = 0;

    r->line = 0; /* complaints on the file as a whole */
    if (r->D == 0 || r->directions < r->D) {
        complain(r, r->D == 0 ? "no `degree` line" : "fewer `knots` lines than degrees");
        return NULL;
    }
    functions = functions_of(r->D, r->s);
    if (functions > KW_MESHFILE_CELLS) {
        complain(r, "%.0f functions on level 0, more than %d", functions,
                 KW_MESHFILE_CELLS);
        return NULL;
    }
    g = kw_tensor_new(r->D, (const kw_bspline *const *)r->s);
    m = kw_mesh_new(g);
    kw_tensor_free(g);
    r->levels = 1;
    r->knots = knots_of_level(m, 0);
    r->cells = cells_of_level(m, 0);
    for (size_t i = 0; i < r->boxes; i++)
        deepest = r->box[i][0] > deepest ? r->box[i][0] : deepest;
    for (int level = 0; level <= deepest && !failed; level++)
        failed = use_level(r, m, level);
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
    while (*size <= most_bytes && (got = fread(text + *size, 1, room - *size, f)) > 0) {
        *size += got;
        if (*size == room) {
            char *more = realloc(text, room *= 2);

            KW_NEED(more, "memory for %zu bytes", room);
            text = more;
        }
    }
    error = *size > most_bytes ? EFBIG : ferror(f) ? errno : 0;
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
    kw_out *f;

    if (check_limits(m, path))
        return 1;
    f = kw_out_new(path);
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
