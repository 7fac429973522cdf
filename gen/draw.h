/* draw.h -- random things that several families need. */
#ifndef GEN_DRAW_H
#define GEN_DRAW_H

#include "rng.h"

/* x[0..n-1], uniform in [low, high). */
void gen_draw_uniform(kw_rng *r, double low, double high, int n, double *x);

/* x[0..n-1], uniform in [0, 1) and ascending. `work` has n numbers, `place` n + 1. Linear time,
   on the average. */
void gen_draw_sorted(kw_rng *r, int n, double *x, double *work, int *place);

/* noisy[0..n-1]: clean[0..n-1] plus normal deviates of the standard deviation sigma. With
   sigma = 0 the same. The arrays do not overlap. */
void gen_draw_noise(kw_rng *r, double sigma, int n, const double *restrict clean,
                    double *restrict noisy);

#endif
