/* celltree.h -- the tree of all cells of a hierarchical mesh, to find the cell of a point.

   Its nodes are the cells of level 0, in the order of their flat indices, and below each
   refined cell its 2^D halves. The leaves are the active cells, counted from 0 in the order of
   a walk through the tree. A search begins in the knots of level 0, and then touches one small
   node a level and no more knots. */
#ifndef KW_CELLTREE_H
#define KW_CELLTREE_H

#include "mesh.h"

typedef struct kw_celltree_node {
    double middle[KW_TENSOR_D]; /* of a refined cell: where its second halves begin */
    int child; /* its first child; of the children, bit h of their number says that they are
                  second halves in direction h. Of an active cell: -1 - leaf */
} kw_celltree_node;

typedef struct kw_celltree {
    const kw_mesh *mesh; /* not owned */
    kw_celltree_node *node;
    int nodes, room;
    int leaves;
} kw_celltree;

/* Time and memory are linear in the number of cells. The mesh must stay as it is while the tree
   is in use. The caller frees. Never NULL. */
kw_celltree *kw_celltree_new(const kw_mesh *m);
void kw_celltree_free(kw_celltree *t);

/* The node of the cell of level 0 that holds x, a point of the domain, and that cell. */
int kw_celltree_root(const kw_celltree *t, const double *x, int *cell);

/* From the node of a refined cell that holds x, and the cell, to the child that does. */
int kw_celltree_below(const kw_celltree *t, int node, const double *x, int *cell);

/* The leaf of the active cell that holds x: at an inner edge that of the cell behind it. */
int kw_celltree_leaf(const kw_celltree *t, const double *x);

/* The same of many points: x is count x D, leaf is count. */
void kw_celltree_leaf_many(const kw_celltree *t, int count, const double *x, int *leaf);

#endif
