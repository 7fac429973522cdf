#include "hier.h"
#include "need.h"
#include "twoscale.h"
#include <stdlib.h>
#include <string.h>

enum { K = KW_BSPLINE_DEGREE + 1, D_MOST = KW_TENSOR_D };

/* Makes room for `need` objects of `size` bytes in a growing array, which is not NULL then. */
static void *grown(void *array, size_t *room, size_t need, size_t size)
{
    if (array && need <= *room)
        return array;
    *room = need + need / 2 + 64;
    array = realloc(array, *room * size);
    KW_NEED(array, "memory for %zu objects of %zu bytes", *room, size);
    return array;
}

/* Gives back what an array has in reserve. */
static void *cut(void *array, size_t *room, size_t used, size_t size)
{
    *room = used;
    array = realloc(array, (used > 0 ? used : 1) * size);
    KW_NEED(array, "memory for %zu objects of %zu bytes", used, size);
    return array;
}

/* --- the THB-splines of every cell ---

   On the way down from a cell of level 0 a table is carried along: the THB-splines met so far
   that are not zero on the cell, as combinations of its local functions. */

typedef struct table {
    int count;
    int *index;  /* count: the functions */
    double *row; /* local x count: their coefficients */
    double *work;
    size_t index_room, row_room, work_room;
    kw_twoscale halves;      /* from the cell of this level to its children */
    int is[KW_ACTIVE_LOCAL]; /* what the local functions of the cell are */
} table;

/* Steps from the table of a cell to that of a child, as it is before truncation. */
static void refine_table(const table *from, int child, int local, table *to)
{
    size_t numbers = (size_t)local * (size_t)from->count;

    to->count = from->count;
    to->index = grown(to->index, &to->index_room, (size_t)from->count, sizeof *to->index);
    to->row = grown(to->row, &to->row_room, numbers, sizeof *to->row);
    to->work = grown(to->work, &to->work_room, numbers, sizeof *to->work);
    memcpy(to->index, from->index, (size_t)from->count * sizeof *to->index);
    memcpy(to->row, from->row, numbers * sizeof *to->row);
    kw_twoscale_apply(&from->halves, child, (int)numbers, to->row, to->work);
}

/* Is every local function of the cell one that Definition 5 cuts off from coarser ones? Then
   nothing is left of these, and nothing has to be computed. */
static int all_cut_off(const int *is, int local)
{
    for (int f = 0; f < local; f++)
        if (is[f] < KW_ACTIVE_COVERED)
            return 0;
    return 1;
}

/* Sets what Definition 5 cuts off to zero. [source text, (15), (16)] */
static void truncate_table(table *t, int local)
{
    for (int f = 0; f < local; f++)
        if (t->is[f] >= KW_ACTIVE_COVERED)
            memset(t->row + (size_t)f * (size_t)t->count, 0,
                   (size_t)t->count * sizeof *t->row);
}

static int is_zero(const table *t, int local, int i)
{
    for (int f = 0; f < local; f++)
        if (t->row[(size_t)f * (size_t)t->count + (size_t)i] != 0)
            return 0;
    return 1;
}

/* Drops the functions of which nothing is left. */
static void drop_zeros(table *t, int local)
{
    int kept = 0;

    for (int i = 0; i < t->count; i++) {
        if (is_zero(t, local, i))
            continue;
        t->index[kept] = t->index[i];
        for (int f = 0; kept < i && f < local; f++)
            t->row[(size_t)f * (size_t)t->count + (size_t)kept] =
                t->row[(size_t)f * (size_t)t->count + (size_t)i];
        kept++;
    }
    for (int f = 1; kept < t->count && f < local; f++)
        memmove(t->row + (size_t)f * (size_t)kept, t->row + (size_t)f * (size_t)t->count,
                (size_t)kept * sizeof *t->row);
    t->count = kept;
}

/* Appends the active functions of the cell's level, each one of its local functions. */
static void add_active(table *t, int local)
{
    int before = t->count, added = 0;
    size_t numbers;
    double *wider;

    for (int f = 0; f < local; f++)
        added += t->is[f] >= KW_ACTIVE_FIRST;
    if (added == 0)
        return;
    t->count += added;
    numbers = (size_t)local * (size_t)t->count;
    t->row = grown(t->row, &t->row_room, numbers, sizeof *t->row);
    t->index = grown(t->index, &t->index_room, (size_t)t->count, sizeof *t->index);
    t->work = grown(t->work, &t->work_room, numbers, sizeof *t->work);
    wider = t->work;
    memset(wider, 0, numbers * sizeof *wider);
    added = before;
    for (int f = 0; f < local; f++, wider += t->count) {
        memcpy(wider, t->row + (size_t)f * (size_t)before,
               (size_t)before * sizeof *wider);
        if (t->is[f] >= KW_ACTIVE_FIRST) {
            t->index[added] = t->is[f] - KW_ACTIVE_FIRST;
            wider[added++] = 1;
        }
    }
    memcpy(t->row, t->work, numbers * sizeof *t->row);
}

/* Remembers which active functions are local to the cell of a node; returns how many. */
static int remember_own(kw_hier *b, int node, const int *is)
{
    kw_hier_own *own = &b->own[node];
    size_t most = b->owns + (size_t)b->active->local;

    b->own_index = grown(b->own_index, &b->own_index_room, most, sizeof *b->own_index);
    b->own_place = grown(b->own_place, &b->own_place_room, most, sizeof *b->own_place);
    own->first = b->owns;
    for (int f = 0; f < b->active->local; f++)
        if (is[f] >= KW_ACTIVE_FIRST) {
            b->own_index[b->owns] = is[f] - KW_ACTIVE_FIRST;
            b->own_place[b->owns++] = (unsigned short)f;
            own->count++;
        }
    return own->count;
}

static void remember_leaf(kw_hier *b, int node, int level, const int *cell,
                          const table *t)
{
    const kw_mesh *m = b->active->mesh;
    size_t carried = (size_t)t->count, numbers = b->numbers,
           local = (size_t)b->active->local;
    kw_hier_leaf *l = &b->leaf[-1 - b->tree->node[node].child];

    KW_NEED(t->count + b->own[node].count > 0, "no function on a cell of level %d",
            level);
    l->level = level;
    l->node = node;
    for (int h = 0; h < m->D; h++)
        l->span[h] = m->level[level].span[h][cell[h]];
    l->carried = t->count;
    l->index = b->indices;
    l->row = b->numbers;
    if (carried == 0)
        return;
    b->index = grown(b->index, &b->index_room, b->indices + carried, sizeof *b->index);
    b->row = grown(b->row, &b->row_room, numbers + local * carried, sizeof *b->row);
    memcpy(b->index + b->indices, t->index, carried * sizeof *b->index);
    b->indices += carried;
    for (size_t f = 0; f < local; f++)
        if (t->is[f] == KW_ACTIVE_OUTSIDE) {
            memcpy(b->row + b->numbers, t->row + f * carried, carried * sizeof *b->row);
            b->numbers += carried;
        }
}

/* The THB-splines of coarser levels on a cell, from the table of its parent if it has one. */
static void fill_table(const table *parent, int child, int local, table *t)
{
    t->count = 0;
    if (parent && parent->count > 0 && !all_cut_off(t->is, local)) {
        refine_table(parent, child, local, t);
        truncate_table(t, local);
        drop_zeros(t, local);
    }
}

/* Fills the node of a cell and all below it; `child` is its number among its parent's children,
   `before` counts the HB-splines of coarser levels on it. t: a table for each level. */
static void descend(kw_hier *b, int node, int level, int child, const int *cell, table *t,
                    int before)
{
    const kw_mesh *m = b->active->mesh;
    int local = b->active->local, first = b->tree->node[node].child;

    kw_active_of_cell(b->active, level, cell, t[level].is);
    before += remember_own(b, node, t[level].is);
    fill_table(level > 0 ? &t[level - 1] : NULL, child, local, &t[level]);
    if (first < 0) {
        remember_leaf(b, node, level, cell, &t[level]);
        b->most = before > b->most ? before : b->most;
        return;
    }
    add_active(&t[level], local);
    kw_twoscale_of_cell(m, level, cell, &t[level].halves);
    for (int c = 0; c < 1 << m->D; c++) {
        int at[D_MOST] = {0};

        for (int h = 0; h < m->D; h++)
            at[h] = 2 * cell[h] + (c >> h & 1);
        descend(b, first + c, level + 1, c, at, t, before);
    }
}

kw_hier *kw_hier_new(const kw_mesh *m)
{
    kw_hier *b = kw_need_memory(1, sizeof *b);
    table *t = kw_need_memory((size_t)m->levels, sizeof *t);
    long long cells;

    b->active = kw_active_new(m);
    b->tree = kw_celltree_new(b->active->mesh);
    b->leaf = kw_need_memory((size_t)b->tree->leaves, sizeof *b->leaf);
    b->own = kw_need_memory((size_t)b->tree->nodes, sizeof *b->own);
    free(kw_mesh_cells(m, 0, &cells));
    for (int i = 0; i < (int)cells; i++) {
        int cell[D_MOST];

        kw_mesh_multi(m, 0, (uint64_t)i, cell);
        descend(b, i, 0, 0, cell, t, 0);
    }
    for (int l = 0; l < m->levels; l++) {
        free(t[l].index);
        free(t[l].row);
        free(t[l].work);
    }
    free(t);
    b->index = cut(b->index, &b->index_room, b->indices, sizeof *b->index);
    b->row = cut(b->row, &b->row_room, b->numbers, sizeof *b->row);
    b->own_index = cut(b->own_index, &b->own_index_room, b->owns, sizeof *b->own_index);
    b->own_place = cut(b->own_place, &b->own_place_room, b->owns, sizeof *b->own_place);
    return b;
}

void kw_hier_free(kw_hier *b)
{
    if (!b)
        return;
    kw_celltree_free(b->tree);
    kw_active_free(b->active);
    free(b->leaf);
    free(b->index);
    free(b->row);
    free(b->own);
    free(b->own_index);
    free(b->own_place);
    free(b);
}

static size_t map_bytes(const kw_map *m)
{
    return sizeof *m + m->room * (sizeof *m->key + sizeof *m->value);
}

static size_t mesh_bytes(const kw_mesh *m)
{
    size_t bytes = sizeof *m;

    for (int l = 0; l < m->levels; l++) {
        const kw_mesh_level *level = &m->level[l];

        bytes += sizeof *level + map_bytes(level->refined) +
                 (size_t)level->room * sizeof *level->list;
        for (int h = 0; h < m->D; h++)
            bytes += (size_t)level->s[h]->n * (sizeof(double) + sizeof(int)) +
                     (size_t)level->cells[h] * sizeof(int);
    }
    return bytes;
}

size_t kw_hier_bytes(const kw_hier *b)
{
    const kw_active *a = b->active;
    size_t bytes = sizeof *b + sizeof *a + mesh_bytes(a->mesh);

    bytes += (size_t)a->size * sizeof *a->flat;
    for (int l = 0; l < a->mesh->levels; l++)
        bytes += map_bytes(a->status[l]);
    bytes += sizeof *b->tree + (size_t)b->tree->room * sizeof *b->tree->node;
    bytes += (size_t)b->tree->leaves * sizeof *b->leaf;
    bytes += b->index_room * sizeof *b->index + b->row_room * sizeof *b->row;
    bytes += (size_t)b->tree->nodes * sizeof *b->own;
    bytes += b->own_index_room * sizeof *b->own_index +
             b->own_place_room * sizeof *b->own_place;
    return bytes;
}

/* --- at a point --- */

/* The r-th derivatives of the local functions of a span: value[0..d]. */
static void univariate(const kw_bspline *s, int span, int r, double x, double *value)
{
    double all[K * K];
    int k = s->d + 1;

    KW_NEED(r >= 0, "derivative %d", r);
    kw_bspline_derivatives_on(s, span, x, r < k ? r : 0, all);
    for (int i = 0; i < k; i++)
        value[i] = r < k ? all[r * k + i] : 0;
}

/* The derivatives of the local functions of a cell, given by its spans: value[0..local-1]. */
static void local_values(const kw_mesh *m, int level, const int *span, const int *r,
                         const double *x, double *value)
{
    double factor[K];
    int size = 1; /* products so far; the same loop as in kw_tensor_basis */

    value[0] = 1;
    for (int h = 0; h < m->D; h++) {
        int k = m->level[level].s[h]->d + 1;

        univariate(m->level[level].s[h], span[h], r ? r[h] : 0, x[h], factor);
        for (int a = size - 1; a >= 0; a--)
            for (int i = k - 1; i >= 0; i--) /* NOLINTNEXTLINE: both are set */
                value[a * k + i] = value[a] * factor[i];
        size *= k;
    }
}

void kw_hier_local(const kw_hier *b, int leaf, const int *r, const double *x,
                   double *value)
{
    const kw_hier_leaf *l = &b->leaf[leaf];

    KW_NEED(0 <= leaf && leaf < b->tree->leaves, "cell %d, not in 0 .. %d", leaf,
            b->tree->leaves - 1);
    local_values(b->active->mesh, l->level, l->span, r, x, value);
}

/* The THB-splines at x, as kw_hier_at. */
static int thb_at(const kw_hier *b, const int *r, const double *x, int *index,
                  double *restrict value)
{
    int leaf = kw_celltree_leaf(b->tree, x), own = 0;
    const kw_hier_leaf *l = &b->leaf[leaf];
    const kw_hier_own *owns = &b->own[l->node];
    const double *row = b->row + l->row;
    double of_cell[KW_ACTIVE_LOCAL];

    kw_hier_local(b, leaf, r, x, of_cell);
    memcpy(index, b->index + l->index, (size_t)l->carried * sizeof *index);
    memcpy(index + l->carried, b->own_index + owns->first,
           (size_t)owns->count * sizeof *index);
    memset(value, 0, (size_t)l->carried * sizeof *value);
    for (int f = 0; f < b->active->local; f++) {
        if (own < owns->count && b->own_place[owns->first + (size_t)own] == f) {
            value[l->carried + own++] = of_cell[f];
            continue;
        }
        for (int i = 0; i < l->carried; i++) /* NOLINTNEXTLINE: all of of_cell is set */
            value[i] += of_cell[f] * row[i];
        row += l->carried;
    }
    return l->carried + owns->count;
}

/* The HB-splines at x, as kw_hier_at: those of every level on the way down. */
static int hb_at(const kw_hier *b, const int *r, const double *x, int *index,
                 double *value)
{
    const kw_mesh *m = b->active->mesh;
    int cell[D_MOST] = {0}, span[D_MOST] = {0}, count = 0;
    int node = kw_celltree_root(b->tree, x, cell);
    double of_cell[KW_ACTIVE_LOCAL];

    for (int level = 0;; level++) {
        const kw_hier_own *own = &b->own[node];

        for (int h = 0; h < m->D; h++)
            span[h] = m->level[level].span[h][cell[h]];
        if (own->count > 0)
            local_values(m, level, span, r, x, of_cell);
        for (int i = 0; i < own->count; i++) {
            index[count] = b->own_index[own->first + (size_t)i];
            value[count++] = of_cell[b->own_place[own->first + (size_t)i]];
        }
        if (b->tree->node[node].child < 0)
            return count;
        node = kw_celltree_below(b->tree, node, x, cell);
    }
}

int kw_hier_at(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
               int *index, double *value)
{
    return kind == KW_THB ? thb_at(b, r, x, index, value) : hb_at(b, r, x, index, value);
}

/* Where an index stands among `count` ascending ones, or -1. */
static int column_of(int i, int count, const int *index)
{
    int low = 0, high = count;

    while (low < high) {
        int middle = (low + high) / 2;

        if (index[middle] < i)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && index[low] == i ? low : -1;
}

static double thb_one(const kw_hier *b, int i, const int *r, const double *x)
{
    int leaf = kw_celltree_leaf(b->tree, x), column, own = 0;
    const kw_hier_leaf *l = &b->leaf[leaf];
    const kw_hier_own *owns = &b->own[l->node];
    const unsigned short *place = b->own_place + owns->first;
    const double *row = b->row + l->row;
    double of_cell[KW_ACTIVE_LOCAL], value = 0;

    kw_hier_local(b, leaf, r, x, of_cell);
    column = column_of(i, owns->count, b->own_index + owns->first);
    if (column >= 0)
        return of_cell[place[column]];
    column = column_of(i, l->carried, b->index + l->index);
    for (int f = 0; column >= 0 && f < b->active->local; f++) {
        if (own < owns->count && place[own] == f) {
            own++;
            continue;
        }
        value += of_cell[f] * row[column]; /* NOLINT: all of of_cell is set */
        row += l->carried;
    }
    return value;
}

static double hb_one(const kw_hier *b, int i, const int *r, const double *x)
{
    const kw_mesh *m = b->active->mesh;
    int cell[D_MOST] = {0}, j[D_MOST], level;
    int node = kw_celltree_root(b->tree, x, cell);
    double value = 1;

    kw_active_function(b->active, i, &level, j);
    for (int l = 0; l < level; l++) {
        if (b->tree->node[node].child < 0)
            return 0; /* x is not in Omega^level */
        node = kw_celltree_below(b->tree, node, x, cell);
    }
    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[level].s[h];
        int span = m->level[level].span[h][cell[h]], of_span = j[h] - (span - s->d);
        double factor[K];

        if (of_span < 0 || of_span > s->d)
            return 0;
        univariate(s, span, r ? r[h] : 0, x[h], factor);
        value *= factor[of_span];
    }
    return value;
}

double kw_hier_one(const kw_hier *b, kw_hier_kind kind, int i, const int *r,
                   const double *x)
{
    KW_NEED(0 <= i && i < b->active->size, "function %d, not in 0 .. %d", i,
            b->active->size - 1);
    return kind == KW_THB ? thb_one(b, i, r, x) : hb_one(b, i, r, x);
}
