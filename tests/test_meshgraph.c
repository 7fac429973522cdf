/* Graphs of meshes against the table of the finest cells (meshes.h): two active cells share a
   side if and only if two cells of the table do, one of each. */
#include "meshgraph.h"
#include "meshes.h"

enum { MESHES = 40 };

/* owner[c]: the node of table cell c. Checks that nodes tile the table and are in order. */
static int *new_owners(const twin *w, const kw_meshgraph *g)
{
    int *owner = room_for(w->total, sizeof *owner), filled = 0;

    for (int node = 0; node < g->graph->n; node++) {
        const int *cell = g->cell + (size_t)node * (size_t)w->D;
        int low[D_MOST], high[D_MOST], at[D_MOST], level = g->level[node];

        for (int h = 0; h < w->D; h++) {
            at[h] = low[h] = cell[h] << (w->finest - level);
            high[h] = (cell[h] + 1) << (w->finest - level);
        }
        do {
            CHECK(w->depth[twin_flat(w, at)] == level, "node %d, level %d", node, level);
            owner[twin_flat(w, at)] = node;
            filled++;
        } while (step(w->D, low, high, at));
        if (node > 0 && g->level[node - 1] == level)
            CHECK(kw_mesh_flat(w->mesh, level, cell - w->D) <
                      kw_mesh_flat(w->mesh, level, cell),
                  "nodes %d and %d", node - 1, node);
        else if (node > 0)
            CHECK(g->level[node - 1] < level, "nodes %d and %d", node - 1, node);
    }
    CHECK(filled == w->total, "%d of %d", filled, w->total);
    return owner;
}

/* joined[a*n + b]: does a table cell of node a share a side with one of node b? */
static char *new_joined(const twin *w, const int *owner, int n)
{
    char *joined = room_for(n * n, 1);
    const int zero[D_MOST] = {0};
    int at[D_MOST] = {0};

    do {
        int here = owner[twin_flat(w, at)];

        for (int h = 0; h < w->D; h++) {
            int beside[D_MOST], there;

            memcpy(beside, at, sizeof at);
            if (++beside[h] == w->cells[h])
                continue;
            there = owner[twin_flat(w, beside)];
            if (there != here)
                joined[here * n + there] = joined[there * n + here] = 1;
        }
    } while (step(w->D, zero, w->cells, at));
    return joined;
}

static void check_graph(const twin *w)
{
    kw_meshgraph *g = kw_meshgraph_new(w->mesh);
    int n = g->graph->n, *owner = new_owners(w, g);
    char *joined = new_joined(w, owner, n);

    CHECK(g->D == w->D, "%d", g->D);
    for (int i = 0; i < n; i++) {
        int e = g->graph->start[i];

        for (int j = 0; j < n; j++) {
            int there = e < g->graph->start[i + 1] && g->graph->to[e] == j;

            CHECK(there == joined[i * n + j], "cells %d and %d", i, j);
            CHECK(!there || g->graph->weight[e] == 1, "%g", g->graph->weight[e]);
            e += there;
        }
    }
    free(owner);
    free(joined);
    kw_meshgraph_free(g);
}

static void random_meshes(void)
{
    static const int most[] = {0, 6, 4, 2}, finest[] = {0, 4, 3, 2};

    for (int D = 1; D <= D_MOST; D++)
        for (uint64_t sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(431, (uint64_t)D, sample, 0);
            twin w = random_twin(&r, D, 3, most[D], finest[D]);

            check_graph(&w);
            twin_free(&w);
        }
}

/* 3 x 3 cells, the one in the middle split: it has 8 + 4 cells, and each of its four
   neighbours meets two small ones. */
static void a_split_cell(void)
{
    twin w = twin_new(meshes_uniform(2, 1, 3), 1);
    kw_meshgraph *g;

    refine_cube(&w, 0, 1, 2);
    check_graph(&w);
    g = kw_meshgraph_new(w.mesh);
    CHECK(g->graph->n == 12, "%d cells", g->graph->n);
    /* 8 sides around the ring of large cells, 4 among the small ones, 8 between */
    CHECK(g->graph->start[12] == 2 * 20, "%d sides, twice", g->graph->start[12]);
    kw_meshgraph_free(g);
    twin_free(&w);
}

static void one_cell_has_no_neighbour(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        twin w = twin_new(meshes_uniform(D, 1, 1), 1);
        kw_meshgraph *g = kw_meshgraph_new(w.mesh);

        CHECK(g->graph->n == 1 && g->graph->start[1] == 0, "%d", g->graph->n);
        kw_meshgraph_free(g);
        twin_free(&w);
    }
    kw_meshgraph_free(NULL);
}

int main(void)
{
    test_run("meshgraph: random meshes, cell by cell of the finest grid", random_meshes);
    test_run("meshgraph: a split cell among eight", a_split_cell);
    test_run("meshgraph: one cell has no neighbour", one_cell_has_no_neighbour);
    return test_end();
}
