/* convlayer.h -- what the tests of convolutional layers share: random layers, integers and
   a property held over many of them. */
#ifndef CONVLAYER_H
#define CONVLAYER_H

#include "conv.h"
#include "need.h"
#include "test.h"
#include <stdlib.h>

enum {
    ROUNDS = 300, /* random layers a property is held over */
    COUNT = 3     /* samples of a batch */
};

/* A third of them are signals. Filters up to the largest that a layer takes, and strides up
   to ones that leave a single output. */
static inline kw_conv random_layer(kw_rng *r)
{
    kw_conv l = {.in_channels = 1 + kw_rng_below(r, 3),
                 .rows = kw_rng_below(r, 3) ? 1 + kw_rng_below(r, 6) : 1,
                 .columns = 1 + kw_rng_below(r, 6),
                 .out_channels = 1 + kw_rng_below(r, 3),
                 .stride = 1 + kw_rng_below(r, 3),
                 .padding = (kw_conv_padding)kw_rng_below(r, 3)};
    int wide = l.padding != KW_CONV_VALID;

    l.filter_rows = 1 + kw_rng_below(r, wide ? 2 * l.rows - 1 : l.rows);
    l.filter_columns = 1 + kw_rng_below(r, wide ? 2 * l.columns - 1 : l.columns);
    return kw_conv_layer(l);
}

static inline double *new_numbers(int count)
{
    double *a = kw_need_memory((size_t)count, sizeof *a);

    test_poison(a, count);
    return a;
}

/* Integers in -9 .. 9: sums of products of two are exact. */
static inline double *new_integers(kw_rng *r, int count)
{
    double *a = new_numbers(count);

    for (int i = 0; i < count; i++)
        a[i] = kw_rng_below(r, 19) - 9;
    return a;
}

static inline double dot(int count, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* --- a property over random layers --- */

typedef void layer_property(const kw_conv *l, kw_rng *r);

static layer_property *held;

static inline void over_layers(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        kw_rng r = kw_rng_at(90, 0, (uint64_t)round, 0);
        kw_conv l = random_layer(&r);

        held(&l, &r);
    }
}

static inline void run_over_layers(const char *name, layer_property *holds)
{
    held = holds;
    test_run(name, over_layers);
}

#endif
