#include "eigen.h"
#include "need.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* More than any matrix needs: about log2 of n and a few more. */
enum { SWEEPS = 60 };

static void need_symmetric(int n, const double *A)
{
    KW_NEED(n >= 1, "n = %d", n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            KW_NEED(isfinite(A[i * n + j]), "entry (%d,%d) is %g", i, j, A[i * n + j]);
            KW_NEED(A[i * n + j] == A[j * n + i], "entry (%d,%d) is %g, (%d,%d) is %g", i,
                    j, A[i * n + j], j, i, A[j * n + i]);
        }
}

static double largest(int count, const double *a)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(a[i]));
    return most;
}

/* The tangent of the smaller of the two angles whose rotation makes entry (p,q) zero. [Golub,
   Van Loan, algorithm 8.5.1] */
static double tangent(int n, const double *A, int p, int q)
{
    double tau = (A[q * n + q] - A[p * n + p]) / (2 * A[p * n + q]);

    return (tau >= 0 ? 1 : -1) / (fabs(tau) + sqrt(1 + tau * tau));
}

/* (x, y) becomes (c x - s y, s x + c y), entry by entry. */
static void rotate_rows(int n, double c, double s, double *restrict x, double *restrict y)
{
    for (int i = 0; i < n; i++) {
        double kept = x[i];

        x[i] = c * kept - s * y[i];
        y[i] = s * kept + c * y[i];
    }
}

/* Rotates rows and columns p and q of A, and rows p and q of the eigenvectors. The columns are
   copies of the rows, so A stays symmetric bit by bit. */
static void rotate(int n, double *A, double *vector, int p, int q)
{
    double t = tangent(n, A, p, q), c = 1 / sqrt(1 + t * t), s = t * c;
    double pp = A[p * n + p] - t * A[p * n + q], qq = A[q * n + q] + t * A[p * n + q];

    rotate_rows(n, c, s, A + p * n, A + q * n);
    rotate_rows(n, c, s, vector + p * n, vector + q * n);
    A[p * n + p] = pp;
    A[q * n + q] = qq;
    A[p * n + q] = A[q * n + p] = 0;
    for (int i = 0; i < n; i++) {
        A[i * n + p] = A[p * n + i];
        A[i * n + q] = A[q * n + i];
    }
}

/* One rotation for each entry above the diagonal that is larger than `small`; how many. */
static int sweep(int n, double small, double *A, double *vector)
{
    int rotations = 0;

    for (int p = 0; p < n; p++)
        for (int q = p + 1; q < n; q++)
            if (!(fabs(A[p * n + q]) <= small)) {
                rotate(n, A, vector, p, q);
                rotations++;
            }
    return rotations;
}

static void swap_rows(int n, double *x, double *y)
{
    for (int i = 0; i < n; i++) {
        double kept = x[i];

        x[i] = y[i];
        y[i] = kept;
    }
}

/* Sorts by selection, eigenvalue and eigenvector together. */
static void sort(int n, double *value, double *vector)
{
    for (int k = 0; k < n; k++) {
        int least = k;

        for (int i = k + 1; i < n; i++)
            if (value[i] < value[least])
                least = i;
        if (least != k) {
            swap_rows(1, value + k, value + least);
            swap_rows(n, vector + k * n, vector + least * n);
        }
    }
}

/* Makes the first entry that is no rounding of zero positive. */
static void fix_sign(int n, double *vector)
{
    int i = 0;

    while (i < n - 1 && !(fabs(vector[i]) > 0x1p-26))
        i++;
    if (vector[i] < 0)
        for (int j = 0; j < n; j++)
            vector[j] = -vector[j];
}

int kw_eigen_symmetric(int n, double *A, double *value, double *vector)
{
    double most, small;
    int sweeps = 0;

    need_symmetric(n, A);
    most = largest(n * n, A);
    KW_NEED(most <= DBL_MAX / 4 / n, "n = %d, an entry of size %g", n, most);
    /* n^2 entries of this size are a matrix of norm n u |A| / 2 at most */
    small = most * DBL_EPSILON / 4;
    memset(vector, 0, (size_t)n * (size_t)n * sizeof *vector);
    for (int i = 0; i < n; i++)
        vector[i * n + i] = 1;
    while (sweep(n, small, A, vector) > 0)
        KW_NEED(++sweeps < SWEEPS, "n = %d: not diagonal after %d sweeps", n, SWEEPS);
    for (int i = 0; i < n; i++)
        value[i] = A[i * n + i];
    sort(n, value, vector);
    for (int k = 0; k < n; k++)
        fix_sign(n, vector + k * n);
    return sweeps;
}
