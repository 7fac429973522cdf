/* bench_spline.c -- what evaluation costs, and that many spans cost little more than few: a
   span is found by bisection. The ratios are to the basis of degree 2 on 100 spans. */
#include "bench.h"
#include "curve.h"
#include "need.h"
#include "rng.h"
#include "tensor.h"
#include <stdio.h>

enum { POINTS = 20000, N = 3, SURFACE = 40 /* spans of a direction */ };

typedef struct task {
    kw_bspline *s;
    kw_tensor *g;
    double *x; /* POINTS x 2 */
    double *c; /* coefficients in R^N */
} task;

static double basis(void *with)
{
    const task *t = with;
    double value[KW_BSPLINE_DEGREE + 1], sum = 0;

    for (int i = 0; i < POINTS; i++)
        sum += kw_bspline_basis(t->s, t->x[i], value) + value[0];
    return sum;
}

static double curve_point(void *with)
{
    const task *t = with;
    double point[N], sum = 0;

    for (int i = 0; i < POINTS; i++) {
        kw_curve_point(t->s, N, t->c, t->x[i], point);
        sum += point[0];
    }
    return sum;
}

static double surface_point(void *with)
{
    const task *t = with;
    double point[N], sum = 0;

    for (int i = 0; i < POINTS; i++) {
        kw_tensor_point(t->g, N, t->c, NULL, t->x + 2 * i, point);
        sum += point[0];
    }
    return sum;
}

static double *random_numbers(size_t count)
{
    kw_rng r = kw_rng_at(2, 0, 0, 0);
    double *x = kw_need_memory(count, sizeof *x);

    for (size_t i = 0; i < count; i++)
        x[i] = kw_rng_uniform(&r);
    return x;
}

/* first == 0 asks for the time to which the others are compared. */
static double show(const char *what, int d, int spans, double time, double first)
{
    double ns = time / POINTS;

    first = first > 0 ? first : ns;
    printf("%-14s %6d %6d  %8.1f (%.2f)\n", what, d, spans, ns, ns / first);
    fflush(stdout);
    return first;
}

int main(void)
{
    double first = 0;
    task t = {.x = random_numbers((size_t)2 * POINTS)};

    printf("B-splines; in brackets the ratio to the first row\n"
           "what           degree  spans  ns/point\n");
    for (int d = 2; d <= 3; d++)
        for (int spans = 100; spans <= 10000; spans *= 100) {
            t.s = kw_bspline_new_open_uniform(d, spans, 0, 1);
            t.c = random_numbers((size_t)t.s->n * N);
            first = show("basis", d, spans, bench_median(basis, &t), first);
            show("curve point", d, spans, bench_median(curve_point, &t), first);
            free(t.c);
            kw_bspline_free(t.s);
        }
    for (int d = 2; d <= 3; d++) {
        const kw_bspline *both[2];

        t.s = kw_bspline_new_open_uniform(d, SURFACE, 0, 1);
        both[0] = both[1] = t.s;
        t.g = kw_tensor_new(2, both);
        t.c = random_numbers((size_t)kw_tensor_dimension(t.g) * N);
        show("surface point", d, SURFACE, bench_median(surface_point, &t), first);
        free(t.c);
        kw_tensor_free(t.g);
        kw_bspline_free(t.s);
    }
    free(t.x);
    return 0;
}
