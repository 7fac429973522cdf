/* Selection -- the best of many models looks better than it is.

   What to see: labels and models are coin flips, so that every model has a true error of one half.
   The one that does best on a validation set has a smaller error there, the smaller the more
   models there are; on a test set, which had no part in the choice, it has one half on average.

   Book: section 1.2, the validation and the test set.
   Claims: learn.best.*, learn.predict.*
   Chosen here: 50 models, 100 validation and 100 test samples, repeated 4000 times; other numbers
   of models and samples for the curves. */

#include "claim.h"      /* what we found, for the ledger */
#include "elementary.h" /* the logarithm in a bound */
#include "out.h"        /* columns for gnuplot */
#include "power.h"      /* all models above */
#include "rng.h"        /* coins */
#include <math.h>

enum { MODELS = 50, SAMPLES = 100, REPEATS = 4000, MOST = 400, STEPS = 11 };

static const uint64_t SEED = 431;

/* --- in closed form. A model's mistakes on m samples are binomial, and the least of n of them is
   above k if all are. --- */

/* above[k], k = 0 .. m-1: the probability of more than k heads in m flips, m <= 1000. */
static void tails(int m, double *above)
{
    double p = 1, sum = 0;

    for (int k = 0; k < m; k++)
        p /= 2;
    for (int k = m; k > 0; k--) { /* p: of exactly k heads */
        sum += p;
        above[k - 1] = sum;
        p = p * k / (m - k + 1);
    }
}

/* The mean of the least share of mistakes among n models on m samples. */
static double least_share(int n, int m)
{
    double above[MOST] = {0}, sum = 0;

    tails(m, above);
    for (int k = m - 1; k >= 0; k--)
        sum += power(above[k], n);
    return sum / m;
}

/* The same mean over all outcomes of n m flips, one after the other. */
static double least_share_by_trying(int n, int m)
{
    double sum = 0;

    for (long outcome = 0; outcome < 1L << n * m; outcome++) {
        int least = m;

        for (int model = 0; model < n; model++) {
            int mistakes = 0;

            for (int i = 0; i < m; i++)
                mistakes += (outcome >> (model * m + i) & 1) != 0;
            least = mistakes < least ? mistakes : least;
        }
        sum += least;
    }
    return sum / m / (double)(1L << n * m);
}

/* The largest difference of the two ways, n m <= 12. */
static double largest_difference(void)
{
    double most = 0;

    for (int m = 1; m <= 12; m++)
        for (int n = 1; n * m <= 12; n++)
            most = fmax(most, fabs(least_share(n, m) - least_share_by_trying(n, m)));
    return most;
}

/* --- with random labels and models --- */

/* Flips SAMPLES coins: a bit each. */
static void flip(kw_rng *r, uint64_t coin[2])
{
    coin[0] = kw_rng_word(r);
    coin[1] = kw_rng_word(r) >> (128 - SAMPLES);
}

static int differing(const uint64_t a[2], const uint64_t b[2])
{
    int count = 0;

    for (int i = 0; i < 2; i++)
        for (uint64_t rest = a[i] ^ b[i]; rest; rest &= rest - 1)
            count++;
    return count;
}

/* The model with the fewest mistakes on the validation set, the first of them: its mistakes
   there and on the test set. */
static void select_one(uint64_t repeat, int *on_validation, int *on_test)
{
    uint64_t validation[2], test[2], answer[2];
    kw_rng r = kw_rng_at(SEED, 0, repeat, 0);

    /* labels, then the answers of each model, in both sets */
    flip(&r, validation);
    flip(&r, test);
    *on_validation = SAMPLES + 1;
    for (int model = 0; model < MODELS; model++) {
        int mistakes;

        flip(&r, answer);
        mistakes = differing(answer, validation);
        flip(&r, answer);
        if (mistakes < *on_validation) {
            *on_validation = mistakes;
            *on_test = differing(answer, test);
        }
    }
}

/* --- columns --- */

/* How often the selected model had k mistakes, and the probabilities of that. */
static void write_selected(kw_out *f, const int *validation, const int *test)
{
    double above[SAMPLES + 1] = {0};

    tails(SAMPLES, above);
    kw_out_section(f, "selected", "share validation test validation-law test-law");
    for (int k = 0; k <= SAMPLES; k++) {
        double before = k == 0 ? 1 : above[k - 1];

        kw_out_number(f, (double)k / SAMPLES);
        kw_out_number(f, (double)validation[k] / REPEATS);
        kw_out_number(f, (double)test[k] / REPEATS);
        kw_out_number(f, power(before, MODELS) - power(above[k], MODELS));
        kw_out_number(f, before - above[k]);
        kw_out_row(f);
    }
}

/* By how much the best of 1, 2, 4, .. models looks better than it is, and the bound
   sqrt(log n / 2m); returns the largest quotient of the two.
   [Boucheron, Lugosi, Massart: Concentration Inequalities, 2013, section 2.5] */
static double write_bias(kw_out *f)
{
    static const int sizes[] = {25, 100, 400};
    double most = 0;

    kw_out_section(f, "bias", "models 25 100 400 bound25 bound100 bound400");
    for (int step = 0; step < STEPS; step++) {
        int n = 1 << step;
        double bias[3], bound[3];

        kw_out_number(f, n);
        for (int s = 0; s < 3; s++) {
            bias[s] = 0.5 - least_share(n, sizes[s]);
            bound[s] = sqrt(kw_log(n) / (2.0 * sizes[s]));
            if (n > 1)
                most = fmax(most, bias[s] / bound[s]);
        }
        for (int s = 0; s < 3; s++)
            kw_out_number(f, bias[s]);
        for (int s = 0; s < 3; s++)
            kw_out_number(f, bound[s]);
        kw_out_row(f);
    }
    return most;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_selection"), *report = kw_claim_new("ex_selection");
    int validation[SAMPLES + 1] = {0}, test[SAMPLES + 1] = {0};
    double validation_sum = 0, test_sum = 0;

    for (uint64_t repeat = 0; repeat < REPEATS; repeat++) {
        int on_validation, on_test = 0;

        select_one(repeat, &on_validation, &on_test);
        validation[on_validation]++;
        test[on_test]++;
        validation_sum += on_validation;
        test_sum += on_test;
    }
    write_selected(f, validation, test);

    kw_claim_real(report, "learn.best.bound", write_bias(f));
    kw_claim_real(report, "learn.best.one", least_share(1, SAMPLES));
    kw_claim_real(report, "learn.best.two", least_share(2, 1));
    kw_claim_real(report, "learn.best.fifty", least_share(MODELS, SAMPLES));
    kw_claim_real(report, "learn.predict.two", least_share(3, 2));
    kw_claim_real(report, "learn.predict.four", least_share(3, 4));
    kw_claim_real(report, "learn.best.tried", largest_difference());
    kw_claim_real(report, "learn.best.validation", validation_sum / SAMPLES / REPEATS);
    kw_claim_real(report, "learn.best.test", test_sum / SAMPLES / REPEATS);
    return kw_out_close(f) | kw_out_close(report);
}
