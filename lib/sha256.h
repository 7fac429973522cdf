/* sha256.h -- checksums as sha256sum prints them.
   [FIPS PUB 180-4, Secure Hash Standard] */
#ifndef KW_SHA256_H
#define KW_SHA256_H

#include <stddef.h>
#include <stdint.h>

enum { KW_SHA256_TEXT = 65 }; /* 64 hexadecimal digits and a 0 */

typedef struct kw_sha256 {
    uint32_t state[8];
    uint64_t bytes; /* so far */
    unsigned char block[64];
    /* takes so many blocks of 64 bytes into the state */
    void (*compress)(uint32_t *state, size_t blocks, const unsigned char *block);
} kw_sha256;

/* The sum of nothing yet. Where the processor has instructions for it they are used. */
kw_sha256 kw_sha256_begin(void);

/* The same without them, several times slower. */
kw_sha256 kw_sha256_begin_plain(void);

void kw_sha256_add(kw_sha256 *s, const void *bytes, size_t count);

/* The sum of all bytes added: text[0 .. KW_SHA256_TEXT-1]. s is used up. */
void kw_sha256_end(kw_sha256 *s, char *text);

/* The sum of a file, and how many bytes it has (NULL if nobody asks). 0, or an errno. */
int kw_sha256_file(const char *path, char *text, uint64_t *bytes);

#endif
