/* control.h -- splines with their control points, for the drivers that refine them. */
#ifndef CONTROL_H
#define CONTROL_H

#include "bspline.h"
#include "elevate.h"
#include "insert.h"
#include "need.h"
#include <stdlib.h>

enum { PLANE = 2 };

/* A spline: a space and its control points in the plane, both owned. */
typedef struct spline {
    kw_bspline *s;
    double *c;
} spline;

static inline spline new_spline(kw_bspline *s)
{
    spline f = {s, kw_need_memory((size_t)s->n * PLANE, sizeof(double))};

    return f;
}

static inline void free_spline(spline f)
{
    kw_bspline_free(f.s);
    free(f.c);
}

static inline spline insert_dyadic(spline f)
{
    spline g = new_spline(kw_insert_new_dyadic(f.s));

    kw_insert_oslo(f.s, g.s, PLANE, f.c, g.c);
    return g;
}

static inline spline elevate(spline f)
{
    spline g = new_spline(kw_elevate_new(f.s));

    kw_elevate(f.s, g.s, PLANE, f.c, g.c);
    return g;
}

#endif
