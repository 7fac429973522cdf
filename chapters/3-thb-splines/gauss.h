/* gauss.h -- Gauss's rule with three or four nodes, for products of two splines of degree 2 or
   3. */
#ifndef GAUSS_H
#define GAUSS_H

#include "need.h"
#include <math.h>

enum { GAUSS_NODES = 4 };

/* Nodes and weights on [0,1], `nodes` of either, 3 or 4: exact for polynomials of degree 5 or
   7. [Abramowitz, Stegun: Handbook of Mathematical Functions, table 25.4] */
static inline void gauss(int nodes, double *node, double *weight)
{
    double x[GAUSS_NODES] = {0}, w[GAUSS_NODES] = {0}; /* on [-1,1] */

    KW_NEED(nodes == 3 || nodes == 4, "%d nodes", nodes);
    if (nodes == 3) {
        x[2] = sqrt(3.0 / 5);
        w[2] = 5.0 / 9;
        w[1] = 8.0 / 9;
    } else {
        x[3] = sqrt(3.0 / 7 + 2.0 / 7 * sqrt(6.0 / 5));
        x[2] = sqrt(3.0 / 7 - 2.0 / 7 * sqrt(6.0 / 5));
        w[3] = (18 - sqrt(30)) / 36;
        w[2] = (18 + sqrt(30)) / 36;
    }
    for (int i = nodes / 2; i < nodes; i++) {
        node[i] = (1 + x[i]) / 2;
        node[nodes - 1 - i] = (1 - x[i]) / 2;
        weight[i] = weight[nodes - 1 - i] = w[i] / 2;
    }
}

#endif
