#include "npy.h"
#include "need.h"
#include <stdio.h>
#include <string.h>

enum { PREAMBLE = 10, ALIGNMENT = 64, SIZE = 8 /* bytes of a number */ };

size_t kw_npy_header(const char *type, int dimensions, const size_t *shape,
                     unsigned char *header)
{
    char text[KW_NPY_HEADER];
    size_t length, total;

    KW_NEED(1 <= dimensions && dimensions <= KW_NPY_DIMENSIONS, "%d dimensions",
            dimensions);
    length = (size_t)snprintf(text, sizeof text,
                              "{'descr': '%s', 'fortran_order': False, 'shape': (", type);
    for (int i = 0; i < dimensions; i++)
        length += (size_t)snprintf(text + length, sizeof text - length, "%zu%s", shape[i],
                                   i + 1 == dimensions ? "" : ", ");
    length += (size_t)snprintf(text + length, sizeof text - length, "%s), }",
                               dimensions == 1 ? "," : "");

    /* blanks, then a newline, up to the next multiple of the alignment */
    total = (PREAMBLE + length + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    memset(header, ' ', total);
    memcpy(header, "\x93NUMPY\x01\x00", PREAMBLE - 2);
    header[PREAMBLE - 2] = (unsigned char)((total - PREAMBLE) & 0xff);
    header[PREAMBLE - 1] = (unsigned char)((total - PREAMBLE) >> 8);
    memcpy(header + PREAMBLE, text, length);
    header[total - 1] = '\n';
    return total;
}

/* The machine's own order is the right one nearly everywhere. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
enum { OWN_ORDER = 1 };
#else
enum { OWN_ORDER = 0 };
#endif

/* `count` numbers of 8 bytes, from the machine's own order. */
static void write_numbers(size_t count, const void *a, unsigned char *bytes)
{
    const unsigned char *from = a;

    if (OWN_ORDER) {
        memcpy(bytes, a, count * SIZE);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;

        memcpy(&bits, from + SIZE * i, sizeof bits);
        for (int k = 0; k < SIZE; k++)
            bytes[SIZE * i + (size_t)k] = (unsigned char)(bits >> (8 * k));
    }
}

void kw_npy_doubles(size_t count, const double *a, unsigned char *bytes)
{
    write_numbers(count, a, bytes);
}

void kw_npy_integers(size_t count, const int64_t *a, unsigned char *bytes)
{
    write_numbers(count, a, bytes);
}
