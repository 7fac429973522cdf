/* test_sha256.c -- checksums: known answers, any cut into pieces, files. */
#include "sha256.h"
#include "need.h"
#include "rng.h"
#include "test.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void sum_of(const void *bytes, size_t count, char *text)
{
    kw_sha256 s = kw_sha256_begin();

    kw_sha256_add(&s, bytes, count);
    kw_sha256_end(&s, text);
}

/* Those of FIPS 180-4's examples, and of nothing. */
static void known_answers(void)
{
    static const char *const message[] = {
        "", "abc", "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"};
    static const char *const wanted[] = {
        "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855",
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"};
    char text[KW_SHA256_TEXT];

    for (int i = 0; i < 3; i++) {
        sum_of(message[i], strlen(message[i]), text);
        CHECK(strcmp(text, wanted[i]) == 0, "`%s': %s", message[i], text);
    }
}

static void a_million_letters(void)
{
    enum { MILLION = 1000000 };
    char *a = kw_need_memory(MILLION, 1), text[KW_SHA256_TEXT];

    memset(a, 'a', MILLION);
    sum_of(a, MILLION, text);
    CHECK(strcmp(text, "cdc76e5c9914fb9281a1c7e284d73e67"
                       "f1809a48a497200e046d39ccc7112cd0") == 0,
          "%s", text);
    free(a);
}

/* With the processor's own instructions, if it has some, and without. */
static void both_ways_agree(void)
{
    enum { LONGEST = 1000 };
    unsigned char bytes[LONGEST];
    kw_rng r = kw_rng_at(6, 0, 0, 0);

    for (int i = 0; i < LONGEST; i++)
        bytes[i] = (unsigned char)kw_rng_below(&r, 256);
    for (size_t length = 0; length <= LONGEST; length++) {
        char one[KW_SHA256_TEXT], other[KW_SHA256_TEXT];
        kw_sha256 s = kw_sha256_begin_plain();

        sum_of(bytes, length, one);
        kw_sha256_add(&s, bytes, length);
        kw_sha256_end(&s, other);
        CHECK(strcmp(one, other) == 0, "%zu bytes: %s and %s", length, one, other);
    }
}

/* Every length around the block of 64, and every cut of it in two. */
static void pieces_do_not_matter(void)
{
    enum { LONGEST = 140 };
    unsigned char bytes[LONGEST];
    kw_rng r = kw_rng_at(5, 0, 0, 0);

    for (int i = 0; i < LONGEST; i++)
        bytes[i] = (unsigned char)kw_rng_below(&r, 256);
    for (size_t length = 0; length <= LONGEST; length++)
        for (size_t cut = 0; cut <= length; cut++) {
            char whole[KW_SHA256_TEXT], parts[KW_SHA256_TEXT];
            kw_sha256 s = kw_sha256_begin();

            sum_of(bytes, length, whole);
            kw_sha256_add(&s, bytes, cut);
            kw_sha256_add(&s, bytes + cut, length - cut);
            kw_sha256_end(&s, parts);
            CHECK(strcmp(whole, parts) == 0, "%zu of %zu", cut, length);
        }
}

static void files(void)
{
    char text[KW_SHA256_TEXT];
    uint64_t bytes = 1;
    int error = kw_sha256_file("/dev/null", text, &bytes);

    CHECK(error == 0 && bytes == 0 && strncmp(text, "e3b0c442", 8) == 0, "%d %s", error,
          text);
    error = kw_sha256_file("/nonexistent/file", text, &bytes);
    CHECK(error == ENOENT, "%d", error);
    error = kw_sha256_file("/", text, NULL);
    CHECK(error == EISDIR, "%d", error);
}

int main(void)
{
    test_run("sha256: known answers", known_answers);
    test_run("sha256: a million letters", a_million_letters);
    test_run("sha256: the same without the processor's instructions", both_ways_agree);
    test_run("sha256: pieces do not matter", pieces_do_not_matter);
    test_run("sha256: files, and what is none", files);
    return test_end();
}
