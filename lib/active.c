#include "active.h"
#include "box.h"
#include "need.h"
#include <stdlib.h>
#include <string.h>

enum { D_MOST = KW_TENSOR_D };

static uint64_t flat_function(const kw_mesh *m, int level, const int *j)
{
    uint64_t flat = 0;

    for (int h = 0; h < m->D; h++)
        flat = flat * (uint64_t)m->level[level].s[h]->n + (uint64_t)j[h];
    return flat;
}

/* The cells low <= cell < high of the support of function j. */
static void support(const kw_mesh *m, int level, const int *j, int *low, int *high)
{
    const kw_mesh_level *l = &m->level[level];

    for (int h = 0; h < m->D; h++) {
        low[h] = l->edge[h][j[h]];
        high[h] = l->edge[h][j[h] + l->s[h]->d + 1];
    }
}

void kw_active_box(const kw_mesh *m, int level, const int *cell, int *low, int *high)
{
    for (int h = 0; h < m->D; h++) {
        high[h] = m->level[level].span[h][cell[h]] + 1;
        low[h] = high[h] - m->level[level].s[h]->d - 1;
    }
}

static int ascending(const void *a, const void *b)
{
    const uint64_t *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

/* While they are counted: cells of Omega^l in a support, plus REFINED times the refined ones. A
   support has at most KW_ACTIVE_LOCAL cells. */
enum { REFINED = 2 * KW_ACTIVE_LOCAL };

/* Lets every cell of Omega^level tell its local functions that it is there. */
static void count_cells(kw_active *a, int level)
{
    const kw_mesh *m = a->mesh;
    long long cells;
    uint64_t *list = kw_mesh_cells(m, level, &cells);

    for (long long i = 0; i < cells; i++) {
        int cell[D_MOST], low[D_MOST] = {0}, high[D_MOST] = {0}, j[D_MOST], amount;

        kw_mesh_multi(m, level, list[i], cell);
        kw_active_box(m, level, cell, low, high);
        memcpy(j, low, sizeof j);
        amount = kw_mesh_refined(m, level, cell) ? 1 + REFINED : 1;
        do
            kw_map_add(a->status[level], flat_function(m, level, j), amount);
        while (kw_box_next(m->D, low, high, j));
    }
    free(list);
}

/* What a function is, from the counts and the number of cells in its support: it
   is inside Omega^l if all of them are, and covered if all of them are refined.
   [source text, (14)] */
static int status_from_counts(int counts, int cells)
{
    if (counts % REFINED < cells)
        return KW_ACTIVE_OUTSIDE;
    return counts / REFINED == cells ? KW_ACTIVE_COVERED : KW_ACTIVE_FIRST;
}

static void multi_function(const kw_mesh *m, int level, uint64_t flat, int *j)
{
    for (int h = m->D - 1; h >= 0; h--) {
        uint64_t n = (uint64_t)m->level[level].s[h]->n;

        j[h] = (int)(flat % n);
        flat /= n;
    }
}

static void append_active(kw_active *a, uint64_t flat, size_t *room)
{
    if ((size_t)a->size == *room) {
        *room = *room > 0 ? 2 * *room : 64;
        a->flat = realloc(a->flat, *room * sizeof *a->flat);
        KW_NEED(a->flat && *room < INT32_MAX, "memory for %zu functions", *room);
    }
    a->flat[a->size++] = flat;
}

/* Turns the counts of a level into what its functions are, and numbers the active ones in the
   order of their flat indices. */
static void number_level(kw_active *a, int level, size_t *room)
{
    const kw_mesh *m = a->mesh;
    kw_map *status = a->status[level];
    int start = a->size;

    for (size_t i = 0; i < status->room; i++) {
        int j[D_MOST], low[D_MOST] = {0}, high[D_MOST] = {0}, cells = 1;

        if (status->value[i] == KW_MAP_NONE)
            continue;
        multi_function(m, level, status->key[i], j);
        support(m, level, j, low, high);
        for (int h = 0; h < m->D; h++)
            cells *= high[h] - low[h];
        status->value[i] = status_from_counts(status->value[i], cells);
        if (status->value[i] == KW_ACTIVE_FIRST)
            append_active(a, status->key[i], room);
    }
    a->start[level] = start;
    if (a->size > start)
        qsort(a->flat + start, (size_t)(a->size - start), sizeof *a->flat, ascending);
    for (int i = start; i < a->size; i++)
        kw_map_put(status, a->flat[i], KW_ACTIVE_FIRST + i);
}

kw_active *kw_active_new(const kw_mesh *m)
{
    kw_active *a = kw_need_memory(1, sizeof *a);
    double local = 1;
    size_t room = 0;

    for (int h = 0; h < m->D; h++)
        local *= m->level[0].s[h]->d + 1;
    KW_NEED(local <= KW_ACTIVE_LOCAL, "%.0f functions on a cell, more than %d", local,
            KW_ACTIVE_LOCAL);
    a->local = (int)local;
    a->mesh = kw_mesh_new_copy(m);
    a->start = kw_need_memory((size_t)m->levels + 1, sizeof *a->start);
    a->status = kw_need_memory((size_t)m->levels, sizeof *a->status);
    for (int level = 0; level < m->levels; level++) {
        a->status[level] = kw_map_new();
        count_cells(a, level);
        number_level(a, level, &room);
    }
    a->start[m->levels] = a->size;
    a->flat =
        realloc(a->flat, (size_t)a->size * sizeof *a->flat); /* no more than needed */
    KW_NEED(a->flat, "memory for %d functions", a->size);
    return a;
}

void kw_active_free(kw_active *a)
{
    if (!a)
        return;
    for (int level = 0; level < a->mesh->levels; level++)
        kw_map_free(a->status[level]);
    kw_mesh_free(a->mesh);
    free(a->status);
    free(a->start);
    free(a->flat);
    free(a);
}

void kw_active_function(const kw_active *a, int i, int *level, int *j)
{
    KW_NEED(0 <= i && i < a->size, "function %d, not in 0 .. %d", i, a->size - 1);
    *level = 0;
    while (i >= a->start[*level + 1])
        ++*level;
    multi_function(a->mesh, *level, a->flat[i], j);
}

int kw_active_status(const kw_active *a, int level, const int *j)
{
    int is;

    KW_NEED(0 <= level && level < a->mesh->levels, "level %d, not in 0 .. %d", level,
            a->mesh->levels - 1);
    for (int h = 0; h < a->mesh->D; h++)
        KW_NEED(0 <= j[h] && j[h] < a->mesh->level[level].s[h]->n,
                "index %d of direction %d on level %d, not in 0 .. %d", j[h], h, level,
                a->mesh->level[level].s[h]->n - 1);
    is = kw_map_find(a->status[level], flat_function(a->mesh, level, j));
    return is == KW_MAP_NONE ? KW_ACTIVE_OUTSIDE : is;
}

int kw_active_find(const kw_active *a, int level, const int *j)
{
    int is = kw_active_status(a, level, j);

    return is >= KW_ACTIVE_FIRST ? is - KW_ACTIVE_FIRST : -1;
}

void kw_active_of_cell(const kw_active *a, int level, const int *cell, int *is)
{
    int low[D_MOST] = {0}, high[D_MOST] = {0}, j[D_MOST], i = 0;

    kw_active_box(a->mesh, level, cell, low, high);
    memcpy(j, low, sizeof j);
    do {
        int found = kw_map_find(a->status[level], flat_function(a->mesh, level, j));

        is[i++] = found == KW_MAP_NONE ? KW_ACTIVE_OUTSIDE : found;
    } while (kw_box_next(a->mesh->D, low, high, j));
}

int kw_active_cell(const kw_active *a, int i, int *cell)
{
    int level, j[D_MOST], low[D_MOST], high[D_MOST];

    kw_active_function(a, i, &level, j);
    support(a->mesh, level, j, low, high);
    memcpy(cell, low, (size_t)a->mesh->D * sizeof *cell);
    while (kw_mesh_refined(a->mesh, level, cell))
        kw_box_next(a->mesh->D, low, high, cell);
    return level;
}

/* --- Kraft's recursion: it asks the mesh alone, and nothing above --- */

/* A set of functions of any levels. */
typedef struct member {
    int level, j[D_MOST];
} member;

typedef struct members {
    member *list;
    long long count;
    size_t room;
} members;

static void add_member(members *H, member f)
{
    if ((size_t)H->count == H->room) {
        H->room = H->room > 0 ? 2 * H->room : 64;
        H->list = realloc(H->list, H->room * sizeof *H->list);
        KW_NEED(H->list, "memory for %zu functions", H->room);
    }
    H->list[H->count++] = f;
}

/* How many cells of a level begin before x. */
static int cells_before(const kw_mesh *m, int level, int h, double x)
{
    const kw_mesh_level *l = &m->level[level];
    int low = 0, high = l->cells[h];

    while (low < high) {
        int middle = low + (high - low) / 2;

        if (l->s[h]->t[l->span[h][middle]] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Does the support of f, from its first knot to its last, lie in Omega^level? A coarse knot is a
   fine one too, so the support is a union of cells of every finer level. */
static int lies_in(const kw_mesh *m, const member *f, int level)
{
    int low[D_MOST] = {0}, high[D_MOST] = {0}, cell[D_MOST];

    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[f->level].s[h];

        low[h] = cells_before(m, level, h, s->t[f->j[h]]);
        high[h] = cells_before(m, level, h, s->t[f->j[h] + s->d + 1]);
    }
    memcpy(cell, low, sizeof cell);
    do
        if (!kw_mesh_inside(m, level, cell))
            return 0;
    while (kw_box_next(m->D, low, high, cell));
    return 1;
}

/* Drops those with support in Omega^level, of whatever level they are. */
static void drop_members(const kw_mesh *m, members *H, int level)
{
    long long kept = 0;

    for (long long i = 0; i < H->count; i++)
        if (!lies_in(m, &H->list[i], level))
            H->list[kept++] = H->list[i];
    H->count = kept;
}

/* Adds the functions of a level with support in Omega^level. Such a support begins with a cell
   of Omega^level, and its first knot lies behind the beginning of the cell before. */
static void add_members(const kw_mesh *m, members *H, int level)
{
    long long cells;
    uint64_t *list = kw_mesh_cells(m, level, &cells);

    for (long long i = 0; i < cells; i++) {
        int cell[D_MOST], low[D_MOST] = {0}, high[D_MOST] = {0};
        member f = {.level = level};

        kw_mesh_multi(m, level, list[i], cell);
        for (int h = 0; h < m->D; h++) {
            const int *span = m->level[level].span[h];

            f.j[h] = low[h] = cell[h] > 0 ? span[cell[h] - 1] + 1 : 0;
            high[h] = span[cell[h]] + 1;
        }
        do
            if (lies_in(m, &f, level))
                add_member(H, f);
        while (kw_box_next(m->D, low, high, f.j));
    }
    free(list);
}

long long kw_active_kraft(const kw_mesh *m)
{
    members H = {NULL, 0, 0};

    add_members(m, &H, 0);
    for (int level = 1; level < m->levels; level++) {
        drop_members(m, &H, level);
        add_members(m, &H, level);
    }
    free(H.list);
    return H.count;
}
