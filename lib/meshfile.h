/* meshfile.h -- hierarchical meshes as text.

       degree 2 2
       knots 0 0 0 0.25 0.5 0.75 1 1 1     one line a direction, the extended knots of level 0
       knots 0 0 0 0.25 0.5 0.75 1 1 1
       refine 0  0 0  2 2                  the level-0 cells [0,2) x [0,2) join Omega^1
       refine 1  0 0  3 3                  the level-1 cells [0,3) x [0,3) join Omega^2, as
                                           far as they lie in Omega^1
   1, 2 or 3 directions. `#` begins a comment. `degree` and `knots` stand before `refine`;
   refine lines come in any order of levels; boxes may overlap; cells as in mesh.h. One
   degree a direction, the same on all levels. */
#ifndef KW_MESHFILE_H
#define KW_MESHFILE_H

#include "mesh.h"

/* Room for a message: the file, the line, what is wrong there. */
enum { KW_MESHFILE_MESSAGE = 512 };

/* Reads a mesh file. If it cannot it returns NULL and fills
   message[0 .. KW_MESHFILE_MESSAGE-1]. The caller frees the mesh. */
kw_mesh *kw_meshfile_read(const char *path, char *message);

/* The same from `size` characters of text; messages call it `name`. */
kw_mesh *kw_meshfile_parse(const char *text, size_t size, const char *name,
                           char *message);

/* Writes a mesh file, whole or not at all. 0, or 1 after a message on stderr. */
int kw_meshfile_write(const kw_mesh *m, const char *path);

#endif
