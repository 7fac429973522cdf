/* active.h -- which functions of which level make up the hierarchical basis.

   A function beta_j^l of level l has the support of its D univariate factors, cut to the
   domain. On a mesh (mesh.h) it is
     outside   if its support does not lie in Omega^l
     covered   if it lies in Omega^{l+1}: finer functions take its place
     active    otherwise
   [source text, (14)]. The active functions are counted from 0: index i runs level by level,
   on a level in the order of the flat indices of the functions, the last direction fastest.

   The local functions of a cell of level l are those of level l that are non-zero on it, prod
   (d_h+1) of them, in the order of kw_tensor_basis.

   Time and memory of kw_active_new are linear in the number of cells of all domains. */
#ifndef KW_ACTIVE_H
#define KW_ACTIVE_H

#include "mesh.h"

/* What a function is, as one number: KW_ACTIVE_FIRST + i if it is active function i. */
enum { KW_ACTIVE_OUTSIDE = 0, KW_ACTIVE_COVERED = 1, KW_ACTIVE_FIRST = 2 };

/* The most local functions of a cell; it bounds arrays that evaluation keeps on the stack. */
enum { KW_ACTIVE_LOCAL = 4096 };

typedef struct kw_active {
    kw_mesh *mesh;   /* a copy; owned, as all that follows */
    int local;       /* local functions of a cell, at most KW_ACTIVE_LOCAL */
    int size;        /* active functions */
    int *start;      /* levels + 1: those of level l are start[l] .. start[l+1] - 1 */
    uint64_t *flat;  /* size: their flat indices */
    kw_map **status; /* levels: from the flat index of a function to what it is; functions
                        that are local to no cell of Omega^l are missing, and outside */
} kw_active;

/* The caller frees. Never NULL. */
kw_active *kw_active_new(const kw_mesh *m);
void kw_active_free(kw_active *a);

/* Level and multi-index j[0..D-1] of active function i. */
void kw_active_function(const kw_active *a, int i, int *level, int *j);

/* What beta_j^level is. */
int kw_active_status(const kw_active *a, int level, const int *j);

/* The index of beta_j^level, or -1 if it is not active. */
int kw_active_find(const kw_active *a, int level, const int *j);

/* What the local functions of a cell are: is[0..local-1]. */
void kw_active_of_cell(const kw_active *a, int level, const int *cell, int *is);

/* The box low[h] <= j[h] < high[h] of the local functions of a cell. */
void kw_active_box(const kw_mesh *m, int level, const int *cell, int *low, int *high);

/* An active cell of its own level in the support of active function i; there is one. Returns
   the level. */
int kw_active_cell(const kw_active *a, int i, int *cell);

/* The number of active functions found in another way, by Kraft's recursion: begin with all
   functions of level 0; then, domain by domain, drop those of any level with support in
   Omega^l and add the functions of level l with support there. Supports are taken from the
   knots and laid out in cells of level l. Nothing but the mesh is shared with kw_active_new.
   For tests and drivers: memory follows the functions, but each of them is looked at once a
   level, and a look may go through all cells of level l in its support. [Kraft: Adaptive and
   linearly independent multilevel B-splines, 1997] */
long long kw_active_kraft(const kw_mesh *m);

#endif
