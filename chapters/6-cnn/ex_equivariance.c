/* Shift equivariance -- where the output of a layer moves with its input, and where not.

   What to see: the input is moved by one place; shown is by how much each output then
   differs from the old output moved along. On a circle not at all; with zeros around the
   input at the borders; with stride 2 everywhere.

   Book: section 1.2, the text between Figures 16 and 17.
   Claims: cnn.shift.*
   Chosen here: 32 inputs, a filter of 3, an image of 8 x 9; random inputs and weights. */

#include "claim.h" /* what we found, for the ledger */
#include "conv.h"  /* the layers */
#include "out.h"   /* columns for gnuplot */
#include "rng.h"   /* inputs and weights */
#include <math.h>

enum { IN = 32, FILTER = 3, ROWS = 8, COLUMNS = 9, MOST = ROWS * COLUMNS };

static kw_conv line(kw_conv_padding padding, int stride)
{
    return kw_conv_layer((kw_conv){.in_channels = 1,
                                   .rows = 1,
                                   .columns = IN,
                                   .out_channels = 1,
                                   .filter_rows = 1,
                                   .filter_columns = FILTER,
                                   .stride = stride,
                                   .padding = padding});
}

static void fill_random(uint64_t stream, int count, double *a)
{
    kw_rng r = kw_rng_at(17, stream, 0, 0);

    for (int i = 0; i < count; i++)
        a[i] = 2 * kw_rng_uniform(&r) - 1;
}

/* A grid moved around the circle, down and to the right. */
static void move(int rows, int columns, int down, int right, const double *a, double *b)
{
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            b[(i + down) % rows * columns + (j + right) % columns] = a[i * columns + j];
}

/* Outputs for the moved input that are not, to the bit, those for x moved by `out_down` and
   `out_right`. All of them, as differences, to a section of f unless that is NULL. */
static int count_differing(const kw_conv *l, const double *x, const int in[2],
                           const int out[2], kw_out *f)
{
    double w[FILTER * FILTER + 1], moved[MOST], y[MOST], y_moved[MOST];
    double wanted[MOST] = {0};
    int differ = 0;

    fill_random(0, l->parameters, w);
    move(l->rows, l->columns, in[0], in[1], x, moved);
    kw_conv_forward(l, w, 1, x, y);
    kw_conv_forward(l, w, 1, moved, y_moved);
    move(l->out_rows, l->out_columns, out[0], out[1], y, wanted);
    for (int i = 0; i < l->out; i++) {
        differ += y_moved[i] != wanted[i];
        if (!f)
            continue;
        kw_out_number(f, i);
        kw_out_number(f, fabs(y_moved[i] - wanted[i]));
        kw_out_row(f);
    }
    return differ;
}

/* The same for a signal. */
static int differing(const kw_conv *l, const double *x, int in, int out)
{
    const int by[2][2] = {{0, in}, {0, out}};

    return count_differing(l, x, by[0], by[1], NULL);
}

static int show(kw_out *f, const char *name, const kw_conv *l, const double *x, int in,
                int out)
{
    const int by[2][2] = {{0, in}, {0, out}};

    kw_out_section(f, name, "output difference");
    return count_differing(l, x, by[0], by[1], f);
}

/* Over all moves of a signal around the circle. */
static int over_all_moves(const kw_conv *l, const double *x)
{
    int differ = 0;

    for (int by = 0; by < IN; by++)
        differ += differing(l, x, by, by);
    return differ;
}

/* The same for an image. */
static int over_all_moves_of_an_image(void)
{
    const kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                              .rows = ROWS,
                                              .columns = COLUMNS,
                                              .out_channels = 1,
                                              .filter_rows = FILTER,
                                              .filter_columns = FILTER,
                                              .stride = 1,
                                              .padding = KW_CONV_CIRCULAR});
    double x[MOST];
    int differ = 0;

    fill_random(2, MOST, x);
    for (int down = 0; down < ROWS; down++)
        for (int right = 0; right < COLUMNS; right++) {
            const int by[2] = {down, right};

            differ += count_differing(&l, x, by, by, NULL);
        }
    return differ;
}

/* A signal that is zero but for its middle half moves without meeting a border, as on the
   whole line: by up to IN / 4 - 1 places. */
static int inside(const kw_conv *l, const double *x)
{
    double middle[IN] = {0};
    int differ = 0;

    for (int i = IN / 4; i < 3 * IN / 4; i++)
        middle[i] = x[i];
    for (int by = 1; by < IN / 4; by++)
        differ += differing(l, middle, by, by);
    return differ;
}

/* The fewest outputs that differ if the input moves by one and the output by anything. */
static int fewest(const kw_conv *l, const double *x)
{
    int least = l->out;

    for (int by = 0; by < l->out; by++) {
        int differ = differing(l, x, 1, by);

        least = differ < least ? differ : least;
    }
    return least;
}

int main(void)
{
    kw_out *f = kw_out_data("ex_equivariance"), *report = kw_claim_new("ex_equivariance");
    const kw_conv circular = line(KW_CONV_CIRCULAR, 1), same = line(KW_CONV_SAME, 1);
    const kw_conv valid = line(KW_CONV_VALID, 1), stride = line(KW_CONV_CIRCULAR, 2);
    double x[IN];

    fill_random(1, IN, x);
    kw_claim_count(report, "cnn.shift.border", show(f, "zeros", &same, x, 1, 1));
    kw_claim_count(report, "cnn.shift.one", show(f, "circular", &circular, x, 1, 1));
    show(f, "stride", &stride, x, 1, 1);

    kw_claim_count(report, "cnn.shift.circular", over_all_moves(&circular, x));
    kw_claim_count(report, "cnn.shift.image", over_all_moves_of_an_image());
    kw_claim_count(report, "cnn.shift.inside", inside(&same, x));
    kw_claim_count(report, "cnn.shift.valid", differing(&valid, x, 1, 1));
    kw_claim_count(report, "cnn.shift.stride", fewest(&stride, x));
    kw_claim_count(report, "cnn.shift.stride.outputs", stride.out);
    kw_claim_count(report, "cnn.shift.stride.two", differing(&stride, x, 2, 1));
    return kw_out_close(f) | kw_out_close(report);
}
