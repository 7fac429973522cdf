/* rng.h -- random numbers that depend on their place alone: Philox4x64-10.

   A generator without a state: a key and a counter are mixed into four 64-bit words. The
   sample with a given counter is the same whoever asks for it, in any order and on any
   machine, so a data set may be made in any number of pieces.
   [Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3. SC 2011] */
#ifndef KW_RNG_H
#define KW_RNG_H

#include <stdint.h>

/* Mixes counter[0..3] under key[0..1] into word[0..3], ten rounds. */
void kw_rng_philox(const uint64_t key[2], const uint64_t counter[4], uint64_t word[4]);

/* A place in the sequence of one key: the counter of the next block of four words, and
   how many words of the present block are used up. Copy it to go back. */
typedef struct kw_rng {
    uint64_t key[2];     /* seed, stream */
    uint64_t counter[4]; /* block, attempt, sample, field */
    uint64_t word[4];    /* the present block */
    int used;            /* 0..4 words of it */
} kw_rng;

/* The numbers of (seed, stream) that belong to `sample` and `field`, from the first. */
kw_rng kw_rng_at(uint64_t seed, uint64_t stream, uint64_t sample, uint64_t field);

/* Makes the next block of four words, whatever is left of the present one. */
void kw_rng_block(kw_rng *r);

/* The next 64 random bits. It stands here because it is called for every number. */
static inline uint64_t kw_rng_word(kw_rng *r)
{
    if (r->used == 4)
        kw_rng_block(r);
    return r->word[r->used++];
}

/* A multiple of 2^-53, uniform in [0,1). */
static inline double kw_rng_uniform(kw_rng *r)
{
    return (double)(kw_rng_word(r) >> 11) * 0x1p-53;
}

/* An integer, uniform in 0..n-1 without bias (words that would bias it are passed over).
   n >= 1. */
int kw_rng_below(kw_rng *r, int n);

#endif
