#include "tensor.h"
#include "combine.h"
#include "insert.h"
#include "need.h"
#include <limits.h>
#include <stdlib.h>

enum { K = KW_BSPLINE_DEGREE + 1, BATCH = 32 /* points or lines at a time */ };

/* --- spaces --- */

kw_tensor *kw_tensor_new(int D, const kw_bspline *const *s)
{
    kw_tensor *g = kw_need_memory(1, sizeof *g);
    int dimension = 1;

    KW_NEED(1 <= D && D <= KW_TENSOR_D, "D = %d, not in 1 .. %d", D, KW_TENSOR_D);
    g->D = D;
    for (int h = 0; h < D; h++) {
        KW_NEED(dimension <= INT_MAX / s[h]->n, "more than %d functions", INT_MAX);
        dimension *= s[h]->n;
        g->s[h] = kw_bspline_new_copy(s[h]);
    }
    return g;
}

static void need_direction(const kw_tensor *g, int h)
{
    KW_NEED(0 <= h && h < g->D, "direction %d, not in 0 .. %d", h, g->D - 1);
}

kw_tensor *kw_tensor_new_direction(const kw_tensor *g, int h, const kw_bspline *fine)
{
    const kw_bspline *s[KW_TENSOR_D] = {g->s[0], g->s[1], g->s[2]};

    need_direction(g, h);
    s[h] = fine;
    return kw_tensor_new(g->D, s);
}

kw_tensor *kw_tensor_new_dyadic(const kw_tensor *g)
{
    kw_bspline *fine[KW_TENSOR_D] = {NULL};
    const kw_bspline *s[KW_TENSOR_D] = {NULL};
    kw_tensor *all;

    for (int h = 0; h < g->D; h++)
        s[h] = fine[h] = kw_insert_new_dyadic(g->s[h]);
    all = kw_tensor_new(g->D, s);
    for (int h = 0; h < g->D; h++)
        kw_bspline_free(fine[h]);
    return all;
}

void kw_tensor_free(kw_tensor *g)
{
    if (!g)
        return;
    for (int h = 0; h < g->D; h++)
        kw_bspline_free(g->s[h]);
    free(g);
}

/* --- indices --- */

int kw_tensor_dimension(const kw_tensor *g)
{
    int product = 1;

    for (int h = 0; h < g->D; h++)
        product *= g->s[h]->n;
    return product;
}

int kw_tensor_local(const kw_tensor *g)
{
    int product = 1;

    for (int h = 0; h < g->D; h++)
        product *= g->s[h]->d + 1;
    return product;
}

int kw_tensor_flat(const kw_tensor *g, const int *j)
{
    int flat = 0;

    for (int h = 0; h < g->D; h++) {
        KW_NEED(0 <= j[h] && j[h] < g->s[h]->n,
                "index %d of direction %d, not in 0 .. %d", j[h], h, g->s[h]->n - 1);
        flat = flat * g->s[h]->n + j[h];
    }
    return flat;
}

void kw_tensor_multi(const kw_tensor *g, int flat, int *j)
{
    KW_NEED(0 <= flat && flat < kw_tensor_dimension(g), "index %d, not in 0 .. %d", flat,
            kw_tensor_dimension(g) - 1);
    for (int h = g->D - 1; h >= 0; h--) {
        j[h] = flat % g->s[h]->n;
        flat /= g->s[h]->n;
    }
}

/* --- functions --- */

/* The r-th derivatives of the local functions of s at x, value[0..d]; returns the first. */
static int univariate(const kw_bspline *s, int r, double x, double *value)
{
    int i;

    if (r == 0)
        return kw_bspline_basis(s, x, value);
    i = kw_bspline_span(s, x);
    kw_bspline_derivative_on(s, i, x, r, value);
    return i - s->d;
}

/* The same at x[0..count-1]: value is count x (d+1). */
static void univariate_many(const kw_bspline *s, int r, int count, const double *x,
                            int *first, double *value)
{
    if (r == 0)
        kw_bspline_basis_many(s, count, x, first, value);
    else
        for (int l = 0; l < count; l++)
            first[l] = univariate(s, r, x[l], value + l * (s->d + 1));
}

void kw_tensor_basis(const kw_tensor *g, const int *r, const double *x, int *first,
                     double *value)
{
    double factor[K];
    int size = 1; /* products of the directions so far: value[0..size-1] */

    value[0] = 1;
    for (int h = 0; h < g->D; h++) {
        int k = g->s[h]->d + 1;

        first[h] = univariate(g->s[h], r ? r[h] : 0, x[h], factor);
        /* from the back, so that each product is read before its place is written */
        for (int a = size - 1; a >= 0; a--)
            for (int b = k - 1; b >= 0; b--)
                value[a * k + b] = value[a] * factor[b];
        size *= k;
    }
}

double kw_tensor_one(const kw_tensor *g, const int *j, const int *r, const double *x)
{
    double product = 1;

    for (int h = 0; h < g->D; h++)
        product *= kw_bspline_one(g->s[h], j[h], r ? r[h] : 0, x[h]);
    return product;
}

/* --- geometries --- */

/* The local functions of a batch of points, direction by direction. Directions that do not
   exist stand in front, as one function with the value 1. */
typedef struct local {
    int k[KW_TENSOR_D], n[KW_TENSOR_D], first[KW_TENSOR_D][BATCH];
    double factor[KW_TENSOR_D][BATCH * K]; /* k values a point */
} local;

static void find_local(const kw_tensor *g, const int *r, int points, const double *x,
                       local *l)
{
    int absent = KW_TENSOR_D - g->D;
    double line[BATCH];

    for (int h = 0; h < absent; h++) {
        l->k[h] = l->n[h] = 1;
        for (int i = 0; i < points; i++) {
            l->first[h][i] = 0;
            l->factor[h][i] = 1;
        }
    }
    for (int h = absent; h < KW_TENSOR_D; h++) {
        const kw_bspline *s = g->s[h - absent];

        l->k[h] = s->d + 1;
        l->n[h] = s->n;
        for (int i = 0; i < points; i++)
            line[i] = x[i * g->D + h - absent];
        univariate_many(s, r ? r[h - absent] : 0, points, line, l->first[h],
                        l->factor[h]);
    }
}

/* The geometry at these points, line by line of the k functions of the last direction. */
static inline void sum_up(const local *l, int points, int k, int N,
                          const double *restrict c, double *restrict point)
{
    size_t step = (size_t)l->n[2] * (size_t)N;

    for (int i = 0; i < points; i++, point += N) {
        const double *f0 = l->factor[0] + i * l->k[0], *f1 = l->factor[1] + i * l->k[1];

        for (int a = 0; a < N; a++)
            point[a] = 0;
        for (int i0 = 0; i0 < l->k[0]; i0++) {
            int plane = (l->first[0][i] + i0) * l->n[1] + l->first[1][i];
            const double *line =
                c + (size_t)(plane * l->n[2] + l->first[2][i]) * (size_t)N;

            for (int i1 = 0; i1 < l->k[1]; i1++, line += step)
                kw_combine_sized(1, f0[i0] * f1[i1], k, N, l->factor[2] + i * k, line,
                                 point);
        }
    }
}

void kw_tensor_point(const kw_tensor *g, int N, const double *c, const int *r,
                     const double *x, double *point)
{
    kw_tensor_point_many(g, N, c, r, 1, x, point);
}

void kw_tensor_point_many(const kw_tensor *g, int N, const double *c, const int *r,
                          int count, const double *x, double *point)
{
    local l;
    int points, k = g->s[g->D - 1]->d + 1;

    KW_NEED(N >= 1, "N = %d", N);
    KW_NEED(count >= 0, "%d points", count);
    for (; count > 0; count -= points, x += points * g->D, point += points * N) {
        points = count < BATCH ? count : BATCH;
        find_local(g, r, points, x, &l);
        if (k == 4 && N == 3)
            sum_up(&l, points, 4, 3, c, point);
        else if (k == 3 && N == 3)
            sum_up(&l, points, 3, 3, c, point);
        else
            sum_up(&l, points, k, N, c, point);
    }
}

/* --- one direction at a time: grids and refinement ---

   An array of shape outer x n x inner becomes one of shape outer x m x inner: each new
   line is a combination of k neighbouring old lines. */

typedef struct shape {
    size_t outer, inner; /* of direction h: what runs slower, what runs faster */
} shape;

/* A batch of lines: new line i+l = sum of weight[l*k + q] * old line (first[l] + q), q < k. */
static void combine_lines(shape around, size_t n, size_t m, size_t i, int lines,
                          const int *first, int k, const double *weight,
                          const double *restrict old, double *restrict new)
{
    for (size_t a = 0; a < around.outer; a++)
        for (int l = 0; l < lines; l++)
            kw_combine(k, (int)around.inner, weight + l * k,
                       old + (a * n + (size_t)first[l]) * around.inner,
                       new + (a * m + i + (size_t)l) * around.inner);
}

/* The directions before h have their new sizes, those behind it the old ones. */
static shape shape_around(const kw_tensor *g, int N, const int *sizes, int h)
{
    shape around = {1, (size_t)N};

    for (int i = 0; i < h; i++)
        around.outer *= (size_t)sizes[i];
    for (int i = h + 1; i < g->D; i++)
        around.inner *= (size_t)g->s[i]->n;
    return around;
}

/* the numbers between the first direction and the last: after direction 0, after 1 */
static size_t work_size(const kw_tensor *g, int N, const int *sizes)
{
    size_t size = 0;

    for (int h = 0; h + 1 < g->D; h++) {
        shape around = shape_around(g, N, sizes, h);

        size += around.outer * (size_t)sizes[h] * around.inner;
    }
    return size;
}

static void need_counts(const kw_tensor *g, const int *count)
{
    for (int h = 0; h < g->D; h++)
        KW_NEED(count[h] >= 0, "%d points in direction %d", count[h], h);
}

size_t kw_tensor_grid_work(const kw_tensor *g, int N, const int *count)
{
    need_counts(g, count);
    return work_size(g, N, count);
}

void kw_tensor_grid(const kw_tensor *g, int N, const double *c, const int *r,
                    const int *count, const double *const *x, double *work, double *point)
{
    const double *old = c;

    KW_NEED(N >= 1, "N = %d", N);
    need_counts(g, count);
    for (int h = 0; h < g->D; h++) {
        shape around = shape_around(g, N, count, h);
        size_t m = (size_t)count[h];
        double *next = h + 1 == g->D ? point : work;

        for (size_t i = 0; i < m; i += BATCH) {
            double value[BATCH * K];
            int first[BATCH], lines = m - i < BATCH ? (int)(m - i) : BATCH;

            univariate_many(g->s[h], r ? r[h] : 0, lines, x[h] + i, first, value);
            combine_lines(around, (size_t)g->s[h]->n, m, i, lines, first, g->s[h]->d + 1,
                          value, old, next);
        }
        old = next;
        work = next + m * around.outer * around.inner;
    }
}

static void dimensions(const kw_tensor *g, int *n)
{
    for (int h = 0; h < g->D; h++)
        n[h] = g->s[h]->n;
}

size_t kw_tensor_refine_work(const kw_tensor *g, const kw_tensor *fine, int N)
{
    int n[KW_TENSOR_D];

    dimensions(fine, n);
    return work_size(g, N, n);
}

void kw_tensor_refine(const kw_tensor *g, const kw_tensor *fine, int N, const double *c,
                      double *work, double *out)
{
    const double *old = c;
    int n[KW_TENSOR_D];

    KW_NEED(N >= 1, "N = %d", N);
    KW_NEED(g->D == fine->D, "%d and %d directions", g->D, fine->D);
    dimensions(fine, n);
    for (int h = 0; h < g->D; h++) {
        shape around = shape_around(g, N, n, h);
        size_t m = (size_t)n[h];
        double *next = h + 1 == g->D ? out : work;

        kw_insert_need_nested(g->s[h], fine->s[h]);
        for (size_t i = 0; i < m; i++) {
            double alpha[K];
            int first = kw_insert_oslo_row(g->s[h], fine->s[h], (int)i, alpha);

            combine_lines(around, (size_t)g->s[h]->n, m, i, 1, &first, g->s[h]->d + 1,
                          alpha, old, next);
        }
        old = next;
        work = next + m * around.outer * around.inner;
    }
}
