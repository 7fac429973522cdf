/* bits.h -- what drivers of this lesson share: all inputs of a few signs, and a task on them. */
#ifndef BITS_H
#define BITS_H

/* all, 2^bits x bits: row i has the binary digits of i, the last one first, as -1 and +1. */
static inline void fill_inputs(int bits, double *all)
{
    for (int i = 0; i < 1 << bits; i++)
        for (int j = 0; j < bits; j++)
            all[i * bits + j] = i >> j & 1 ? 1 : -1;
}

/* The task that a vote decides, `bits` odd: +1 if most of the signs are, else -1. */
static inline double majority(int bits, const double *signs)
{
    double sum = 0;

    for (int j = 0; j < bits; j++)
        sum += signs[j];
    return sum > 0 ? 1 : -1;
}

#endif
