/* Key properties -- non-negativity, local support, partition of unity.

   What to see: nothing to look at. The three properties hold on open knots and on others, b
   included; outside the domain the sum is below one. That a function is zero outside its
   support is seen in its other form, a divided difference of truncated powers, where it is
   not built in.

   Book: section 1.1, the list of key properties behind Definition 3, and Remark 2.
   Claims: bs.list1.*, bs.def3.indicator, bs.def3.divided
   Chosen here: 200 random knot vectors, each open and with random auxiliary knots. */

#include "bspline.h"   /* the functions */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* reports are files */
#include "partition.h" /* random knots */
#include <math.h>

enum { SPACES = 200, SAMPLES = 48, K = PARTITION_D + 1 };

typedef struct findings {
    double least, unity, outside, difference;
} findings;

/* beta_j(x) = (t_{j+k} - t_j) [t_j, .., t_{j+k}] (s - x)_+^d, the divided difference in s; at
   equal knots a derivative over a factorial. *size is the same with every sign positive.
   [de Boor, ch. IX, (2)] */
static double divided_difference(const kw_bspline *s, int j, double x, double *size)
{
    const double *t = s->t + j;
    double value[K + 1] = {0}, terms[K + 1] = {0};
    int k = s->d + 1;

    for (int q = 0; q <= k; q++)
        for (int i = k - q; i >= 0;
             i--) { /* over t[i .. i+q]; from t[i .. ] of one less */
            int place = i + q;

            if (t[i] == t[place]) {
                double power = t[i] > x;

                for (int r = 0; r < s->d - q; r++)
                    power *= t[i] - x;
                for (int r = 0; r < q; r++) /* binomial(d, q) */
                    power = power * (s->d - r) / (r + 1);
                value[place] = power;
                terms[place] = fabs(power);
            } else {
                double width = t[place] - t[i];

                value[place] = (value[place] - value[place - 1]) / width;
                terms[place] = (terms[place] + terms[place - 1]) / width;
            }
        }
    *size = (t[k] - t[0]) * terms[k];
    return (t[k] - t[0]) * value[k];
}

static void look_at(const kw_bspline *s, findings *all)
{
    double a = s->t[s->d], b = s->t[s->n];

    for (int q = -SAMPLES / 4; q <= SAMPLES + SAMPLES / 4; q++) {
        double x = a + (b - a) * q / SAMPLES, sum = 0;

        for (int j = 0; j < s->n; j++) {
            double value = kw_bspline_one(s, j, 0, x), size;
            double other = divided_difference(s, j, x, &size);

            all->least = fmin(all->least, value);
            sum += value;
            if (x < s->t[j] || (x >= s->t[j + s->d + 1] && x != b))
                all->outside = fmax(all->outside, size > 0 ? fabs(other) / size : 0);
            if (size > 0 && x != b)
                all->difference = fmax(all->difference, fabs(other - value) / size);
        }
        if (a <= x && x <= b)
            all->unity = fmax(all->unity, fabs(sum - 1));
    }
}

/* (function, point) pairs of degree 0 at which the function is not the indicator of
   [t_j, t_{j+1}); x = b left out. */
static int indicators_off(const partition *p)
{
    kw_bspline *s = kw_bspline_new_open(0, p->L, p->tau, NULL);
    int off = 0;

    for (int j = 0; j < s->n; j++)
        for (int q = -2; p->tau[0] + q / 2.0 < p->tau[p->L]; q++) {
            double x = p->tau[0] + q / 2.0;

            off += kw_bspline_one(s, j, 0, x) != (p->tau[j] <= x && x < p->tau[j + 1]);
        }
    kw_bspline_free(s);
    return off;
}

/* Left of the domain, on knots that are not open, too few functions are left for a sum of
   one: quadratics on simple knots at -1/2. */
static double sum_outside(void)
{
    kw_bspline *s = kw_bspline_new_uniform(2, 4, 0, 4);
    double sum = 0;

    for (int j = 0; j < s->n; j++)
        sum += kw_bspline_one(s, j, 0, -0.5);
    kw_bspline_free(s);
    return sum;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_properties");
    findings open = {0, 0, 0, 0}, free_ends = {0, 0, 0, 0};
    int at_end = 0, indicators = 0;

    for (uint64_t i = 0; i < SPACES; i++) {
        partition p = random_partition(3, i);
        kw_bspline *s = partition_space(&p), *other = with_auxiliary_knots(s, i);

        look_at(s, &open);
        look_at(other, &free_ends);
        /* b lies in no [t_j, t_{j+k}), but the last function is one there */
        at_end +=
            kw_bspline_one(s, s->n - 1, 0, p.tau[p.L]) == 1 && p.tau[p.L] >= s->t[s->n];
        indicators += indicators_off(&p);
        kw_bspline_free(s);
        kw_bspline_free(other);
    }
    kw_claim_count(report, "bs.def3.indicator", indicators);
    kw_claim_real(report, "bs.def3.divided", fmax(open.difference, free_ends.difference));
    kw_claim_real(report, "bs.list1.nonnegative", open.least);
    kw_claim_real(report, "bs.list1.support", open.outside);
    kw_claim_count(report, "bs.list1.support.end", at_end);
    kw_claim_real(report, "bs.list1.unity", open.unity);
    kw_claim_real(report, "bs.list1.auxiliary.nonnegative", free_ends.least);
    kw_claim_real(report, "bs.list1.auxiliary.support", free_ends.outside);
    kw_claim_real(report, "bs.list1.auxiliary.unity", free_ends.unity);
    kw_claim_real(report, "bs.list1.unity.outside", sum_outside());
    return kw_out_close(report);
}
