#include "celltree.h"
#include "need.h"
#include <stdlib.h>
#include <string.h>

enum { D_MOST = KW_TENSOR_D };

/* Room for `count` more nodes; returns the first. */
static int add_nodes(kw_celltree *t, int count)
{
    int first = t->nodes;

    KW_NEED(count <= INT32_MAX / 2 - first, "more than %d cells", INT32_MAX / 2);
    t->nodes += count;
    if (t->nodes > t->room) {
        t->room = t->nodes + t->nodes / 2;
        t->node = realloc(t->node, (size_t)t->room * sizeof *t->node);
        KW_NEED(t->node, "memory for %d cells", t->room);
    }
    return first;
}

/* Sets the node of a cell and all below it. */
static void descend(kw_celltree *t, int node, int level, const int *cell)
{
    const kw_mesh *m = t->mesh;
    int first;

    if (!kw_mesh_refined(m, level, cell)) {
        t->node[node] = (kw_celltree_node){.child = -1 - t->leaves++};
        return;
    }
    first = add_nodes(t, 1 << m->D); /* may move t->node */
    t->node[node].child = first;
    for (int h = 0; h < m->D; h++) {
        const kw_mesh_level *fine = &m->level[level + 1];

        /* the second half begins at the knot behind the span of the first */
        t->node[node].middle[h] = fine->s[h]->t[fine->span[h][2 * cell[h]] + 1];
    }
    for (int c = 0; c < 1 << m->D; c++) {
        int child[D_MOST] = {0};

        for (int h = 0; h < m->D; h++)
            child[h] = 2 * cell[h] + (c >> h & 1);
        descend(t, first + c, level + 1, child);
    }
}

kw_celltree *kw_celltree_new(const kw_mesh *m)
{
    kw_celltree *t = kw_need_memory(1, sizeof *t);
    long long cells;

    free(kw_mesh_cells(m, 0, &cells));
    KW_NEED(cells < INT32_MAX / 2, "%lld cells of level 0", cells);
    t->mesh = m;
    add_nodes(t, (int)cells);
    for (int i = 0; i < (int)cells; i++) {
        int cell[D_MOST];

        kw_mesh_multi(m, 0, (uint64_t)i, cell);
        descend(t, i, 0, cell);
    }
    t->room = t->nodes;
    t->node = realloc(t->node, (size_t)t->room * sizeof *t->node);
    KW_NEED(t->node, "memory for %d cells", t->room);
    return t;
}

void kw_celltree_free(kw_celltree *t)
{
    if (!t)
        return;
    free(t->node);
    free(t);
}

int kw_celltree_root(const kw_celltree *t, const double *x, int *cell)
{
    const kw_mesh_level *l = &t->mesh->level[0];
    int flat = 0;

    for (int h = 0; h < t->mesh->D; h++) {
        cell[h] = l->edge[h][kw_bspline_span(l->s[h], x[h])];
        flat = flat * l->cells[h] + cell[h];
    }
    return flat;
}

int kw_celltree_below(const kw_celltree *t, int node, const double *x, int *cell)
{
    const kw_celltree_node *from = &t->node[node];
    int child = from->child;

    for (int h = 0; h < t->mesh->D; h++) {
        int second = x[h] >= from->middle[h];

        cell[h] = 2 * cell[h] + second;
        child += second << h;
    }
    return child;
}

/* Points that go down together: while one waits for its next node the others go on. */
enum { TOGETHER = 64 };

/* The nodes of the cells of level 0 of up to TOGETHER points, one direction after the other. */
static inline void find_roots(const kw_celltree *t, int D, int count, const double *x,
                              int *node)
{
    const kw_mesh_level *l = &t->mesh->level[0];

    memset(node, 0, (size_t)count * sizeof *node);
    for (int h = 0; h < D; h++) {
        double coordinate[TOGETHER];
        int span[TOGETHER];

        for (int p = 0; p < count; p++)
            coordinate[p] = x[p * D + h];
        kw_bspline_span_many(l->s[h], count, coordinate, span);
        for (int p = 0; p < count; p++)
            node[p] = node[p] * l->cells[h] + l->edge[h][span[p]];
    }
}

/* The leaves of up to TOGETHER points. In every round each point that is not in its leaf yet
   takes a step; a branch that depends on the point would be guessed wrong half of the time. */
static inline void search(const kw_celltree *t, int D, int count, const double *x,
                          int *restrict leaf)
{
    int at[TOGETHER], left[TOGETHER]; /* nodes; the points that still go down */

    find_roots(t, D, count, x, at);
    for (int p = 0; p < count; p++)
        left[p] = p;
    while (count > 0) {
        int still = 0;

        for (int i = 0; i < count; i++) {
            int p = left[i];
            const kw_celltree_node *from = &t->node[at[p]];
            int child = from->child, refined = child >= 0;

            leaf[p] = -1 - child;
            for (int h = 0; h < D; h++)
                child += (x[p * D + h] >= from->middle[h]) << h;
            at[p] = child;
            left[still] = p;
            still += refined;
        }
        count = still;
    }
}

void kw_celltree_leaf_many(const kw_celltree *t, int count, const double *x, int *leaf)
{
    const int D = t->mesh->D;

    KW_NEED(count >= 0, "%d points", count);
    for (int i = 0; i < count; i += TOGETHER) {
        int now = count - i < TOGETHER ? count - i : TOGETHER;

        if (D == 2)
            search(t, 2, now, x + (size_t)i * 2, leaf + i);
        else
            search(t, D, now, x + (size_t)i * (size_t)D, leaf + i);
    }
}

int kw_celltree_leaf(const kw_celltree *t, const double *x)
{
    int leaf;

    kw_celltree_leaf_many(t, 1, x, &leaf);
    return leaf;
}
