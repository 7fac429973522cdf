/* out.h -- files that are either whole or not there.

   Every file is written to a temporary beside it, `<path>.tmp`, and renamed when it is
   complete. If anything fails on the way (no folder, no rights, a full disk), the writer
   goes quiet; closing it then says so on stderr with path and reason, removes the
   temporary, leaves an older file at that path as it was, and returns 1. So a program
   writes freely and looks once, at the end.

   A renamed file is not forced to the disk: after a power failure it may be short, or hold zeros.

   A caller's mistake (need.h) aborts as everywhere, and leaves at most a `.tmp`.

   Numbers are printed with 17 digits, which give back the same double. */
#ifndef KW_OUT_H
#define KW_OUT_H

#include <stddef.h>

/* The folder of all that is built, relative to the folder of the Makefile; the Makefile
   sets another one for another compiler. */
#ifndef KW_BUILD
#define KW_BUILD "build"
#endif

typedef struct kw_out kw_out;

/* A file to be written at `path`. Never NULL. */
kw_out *kw_out_new(const char *path);

/* Appends text in the form of printf. */
void kw_out_text(kw_out *f, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Appends bytes as they are. */
void kw_out_bytes(kw_out *f, const void *bytes, size_t count);

/* Puts bytes in place of the first ones of the file, which has at least as many; what comes next
   is appended as before. For a header that tells how much comes behind it. */
void kw_out_begin_with(kw_out *f, const void *bytes, size_t count);

/* Has anything failed so far? For who would rather stop early than write into the void. */
int kw_out_failed(const kw_out *f);

/* Gives the file up: removes the temporary and frees f, without a word. */
void kw_out_drop(kw_out *f);

/* Completes the file and frees f. 0, or 1 after a message on stderr. Aborts in the middle of a
   row; then the `.tmp` may remain. */
int kw_out_close(kw_out *f);

/* --- columns for gnuplot: build/data/<driver>.dat, in named sections --- */

/* The data file of a driver. */
kw_out *kw_out_data(const char *driver);

/* Begins a section, which gnuplot reads by `index "<name>"`. `columns` names its columns,
   separated by blanks; every row will have as many numbers. */
void kw_out_section(kw_out *f, const char *name, const char *columns);

/* The next number of the row, finite: gnuplot drops a row with a NaN in silence. */
void kw_out_number(kw_out *f, double value);

/* Ends the row, which must be full: gnuplot drops a short row in silence. */
void kw_out_row(kw_out *f);

/* An empty line: ends one curve of the section, or one line of a surface. */
void kw_out_gap(kw_out *f);

/* --- whole arrays of doubles, row-major; 0, or 1 after a message on stderr. They take any
   double as it is, NaN and infinities too: what reads them can tell, as gnuplot cannot --- */

/* CSV: the line `header`, then rows x columns numbers. */
int kw_out_csv(const char *path, const char *header, size_t rows, size_t columns,
               const double *a);

/* NPY 1.0, little-endian doubles ('<f8') in the given shape of 1 to 4 dimensions; the
   data begin at a multiple of 64 bytes.
   [NumPy Enhancement Proposal 1, A simple file format for NumPy arrays] */
int kw_out_npy(const char *path, int dimensions, const size_t *shape, const double *a);

#endif
