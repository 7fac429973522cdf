/* meshtext.h -- the lines of a mesh file (meshfile.h), each of them right in itself.

   What they say together, and whether it is a mesh within the limits, meshfile.c finds out. */
#ifndef KW_MESHTEXT_H
#define KW_MESHTEXT_H

#include "meshfile.h"

/* What has been read so far. Begin with zeros, a name and a place for messages. */
typedef struct kw_meshtext {
    const char *name; /* of the file */
    char *message;    /* KW_MESHFILE_MESSAGE characters */
    int line; /* the present one, from 1; 0 for complaints on the file as a whole */
    int D;    /* directions, 0 before `degree` */
    int degree[KW_TENSOR_D];
    int directions;                  /* of which the knots are known */
    kw_bspline *s[KW_TENSOR_D];      /* their spaces; owned, as all that follows */
    int (*box)[1 + 2 * KW_TENSOR_D]; /* level, low, high of each refine line */
    int *box_line;                   /* the line it stands in */
    size_t boxes, room;
} kw_meshtext;

/* Notes what is wrong in the present line; always 1. */
int kw_meshtext_wrong(kw_meshtext *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Reads `size` characters of text. 0, or 1 after a complaint. */
int kw_meshtext_read(kw_meshtext *r, const char *text, size_t size);

/* Frees what r owns. */
void kw_meshtext_clear(kw_meshtext *r);

#endif
