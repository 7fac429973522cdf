/* Depth and width -- two nets that are the same polygon, at very different prices.

   What to see: (a) polygons through points of x^2, which nets of ReLU units draw exactly;
   (b) the error against the number of parameters. One wide layer has a unit for each side of
   the polygon. A deep net folds the interval in half, again and again, and has three units for
   each doubling of the sides.

   Book: section 1.2, the text before and behind Remark 9.
   Claims: mlp.square.*
   Chosen here: x^2 on [0,1] and its polygons with 2^q sides, q = 1 .. 8. All numbers are
   binary fractions, so nothing is rounded. [Yarotsky 2017] */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* the nets */
#include "need.h"  /* memory */
#include "out.h"   /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum {
    MOST = 8, /* q, at most */
    GRID =
        1024, /* cells of [0,1]: four a side at least, so that middles are among them */
    SHOWN = 2 /* q up to which polygons are drawn */
};

/* A net and its parameters. */
typedef struct polygon {
    kw_net *n;
    double *w;
} polygon;

static polygon new_polygon(int L, const int *width)
{
    kw_activation_kind sigma[MOST + 1];
    polygon a;

    for (int l = 0; l < L; l++)
        sigma[l] = l + 1 < L ? KW_RELU : KW_IDENTITY;
    a.n = kw_mlp_new(L, width, sigma);
    a.w = kw_need_memory((size_t)a.n->parameters, sizeof *a.w);
    return a;
}

static void free_polygon(polygon a)
{
    kw_net_free(a.n);
    free(a.w);
}

/* The sum of c_i max(0, x - i/n), i = 0 .. n-1, where c_i is the change of slope at i/n: a
   unit for each side. */
static polygon wide(int q)
{
    const int sides = 1 << q, width[] = {1, sides, 1};
    polygon a = new_polygon(2, width);
    double slope = 0;

    for (int i = 0; i < sides; i++) {
        double next = (2.0 * i + 1) / sides; /* of side i: ((i+1)^2 - i^2) / n */

        a.w[i] = 1;
        a.w[sides + i] = -(double)i / sides;
        a.w[2 * sides + i] = next - slope;
        slope = next;
    }
    return a; /* the last bias is zero */
}

/* x - g(x)/4 - g(g(x))/16 - ..., q terms, g the hat 2 max(0, x) - 4 max(0, x - 1/2). A layer
   has the units max(0, h), max(0, h - 1/2) and s, where h is the hat so far and s the sum so
   far, which is never negative. */
static polygon deep(int q)
{
    int width[MOST + 2] = {1};
    polygon a;
    double quarter = 1;

    for (int l = 1; l <= q; l++)
        width[l] = 3;
    width[q + 1] = 1;
    a = new_polygon(q + 1, width);
    for (int l = 1; l <= q + 1; l++) {
        int first;
        const kw_affine *map = kw_mlp_affine(a.n, l, &first);
        double *w = a.w + first;

        for (int i = 0; i < map->out; i++)
            if (l == 1)
                w[kw_affine_weight(map, i, 0)] = 1;
            else if (i < 2 && l <= q) { /* h */
                w[kw_affine_weight(map, i, 0)] = 2;
                w[kw_affine_weight(map, i, 1)] = -4;
            } else { /* s - h / 4^(l-1) */
                w[kw_affine_weight(map, i, 0)] = -2 * quarter;
                w[kw_affine_weight(map, i, 1)] = 4 * quarter;
                w[kw_affine_weight(map, i, 2)] = 1;
            }
        if (l <= q)
            w[kw_affine_bias(map, 1)] = -0.5;
        quarter /= 4;
    }
    return a;
}

static void on_grid(polygon a, double *y)
{
    kw_net_work *work = kw_net_work_new(a.n, 1);

    for (int i = 0; i <= GRID; i++) {
        double x = (double)i / GRID;

        kw_net_forward(a.n, a.w, 1, &x, work, y + i);
    }
    kw_net_work_free(work);
}

/* The largest distance from x^2 on the grid. */
static double error(const double *y)
{
    double most = 0;

    for (int i = 0; i <= GRID; i++) {
        double x = (double)i / GRID;

        most = fmax(most, fabs(y[i] - x * x));
    }
    return most;
}

static double difference(const double *y, const double *z)
{
    double most = 0;

    for (int i = 0; i <= GRID; i++)
        most = fmax(most, fabs(y[i] - z[i]));
    return most;
}

static void write_curve(kw_out *f, int sides, const double *y)
{
    for (int i = 0; i <= GRID; i += GRID / sides) {
        kw_out_number(f, (double)i / GRID);
        kw_out_number(f, y[i]);
        kw_out_row(f);
    }
    kw_out_gap(f);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_depth"), *report = kw_claim_new("ex_depth");
    double *y = kw_need_memory(GRID + 1, sizeof *y);
    double *z = kw_need_memory(GRID + 1, sizeof *z), off = 0, last = 0;
    double table[MOST + 1][3] = {{0}};

    kw_out_section(f, "polygons", "x y");
    for (int q = 1; q <= MOST; q++) {
        polygon a = wide(q), b = deep(q);

        on_grid(a, y);
        on_grid(b, z);
        off = fmax(off, difference(y, z));
        last = error(z);
        table[q][0] = kw_mlp_count(a.n);
        table[q][1] = kw_mlp_count(b.n);
        table[q][2] = last;
        if (q <= SHOWN)
            write_curve(f, 1 << q, z);
        free_polygon(a);
        free_polygon(b);
    }
    kw_out_section(f, "errors", "wide deep error");
    for (int q = 1; q <= MOST; q++) {
        for (int i = 0; i < 3; i++)
            kw_out_number(f, table[q][i]);
        kw_out_row(f);
    }
    kw_claim_real(report, "mlp.square.difference", off);
    kw_claim_real(report, "mlp.square.error", last);
    kw_claim_count(report, "mlp.square.wide", (long long)table[MOST][0]);
    kw_claim_count(report, "mlp.square.deep", (long long)table[MOST][1]);

    free(y);
    free(z);
    return kw_out_close(f) | kw_out_close(report);
}
