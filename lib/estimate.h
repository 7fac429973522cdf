/* estimate.h -- how much memory and work a hierarchical basis takes, before it is built.

   A mesh of a few lines may have more cells and functions than a machine holds, and then
   kw_active_new and kw_hier_new abort. Who reads meshes of others asks here first. The numbers
   count what those functions ask of the system; they are upper bounds, one and a
   half to four times what is kept in the end. */
#ifndef KW_ESTIMATE_H
#define KW_ESTIMATE_H

#include "active.h"

/* The pairs of a cell and a function of its level that is not zero on it: kw_active_new takes a
   step for each of them. */
double kw_estimate_pairs(const kw_mesh *m);

/* The triples of a cell and two such functions: kw_hier_new moves a few numbers for each. */
double kw_estimate_numbers(const kw_mesh *m);

/* The bytes of m and of kw_active_new(m). Linear in the number of refined cells. */
double kw_estimate_active(const kw_mesh *m);

/* The bytes of the mesh of a and of kw_hier_new of it. As quick as kw_active_new. */
double kw_estimate_hier(const kw_active *a);

#endif
