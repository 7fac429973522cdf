/* ranks.h -- what the drivers that count dimensions share. */
#ifndef RANKS_H
#define RANKS_H

#include "dense.h"
#include <math.h>

/* The r-th derivative of u^q at u. */
static inline double power(int q, int r, double u)
{
    double value = 1;

    for (int i = 0; i < r; i++)
        value *= q - i;
    for (int i = 0; i < q - r; i++)
        value *= u;
    return q < r ? 0 : value;
}

/* The rank of A; *slack grows to the tolerance over the smallest pivot. */
static inline int rank_of(int rows, int columns, double *A, double *slack)
{
    double gap;
    int rank = kw_dense_rank(rows, columns, A, &gap);

    *slack = fmax(*slack, 1 / gap);
    return rank;
}

#endif
