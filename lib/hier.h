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
     c    coefficients, size x N, row-major: c_j^l stands at the index i of its function.
          [source text, (19), with the level that it leaves out]

   Every active cell keeps what a point in it needs: its THB-splines as combinations of its
   local functions. A point costs the way down to its cell and one product for each of them. */
#ifndef KW_HIER_H
#define KW_HIER_H

#include "active.h"

typedef enum kw_hier_kind { KW_HB, KW_THB } kw_hier_kind;

/* An active cell. */
typedef struct kw_hier_leaf {
    int level;
    int span[KW_TENSOR_D]; /* its knot spans */
    int count;             /* THB-splines that are not zero on it */
    size_t first;          /* where their rows begin */
} kw_hier_leaf;

typedef struct kw_hier {
    kw_active *active; /* functions and mesh; owned, as all that follows */
    int most;          /* HB-splines that are not zero on one cell, at most; there are
                          never more THB-splines */
    int *tree; /* cells: first those of level 0 in the order of flat indices; the entry
                          of a cell is the place of its 2^D children, which run fastest in
                          direction 0, or -1 - leaf */
    size_t cells, cell_room;
    kw_hier_leaf *leaf;
    size_t leaves, leaf_room;
    int *index;  /* of row r: a function */
    double *row; /* row r: its coefficients in the local functions of the cell */
    size_t rows, row_room;
} kw_hier;

/* Time and memory are linear in the number of cells and active functions. The caller frees.
   Never NULL. */
kw_hier *kw_hier_new(const kw_mesh *m);
void kw_hier_free(kw_hier *b);

/* The bytes that b and all it owns take, as asked of the system. */
size_t kw_hier_bytes(const kw_hier *b);

/* The functions that may be non-zero at x: index[0..count-1] ascending, value[0..count-1];
   returns count, at most b->most. A value may be zero, on the edge of a support. */
int kw_hier_at(const kw_hier *b, kw_hier_kind kind, const int *r, const double *x,
               int *index, double *value);

/* Function i at x. */
double kw_hier_one(const kw_hier *b, kw_hier_kind kind, int i, const int *r,
                   const double *x);

/* The geometry sum over i of c_i times function i at x: point[0..N-1]. */
void kw_hier_point(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                   const int *r, const double *x, double *point);

/* The same at many points: x is count x D, point is count x N. Nothing is allocated. */
void kw_hier_point_many(const kw_hier *b, kw_hier_kind kind, int N, const double *c,
                        const int *r, int count, const double *x, double *point);

#endif
