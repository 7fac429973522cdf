/* loss.h -- losses: how far predictions are from their targets, and in which direction.

   All have one shape. y is count x out, a row of predictions a sample; target is count x
   out too; count, out >= 1. The value is the mean over the samples of the sum over a row. dy,
   count x out, is set to the derivative of that value with respect to y; NULL: not wanted.

   Targets are checked. Predictions are not: one that is NaN makes the value NaN, so that a
   training that has run away can be told from one that has not; where the value is NaN, dy may
   be any number (hinge and perceptron losses have -t / count there). Sums are taken in the order
   of the samples. */
#ifndef KW_LOSS_H
#define KW_LOSS_H

typedef double kw_loss(int count, int out, const double *y, const double *target,
                       double *dy);

/* (y - t)^2, for numbers; t is finite. Some authors have half of it. */
kw_loss kw_loss_squared;

/* Cross-entropy of a row of logits y: minus the sum of t_k log s_k, where the softmax
   s_k = exp(y_k) / (sum of all exp(y_j)) are the probabilities predicted for `out` >= 2 classes.
   A row of targets are the true ones, non-negative with a sum of one up to rounding: 1 for
   the sample's class and 0 for the others. [Goodfellow, Bengio, Courville, section 6.2.2.3] */
kw_loss kw_loss_cross_entropy;

/* --- two classes; each prediction decides for +1 or -1, its target, by its sign --- */

/* Cross-entropy of two classes with the logits y and 0: log(1 + exp(-t y)). */
kw_loss kw_loss_logistic;

/* max(0, 1 - t y): zero from a safe decision on. At the kink t y = 1 the derivative is 0.
   [Cortes, Vapnik 1995] */
kw_loss kw_loss_hinge;

/* The perceptron criterion max(0, -t y): how far on the wrong side. Its derivative is -t
   where the decision (21) is wrong and 0 where it is right; at y = 0, where both would do,
   the decision is +1. So a step of the perceptron's rule is one against the gradient.
   [Bishop: Pattern Recognition and Machine Learning, 2006, (4.54)] */
kw_loss kw_loss_perceptron;

#endif
