/* Exercise 1 -- a knot written once, twice and three times.

   What to see: nothing to look at. Every copy of the knot adds a function to the basis and takes
   one away at the knot, as long as there is more than one.

   Book: section 1.1, Definitions 2 and 3.
   Claims: bs.predict.*
   Chosen here: degree 2, four equal cells on [0,1], the knot in the middle. */

#include "bspline.h" /* the spaces and their functions */
#include "claim.h"   /* what we found, for the ledger */
#include "out.h"     /* reports are files */

enum { DEGREE = 2, CELLS = 4, MIDDLE = 2, MOST = DEGREE + 1 };

/* The space whose middle breakpoint is written `times` times, all others once. */
static kw_bspline *new_space(int times)
{
    double tau[CELLS + 1];
    int mu[CELLS - 1];

    for (int i = 0; i <= CELLS; i++)
        tau[i] = (double)i / CELLS;
    for (int i = 1; i < CELLS; i++)
        mu[i - 1] = i == MIDDLE ? times : 1;
    return kw_bspline_new_open(DEGREE, CELLS, tau, mu);
}

/* How many functions are not zero at x. */
static int count_at(const kw_bspline *s, double x)
{
    double value[DEGREE + 1];
    int count = 0;

    kw_bspline_basis(s, x, value);
    for (int j = 0; j <= DEGREE; j++)
        count += value[j] != 0;
    return count;
}

int main(void)
{
    static const char *const dimension[MOST] = {
        "bs.predict.dimension.1", "bs.predict.dimension.2", "bs.predict.dimension.3"};
    static const char *const middle[MOST] = {"bs.predict.middle.1", "bs.predict.middle.2",
                                             "bs.predict.middle.3"};
    kw_out *report = kw_claim_new("ex_predict_knots");

    for (int times = 1; times <= MOST; times++) {
        kw_bspline *s = new_space(times);

        kw_claim_count(report, dimension[times - 1], s->n);
        kw_claim_count(report, middle[times - 1], count_at(s, (double)MIDDLE / CELLS));
        kw_bspline_free(s);
    }
    return kw_out_close(report);
}
