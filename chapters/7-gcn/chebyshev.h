/* chebyshev.h -- the value of a Chebyshev series. */
#ifndef CHEBYSHEV_H
#define CHEBYSHEV_H

/* c_0 T_0(s) + .. + c_degree T_degree(s) */
static inline double polynomial(int degree, const double *c, double s)
{
    double before = 1, t = s, sum = c[0];

    for (int q = 1; q <= degree; q++) {
        double next = 2 * s * t - before;

        sum += c[q] * t;
        before = t;
        t = next;
    }
    return sum;
}

#endif
