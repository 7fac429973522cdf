/* Pieces of a ReLU net -- depth multiplies them, width adds them.

   What to see: a hat of two ReLU units, applied again and again; each layer doubles the
   number of straight pieces. The same number of units in one layer makes one piece more than
   there are units.

   Book: section 1.2, the text on depth behind Remark 9.
   Claims: mlp.depth.*
   Chosen here: the hat 2 max(0, x) - 4 max(0, x - 1/2), up to eight times. All numbers are
   binary fractions, so nothing is rounded. [Telgarsky 2016] */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* the nets */
#include "need.h"  /* memory */
#include "out.h"   /* columns for gnuplot */
#include "rng.h"   /* slopes of the wide net */
#include <stdlib.h>

enum {
    TEETH = 8,        /* hats on hats, at most */
    SHOWN = 3,        /* of them drawn */
    GRID = 512,       /* cells of [0,1]: a multiple of the pieces */
    WIDTH = 2 * TEETH /* units of the deepest net */
};

/* The values of a net of one input and one output on the grid of [0,1], GRID + 1 of them. */
static void on_grid(const kw_net *n, const double *w, double *y)
{
    kw_net_work *work = kw_net_work_new(n, 1);

    for (int i = 0; i <= GRID; i++) {
        double x = (double)i / GRID;

        kw_net_forward(n, w, 1, &x, work, y + i);
    }
    kw_net_work_free(work);
}

/* Straight pieces: the grid contains all joints, and second differences are exact. */
static int count_pieces(const double *y)
{
    int pieces = 1;

    for (int i = 1; i < GRID; i++)
        pieces += y[i - 1] - 2 * y[i] + y[i + 1] != 0;
    return pieces;
}

/* The hat, `times` times: each hidden layer is max(0, h), max(0, h - 1/2) of the hat
   h = 2 u_1 - 4 u_2 before it. */
static void sawtooth(int times, double *y)
{
    int width[TEETH + 2] = {1};
    kw_activation_kind sigma[TEETH + 1];
    double w[6 * TEETH + 3], *next = w;
    kw_net *n;

    for (int l = 1; l <= times + 1; l++) {
        int last = l == times + 1;

        width[l] = last ? 1 : 2;
        sigma[l - 1] = last ? KW_IDENTITY : KW_RELU;
        for (int i = 0; i < width[l]; i++) { /* a row of weights for each unit */
            if (l == 1)
                *next++ = 1;
            else {
                *next++ = 2;
                *next++ = -4;
            }
        }
        for (int i = 0; i < width[l]; i++)
            *next++ = i == 0 ? 0 : -0.5;
    }
    n = kw_mlp_new(times + 1, width, sigma);
    on_grid(n, w, y);
    kw_net_free(n);
}

/* As many units in one hidden layer: the joints of unit i at (2i+1) / (2 WIDTH), all of them
   different, and random slopes. Each unit adds at most one joint. */
static void shallow(double *y)
{
    const int width[] = {1, WIDTH, 1};
    const kw_activation_kind sigma[] = {KW_RELU, KW_IDENTITY};
    kw_net *n = kw_mlp_new(2, width, sigma);
    double w[3 * WIDTH + 1];
    kw_rng r = kw_rng_at(58, 0, 0, 0);

    for (int i = 0; i < WIDTH; i++) {
        w[i] = 1;
        w[WIDTH + i] = -(2 * i + 1) / (2.0 * WIDTH);
        w[2 * WIDTH + i] = 1 + kw_rng_below(&r, 8);
    }
    w[3 * WIDTH] = 0;
    on_grid(n, w, y);
    kw_net_free(n);
}

/* One curve of the picture: a value at each joint that may be there. */
static void write_grid(kw_out *f, int times, const double *y)
{
    const int step = GRID >> SHOWN;

    for (int i = 0; i <= GRID; i += step) {
        kw_out_number(f, (double)i / GRID);
        kw_out_number(f, y[i]);
        kw_out_number(f, times);
        kw_out_row(f);
    }
    kw_out_gap(f);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_pieces"), *report = kw_claim_new("ex_pieces");
    double *y = kw_need_memory(GRID + 1, sizeof *y);
    int pieces = 0, off = 0;

    kw_out_section(f, "sawtooth", "x y layers");
    for (int times = 1; times <= TEETH; times++) {
        sawtooth(times, y);
        pieces = count_pieces(y);
        off += pieces != 1 << times;
        if (times <= SHOWN)
            write_grid(f, times, y);
    }
    kw_claim_count(report, "mlp.depth.off", off);
    kw_claim_count(report, "mlp.depth.deep", pieces);
    shallow(y);
    kw_claim_count(report, "mlp.depth.shallow", count_pieces(y));

    free(y);
    return kw_out_close(f) | kw_out_close(report);
}
