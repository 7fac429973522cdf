/* truncation.h -- the THB-splines on a cell, on the way down from level to level.

   A table holds THB-splines that are not zero on a cell, as combinations of the local functions
   of the cell (active.h). That of a child is made of it: the functions are written in those of the
   child's level, and truncated. [source text, Definition 5, (15), (16)] */
#ifndef KW_TRUNCATION_H
#define KW_TRUNCATION_H

#include "active.h"
#include "twoscale.h"

typedef struct kw_truncation {
    int local;    /* local functions of a cell */
    int count;    /* THB-splines */
    int *index;   /* count: their indices, ascending; owned, as all that follows */
    double *row;  /* local x count: their coefficients */
    double *work; /* as large as row */
    int room;     /* THB-splines that there is memory for */
} kw_truncation;

/* An empty table; it is used again for every cell of a level. The caller frees. Never NULL. */
kw_truncation *kw_truncation_new(int local);
void kw_truncation_free(kw_truncation *t);

/* From the table of a cell to that of its child number `child` (twoscale.h), t, still without the
   active functions of the child's level; is[0..local-1]: what the child's local functions are. */
void kw_truncation_refine(const kw_truncation *cell, const kw_twoscale *halves, int child,
                          const int *is, kw_truncation *t);

/* Appends the active functions of the cell's level, each one of the local functions. */
void kw_truncation_add(kw_truncation *t, const int *is);

#endif
