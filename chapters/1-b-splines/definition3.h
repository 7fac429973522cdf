/* definition3.h -- Definition 3 as it is printed, for the drivers that read it closely. */
#ifndef DEFINITION3_H
#define DEFINITION3_H

#include <stddef.h>

/* K and N are the book's k and n: the functions are beta_0 .. beta_N. */
enum { K = 3, N = 4, SAMPLES = 48, KNOTS = N + K + 1 };

/* For which j does the printed text say beta_{j,1}(t_{n+1}) = 1? */
typedef enum reading { EVERY_J, J_IS_N, LAST_OF_ORDER_1, NONE, READINGS } reading;

/* The weight omega_{j,k}: word for word, with x/0 guarded, or without the condition
   `if x < t_{j+k-1}' (the usual form, guarded too). */
typedef enum weight { LITERAL, GUARDED, USUAL } weight;

/* How the definition is read. */
typedef struct rule {
    reading end;
    weight weight;
    const double *t; /* KNOTS of them */
    int *called;     /* unless NULL: called[j] becomes 1 if beta_{j,1} is asked for */
} rule;

static inline double omega(rule how, int j, int k, double x)
{
    double left = how.t[j], right = how.t[j + k - 1];

    if (how.weight != LITERAL && left == right)
        return 0;
    if (how.weight != USUAL && !(x < right))
        return 0;
    return (x - left) / (right - left);
}

/* beta_{j,k}(x) by Definition 3. */
static inline double printed(rule how, int j, int k, double x)
{
    if (k == 1) {
        int here = how.end == EVERY_J || (how.end == J_IS_N && j == N) ||
                   (how.end == LAST_OF_ORDER_1 && j == N + K - 1);

        if (how.called)
            how.called[j] = 1;
        if (x == how.t[N + 1] && here)
            return 1;
        return how.t[j] <= x && x < how.t[j + 1];
    }
    return omega(how, j, k, x) * printed(how, j, k - 1, x) +
           (1 - omega(how, j + 1, k, x)) * printed(how, j + 1, k - 1, x);
}

/* The sum of all functions. */
static inline double sum_printed(rule how, double x)
{
    double sum = 0;

    for (int j = 0; j <= N; j++)
        sum += printed(how, j, K, x);
    return sum;
}

/* Sample i of [a,b), 0 <= i < SAMPLES. */
static inline double sample(const double *t, int i)
{
    return t[K - 1] + (t[N + 1] - t[K - 1]) * i / SAMPLES;
}

#endif
