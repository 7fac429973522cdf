#include "mesh.h"
#include "box.h"
#include "insert.h"
#include "need.h"
#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 16 };

/* A grid has at most this many cells, so that flat indices and what is computed from them
   stay far from overflow. */
static const double MOST_CELLS = 0x1p62;

/* --- levels --- */

/* Numbers the breakpoints of direction h of the level. */
static void number_cells(kw_mesh_level *l, int h)
{
    const kw_bspline *s = l->s[h];
    int cell = 0;

    l->span[h] = kw_need_memory((size_t)(s->n - s->d), sizeof *l->span[h]);
    l->edge[h] = kw_need_memory((size_t)s->n + (size_t)s->d + 1, sizeof *l->edge[h]);
    for (int i = 0; i <= s->n + s->d; i++) {
        l->edge[h][i] = cell;
        if (s->d <= i && i < s->n && s->t[i] < s->t[i + 1])
            l->span[h][cell++] = i;
    }
    l->cells[h] = cell;
}

/* Level `level` with the spaces s, which are handed over. */
static void add_level(kw_mesh *m, kw_bspline *const *s)
{
    kw_mesh_level *l = &m->level[m->levels++];
    double cells = 1;

    KW_NEED(m->levels <= KW_MESH_LEVELS, "more than %d levels", KW_MESH_LEVELS);
    for (int h = 0; h < m->D; h++) {
        l->s[h] = s[h];
        number_cells(l, h);
        cells *= l->cells[h] + s[h]->d;
    }
    KW_NEED(cells < MOST_CELLS, "about %g functions on level %d", cells, m->levels - 1);
    l->refined = kw_map_new();
}

kw_mesh *kw_mesh_new(const kw_tensor *g)
{
    kw_mesh *m = kw_need_memory(1, sizeof *m);
    kw_bspline *s[KW_TENSOR_D] = {NULL};

    m->D = g->D;
    m->level = kw_need_memory(KW_MESH_LEVELS, sizeof *m->level);
    for (int h = 0; h < g->D; h++)
        s[h] = kw_bspline_new_copy(g->s[h]);
    add_level(m, s);
    return m;
}

static void remember_refined(kw_mesh_level *l, uint64_t flat)
{
    if (l->count == l->room) {
        l->room = l->room > 0 ? 2 * l->room : FIRST_ROOM;
        l->list = realloc(l->list, (size_t)l->room * sizeof *l->list);
        KW_NEED(l->list, "memory for %d cells", l->room);
    }
    kw_map_put(l->refined, flat, l->count);
    l->list[l->count++] = flat;
}

kw_mesh *kw_mesh_new_copy(const kw_mesh *m)
{
    kw_mesh *copy = kw_need_memory(1, sizeof *copy);

    copy->D = m->D;
    copy->level = kw_need_memory(KW_MESH_LEVELS, sizeof *copy->level);
    for (int l = 0; l < m->levels; l++) {
        kw_bspline *s[KW_TENSOR_D] = {NULL};

        for (int h = 0; h < m->D; h++)
            s[h] = kw_bspline_new_copy(m->level[l].s[h]);
        add_level(copy, s);
        for (int i = 0; i < m->level[l].count; i++)
            remember_refined(&copy->level[l], m->level[l].list[i]);
    }
    return copy;
}

void kw_mesh_free(kw_mesh *m)
{
    if (!m)
        return;
    for (int i = 0; i < m->levels; i++) {
        kw_mesh_level *l = &m->level[i];

        for (int h = 0; h < m->D; h++) {
            kw_bspline_free(l->s[h]);
            free(l->span[h]);
            free(l->edge[h]);
        }
        kw_map_free(l->refined);
        free(l->list);
    }
    free(m->level);
    free(m);
}

/* --- cells --- */

static void need_cell(const kw_mesh *m, int level, const int *cell)
{
    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    for (int h = 0; h < m->D; h++)
        KW_NEED(0 <= cell[h] && cell[h] < m->level[level].cells[h],
                "cell %d of direction %d on level %d, not in 0 .. %d", cell[h], h, level,
                m->level[level].cells[h] - 1);
}

uint64_t kw_mesh_flat(const kw_mesh *m, int level, const int *cell)
{
    uint64_t flat = 0;

    need_cell(m, level, cell);
    for (int h = 0; h < m->D; h++)
        flat = flat * (uint64_t)m->level[level].cells[h] + (uint64_t)cell[h];
    return flat;
}

void kw_mesh_multi(const kw_mesh *m, int level, uint64_t flat, int *cell)
{
    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    for (int h = m->D - 1; h >= 0; h--) {
        uint64_t cells = (uint64_t)m->level[level].cells[h];

        cell[h] = (int)(flat % cells);
        flat /= cells;
    }
}

int kw_mesh_refined(const kw_mesh *m, int level, const int *cell)
{
    return kw_map_find(m->level[level].refined, kw_mesh_flat(m, level, cell)) !=
           KW_MAP_NONE;
}

int kw_mesh_inside(const kw_mesh *m, int level, const int *cell)
{
    int parent[KW_TENSOR_D] = {0};

    need_cell(m, level, cell);
    if (level == 0)
        return 1;
    for (int h = 0; h < m->D; h++)
        parent[h] = cell[h] / 2;
    return kw_mesh_refined(m, level - 1, parent);
}

static void need_next_level(kw_mesh *m, int level)
{
    kw_bspline *fine[KW_TENSOR_D] = {NULL};

    if (level + 1 < m->levels)
        return;
    for (int h = 0; h < m->D; h++)
        fine[h] = kw_insert_new_dyadic(m->level[level].s[h]);
    add_level(m, fine);
}

static int refine_cell(kw_mesh *m, int level, const int *cell)
{
    if (!kw_mesh_inside(m, level, cell) || kw_mesh_refined(m, level, cell))
        return 0;
    need_next_level(m, level);
    remember_refined(&m->level[level], kw_mesh_flat(m, level, cell));
    return 1;
}

/* Refines those children of the refined cells of level-1 that lie in the box: quicker than a
   walk through the box where the box is large and the domain is not. */
static int refine_children(kw_mesh *m, int level, const int *low, const int *high)
{
    int done = 0, before = m->level[level - 1].count;

    for (int i = 0; i < before; i++) {
        int parent[KW_TENSOR_D], cell[KW_TENSOR_D];

        kw_mesh_multi(m, level - 1, m->level[level - 1].list[i], parent);
        for (int child = 0; child < 1 << m->D; child++) {
            int in_box = 1;

            for (int h = 0; h < m->D; h++) {
                cell[h] = 2 * parent[h] + (child >> h & 1);
                in_box = in_box && low[h] <= cell[h] && cell[h] < high[h];
            }
            done += in_box && refine_cell(m, level, cell);
        }
    }
    return done;
}

int kw_mesh_refine(kw_mesh *m, int level, const int *low, const int *high)
{
    int cell[KW_TENSOR_D], done = 0;
    double box = 1;

    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    KW_NEED(level + 1 < KW_MESH_LEVELS, "level %d; level %d is the last one", level,
            KW_MESH_LEVELS - 1);
    for (int h = 0; h < m->D; h++) {
        KW_NEED(0 <= low[h] && low[h] <= high[h] && high[h] <= m->level[level].cells[h],
                "cells %d .. %d of direction %d on level %d, not in 0 .. %d", low[h],
                high[h] - 1, h, level, m->level[level].cells[h] - 1);
        cell[h] = low[h];
        box *= high[h] - low[h];
    }
    if (box == 0)
        return 0;
    if (level > 0 && box > (double)m->level[level - 1].count * (1 << m->D))
        return refine_children(m, level, low, high);
    do
        done += refine_cell(m, level, cell);
    while (kw_box_next(m->D, low, high, cell));
    return done;
}

/* --- asking --- */

int kw_mesh_locate(const kw_mesh *m, const double *x, int *cell)
{
    int level = 0;

    for (int h = 0; h < m->D; h++)
        cell[h] = m->level[0].edge[h][kw_bspline_span(m->level[0].s[h], x[h])];
    while (kw_mesh_refined(m, level, cell)) {
        const kw_mesh_level *fine = &m->level[++level];

        for (int h = 0; h < m->D; h++) {
            /* the second half begins at the knot behind the span of the first */
            double middle = fine->s[h]->t[fine->span[h][2 * cell[h]] + 1];

            cell[h] = 2 * cell[h] + (x[h] >= middle);
        }
    }
    return level;
}

static int ascending(const void *a, const void *b)
{
    const uint64_t *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

uint64_t *kw_mesh_cells(const kw_mesh *m, int level, long long *count)
{
    const int children = 1 << m->D;
    uint64_t *list;
    long long i = 0;

    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    *count = level > 0 ? (long long)m->level[level - 1].count * children : 1;
    for (int h = 0; level == 0 && h < m->D; h++)
        *count *= m->level[0].cells[h];
    list = kw_need_memory((size_t)*count, sizeof *list);
    if (level == 0) {
        for (; i < *count; i++)
            list[i] = (uint64_t)i;
        return list;
    }
    for (int p = 0; p < m->level[level - 1].count; p++) {
        int parent[KW_TENSOR_D], cell[KW_TENSOR_D];

        kw_mesh_multi(m, level - 1, m->level[level - 1].list[p], parent);
        for (int child = 0; child < children; child++) {
            for (int h = 0; h < m->D; h++)
                cell[h] = 2 * parent[h] + (child >> h & 1);
            list[i++] = kw_mesh_flat(m, level, cell);
        }
    }
    qsort(list, (size_t)*count, sizeof *list, ascending);
    return list;
}

long long kw_mesh_active(const kw_mesh *m, int level)
{
    long long inside = 1;

    KW_NEED(0 <= level && level < m->levels, "level %d, not in 0 .. %d", level,
            m->levels - 1);
    if (level > 0)
        inside = (long long)m->level[level - 1].count << m->D;
    for (int h = 0; level == 0 && h < m->D; h++)
        inside *= m->level[0].cells[h];
    return inside - m->level[level].count;
}

/* Marks the breakpoints of direction h, numbered on the finest level, that bound an active
   cell. */
static void mark_edges(const kw_mesh *m, int h, char *mark)
{
    for (int level = 0; level < m->levels; level++) {
        int shift = m->levels - 1 - level;
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];

            kw_mesh_multi(m, level, list[i], cell);
            if (kw_mesh_refined(m, level, cell))
                continue;
            mark[(size_t)cell[h] << shift] = 1;
            mark[(size_t)(cell[h] + 1) << shift] = 1;
        }
        free(list);
    }
}

kw_bspline *kw_mesh_new_direction(const kw_mesh *m, int h)
{
    KW_NEED(0 <= h && h < m->D, "direction %d, not in 0 .. %d", h, m->D - 1);
    const kw_mesh_level *finest = &m->level[m->levels - 1];
    const kw_bspline *s = finest->s[h], *coarse = m->level[0].s[h];
    char *mark = kw_need_memory((size_t)finest->cells[h] + 1, 1);
    double *t = kw_need_memory((size_t)s->n + (size_t)s->d + 1, sizeof *t);
    int count = 0, d = s->d;
    kw_bspline *smallest;

    mark_edges(m, h, mark);
    for (int i = 0; i < d; i++) /* the auxiliary knots of level 0 */
        t[count++] = coarse->t[i];
    for (int i = d; i <= s->n; i++)
        if (mark[finest->edge[h][i]] || finest->edge[h][i] % (1 << (m->levels - 1)) == 0)
            t[count++] = s->t[i];
    for (int i = coarse->n + 1; i <= coarse->n + d; i++)
        t[count++] = coarse->t[i];
    smallest = kw_bspline_new(d, count - d - 1, t);
    free(mark);
    free(t);
    return smallest;
}
