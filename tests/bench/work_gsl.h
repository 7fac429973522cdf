/* work_gsl.h -- the works of work_spline.h, done by the GNU Scientific Library where it is
   installed. Nothing but `make bench` knows of it. */
#ifndef WORK_GSL_H
#define WORK_GSL_H

#include "bench.h"
#include "work_spline.h"

typedef struct gsl_work gsl_work;

typedef struct gsl_peer {
    /* The same space, coefficients and points, the first `count` of them; results in memory of
       its own with room for as many numbers a point. `of` stays the caller's. */
    gsl_work *(*make)(const spline_work *of, int count, int numbers);
    void (*drop)(gsl_work *g);
    /* what is done with it */
    bench_work *basis, *curve, *curve2, *surface;
    /* The largest difference between its first results and value[0..numbers-1]. */
    double (*difference)(const gsl_work *g, size_t numbers, const double *value);
} gsl_peer;

/* NULL if it was not there when this was compiled. */
const gsl_peer *gsl_peer_there(void);

#endif
