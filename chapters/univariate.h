/* univariate.h -- how drivers of several lessons write a univariate basis. */
#ifndef UNIVARIATE_H
#define UNIVARIATE_H

#include "bspline.h"
#include "out.h"

/* A section with the functions of s, one block each, on `cells` equal cells of [0,1], each
   function on its support alone. */
static inline void write_univariate(kw_out *f, const char *name, const kw_bspline *s,
                                    int cells)
{
    kw_out_section(f, name, "x value function");
    for (int j = 0; j < s->n; j++) {
        for (int i = 0; i <= cells; i++) {
            double x = (double)i / cells;

            if (x < s->t[j] || x > s->t[j + s->d + 1])
                continue; /* outside the support */
            kw_out_number(f, x);
            kw_out_number(f, kw_bspline_one(s, j, 0, x));
            kw_out_number(f, j);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
}

#endif
