/* npy.h -- what stands in a NPY file: a header, then numbers of 8 bytes, the least significant
   first, row-major. Version 1.0; the data begin at a multiple of 64 bytes.
   [NumPy Enhancement Proposal 1, A simple file format for NumPy arrays] */
#ifndef KW_NPY_H
#define KW_NPY_H

#include <stddef.h>
#include <stdint.h>

/* The longest header, and the most dimensions. */
enum { KW_NPY_HEADER = 192, KW_NPY_DIMENSIONS = 4 };

/* The header of an array of the type "<f8" (doubles) or "<i8" (integers) in the given shape of
   1 to 4 dimensions: header[0 .. KW_NPY_HEADER-1], of which it returns the length. */
size_t kw_npy_header(const char *type, int dimensions, const size_t *shape,
                     unsigned char *header);

/* The numbers a[0..count-1] as 8 * count bytes, whatever the machine's own order. */
void kw_npy_doubles(size_t count, const double *a, unsigned char *bytes);
void kw_npy_integers(size_t count, const int64_t *a, unsigned char *bytes);

#endif
