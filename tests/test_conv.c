#include "convlayer.h"
#include <math.h>

enum {
    WALL = 6, /* rows and columns around a grid in the reference */
    SIDE = 6 + 2 * WALL
};

/* --- the reference: a grid with a wall of zeros or copies around it, and two loops --- */

static void build_wall(const kw_conv *l, const double *grid, double wall[SIDE][SIDE])
{
    for (int i = 0; i < l->rows + 2 * WALL; i++)
        for (int j = 0; j < l->columns + 2 * WALL; j++) {
            int row = i - WALL, column = j - WALL;
            int inside = row >= 0 && row < l->rows && column >= 0 && column < l->columns;

            if (l->padding == KW_CONV_CIRCULAR)
                wall[i][j] = grid[(row + WALL * l->rows) % l->rows * l->columns +
                                  (column + WALL * l->columns) % l->columns];
            else
                wall[i][j] = inside ? grid[row * l->columns + column] : 0;
        }
}

/* One number of the output: that of output channel o at (r, c), with filters that are turned
   or not. */
static double reference(const kw_conv *l, int turned, const double *w, const double *x,
                        int o, int r, int c)
{
    int H = l->filter_rows, W = l->filter_columns, wide = l->padding != KW_CONV_VALID;
    int top = WALL + r * l->stride - (wide ? (H - 1) / 2 : 0);
    int left = WALL + c * l->stride - (wide ? (W - 1) / 2 : 0);
    double wall[SIDE][SIDE] = {{0}}, sum = 0;

    for (int channel = 0; channel < l->in_channels; channel++) {
        const double *filter = w + (o * l->in_channels + channel) * H * W;

        build_wall(l, x + channel * l->rows * l->columns, wall);
        for (int a = 0; a < H; a++)
            for (int b = 0; b < W; b++)
                sum += wall[top + a][left + b] *
                       (turned ? filter[(H - 1 - a) * W + W - 1 - b] : filter[a * W + b]);
    }
    return sum;
}

static void check_against_reference(const kw_conv *l, int turned, const double *w,
                                    const double *x, const double *b, const double *y)
{
    for (int o = 0; o < l->out_channels; o++)
        for (int r = 0; r < l->out_rows; r++)
            for (int c = 0; c < l->out_columns; c++) {
                double got = *y++;
                double wanted = reference(l, turned, w, x, o, r, c) + (b ? b[o] : 0);

                CHECK(got == wanted, "map %d (%d, %d): %g, not %g", o, r, c, got, wanted);
            }
}

static void both_operators_are_a_double_loop(const kw_conv *l, kw_rng *r)
{
    double *w = new_integers(r, l->parameters), *x = new_integers(r, l->in);
    double *y = new_numbers(l->out + 1);

    kw_conv_correlate(l, w, x, y);
    check_against_reference(l, 0, w, x, NULL, y);
    kw_conv_convolve(l, w, x, y);
    check_against_reference(l, 1, w, x, NULL, y);
    CHECK(isnan(y[l->out]), "more than %d numbers", l->out);
    free(w);
    free(x);
    free(y);
}

static void the_layer_adds_a_bias_to_each_map(const kw_conv *l, kw_rng *r)
{
    double *w = new_integers(r, l->parameters), *x = new_integers(r, COUNT * l->in);
    double *y = new_numbers(COUNT * l->out + 1);

    kw_conv_forward(l, w, COUNT, x, y);
    for (int s = 0; s < COUNT; s++)
        check_against_reference(l, 0, w, x + s * l->in,
                                w + l->parameters - l->out_channels, y + s * l->out);
    CHECK(isnan(y[COUNT * l->out]), "more than %d numbers", COUNT * l->out);
    free(w);
    free(x);
    free(y);
}

/* --- (22) --- */

/* A filter of the size of the grid: the sum as it is printed, with indices from 1; the same
   if grid and filter change places; and the middle of a convolution of polynomials. */
static void equal_sizes_give_equation_22(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        kw_rng r = kw_rng_at(91, 0, (uint64_t)round, 0);
        int m = 1 + kw_rng_below(&r, 5), n = 1 + kw_rng_below(&r, 5);
        kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                            .rows = m,
                                            .columns = n,
                                            .out_channels = 1,
                                            .filter_rows = m,
                                            .filter_columns = n,
                                            .stride = 1});
        double *A = new_integers(&r, m * n), *W = new_integers(&r, m * n);
        double sum = 0, AW = NAN, WA = NAN;

        for (int i = 0; i <= m - 1; i++)
            for (int j = 0; j <= n - 1; j++)
                sum += A[(m - i - 1) * n + (n - j - 1)] * W[(1 + i - 1) * n + 1 + j - 1];
        kw_conv_convolve(&l, W, A, &AW);
        kw_conv_convolve(&l, A, W, &WA);
        CHECK(l.out == 1, "%d numbers", l.out);
        CHECK(AW == sum && WA == sum, "%d x %d: %g, %g, not %g", m, n, AW, WA, sum);
        free(A);
        free(W);
    }
}

/* The audit's two examples, by hand. */
static void small_examples(void)
{
    const double A[] = {1, 2, 3, 4}, W[] = {1, 0, 0, 0}, a[] = {1, 2, 3},
                 w[] = {1, 0, -1};
    kw_conv square = kw_conv_layer((kw_conv){.in_channels = 1,
                                             .rows = 2,
                                             .columns = 2,
                                             .out_channels = 1,
                                             .filter_rows = 2,
                                             .filter_columns = 2,
                                             .stride = 1});
    kw_conv line = kw_conv_layer((kw_conv){.in_channels = 1,
                                           .rows = 1,
                                           .columns = 3,
                                           .out_channels = 1,
                                           .filter_rows = 1,
                                           .filter_columns = 3,
                                           .stride = 1});
    double y = NAN;

    kw_conv_convolve(&square, W, A, &y);
    CHECK(y == 4, "%g", y);
    kw_conv_correlate(&square, W, A, &y);
    CHECK(y == 1, "%g", y);
    kw_conv_convolve(&line, w, a, &y);
    CHECK(y == 2, "%g", y);
    kw_conv_correlate(&line, w, a, &y);
    CHECK(y == -2, "%g", y);
}

/* The order of NumPy's `same' would be 1, 12, 23. */
static void an_even_filter_is_turned_in_its_place(void)
{
    const double filter[] = {1, 10}, signal[] = {1, 2, 3};
    kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                        .rows = 1,
                                        .columns = 3,
                                        .out_channels = 1,
                                        .filter_rows = 1,
                                        .filter_columns = 2,
                                        .stride = 1,
                                        .padding = KW_CONV_SAME});
    double y[3] = {NAN, NAN, NAN};

    kw_conv_convolve(&l, filter, signal, y);
    CHECK(y[0] == 12 && y[1] == 23 && y[2] == 30, "%g %g %g", y[0], y[1], y[2]);
}

/* --- shapes --- */

/* (3 -> 8 maps of 32 x 32, filter 5 x 3): sizes and counts by hand. */
static void check_sizes(kw_conv_padding padding, int stride, int rows, int columns)
{
    kw_conv l = kw_conv_layer((kw_conv){.in_channels = 3,
                                        .rows = 32,
                                        .columns = 32,
                                        .out_channels = 8,
                                        .filter_rows = 5,
                                        .filter_columns = 3,
                                        .stride = stride,
                                        .padding = padding});

    CHECK(l.out_rows == rows && l.out_columns == columns,
          "padding %d, stride %d: %d x %d", (int)padding, stride, l.out_rows,
          l.out_columns);
    CHECK(l.in == 3 * 1024 && l.out == 8 * rows * columns, "%d and %d", l.in, l.out);
    CHECK(l.parameters == 8 * (3 * 15 + 1), "%d parameters", l.parameters);
}

static void sizes_are_those_by_hand(void)
{
    check_sizes(KW_CONV_VALID, 1, 28, 30);
    check_sizes(KW_CONV_VALID, 2, 14, 15);
    check_sizes(KW_CONV_VALID, 28, 1, 2);
    check_sizes(KW_CONV_SAME, 1, 32, 32);
    check_sizes(KW_CONV_SAME, 3, 11, 11);
    check_sizes(KW_CONV_CIRCULAR, 2, 16, 16);
    check_sizes(KW_CONV_CIRCULAR, 31, 2, 2);
}

/* --- what follows from the sums --- */

/* Moving the input around the circle moves the output, to the bit: any numbers. */
static void circular_layers_move_with_their_input(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        kw_rng r = kw_rng_at(92, 0, (uint64_t)round, 0);
        int m = 1 + kw_rng_below(&r, 6), n = 1 + kw_rng_below(&r, 6);
        int down = kw_rng_below(&r, m), right = kw_rng_below(&r, n);
        kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                            .rows = m,
                                            .columns = n,
                                            .out_channels = 1,
                                            .filter_rows = 1 + kw_rng_below(&r, m),
                                            .filter_columns = 1 + kw_rng_below(&r, n),
                                            .stride = 1,
                                            .padding = KW_CONV_CIRCULAR});
        double w[37], x[36], moved[36], y[36], y_moved[36];

        for (int i = 0; i < 37; i++)
            w[i] = test_random_in(&r, -1, 1);
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++) {
                x[i * n + j] = test_random_in(&r, -1, 1);
                moved[(i + down) % m * n + (j + right) % n] = x[i * n + j];
            }
        kw_conv_forward(&l, w, 1, x, y);
        kw_conv_forward(&l, w, 1, moved, y_moved);
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++)
                CHECK(y_moved[(i + down) % m * n + (j + right) % n] == y[i * n + j],
                      "%d x %d moved by (%d, %d): output (%d, %d)", m, n, down, right, i,
                      j);
    }
}

static void a_nan_reaches_the_outputs_that_see_it(void)
{
    const double w[] = {1, 2, 3, 0}, x[] = {1, 1, NAN, 1, 1, 1};
    const int seen[] = {0, 1, 1, 1, 0, 0};
    kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                        .rows = 1,
                                        .columns = 6,
                                        .out_channels = 1,
                                        .filter_rows = 1,
                                        .filter_columns = 3,
                                        .stride = 1,
                                        .padding = KW_CONV_SAME});
    double y[6];

    kw_conv_forward(&l, w, 1, x, y);
    for (int i = 0; i < 6; i++)
        CHECK(!isnan(y[i]) == !seen[i], "output %d: %g", i, y[i]);
}

int main(void)
{
    run_over_layers("conv: correlation and convolution are a double loop",
                    both_operators_are_a_double_loop);
    run_over_layers("conv: the layer adds a bias to each map of each sample",
                    the_layer_adds_a_bias_to_each_map);
    test_run("conv: a filter of the size of the grid gives (22)",
             equal_sizes_give_equation_22);
    test_run("conv: two small examples by hand", small_examples);
    test_run("conv: an even filter is turned in its place",
             an_even_filter_is_turned_in_its_place);
    test_run("conv: sizes and counts by hand", sizes_are_those_by_hand);
    test_run("conv: circular layers move with their input, to the bit",
             circular_layers_move_with_their_input);
    test_run("conv: a NaN reaches the outputs that see it",
             a_nan_reaches_the_outputs_that_see_it);
    return test_end();
}
