/* Eigenvalues in closed form, and what must hold for every symmetric matrix.

   Bounds: with at most SWEEPS sweeps, which are counted, value and vector are exact for a
   matrix that differs from A by 14 SWEEPS n u |A| in the Frobenius norm (eigen.h). An
   eigenvalue then is off by at most as much, and a residual too; the same product of
   rotations makes the rows orthonormal up to 7 SWEEPS n u. */
#include "eigen.h"
#include "graphmatrix.h"
#include "graphs.h"
#include "test.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 2 * MOST, SWEEPS = 10 };

static const double U = DBL_EPSILON / 2, PI = 3.14159265358979323846;

static double norm(int count, const double *a)
{
    double sum = 0;

    for (int i = 0; i < count; i++)
        sum += a[i] * a[i];
    return sqrt(sum);
}

static double backward(int n, const double *A)
{
    return 14 * SWEEPS * n * U * norm(n * n, A);
}

/* Ascending; A v = value v; rows orthonormal; signs as promised. */
static void check_pairs(int n, const double *A, const double *value, const double *vector)
{
    double orthogonal = 14 * SWEEPS * n * U, off = backward(n, A);

    for (int k = 0; k < n; k++) {
        const double *v = vector + (size_t)k * (size_t)n;
        double residual[SIDE];
        int i = 0;

        CHECK(k == 0 || value[k - 1] <= value[k], "%g, %g", value[k - 1], value[k]);
        for (int row = 0; row < n; row++) {
            residual[row] = -value[k] * v[row];
            for (int j = 0; j < n; j++)
                residual[row] += A[row * n + j] * v[j];
        }
        /* once for the pair, once for the loss of orthogonality, and n + 1 roundings here */
        CHECK(norm(n, residual) <= 2 * off + (n + 1) * U * norm(n * n, A),
              "pair %d of %d: %g", k, n, norm(n, residual));
        for (int l = 0; l < n; l++) {
            double dot = 0;

            for (int j = 0; j < n; j++)
                dot += v[j] * vector[l * n + j];
            CHECK(fabs(dot - (k == l)) <= orthogonal, "rows %d, %d: %g", k, l, dot);
        }
        while (i < n - 1 && fabs(v[i]) <= 0x1p-26)
            i++;
        CHECK(v[i] > 0, "pair %d of %d: entry %d is %g", k, n, i, v[i]);
    }
}

static void solve(int n, const double *A, double *value, double *vector)
{
    double work[SIDE * SIDE];
    int sweeps;

    memcpy(work, A, (size_t)n * (size_t)n * sizeof *A);
    test_poison(value, n);
    test_poison(vector, n * n);
    sweeps = kw_eigen_symmetric(n, work, value, vector);
    CHECK(sweeps <= SWEEPS, "%d sweeps", sweeps);
    check_pairs(n, A, value, vector);
}

/* Random entries; small integers, where eigenvalues repeat; low rank; all the scales. */
static void pairs_of_random_matrices(void)
{
    for (uint64_t sample = 0; sample < 400; sample++) {
        kw_rng r = kw_rng_at(421, 0, sample, 0);
        int n = 1 + kw_rng_below(&r, SIDE), kind = kw_rng_below(&r, 3);
        double A[SIDE * SIDE] = {0}, value[SIDE], vector[SIDE * SIDE];
        double scale = ldexp(1, kw_rng_below(&r, 600) - 300);

        for (int i = 0; i < n; i++)
            for (int j = 0; j <= i; j++) {
                double a = kind == 0   ? test_random_in(&r, -1, 1)
                           : kind == 1 ? kw_rng_below(&r, 3) - 1
                                       : (i % 3 + 1) * (j % 3 + 1);

                A[i * n + j] = A[j * n + i] = a * scale;
            }
        solve(n, A, value, vector);
    }
}

/* --- closed forms --- */

static int ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;

    return (*p > *q) - (*p < *q);
}

/* The eigenvalues of M are `want`, in any order; cosines and the entries of M have two
   roundings of numbers of at most 4 (2 d, d <= 2, or n <= SIDE for complete graphs). M is
   handed over. */
static void check_values(kw_graphmatrix *M, double *want, const char *name)
{
    double A[SIDE * SIDE], value[SIDE], vector[SIDE * SIDE];
    int n = M->n;

    kw_graphmatrix_dense(M, A);
    solve(n, A, value, vector);
    qsort(want, (size_t)n, sizeof *want, ascending);
    for (int k = 0; k < n; k++)
        CHECK(fabs(value[k] - want[k]) <= backward(n, A) + 4 * U * norm(n * n, A),
              "%s, %d nodes: %.17g, not %.17g", name, n, value[k], want[k]);
    kw_graphmatrix_free(M);
}

static void paths(void)
{
    for (int n = 2; n <= SIDE; n++) {
        kw_graph *g = graphs_path(n);
        double want[SIDE];

        for (int k = 0; k < n; k++)
            want[k] = 2 - 2 * cos(PI * k / n);
        check_values(kw_graphmatrix_new_laplacian(g), want, "path");
        for (int k = 0; k < n; k++)
            want[k] = 1 - cos(PI * k / (n - 1));
        check_values(kw_graphmatrix_new_normalized(g), want, "path, normalized");
        for (int k = 0; k < n; k++)
            want[k] = 2 * cos(PI * (k + 1) / (n + 1));
        check_values(kw_graphmatrix_new_adjacency(g), want, "path, adjacency");
        kw_graph_free(g);
    }
}

static void cycles(void)
{
    for (int n = 3; n <= SIDE; n++) {
        kw_graph *g = graphs_cycle(n);
        double want[SIDE];

        for (int k = 0; k < n; k++)
            want[k] = 2 - 2 * cos(2 * PI * k / n);
        check_values(kw_graphmatrix_new_laplacian(g), want, "cycle");
        for (int k = 0; k < n; k++)
            want[k] = 1 - cos(2 * PI * k / n);
        check_values(kw_graphmatrix_new_normalized(g), want, "cycle, normalized");
        for (int k = 0; k < n; k++)
            want[k] = (1 + 2 * cos(2 * PI * k / n)) / 3;
        check_values(kw_graphmatrix_new_renormalized(g), want, "cycle, renormalized");
        kw_graph_free(g);
    }
}

static void complete_graphs(void)
{
    for (int n = 2; n <= SIDE; n++) {
        kw_graph *g = graphs_complete(n);
        double want[SIDE];

        for (int k = 0; k < n; k++)
            want[k] = k > 0 ? n : 0;
        check_values(kw_graphmatrix_new_laplacian(g), want, "complete");
        for (int k = 0; k < n; k++)
            want[k] = k > 0 ? n / (n - 1.0) : 0;
        check_values(kw_graphmatrix_new_normalized(g), want, "complete, normalized");
        kw_graph_free(g);
    }
}

/* The spectrum says how many components there are, and bounds hold: [0,2] for the normalized
   Laplacian, whose trace is n, (-1,1] for the renormalized adjacency. */
static void spectra_of_random_graphs(void)
{
    for (uint64_t sample = 0; sample < 200; sample++) {
        kw_rng r = kw_rng_at(422, 0, sample, 0);
        double A[MOST * MOST], value[MOST], vector[MOST * MOST], off, trace = 0;
        kw_graph *g = graphs_random(&r, 1, A);
        int n = g->n, work[MOST], component[MOST], zeros = 0;
        kw_graphmatrix *L = kw_graphmatrix_new_laplacian(g),
                       *S = kw_graphmatrix_new_renormalized(g), *N;

        kw_graphmatrix_dense(L, A);
        off = backward(n, A);
        solve(n, A, value, vector);
        for (int k = 0; k < n; k++)
            zeros += value[k] <= off;
        CHECK(zeros == kw_graph_components(g, work, component), "%d", zeros);
        CHECK(fabs(value[0]) <= off, "%g", value[0]);
        kw_graphmatrix_dense(S, A);
        solve(n, A, value, vector);
        CHECK(value[0] > -1, "%g", value[0]);
        CHECK(fabs(value[n - 1] - 1) <= backward(n, A), "%g", value[n - 1]);
        kw_graphmatrix_free(L);
        kw_graphmatrix_free(S);
        kw_graph_free(g);

        g = graphs_random(&r, 0, A);
        n = g->n;
        N = kw_graphmatrix_new_normalized(g);
        kw_graphmatrix_dense(N, A);
        off = backward(n, A);
        solve(n, A, value, vector);
        for (int k = 0; k < n; k++)
            trace += value[k];
        CHECK(value[0] >= -off && value[n - 1] <= 2 + off, "%g, %g", value[0],
              value[n - 1]);
        CHECK(fabs(trace - n) <= n * (off + 2 * n * U), "%g of %d", trace, n);
        kw_graphmatrix_free(N);
        kw_graph_free(g);
    }
}

/* The path's eigenvectors cos(pi k (i + 1/2) / n), scaled to one, are unique but for the
   sign: |v - want| is at most the error of the matrix by the gap between eigenvalues (times
   root 2 from sine to chord; 2 for the higher orders). */
static void eigenvectors_of_a_path(void)
{
    for (int n = 2; n <= SIDE; n++) {
        kw_graph *g = graphs_path(n);
        kw_graphmatrix *M = kw_graphmatrix_new_laplacian(g);
        double A[SIDE * SIDE], value[SIDE], vector[SIDE * SIDE];
        double gap = 2 - 2 * cos(PI / n);

        kw_graphmatrix_dense(M, A);
        solve(n, A, value, vector);
        for (int k = 0; k < n; k++) {
            double off[SIDE] = {0}, want[SIDE] = {0}, length;

            for (int i = 0; i < n; i++)
                want[i] = cos(PI * k * (i + 0.5) / n);
            length = norm(n, want);
            for (int i = 0; i < n; i++)
                off[i] = vector[k * n + i] - want[i] / length;
            CHECK(norm(n, off) <= 2 * sqrt(2) * backward(n, A) / gap,
                  "eigenvector %d of %d: off by %g", k, n, norm(n, off));
        }
        kw_graphmatrix_free(M);
        kw_graph_free(g);
    }
}

/* Nothing to rotate: entries come out as they are. */
static void diagonal_matrices_are_sorted(void)
{
    double A[] = {3, 0, 0, 0, -1, 0, 0, 0, 2}, value[3], vector[9];
    double zero[] = {0, 0, 0, 0}, one[] = {-5};

    solve(3, A, value, vector);
    CHECK(value[0] == -1 && value[1] == 2 && value[2] == 3, "%g, %g, %g", value[0],
          value[1], value[2]);
    CHECK(vector[1] == 1 && vector[5] == 1 && vector[6] == 1, "%g, %g, %g", vector[1],
          vector[5], vector[6]);
    solve(2, zero, value, vector);
    CHECK(value[0] == 0 && value[1] == 0, "%g, %g", value[0], value[1]);
    solve(1, one, value, vector);
    CHECK(kw_eigen_symmetric(1, one, value, vector) == 0, "%g", one[0]);
    CHECK(value[0] == -5 && vector[0] == 1, "%g, %g", value[0], vector[0]);
}

/* (2 1; 1 2): one rotation by 45 degrees. */
static void one_rotation(void)
{
    double A[] = {2, 1, 1, 2}, value[2], vector[4];

    solve(2, A, value, vector);
    CHECK(value[0] == 1 && value[1] == 3, "%.17g, %.17g", value[0], value[1]);
    CHECK(vector[0] == -vector[1] && vector[2] == vector[3], "%g, %g, %g, %g", vector[0],
          vector[1], vector[2], vector[3]);
}

/* Near the bound nothing overflows. */
static void large_entries(void)
{
    double A[] = {3, 1, 1, 3}, value[2], vector[4];

    for (int i = 0; i < 4; i++)
        A[i] *= ldexp(1, 1019); /* 3 2^1019 is below 2^1021, the bound for n = 2 */
    CHECK(kw_eigen_symmetric(2, A, value, vector) == 1, "%g", value[0]);
    CHECK(value[0] == ldexp(1, 1020) && value[1] == ldexp(1, 1021), "%g, %g", value[0],
          value[1]);
}

static void too_large(void)
{
    double A[] = {1.5e308, 1e308, 1e308, -1.5e308}, value[2], vector[4];

    kw_eigen_symmetric(2, A, value, vector);
}

static void unequal(void)
{
    double A[] = {1, 2, 3, 4}, value[2], vector[4];

    kw_eigen_symmetric(2, A, value, vector);
}

static void not_a_number(void)
{
    double A[] = {1, NAN, NAN, 4}, value[2], vector[4];

    kw_eigen_symmetric(2, A, value, vector);
}

static void of_nothing(void)
{
    double A[1] = {1}, value[1], vector[1];

    kw_eigen_symmetric(0, A, value, vector);
}

static void mistakes_are_named(void)
{
    test_aborts("entry (1,0) is 3, (0,1) is 2", unequal);
    test_aborts("entry (1,0) is nan", not_a_number);
    test_aborts("n = 0", of_nothing);
    test_aborts("n = 2, an entry of size 1.5e+308", too_large);
}

int main(void)
{
    test_run("eigen: random matrices, ascending, orthonormal, signs fixed",
             pairs_of_random_matrices);
    test_run("eigen: paths in closed form", paths);
    test_run("eigen: cycles in closed form", cycles);
    test_run("eigen: complete graphs in closed form", complete_graphs);
    test_run("eigen: zeros count components, and spectra keep their bounds",
             spectra_of_random_graphs);
    test_run("eigen: the eigenvectors of a path are its cosines", eigenvectors_of_a_path);
    test_run("eigen: diagonal matrices are sorted, exactly",
             diagonal_matrices_are_sorted);
    test_run("eigen: one rotation", one_rotation);
    test_run("eigen: large entries", large_entries);
    test_run("eigen: mistakes abort and are named", mistakes_are_named);
    return test_end();
}
