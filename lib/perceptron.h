/* perceptron.h -- the Perceptron: a decision between two classes, and the rule that learns it.

   A point p has m >= 1 features; its label x is +1 or -1. The parameters are one array
   w[0..m]: the weights, then the bias, as in an affine layer with one output (affine.h). A
   data set is P, count x m, row-major, with labels x[0..count-1]; count >= 1. Everything is
   made of + - * alone, so on small integers it is exact. Numbers that are not finite and labels
   that are none abort. [source text, Definition 9, (20), (21); Rosenblatt 1958] */
#ifndef KW_PERCEPTRON_H
#define KW_PERCEPTRON_H

/* The affine function (20): the sum of w_j p_j, plus the bias. */
double kw_perceptron_sum(int m, const double *w, const double *p);

/* The decision (21), +1 or -1: the sign of the sum, where zero counts as positive. */
int kw_perceptron_decide(int m, const double *w, const double *p);

/* One step of the rule: the error x - decision is -2, 0 or +2, and w becomes
   w + rate * error * (p, 1). Returns the error. rate > 0. */
int kw_perceptron_update(int m, double rate, const double *p, double x, double *w);

/* Applies the rule to one sample after the other, again and again, until a whole pass over the
   data makes no mistake, or `passes` >= 1 passes are over. Returns the number of mistakes, all
   passes together; *clean is the number of the pass (from 1) that made none, or 0 if there was
   none. w goes in as the start and comes out as what was learned. */
long long kw_perceptron_train(int m, int count, const double *P, const double *x,
                              double rate, int passes, double *w, int *clean);

/* The margin of w on the data: the least distance of a point (p, 1) of R^(m+1) from the plane
   through the origin with normal w, counted negative on the wrong side. w is not zero. */
double kw_perceptron_margin(int m, int count, const double *P, const double *x,
                            const double *w);

/* The most mistakes that training from w = 0 can make, at any rate and in any number of
   passes, on data that `u` separates: (R / margin of u)^2, R the largest norm of a point
   (p, 1). The margin of u must be positive. [Novikoff 1962] */
double kw_perceptron_bound(int m, int count, const double *P, const double *x,
                           const double *u);

#endif
