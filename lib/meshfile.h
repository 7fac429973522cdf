/* meshfile.h -- hierarchical meshes as text.

       degree 2 2
       knots 0 0 0 0.25 0.5 0.75 1 1 1     one line a direction, the extended knots of level 0
       knots 0 0 0 0.25 0.5 0.75 1 1 1
       refine 0  0 0  2 2                  the level-0 cells [0,2) x [0,2) join Omega^1
       refine 1  0 0  3 3                  the level-1 cells [0,3) x [0,3) join Omega^2, as
                                           far as they lie in Omega^1
   1, 2 or 3 directions. `#` begins a comment. `degree` and `knots` stand before `refine`;
   refine lines come in any order of levels; boxes may overlap; cells as in mesh.h. One
   degree a direction, the same on all levels.

   Knots of finer levels (insert.h). The knots of a level are the doubles of the level before and
   t + (t' - t) / 2 between neighbours t < t', computed in double precision, level by level. They
   are exact where level 0 has few binary digits (0.25), and rounded elsewhere (0.1): who takes
   (t + t') / 2, or the middles of decimal fractions, may get other knots, and values that differ
   by about ulp(t) / (t' - t).
   Auxiliary knots, those before and behind the domain, are halved too, and on each side the d
   nearest to the domain are kept. For example, degree 2:
       level 0   -2 -1  0  1  2  3  4           the domain is [0,2]
       level 1   -1 -0.5  0  0.5  1  1.5  2  2.5  3
       level 2   -0.5 -0.25  0  0.25 ..  2  2.25  2.5
   Knots at an open end, 0 0 0, stay d+1 copies of it.

   Limits, of reader and writer alike: the cells of all Omega^l together, refined or not, and the
   functions of level 0 are at most KW_MESHFILE_CELLS; the knots of all levels and directions are
   at most KW_MESHFILE_KNOTS, which lets a mesh of one cell in each of two directions have all
   KW_MESH_LEVELS levels. Such a mesh takes 20 bytes a knot and up to 64 a refined cell, less
   than 3.5 GB. The reader takes 2^30 steps at most, one for each cell of each box. */
#ifndef KW_MESHFILE_H
#define KW_MESHFILE_H

#include "mesh.h"

enum { KW_MESHFILE_CELLS = 1 << 26, KW_MESHFILE_KNOTS = 1 << 26 };

/* Room for a message: the file, the line, what is wrong there. */
enum { KW_MESHFILE_MESSAGE = 512 };

/* Reads a mesh file. If it cannot it returns NULL and fills
   message[0 .. KW_MESHFILE_MESSAGE-1]. The caller frees the mesh. */
kw_mesh *kw_meshfile_read(const char *path, char *message);

/* The same from `size` characters of text; messages call it `name`. */
kw_mesh *kw_meshfile_parse(const char *text, size_t size, const char *name,
                           char *message);

/* Writes a mesh file, whole or not at all. 0, or 1 after a message on stderr: the file cannot be
   written, or the mesh is beyond the limits. */
int kw_meshfile_write(const kw_mesh *m, const char *path);

#endif
