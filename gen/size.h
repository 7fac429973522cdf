/* size.h -- what a mesh may ask for: a short file may ask for more than a machine has. */
#ifndef SIZE_H
#define SIZE_H

#include "active.h"

/* For `gen COMMAND --help`. */
#define SIZE_HELP                                                                        \
    "Limits. A file is refused if the cells of all levels, refined or not, or the\n"     \
    "knots of all levels and directions are more than 2^26 (67108864), or the cells\n"   \
    "of all boxes more than 2^30. So it is if the basis would take more than 2^32\n"     \
    "bytes (4.3e9, half of what many machines have; an upper bound is counted\n"         \
    "before), or more than a minute or two: 2^30 pairs of a cell and a B-spline of\n"    \
    "its level on it; for gen reference also 2^35 triples of a cell and two such\n"      \
    "B-splines.\n"

/* Is there room for the active functions of the mesh of file `path`? For its whole basis? 0, or
   GEN_BAD_INPUT after a message. For the second the active functions are found, and dropped. */
int size_check_active(const kw_mesh *m, const char *path);
int size_check_basis(const kw_mesh *m, const char *path);

#endif
