/* affine.h -- the affine layer y = W x + b, all units of a layer with all of the next.

   W is out x in, row-major: w_ij belongs to the edge from unit j to unit i; b has `out` numbers.
   The parameters are W, then b. [source text, (20), Definition 10] */
#ifndef KW_AFFINE_H
#define KW_AFFINE_H

typedef struct kw_affine {
    int in, out;
    int parameters; /* out in + out */
} kw_affine;

/* in, out >= 1, at most INT_MAX parameters */
kw_affine kw_affine_layer(int in, int out);

/* Where w_ij and b_i stand among the parameters; 0 <= i < out, 0 <= j < in. */
int kw_affine_weight(const kw_affine *l, int i, int j);
int kw_affine_bias(const kw_affine *l, int i);

/* x: count x in; y: count x out; count >= 1. Each y begins with its bias and takes its
   products in the order of j. */
void kw_affine_forward(const kw_affine *l, const double *w, int count, const double *x,
                       double *y);

/* From dy, count x out, the derivative of a number with respect to y, to those with respect
   to x and w: dx, count x in, is set (NULL: not wanted); to dw, of the shape of w, it is
   added, in the order of the samples. y is what kw_affine_forward wrote; it is not
   needed here. Arrays do not overlap. */
void kw_affine_backward(const kw_affine *l, const double *w, int count, const double *x,
                        const double *y, const double *dy, double *dx, double *dw);

#endif
