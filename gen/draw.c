/* draw.c -- random things that several families need. */
#include "draw.h"
#include "normal.h"
#include <string.h>

void gen_draw_uniform(kw_rng *r, double low, double high, int n, double *x)
{
    for (int i = 0; i < n; i++)
        x[i] = low + (high - low) * kw_rng_uniform(r);
}

/* Few steps where all is nearly in order. */
static void sort_nearly(int n, double *x)
{
    for (int i = 1; i < n; i++) {
        double value = x[i];
        int j = i;

        for (; j > 0 && x[j - 1] > value; j--)
            x[j] = x[j - 1];
        x[j] = value;
    }
}

/* Into n buckets of equal width, bucket after bucket; about one number falls into each. */
void gen_draw_sorted(kw_rng *r, int n, double *x, double *work, int *place)
{
    memset(place, 0, (size_t)(n + 1) * sizeof *place);
    for (int i = 0; i < n; i++) {
        work[i] = kw_rng_uniform(r);
        place[(int)(work[i] * n) + 1]++;
    }
    for (int b = 0; b < n; b++)
        place[b + 1] += place[b];
    for (int i = 0; i < n; i++)
        x[place[(int)(work[i] * n)]++] = work[i];
    sort_nearly(n, x);
}

void gen_draw_noise(kw_rng *r, double sigma, int n, const double *restrict clean,
                    double *restrict noisy)
{
    if (sigma == 0) {
        memcpy(noisy, clean, (size_t)n * sizeof *noisy);
        return;
    }
    kw_normal_many(r, n, noisy);
    for (int i = 0; i < n; i++)
        noisy[i] = clean[i] + sigma * noisy[i];
}
