/* mesh.h -- hierarchical meshes: cells that are split where it matters.

   Conventions, stated here once:
     level     l = 0 .. levels-1. The space of level 0 is given; every span of level l is
               halved on level l+1, in every direction (dyadic refinement)
     cell      a box of non-empty spans of one level, cell[0..D-1], counted from 0 in each
               direction, 0 <= cell[h] < level[l].cells[h]
     flat      a multi-index of cells, or of functions, as one number: row-major, the last
               direction runs fastest
     Omega^l   the nested domains: Omega^0 is the whole box; Omega^{l+1} is the union of the
               refined cells of level l, which lie in Omega^l. So every domain is a union of
               cells of the level before (source text, section 1.1; with cells of the level
               itself the mesh may leave holes, ERRATA.md, ER-11)
     active    a cell of level l that lies in Omega^l and is not refined; the active cells
               tile the domain
   Degrees are the same on all levels: with dyadic knots of the same multiplicity, inner knots
   among them, spaces of different degree are not nested (source text, Remark 7).

   Memory follows the number of refined cells, and the number of knots of each direction. */
#ifndef KW_MESH_H
#define KW_MESH_H

#include "map.h"
#include "tensor.h"

enum { KW_MESH_LEVELS = 24 };

typedef struct kw_mesh_level {
    kw_bspline *s[KW_TENSOR_D]; /* the space of direction h; owned, as all that follows */
    int cells[KW_TENSOR_D];     /* its non-empty spans */
    int *span[KW_TENSOR_D];     /* span[h][c]: the span of cell c; cells[h] of them */
    int *edge[KW_TENSOR_D]; /* edge[h][i]: number of the breakpoint that knot i is, cut to
                                   0 .. cells[h]; function j lives on the cells edge[h][j] ..
                                   edge[h][j+d+1] - 1 */
    kw_map *refined; /* from the flat index of a refined cell to its place in list */
    uint64_t *list;  /* the flat indices of the refined cells */
    int count, room; /* refined cells, and places in list */
} kw_mesh_level;

typedef struct kw_mesh {
    int D;
    int levels;           /* Omega^{levels-1} is not empty */
    kw_mesh_level *level; /* KW_MESH_LEVELS, of which `levels` are in use */
} kw_mesh;

/* --- making a mesh --- */

/* The mesh of the cells of g, which is copied. The caller frees. Never NULL. */
kw_mesh *kw_mesh_new(const kw_tensor *g);
kw_mesh *kw_mesh_new_copy(const kw_mesh *m);
void kw_mesh_free(kw_mesh *m);

/* Refines the cells low[h] <= cell[h] < high[h] of a level, as far as they lie in Omega^level;
   a cell that is refined stays so. 0 <= level < m->levels < KW_MESH_LEVELS. Returns how many
   cells were refined now. */
int kw_mesh_refine(kw_mesh *m, int level, const int *low, const int *high);

/* --- asking --- */

uint64_t kw_mesh_flat(const kw_mesh *m, int level, const int *cell);
void kw_mesh_multi(const kw_mesh *m, int level, uint64_t flat, int *cell);

/* Does the cell lie in Omega^level? Is it refined? */
int kw_mesh_inside(const kw_mesh *m, int level, const int *cell);
int kw_mesh_refined(const kw_mesh *m, int level, const int *cell);

/* The active cell that holds x; returns its level. At an inner edge the cell behind it. */
int kw_mesh_locate(const kw_mesh *m, const double *x, int *cell);

/* All cells of level `level` that lie in Omega^level, in ascending order: their flat indices,
   *count of them; the caller frees. */
uint64_t *kw_mesh_cells(const kw_mesh *m, int level, long long *count);

/* How many active cells the level has. */
long long kw_mesh_active(const kw_mesh *m, int level);

/* The space of direction h in the smallest tensor product that has all knot lines of the
   mesh: the knots of level 0, and the finer ones that bound an active cell. The caller
   frees. */
kw_bspline *kw_mesh_new_direction(const kw_mesh *m, int h);

#endif
