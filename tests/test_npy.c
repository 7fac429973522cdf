/* test_npy.c -- bytes of NPY files; test_out.c has those of whole files. */
#include "npy.h"
#include "test.h"
#include <stdio.h>
#include <string.h>

static void headers(void)
{
    static const size_t shape[] = {3, 2, 1, 7};
    static const char *const words[] = {"(3,), }", "(3, 2), }", "(3, 2, 1), }",
                                        "(3, 2, 1, 7), }"};

    for (int dimensions = 1; dimensions <= KW_NPY_DIMENSIONS; dimensions++) {
        unsigned char header[KW_NPY_HEADER];
        char wanted[KW_NPY_HEADER];
        size_t length = kw_npy_header("<i8", dimensions, shape, header);

        snprintf(wanted, sizeof wanted,
                 "{'descr': '<i8', 'fortran_order': False, 'shape': %s",
                 words[dimensions - 1]);
        CHECK(length == 128, "%zu", length);
        CHECK(memcmp(header, "\x93NUMPY\x01\x00\x76\x00", 10) == 0, "preamble");
        CHECK(memcmp(header + 10, wanted, strlen(wanted)) == 0, "%.118s", header + 10);
        CHECK(header[127] == '\n' && header[126] == ' ', "its end");
    }
}

/* The longest shape still fits; the length is a multiple of 64. */
static void the_longest_header(void)
{
    static const size_t shape[] = {SIZE_MAX, SIZE_MAX, SIZE_MAX, SIZE_MAX};
    unsigned char header[KW_NPY_HEADER];
    size_t length = kw_npy_header("<f8", KW_NPY_DIMENSIONS, shape, header);

    CHECK(length <= KW_NPY_HEADER && length % 64 == 0, "%zu", length);
    CHECK(header[length - 1] == '\n', "its end");
}

static void numbers(void)
{
    static const int64_t integers[] = {1, -2, INT64_MIN, 0x0102030405060708};
    static const double doubles[] = {1, -0.1};
    static const unsigned char wanted[] = {
        1, 0, 0, 0, 0, 0, 0,    0,    0xfe, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,
        0, 0, 0, 0, 0, 0, 0,    0x80, 8,    7,    6,    5,    4,    3,    2,    1,
        0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0x9a, 0x99, 0x99, 0x99, 0x99, 0x99, 0xb9, 0xbf};
    unsigned char bytes[sizeof wanted];

    kw_npy_integers(4, integers, bytes);
    kw_npy_doubles(2, doubles, bytes + sizeof integers);
    CHECK(memcmp(bytes, wanted, sizeof wanted) == 0, "bytes");
}

static void five_dimensions(void)
{
    static const size_t shape[] = {1, 1, 1, 1, 1};
    unsigned char header[KW_NPY_HEADER];

    kw_npy_header("<f8", 5, shape, header);
}

static void dimensions_have_bounds(void)
{
    test_aborts("5 dimensions", five_dimensions);
}

int main(void)
{
    test_run("npy: headers", headers);
    test_run("npy: the longest header", the_longest_header);
    test_run("npy: numbers have the least significant byte first", numbers);
    test_run("npy: 1 to 4 dimensions", dimensions_have_bounds);
    return test_end();
}
