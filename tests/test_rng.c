#include "rng.h"
#include "test.h"
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* The known answers that come with [Salmon et al.]'s own code, Random123: counter, key,
   words. */
static const struct known {
    uint64_t counter[4], key[2], word[4];
} KNOWN[] = {
    {{0, 0, 0, 0},
     {0, 0},
     {0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}},
    {{UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX},
     {UINT64_MAX, UINT64_MAX},
     {0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}},
    {{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
     {0x452821e638d01377, 0xbe5466cf34e90c6c},
     {0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}},
};

static void philox_gives_the_known_answers(void)
{
    for (size_t i = 0; i < sizeof KNOWN / sizeof *KNOWN; i++) {
        uint64_t word[4] = {1, 2, 3, 4};

        kw_rng_philox(KNOWN[i].key, KNOWN[i].counter, word);
        for (int j = 0; j < 4; j++)
            CHECK(word[j] == KNOWN[i].word[j], "answer %zu, word %d: %016" PRIx64, i, j,
                  word[j]);
    }
}

static void words_are_the_blocks_in_order(void)
{
    const uint64_t key[2] = {5, 6};
    kw_rng r = kw_rng_at(5, 6, 7, 8);

    for (uint64_t block = 0; block < 5; block++) {
        const uint64_t counter[4] = {block, 0, 7, 8};
        uint64_t word[4];

        kw_rng_philox(key, counter, word);
        for (int j = 0; j < 4; j++) {
            uint64_t got = kw_rng_word(&r);

            CHECK(got == word[j], "block %d, word %d: %016" PRIx64, (int)block, j, got);
        }
    }
}

enum { SAMPLES = 100, WORDS = 7 }; /* seven words: not a whole number of blocks */

static void samples_do_not_depend_on_the_order(void)
{
    static uint64_t forward[SAMPLES][WORDS];

    for (int i = 0; i < SAMPLES; i++) {
        kw_rng r = kw_rng_at(1, 2, (uint64_t)i, 3);

        for (int j = 0; j < WORDS; j++)
            forward[i][j] = kw_rng_word(&r);
    }
    for (int i = SAMPLES - 1; i >= 0; i--) {
        kw_rng r = kw_rng_at(1, 2, (uint64_t)i, 3);

        for (int j = 0; j < WORDS; j++)
            CHECK(kw_rng_word(&r) == forward[i][j], "sample %d, word %d", i, j);
    }
}

static int compare_words(const void *a, const void *b)
{
    uint64_t left = *(const uint64_t *)a, right = *(const uint64_t *)b;

    return (left > right) - (left < right);
}

static void places_have_numbers_of_their_own(void)
{
    enum { SIDE = 5, PLACES = SIDE * SIDE * SIDE * SIDE };
    static uint64_t word[PLACES];

    for (int i = 0; i < PLACES; i++) {
        uint64_t seed = (uint64_t)(i % SIDE), stream = (uint64_t)(i / SIDE % SIDE);
        uint64_t sample = (uint64_t)(i / (SIDE * SIDE) % SIDE);
        uint64_t field = (uint64_t)(i / (SIDE * SIDE * SIDE));
        kw_rng r = kw_rng_at(seed, stream, sample, field);

        word[i] = kw_rng_word(&r);
    }
    qsort(word, PLACES, sizeof *word, compare_words);
    for (int i = 1; i < PLACES; i++)
        CHECK(word[i - 1] != word[i], "%016" PRIx64 " twice", word[i]);
}

static void a_copy_goes_back(void)
{
    kw_rng r = kw_rng_at(11, 12, 13, 14);

    for (int skip = 0; skip < 9; skip++) {
        kw_rng copy = r;
        uint64_t first[WORDS];

        for (int j = 0; j < WORDS; j++)
            first[j] = kw_rng_word(&r);
        for (int j = 0; j < WORDS; j++)
            CHECK(kw_rng_word(&copy) == first[j], "after %d words, word %d", skip * WORDS,
                  j);
    }
}

static void uniform_numbers_are_multiples_in_range(void)
{
    enum { DRAWS = 100000 };
    kw_rng r = kw_rng_at(21, 0, 0, 0);
    double sum = 0, spread = 6 / sqrt(12.0 * DRAWS); /* six standard deviations */

    for (int i = 0; i < DRAWS; i++) {
        kw_rng before = r;
        double x = kw_rng_uniform(&r), steps = x * 0x1p53;

        CHECK(0 <= x && x < 1, "%.17g", x);
        CHECK(steps == floor(steps), "%.17g", x);
        CHECK(steps == (double)(kw_rng_word(&before) >> 11), "%.17g", x);
        sum += x;
    }
    CHECK(fabs(sum / DRAWS - 0.5) <= spread, "mean %g", sum / DRAWS);
}

static void below_is_in_range_and_even(void)
{
    enum { MOST = 13, EACH = 5000 };
    kw_rng r = kw_rng_at(31, 0, 0, 0);

    for (int n = 1; n <= MOST; n++) {
        int count[MOST] = {0};
        /* six standard deviations of a binomial count with the mean EACH */
        double spread = 6 * sqrt(EACH * (1 - 1.0 / n));

        for (int i = 0; i < n * EACH; i++) {
            int j = kw_rng_below(&r, n);

            CHECK(0 <= j && j < n, "%d of %d", j, n);
            if (0 <= j && j < n)
                count[j]++;
        }
        for (int j = 0; j < n; j++)
            CHECK(fabs(count[j] - (double)EACH) <= spread, "%d of %d: %d", j, n,
                  count[j]);
    }
}

static void below_reaches_large_numbers(void)
{
    kw_rng r = kw_rng_at(32, 0, 0, 0);
    int most = 0;

    for (int i = 0; i < 1000; i++) {
        int j = kw_rng_below(&r, INT_MAX);

        CHECK(0 <= j && j < INT_MAX, "%d", j);
        most = j > most ? j : most;
    }
    /* all below 98 % of the range: a chance of 0.98^1000 < 2e-9 */
    CHECK(most > INT_MAX / 50 * 49, "at most %d", most);
}

static void below_nothing(void)
{
    kw_rng r = kw_rng_at(0, 0, 0, 0);

    kw_rng_below(&r, 0);
}

static void below_a_negative_number(void)
{
    kw_rng r = kw_rng_at(0, 0, 0, 0);

    kw_rng_below(&r, -3);
}

static void below_needs_a_number(void)
{
    test_aborts("n = 0", below_nothing);
    test_aborts("n = -3", below_a_negative_number);
}

int main(void)
{
    test_run("rng: Philox gives the known answers", philox_gives_the_known_answers);
    test_run("rng: words are the blocks in order", words_are_the_blocks_in_order);
    test_run("rng: a sample does not depend on what was drawn before",
             samples_do_not_depend_on_the_order);
    test_run("rng: seed, stream, sample and field each change the numbers",
             places_have_numbers_of_their_own);
    test_run("rng: a copy goes back", a_copy_goes_back);
    test_run("rng: uniform numbers are multiples of 2^-53 in [0,1)",
             uniform_numbers_are_multiples_in_range);
    test_run("rng: integers below n are in range and equally frequent",
             below_is_in_range_and_even);
    test_run("rng: integers below n reach the largest n", below_reaches_large_numbers);
    test_run("rng: n below 1 aborts", below_needs_a_number);
    return test_end();
}
