/* Exercise 6 -- two convolutional layers behind each other, against a single one.

   What to see: nothing to look at. A layer or two without an activation are linear, so the
   derivatives of an output with respect to the inputs are the weights of the single layer that
   does the same. What the weights of the two can change in these is a rank.

   Book: section 1.2, Definition 11 and its three properties.
   Claims: cnn.predict.*
   Chosen here: filters of 3 x 3, an image of 7 x 7, its middle output; stride 1, no padding. */

#include "claim.h" /* what we found, for the ledger */
#include "dense.h" /* the rank */
#include "net.h"   /* layers behind each other */
#include "out.h"   /* reports are files */
#include "rng.h"   /* weights */

enum {
    FILTER = 3,
    BOTH = 2 * FILTER - 1, /* rows of the single filter */
    IMAGE = 7,
    MOST = IMAGE * IMAGE + 1,      /* inputs, or weights and a bias */
    WEIGHTS = FILTER * FILTER,     /* of one of the two */
    PARAMETERS = 2 * (WEIGHTS + 1) /* of the two */
};

/* A layer with one filter, size x size, behind a net that gives an image, side x side. */
static int add_filter(kw_net *n, int side, int size)
{
    const kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                              .rows = side,
                                              .columns = side,
                                              .out_channels = 1,
                                              .filter_rows = size,
                                              .filter_columns = size,
                                              .stride = 1});

    kw_net_add_conv(n, &l);
    return l.out_rows;
}

/* Two layers on an image of side x side. */
static kw_net *new_two(int side)
{
    kw_net *n = kw_net_new(side * side);

    add_filter(n, add_filter(n, side, FILTER), FILTER);
    return n;
}

/* dx, n->in: the derivatives of the middle output under the parameters w. */
static void derivatives(const kw_net *n, const double *w, double *dx)
{
    kw_net_work *work = kw_net_work_new(n, 1);
    double x[MOST] = {0}, y[MOST], dy[MOST] = {0}, dw[MOST] = {0};

    dy[n->out / 2] = 1;
    kw_net_forward(n, w, 1, x, work, y);
    kw_net_backward(n, w, 1, x, y, dy, work, dx, dw);
    kw_net_work_free(work);
}

/* seen[i]: does the middle output see input i? Returns how many it sees. */
static int count_seen(const kw_net *n, int *seen)
{
    double ones[MOST], dx[MOST];
    int count = 0;

    for (int i = 0; i < MOST; i++)
        ones[i] = 1;
    derivatives(n, ones, dx);
    for (int i = 0; i < n->in; i++) {
        seen[i] = dx[i] != 0;
        count += seen[i];
    }
    return count;
}

/* In how many directions the single filter can change if the weights of the two do: it is
   linear in either filter, so a one in place of a weight, and zeros in place of the others of
   this filter, give a row. */
static int count_directions(double *gap)
{
    kw_net *n = new_two(BOTH);
    kw_rng r = kw_rng_at(66, 0, 0, 0);
    double w[PARAMETERS], row[2 * WEIGHTS * BOTH * BOTH];
    int rank;

    for (int i = 0; i < PARAMETERS; i++)
        w[i] = 1 + kw_rng_below(&r, 9);
    for (int i = 0; i < 2 * WEIGHTS; i++) {
        const int first = i / WEIGHTS * (WEIGHTS + 1); /* of the filter of weight i */
        double moved[PARAMETERS];

        for (int j = 0; j < PARAMETERS; j++)
            moved[j] = first <= j && j < first + WEIGHTS ? 0 : w[j];
        moved[first + i % WEIGHTS] = 1;
        derivatives(n, moved, row + (size_t)i * BOTH * BOTH);
    }
    rank = kw_dense_rank(2 * WEIGHTS, BOTH * BOTH, row, gap);
    kw_net_free(n);
    return rank;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_predict_filters");
    kw_net *two = new_two(IMAGE), *one = kw_net_new(IMAGE * IMAGE);
    int seen[MOST], seen_by_one[MOST], differ = 0;
    double gap;

    add_filter(one, IMAGE, BOTH);
    kw_claim_count(report, "cnn.predict.seen", count_seen(two, seen));
    kw_claim_count(report, "cnn.predict.weights", two->parameters - two->layers);

    count_seen(one, seen_by_one);
    for (int i = 0; i < IMAGE * IMAGE; i++)
        differ += seen[i] != seen_by_one[i];
    kw_claim_count(report, "cnn.predict.one.differ", differ);
    kw_claim_count(report, "cnn.predict.one.weights", one->parameters - one->layers);

    kw_claim_count(report, "cnn.predict.directions", count_directions(&gap));
    kw_claim_real(report, "cnn.predict.slack", 1 / gap);
    kw_net_free(two);
    kw_net_free(one);
    return kw_out_close(report);
}
