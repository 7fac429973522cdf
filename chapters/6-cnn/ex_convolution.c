/* Convolutional layers -- few connections, and the same weights again and again.

   What to see: the matrix of a convolutional layer is a band of three weights, all of them
   in every row; that of a fully connected layer with as many outputs is full, and no weight
   is there twice.

   Book: section 1.2, Definition 11 and the text between Figures 16 and 17.
   Claims: cnn.def11.matrix, cnn.sparse.*, cnn.sharing.*
   Chosen here: 32 inputs, a filter of 3 and no padding; a fully connected layer is written
   as one with a filter of its own for each output, as large as the input. */

#include "claim.h" /* what we found, for the ledger */
#include "conv.h"  /* both layers */
#include "need.h"  /* memory */
#include "out.h"   /* columns for gnuplot */
#include "rng.h"   /* an input */
#include <stdlib.h>

enum { IN = 32, FILTER = 3, OUT = IN - FILTER + 1 };

static kw_conv layer(int filters, int size)
{
    return kw_conv_layer((kw_conv){.in_channels = 1,
                                   .rows = 1,
                                   .columns = IN,
                                   .out_channels = filters,
                                   .filter_rows = 1,
                                   .filter_columns = size,
                                   .stride = 1});
}

/* No two are the same and none is zero; sums of products are exact. */
static void fill_weights(int count, double *w)
{
    for (int i = 0; i < count; i++)
        w[i] = (i + 1) / 8.0;
}

/* The OUT x IN matrix of the layer: column i is what it makes of the unit input i. */
static void build_matrix(const kw_conv *l, const double *w, double *A)
{
    for (int i = 0; i < IN; i++) {
        double x[IN] = {0}, y[OUT];

        x[i] = 1;
        kw_conv_correlate(l, w, x, y);
        for (int o = 0; o < OUT; o++)
            A[o * IN + i] = y[o];
    }
}

/* What a matrix says. */
typedef struct counts {
    int connections; /* entries that are not zero */
    int weights;     /* different ones among them */
    int most;        /* entries of a row at most: the inputs that an output sees */
    int apart;       /* rows in which they are not side by side */
} counts;

static int is_new(const double *A, int i)
{
    for (int j = 0; j < i; j++)
        if (A[j] == A[i])
            return 0;
    return 1;
}

static counts count(const double *A)
{
    counts n = {0};

    for (int o = 0; o < OUT; o++) {
        int first = IN, last = -1, seen = 0;

        for (int i = 0; i < IN; i++)
            if (A[o * IN + i] != 0) {
                first = i < first ? i : first;
                last = i;
                seen++;
                n.weights += is_new(A, o * IN + i);
            }
        n.connections += seen;
        n.most = seen > n.most ? seen : n.most;
        n.apart += last - first + 1 != seen;
    }
    return n;
}

static void write_matrix(kw_out *f, const char *name, const double *A)
{
    kw_out_section(f, name, "input output weight");
    for (int o = 0; o < OUT; o++)
        for (int i = 0; i < IN; i++)
            if (A[o * IN + i] != 0) {
                kw_out_number(f, i);
                kw_out_number(f, o);
                kw_out_number(f, A[o * IN + i]);
                kw_out_row(f);
            }
}

static void write_counts(kw_out *f, const char *name, const kw_conv *l, counts n)
{
    kw_out_section(f, name, "connections parameters");
    kw_out_number(f, n.connections);
    kw_out_number(f, l->parameters);
    kw_out_row(f);
}

/* Outputs for a random input that differ from the product with the matrix. */
static int count_differing(const kw_conv *l, const double *w, const double *A)
{
    kw_rng r = kw_rng_at(16, 0, 0, 0);
    double x[IN], y[OUT];
    int differ = 0;

    for (int i = 0; i < IN; i++)
        x[i] = kw_rng_below(&r, 19) - 9;
    kw_conv_correlate(l, w, x, y);
    for (int o = 0; o < OUT; o++) {
        double sum = 0;

        for (int i = 0; i < IN; i++)
            sum += A[o * IN + i] * x[i];
        differ += sum != y[o];
    }
    return differ;
}

/* How many outputs use a weight, at least: the derivative of the sum of all outputs with
   respect to it, for inputs one. */
static int least_uses(const kw_conv *l, const double *w)
{
    double ones[IN], y[OUT], uses[FILTER + 1] = {0}, least;

    for (int i = 0; i < IN; i++)
        ones[i] = 1;
    kw_conv_forward(l, w, 1, ones, y);
    kw_conv_backward(l, w, 1, ones, y, ones, NULL, uses);
    least = uses[0];
    for (int i = 1; i < FILTER; i++)
        least = uses[i] < least ? uses[i] : least;
    return (int)least;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_convolution"), *report = kw_claim_new("ex_convolution");
    const kw_conv conv = layer(1, FILTER), full = layer(OUT, IN);
    double *w = kw_need_memory((size_t)full.parameters, sizeof *w);
    double A[OUT * IN], B[OUT * IN];
    counts few, all;

    fill_weights(full.parameters, w);
    build_matrix(&conv, w, A);
    build_matrix(&full, w, B);
    few = count(A);
    all = count(B);
    write_matrix(f, "convolution", A);
    write_counts(f, "convolution counts", &conv, few);
    write_matrix(f, "full", B);
    write_counts(f, "full counts", &full, all);

    kw_claim_count(report, "cnn.def11.matrix", count_differing(&conv, w, A));
    kw_claim_count(report, "cnn.sparse.connections", few.connections);
    kw_claim_count(report, "cnn.sparse.connections.full", all.connections);
    kw_claim_count(report, "cnn.sparse.seen", few.most);
    kw_claim_count(report, "cnn.sparse.seen.full", all.most);
    kw_claim_count(report, "cnn.sparse.apart", few.apart);
    kw_claim_count(report, "cnn.sharing.weights", few.weights);
    kw_claim_count(report, "cnn.sharing.weights.full", all.weights);
    kw_claim_count(report, "cnn.sharing.parameters", conv.parameters);
    kw_claim_count(report, "cnn.sharing.parameters.full", full.parameters);
    kw_claim_count(report, "cnn.sharing.uses", least_uses(&conv, w));

    free(w);
    return kw_out_close(f) | kw_out_close(report);
}
