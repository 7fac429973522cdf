#include "graphmatrix.h"
#include "need.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- making a matrix --- */

/* A + self I: the rows of the graph, each with its node put in its place. */
static kw_graphmatrix *new_rows(const kw_graph *g, double self)
{
    kw_graphmatrix *M = kw_need_memory(1, sizeof *M);
    int entries = 0;
    size_t room;

    KW_NEED(g->start[g->n] <= INT_MAX - g->n, "%d nodes and %d neighbours", g->n,
            g->start[g->n]);
    room = (size_t)g->start[g->n] + (size_t)g->n;
    M->n = g->n;
    M->start = kw_need_memory((size_t)g->n + 1, sizeof *M->start);
    M->column = kw_need_memory(room, sizeof *M->column);
    M->value = kw_need_memory(room, sizeof *M->value);
    for (int i = 0; i < g->n; i++) {
        int e = g->start[i];

        for (; e < g->start[i + 1] && g->to[e] < i; e++) {
            M->column[entries] = g->to[e];
            M->value[entries++] = g->weight[e];
        }
        M->column[entries] = i;
        M->value[entries++] = self;
        for (; e < g->start[i + 1]; e++) {
            M->column[entries] = g->to[e];
            M->value[entries++] = g->weight[e];
        }
        M->start[i + 1] = entries;
    }
    return M;
}

/* The degrees of all nodes plus `self`, none of which may be zero; the caller frees. */
static double *new_degrees(const kw_graph *g, double self)
{
    double *degree = kw_need_memory((size_t)g->n, sizeof *degree);

    kw_graph_degrees(g, degree);
    for (int i = 0; i < g->n; i++) {
        degree[i] += self;
        KW_NEED(degree[i] > 0, "node %d has no neighbour", i);
    }
    return degree;
}

/* Divides entry (i,j) by the root of degree[i] degree[j]. One root of the product: where the
   degrees are equal, the root is exact. */
static void normalize(kw_graphmatrix *M, const double *degree)
{
    for (int i = 0; i < M->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            M->value[e] /= sqrt(degree[i] * degree[M->column[e]]);
}

static void negate(kw_graphmatrix *M)
{
    for (int e = 0; e < M->start[M->n]; e++)
        M->value[e] = 0 - M->value[e]; /* not -0 on the diagonal */
}

kw_graphmatrix *kw_graphmatrix_new_adjacency(const kw_graph *g)
{
    return new_rows(g, 0);
}

kw_graphmatrix *kw_graphmatrix_new_laplacian(const kw_graph *g)
{
    kw_graphmatrix *M = new_rows(g, 0);
    double *degree = kw_need_memory((size_t)g->n, sizeof *degree);

    kw_graph_degrees(g, degree);
    negate(M);
    for (int i = 0; i < g->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            if (M->column[e] == i)
                M->value[e] = degree[i];
    free(degree);
    return M;
}

kw_graphmatrix *kw_graphmatrix_new_normalized(const kw_graph *g)
{
    kw_graphmatrix *M = new_rows(g, 0);
    double *degree = new_degrees(g, 0);

    normalize(M, degree);
    negate(M);
    kw_graphmatrix_shift(M, 1);
    free(degree);
    return M;
}

kw_graphmatrix *kw_graphmatrix_new_mean(const kw_graph *g)
{
    kw_graphmatrix *M = new_rows(g, 0);
    double *degree = new_degrees(g, 0);

    for (int i = 0; i < g->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            M->value[e] /= degree[i];
    free(degree);
    return M;
}

kw_graphmatrix *kw_graphmatrix_new_renormalized(const kw_graph *g)
{
    kw_graphmatrix *M = new_rows(g, 1);
    double *degree = new_degrees(g, 1);

    normalize(M, degree);
    free(degree);
    return M;
}

void kw_graphmatrix_free(kw_graphmatrix *M)
{
    if (!M)
        return;
    free(M->start);
    free(M->column);
    free(M->value);
    free(M);
}

/* --- using them --- */

void kw_graphmatrix_shift(kw_graphmatrix *M, double c)
{
    for (int i = 0; i < M->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            if (M->column[e] == i)
                M->value[e] += c;
}

/* y += a x */
static void add_row(int channels, double a, const double *restrict x, double *restrict y)
{
    for (int c = 0; c < channels; c++)
        y[c] += a * x[c];
}

void kw_graphmatrix_multiply(const kw_graphmatrix *M, int channels, const double *x,
                             double *y)
{
    KW_NEED(channels >= 1, "%d channels", channels);
    memset(y, 0, (size_t)M->n * (size_t)channels * sizeof *y);
    for (int i = 0; i < M->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            add_row(channels, M->value[e], x + M->column[e] * channels, y + i * channels);
}

void kw_graphmatrix_multiply_transposed(const kw_graphmatrix *M, int channels,
                                        const double *x, double *y)
{
    KW_NEED(channels >= 1, "%d channels", channels);
    memset(y, 0, (size_t)M->n * (size_t)channels * sizeof *y);
    for (int i = 0; i < M->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            add_row(channels, M->value[e], x + i * channels, y + M->column[e] * channels);
}

void kw_graphmatrix_dense(const kw_graphmatrix *M, double *dense)
{
    memset(dense, 0, (size_t)M->n * (size_t)M->n * sizeof *dense);
    for (int i = 0; i < M->n; i++)
        for (int e = M->start[i]; e < M->start[i + 1]; e++)
            dense[i * M->n + M->column[e]] = M->value[e];
}
