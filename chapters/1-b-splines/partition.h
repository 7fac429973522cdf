/* partition.h -- random partitions with multiplicities, for the drivers that try many.

   Widths of cells are small integers, so that breakpoints are exact and every degree, number
   of cells and multiplicity up to k comes up. */
#ifndef PARTITION_H
#define PARTITION_H

#include "bspline.h"
#include "rng.h"
#include <string.h>

enum {
    PARTITION_D = 4,
    PARTITION_L = 5,
    PARTITION_N = PARTITION_L * (PARTITION_D + 1) /* the largest dimension */
};

typedef struct partition {
    int d, L;                    /* degree 0 .. PARTITION_D, cells 1 .. PARTITION_L */
    int mu[PARTITION_L];         /* mu[i-1] of tau[i], 1 .. k, i = 1 .. L-1 */
    int m;                       /* their sum */
    double tau[PARTITION_L + 1]; /* tau[0] < .. < tau[L] */
} partition;

/* Sample i of the partitions of one seed. */
static inline partition random_partition(uint64_t seed, uint64_t i)
{
    kw_rng r = kw_rng_at(seed, 0, i, 0);
    partition p = {.d = kw_rng_below(&r, PARTITION_D + 1),
                   .L = 1 + kw_rng_below(&r, PARTITION_L)};

    for (int c = 1; c <= p.L; c++)
        p.tau[c] = p.tau[c - 1] + 1 + kw_rng_below(&r, 4);
    for (int c = 1; c < p.L; c++) {
        p.mu[c - 1] = 1 + kw_rng_below(&r, p.d + 1);
        p.m += p.mu[c - 1];
    }
    return p;
}

/* Its space on open knots; the caller frees. */
static inline kw_bspline *partition_space(const partition *p)
{
    return kw_bspline_new_open(p->d, p->L, p->tau, p->mu);
}

/* The same space on auxiliary knots of sample i, in order, 0 .. 2 apart: the knots are not open
   but by chance. The caller frees. */
static inline kw_bspline *with_auxiliary_knots(const kw_bspline *s, uint64_t i)
{
    double t[PARTITION_N + PARTITION_D + 1];
    kw_rng r = kw_rng_at(4, 0, i, 0);

    memcpy(t, s->t, (size_t)(s->n + s->d + 1) * sizeof *t);
    for (int j = 1; j <= s->d; j++) {
        t[s->d - j] = t[s->d - j + 1] - kw_rng_below(&r, 3);
        t[s->n + j] = t[s->n + j - 1] + kw_rng_below(&r, 3);
    }
    return kw_bspline_new(s->d, s->n, t);
}

#endif
