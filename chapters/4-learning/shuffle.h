/* shuffle.h -- a random order. */
#ifndef SHUFFLE_H
#define SHUFFLE_H

#include "rng.h"

/* order[0..count-1]: 0 .. count-1, every order as likely.
   [Knuth: The Art of Computer Programming, vol. 2, section 3.4.2] */
static inline void shuffle(kw_rng *r, int count, int *order)
{
    for (int i = 0; i < count; i++) {
        int at = kw_rng_below(r, i + 1);

        order[i] = i; /* if `at` is i, it stays there */
        order[i] = order[at];
        order[at] = i;
    }
}

#endif
