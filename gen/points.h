/* points.h -- points from a CSV file.

       x1,x2
       0.25,1
   The header x1 .. xD, then a line for each point. Lines end with LF or CRLF. */
#ifndef POINTS_H
#define POINTS_H

#include "mesh.h"

/* Reads points of the domain of m: *x is count x D and freed by the caller. 0, or 1 after a
   message on stderr with the file, the line and what is wrong there; then *x is NULL. */
int points_read(const char *path, const kw_mesh *m, size_t *count, double **x);

#endif
