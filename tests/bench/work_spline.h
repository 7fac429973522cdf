/* work_spline.h -- what is done with B-splines of one direction and of two: open knots, equal
   spans of [0,1], coefficients in R^3, random points. */
#ifndef WORK_SPLINE_H
#define WORK_SPLINE_H

#include "tensor.h"

enum { WORK_N = 3, WORK_DERIVATIVES = 2, WORK_GRID = 1000 };

typedef struct spline_work {
    int count;     /* points */
    kw_bspline *s; /* a direction */
    kw_tensor *g;  /* two of them, or NULL */
    double *x;     /* count x the number of directions */
    double *c;     /* coefficients of a curve, of a surface if there are two directions */
    int *first;    /* count */
    double *value; /* count x as many numbers as were asked for */
} spline_work;

/* Random numbers in [0,1); the caller frees. */
double *new_random(size_t count);

/* `numbers`: how many results of a point there is room for. */
spline_work *spline_work_new(int d, int spans, int directions, int count, int numbers);
void spline_work_free(spline_work *w);

/* --- works with a spline_work: at all of its points --- */

void work_basis(void *with);   /* the d+1 functions that are not zero */
void work_curve(void *with);   /* a point of the curve */
void work_curve2(void *with);  /* the same with two derivatives */
void work_basis2(void *with);  /* the (d+1)^2 functions of two directions */
void work_surface(void *with); /* a point of the surface */

/* --- the surface on a grid of WORK_GRID x WORK_GRID points --- */

typedef struct grid_work {
    const spline_work *of; /* not owned */
    double *x, *room, *point;
} grid_work;

grid_work *grid_work_new(const spline_work *of);
void grid_work_free(grid_work *w);
void work_grid(void *with);

/* --- a curve of n coefficients, every span of which is halved --- */

typedef struct refine_work {
    kw_bspline *s, *fine;
    double *c, *out;
} refine_work;

refine_work *refine_work_new(int d, int n);
void refine_work_free(refine_work *w);
void work_refine(void *with);       /* the new coefficients, in a space that is there */
void work_refine_space(void *with); /* that space, made and freed */

#endif
