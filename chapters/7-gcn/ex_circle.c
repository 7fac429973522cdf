/* Circle -- where graphs and grids meet: the convolution theorem.

   What to see: nothing to look at. On a circle of nodes the eigenvectors of the Laplacian
   are Fourier's, a filter of frequencies is a circular convolution, and a symmetric filter
   with K taps on either side is the Chebyshev layer of degree K, to the last bit. A filter
   that is not symmetric, as a step to the right, is out of reach.

   Book: section 1.2, the convolution theorem and the eigenvectors of the Laplacian.
   Claims: gcn.circle.*
   Chosen here: a circle of 32 nodes; random signals and filters of small integers. */

#include "chebyshev.h"  /* the value of a series */
#include "claim.h"      /* what we found, for the ledger */
#include "conv.h"       /* convolution on a circle, the usual way */
#include "elementary.h" /* the frequencies in closed form */
#include "gcn.h"        /* the layers */
#include "graphs.h"     /* the circle */
#include "out.h"        /* reports are files */
#include "rng.h"        /* random signals and filters */
#include <math.h>

enum { N = 32, K = 4, CASES = 100 };

static const double PI = 3.14159265358979323846;

/* The frequencies 1 - cos(2 pi k / N), all but the first and the last one twice. */
static double frequency_error(const kw_gcn *l)
{
    double most = 0;

    for (int k = 0; k < N; k++) {
        int waves = (k + 1) / 2; /* once around the circle */
        double want = 1 - kw_cos(2 * PI * waves / N);

        most = fmax(most, fabs(l->frequency[k] - want));
    }
    return most;
}

/* The filter 1 / (1 + frequency): how far its matrix is from commuting with a step along the
   circle, that is from rows that are all the same but for their place. */
static double circulant_error(const kw_gcn *l)
{
    double w[N + 1] = {0}, first[N] = {0}, most = 0;

    for (int k = 0; k < N; k++)
        w[k] = 1 / (1 + l->frequency[k]);
    for (int i = 0; i < N; i++) {
        double one[N] = {0}, row[N] = {0};

        one[i] = 1;
        kw_gcn_forward(l, w, 1, one, row);
        for (int j = 0; j < N; j++) {
            if (i == 0)
                first[j] = row[j];
            most = fmax(most, fabs(row[(i + j) % N] - first[j]));
        }
    }
    return most;
}

/* Random symmetric filters h_K .. h_0 .. h_K on random signals: the convolution against the
   two layers with the coefficients h_0 and 2 (-1)^q h_q of T_q; a step to the right and one
   to the left have the mean -S, and T_q(-S) = (-1)^q T_q(S). */
static void report_convolution(kw_out *report, const kw_gcn *vectors, const kw_gcn *terms)
{
    const kw_conv conv = kw_conv_layer((kw_conv){.in_channels = 1,
                                                 .rows = 1,
                                                 .columns = N,
                                                 .out_channels = 1,
                                                 .filter_rows = 1,
                                                 .filter_columns = 2 * K + 1,
                                                 .stride = 1,
                                                 .padding = KW_CONV_CIRCULAR});
    double by_terms = 0, by_vectors = 0;

    for (uint64_t sample = 0; sample < CASES; sample++) {
        kw_rng r = kw_rng_at(721, 0, sample, 0);
        double x[N], filter[2 * K + 1], c[K + 2] = {0}, w[N + 1] = {0};
        double want[N], y[N], z[N];

        for (int i = 0; i < N; i++)
            x[i] = kw_rng_below(&r, 19) - 9;
        for (int q = 0; q <= K; q++) {
            filter[K - q] = filter[K + q] = kw_rng_below(&r, 19) - 9;
            c[q] = (q == 0 ? 1 : 2) * (q % 2 ? -1 : 1) * filter[K + q];
        }
        for (int k = 0; k < N; k++)
            w[k] = polynomial(K, c, vectors->frequency[k] - 1);
        kw_conv_convolve(&conv, filter, x, want);
        kw_gcn_forward(terms, c, 1, x, y);
        kw_gcn_forward(vectors, w, 1, x, z);
        for (int i = 0; i < N; i++) {
            by_terms = fmax(by_terms, fabs(y[i] - want[i]));
            by_vectors = fmax(by_vectors, fabs(z[i] - want[i]));
        }
    }
    kw_claim_real(report, "gcn.circle.chebyshev", by_terms);
    kw_claim_real(report, "gcn.circle.theorem", by_vectors);
}

/* The distance of a step to the right, y_i = x_{i-1}, from all matrices U diag(w) U^T, as a
   part of its norm. These matrices have the orthonormal basis u_k u_k^T, so what the step
   has in common with them are the numbers u_k^T P u_k. */
static double distance_of_step(const kw_gcn *l)
{
    double common = 0;

    for (int k = 0; k < N; k++) {
        const double *u = l->vector + (size_t)k * N;
        double sum = 0;

        for (int i = 0; i < N; i++)
            sum += u[i] * u[(i + N - 1) % N];
        common += sum * sum;
    }
    return sqrt((N - common) / N);
}

/* A layer with free coefficients, another one for each eigenvector: the norm of the difference
   of `step, then layer' and `layer, then step'. In the plane of two eigenvectors a step is a
   rotation by its angle t, and with the coefficients a and b the difference is |a - b| sin(t)
   times as long as the signal there, whatever basis the eigenvectors are. */
static double free_coefficients(const kw_gcn *l)
{
    kw_rng r = kw_rng_at(722, 0, 0, 0);
    double w[N + 1] = {0}, x[N], moved[N], y[N], y_moved[N], sum = 0;

    for (int k = 0; k < N; k++)
        w[k] = kw_rng_uniform(&r);
    for (int i = 0; i < N; i++)
        x[i] = kw_rng_uniform(&r);
    for (int i = 0; i < N; i++)
        moved[(i + 1) % N] = x[i];
    kw_gcn_forward(l, w, 1, x, y);
    kw_gcn_forward(l, w, 1, moved, y_moved);
    for (int i = 0; i < N; i++)
        sum += (y_moved[(i + 1) % N] - y[i]) * (y_moved[(i + 1) % N] - y[i]);
    return sqrt(sum);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_circle");
    kw_graph *g = new_cycle(N);
    kw_gcn *vectors = kw_gcn_new_spectral(g, 1, 1);
    kw_gcn *terms = kw_gcn_new_chebyshev(g, 1, 1, K);

    kw_claim_count(report, "gcn.circle.sweeps", count_sweeps(g));
    kw_claim_real(report, "gcn.circle.frequencies", frequency_error(vectors));
    kw_claim_real(report, "gcn.circle.circulant", circulant_error(vectors));
    report_convolution(report, vectors, terms);
    kw_claim_real(report, "gcn.circle.step", distance_of_step(vectors));
    kw_claim_real(report, "gcn.circle.free", free_coefficients(vectors));

    kw_gcn_free(vectors);
    kw_gcn_free(terms);
    kw_graph_free(g);
    return kw_out_close(report);
}
