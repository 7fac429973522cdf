/* netcheck.h -- what the tests of nets share: a net with parameters and a batch, and its
   gradients held against differences. */
#ifndef NETCHECK_H
#define NETCHECK_H

#include "need.h"
#include "net.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>

enum { SAMPLES = 3 };

/* A batch, and weights c for the sum of all c_i y_i, the number that is differentiated. */
typedef struct netcheck {
    const kw_net *n;
    kw_net_work *k;
    double *w, *x, *y, *c;
} netcheck;

static inline double *netcheck_numbers(kw_rng *r, int count)
{
    double *a = kw_need_memory((size_t)count, sizeof *a);

    for (int i = 0; i < count; i++)
        a[i] = test_random_in(r, -1, 1);
    return a;
}

static inline netcheck netcheck_new(const kw_net *n, uint64_t seed)
{
    kw_rng r = kw_rng_at(seed, 0, 0, 0);

    return (netcheck){.n = n,
                      .k = kw_net_work_new(n, SAMPLES),
                      .w = netcheck_numbers(&r, n->parameters),
                      .x = netcheck_numbers(&r, SAMPLES * n->in),
                      .y = netcheck_numbers(&r, SAMPLES * n->out),
                      .c = netcheck_numbers(&r, SAMPLES * n->out)};
}

static inline void netcheck_free(netcheck *t)
{
    kw_net_work_free(t->k);
    free(t->w);
    free(t->x);
    free(t->y);
    free(t->c);
}

/* How many of count numbers differ. */
static inline int netcheck_unlike(int count, const double *a, const double *b)
{
    int unlike = 0;

    for (int i = 0; i < count; i++)
        unlike += a[i] != b[i];
    return unlike;
}

static inline double netcheck_sum(netcheck *t)
{
    double sum = 0;

    kw_net_forward(t->n, t->w, SAMPLES, t->x, t->k, t->y);
    for (int i = 0; i < SAMPLES * t->n->out; i++)
        sum += t->c[i] * t->y[i];
    return sum;
}

/* Central differences with respect to a[0..count-1], which the sum reads, against `d`. With
   the step h they are off by h^2/6 times a third derivative and by the rounding of the
   sum over h. With h = 2^-17 both are some 1e-10 times numbers of the size of 1 to 10,
   while the largest derivative is not much below 1: so 1e-6 times this is held. */
static inline void netcheck_differences(netcheck *t, const char *name, int count,
                                        double *a, const double *d)
{
    const double h = 0x1p-17;
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(d[i]));
    CHECK(count == 0 || most >= 0.01, "%s: all derivatives below %g", name, most);
    for (int i = 0; i < count; i++) {
        double here = a[i], ahead, behind;

        a[i] = here + h;
        ahead = netcheck_sum(t);
        a[i] = here - h;
        behind = netcheck_sum(t);
        a[i] = here;
        CHECK(fabs((ahead - behind) / (2 * h) - d[i]) <= 1e-6 * most,
              "%s: derivative %d is %.12g, the difference %.12g", name, i, d[i],
              (ahead - behind) / (2 * h));
    }
}

/* All derivatives of the net at one place. */
static inline void netcheck_gradient(const char *name, const kw_net *n, uint64_t seed)
{
    netcheck t = netcheck_new(n, seed);
    double *dx = kw_need_memory((size_t)SAMPLES * (size_t)n->in, sizeof *dx);
    double *dw = kw_need_memory((size_t)n->parameters, sizeof *dw);

    test_poison(dx, SAMPLES * n->in);
    netcheck_sum(&t);
    kw_net_backward(n, t.w, SAMPLES, t.x, t.y, t.c, t.k, dx, dw);
    netcheck_differences(&t, name, n->parameters, t.w, dw);
    netcheck_differences(&t, name, SAMPLES * n->in, t.x, dx);
    free(dx);
    free(dw);
    netcheck_free(&t);
}

#endif
