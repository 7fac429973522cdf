/* test.h -- what the test programs share: named tests, checks with values, calls that must
   abort, and random spline spaces. */
#ifndef TEST_H
#define TEST_H

#include "bspline.h"
#include "rng.h"

/* Counts and prints a failure unless `condition` holds; a printf format with the values
   comes behind it. */
#define CHECK(condition, ...)                                                            \
    ((condition) ? (void)0 : test_failed(__FILE__, __LINE__, #condition, __VA_ARGS__))

void test_failed(const char *file, int line, const char *condition, const char *format,
                 ...) __attribute__((format(printf, 4, 5)));

/* Runs one test and prints `ok - name` or `not ok - name`. */
void test_run(const char *name, void (*test)(void));

/* The exit status of the program: 1 if a test failed. */
int test_end(void);

/* Fails unless call() aborts with a message on stderr that contains `text`. */
void test_aborts(const char *text, void (*call)(void));

/* A random space: degree 0 .. highest, 1 .. 6 spans of very different lengths, knots of
   every multiplicity up to k, open or with auxiliary knots 0, 1 or 2 times the neighbouring
   span apart. The caller frees. */
kw_bspline *test_random_space(kw_rng *r, int highest);

/* A random point of the domain; one in four is a knot, one in eight an end. */
double test_random_point(kw_rng *r, const kw_bspline *s);

/* A number in [low, high). */
double test_random_in(kw_rng *r, double low, double high);

/* Fills a[0..count-1] with NaN, so that what is not written shows. */
void test_poison(double *a, int count);

#endif
