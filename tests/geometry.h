/* geometry.h -- a geometry in hierarchical splines, function by function. */
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include "hier.h"
#include "need.h"
#include <stdlib.h>

/* point[0..N-1] = the sum over i of c_i times function i at x, orders r; c is size x N. */
static inline void geometry_at(const kw_hier *b, kw_hier_kind kind, int N,
                               const double *c, const int *r, const double *x,
                               double *point)
{
    int *index = kw_need_memory((size_t)b->most, sizeof *index), count;
    double *value = kw_need_memory((size_t)b->most, sizeof *value);

    count = kw_hier_at(b, kind, r, x, index, value);
    for (int a = 0; a < N; a++)
        point[a] = 0;
    for (int i = 0; i < count; i++)
        for (int a = 0; a < N; a++)
            point[a] += value[i] * c[index[i] * N + a];
    free(index);
    free(value);
}

#endif
