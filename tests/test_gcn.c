/* Graph convolutions against dense matrices and double loops, and their derivatives.

   A layer is linear in x, and in w: differences with step 1 are derivatives without any
   error of their own. On graphs where all degrees are equal and fit (2 for the mean and the
   Chebyshev layer, 3 for the first-order layer, whose root is that of 4 by 4) all entries
   of S are powers of two, and with integers everything is exact. Elsewhere, and in the
   spectral layer, roundings are counted (roundings, below). */
#include "gcn.h"
#include "graphs.h"
#include "test.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum {
    CHANNELS = 3,
    DEGREE = 4,
    SIGNAL = MOST * CHANNELS,
    WEIGHTS = MOST * CHANNELS * CHANNELS + CHANNELS, /* of the spectral layer, the most */
    SAMPLES = 200
};

typedef enum kind { SPATIAL, SPECTRAL, CHEBYSHEV, FIRST_ORDER, KINDS } kind;

static const double U = DBL_EPSILON / 2;

static kw_gcn *new_layer(kind which, const kw_graph *g, int in, int out, int degree)
{
    switch (which) {
    case SPATIAL:
        return kw_gcn_new_spatial(g, in, out);
    case SPECTRAL:
        return kw_gcn_new_spectral(g, in, out);
    case CHEBYSHEV:
        return kw_gcn_new_chebyshev(g, in, out, degree);
    default:
        return kw_gcn_new_first_order(g, in, out);
    }
}

static void integers(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = kw_rng_below(r, 9) - 4;
}

/* --- the long way --- */

/* S by its formula, from the dense adjacency matrix A; every entry with at most four
   roundings. */
static void matrix_of(kind which, int n, const double *A, double *S)
{
    double degree[MOST] = {0};

    for (int i = 0; i < n; i++) {
        degree[i] = which == FIRST_ORDER;
        for (int j = 0; j < n; j++)
            degree[i] += A[i * n + j];
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double a = A[i * n + j] + (which == FIRST_ORDER && i == j);

            S[i * n + j] = which == SPATIAL ? a / degree[i]
                                            : a / (sqrt(degree[i]) * sqrt(degree[j]));
            if (which == CHEBYSHEV)
                S[i * n + j] = -S[i * n + j];
        }
}

/* t = T_k(S), all n x n of it; with `size` the sum of the absolute values of its terms. */
static void chebyshev(int n, const double *S, int k, int size, double *t)
{
    double before[MOST * MOST] = {0}, next[MOST * MOST] = {0};

    for (int i = 0; i < n * n; i++) {
        before[i] = i / n == i % n;
        t[i] = k == 0 ? before[i] : size ? fabs(S[i]) : S[i];
    }
    for (int step = 2; step <= k; step++) {
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                double sum = 0;

                for (int q = 0; q < n; q++) {
                    double s = S[i * n + q];

                    sum += (size ? fabs(s) : s) * t[q * n + j];
                }
                next[i * n + j] = 2 * sum + (size ? 1 : -1) * before[i * n + j];
            }
        for (int i = 0; i < n * n; i++) {
            before[i] = t[i];
            t[i] = next[i];
        }
    }
}

/* The n x n matrix of W_k: T_k(S), or u u' of eigenvector k. */
static void operator_of(const kw_gcn *l, const double *S, int k, int size, double *t)
{
    if (!l->vector) {
        chebyshev(l->n, S, k, size, t);
        return;
    }
    for (int i = 0; i < l->n * l->n; i++) {
        double a = l->vector[k * l->n + i / l->n] * l->vector[k * l->n + i % l->n];

        t[i] = size ? fabs(a) : a;
    }
}

/* The layer on one sample; with `size` the sum of the absolute values of all terms. */
static void long_way(const kw_gcn *l, const double *S, int size, const double *w,
                     const double *x, double *y)
{
    int n = l->n, in = l->in_channels, out = l->out_channels;
    const double *bias = w + (l->last - l->first + 1) * in * out;

    for (int i = 0; i < n * out; i++)
        y[i] = size ? fabs(bias[i % out]) : bias[i % out];
    for (int k = l->first; k <= l->last; k++, w += in * out) {
        double t[MOST * MOST] = {0};

        operator_of(l, S, k, size, t);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                for (int c = 0; c < in; c++)
                    for (int f = 0; f < out; f++) {
                        double a = t[i * n + j] * x[j * in + c] * w[c * out + f];

                        y[i * out + f] += size ? fabs(a) : a;
                    }
    }
}

/* Of a term, in either way: four for an entry of S, a product, n sums and a difference a step
   of the recursion, or a product and n sums with an eigenvector, twice; products with x and w,
   sums over all nodes, channels and matrices, and the bias. */
static int roundings(const kw_gcn *l)
{
    int steps = l->vector ? 2 : l->last;

    return steps * (l->n + 6) + l->n * l->in_channels * (l->last + 1) + 3;
}

/* A random graph, a layer on it, parameters, a batch, and what the long way needs. */
typedef struct scene {
    kw_gcn *l;
    int count;
    double S[MOST * MOST], w[WEIGHTS], x[3 * SIGNAL], dy[3 * SIGNAL];
} scene;

static scene random_scene(kw_rng *r, kind which)
{
    scene s = {.count = 1 + kw_rng_below(r, 3)};
    double A[MOST * MOST];
    kw_graph *g = graphs_random(r, which == FIRST_ORDER, A);
    int in = 1 + kw_rng_below(r, CHANNELS), out = 1 + kw_rng_below(r, CHANNELS);

    s.l = new_layer(which, g, in, out, kw_rng_below(r, DEGREE + 1));
    matrix_of(which, g->n, A, s.S);
    integers(r, s.l->parameters, s.w);
    integers(r, s.count * s.l->in, s.x);
    integers(r, s.count * s.l->out, s.dy);
    kw_graph_free(g);
    return s;
}

static void shapes(void)
{
    kw_graph *g = graphs_cycle(5);
    static const int matrices[KINDS] = {2, 5, DEGREE + 1, 1};

    for (int which = 0; which < KINDS; which++) {
        kw_gcn *l = new_layer((kind)which, g, 2, 3, DEGREE);

        CHECK(l->in == 10 && l->out == 15, "%d, %d", l->in, l->out);
        CHECK(l->parameters == matrices[which] * 6 + 3, "kind %d: %d", which,
              l->parameters);
        kw_gcn_free(l);
    }
    kw_graph_free(g);
}

static void forward_is_the_long_way(void)
{
    for (int which = 0; which < KINDS; which++)
        for (uint64_t sample = 0; sample < SAMPLES; sample++) {
            kw_rng r = kw_rng_at(441, (uint64_t)which, sample, 0);
            scene s = random_scene(&r, (kind)which);
            double y[3 * SIGNAL + 1], want[SIGNAL] = {0}, size[SIGNAL] = {0};

            test_poison(y, 3 * SIGNAL + 1);
            kw_gcn_forward(s.l, s.w, s.count, s.x, y);
            CHECK(isnan(y[s.count * s.l->out]), "written behind the batch");
            for (int b = 0; b < s.count; b++) {
                long_way(s.l, s.S, 0, s.w, s.x + (size_t)(b * s.l->in), want);
                long_way(s.l, s.S, 1, s.w, s.x + (size_t)(b * s.l->in), size);
                for (int i = 0; i < s.l->out; i++) {
                    double got = y[b * s.l->out + i];

                    CHECK(fabs(got - want[i]) <= 2 * roundings(s.l) * U * size[i],
                          "kind %d: %.17g, not %.17g", which, got, want[i]);
                }
            }
            kw_gcn_free(s.l);
        }
}

/* A batch is its samples one by one, bit by bit. */
static void a_batch_is_its_samples(void)
{
    for (int which = 0; which < KINDS; which++) {
        kw_rng r = kw_rng_at(442, (uint64_t)which, 0, 0);
        double A[MOST * MOST], w[WEIGHTS], x[3 * SIGNAL], y[3 * SIGNAL], one[SIGNAL];
        double dx[3 * SIGNAL], dx_one[SIGNAL], dw[WEIGHTS] = {0}, dw_one[WEIGHTS] = {0};
        double dw_alone[WEIGHTS] = {0};
        kw_graph *g = graphs_random(&r, 0, A);
        kw_gcn *l = new_layer((kind)which, g, 2, 3, DEGREE);

        for (int i = 0; i < l->parameters; i++)
            w[i] = test_random_in(&r, -1, 1);
        for (int i = 0; i < 3 * SIGNAL; i++)
            x[i] = test_random_in(&r, -1, 1);
        kw_gcn_forward(l, w, 3, x, y);
        kw_gcn_backward(l, w, 3, x, y, y, dx, dw);
        kw_gcn_backward(l, w, 3, x, y, y, NULL, dw_alone);
        for (int b = 0; b < 3; b++) {
            const double *xb = x + (size_t)(b * l->in), *yb = y + (size_t)(b * l->out);

            kw_gcn_forward(l, w, 1, xb, one);
            kw_gcn_backward(l, w, 1, xb, yb, yb, dx_one, dw_one);
            for (int i = 0; i < l->out; i++)
                CHECK(one[i] == yb[i], "kind %d, sample %d", which, b);
            for (int i = 0; i < l->in; i++)
                CHECK(dx_one[i] == dx[b * l->in + i], "kind %d, sample %d", which, b);
        }
        for (int i = 0; i < l->parameters; i++)
            CHECK(dw_one[i] == dw[i] && dw_alone[i] == dw[i], "kind %d, parameter %d",
                  which, i);
        kw_gcn_free(l);
        kw_graph_free(g);
    }
}

/* --- derivatives --- */

/* The number whose derivative with respect to y is dy; size: see long_way. */
static double number_of(const scene *s, double *size)
{
    double y[3 * SIGNAL], sizes[SIGNAL] = {0}, sum = 0;

    *size = 0;
    kw_gcn_forward(s->l, s->w, s->count, s->x, y);
    for (int b = 0; b < s->count; b++) {
        long_way(s->l, s->S, 1, s->w, s->x + (size_t)(b * s->l->in), sizes);
        for (int i = 0; i < s->l->out; i++) {
            sum += s->dy[b * s->l->out + i] * y[b * s->l->out + i];
            *size += fabs(s->dy[b * s->l->out + i]) * sizes[i];
        }
    }
    return sum;
}

/* The derivative `got` with respect to *at, against the difference with step 1: three numbers
   with their roundings, and those of the sum of number_of. */
static void check_derivative(const scene *s, double *at, double got, int exact)
{
    double size_before, size_behind, before = number_of(s, &size_before), behind, bound;

    *at += 1;
    behind = number_of(s, &size_behind);
    *at -= 1;
    bound = exact ? 0
                  : (2 * roundings(s->l) + s->count * s->l->out + 1) * U *
                        (2 * size_before + size_behind);
    CHECK(fabs(got - (behind - before)) <= bound, "%.17g, not %.17g", got,
          behind - before);
}

static void check_derivatives(kw_rng *r, scene *s, int exact)
{
    double y[3 * SIGNAL], dx[3 * SIGNAL + 1], dw[WEIGHTS], kept[WEIGHTS] = {0};

    integers(r, s->l->parameters, kept);
    for (int i = 0; i < s->l->parameters; i++)
        dw[i] = kept[i];
    test_poison(dx, 3 * SIGNAL + 1);
    test_poison(y, 3 * SIGNAL);
    kw_gcn_backward(s->l, s->w, s->count, s->x, y, s->dy, dx, dw);
    for (int i = 0; i < s->count * s->l->in; i++)
        check_derivative(s, &s->x[i], dx[i], exact);
    CHECK(isnan(dx[s->count * s->l->in]), "written behind the batch");
    for (int i = 0; i < s->l->parameters; i++)
        check_derivative(s, &s->w[i], dw[i] - kept[i], exact);
}

static void backward_is_the_derivative(void)
{
    for (int which = 0; which < KINDS; which++)
        for (uint64_t sample = 0; sample < SAMPLES / 10; sample++) {
            kw_rng r = kw_rng_at(443, (uint64_t)which, sample, 0);
            scene s = random_scene(&r, (kind)which);

            check_derivatives(&r, &s, 0);
            kw_gcn_free(s.l);
        }
}

/* Circles of 3 .. MOST nodes; for the first-order layer the complete graph of four. */
static void derivatives_on_integers_are_exact(void)
{
    static const kind exact[] = {SPATIAL, CHEBYSHEV, FIRST_ORDER};

    for (int which = 0; which < 3; which++)
        for (uint64_t sample = 0; sample < SAMPLES / 10; sample++) {
            kw_rng r = kw_rng_at(444, (uint64_t)which, sample, 0);
            kw_graph *g = exact[which] == FIRST_ORDER
                              ? graphs_complete(4)
                              : graphs_cycle(3 + kw_rng_below(&r, MOST - 2));
            scene s = {.count = 2,
                       .l = new_layer(exact[which], g, 2, 3, kw_rng_below(&r, 5))};

            integers(&r, s.l->parameters, s.w);
            integers(&r, s.count * s.l->in, s.x);
            integers(&r, s.count * s.l->out, s.dy);
            check_derivatives(&r, &s, 1);
            kw_gcn_free(s.l);
            kw_graph_free(g);
        }
}

/* --- what the layers are for --- */

/* W_k = w_k for the Chebyshev layer, and the value of that polynomial at each frequency for
   the spectral one. U p(frequency - 1) U' is p of a matrix that differs from S by 140 n u
   |L| (test_eigen.c; |L| < 2 n), and T_k' is at most k^2 on [-1,1]; then the roundings of
   both. */
static void chebyshev_is_spectral(void)
{
    for (uint64_t sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = kw_rng_at(445, 0, sample, 0);
        double A[MOST * MOST], S[MOST * MOST] = {0}, x[MOST], y[MOST], z[MOST];
        double w[DEGREE + 2], theta[MOST + 1], size[MOST], slope = 0, norm = 0;
        kw_graph *g = graphs_random(&r, 0, A);
        kw_gcn *c = kw_gcn_new_chebyshev(g, 1, 1, DEGREE);
        kw_gcn *s = kw_gcn_new_spectral(g, 1, 1);

        integers(&r, DEGREE + 2, w);
        integers(&r, g->n, x);
        for (int i = 0; i < g->n; i++) {
            double at = s->frequency[i] - 1, t[DEGREE + 1] = {1, at};

            theta[i] = w[0] + w[1] * at;
            for (int k = 2; k <= DEGREE; k++) {
                t[k] = 2 * at * t[k - 1] - t[k - 2];
                theta[i] += w[k] * t[k];
            }
            norm += x[i] * x[i];
        }
        for (int k = 1; k <= DEGREE; k++)
            slope += fabs(w[k]) * k * k;
        theta[g->n] = w[DEGREE + 1];
        matrix_of(CHEBYSHEV, g->n, A, S);
        kw_gcn_forward(c, w, 1, x, y);
        kw_gcn_forward(s, theta, 1, x, z);
        long_way(c, S, 1, w, x, size);
        for (int i = 0; i < g->n; i++)
            CHECK(fabs(y[i] - z[i]) <= 280.0 * g->n * g->n * U * slope * sqrt(norm) +
                                           2 * roundings(s) * U * size[i] * g->n,
                  "%.17g, %.17g", y[i], z[i]);
        kw_gcn_free(c);
        kw_gcn_free(s);
        kw_graph_free(g);
    }
}

/* A one at a node is seen exactly within `degree` hops, and so is a NaN; zero elsewhere,
   exactly. Random weights, so that nothing cancels. */
static void chebyshev_stays_within_its_hops(void)
{
    for (uint64_t sample = 0; sample < SAMPLES; sample++) {
        kw_rng r = kw_rng_at(446, 0, sample, 0);
        double A[MOST * MOST], x[MOST] = {0}, y[MOST], w[DEGREE + 2] = {0};
        kw_graph *g = graphs_random(&r, 0, A);
        int degree = kw_rng_below(&r, DEGREE + 1), from = kw_rng_below(&r, g->n);
        int work[MOST], hops[MOST];
        kw_gcn *l = kw_gcn_new_chebyshev(g, 1, 1, degree);

        for (int k = 0; k <= degree; k++)
            w[k] = test_random_in(&r, 0.1, 1);
        kw_graph_hops(g, from, work, hops);
        for (int round = 0; round < 2; round++) {
            x[from] = round == 0 ? 1 : NAN;
            kw_gcn_forward(l, w, 1, x, y);
            for (int i = 0; i < g->n; i++)
                CHECK((y[i] == 0) == (hops[i] > degree),
                      "degree %d: %g at %d hops from %g", degree, y[i], hops[i], x[from]);
        }
        kw_gcn_free(l);
        kw_graph_free(g);
    }
}

/* --- misuse --- */

static kw_graph *with_an_isolated_node(void)
{
    const int end[] = {0, 1};

    return kw_graph_new(3, 1, end, NULL);
}

/* The first-order layer gives an isolated node its own value. */
static void an_isolated_node_keeps_its_value(void)
{
    kw_graph *g = with_an_isolated_node();
    kw_gcn *l = kw_gcn_new_first_order(g, 1, 1);
    const double w[] = {3, 0.5}, x[] = {1, 2, 4};
    double y[3];

    kw_gcn_forward(l, w, 1, x, y);
    CHECK(y[0] == 5 && y[1] == 5 && y[2] == 12.5, "%g, %g, %g", y[0], y[1], y[2]);
    kw_gcn_free(l);
    kw_graph_free(g);
}

static void isolated_spatial(void)
{
    kw_gcn_new_spatial(with_an_isolated_node(), 1, 1);
}

static void isolated_spectral(void)
{
    kw_gcn_new_spectral(with_an_isolated_node(), 1, 1);
}

static void isolated_chebyshev(void)
{
    kw_gcn_new_chebyshev(with_an_isolated_node(), 1, 1, 2);
}

static void no_channels_in(void)
{
    kw_gcn_new_spatial(graphs_cycle(3), 0, 2);
}

static void no_channels_out(void)
{
    kw_gcn_new_first_order(graphs_cycle(3), 2, -1);
}

static void too_many_channels(void)
{
    kw_gcn_new_first_order(graphs_cycle(3), 1 << 20, 1 << 20);
}

static void negative_degree(void)
{
    kw_gcn_new_chebyshev(graphs_cycle(3), 1, 1, -1);
}

static void empty_batch(void)
{
    kw_gcn_forward(kw_gcn_new_first_order(graphs_cycle(3), 1, 1), NULL, 0, NULL, NULL);
}

static void empty_batch_backward(void)
{
    kw_gcn_backward(kw_gcn_new_first_order(graphs_cycle(3), 1, 1), NULL, -1, NULL, NULL,
                    NULL, NULL, NULL);
}

static void mistakes_are_named(void)
{
    test_aborts("node 2 has no neighbour", isolated_spatial);
    test_aborts("node 2 has no neighbour", isolated_spectral);
    test_aborts("node 2 has no neighbour", isolated_chebyshev);
    test_aborts("0 channels in, 2 channels out", no_channels_in);
    test_aborts("2 channels in, -1 channels out", no_channels_out);
    test_aborts("1 matrices of 1048576 x 1048576 weights", too_many_channels);
    test_aborts("degree -1", negative_degree);
    test_aborts("0 samples", empty_batch);
    test_aborts("-1 samples", empty_batch_backward);
    kw_gcn_free(NULL);
}

int main(void)
{
    test_run("gcn: shapes and parameters", shapes);
    test_run("gcn: forward is the sum over all nodes, channels and matrices",
             forward_is_the_long_way);
    test_run("gcn: a batch is its samples, bit by bit", a_batch_is_its_samples);
    test_run("gcn: backward is the derivative", backward_is_the_derivative);
    test_run("gcn: derivatives on integers are exact", derivatives_on_integers_are_exact);
    test_run("gcn: a polynomial of the frequency is a Chebyshev layer",
             chebyshev_is_spectral);
    test_run("gcn: a Chebyshev layer stays within its hops",
             chebyshev_stays_within_its_hops);
    test_run("gcn: an isolated node keeps its value in a first-order layer",
             an_isolated_node_keeps_its_value);
    test_run("gcn: mistakes abort and are named", mistakes_are_named);
    return test_end();
}
