#include "work_gsl.h"
#include <stddef.h>

#ifdef BENCH_GSL

#include "need.h"
#include <gsl/gsl_bspline.h>
#include <math.h>
#include <stdlib.h>

struct gsl_work {
    const spline_work *of;
    int count;
    gsl_bspline_workspace *space[2]; /* one for each direction */
    gsl_vector *basis[2];
    gsl_matrix *derivatives; /* (d+1) x (WORK_DERIVATIVES + 1) */
    double *value;
};

static gsl_work *make_work(const spline_work *of, int count, int numbers)
{
    gsl_work *g = kw_need_memory(1, sizeof *g);
    const size_t k = (size_t)of->s->d + 1, breaks = (size_t)(of->s->n - of->s->d) + 1;

    g->of = of;
    g->count = count;
    for (int h = 0; h < 2; h++) {
        gsl_vector_view t = gsl_vector_view_array(of->s->t + of->s->d, breaks);

        g->space[h] = gsl_bspline_alloc(k, breaks);
        gsl_bspline_knots(&t.vector, g->space[h]);
        g->basis[h] = gsl_vector_alloc(k);
    }
    g->derivatives = gsl_matrix_alloc(k, WORK_DERIVATIVES + 1);
    g->value = kw_need_memory((size_t)count * (size_t)numbers, sizeof *g->value);
    return g;
}

static void drop_work(gsl_work *g)
{
    if (!g)
        return;
    for (int h = 0; h < 2; h++) {
        gsl_bspline_free(g->space[h]);
        gsl_vector_free(g->basis[h]);
    }
    gsl_matrix_free(g->derivatives);
    free(g->value);
    free(g);
}

static void run_basis(void *with)
{
    gsl_work *g = with;
    const size_t k = (size_t)g->of->s->d + 1;
    size_t first, last;

    for (int i = 0; i < g->count; i++) {
        gsl_vector_view value = gsl_vector_view_array(g->value + (size_t)i * k, k);

        gsl_bspline_eval_nonzero(g->of->x[i], &value.vector, &first, &last, g->space[0]);
    }
}

/* point += factor times a coefficient */
static void add(double factor, const double *c, double *point)
{
    for (int m = 0; m < WORK_N; m++)
        point[m] += factor * c[m];
}

static double *cleared(double *point, int numbers)
{
    for (int m = 0; m < numbers; m++)
        point[m] = 0;
    return point;
}

static void run_curve(void *with)
{
    gsl_work *g = with;
    const gsl_vector *b = g->basis[0];
    size_t first, last;

    for (int i = 0; i < g->count; i++) {
        double *point = cleared(g->value + (size_t)i * WORK_N, WORK_N);

        gsl_bspline_eval_nonzero(g->of->x[i], g->basis[0], &first, &last, g->space[0]);
        for (size_t j = 0; j < b->size; j++)
            add(b->data[j], g->of->c + (first + j) * WORK_N, point);
    }
}

static void run_curve2(void *with)
{
    enum { NUMBERS = WORK_N * (WORK_DERIVATIVES + 1) };
    gsl_work *g = with;
    const gsl_matrix *b = g->derivatives;
    size_t first, last;

    for (int i = 0; i < g->count; i++) {
        double *point = cleared(g->value + (size_t)i * NUMBERS, NUMBERS);

        gsl_bspline_deriv_eval_nonzero(g->of->x[i], WORK_DERIVATIVES, g->derivatives,
                                       &first, &last, g->space[0]);
        for (size_t j = 0; j < b->size1; j++)
            for (size_t q = 0; q < b->size2; q++)
                add(b->data[j * b->tda + q], g->of->c + (first + j) * WORK_N,
                    point + q * WORK_N);
    }
}

static void run_surface(void *with)
{
    gsl_work *g = with;
    const size_t n = (size_t)g->of->s->n;
    size_t first[2], last;

    for (int i = 0; i < g->count; i++) {
        double *point = cleared(g->value + (size_t)i * WORK_N, WORK_N);

        for (int h = 0; h < 2; h++)
            gsl_bspline_eval_nonzero(g->of->x[(size_t)2 * (size_t)i + (size_t)h],
                                     g->basis[h], &first[h], &last, g->space[h]);
        for (size_t j = 0; j < g->basis[0]->size; j++)
            for (size_t k = 0; k < g->basis[1]->size; k++)
                add(g->basis[0]->data[j] * g->basis[1]->data[k],
                    g->of->c + ((first[0] + j) * n + first[1] + k) * WORK_N, point);
    }
}

static double difference(const gsl_work *g, size_t numbers, const double *value)
{
    double most = 0;

    for (size_t i = 0; i < numbers; i++)
        most = fmax(most, fabs(g->value[i] - value[i]));
    return most;
}

const gsl_peer *gsl_peer_there(void)
{
    static const gsl_peer peer = {make_work,  drop_work,   run_basis, run_curve,
                                  run_curve2, run_surface, difference};

    return &peer;
}

#else

const gsl_peer *gsl_peer_there(void)
{
    return NULL;
}

#endif
