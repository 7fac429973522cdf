#include "meshfile.h"
#include "box.h"
#include "meshtext.h"
#include "need.h"
#include "out.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of all refine lines together: cells that kw_mesh_refine goes through. Half a minute. */
enum { MOST_STEPS = 1 << 30 };

/* A mesh within the limits is written with fewer characters, at most 25 for a knot of level 0 and
   30, 48 or 66 for a refined cell, which counts as 2, 4 or 8 cells. */
static const size_t most_bytes = (size_t)1 << 31;

/* A file that is being read: what its lines say, and what is known of the mesh so far. */
typedef struct reader {
    kw_meshtext text;
    int levels;          /* for which there is room, the knots counted */
    double knots, cells; /* of all levels of the mesh so far */
    double steps;        /* cells that the boxes used so far went through */
} reader;

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
        return kw_meshtext_wrong(
            &r->text, "with level %d the mesh would have %.0f knots, more than %d",
            level + 1, r->knots, KW_MESHFILE_KNOTS);
    if (functions >= 0x1p62) /* as in kw_mesh_refine */
        return kw_meshtext_wrong(&r->text, "level %d would have about %g functions",
                                 level + 1, functions);
    for (int h = 0; h < m->D; h++) {
        const double *t = l->s[h]->t;

        for (int i = 0; i < l->s[h]->n + l->s[h]->d; i++) {
            double middle = t[i] + (t[i + 1] - t[i]) / 2;

            if (t[i] < t[i + 1] && !(t[i] < middle && middle < t[i + 1]))
                return kw_meshtext_wrong(
                    &r->text, "level %d: no number between the knots %.17g and %.17g",
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
        return kw_meshtext_wrong(
            &r->text,
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
        return kw_meshtext_wrong(
            &r->text, "with this box the levels would have %.0f cells, more than %d",
            cells, KW_MESHFILE_CELLS);
    return 0;
}

/* Is it a box of cells of its level? The levels before are complete. */
static int check_box(reader *r, const kw_mesh *m, const int *box)
{
    int level = box[0];
    const int *low = box + 1, *high = box + 1 + r->text.D;

    if (level >= m->levels)
        return kw_meshtext_wrong(&r->text,
                                 "level %d skips a level: no cell of level %d is refined",
                                 level, m->levels - 1);
    for (int h = 0; h < m->D; h++) {
        if (high[h] > m->level[level].cells[h])
            return kw_meshtext_wrong(
                &r->text, "cell %d of direction %d is outside the %d cells of level %d",
                high[h] - 1, h, m->level[level].cells[h], level);
        if (low[h] >= high[h])
            return kw_meshtext_wrong(&r->text,
                                     "an empty box: cells %d .. %d of direction %d",
                                     low[h], high[h] - 1, h);
    }
    return take_steps(r, cells_of_box(m, level, low, high));
}

static int use_box(reader *r, kw_mesh *m, const int *box)
{
    int level = box[0];
    const int *low = box + 1, *high = box + 1 + r->text.D;

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
        for (size_t i = 0; i < r->text.boxes && !failed; i++) {
            if (r->text.box[i][0] != level)
                continue;
            r->text.line = r->text.box_line[i];
            failed =
                use ? use_box(r, m, r->text.box[i]) : check_box(r, m, r->text.box[i]);
        }
    return failed;
}

static kw_mesh *build(reader *r)
{
    kw_tensor *g;
    kw_mesh *m;
    double functions;
    int failed = 0, deepest = 0;

    functions = functions_of(r->text.D, r->text.s);
    if (functions > KW_MESHFILE_CELLS) {
        kw_meshtext_wrong(&r->text, "%.0f functions on level 0, more than %d", functions,
                          KW_MESHFILE_CELLS);
        return NULL;
    }
    g = kw_tensor_new(r->text.D, (const kw_bspline *const *)r->text.s);
    m = kw_mesh_new(g);
    kw_tensor_free(g);
    r->levels = 1;
    r->knots = knots_of_level(m, 0);
    r->cells = cells_of_level(m, 0);
    for (size_t i = 0; i < r->text.boxes; i++)
        deepest = r->text.box[i][0] > deepest ? r->text.box[i][0] : deepest;
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
    reader r = {.text = {.name = name, .message = message}};
    kw_mesh *m = NULL;

    message[0] = 0;
    if (!kw_meshtext_read(&r.text, text, size))
        m = build(&r);
    kw_meshtext_clear(&r.text);
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
