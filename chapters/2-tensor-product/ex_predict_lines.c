/* Exercise 2 -- what it costs to split one cell, and two.

   What to see: nothing to look at. A tensor product splits a cell by a knot line in each
   direction, and a line runs through the whole box.

   Book: section 1.1, the text around Figure 7.
   Claims: tp.predict.*
   Chosen here: bi-degree (2,2) on 6 x 6 equal cells, and the marked cells. */

#include "bspline.h" /* the univariate spaces */
#include "claim.h"   /* what we found, for the ledger */
#include "insert.h"  /* one more knot */
#include "out.h"     /* reports are files */
#include "picture.h" /* cells of a grid */
#include "tensor.h"  /* their product */

enum { DEGREE = 2, CELLS = 6 };

/* The marked cells, by the number of their span in either direction. */
static const int marked[][2] = {{2, 2}, {2, 3}}; /* they share an edge */

/* The spans of direction h that hold one of the first `count` marked cells, halved. */
static kw_bspline *new_halved(int h, int count)
{
    kw_bspline *s = kw_bspline_new_open_uniform(DEGREE, CELLS, 0, 1);

    for (int i = 0; i < CELLS; i++) {
        kw_bspline *next;
        int hit = 0;

        for (int c = 0; c < count; c++)
            hit |= marked[c][h] == i;
        if (!hit)
            continue;
        next = kw_insert_new_knot(s, (i + 0.5) / CELLS);
        kw_bspline_free(s);
        s = next;
    }
    return s;
}

/* The smallest tensor product that splits the first `count` marked cells. */
static kw_tensor *new_split(int count)
{
    kw_bspline *halved[2] = {new_halved(0, count), new_halved(1, count)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)halved);

    kw_bspline_free(halved[0]);
    kw_bspline_free(halved[1]);
    return g;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_predict_lines");
    kw_tensor *one = new_split(1), *two = new_split(2);

    kw_claim_count(report, "tp.predict.one.cells", count_cells(one));
    kw_claim_count(report, "tp.predict.one.functions", kw_tensor_dimension(one));
    kw_claim_count(report, "tp.predict.two.cells", count_cells(two));
    kw_claim_count(report, "tp.predict.two.functions", kw_tensor_dimension(two));

    kw_tensor_free(one);
    kw_tensor_free(two);
    return kw_out_close(report);
}
