/* ply.h -- clouds of points as PLY files, which keep parameters u and v with each point.
   [Turk: The PLY polygon file format, 1994] */
#ifndef GEN_PLY_H
#define GEN_PLY_H

/* The points of `rows` rows of `columns` numbers; x, y, z, u and v are the columns place[0..4] of a
   row. 0, or 1 after a message on stderr. */
int gen_ply_cloud(const char *path, int rows, int columns, const double *row,
                  const int *place);

#endif
