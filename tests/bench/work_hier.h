/* work_hier.h -- what is done with hierarchical splines on a mesh that is refined along the
   diagonal of the unit square (chapters/9-cost/diagonal.h). */
#ifndef WORK_HIER_H
#define WORK_HIER_H

#include "hierpieces.h"

enum { WORK_BLOCK = 1000 };

typedef struct hier_work {
    kw_mesh *m;
    kw_hier *b;
    kw_hierpieces *p; /* of a geometry in R^3 */
    double *x;        /* count x 2: points, half anywhere and half in the finest cells */
    double *y;        /* count x 3 */
    /* room for WORK_BLOCK points at a time: so little that it stays in the cache */
    int *found, *index;
    double *value;
    double listed; /* functions at a point, on average; work_functions sets it */
    kw_hier_kind kind;
    int count;
} hier_work;

/* cells x cells of them, refined so many times. */
hier_work *hier_work_new(int d, int cells, int times, int count);
void hier_work_free(hier_work *w);

void work_build(void *with);      /* the basis of the mesh */
void work_functions(void *with);  /* the functions that are not zero at all points */
void work_hierpieces(void *with); /* the points of the geometry */

#endif
