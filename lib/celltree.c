#include "celltree.h"
#include "need.h"
#include <stdlib.h>

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
        t->node[node].child = -1 - t->leaves++;
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
    const kw_mesh *m = t->mesh;

    for (int h = 0; h < m->D; h++)
        cell[h] = m->level[0].edge[h][kw_bspline_span(m->level[0].s[h], x[h])];
    return (int)kw_mesh_flat(m, 0, cell);
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

int kw_celltree_leaf(const kw_celltree *t, const double *x)
{
    int cell[D_MOST], node = kw_celltree_root(t, x, cell);

    while (t->node[node].child >= 0)
        node = kw_celltree_below(t, node, x, cell);
    return -1 - t->node[node].child;
}
