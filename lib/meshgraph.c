#include "meshgraph.h"
#include "need.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* What is known while the graph is made. */
typedef struct builder {
    const kw_mesh *mesh;
    kw_meshgraph *g;
    kw_map *node[KW_MESH_LEVELS]; /* from the flat index of an active cell to its node */
    int *end, edges;              /* the edges so far, two ends each */
} builder;

static int count_active(const kw_mesh *m)
{
    long long count = 0;

    for (int level = 0; level < m->levels; level++)
        count += kw_mesh_active(m, level);
    /* each cell asks for at most 2 D edges */
    KW_NEED(count <= INT_MAX / (4 * KW_TENSOR_D), "%lld active cells", count);
    return (int)count;
}

static void number_cells(builder *b)
{
    const kw_mesh *m = b->mesh;
    int node = 0;

    for (int level = 0; level < m->levels; level++) {
        long long count;
        uint64_t *list = kw_mesh_cells(m, level, &count);

        b->node[level] = kw_map_new();
        for (long long i = 0; i < count; i++) {
            int *cell = b->g->cell + (size_t)node * (size_t)m->D, at[KW_TENSOR_D];

            kw_mesh_multi(m, level, list[i], at);
            if (kw_mesh_refined(m, level, at))
                continue;
            memcpy(cell, at, (size_t)m->D * sizeof *cell);
            b->g->level[node] = level;
            kw_map_put(b->node[level], list[i], node++);
        }
        free(list);
    }
}

/* The active cell that holds a cell of a level and has at most its level, or KW_MAP_NONE if
   finer ones tile it. */
static int holder(const builder *b, int level, const int *cell)
{
    int at[KW_TENSOR_D];

    memcpy(at, cell, (size_t)b->mesh->D * sizeof *at);
    while (!kw_mesh_inside(b->mesh, level, at)) {
        level--;
        for (int h = 0; h < b->mesh->D; h++)
            at[h] /= 2;
    }
    return kw_map_find(b->node[level], kw_mesh_flat(b->mesh, level, at));
}

/* Joins a node with what lies behind its side in direction h, step -1 or 1. A pair of cells is
   found from the finer one, and one of equal levels from the one before. */
static void join(builder *b, int node, int h, int step)
{
    int level = b->g->level[node], D = b->mesh->D, beside[KW_TENSOR_D], other;

    memcpy(beside, b->g->cell + (size_t)node * (size_t)D, (size_t)D * sizeof *beside);
    beside[h] += step;
    if (beside[h] < 0 || beside[h] == b->mesh->level[level].cells[h])
        return;
    other = holder(b, level, beside);
    if (other == KW_MAP_NONE || (b->g->level[other] == level && step < 0))
        return;
    b->end[2 * b->edges] = node;
    b->end[2 * b->edges++ + 1] = other;
}

kw_meshgraph *kw_meshgraph_new(const kw_mesh *m)
{
    kw_meshgraph *g = kw_need_memory(1, sizeof *g);
    builder b = {.mesh = m, .g = g};
    int n = count_active(m);

    g->D = m->D;
    g->level = kw_need_memory((size_t)n, sizeof *g->level);
    g->cell = kw_need_memory((size_t)n * (size_t)m->D, sizeof *g->cell);
    b.end = kw_need_memory((size_t)n * (size_t)(4 * m->D), sizeof *b.end);
    number_cells(&b);
    for (int node = 0; node < n; node++)
        for (int h = 0; h < m->D; h++) {
            join(&b, node, h, -1);
            join(&b, node, h, 1);
        }
    g->graph = kw_graph_new(n, b.edges, b.end, NULL);
    for (int level = 0; level < m->levels; level++)
        kw_map_free(b.node[level]);
    free(b.end);
    return g;
}

void kw_meshgraph_free(kw_meshgraph *g)
{
    if (!g)
        return;
    kw_graph_free(g->graph);
    free(g->level);
    free(g->cell);
    free(g);
}
