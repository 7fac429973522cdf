/* work_hier.h -- what is done with hierarchical splines on a mesh that is refined along the
   diagonal of the unit square (chapters/9-cost/diagonal.h). */
#ifndef WORK_HIER_H
#define WORK_HIER_H

#include "hierpieces.h"

typedef struct hier_work {
    kw_mesh *m;
    kw_hier *b;
    kw_hier_kind kind;
    kw_hierpieces *p; /* of a geometry in R^3 */
    int count;     /* points: half of them anywhere, half of them in the finest cells */
    double *x;     /* count x 2 */
    double *y;     /* count x 3 */
    int *index;    /* b->most */
    double *value; /* b->most */
    double found;  /* functions listed at a point, on average; work_functions sets it */
} hier_work;

/* cells x cells of them, refined so many times. */
hier_work *hier_work_new(int d, int cells, int times, int count);
void hier_work_free(hier_work *w);

void work_build(void *with);      /* the basis of the mesh */
void work_functions(void *with);  /* the functions that are not zero at all points */
void work_hierpieces(void *with); /* the points of the geometry */

#endif
