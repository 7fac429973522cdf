/* vtu.h -- hierarchical meshes as VTK files, every active cell with its level.
   [Schroeder, Martin, Lorensen: The Visualization Toolkit, 4th edition, file formats] */
#ifndef GEN_VTU_H
#define GEN_VTU_H

#include "mesh.h"

/* Each active cell is a line, a quadrilateral or a hexahedron with corners of its own. A corner
   stands where place(with, x, point) says: from x[0..D-1] to point[0..2]; place == NULL:
   at x. 0, or 1 after a message on stderr. */
int gen_vtu_mesh(const char *path, const kw_mesh *m,
                 void (*place)(void *with, const double *x, double *point), void *with);

#endif
