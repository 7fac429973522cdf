/* meshgraph.h -- the graph of a hierarchical mesh: active cells, joined where they share a
   side.

   Nodes are the active cells, level by level, on a level in the order of their flat indices
   (mesh.h). Two of them are joined, with weight 1, if they share a side or a part of one: a
   point for D = 1, a piece of an edge for D = 2, of a face for D = 3. Cells that meet in
   less, at a corner, are no neighbours. */
#ifndef KW_MESHGRAPH_H
#define KW_MESHGRAPH_H

#include "graph.h"
#include "mesh.h"

typedef struct kw_meshgraph {
    int D;
    kw_graph *graph; /* owned, as all that follows */
    int *level;      /* graph->n: the level of the cell */
    int *cell;       /* graph->n x D: the cell */
} kw_meshgraph;

/* The caller frees. Never NULL. */
kw_meshgraph *kw_meshgraph_new(const kw_mesh *m);
void kw_meshgraph_free(kw_meshgraph *g);

#endif
