/* hinges.h -- a linear spline as a network of one hidden layer of ReLU units. */
#ifndef HINGES_H
#define HINGES_H

#include "mlp.h"

/* 1-hidden-1; its 3 hidden + 1 parameters are W^(1), b^(1), W^(2), b^(2). */
static inline kw_net *new_relu_net(int hidden)
{
    static const kw_activation_kind sigma[] = {KW_RELU, KW_IDENTITY};

    return kw_mlp_new(2, (const int[]){1, hidden, 1}, sigma);
}

/* The parameters w with which a net of n-1 hidden units is the piecewise linear
   function through (t_i, c_i), i = 0 .. n-1, on [t_0, t_{n-1}]: c_0 and a hinge at
   each t_i but the last, whose weight is the change of the slope there. */
static inline void hinges_of(int n, const double *t, const double *c, double *w)
{
    const int hidden = n - 1;
    double before = 0;

    for (int i = 0; i < hidden; i++) {
        double slope = (c[i + 1] - c[i]) / (t[i + 1] - t[i]);

        w[i] = 1;
        w[hidden + i] = -t[i];
        w[2 * hidden + i] = slope - before;
        before = slope;
    }
    w[3 * hidden] = c[0];
}

#endif
