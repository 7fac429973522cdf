#include "matrix.h"
#include "need.h"
#include "wide.h"
#include <limits.h>
#include <stdalign.h>
#include <stddef.h>

/* B is read in panels of DEPTH x COLUMNS numbers, which stay in the fastest cache while every
   row of A passes. EIGHT rows of a panel are added to a row of C at once, so that an entry
   of C is loaded and stored once for so many products. With fewer than NARROW columns there
   is too little to be done at once. */
enum { DEPTH = 32, COLUMNS = 64, EIGHT = 8, NARROW = 8 };

/* A matrix or its transpose: entry (i,j) is at[i * row + j * column]. */
typedef struct view {
    const double *at;
    size_t row, column;
} view;

static view moved(view A, int i, int j)
{
    A.at += (size_t)i * A.row + (size_t)j * A.column;
    return A;
}

static view transposed(view A)
{
    return (view){A.at, A.column, A.row};
}

static void copy_panel(int depth, int columns, view B, double (*panel)[COLUMNS])
{
    for (int k = 0; k < depth; k++)
        for (int j = 0; j < columns; j++)
            panel[k][j] = B.at[(size_t)k * B.row + (size_t)j * B.column];
}

/* c = c + f[0] * b[0] + f[1] * b[1] + .., from left to right */
static inline void add_eight(int columns, const double *f,
                             const double (*restrict b)[COLUMNS], double *restrict c)
{
    for (int j = 0; j < columns; j++)
        c[j] = c[j] + f[0] * b[0][j] + f[1] * b[1][j] + f[2] * b[2][j] + f[3] * b[3][j] +
               f[4] * b[4][j] + f[5] * b[5][j] + f[6] * b[6][j] + f[7] * b[7][j];
}

/* c += a row of A, its depth entries a step apart, times the panel */
KW_WIDE static void add_row(int depth, int columns, const double *a, size_t step,
                            const double (*restrict panel)[COLUMNS], double *restrict c)
{
    int k = 0;

    for (; k + EIGHT <= depth; k += EIGHT) {
        double f[EIGHT];

        for (int q = 0; q < EIGHT; q++)
            f[q] = a[(size_t)(k + q) * step];
        if (columns == COLUMNS) /* a loop of known length without a rest */
            add_eight(COLUMNS, f, panel + k, c);
        else
            add_eight(columns, f, panel + k, c);
    }
    for (; k < depth; k++)
        for (int j = 0; j < columns; j++)
            c[j] += a[(size_t)k * step] * panel[k][j];
}

/* C += A times the panel; the rows of C are row apart, their entries column apart */
static void add_panel(int m, int depth, int columns, view A,
                      const double (*restrict panel)[COLUMNS], double *C, size_t row,
                      size_t column)
{
    alignas(64) double copy[COLUMNS];

    for (int i = 0; i < m; i++) {
        double *c = C + (size_t)i * row, *sum = column == 1 ? c : copy;

        for (int j = 0; j < columns && column != 1; j++)
            copy[j] = c[(size_t)j * column];
        add_row(depth, columns, A.at + (size_t)i * A.row, A.column, panel, sum);
        for (int j = 0; j < columns && column != 1; j++)
            c[(size_t)j * column] = copy[j];
    }
}

/* C += A B; the rows of C are row apart, their entries column apart */
static void add_product(int m, int n, int k, view A, view B, double *C, size_t row,
                        size_t column)
{
    alignas(64) double panel[DEPTH][COLUMNS];

    if (n < NARROW && n < m) {
        add_product(n, m, k, transposed(B), transposed(A), C, column, row);
        return;
    }
    for (int j = 0; j < n; j += COLUMNS)
        for (int p = 0; p < k; p += DEPTH) {
            int depth = k - p < DEPTH ? k - p : DEPTH;
            int columns = n - j < COLUMNS ? n - j : COLUMNS;

            copy_panel(depth, columns, moved(B, p, j), panel);
            add_panel(m, depth, columns, moved(A, 0, p), (const double(*)[COLUMNS])panel,
                      C + (size_t)j * column, row, column);
        }
}

static void need_shapes(int m, int n, int k)
{
    KW_NEED(m >= 1 && n >= 1 && k >= 1, "m = %d, n = %d, k = %d", m, n, k);
    KW_NEED(m <= INT_MAX / k && n <= INT_MAX / k && m <= INT_MAX / n,
            "m = %d, n = %d, k = %d: more than %d entries", m, n, k, INT_MAX);
}

void kw_matrix_add_ab(int m, int n, int k, const double *A, const double *B, double *C)
{
    need_shapes(m, n, k);
    add_product(m, n, k, (view){A, (size_t)k, 1}, (view){B, (size_t)n, 1}, C, (size_t)n,
                1);
}

void kw_matrix_add_atb(int m, int n, int k, const double *A, const double *B, double *C)
{
    need_shapes(m, n, k);
    add_product(m, n, k, (view){A, 1, (size_t)m}, (view){B, (size_t)n, 1}, C, (size_t)n,
                1);
}

void kw_matrix_add_abt(int m, int n, int k, const double *A, const double *B, double *C)
{
    need_shapes(m, n, k);
    add_product(m, n, k, (view){A, (size_t)k, 1}, (view){B, 1, (size_t)k}, C, (size_t)n,
                1);
}
