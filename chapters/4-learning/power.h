/* power.h -- a whole power of a number. */
#ifndef POWER_H
#define POWER_H

/* base^exponent by `exponent` products, exponent >= 0. */
static inline double power(double base, int exponent)
{
    double p = 1;

    for (int i = 0; i < exponent; i++)
        p *= base;
    return p;
}

#endif
