/* dense.h -- small dense linear algebra, for checks and small fits.

   Matrices are row-major: A is m x n, A[i*n + j], with at most INT_MAX
   entries. A and B are overwritten.
   [Golub, Van Loan: Matrix Computations, 4th edition, 2013] is [GvL]. */
#ifndef KW_DENSE_H
#define KW_DENSE_H

/* The rank of A by elimination with full pivoting, after each row has been divided by its
   largest entry. Returns the rank; *gap is the smallest pivot that counted divided by the
   tolerance, below which everything is taken for zero.

   The tolerance: elimination in floating point is exact for a matrix that differs from A
   by at most about 8 r^2 g u, r = min(m,n) steps of a few roundings u = 2^-53 on entries
   that have grown by g [GvL, section 3.3]. With the first pivot 1 and the growth under
   full pivoting of the order of r, what should be zero stays below 8 r^3 u. A gap of many
   powers of ten says that the rank does not hang on this estimate; a gap near one says
   that it does. */
int kw_dense_rank(int m, int n, double *A, double *gap);

/* Solves A X = B by elimination with row pivoting: A is n x n, B is n x rhs and becomes X.
   Returns 0, or 1 if a pivot is below 8 n^3 u times the largest entry of A, that is if A is
   singular as far as rounding can tell; then B is undefined. */
int kw_dense_solve(int n, int rhs, double *A, double *B);

/* Minimizes |A X - B| column by column by Householder reflections: A is m x n, m >= n, B is
   m x rhs; its first n rows become X, the norm of the others is the residual's. Returns 0,
   or 1 if the columns of A are dependent as far as rounding can tell (as above, m for n).
   [GvL, section 5.3] */
int kw_dense_least_squares(int m, int n, int rhs, double *A, double *B);

#endif
