#include "dense.h"
#include "test.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST = 12 }; /* rows and columns of the random matrices */

static const double U = DBL_EPSILON / 2; /* one rounding, relative */

/* the tolerance that dense.h states */
static double tolerance(int r)
{
    return 8.0 * r * r * r * U;
}

/* --- matrices --- */

/* A multiple of 1/8 in [-1,1]: sums of a few products of two are exact. */
static double eighth(kw_rng *r)
{
    return (kw_rng_below(r, 17) - 8) / 8.0;
}

static void swap_lines(double *a, int count, int step, int i, int j)
{
    for (int k = 0; k < count; k++) {
        double kept = a[i + k * step];

        a[i + k * step] = a[j + k * step];
        a[j + k * step] = kept;
    }
}

/* P, m x r, m >= r: r rows are those of the identity, the others random multiples of 1/8,
   all shuffled. P'P = I + R'R, so no singular value is below 1. */
static void tall(kw_rng *random, int m, int r, double *P)
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j < r; j++)
            P[i * r + j] = i < r ? i == j : eighth(random);
    for (int i = 0; i < m; i++)
        swap_lines(P, r, 1, i * r, kw_rng_below(random, m) * r);
}

/* C = A B: (m x k) (k x n) */
static void multiply(int m, int k, int n, const double *A, const double *B, double *C)
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++) {
            C[i * n + j] = 0;
            for (int q = 0; q < k; q++)
                C[i * n + j] += A[i * k + q] * B[q * n + j];
        }
}

/* B = A', A being m x n */
static void transpose(int m, int n, const double *A, double *B)
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++)
            B[j * m + i] = A[i * n + j];
}

static double largest(int count, const double *a)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(a[i]));
    return most;
}

static double norm(int count, const double *a, int step)
{
    double sum = 0;

    for (int i = 0; i < count; i++) {
        double entry = a[(size_t)i * (size_t)step];

        sum += entry * entry;
    }
    return sqrt(sum);
}

/* --- rank --- */

/* The product of an m x r and an r x n matrix of singular values >= 1 has its r-th singular
   value >= 1. A row is divided by at most r (entries are sums of r products <= 1), so after
   that it is >= 1/r. What is left before step q+1 differs from the scaled matrix by a
   matrix of rank q, so its norm is at least the (q+1)-th singular value (Eckart, Young) and
   its largest entry at least 1 / (r sqrt(m n)): a bound for every pivot that counts.
   Products are exact. */
static void a_product_has_its_rank(void)
{
    kw_rng random = kw_rng_at(51, 0, 0, 0);
    double P[MOST * MOST] = {0}, Q[MOST * MOST] = {0}, T[MOST * MOST], A[MOST * MOST];

    for (int round = 0; round < 1000; round++) {
        int m = 1 + kw_rng_below(&random, MOST), n = 1 + kw_rng_below(&random, MOST);
        int least = m < n ? m : n, r = 1 + kw_rng_below(&random, least), rank;
        double gap = NAN, wanted;

        tall(&random, m, r, P);
        tall(&random, n, r, T);
        transpose(n, r, T, Q);
        multiply(m, r, n, P, Q, A);
        rank = kw_dense_rank(m, n, A, &gap);
        wanted = 1 / (r * sqrt(m * n) * tolerance(least));
        CHECK(rank == r, "%d x %d: %d, not %d", m, n, rank, r);
        CHECK(gap >= wanted / 2, "%d x %d, rank %d: %g < %g", m, n, r, gap, wanted);
    }
}

/* Rank by fraction-free elimination (Bareiss): every entry is a minor of A, so all
   divisions are exact. With 7 rows of entries up to 2, minors are at most (2 sqrt 7)^7 < 2e5
   (Hadamard). */
static int exact_rank(int m, int n, long long *A)
{
    long long before = 1;
    int r = 0;

    for (int column = 0; column < n && r < m; column++) {
        int row = r;

        while (row < m && A[row * n + column] == 0)
            row++;
        if (row == m)
            continue;
        for (int j = 0; j < n; j++) {
            long long kept = A[row * n + j];

            A[row * n + j] = A[r * n + j];
            A[r * n + j] = kept;
        }
        for (int i = r + 1; i < m; i++) {
            for (int j = column + 1; j < n; j++)
                A[i * n + j] = (A[r * n + column] * A[i * n + j] -
                                A[i * n + column] * A[r * n + j]) /
                               before;
            A[i * n + column] = 0;
        }
        before = A[r * n + column];
        r++;
    }
    return r;
}

/* Entries -1 .. 1; some rows are the sum or the difference of the first two. */
static void integer_matrices_have_their_exact_rank(void)
{
    enum { SIDE = 7 };
    kw_rng random = kw_rng_at(52, 0, 0, 0);
    int seen[SIDE + 1] = {0};

    for (int round = 0; round < 2000; round++) {
        int m = 1 + kw_rng_below(&random, SIDE), n = 1 + kw_rng_below(&random, SIDE);
        int rank, exact;
        long long whole[SIDE * SIDE] = {0};
        double A[SIDE * SIDE], gap;

        for (int i = 0; i < m; i++) {
            int dependent = i >= 2 && kw_rng_below(&random, 3) == 0;
            int sign = kw_rng_below(&random, 2) ? 1 : -1;

            for (int j = 0; j < n; j++)
                whole[i * n + j] = dependent ? whole[j] + sign * whole[n + j]
                                             : kw_rng_below(&random, 3) - 1;
        }
        for (int i = 0; i < m * n; i++)
            A[i] = (double)whole[i];
        exact = exact_rank(m, n, whole);
        rank = kw_dense_rank(m, n, A, &gap);
        CHECK(rank == exact, "%d x %d: %d, not %d (gap %g)", m, n, rank, exact, gap);
        seen[exact]++;
    }
    for (int r = 1; r <= SIDE; r++)
        CHECK(seen[r] > 0, "no matrix of rank %d", r);
}

static void nothing_has_rank_zero(void)
{
    double zeros[12] = {0}, none[1] = {5}, gap = NAN;

    for (int m = 1; m <= 4; m++) {
        CHECK(kw_dense_rank(m, 3, zeros, &gap) == 0, "%d x 3", m);
        CHECK(gap >= 1e12, "%g", gap);
        CHECK(kw_dense_rank(m, 0, none, &gap) == 0, "%d x 0", m);
        CHECK(kw_dense_rank(0, m, none, &gap) == 0, "0 x %d", m);
    }
    CHECK(kw_dense_rank(0, 0, none, &gap) == 0, "0 x 0");
    CHECK(kw_dense_rank(1, 1, none, &gap) == 1, "1 x 1");
}

/* Rows are scaled: one of 1e-200 counts as one of 1e200 does, beside a row of zeros. */
static void rank_does_not_see_the_scale_of_a_row(void)
{
    double A[] = {1e200, 2e200, 3e200, 0, 0, 0, 1e-200, 2e-200, 4e-200}, gap = NAN;

    CHECK(kw_dense_rank(3, 3, A, &gap) == 2, "gap %g", gap);
    CHECK(gap > 1e10, "%g", gap);
}

/* (1 1; 1 1+e): the second pivot is e up to the rounding of 1/(1+e). */
static void a_borderline_gap_is_near_one(void)
{
    double e = 1.5 * tolerance(2), A[] = {1, 1, 1, 1 + e}, B[] = {1, 1, 1, 1 + e / 3};
    double gap = NAN;

    CHECK(kw_dense_rank(2, 2, A, &gap) == 2, "gap %g", gap);
    CHECK(1 <= gap && gap <= 2, "%g", gap);
    CHECK(kw_dense_rank(2, 2, B, &gap) == 1, "gap %g", gap);
}

/* --- solving --- */

/* Off the diagonal [-1,1], on it 2n: dominant by rows and by columns, so entries at most
   double under elimination, and |A^-1| <= 1 / (n+1). The rows are shuffled. */
static void dominant(kw_rng *random, int n, double *A)
{
    for (int i = 0; i < n * n; i++)
        A[i] = i / n == i % n ? 2 * n : eighth(random);
    for (int i = 0; i < n; i++)
        swap_lines(A, n, 1, i * n, kw_rng_below(random, n) * n);
}

/* x' solves (A+E) x' = b with |E| <= 8 n^3 g u |A| in the maximum norm of entries, g = 2
   here [GvL, section 3.4]; |A| <= 3n as an operator, and B = A X is exact. So the error is
   at most |A^-1| n |E| |X|, where n |E| <= 16 n^4 u 2n. */
static void solve_finds_a_known_solution(void)
{
    enum { RHS = 3 };
    kw_rng random = kw_rng_at(53, 0, 0, 0);
    double A[MOST * MOST] = {0}, X[MOST * RHS] = {0}, B[MOST * RHS] = {0};

    for (int round = 0; round < 500; round++) {
        int n = 1 + kw_rng_below(&random, MOST), rhs = 1 + kw_rng_below(&random, RHS);
        double bound = 32 * pow(n, 5) * U / (n + 1);

        dominant(&random, n, A);
        for (int i = 0; i < n * rhs; i++)
            X[i] = eighth(&random);
        multiply(n, n, rhs, A, X, B);
        CHECK(kw_dense_solve(n, rhs, A, B) == 0, "n = %d", n);
        for (int i = 0; i < n * rhs; i++)
            CHECK(fabs(B[i] - X[i]) <= bound, "n = %d: %g, not %g", n, B[i], X[i]);
    }
}

/* The residual of any regular matrix: |b - A x'| <= |E| |x'| as above with the largest
   growth there is under row pivoting, g = 2^(n-1). */
static void solve_leaves_a_small_residual(void)
{
    enum { SIDE = 8 };
    kw_rng random = kw_rng_at(54, 0, 0, 0);
    double A[SIDE * SIDE] = {0}, kept[SIDE * SIDE], B[SIDE], b[SIDE] = {0}, product[SIDE];

    for (int round = 0; round < 500; round++) {
        int n = 1 + kw_rng_below(&random, SIDE);
        double scale = ldexp(1, kw_rng_below(&random, 1200) - 600), bound;

        for (int i = 0; i < n * n; i++)
            A[i] = test_random_in(&random, -1, 1) * scale;
        for (int i = 0; i < n; i++)
            B[i] = b[i] = test_random_in(&random, -1, 1) * scale;
        memcpy(kept, A, sizeof A);
        CHECK(kw_dense_solve(n, 1, A, B) == 0, "n = %d", n);
        multiply(n, n, 1, kept, B, product);
        bound =
            8 * pow(n, 4) * ldexp(1, n - 1) * U * largest(n * n, kept) * largest(n, B);
        for (int i = 0; i < n; i++)
            CHECK(fabs(product[i] - b[i]) <= bound, "n = %d: %g > %g", n,
                  fabs(product[i] - b[i]), bound);
    }
}

static void a_singular_matrix_is_refused(void)
{
    kw_rng random = kw_rng_at(55, 0, 0, 0);
    double A[MOST * MOST], B[MOST], P[MOST * MOST], T[MOST * MOST], Q[MOST * MOST];
    double zero[] = {0, 0, 0, 0};

    for (int n = 2; n <= MOST; n++) {
        tall(&random, n, n - 1, P);
        tall(&random, n, n - 1, T);
        transpose(n, n - 1, T, Q);
        multiply(n, n - 1, n, P, Q, A);
        memset(B, 0, sizeof B);
        CHECK(kw_dense_solve(n, 1, A, B) == 1, "n = %d, rank n-1", n);

        dominant(&random, n, A);
        for (int i = 0; i < n; i++)
            A[i * n + n / 2] = 0;
        CHECK(kw_dense_solve(n, 1, A, B) == 1, "n = %d, a zero column", n);
    }
    CHECK(kw_dense_solve(2, 1, zero, B) == 1, "zero matrix");
}

/* Without pivoting the first step would divide by 1e-20 and lose the second row: x = (0, 1). */
static void solve_pivots(void)
{
    double A[] = {1e-20, 1, 1, 1}, B[] = {1, 2};

    CHECK(kw_dense_solve(2, 1, A, B) == 0, "refused");
    /* x = (1 / (1 - e), (1 - 2e) / (1 - e)), e = 1e-20: (1, 1) but for a few roundings */
    CHECK(fabs(B[0] - 1) <= 4 * U && fabs(B[1] - 1) <= 4 * U, "%.17g, %.17g", B[0], B[1]);
}

/* --- least squares --- */

/* Householder's X is exact for A + E and b + f with |E| <= e |A|, |f| <= e |b| in the
   Frobenius norm, e = (6m - 3n + 41) n u [GvL, section 5.3.3]. */
static double householder(int m, int n)
{
    return (6 * m - 3 * n + 41) * n * U;
}

/* With r = b - A x, 0 = (A+E)' (b + f - (A+E) x) gives, to first order,
   |A' r| <= |E| |r| + |A| (|f| + |E| |x|); 2 for the higher orders and for the rounding
   of the products formed here. */
static void the_residual_is_orthogonal(void)
{
    kw_rng random = kw_rng_at(56, 0, 0, 0);
    double A[MOST * MOST] = {0}, kept[MOST * MOST], B[MOST] = {0}, b[MOST], r[MOST] = {0};

    for (int round = 0; round < 500; round++) {
        int n = 1 + kw_rng_below(&random, MOST),
            m = n + kw_rng_below(&random, MOST - n + 1);
        double e = householder(m, n), size, bound;

        tall(&random, m, n, A);
        for (int i = 0; i < m; i++)
            B[i] = b[i] = test_random_in(&random, -1, 1);
        memcpy(kept, A, sizeof A);
        CHECK(kw_dense_least_squares(m, n, 1, A, B) == 0, "%d x %d", m, n);
        multiply(m, n, 1, kept, B, r);
        for (int i = 0; i < m; i++)
            r[i] = b[i] - r[i];
        size = norm(m * n, kept, 1);
        bound = 2 * e * size * (norm(m, r, 1) + norm(m, b, 1) + size * norm(n, B, 1));
        for (int j = 0; j < n; j++) {
            double dot = 0;

            for (int i = 0; i < m; i++)
                dot += kept[i * n + j] * r[i];
            CHECK(fabs(dot) <= bound, "%d x %d: %g > %g", m, n, dot, bound);
        }
        CHECK(fabs(norm(m - n, B + n, 1) - norm(m, r, 1)) <= bound, "%d x %d: %g, not %g",
              m, n, norm(m - n, B + n, 1), norm(m, r, 1));
    }
}

/* Where B = A X exactly and no singular value of A is below 1, the error of X is at most
   |f| + |E| |X|; 2 for the higher orders. Several right-hand sides. */
static void an_exact_fit_is_found(void)
{
    enum { RHS = 3 };
    kw_rng random = kw_rng_at(57, 0, 0, 0);
    double A[MOST * MOST] = {0}, X[MOST * RHS] = {0}, B[MOST * RHS] = {0};

    for (int round = 0; round < 500; round++) {
        int n = 1 + kw_rng_below(&random, MOST),
            m = n + kw_rng_below(&random, MOST - n + 1);
        int rhs = 1 + kw_rng_below(&random, RHS);
        double size, bound;

        tall(&random, m, n, A);
        for (int i = 0; i < n * rhs; i++)
            X[i] = eighth(&random);
        multiply(m, n, rhs, A, X, B);
        size = norm(m * n, A, 1);
        bound =
            2 * householder(m, n) * (norm(m * rhs, B, 1) + size * norm(n * rhs, X, 1));
        CHECK(kw_dense_least_squares(m, n, rhs, A, B) == 0, "%d x %d", m, n);
        for (int i = 0; i < n * rhs; i++)
            CHECK(fabs(B[i] - X[i]) <= bound, "%d x %d: %g, not %g", m, n, B[i], X[i]);
        for (int j = 0; j < rhs; j++)
            CHECK(m == n || norm(m - n, &B[n * rhs + j], rhs) <= bound,
                  "%d x %d: residual", m, n);
    }
}

/* The squares of these columns vanish or overflow; the fit is exact, X = 1. */
static void a_fit_does_not_see_the_scale(void)
{
    const double scales[] = {1e-300, 1e-170, 1, 1e160, 1e300};

    for (int i = 0; i < 5; i++) {
        double s = scales[i], A[] = {s, 2 * s}, B[] = {s, 2 * s};

        CHECK(kw_dense_least_squares(2, 1, 1, A, B) == 0, "scale %g", s);
        CHECK(fabs(B[0] - 1) <= 2 * householder(2, 1) * 5, "scale %g: %.17g", s, B[0]);
        CHECK(fabs(B[1]) <= 2 * householder(2, 1) * 5 * s, "scale %g: residual %g", s,
              B[1]);
    }
}

static void dependent_columns_are_refused(void)
{
    kw_rng random = kw_rng_at(58, 0, 0, 0);
    double A[MOST * MOST], B[MOST] = {0}, zero[3] = {0};

    for (int n = 2; n <= MOST; n++)
        for (int m = n; m <= MOST; m++) {
            tall(&random, m, n, A);
            for (int i = 0; i < m; i++) { /* the last column is the sum of others */
                double *row = A + (size_t)i * (size_t)n;

                row[n - 1] = row[0] + (m % 2 && n > 2 ? row[1] : 0);
            }
            CHECK(kw_dense_least_squares(m, n, 1, A, B) == 1, "%d x %d", m, n);
        }
    CHECK(kw_dense_least_squares(3, 1, 1, zero, B) == 1, "a zero column");
}

/* --- misuse --- */

static void rank_of_nan(void)
{
    double A[] = {1, 2, 3, NAN}, gap;

    kw_dense_rank(2, 2, A, &gap);
}

static void solve_with_infinity(void)
{
    double A[] = {1, 2, 3, -INFINITY}, B[] = {1, 1};

    kw_dense_solve(2, 1, A, B);
}

static void fit_with_nan(void)
{
    double A[] = {1, NAN, 3, 4}, B[] = {1, 1, 1, 1};

    kw_dense_least_squares(4, 1, 1, A, B);
}

static void fit_too_few_rows(void)
{
    double A[] = {1, 2}, B[] = {1};

    kw_dense_least_squares(1, 2, 1, A, B);
}

static void misuse_aborts(void)
{
    test_aborts("is nan", rank_of_nan);
    test_aborts("entry 3 is -inf", solve_with_infinity);
    test_aborts("entry 1 is nan", fit_with_nan);
    test_aborts("m = 1, n = 2", fit_too_few_rows);
}

int main(void)
{
    test_run("dense: a product has its rank, with a wide gap", a_product_has_its_rank);
    test_run("dense: integer matrices have their exact rank",
             integer_matrices_have_their_exact_rank);
    test_run("dense: zero and empty matrices have rank 0", nothing_has_rank_zero);
    test_run("dense: the rank does not see the scale of a row",
             rank_does_not_see_the_scale_of_a_row);
    test_run("dense: the gap of a borderline case is near one",
             a_borderline_gap_is_near_one);
    test_run("dense: solve finds a known solution", solve_finds_a_known_solution);
    test_run("dense: solve leaves a small residual at any scale",
             solve_leaves_a_small_residual);
    test_run("dense: solve pivots", solve_pivots);
    test_run("dense: a singular matrix is refused", a_singular_matrix_is_refused);
    test_run("dense: the residual of least squares is orthogonal to the columns",
             the_residual_is_orthogonal);
    test_run("dense: least squares finds an exact fit", an_exact_fit_is_found);
    test_run("dense: least squares does not see the scale", a_fit_does_not_see_the_scale);
    test_run("dense: dependent columns are refused", dependent_columns_are_refused);
    test_run("dense: NaN, infinity and impossible shapes abort", misuse_aborts);
    return test_end();
}
