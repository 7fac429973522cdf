#include "hier.h"
#include "need.h"
#include "twoscale.h"
#include <stdlib.h>
#include <string.h>

enum { K = KW_BSPLINE_DEGREE + 1, D_MOST = KW_TENSOR_D };

/* --- the tree of cells ---

   On the way down from a cell of level 0 a table is carried along: the THB-splines met so far
   that are not zero on the cell, as combinations of its local functions. */

typedef struct table {
    int count, room;
    int *index;  /* function of each row */
    double *row; /* count x local */
} table;

/* Appends a row and returns it; its numbers are not set. */
static double *new_row(table *t, int local, int index)
{
    if (t->count == t->room) {
        t->room = t->room > 0 ? 2 * t->room : 32;
        t->index = realloc(t->index, (size_t)t->room * sizeof *t->index);
        t->row = realloc(t->row, (size_t)t->room * (size_t)local * sizeof *t->row);
        KW_NEED(t->index && t->row, "memory for %d rows", t->room);
    }
    t->index[t->count] = index;
    return t->row + (size_t)t->count++ * (size_t)local;
}

/* Appends the active functions of a cell's level, each one of its local functions; returns
   how many there are. */
static int add_active(table *t, int local, const int *is)
{
    int added = 0;

    for (int f = 0; f < local; f++)
        if (is[f] >= KW_ACTIVE_FIRST) {
            double *row = new_row(t, local, is[f] - KW_ACTIVE_FIRST);

            memset(row, 0, (size_t)local * sizeof *row);
            row[f] = 1;
            added++;
        }
    return added;
}

/* Sets what Definition 5 cuts off to zero; returns whether anything is left. */
static int truncate_row(int local, const int *is, double *row)
{
    int left = 0;

    for (int f = 0; f < local; f++) {
        if (is[f] >= KW_ACTIVE_COVERED)
            row[f] = 0;
        left = left || row[f] != 0;
    }
    return left;
}

/* The rows of a cell's table on one of its children, truncated there; those of which nothing
   is left are dropped. [source text, (15), (16)] */
static void carry_rows(const table *from, int local, const kw_twoscale *s, const int *is,
                       table *to)
{
    double work[KW_ACTIVE_LOCAL];

    to->count = 0;
    for (int i = 0; i < from->count; i++) {
        double *row = new_row(to, local, from->index[i]);

        memcpy(row, from->row + (size_t)i * (size_t)local, (size_t)local * sizeof *row);
        kw_twoscale_apply(s, local, row, work);
        if (!truncate_row(local, is, row))
            to->count--;
    }
}

static void add_leaf(kw_hier *b, int level, const int *cell, const table *t, size_t at)
{
    const kw_mesh *m = b->active->mesh;
    size_t local = (size_t)b->active->local;
    kw_hier_leaf *l;

    if (b->leaves == b->leaf_room) {
        b->leaf_room = b->leaf_room + b->leaf_room / 2 + 64;
        b->leaf = realloc(b->leaf, b->leaf_room * sizeof *b->leaf);
        KW_NEED(b->leaf, "memory for %zu cells", b->leaf_room);
    }
    while (b->rows + (size_t)t->count > b->row_room) {
        b->row_room = b->row_room + b->row_room / 2 + 64;
        b->index = realloc(b->index, b->row_room * sizeof *b->index);
        b->row = realloc(b->row, b->row_room * local * sizeof *b->row);
        KW_NEED(b->index && b->row, "memory for %zu rows", b->row_room);
    }
    b->tree[at] = -1 - (int)b->leaves;
    l = &b->leaf[b->leaves++];
    l->level = level;
    for (int h = 0; h < m->D; h++)
        l->span[h] = m->level[level].span[h][cell[h]];
    l->first = b->rows;
    l->count = t->count;
    KW_NEED(t->count > 0, "no function on a cell of level %d", level);
    memcpy(b->index + b->rows, t->index, (size_t)t->count * sizeof *b->index);
    memcpy(b->row + b->rows * local, t->row, (size_t)t->count * local * sizeof *b->row);
    b->rows += (size_t)t->count;
}

/* Room for `count` more cells in the tree; returns the place of the first. */
static size_t add_cells(kw_hier *b, size_t count)
{
    size_t first = b->cells;

    b->cells += count;
    KW_NEED(b->cells < INT32_MAX, "%zu cells", b->cells);
    if (b->cells > b->cell_room) {
        b->cell_room = b->cells + b->cells / 2;
        b->tree = realloc(b->tree, b->cell_room * sizeof *b->tree);
        KW_NEED(b->tree, "memory for %zu cells", b->cell_room);
    }
    return first;
}

/* Adds what lies below a cell to the tree. t[level] is the table of the cell; `before` counts
   the HB-splines on it. */
static void descend(kw_hier *b, int level, const int *cell, size_t at, table *t,
                    int before)
{
    const kw_mesh *m = b->active->mesh;
    int is[KW_ACTIVE_LOCAL], children = 1 << m->D, local = b->active->local;
    size_t first;
    kw_twoscale s;

    if (!kw_mesh_refined(m, level, cell)) {
        add_leaf(b, level, cell, &t[level], at);
        b->most = before > b->most ? before : b->most;
        return;
    }
    first = add_cells(b, (size_t)children);
    b->tree[at] = (int)first;
    for (int c = 0; c < children; c++) {
        int child[D_MOST] = {0}, added;

        for (int h = 0; h < m->D; h++)
            child[h] = 2 * cell[h] + (c >> h & 1);
        kw_twoscale_between(m, level, cell, child, &s);
        kw_active_of_cell(b->active, level + 1, child, is);
        carry_rows(&t[level], local, &s, is, &t[level + 1]);
        added = add_active(&t[level + 1], local, is);
        descend(b, level + 1, child, first + (size_t)c, t, before + added);
    }
}

/* Gives back what the arrays have in reserve. */
static void give_back(kw_hier *b)
{
    b->cell_room = b->cells;
    b->leaf_room = b->leaves;
    b->row_room = b->rows;
    b->tree = realloc(b->tree, b->cells * sizeof *b->tree);
    b->leaf = realloc(b->leaf, b->leaves * sizeof *b->leaf);
    b->index = realloc(b->index, b->rows * sizeof *b->index);
    b->row = realloc(b->row, b->rows * (size_t)b->active->local * sizeof *b->row);
    KW_NEED(b->tree && b->leaf && b->index && b->row, "memory for %zu rows", b->rows);
}

kw_hier *kw_hier_new(const kw_mesh *m)
{
    kw_hier *b = kw_need_memory(1, sizeof *b);
    table t[KW_MESH_LEVELS] = {{0, 0, NULL, NULL}};
    int is[KW_ACTIVE_LOCAL], cell[D_MOST];
    size_t cells = 1;

    b->active = kw_active_new(m);
    for (int h = 0; h < m->D; h++)
        cells *= (size_t)m->level[0].cells[h];
    add_cells(b, cells);
    for (size_t i = 0; i < cells; i++) {
        kw_mesh_multi(m, 0, i, cell);
        kw_active_of_cell(b->active, 0, cell, is);
        t[0].count = 0;
        descend(b, 0, cell, i, t, add_active(&t[0], b->active->local, is));
    }
    for (int l = 0; l < KW_MESH_LEVELS; l++) {
        free(t[l].index);
        free(t[l].row);
    }
    give_back(b);
    return b;
}

void kw_hier_free(kw_hier *b)
{
    if (!b)
        return;
    kw_active_free(b->active);
    free(b->tree);
    free(b->leaf);
    free(b->index);
    free(b->row);
    free(b);
}

static size_t map_bytes(const kw_map *m)
{
    return sizeof *m + m->room * (sizeof *m->key + sizeof *m->value);
}

size_t kw_hier_bytes(const kw_hier *b)
{
    const kw_mesh *m = b->active->mesh;
    size_t local = (size_t)b->active->local,
           bytes = sizeof *b + sizeof *b->active + sizeof *m;

    bytes += b->cell_room * sizeof *b->tree + b->leaf_room * sizeof *b->leaf;
    bytes += b->row_room * (sizeof *b->index + local * sizeof *b->row);
    bytes += (size_t)b->active->size * sizeof *b->active->flat;
    for (int l = 0; l < m->levels; l++) {
        const kw_mesh_level *level = &m->level[l];

        bytes +=
            sizeof *level + map_bytes(level->refined) + map_bytes(b->active->status[l]);
        bytes += (size_t)level->room * sizeof *level->list;
        for (int h = 0; h < m->D; h++)
            bytes += (size_t)level->s[h]->n * (sizeof(double) + sizeof(int)) +
                     (size_t)level->cells[h] * sizeof(int);
    }
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

/* The way down to x: the cell of level 0, and, from a cell on level `level` - 1, the half of
   each direction that holds x. */
static void first_cell(const kw_mesh *m, const double *x, int *cell)
{
    for (int h = 0; h < m->D; h++)
        cell[h] = m->level[0].edge[h][kw_bspline_span(m->level[0].s[h], x[h])];
}

static void next_cell(const kw_mesh *m, int level, const double *x, int *cell)
{
    const kw_mesh_level *l = &m->level[level];

    for (int h = 0; h < m->D; h++) {
        int left = 2 * cell[h];

        cell[h] = left + (x[h] >= l->s[h]->t[l->span[h][left] + 1]);
    }
}

static const kw_hier_leaf *find_leaf(const kw_hier *b, const double *x)
{
    const kw_mesh *m = b->active->mesh;
    int cell[D_MOST] = {0}, level = 0, at;

    first_cell(m, x, cell);
    at = b->tree[kw_mesh_flat(m, 0, cell)];
    while (at >= 0) {
        int child = 0;

        next_cell(m, ++level, x, cell);
        for (int h = 0; h < m->D; h++)
            child |= (cell[h] & 1) << h;
        at = b->tree[at + child];
    }
    return &b->leaf[-1 - at];
}

/* What is done with each function that may not be zero at a point. */
typedef void use_function(void *target, int index, double value);

static void for_thb(const kw_hier *b, const int *r, const double *x, use_function *use,
                    void *target)
{
    const kw_hier_leaf *l = find_leaf(b, x);
    int local = b->active->local;
    double value[KW_ACTIVE_LOCAL];

    local_values(b->active->mesh, l->level, l->span, r, x, value);
    for (int i = 0; i < l->count; i++) {
        const double *row = b->row + (l->first + (size_t)i) * (size_t)local;
        double sum = 0;

        for (int f = 0; f < local; f++) /* NOLINTNEXTLINE: local_values sets `local` */
            sum += row[f] * value[f];
        use(target, b->index[l->first + (size_t)i], sum);
    }
}

static void for_hb(const kw_hier *b, const int *r, const double *x, use_function *use,
                   void *target)
{
    const kw_mesh *m = b->active->mesh;
    double value[KW_ACTIVE_LOCAL];
    int is[KW_ACTIVE_LOCAL], cell[D_MOST] = {0}, span[D_MOST] = {0}, level = 0;

    first_cell(m, x, cell);
    for (;;) {
        for (int h = 0; h < m->D; h++)
            span[h] = m->level[level].span[h][cell[h]];
        local_values(m, level, span, r, x, value);
        kw_active_of_cell(b->active, level, cell, is);
        for (int f = 0; f < b->active->local; f++)
            if (is[f] >= KW_ACTIVE_FIRST) /* NOLINTNEXTLINE: as above */
                use(target, is[f] - KW_ACTIVE_FIRST, value[f]);
        if (!kw_mesh_refined(m, level, cell))
            return;
        next_cell(m, ++level, x, cell);
    }
}

static void for_kind(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
                     use_function *use, void *target)
{
    if (kind == KW_THB)
        for_thb(b, r, x, use, target);
    else
        for_hb(b, r, x, use, target);
}

typedef struct list {
    int count, *index;
    double *value;
} list;

static void append(void *target, int index, double value)
{
    list *l = target;

    l->index[l->count] = index;
    l->value[l->count++] = value;
}

int kw_hier_at(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
               int *index, double *value)
{
    list l = {0, index, value};

    for_kind(b, kind, r, x, append, &l);
    return l.count;
}

typedef struct sum {
    int N;
    const double *c;
    double *point;
} sum;

static void accumulate(void *target, int index, double value)
{
    const sum *s = target;

    for (int a = 0; a < s->N; a++)
        s->point[a] += value * s->c[(size_t)index * (size_t)s->N + (size_t)a];
}

void kw_hier_point(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                   const int *r, const double *x, double *point)
{
    sum s = {N, c, point};

    KW_NEED(N >= 1, "N = %d", N);
    for (int a = 0; a < N; a++)
        point[a] = 0;
    for_kind(b, kind, r, x, accumulate, &s);
}

void kw_hier_point_many(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                        const int *r, int count, const double *x, double *point)
{
    for (int i = 0; i < count; i++)
        kw_hier_point(b, kind, N, c, r, x + (size_t)i * (size_t)b->active->mesh->D,
                      point + (size_t)i * (size_t)N);
}

typedef struct one {
    int index;
    double value;
} one;

static void pick(void *target, int index, double value)
{
    one *o = target;

    if (index == o->index)
        o->value = value;
}

double kw_hier_one(const kw_hier *b, kw_hier_kind kind, int i, const int *r,
                   const double *x)
{
    one o = {i, 0};

    KW_NEED(0 <= i && i < b->active->size, "function %d, not in 0 .. %d", i,
            b->active->size - 1);
    for_kind(b, kind, r, x, pick, &o);
    return o.value;
}
