/* elementary.h -- exp, log, tanh and their like, the same bits everywhere.

   The functions of the system's libm differ from one system to the next. These are made of
   + - * /, comparisons and the bits of a double alone (with fabs, copysign, frexp and ldexp,
   which are exact). Against 80-bit arithmetic, at some 10^8 points over the whole range,
   their errors in units in the last place (ulp) were found to be at most

     exp 1.0   expm1 1.5   log 0.9   log1p 0.9   tanh 1.4   erf 2.0   erfc 7   sin, cos 0.8

   (tests/test_elementary.c holds that at fewer points). Zeros keep their sign where the
   function is odd; a NaN gives a NaN; what is too large becomes infinite, what is too small
   zero, by way of the subnormal numbers.
   [Muller: Elementary Functions, 3rd edition, 2016] is [Muller]. */
#ifndef KW_ELEMENTARY_H
#define KW_ELEMENTARY_H

double kw_exp(double x);
double kw_expm1(double x); /* exp(x) - 1, without cancellation */
double kw_log(double x);   /* natural; -infinity at 0, NaN below */
double kw_log1p(double x); /* log(1 + x), without cancellation */
double kw_tanh(double x);
double kw_erf(double x);  /* 2/sqrt(pi) times the integral of exp(-t^2) from 0 to x */
double kw_erfc(double x); /* 1 - erf(x), without cancellation */

/* |x| <= 2^19, which keeps the reduction by multiples of pi/2 short. */
double kw_sin(double x);
double kw_cos(double x);

/* y[i] = exp(x[i]) and tanh(x[i]), i < n, the same bits as one by one and several times
   faster. x and y do not overlap. */
void kw_exp_many(int n, const double *x, double *y);
void kw_tanh_many(int n, const double *x, double *y);

#endif
