/* The matrices of a graph against double loops. Weights are small integers, so sums and
   products are exact; where a quotient or a root enters, its rounding is counted. */
#include "graphmatrix.h"
#include "graphs.h"
#include "test.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { GRAPHS = 300, CHANNELS = 3 };

static const double U = DBL_EPSILON / 2;

typedef kw_graphmatrix *maker(const kw_graph *g);

/* Entry (i,j) by its formula in the header, from the dense adjacency matrix. */
typedef double formula(int n, const double *A, int i, int j);

static double row_sum(int n, const double *A, int i)
{
    double sum = 0;

    for (int j = 0; j < n; j++)
        sum += A[i * n + j];
    return sum;
}

static double adjacency(int n, const double *A, int i, int j)
{
    return A[i * n + j];
}

static double laplacian(int n, const double *A, int i, int j)
{
    return (i == j ? row_sum(n, A, i) : 0) - A[i * n + j];
}

static double normalized(int n, const double *A, int i, int j)
{
    return (i == j) - 1 / sqrt(row_sum(n, A, i)) * A[i * n + j] / sqrt(row_sum(n, A, j));
}

static double mean(int n, const double *A, int i, int j)
{
    return A[i * n + j] / row_sum(n, A, i);
}

static double renormalized(int n, const double *A, int i, int j)
{
    return 1 / sqrt(row_sum(n, A, i) + 1) * (A[i * n + j] + (i == j)) /
           sqrt(row_sum(n, A, j) + 1);
}

static const struct {
    maker *make;
    formula *entry;
    int symmetric, roundings; /* of the formula and of the library together */
    int isolated;             /* takes isolated nodes */
} MATRIX[] = {{kw_graphmatrix_new_adjacency, adjacency, 1, 0, 1},
              {kw_graphmatrix_new_laplacian, laplacian, 1, 0, 1},
              /* root, quotient, product, root, quotient here; root, quotient there */
              {kw_graphmatrix_new_normalized, normalized, 1, 7, 0},
              {kw_graphmatrix_new_mean, mean, 0, 0, 0},
              {kw_graphmatrix_new_renormalized, renormalized, 1, 7, 1}};

enum { KINDS = sizeof MATRIX / sizeof *MATRIX };

static void entries_follow_the_formulas(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(411, 0, sample, 0);
        double A[MOST * MOST], dense[MOST * MOST];

        for (int kind = 0; kind < KINDS; kind++) {
            kw_graph *g = graphs_random(&r, MATRIX[kind].isolated, A);
            kw_graphmatrix *M = MATRIX[kind].make(g);
            int n = g->n;

            kw_graphmatrix_dense(M, dense);
            for (int i = 0; i < n; i++)
                for (int j = 0; j < n; j++) {
                    double want = MATRIX[kind].entry(n, A, i, j), got = dense[i * n + j];

                    CHECK(fabs(got - want) <= MATRIX[kind].roundings * U * fabs(want),
                          "kind %d, entry %d, %d: %.17g, not %.17g", kind, i, j, got,
                          want);
                    CHECK(!MATRIX[kind].symmetric || got == dense[j * n + i],
                          "kind %d, entry %d, %d: %.17g and %.17g", kind, i, j, got,
                          dense[j * n + i]);
                    CHECK(!signbit(got) || got < 0, "kind %d, entry %d, %d: -0", kind, i,
                          j);
                }
            kw_graphmatrix_free(M);
            kw_graph_free(g);
        }
    }
}

/* Integer entries, integer signals: every order of the sums gives the same. */
static void products_are_double_loops(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(412, 0, sample, 0);
        double A[MOST * MOST], x[MOST * CHANNELS] = {0}, y[MOST * CHANNELS + 1];
        double back[MOST * CHANNELS + 1];
        kw_graph *g = graphs_random(&r, 1, A);
        kw_graphmatrix *M = kw_graphmatrix_new_laplacian(g);
        int n = g->n, channels = 1 + kw_rng_below(&r, CHANNELS);

        /* not symmetric: every entry of row i is multiplied by i + 1 */
        for (int i = 0; i < n; i++)
            for (int e = M->start[i]; e < M->start[i + 1]; e++)
                M->value[e] *= i + 1;
        for (int i = 0; i < n * channels; i++)
            x[i] = kw_rng_below(&r, 19) - 9;
        test_poison(y, MOST * CHANNELS + 1);
        test_poison(back, MOST * CHANNELS + 1);
        kw_graphmatrix_multiply(M, channels, x, y);
        kw_graphmatrix_multiply_transposed(M, channels, x, back);
        for (int i = 0; i < n; i++)
            for (int c = 0; c < channels; c++) {
                double sum = 0, transposed = 0;

                for (int j = 0; j < n; j++) {
                    sum += (i + 1) * laplacian(n, A, i, j) * x[j * channels + c];
                    transposed += (j + 1) * laplacian(n, A, j, i) * x[j * channels + c];
                }
                CHECK(y[i * channels + c] == sum, "%g, not %g", y[i * channels + c], sum);
                CHECK(back[i * channels + c] == transposed, "transposed: %g, not %g",
                      back[i * channels + c], transposed);
            }
        CHECK(isnan(y[n * channels]) && isnan(back[n * channels]), "written behind %d",
              n * channels);
        kw_graphmatrix_free(M);
        kw_graph_free(g);
    }
}

/* x'(D-A)x is the sum of w (x_i - x_j)^2 over the edges: integers. */
static void the_laplacian_measures_differences(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(413, 0, sample, 0);
        double A[MOST * MOST], x[MOST], y[MOST], form = 0, sum = 0;
        kw_graph *g = graphs_random(&r, 1, A);
        kw_graphmatrix *M = kw_graphmatrix_new_laplacian(g);

        for (int i = 0; i < g->n; i++)
            x[i] = kw_rng_below(&r, 19) - 9;
        kw_graphmatrix_multiply(M, 1, x, y);
        for (int i = 0; i < g->n; i++) {
            form += x[i] * y[i];
            for (int j = 0; j < i; j++)
                sum += A[i * g->n + j] * (x[i] - x[j]) * (x[i] - x[j]);
        }
        CHECK(form == sum, "%g, not %g", form, sum);
        kw_graphmatrix_free(M);
        kw_graph_free(g);
    }
}

static void a_shift_meets_the_diagonal_alone(void)
{
    kw_rng r = kw_rng_at(414, 0, 0, 0);
    double A[MOST * MOST], dense[MOST * MOST];
    kw_graph *g = graphs_random(&r, 1, A);
    kw_graphmatrix *M = kw_graphmatrix_new_adjacency(g);

    kw_graphmatrix_shift(M, -2);
    kw_graphmatrix_dense(M, dense);
    for (int i = 0; i < g->n; i++)
        for (int j = 0; j < g->n; j++)
            CHECK(dense[i * g->n + j] == A[i * g->n + j] - 2 * (i == j), "%d, %d", i, j);
    kw_graphmatrix_free(M);
    kw_graph_free(g);
}

static kw_graph *with_an_isolated_node(void)
{
    const int end[] = {0, 1};

    return kw_graph_new(3, 1, end, NULL);
}

static void isolated_mean(void)
{
    kw_graphmatrix_new_mean(with_an_isolated_node());
}

static void isolated_normalized(void)
{
    kw_graphmatrix_new_normalized(with_an_isolated_node());
}

static void no_channels(void)
{
    double x[3] = {0}, y[3];

    kw_graphmatrix_multiply(kw_graphmatrix_new_adjacency(with_an_isolated_node()), 0, x,
                            y);
}

static void no_channels_transposed(void)
{
    double x[3] = {0}, y[3];

    kw_graphmatrix_multiply_transposed(
        kw_graphmatrix_new_adjacency(with_an_isolated_node()), -1, x, y);
}

static void mistakes_are_named(void)
{
    test_aborts("node 2 has no neighbour", isolated_mean);
    test_aborts("node 2 has no neighbour", isolated_normalized);
    test_aborts("0 channels", no_channels);
    test_aborts("-1 channels", no_channels_transposed);
    kw_graphmatrix_free(NULL);
}

int main(void)
{
    test_run("graphmatrix: entries follow their formulas", entries_follow_the_formulas);
    test_run("graphmatrix: products are double loops", products_are_double_loops);
    test_run("graphmatrix: the Laplacian measures differences along edges",
             the_laplacian_measures_differences);
    test_run("graphmatrix: a shift meets the diagonal alone",
             a_shift_meets_the_diagonal_alone);
    test_run("graphmatrix: mistakes abort and are named", mistakes_are_named);
    return test_end();
}
