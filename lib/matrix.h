/* matrix.h -- products of row-major matrices, added to what is there.

   Each entry of C begins with what it holds and takes its products one by one, in the order
   of the common index: the numbers are those of three plain loops, bit for bit, whatever the
   compiler makes of it. A, B and C have at least one row and one column and at most INT_MAX
   entries; C overlaps neither A nor B. */
#ifndef KW_MATRIX_H
#define KW_MATRIX_H

/* C += A B: A is m x k, B is k x n, C is m x n. */
void kw_matrix_add_ab(int m, int n, int k, const double *A, const double *B, double *C);

/* C += A^T B: A is k x m, B is k x n, C is m x n. */
void kw_matrix_add_atb(int m, int n, int k, const double *A, const double *B, double *C);

/* C += A B^T: A is m x k, B is n x k, C is m x n. */
void kw_matrix_add_abt(int m, int n, int k, const double *A, const double *B, double *C);

#endif
