#include "matrix.h"
#include "test.h"
#include <math.h>
#include <string.h>

enum { MOST = 140, ROOM = MOST * MOST };

typedef void product(int m, int n, int k, const double *A, const double *B, double *C);

/* The three products, and where their plain loops find entry (i,p) of the left factor and
   entry (p,j) of the right one. */
static const struct kernel {
    const char *name;
    product *add;
    int left_transposed, right_transposed;
} KERNELS[] = {
    {"AB", kw_matrix_add_ab, 0, 0},
    {"A'B", kw_matrix_add_atb, 1, 0},
    {"AB'", kw_matrix_add_abt, 0, 1},
};

static void plain_loops(const struct kernel *q, int m, int n, int k, const double *A,
                        const double *B, double *C)
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++)
            for (int p = 0; p < k; p++) {
                double a = q->left_transposed ? A[p * m + i] : A[i * k + p];
                double b = q->right_transposed ? B[j * k + p] : B[p * n + j];

                C[i * n + j] += a * b;
            }
}

static void fill(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = test_random_in(r, -1, 1);
}

static void compare(kw_rng *r, const struct kernel *q, int m, int n, int k)
{
    static double A[ROOM], B[ROOM], C[ROOM + 1], expected[ROOM + 1];
    int different = 0;

    fill(r, m * k, A);
    fill(r, k * n, B);
    fill(r, m * n + 1, C);
    memcpy(expected, C, sizeof C);
    plain_loops(q, m, n, k, A, B, expected);
    q->add(m, n, k, A, B, C);
    for (int i = 0; i <= m * n; i++)
        different += C[i] != expected[i];
    CHECK(different == 0, "%s, m = %d, n = %d, k = %d: %d numbers", q->name, m, n, k,
          different);
}

static void small_shapes(void)
{
    kw_rng r = kw_rng_at(71, 0, 0, 0);

    for (int q = 0; q < 3; q++)
        for (int m = 1; m <= 10; m++)
            for (int n = 1; n <= 10; n++)
                for (int k = 1; k <= 18; k++)
                    compare(&r, &KERNELS[q], m, n, k);
}

/* Sizes around those of the panels that the kernels cut matrices into. */
static void large_shapes(void)
{
    const int size[] = {1, 7, 8, 9, 31, 32, 33, 63, 64, 65, 127, 128, 129, MOST};
    enum { SIZES = sizeof size / sizeof *size };
    kw_rng r = kw_rng_at(72, 0, 0, 0);

    for (int turn = 0; turn < 150; turn++)
        compare(&r, &KERNELS[turn % 3], size[kw_rng_below(&r, SIZES)],
                size[kw_rng_below(&r, SIZES)], size[kw_rng_below(&r, SIZES)]);
}

/* 0 times infinity is NaN: nothing is left out because it looks like zero, and nothing that
   fills up a panel comes in. */
static void infinities_are_not_hidden(void)
{
    double A[] = {0, 1}, B[] = {INFINITY, 2, 3, 4, 5, 6}, C[3] = {0};

    kw_matrix_add_ab(1, 3, 2, A, B, C);
    CHECK(isnan(C[0]) && C[1] == 5 && C[2] == 6, "%g %g %g", C[0], C[1], C[2]);
}

/* --- misuse --- */

static double number[1];

static void no_rows(void)
{
    kw_matrix_add_ab(0, 1, 1, number, number, number);
}

static void no_columns(void)
{
    kw_matrix_add_atb(1, -1, 1, number, number, number);
}

static void no_products(void)
{
    kw_matrix_add_abt(1, 1, 0, number, number, number);
}

static void too_many(void)
{
    kw_matrix_add_ab(65536, 32768, 1, number, number, number);
}

static void shapes_are_positive(void)
{
    test_aborts("m = 0, n = 1, k = 1", no_rows);
    test_aborts("m = 1, n = -1, k = 1", no_columns);
    test_aborts("m = 1, n = 1, k = 0", no_products);
    test_aborts("m = 65536, n = 32768, k = 1: more than 2147483647 entries", too_many);
}

int main(void)
{
    test_run("matrix: small products are those of plain loops, bit by bit", small_shapes);
    test_run("matrix: large products are those of plain loops, bit by bit", large_shapes);
    test_run("matrix: infinities are not hidden", infinities_are_not_hidden);
    test_run("matrix: empty and too large matrices abort", shapes_are_positive);
    return test_end();
}
