/* hier.h -- hierarchical B-splines: the HB and the THB basis of a mesh.

   Levels, cells and domains are those of mesh.h, functions and their indices i those of
   active.h.
     HB   the active beta_j^l themselves. [source text, Definition 4]
     THB  tau_j^l: beta_j^l written in B-splines of level l+1 without those whose support lies
          in Omega^{l+1}, what is left written on level l+2, and so on. [source text,
          Definition 5; Giannelli, Juettler, Speleers: THB-splines, CAGD 29 (2012)]
   Both are bases of the same space. THB-splines add up to one.
     x    a point of the domain, x[0..D-1]; the domain is closed; at an inner edge of cells
          derivatives that jump are those from behind the edge, at the right end from within
     r    orders of derivatives, r[0..D-1] >= 0; NULL for the value

   Every active cell keeps what a point in it needs: its THB-splines as combinations of its
   local functions. A point costs the way down to its cell and, for each function there, one
   product with the local values; for HB-splines the local values on every level of the way
   that has active functions there. Geometries: hierpieces.h. */
#ifndef KW_HIER_H
#define KW_HIER_H

#include "active.h"
#include "celltree.h"

typedef enum kw_hier_kind { KW_HB, KW_THB } kw_hier_kind;

/* An active cell. THB-splines of coarser levels that are not zero on it, `carried` of them,
   have the indices b->index[index ..], ascending; b->row[row ..] are their coefficients in those
   local functions of the cell that are not active: (local - own.count) x carried. In the active
   ones they have none, these are THB-splines themselves (b->own[node]). */
typedef struct kw_hier_leaf {
    int level;
    int span[KW_TENSOR_D]; /* its knot spans */
    int node;              /* of the tree */
    int carried;
    size_t index, row;
} kw_hier_leaf;

/* A local function of a cell: its number there and, if it is active, its index, else -1. */
typedef struct kw_hier_function {
    int place, index;
} kw_hier_function;

/* The active functions among the local ones of a cell: b->function[first .. first+count-1],
   ascending. In a leaf that carries others, those that are not active follow, ascending. */
typedef struct kw_hier_own {
    int count;
    size_t first;
} kw_hier_own;

typedef struct kw_hier {
    kw_active *active; /* functions and mesh; owned, as all that follows */
    kw_celltree *tree;
    int most;           /* HB-splines that are not zero on one cell, at most; there are
                           never more THB-splines */
    kw_hier_leaf *leaf; /* tree->leaves */
    int *index;         /* of all leaves together */
    double *row;        /* the same */
    size_t indices, index_room, numbers, row_room;
    kw_hier_own *own;           /* tree->nodes */
    kw_hier_function *function; /* of all nodes together */
    size_t functions, function_room;
} kw_hier;

/* Time and memory are linear in the number of cells and of the functions that overlap on each,
   which on graded meshes are few in the mean; estimate.h says how much memory before. The caller frees. Never NULL. */
kw_hier *kw_hier_new(const kw_mesh *m);
void kw_hier_free(kw_hier *b);

/* The bytes that b and all it owns take, as asked of the system. */
size_t kw_hier_bytes(const kw_hier *b);

/* The functions that may be non-zero at x: index[0..count-1] ascending, value[0..count-1];
   returns count, at most b->most. A value may be zero, on the edge of a support. */
int kw_hier_at(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
               int *index, double *value);

/* The same at many points: x is count x D; found is count, index and value are count x
   b->most, of which point p has the first found[p] of row p. The same bits as one by one,
   THB-splines in less time; nothing is allocated. */
void kw_hier_at_many(const kw_hier *b, kw_hier_kind kind, const int *r, int count,
                     const double *x, int *found, int *index, double *value);

/* Function i at x. */
double kw_hier_one(const kw_hier *b, kw_hier_kind kind, int i, const int *r,
                   const double *x);

/* The local functions of an active cell at x in it: value, prod (d_h+1), in the order of
   kw_tensor_basis; 0 <= leaf < b->tree->leaves. */
void kw_hier_local(const kw_hier *b, int leaf, const int *r, const double *x,
                   double *value);

#endif
