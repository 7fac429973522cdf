/* Perceptron -- what it learns, and how soon it is done.

   What to see: (a) the line of the decision after each mistake, until none is left; (b) the
   number of mistakes on many data sets, all below the bound.

   Book: section 1.2, Definition 9 and the text around (21).
   Claims: mlp.def9.*, mlp.novikoff.*, mlp.drawn.*, mlp.xor.*
   Chosen here: integer points and rate 1/2, so that weights are integers and nothing is
   rounded; 200 random data sets of 30 points that integer lines separate. */

#include "claim.h"      /* what we found, for the ledger */
#include "mlp.h"        /* two layers for XOR */
#include "out.h"        /* columns for gnuplot */
#include "perceptron.h" /* the rule, the bound */
#include "rng.h"        /* random data */
#include <math.h>
#include <stddef.h>

enum {
    M = 2,      /* features */
    COUNT = 30, /* samples of a data set */
    BOX = 16,   /* features are -BOX .. BOX */
    SETS = 200,
    DRAWN = 49, /* the set of the picture */
    PASSES = 100000
};

static const double RATE = 0.5;

typedef struct data {
    double P[COUNT * M], x[COUNT];
    double u[M + 1]; /* separates them */
} data;

static double random_integer(kw_rng *r, int size)
{
    return kw_rng_below(r, 2 * size + 1) - size;
}

/* Set number `sample`: a line u, and points on both sides of a strip around it, whose width
   is another one for every fourth set. */
static data random_data(uint64_t sample)
{
    static const double strip[] = {0, 1, 2, 4};
    kw_rng r = kw_rng_at(41, 0, sample, 0);
    data d;
    double least;

    do {
        for (int j = 0; j <= M; j++)
            d.u[j] = random_integer(&r, 5);
    } while (d.u[0] == 0 && d.u[1] == 0);
    least = fmax(1, strip[sample % 4] * (fabs(d.u[0]) + fabs(d.u[1])));
    for (int i = 0; i < COUNT; i++) {
        double *p = d.P + i * M, sum;

        do {
            for (int j = 0; j < M; j++)
                p[j] = random_integer(&r, BOX);
            sum = kw_perceptron_sum(M, d.u, p);
        } while (fabs(sum) < least);
        d.x[i] = sum > 0 ? 1 : -1;
    }
    return d;
}

/* Two points of the line w1 p1 + w2 p2 + b = 0, far outside the box. */
static void write_line(kw_out *f, const double *w, int number)
{
    double square = w[0] * w[0] + w[1] * w[1], far = 4 * BOX / sqrt(square);

    for (int end = -1; end <= 1; end += 2) {
        kw_out_number(f, -w[2] / square * w[0] - end * far * w[1]);
        kw_out_number(f, -w[2] / square * w[1] + end * far * w[0]);
        kw_out_number(f, number);
        kw_out_row(f);
    }
    kw_out_gap(f);
}

/* The points, and the line after each mistake. Returns the number of mistakes. */
static int write_training(kw_out *f, const data *d)
{
    double w[M + 1] = {0};
    int mistakes = 0, before = -1;

    kw_out_section(f, "points", "p1 p2 label");
    for (int i = 0; i < COUNT; i++) {
        kw_out_number(f, d->P[i * M]);
        kw_out_number(f, d->P[i * M + 1]);
        kw_out_number(f, d->x[i]);
        kw_out_row(f);
    }
    kw_out_section(f, "lines", "p1 p2 mistakes");
    while (mistakes != before) {
        before = mistakes;
        for (int i = 0; i < COUNT; i++)
            if (kw_perceptron_update(M, RATE, d->P + i * M, d->x[i], w) != 0) {
                mistakes++;
                if (w[0] != 0 || w[1] != 0)
                    write_line(f, w, mistakes);
            }
    }
    return mistakes;
}

/* Training on many data sets; a point of the picture each. */
static void report_training(kw_out *f, kw_out *report)
{
    int unlearned = 0, wrong = 0;
    double worst = 0;

    kw_out_section(f, "mistakes", "bound mistakes");
    for (uint64_t i = 0; i < SETS; i++) {
        data d = random_data(i);
        double w[M + 1] = {0}, bound = kw_perceptron_bound(M, COUNT, d.P, d.x, d.u);
        int clean;
        long long mistakes =
            kw_perceptron_train(M, COUNT, d.P, d.x, RATE, PASSES, w, &clean);

        unlearned += clean == 0;
        for (int k = 0; k < COUNT; k++)
            wrong += kw_perceptron_decide(M, w, d.P + (size_t)k * M) != d.x[k];
        worst = fmax(worst, (double)mistakes / bound);
        kw_out_number(f, bound);
        kw_out_number(f, (double)mistakes);
        kw_out_row(f);
    }
    kw_claim_count(report, "mlp.novikoff.unlearned", unlearned);
    kw_claim_count(report, "mlp.def9.wrong", wrong);
    kw_claim_real(report, "mlp.novikoff.worst", worst);
}

/* `Exactly one of the two' is no half-plane: every pass makes a mistake. Two layers of such
   units can say it: one of them, but not both. */
static void report_xor(kw_out *report)
{
    static const double P[] = {0, 0, 0, 1, 1, 0, 1, 1}, x[] = {-1, 1, 1, -1};
    static const int width[] = {M, 2, 1};
    static const kw_activation_kind sigma[] = {KW_SIGN, KW_SIGN};
    static const double two[] = {2, 2, -2, -2, -1,
                                 3, 1, 1,  -1}; /* at least one; at most one */
    kw_net *n = kw_mlp_new(2, width, sigma);
    kw_net_work *work = kw_net_work_new(n, 4);
    double w[M + 1] = {0}, y[4];
    int clean, wrong = 0;

    kw_perceptron_train(M, 4, P, x, RATE, PASSES, w, &clean);
    kw_net_forward(n, two, 4, P, work, y);
    for (int i = 0; i < 4; i++)
        wrong += y[i] != x[i];
    kw_claim_count(report, "mlp.xor.clean", clean);
    kw_claim_count(report, "mlp.xor.layers", wrong);
    kw_net_work_free(work);
    kw_net_free(n);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_perceptron"), *report = kw_claim_new("ex_perceptron");
    data d = random_data(DRAWN);

    kw_claim_count(report, "mlp.drawn.mistakes", write_training(f, &d));
    report_training(f, report);
    report_xor(report);
    return kw_out_close(f) | kw_out_close(report);
}
