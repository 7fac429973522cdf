/* eigen.h -- eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's method.

   Rotations in the planes of two coordinates make one entry off the diagonal zero after the
   other, row by row, sweep after sweep, until none is left that counts; what they do to the
   identity are the eigenvectors. Slow for large n (some ten sweeps of 6 n^3 operations), but
   short, and as accurate as any.
   [Golub, Van Loan: Matrix Computations, 4th edition, 2013, section 8.5] */
#ifndef KW_EIGEN_H
#define KW_EIGEN_H

/* The eigenvalues of A, n x n, symmetric: value[0..n-1], ascending; and the
   eigenvectors, of norm one and orthogonal: vector is n x n, ROW k belongs to value[k]. So
   with the rows as U^T, A = U diag(value) U^T. A is overwritten.

   The first entry of an eigenvector that is larger than 2^-26 in absolute value is
   positive. So the eigenvector of a simple eigenvalue is unique; those of a multiple one
   are some orthonormal basis of a space that is.

   Accuracy: they are exact for a matrix that differs from A by at most 14 s n u |A| in the
   Frobenius norm, u = 2^-53 and s the number of sweeps: in each of them n-1 times a set of
   disjoint planes is turned, on both sides, with seven roundings in cosine, product and
   sum.

   No entry of A may be larger than DBL_MAX / (4 n) in absolute value: rotations keep all of them
   below |A|, at most n times the largest, and twice that is formed on the way.

   Returns s, the sweeps in which something was turned. */
int kw_eigen_symmetric(int n, double *A, double *value, double *vector);

#endif
