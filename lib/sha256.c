#include "sha256.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#if defined(__x86_64__) && defined(__GNUC__)
#include <cpuid.h>
#include <immintrin.h>
#endif

enum { BLOCK = 64, ROUNDS = 64, LENGTH = 8 /* bytes that hold the length */ };

/* The first 32 bits behind the point of the cube roots of the first 64 primes. */
static const uint32_t constant[ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
    0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
    0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
    0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
    0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
    0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
    0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
    0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
    0xc67178f2};

static inline uint32_t rotate(uint32_t x, int by)
{
    return x >> by | x << (32 - by);
}

static uint32_t big_endian(const unsigned char *byte)
{
    return (uint32_t)byte[0] << 24 | (uint32_t)byte[1] << 16 | (uint32_t)byte[2] << 8 |
           byte[3];
}

/* The message schedule of a block. */
static void expand(const unsigned char *block, uint32_t *w)
{
    for (int i = 0; i < 16; i++)
        w[i] = big_endian(block + 4 * i);
    for (int i = 16; i < ROUNDS; i++) {
        uint32_t a = w[i - 15], b = w[i - 2];

        w[i] = w[i - 16] + w[i - 7] + (rotate(a, 7) ^ rotate(a, 18) ^ a >> 3) +
               (rotate(b, 17) ^ rotate(b, 19) ^ b >> 10);
    }
}

/* One round. Of the eight words only d and h change; the next round has each one place on. */
static inline void step(uint32_t a, uint32_t b, uint32_t c, uint32_t *d, uint32_t e,
                        uint32_t f, uint32_t g, uint32_t *h, uint32_t word)
{
    uint32_t first =
        *h + (rotate(e, 6) ^ rotate(e, 11) ^ rotate(e, 25)) + (g ^ (e & (f ^ g))) + word;
    uint32_t second =
        (rotate(a, 2) ^ rotate(a, 13) ^ rotate(a, 22)) + ((a & b) | (c & (a | b)));

    *d += first;
    *h = first + second;
}

static void compress_block(uint32_t *state, const unsigned char *block)
{
    uint32_t w[ROUNDS], a = state[0], b = state[1], c = state[2], d = state[3];
    uint32_t e = state[4], f = state[5], g = state[6], h = state[7];

    expand(block, w);
    for (int i = 0; i < ROUNDS; i += 8) {
        const uint32_t *k = constant + i, *m = w + i;

        step(a, b, c, &d, e, f, g, &h, k[0] + m[0]);
        step(h, a, b, &c, d, e, f, &g, k[1] + m[1]);
        step(g, h, a, &b, c, d, e, &f, k[2] + m[2]);
        step(f, g, h, &a, b, c, d, &e, k[3] + m[3]);
        step(e, f, g, &h, a, b, c, &d, k[4] + m[4]);
        step(d, e, f, &g, h, a, b, &c, k[5] + m[5]);
        step(c, d, e, &f, g, h, a, &b, k[6] + m[6]);
        step(b, c, d, &e, f, g, h, &a, k[7] + m[7]);
    }
    state[0] += a;
    state[1] += b;
    state[2] += c;
    state[3] += d;
    state[4] += e;
    state[5] += f;
    state[6] += g;
    state[7] += h;
}

static void compress_plain(uint32_t *state, size_t blocks, const unsigned char *block)
{
    for (; blocks > 0; blocks--, block += BLOCK)
        compress_block(state, block);
}

/* --- with the SHA instructions of x86-64. [Gulley, Gopal, Yap, Feghali, Guilford, Wolrich: Intel
   SHA extensions, 2013] --- */

#if defined(__x86_64__) && defined(__GNUC__)
#define HARDWARE __attribute__((target("sha,sse4.1")))

static int has_hardware(void)
{
    unsigned a, b, c, d;

    return __builtin_cpu_supports("sse4.1") && __get_cpuid_count(7, 0, &a, &b, &c, &d) &&
           (b >> 29 & 1) != 0;
}

/* Four words of the message schedule in place of the first four of the sixteen before them. */
HARDWARE static inline __m128i next_words(__m128i a, __m128i b, __m128i c, __m128i d)
{
    const __m128i sum =
        _mm_add_epi32(_mm_sha256msg1_epu32(a, b), _mm_alignr_epi8(d, c, 4));

    return _mm_sha256msg2_epu32(sum, d);
}

/* The instructions keep the state as the words abef and cdgh, a in the highest place. */
HARDWARE static void compress_hardware(uint32_t *state, size_t blocks,
                                       const unsigned char *block)
{
    const __m128i swap = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
    __m128i low = _mm_loadu_si128((const __m128i *)(const void *)state);
    __m128i high = _mm_loadu_si128((const __m128i *)(const void *)(state + 4));
    const __m128i cdab = _mm_shuffle_epi32(low, 0xb1),
                  efgh = _mm_shuffle_epi32(high, 0x1b);
    __m128i abef = _mm_alignr_epi8(cdab, efgh, 8),
            cdgh = _mm_blend_epi16(efgh, cdab, 0xf0);

    for (; blocks > 0; blocks--, block += BLOCK) {
        const __m128i abef_before = abef, cdgh_before = cdgh;
        __m128i w[4]; /* sixteen words of the schedule */

        for (int j = 0; j < 4; j++)
            w[j] = _mm_shuffle_epi8(
                _mm_loadu_si128((const __m128i *)(const void *)(block + 16 * j)), swap);
        for (int i = 0; i < ROUNDS; i += 16)
            for (int j = 0; j < 4; j++) { /* four rounds */
                const __m128i *k = (const __m128i *)(const void *)(constant + i + 4 * j);
                const __m128i sum = _mm_add_epi32(w[j], _mm_loadu_si128(k));

                cdgh = _mm_sha256rnds2_epu32(cdgh, abef, sum);
                abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(sum, 0x0e));
                w[j] = next_words(w[j], w[(j + 1) % 4], w[(j + 2) % 4], w[(j + 3) % 4]);
            }
        abef = _mm_add_epi32(abef, abef_before);
        cdgh = _mm_add_epi32(cdgh, cdgh_before);
    }
    low = _mm_shuffle_epi32(abef, 0x1b);
    high = _mm_shuffle_epi32(cdgh, 0xb1);
    _mm_storeu_si128((__m128i *)(void *)state, _mm_blend_epi16(low, high, 0xf0));
    _mm_storeu_si128((__m128i *)(void *)(state + 4), _mm_alignr_epi8(high, low, 8));
}
#endif

/* --- sums --- */

kw_sha256 kw_sha256_begin_plain(void)
{
    /* the first 32 bits behind the point of the square roots of the first 8 primes */
    const kw_sha256 s = {.state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                   0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19},
                         .compress = compress_plain};

    return s;
}

kw_sha256 kw_sha256_begin(void)
{
    kw_sha256 s = kw_sha256_begin_plain();

#ifdef HARDWARE
    if (has_hardware())
        s.compress = compress_hardware;
#endif
    return s;
}

/* Fills the block that was begun; returns how many bytes that took. */
static size_t fill_block(kw_sha256 *s, const unsigned char *bytes, size_t count)
{
    size_t filled = (size_t)(s->bytes % BLOCK), part = BLOCK - filled;

    if (part > count)
        part = count;
    memcpy(s->block + filled, bytes, part);
    if (filled + part == BLOCK)
        s->compress(s->state, 1, s->block);
    s->bytes += part;
    return part;
}

void kw_sha256_add(kw_sha256 *s, const void *bytes, size_t count)
{
    const unsigned char *next = bytes;

    while (count > 0) {
        size_t part = count / BLOCK * BLOCK;

        if (s->bytes % BLOCK != 0 || part == 0)
            part = fill_block(s, next, count);
        else {
            s->compress(s->state, part / BLOCK, next);
            s->bytes += part;
        }
        next += part;
        count -= part;
    }
}

void kw_sha256_end(kw_sha256 *s, char *text)
{
    const uint64_t bits = 8 * s->bytes;
    const size_t filled = (size_t)(s->bytes % BLOCK);
    const size_t whole = filled < BLOCK - LENGTH ? BLOCK : (size_t)2 * BLOCK;
    const size_t padding = whole - LENGTH - filled;
    unsigned char end[BLOCK + LENGTH] = {0x80};

    for (int i = 0; i < LENGTH; i++)
        end[padding + (size_t)i] = (unsigned char)(bits >> (56 - 8 * i));
    kw_sha256_add(s, end, padding + LENGTH);
    for (int i = 0; i < 8; i++)
        snprintf(text + 8 * i, 9, "%08lx", (unsigned long)s->state[i]);
}

int kw_sha256_file(const char *path, char *text, uint64_t *bytes)
{
    unsigned char part[1 << 15];
    kw_sha256 s = kw_sha256_begin();
    FILE *f = fopen(path, "rb");
    size_t count;
    int error = 0;

    if (!f)
        return errno;
    errno = 0;
    while ((count = fread(part, 1, sizeof part, f)) > 0)
        kw_sha256_add(&s, part, count);
    if (ferror(f))
        error = errno != 0 ? errno : EIO;
    fclose(f);
    if (bytes)
        *bytes = s.bytes;
    kw_sha256_end(&s, text);
    return error;
}
