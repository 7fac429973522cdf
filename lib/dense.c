#include "dense.h"
#include "need.h"
#include <float.h>
#include <math.h>

/* 8 r^3 u, see the header; DBL_EPSILON is 2 u */
static double tolerance(int r)
{
    return 4.0 * r * r * r * DBL_EPSILON;
}

static double largest(int count, const double *a)
{
    double most = 0;

    for (int i = 0; i < count; i++) {
        KW_NEED(isfinite(a[i]), "entry %d is %g", i, a[i]);
        most = fmax(most, fabs(a[i]));
    }
    return most;
}

static void swap(double *a, double *b)
{
    double c = *a;

    *a = *b;
    *b = c;
}

static void swap_rows(int n, double *A, int i, int j)
{
    for (int c = 0; i != j && c < n; c++)
        swap(&A[i * n + c], &A[j * n + c]);
}

static void swap_columns(int m, int n, double *A, int i, int j)
{
    for (int r = 0; i != j && r < m; r++)
        swap(&A[r * n + i], &A[r * n + j]);
}

/* row -= factor * pivot from column `from` on */
static void subtract(int n, int from, double factor, const double *restrict pivot,
                     double *restrict row)
{
    for (int c = from; c < n; c++)
        row[c] -= factor * pivot[c];
}

int kw_dense_rank(int m, int n, double *A, double *gap)
{
    int r = 0, steps = m < n ? m : n;
    double zero = tolerance(steps), least = 1;

    KW_NEED(m >= 0 && n >= 0, "%d x %d", m, n);
    for (int i = 0; i < m; i++) {
        double scale = largest(n, A + i * n);

        for (int j = 0; scale > 0 && j < n; j++)
            A[i * n + j] /= scale;
    }
    for (; r < steps; r++) {
        int row = r, column = r;
        double pivot;

        for (int i = r; i < m; i++)
            for (int j = r; j < n; j++)
                if (fabs(A[i * n + j]) > fabs(A[row * n + column])) {
                    row = i;
                    column = j;
                }
        pivot = fabs(A[row * n + column]);
        if (pivot <= zero)
            break;
        least = fmin(least, pivot);
        swap_rows(n, A, r, row);
        swap_columns(m, n, A, r, column);
        for (int i = r + 1; i < m; i++)
            subtract(n, r, A[i * n + r] / A[r * n + r], A + r * n, A + i * n);
    }
    *gap = least / zero;
    return r;
}

/* the upper triangle of A (n columns), B: n x rhs */
static void back_substitute(int n, int rhs, const double *A, double *B)
{
    for (int p = n - 1; p >= 0; p--) {
        for (int i = p + 1; i < n; i++)
            subtract(rhs, 0, A[p * n + i], B + i * rhs, B + p * rhs);
        for (int j = 0; j < rhs; j++)
            B[p * rhs + j] /= A[p * n + p];
    }
}

int kw_dense_solve(int n, int rhs, double *A, double *B)
{
    double zero;

    KW_NEED(n >= 1 && rhs >= 1, "n = %d, rhs = %d", n, rhs);
    zero = tolerance(n) * largest(n * n, A);
    for (int p = 0; p < n; p++) {
        int row = p;

        for (int i = p + 1; i < n; i++)
            if (fabs(A[i * n + p]) > fabs(A[row * n + p]))
                row = i;
        if (!(fabs(A[row * n + p]) > zero))
            return 1;
        swap_rows(n, A, p, row);
        swap_rows(rhs, B, p, row);
        for (int i = p + 1; i < n; i++) {
            double factor = A[i * n + p] / A[p * n + p];

            subtract(n, p, factor, A + p * n, A + i * n);
            subtract(rhs, 0, factor, B + p * rhs, B + i * rhs);
        }
    }
    back_substitute(n, rhs, A, B);
    return 0;
}

/* Applies I - 2 v v' / v'v to column j of B (m x n), where v is column p of A (m x nA)
   from row p on, with v'v = square. */
static void reflect(int m, int nA, const double *A, int p, double square, int n,
                    double *B, int j)
{
    double dot = 0;

    for (int i = p; i < m; i++)
        dot += A[i * nA + p] * B[i * n + j];
    for (int i = p; i < m; i++)
        B[i * n + j] -= 2 * dot / square * A[i * nA + p];
}

int kw_dense_least_squares(int m, int n, int rhs, double *A, double *B)
{
    double zero;

    KW_NEED(m >= n && n >= 1 && rhs >= 1, "m = %d, n = %d, rhs = %d", m, n, rhs);
    zero = tolerance(m) * largest(m * n, A);
    for (int p = 0; p < n; p++) {
        double scale = 0, norm, square = 0, diagonal;

        for (int i = p; i < m; i++)
            scale = fmax(scale, fabs(A[i * n + p]));
        if (!(scale > zero))
            return 1;
        /* the column over its largest entry, so that squares neither vanish nor overflow */
        for (int i = p; i < m; i++) {
            A[i * n + p] /= scale;
            square += A[i * n + p] * A[i * n + p];
        }
        norm = sqrt(square);
        /* v = column -+ norm e_p, the sign that does not cancel */
        diagonal = A[p * n + p] > 0 ? -norm : norm;
        square = 2 * norm * (norm + fabs(A[p * n + p]));
        A[p * n + p] -= diagonal;
        for (int j = p + 1; j < n; j++)
            reflect(m, n, A, p, square, n, A, j);
        for (int j = 0; j < rhs; j++)
            reflect(m, n, A, p, square, rhs, B, j);
        A[p * n + p] = diagonal * scale;
    }
    back_substitute(n, rhs, A, B);
    return 0;
}
