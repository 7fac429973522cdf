#include "machine.h"
#include "need.h"
#include "wide.h"
#include <math.h>
#include <stdlib.h>

enum { LONG = 1 << 24, SUMS = 96, ROUNDS = 20000 };

const double MACHINE_BYTES = 3.0 * LONG * sizeof(double);
const double MACHINE_MULTIPLY_ADDS = (double)ROUNDS * SUMS;

machine *machine_new(void)
{
    machine *m = kw_need_memory(1, sizeof *m);

    m->a = kw_need_memory((size_t)3 * LONG, sizeof *m->a);
    for (size_t i = 0; i < (size_t)3 * LONG; i++)
        m->a[i] = 1;
    return m;
}

void machine_free(machine *m)
{
    free(m->a);
    free(m);
}

void machine_triad(void *with)
{
    const machine *m = with;
    double *restrict a = m->a;
    const double *b = m->a + LONG, *c = m->a + 2 * LONG;

    for (int i = 0; i < LONG; i++)
        a[i] = b[i] + 3 * c[i];
}

/* Compiled for the processors that have the fused operation, as wide.h does it. */
#if defined(__x86_64__) && defined(__gnu_linux__)
#define FUSED __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define FUSED
#endif

static inline double total(const double *number)
{
    double sum = 0;

    for (int i = 0; i < SUMS; i++)
        sum += number[i];
    return sum;
}

KW_WIDE static double multiply_add(double factor)
{
    double sum[SUMS] = {0};

    for (int k = 0; k < ROUNDS; k++)
        for (int i = 0; i < SUMS; i++)
            sum[i] = sum[i] * factor + factor;
    return total(sum);
}

FUSED static double fused(double factor)
{
    double sum[SUMS] = {0};

    for (int k = 0; k < ROUNDS; k++)
        for (int i = 0; i < SUMS; i++)
            sum[i] = fma(sum[i], factor, factor);
    return total(sum);
}

void machine_multiply_add(void *with)
{
    machine *m = with;

    m->sum = multiply_add(0.5);
}

void machine_fused(void *with)
{
    machine *m = with;

    m->sum = fused(0.5);
}
