/* test_normal.c -- normal deviates: their law, and that they do not depend on how many are asked
   for at once. */
#include "normal.h"
#include "elementary.h"
#include "test.h"
#include <math.h>
#include <string.h>

enum { COUNT = 200000 };

static double all[COUNT];

static void draw(void)
{
    kw_rng r = kw_rng_at(11, 0, 0, 0);

    kw_normal_many(&r, COUNT, all);
}

static double moment(int power)
{
    double sum = 0;

    for (int i = 0; i < COUNT; i++)
        sum += pow(all[i], power);
    return sum / COUNT;
}

/* The mean of x^p is 0, 1, 0, 3, 0, 15 for p = 1 .. 6 with the variance E x^2p - (E x^p)^2, where
   E x^2q = 1 3 5 .. (2q-1); five standard deviations are exceeded once in a million. */
static void moments(void)
{
    static const double mean[] = {0, 1, 0, 3, 0, 15},
                        square[] = {1, 3, 15, 105, 945, 10395};

    draw();
    for (int p = 1; p <= 6; p++) {
        double found = moment(p), variance = square[p - 1] - mean[p - 1] * mean[p - 1];

        CHECK(fabs(found - mean[p - 1]) < 5 * sqrt(variance / COUNT), "E x^%d is %g", p,
              found);
    }
}

/* The largest distance of the distribution function, on 61 points, where the count is binomial:
   five of its standard deviations. */
static void distribution(void)
{
    draw();
    for (int k = -30; k <= 30; k++) {
        double at = 0.1 * k, wanted = 0.5 * kw_erfc(-at * sqrt(0.5));
        int below = 0;

        for (int i = 0; i < COUNT; i++)
            below += all[i] < at;
        CHECK(fabs((double)below / COUNT - wanted) <
                  5 * sqrt(wanted * (1 - wanted) / COUNT),
              "%d below %g", below, at);
    }
}

/* Neighbours are independent: the mean of x_i x_{i+1} has the standard deviation 1/sqrt(COUNT). */
static void neighbours(void)
{
    double sum = 0;

    draw();
    for (int i = 0; i + 1 < COUNT; i++)
        sum += all[i] * all[i + 1];
    CHECK(fabs(sum / COUNT) < 5 / sqrt((double)COUNT), "%g", sum / COUNT);
}

/* All layers have the area of the first, tail and all: 2^-50 is a few roundings of numbers below 4.
   The top one ends where x_1, of 13 digits, lets it: an error of 1e-13 grows to 1.2e-11 there,
   which is the probability that falls into the wrong layer. */
static void layers(void)
{
    const double *x = kw_normal_edge, *f = kw_normal_height;
    double area = x[1] * kw_exp(-0.5 * x[1] * x[1]) +
                  0x1.40d931ff62706p+0 * kw_erfc(x[1] * sqrt(0.5)); /* sqrt(pi/2) */

    CHECK(fabs(x[0] * f[1] - area) < 0x1p-50, "layer 0: %g", x[0] * f[1]);
    for (int i = 1; i < KW_NORMAL_LAYERS; i++) {
        double tolerance = i + 1 < KW_NORMAL_LAYERS ? 0x1p-50 : 2e-11;

        CHECK(fabs(f[i] - kw_exp(-0.5 * x[i] * x[i])) < 0x1p-50, "height %d: %g", i,
              f[i]);
        CHECK(fabs(x[i] * (f[i + 1] - f[i]) - area) < tolerance, "layer %d: %g", i,
              x[i] * (f[i + 1] - f[i]) - area);
        CHECK(x[i] > x[i + 1], "edge %d", i + 1);
    }
    CHECK(x[KW_NORMAL_LAYERS] == 0 && f[KW_NORMAL_LAYERS] == 1, "top");
}

/* The first numbers are the same, however many follow; nothing is written behind the last. */
static void any_number_of_them(void)
{
    enum { MOST = 300 };
    double first[MOST], some[MOST + 1];
    kw_rng r = kw_rng_at(12, 1, 2, 3);

    kw_normal_many(&r, MOST, first);
    for (int n = 0; n <= MOST; n++) {
        r = kw_rng_at(12, 1, 2, 3);
        some[n] = 77;
        kw_normal_many(&r, n, some);
        CHECK(memcmp(first, some, (size_t)n * sizeof *first) == 0 && some[n] == 77, "%d",
              n);
    }
}

/* Any two parts are the whole: the second goes on where the first ended. */
static void in_two_parts(void)
{
    enum { ALL = 300 };
    double whole[ALL], parts[ALL];
    kw_rng r = kw_rng_at(13, 1, 2, 3);

    kw_normal_many(&r, ALL, whole);
    for (int n = 0; n <= ALL; n++) {
        int different = 0;

        r = kw_rng_at(13, 1, 2, 3);
        kw_normal_many(&r, n, parts);
        kw_normal_many(&r, ALL - n, parts + n);
        for (int i = 0; i < ALL; i++)
            different += whole[i] != parts[i];
        CHECK(different == 0, "%d and %d: %d differ", n, ALL - n, different);
    }
}

/* Where a point lies below the next layer, its deviate is made of one word alone: 7 bits of the
   layer, a bit of the sign, 53 bits of the place. The widths say how often that is: five standard
   deviations of a binomial count. */
static void one_word(void)
{
    double share = 0;
    int inside = 0;

    for (int k = 0; k < COUNT; k++) {
        kw_rng r = kw_rng_at(14, 0, (uint64_t)k, 0);
        const uint64_t word = kw_rng_word(&r);
        const int layer = (int)(word & (KW_NORMAL_LAYERS - 1));
        const double x = kw_normal_edge[layer] * ((double)(word >> 11) * 0x1p-53);
        double found;

        if (!(x < kw_normal_edge[layer + 1]))
            continue;
        inside++;
        r = kw_rng_at(14, 0, (uint64_t)k, 0);
        kw_normal_many(&r, 1, &found);
        CHECK(found == (word & KW_NORMAL_LAYERS ? -x : x), "word %llx: %g",
              (unsigned long long)word, found);
    }
    for (int i = 0; i < KW_NORMAL_LAYERS; i++)
        share += kw_normal_edge[i + 1] / kw_normal_edge[i] / KW_NORMAL_LAYERS;
    CHECK(fabs((double)inside / COUNT - share) < 5 * sqrt(share * (1 - share) / COUNT),
          "%d of %d, not %g", inside, COUNT, share);
}

int main(void)
{
    test_run("normal: layers have the same area", layers);
    test_run("normal: moments", moments);
    test_run("normal: distribution", distribution);
    test_run("normal: neighbours are independent", neighbours);
    test_run("normal: the first do not depend on how many follow", any_number_of_them);
    test_run("normal: any two parts are the whole", in_two_parts);
    test_run("normal: a point inside its layer takes one word", one_word);
    return test_end();
}
