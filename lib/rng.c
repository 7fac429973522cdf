#include "rng.h"
#include "need.h"

enum { ROUNDS = 10 };

/* high and low half of the 128-bit product a * b */
#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 product;

static inline void multiply(uint64_t a, uint64_t b, uint64_t *high, uint64_t *low)
{
    product p = (product)a * b;

    *high = (uint64_t)(p >> 64);
    *low = (uint64_t)p;
}
#else
static inline void multiply(uint64_t a, uint64_t b, uint64_t *high, uint64_t *low)
{
    const uint64_t mask = 0xffffffffu; /* from four 32-bit products */
    uint64_t al = a & mask, ah = a >> 32, bl = b & mask, bh = b >> 32;
    uint64_t middle = ah * bl + ((al * bl) >> 32);
    uint64_t cross = al * bh + (middle & mask);

    *high = ah * bh + (middle >> 32) + (cross >> 32);
    *low = a * b;
}
#endif

void kw_rng_philox(const uint64_t key[2], const uint64_t counter[4], uint64_t word[4])
{
    /* multipliers and key increments of Philox4x64 (golden ratio, sqrt(3) - 1) */
    const uint64_t m0 = 0xd2e7470ee14c6c93, m1 = 0xca5a826395121157;
    const uint64_t w0 = 0x9e3779b97f4a7c15, w1 = 0xbb67ae8584caa73b;
    uint64_t k0 = key[0], k1 = key[1];
    uint64_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3];

    for (int round = 0; round < ROUNDS; round++) {
        uint64_t high0, low0, high1, low1;

        multiply(m0, c0, &high0, &low0);
        multiply(m1, c2, &high1, &low1);
        c0 = high1 ^ c1 ^ k0;
        c1 = low1;
        c2 = high0 ^ c3 ^ k1;
        c3 = low0;
        k0 += w0;
        k1 += w1;
    }
    word[0] = c0;
    word[1] = c1;
    word[2] = c2;
    word[3] = c3;
}

kw_rng kw_rng_at(uint64_t seed, uint64_t stream, uint64_t sample, uint64_t field)
{
    kw_rng r = {{seed, stream}, {0, 0, sample, field}, {0, 0, 0, 0}, 4};

    return r;
}

void kw_rng_block(kw_rng *r)
{
    kw_rng_philox(r->key, r->counter, r->word);
    r->counter[0]++;
    r->used = 0;
}

int kw_rng_below(kw_rng *r, int n)
{
    KW_NEED(n >= 1, "n = %d", n);
    const uint64_t m = (uint64_t)n, cut = UINT64_MAX - UINT64_MAX % m;
    uint64_t w = kw_rng_word(r);

    while (w >= cut) /* the last, incomplete run of residues */
        w = kw_rng_word(r);
    return (int)(w % m);
}
