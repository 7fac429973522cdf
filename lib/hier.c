#include "hier.h"
#include "cellbasis.h"
#include "need.h"
#include "truncation.h"
#include <stdlib.h>
#include <string.h>

enum { D_MOST = KW_TENSOR_D };

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

/* --- what is kept of a cell --- */

static void append(kw_hier *b, int place, int is)
{
    b->function[b->functions++] =
        (kw_hier_function){place, is >= KW_ACTIVE_FIRST ? is - KW_ACTIVE_FIRST : -1};
}

/* Remembers which active functions are local to the cell of a node, and the others too if it
   carries some. */
static void remember_own(kw_hier *b, int node, const int *is, int carries)
{
    const int local = b->active->local;
    kw_hier_own *own = &b->own[node];

    b->function = grown(b->function, &b->function_room, b->functions + (size_t)local,
                        sizeof *b->function);
    own->first = b->functions;
    for (int f = 0; f < local; f++)
        if (is[f] >= KW_ACTIVE_FIRST)
            append(b, f, is[f]);
    own->count = (int)(b->functions - own->first);
    for (int f = 0; carries && f < local; f++)
        if (is[f] < KW_ACTIVE_FIRST)
            append(b, f, is[f]);
}

static void remember_leaf(kw_hier *b, int node, int level, const int *cell, const int *is,
                          const kw_truncation *t)
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
        if (is[f] == KW_ACTIVE_OUTSIDE) {
            memcpy(b->row + b->numbers, t->row + f * carried, carried * sizeof *b->row);
            b->numbers += carried;
        }
}

/* --- the way down --- */

/* What is known of the cells that lead down to the present one, one of each level. */
typedef struct way {
    kw_truncation *table;
    kw_twoscale halves; /* from the cell to its children */
    int is[KW_ACTIVE_LOCAL];
} way;

/* Fills the node of a cell and all below it; `child` is its number among its parent's
   children, `before` counts the HB-splines of coarser levels on it. w: the way down to its
   parent. */
static void descend(kw_hier *b, int node, int level, int child, const int *cell, way *w,
                    int before)
{
    const kw_mesh *m = b->active->mesh;
    const int first = b->tree->node[node].child;
    way *here = &w[level];

    kw_active_of_cell(b->active, level, cell, here->is);
    here->table->count = 0;
    if (level > 0)
        kw_truncation_refine(w[level - 1].table, &w[level - 1].halves, child, here->is,
                             here->table);
    remember_own(b, node, here->is, first < 0 && here->table->count > 0);
    before += b->own[node].count;
    if (first < 0) {
        remember_leaf(b, node, level, cell, here->is, here->table);
        b->most = before > b->most ? before : b->most;
        return;
    }
    kw_truncation_add(here->table, here->is);
    kw_twoscale_of_cell(m, level, cell, &here->halves);
    for (int c = 0; c < 1 << m->D; c++) {
        int at[D_MOST] = {0};

        for (int h = 0; h < m->D; h++)
            at[h] = 2 * cell[h] + (c >> h & 1);
        descend(b, first + c, level + 1, c, at, w, before);
    }
}

kw_hier *kw_hier_new(const kw_mesh *m)
{
    kw_hier *b = kw_need_memory(1, sizeof *b);
    way *w = kw_need_memory((size_t)m->levels, sizeof *w);
    long long cells;

    b->active = kw_active_new(m);
    b->tree = kw_celltree_new(b->active->mesh);
    b->leaf = kw_need_memory((size_t)b->tree->leaves, sizeof *b->leaf);
    b->own = kw_need_memory((size_t)b->tree->nodes, sizeof *b->own);
    for (int l = 0; l < m->levels; l++)
        w[l].table = kw_truncation_new(b->active->local);
    free(kw_mesh_cells(m, 0, &cells));
    for (int i = 0; i < (int)cells; i++) {
        int cell[D_MOST];

        kw_mesh_multi(m, 0, (uint64_t)i, cell);
        descend(b, i, 0, 0, cell, w, 0);
    }
    for (int l = 0; l < m->levels; l++)
        kw_truncation_free(w[l].table);
    free(w);
    b->index = cut(b->index, &b->index_room, b->indices, sizeof *b->index);
    b->row = cut(b->row, &b->row_room, b->numbers, sizeof *b->row);
    b->function = cut(b->function, &b->function_room, b->functions, sizeof *b->function);
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
    free(b->function);
    free(b);
}

static size_t map_bytes(const kw_map *m)
{
    return sizeof *m + m->room * (sizeof *m->key + sizeof *m->value);
}

static size_t space_bytes(const kw_bspline *s)
{
    return sizeof *s + (size_t)(s->n + s->d + 1) * sizeof *s->t +
           (size_t)(s->buckets + 1) * sizeof *s->before;
}

static size_t mesh_bytes(const kw_mesh *m)
{
    size_t bytes = sizeof *m + KW_MESH_LEVELS * sizeof *m->level;

    for (int l = 0; l < m->levels; l++) {
        const kw_mesh_level *level = &m->level[l];

        bytes += map_bytes(level->refined) + (size_t)level->room * sizeof *level->list;
        for (int h = 0; h < m->D; h++) {
            const kw_bspline *s = level->s[h];

            bytes += space_bytes(s) + (size_t)(s->n - s->d) * sizeof *level->span[h] +
                     (size_t)(s->n + s->d + 1) * sizeof *level->edge[h];
        }
    }
    return bytes;
}

size_t kw_hier_bytes(const kw_hier *b)
{
    const kw_active *a = b->active;
    size_t bytes = sizeof *b + sizeof *a + mesh_bytes(a->mesh);

    bytes += (size_t)a->size * sizeof *a->flat +
             (size_t)(a->mesh->levels + 1) * sizeof *a->start +
             (size_t)a->mesh->levels * sizeof *a->status;
    for (int l = 0; l < a->mesh->levels; l++)
        bytes += map_bytes(a->status[l]);
    bytes += sizeof *b->tree + (size_t)b->tree->room * sizeof *b->tree->node;
    bytes += (size_t)b->tree->leaves * sizeof *b->leaf;
    bytes += b->index_room * sizeof *b->index + b->row_room * sizeof *b->row;
    bytes += (size_t)b->tree->nodes * sizeof *b->own;
    bytes += b->function_room * sizeof *b->function;
    return bytes;
}

/* --- at a point --- */

void kw_hier_local(const kw_hier *b, int leaf, const int *r, const double *x,
                   double *value)
{
    const kw_hier_leaf *l;

    KW_NEED(0 <= leaf && leaf < b->tree->leaves, "cell %d, not in 0 .. %d", leaf,
            b->tree->leaves - 1);
    l = &b->leaf[leaf];
    kw_cellbasis_at(b->active->mesh, l->level, l->span, r, x, value);
}

/* The THB-splines at x in a cell, as kw_hier_at. */
static int thb_at(const kw_hier *b, int leaf, const int *r, const double *x,
                  int *restrict index, double *restrict value)
{
    const kw_hier_leaf *l = &b->leaf[leaf];
    const int carried = l->carried, own = b->own[l->node].count;
    const kw_hier_function *function = b->function + b->own[l->node].first;
    const double *row = b->row + l->row;
    double of_cell[KW_ACTIVE_LOCAL];

    kw_hier_local(b, leaf, r, x, of_cell);
    for (int i = 0; i < carried; i++) {
        index[i] = b->index[l->index + (size_t)i];
        value[i] = 0;
    }
    for (int f = own; carried > 0 && f < b->active->local; f++, row += carried)
        for (int i = 0; i < carried; i++)
            value[i] += of_cell[function[f].place] * row[i];
    for (int f = 0; f < own; f++) {
        index[carried + f] = function[f].index;
        value[carried + f] = of_cell[function[f].place];
    }
    return carried + own;
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
        const int own = b->own[node].count;
        const kw_hier_function *function = b->function + b->own[node].first;

        for (int h = 0; h < m->D; h++)
            span[h] = m->level[level].span[h][cell[h]];
        if (own > 0)
            kw_cellbasis_at(m, level, span, r, x, of_cell);
        for (int f = 0; f < own; f++) {
            index[count] = function[f].index;
            value[count++] = of_cell[function[f].place];
        }
        if (b->tree->node[node].child < 0)
            return count;
        node = kw_celltree_below(b->tree, node, x, cell);
    }
}

int kw_hier_at(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
               int *index, double *value)
{
    return kind == KW_THB ? thb_at(b, kw_celltree_leaf(b->tree, x), r, x, index, value)
                          : hb_at(b, r, x, index, value);
}

void kw_hier_at_many(const kw_hier *b, kw_hier_kind kind, const int *r, int count,
                     const double *x, int *found, int *index, double *value)
{
    const int D = b->active->mesh->D;

    KW_NEED(count >= 0, "%d points", count);
    if (kind == KW_THB)
        kw_celltree_leaf_many(b->tree, count, x, found);
    for (int i = 0; i < count; i++, x += D, index += b->most, value += b->most)
        found[i] = kind == KW_THB ? thb_at(b, found[i], r, x, index, value)
                                  : hb_at(b, r, x, index, value);
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
    const int leaf = kw_celltree_leaf(b->tree, x);
    const kw_hier_leaf *l = &b->leaf[leaf];
    const int own = b->own[l->node].count,
              column = column_of(i, l->carried, b->index + l->index);
    const kw_hier_function *function = b->function + b->own[l->node].first;
    const double *row = b->row + l->row;
    double of_cell[KW_ACTIVE_LOCAL], value = 0;

    kw_hier_local(b, leaf, r, x, of_cell);
    for (int f = 0; f < own; f++)
        if (function[f].index == i)
            return of_cell[function[f].place];
    for (int f = own; column >= 0 && f < b->active->local; f++, row += l->carried)
        value += of_cell[function[f].place] * row[column]; /* NOLINT: of_cell is set */
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
        double factor[KW_BSPLINE_DEGREE + 1];

        if (of_span < 0 || of_span > s->d)
            return 0;
        kw_bspline_derivative_on(s, span, x[h], r ? r[h] : 0, factor);
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
