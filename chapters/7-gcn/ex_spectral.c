/* Spectral convolution -- filters of frequencies, and what they do to neighbours.

   What to see: the eigenvectors of the Laplacian of a graph are its waves, slow ones first.
   The ideal filter keeps the slow half and drops the rest; seen from one node it reaches
   everywhere, while a polynomial of degree K in the Laplacian is over after K hops.

   Book: section 1.2, on spectral methods: localized filters and their cost.
   Claims: gcn.polynomial.*, gcn.ideal.*, gcn.cost.*
   Chosen here: 40 points, each joined with its four nearest, for the waves; a circle of 66
   nodes for the filters; degree 5; the ideal filter is 1 below frequency 1, the middle of
   [0,2], and 0 above; the polynomial is its Chebyshev series, cut behind that degree. */

#include "chebyshev.h"  /* the value of a series */
#include "claim.h"      /* what we found, for the ledger */
#include "elementary.h" /* the ideal filter on a circle in closed form */
#include "gcn.h"        /* the layers */
#include "graphs.h"     /* graphs and their pictures */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include "rng.h"        /* random filters */
#include <math.h>
#include <stdlib.h>

enum { CIRCLE = 66, K = 5, POINTS = 40, NEAREST = 4, CASES = 40, LARGE = 400 };

static const double PI = 3.14159265358979323846;

/* --- filters --- */

/* The first Chebyshev coefficients of the ideal filter as a function of s = frequency - 1,
   1 for s < 0 and 0 for s > 0. */
static void ideal_series(int degree, double *c)
{
    static const int sine[4] = {0, 1, 0, -1}; /* of q pi / 2 */

    c[0] = 0.5;
    for (int q = 1; q <= degree; q++)
        c[q] = -2 * sine[q % 4] / (q * PI);
}

static double ideal(double frequency)
{
    return frequency < 1;
}

/* filter, n x n: row i is what a layer with one channel and the weights w makes of a one at
   node i. */
static void filter_matrix(const kw_gcn *l, const double *w, double *filter)
{
    double *one = kw_need_memory((size_t)l->n, sizeof *one);

    for (int i = 0; i < l->n; i++) {
        one[i] = 1;
        kw_gcn_forward(l, w, 1, one, filter + (size_t)i * (size_t)l->n);
        one[i] = 0;
    }
    free(one);
}

/* The weights of the spectral layer l that give each frequency the value of the series c; no
   bias. */
static void series_weights(const kw_gcn *l, int degree, const double *c, double *w)
{
    for (int k = 0; k < l->n; k++)
        w[k] = polynomial(degree, c, l->frequency[k] - 1);
    w[l->n] = 0;
}

static void ideal_weights(const kw_gcn *l, double *w)
{
    for (int k = 0; k < l->n; k++)
        w[k] = ideal(l->frequency[k]);
    w[l->n] = 0;
}

/* --- polynomials: two ways to compute them, and how far they reach --- */

typedef struct findings {
    int beyond, missing; /* entries not zero beyond K hops, and zero within */
    int sweeps;          /* most for the eigenvectors of a graph */
    double ways;         /* largest difference of the two ways */
} findings;

/* A polynomial with random coefficients in [1/2, 1] on a graph of random points. */
static void try_polynomial(uint64_t sample, findings *all)
{
    double x[2 * POINTS] = {0}, c[K + 2] = {0}, w[POINTS + 1] = {0};
    double by_terms[POINTS * POINTS] = {0}, by_vectors[POINTS * POINTS] = {0};
    int work[POINTS], hops[POINTS], sweeps;
    kw_rng r = kw_rng_at(711, 0, sample, 0);
    kw_graph *g;
    kw_gcn *terms, *vectors;

    scatter(712, sample, POINTS, x);
    g = kw_graph_new_nearest(POINTS, 2, x, NEAREST);
    terms = kw_gcn_new_chebyshev(g, 1, 1, K);
    vectors = kw_gcn_new_spectral(g, 1, 1);
    for (int q = 0; q <= K; q++)
        c[q] = 0.5 + kw_rng_uniform(&r) / 2;
    series_weights(vectors, K, c, w);
    filter_matrix(terms, c, by_terms);
    filter_matrix(vectors, w, by_vectors);
    sweeps = count_sweeps(g);
    all->sweeps = sweeps > all->sweeps ? sweeps : all->sweeps;
    for (int i = 0; i < POINTS; i++) {
        kw_graph_hops(g, i, work, hops);
        for (int j = 0; j < POINTS; j++) {
            double entry = by_terms[i * POINTS + j];
            int near = 0 <= hops[j] && hops[j] <= K;

            all->beyond += !near && entry != 0;
            all->missing += near && entry == 0;
            all->ways = fmax(all->ways, fabs(entry - by_vectors[i * POINTS + j]));
        }
    }
    kw_gcn_free(terms);
    kw_gcn_free(vectors);
    kw_graph_free(g);
}

static void report_polynomials(kw_out *report)
{
    findings all = {0, 0, 0, 0};

    for (uint64_t sample = 0; sample < CASES; sample++)
        try_polynomial(sample, &all);
    kw_claim_count(report, "gcn.polynomial.beyond", all.beyond);
    kw_claim_count(report, "gcn.polynomial.missing", all.missing);
    kw_claim_count(report, "gcn.polynomial.sweeps", all.sweeps);
    kw_claim_real(report, "gcn.polynomial.vectors", all.ways);
}

/* --- the ideal filter on a circle --- */

/* What the ideal filter leaves of a one, j hops away: the mean of cos(2 pi k j / n) over the
   n frequencies, those with |k| <= n/4 alone; CIRCLE/4 is rounded down, and never a k. */
static double ideal_in_closed_form(int j)
{
    double sum = 1;

    for (int k = 1; k <= CIRCLE / 4; k++)
        sum += 2 * kw_cos(2 * PI * (k * j % CIRCLE) / CIRCLE);
    return sum / CIRCLE;
}

static void look_at_circle(kw_out *f, kw_out *report)
{
    kw_graph *g = new_cycle(CIRCLE);
    kw_gcn *vectors = kw_gcn_new_spectral(g, 1, 1);
    kw_gcn *terms = kw_gcn_new_chebyshev(g, 1, 1, K);
    double w[CIRCLE + 1], c[K + 2] = {0}, one[CIRCLE] = {0}, sharp[CIRCLE], cut[CIRCLE];
    double leak = 0, error = 0;

    one[0] = 1;
    ideal_weights(vectors, w);
    ideal_series(K, c);
    kw_gcn_forward(vectors, w, 1, one, sharp);
    kw_gcn_forward(terms, c, 1, one, cut);
    kw_out_section(f, "from one node", "node ideal polynomial");
    for (int place = -CIRCLE / 2; place <= CIRCLE / 2; place++) {
        int j = (place + CIRCLE) % CIRCLE;

        kw_out_number(f, place);
        kw_out_number(f, sharp[j]);
        kw_out_number(f, cut[j]);
        kw_out_row(f);
        if (abs(place) > K)
            leak = fmax(leak, fabs(sharp[j]));
        error = fmax(error, fabs(sharp[j] - ideal_in_closed_form(j)));
    }
    kw_claim_count(report, "gcn.ideal.sweeps", count_sweeps(g));
    kw_claim_real(report, "gcn.ideal.leak", leak);
    kw_claim_real(report, "gcn.ideal.opposite", fabs(sharp[CIRCLE / 2]));
    kw_claim_real(report, "gcn.ideal.closed", error);
    kw_gcn_free(vectors);
    kw_gcn_free(terms);
    kw_graph_free(g);
}

/* --- costs: multiplications for one channel of one signal, each counted where it is done --- */

/* y = c_0 x + c_1 T_1(S) x + .. + c_K T_K(S) x. */
static long long through_terms(const kw_graphmatrix *S, const double *c, const double *x,
                               double *y)
{
    double *before = kw_need_memory((size_t)S->n, sizeof *before);
    double *now = kw_need_memory((size_t)S->n, sizeof *now);
    double *next = kw_need_memory((size_t)S->n, sizeof *next);
    long long products = 0;

    for (int i = 0; i < S->n; i++) {
        now[i] = x[i];
        y[i] = c[0] * x[i];
        products++;
    }
    for (int q = 1; q <= K; q++) {
        double *done = before;

        for (int i = 0; i < S->n; i++) {
            double sum = 0;

            for (int e = S->start[i]; e < S->start[i + 1]; e++) {
                sum += S->value[e] * now[S->column[e]];
                products++;
            }
            next[i] = q == 1 ? sum : sum + sum - before[i];
            y[i] += c[q] * next[i];
            products++;
        }
        before = now;
        now = next;
        next = done;
    }
    free(before);
    free(now);
    free(next);
    return products;
}

/* y = U diag(w) U^T x, the eigenvectors being the rows of `vector`. */
static long long through_vectors(int n, const double *vector, const double *w,
                                 const double *x, double *y)
{
    long long products = 0;

    for (int i = 0; i < n; i++)
        y[i] = 0;
    for (int k = 0; k < n; k++) {
        const double *u = vector + (size_t)k * (size_t)n;
        double z = 0;

        for (int i = 0; i < n; i++) {
            z += u[i] * x[i];
            products++;
        }
        z = w[k] * z;
        products++;
        for (int i = 0; i < n; i++) {
            y[i] += u[i] * z;
            products++;
        }
    }
    return products;
}

static kw_graph *new_scattered(int n)
{
    double *x = kw_need_memory(2 * (size_t)n, sizeof *x);
    kw_graph *g;

    scatter(713, 0, n, x);
    g = kw_graph_new_nearest(n, 2, x, NEAREST);
    free(x);
    return g;
}

/* Do the two compute what the layers do? The largest difference, on random signals. */
static double difference_to_layers(void)
{
    kw_graph *g = new_scattered(POINTS);
    kw_gcn *terms = kw_gcn_new_chebyshev(g, 1, 1, K);
    kw_gcn *vectors = kw_gcn_new_spectral(g, 1, 1);
    double most = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(714, 0, sample, 0);
        double x[POINTS], w[POINTS + 1] = {0}, c[K + 2] = {0};
        double want[POINTS], y[POINTS];

        for (int i = 0; i < POINTS; i++) {
            x[i] = 2 * kw_rng_uniform(&r) - 1;
            w[i] = 2 * kw_rng_uniform(&r) - 1;
        }
        for (int q = 0; q <= K; q++)
            c[q] = 2 * kw_rng_uniform(&r) - 1;
        kw_gcn_forward(terms, c, 1, x, want);
        through_terms(terms->S, c, x, y);
        for (int i = 0; i < POINTS; i++)
            most = fmax(most, fabs(y[i] - want[i]));
        kw_gcn_forward(vectors, w, 1, x, want);
        through_vectors(POINTS, vectors->vector, w, x, y);
        for (int i = 0; i < POINTS; i++)
            most = fmax(most, fabs(y[i] - want[i]));
    }
    kw_gcn_free(terms);
    kw_gcn_free(vectors);
    kw_graph_free(g);
    return most;
}

/* How many they are does not depend on the numbers: for the large graph all may be zero, and
   its eigenvectors are not needed. */
static void report_costs(kw_out *report)
{
    kw_graph *g = new_scattered(LARGE);
    kw_gcn *terms = kw_gcn_new_chebyshev(g, 1, 1, K);
    double *zero = kw_need_memory((size_t)LARGE * LARGE, sizeof *zero);
    double y[LARGE];

    kw_claim_real(report, "gcn.cost.layers", difference_to_layers());
    kw_claim_count(report, "gcn.cost.terms", through_terms(terms->S, zero, zero, y));
    kw_claim_count(report, "gcn.cost.vectors",
                   through_vectors(LARGE, zero, zero, zero, y));
    kw_gcn_free(terms);
    kw_graph_free(g);
    free(zero);
}

/* --- pictures --- */

static void write_waves(kw_out *f)
{
    double x[2 * POINTS] = {0};
    kw_graph *g;
    kw_gcn *l;

    scatter(712, 0, POINTS, x);
    g = kw_graph_new_nearest(POINTS, 2, x, NEAREST);
    l = kw_gcn_new_spectral(g, 1, 1);
    write_edges(f, "edges", g, x);
    write_nodes(f, "slow wave", POINTS, x, l->vector + POINTS);
    write_nodes(f, "wave", POINTS, x, l->vector + 4 * POINTS);
    write_nodes(f, "fast wave", POINTS, x, l->vector + (POINTS - 1) * POINTS);
    kw_gcn_free(l);
    kw_graph_free(g);
}

static void write_responses(kw_out *f)
{
    enum { STEPS = 200 };
    double c[K + 1];

    ideal_series(K, c);
    kw_out_section(f, "responses", "frequency ideal polynomial");
    for (int i = 0; i <= STEPS; i++) {
        double frequency = 2.0 * i / STEPS;

        kw_out_number(f, frequency);
        kw_out_number(f, ideal(frequency));
        kw_out_number(f, polynomial(K, c, frequency - 1));
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_spectral"), *report = kw_claim_new("ex_spectral");

    write_waves(f);
    write_responses(f);
    look_at_circle(f, report);
    report_polynomials(report);
    report_costs(report);
    return kw_out_close(f) | kw_out_close(report);
}
