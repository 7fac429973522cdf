/* Definition 3 -- the recursion as printed, beside the corrected one.

   What to see: transcribed word for word the recursion divides zero by zero, and at the
   right end of an open knot vector the sentence `beta_{j,1}(t_{n+1}) = 1' has three
   readings, of which two break the partition of unity or hand the end to a wrong function.

   Book: section 1.1, Remark 2, Definition 3 and the three key properties.
   Claims: bs.def3.*, bs.rem2.chain*, bs.list1.*
   Chosen here: order 3 on the knots 0,0,0,1,2,3,3,3, and random knots. */

#include "bspline.h"   /* the corrected recursion */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* columns for gnuplot */
#include "partition.h" /* random knots */
#include <math.h>

/* K and N are the book's k and n: the functions are beta_0 .. beta_N. */
enum { K = 3, N = 4, SAMPLES = 48, SPACES = 200 };

/* For which j does the printed text say beta_{j,1}(t_{n+1}) = 1? */
typedef enum reading { EVERY_J, LAST_OF_ORDER_1, J_IS_N, NONE, READINGS } reading;

/* The weight omega_{j,k}: word for word, with 0/0 guarded, or without the condition
   `if x < t_{j+k-1}' (the usual form, guarded too). */
typedef enum weight { LITERAL, GUARDED, USUAL } weight;

static double omega(weight w, const double *t, int j, int k, double x)
{
    double left = t[j], right = t[j + k - 1];

    if (w != LITERAL && left == right)
        return 0;
    if (w != USUAL && !(x < right))
        return 0;
    return (x - left) / (right - left);
}

/* beta_{j,k}(x) by Definition 3 under a reading and a weight. */
static double printed(reading r, weight w, const double *t, int j, int k, double x)
{
    if (k == 1) {
        int here = r == EVERY_J || (r == LAST_OF_ORDER_1 && j == N + K - 1) ||
                   (r == J_IS_N && j == N);

        if (x == t[N + 1] && here)
            return 1;
        return t[j] <= x && x < t[j + 1];
    }
    return omega(w, t, j, k, x) * printed(r, w, t, j, k - 1, x) +
           (1 - omega(w, t, j + 1, k, x)) * printed(r, w, t, j + 1, k - 1, x);
}

static double sum_printed(reading r, weight w, const double *t, double x)
{
    double sum = 0;

    for (int j = 0; j <= N; j++)
        sum += printed(r, w, t, j, K, x);
    return sum;
}

/* The index of the only function that is not zero at x, or -1. */
static int only_function(reading r, weight w, const double *t, double x)
{
    int index = -1;

    for (int j = 0; j <= N; j++)
        if (printed(r, w, t, j, K, x) != 0) {
            if (index >= 0)
                return -1;
            index = j;
        }
    return index;
}

/* Functions that the literal recursion makes NaN at every sample in [a,b). */
static int count_nan(const double *t)
{
    int count = 0;

    for (int j = 0; j <= N; j++) {
        int bad = 0;

        for (int i = 0; i < SAMPLES; i++)
            bad += isnan(printed(NONE, LITERAL, t, j, K,
                                 t[K - 1] + (t[N + 1] - t[K - 1]) * i / SAMPLES));
        count += bad == SAMPLES;
    }
    return count;
}

/* The largest difference from the library on [a,b) once 0/0 counts as 0. */
static double worst_guarded(const double *t)
{
    kw_bspline *s = kw_bspline_new(K - 1, N + 1, t);
    double worst = 0;

    for (int i = 0; i < SAMPLES; i++) {
        double x = t[K - 1] + (t[N + 1] - t[K - 1]) * i / SAMPLES;

        for (int j = 0; j <= N; j++)
            worst = fmax(worst, fabs(printed(NONE, GUARDED, t, j, K, x) -
                                     kw_bspline_one(s, j, 0, x)));
    }
    kw_bspline_free(s);
    return worst;
}

/* The values at the right end of each function: one block for each reading, and one for
   the library's. */
static void write_right_end(kw_out *f, const double *t, const kw_bspline *s)
{
    kw_out_section(f, "right end", "function value");
    for (int r = 0; r < READINGS; r++) {
        for (int j = 0; j <= N; j++) {
            kw_out_number(f, j);
            kw_out_number(f, r == NONE ? kw_bspline_one(s, j, 0, t[N + 1])
                                       : printed((reading)r, GUARDED, t, j, K, t[N + 1]));
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
}

static void report_readings(kw_out *report, const double *open)
{
    /* the same domain with simple end knots; and t_{n+k} elsewhere, as Remark 2 allows */
    const double not_open[N + K + 1] = {-2, -1, 0, 1, 2, 3, 4, 5};
    const double chain[N + K + 1] = {0, 0, 0, 1, 2, 3, 3, 7};
    double b = open[N + 1], least = 0, change = 0;

    for (int j = 0; j <= N; j++)
        least = fmin(least, printed(EVERY_J, USUAL, open, j, K, b));
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j <= N; j++)
            change =
                fmax(change, fabs(printed(NONE, GUARDED, chain, j, K, b * i / SAMPLES) -
                                  printed(NONE, GUARDED, open, j, K, b * i / SAMPLES)));

    kw_claim_count(report, "bs.def3.nan", count_nan(open));
    kw_claim_real(report, "bs.def3.guarded", worst_guarded(open));
    kw_claim_real(report, "bs.def3.end.every", sum_printed(EVERY_J, GUARDED, open, b));
    kw_claim_real(report, "bs.def3.end.every.least", least);
    kw_claim_count(report, "bs.def3.end.n", only_function(J_IS_N, GUARDED, open, b));
    kw_claim_count(report, "bs.def3.end.n.usual", only_function(J_IS_N, USUAL, open, b));
    kw_claim_count(report, "bs.def3.end.last",
                   only_function(LAST_OF_ORDER_1, GUARDED, open, b));
    kw_claim_real(report, "bs.def3.end.simple.none",
                  sum_printed(NONE, USUAL, not_open, 3));
    kw_claim_real(report, "bs.def3.end.simple.n",
                  sum_printed(J_IS_N, USUAL, not_open, 3));
    kw_claim_real(report, "bs.rem2.chain.inside", change);
    kw_claim_real(report, "bs.rem2.chain.end", printed(J_IS_N, USUAL, chain, N, K, b));
    kw_claim_count(report, "bs.def3.order1", N + K);
}

/* omega is a polynomial of degree 1 on either side of its right knot: second differences
   on integer points are zero. */
static double bend_of_omega(const double *t)
{
    double bend = 0;

    for (int j = 0; j <= N; j++)
        for (int x = -4; x <= 8; x++)
            if (x + 1 < t[j + K - 1] || x - 1 >= t[j + K - 1])
                bend = fmax(bend, fabs(omega(GUARDED, t, j, K, x - 1) -
                                       2 * omega(GUARDED, t, j, K, x) +
                                       omega(GUARDED, t, j, K, x + 1)));
    return bend;
}

/* The three key properties of the corrected functions on random open knots. */
static void report_properties(kw_out *report)
{
    double least = 0, unity = 0, outside = 0;
    int at_end = 0;

    for (uint64_t i = 0; i < SPACES; i++) {
        partition p = random_partition(3, i);
        kw_bspline *s = partition_space(&p);
        double a = p.tau[0], b = p.tau[p.L];

        for (int q = -SAMPLES / 4; q <= SAMPLES + SAMPLES / 4; q++) {
            double x = a + (b - a) * q / SAMPLES, sum = 0;

            for (int j = 0; j < s->n; j++) {
                double value = kw_bspline_one(s, j, 0, x);

                least = fmin(least, value);
                sum += value;
                if ((x < s->t[j] || x >= s->t[j + s->d + 1]) && x != b)
                    outside = fmax(outside, fabs(value));
            }
            if (a <= x && x <= b)
                unity = fmax(unity, fabs(sum - 1));
        }
        /* b lies in no [t_j, t_{j+k}), but the last function is one there */
        at_end += kw_bspline_one(s, s->n - 1, 0, b) == 1 && b >= s->t[s->n + s->d];
        kw_bspline_free(s);
    }
    kw_claim_real(report, "bs.list1.nonnegative", least);
    kw_claim_real(report, "bs.list1.support", outside);
    kw_claim_count(report, "bs.list1.support.end", at_end);
    kw_claim_real(report, "bs.list1.unity", unity);
}

/* Left of the domain, on knots that are not open, too few functions are left for a sum of
   one. */
static double sum_outside(void)
{
    kw_bspline *s = kw_bspline_new_uniform(K - 1, 4, 0, 4);
    double sum = 0;

    for (int j = 0; j < s->n; j++)
        sum += kw_bspline_one(s, j, 0, -0.5);
    kw_bspline_free(s);
    return sum;
}

int main(void)
{
    const double open[N + K + 1] = {0, 0, 0, 1, 2, 3, 3, 3};
    kw_bspline *s = kw_bspline_new(K - 1, N + 1, open);
    kw_out *f = kw_out_data("ex_recursion"), *report = kw_claim_new("ex_recursion");

    write_right_end(f, open, s);
    report_readings(report, open);
    kw_claim_real(report, "bs.def3.omega", bend_of_omega(open));
    report_properties(report);
    kw_claim_real(report, "bs.list1.unity.outside", sum_outside());

    kw_bspline_free(s);
    return kw_out_close(f) | kw_out_close(report);
}
