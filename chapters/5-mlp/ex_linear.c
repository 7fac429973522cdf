/* Why activations bend -- without them all layers are one.

   What to see: one net with the same parameters and three activations. Without any it is a
   straight line, whatever its parameters; with tanh a smooth curve, with ReLU a polygon.

   Book: section 1.2, the text before Remark 9.
   Claims: mlp.linear.*
   Chosen here: the net that is drawn; for the claims random nets with integer parameters, so
   that nothing is rounded. */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* the nets */
#include "out.h"   /* columns for gnuplot */
#include "rng.h"   /* random nets */
#include <math.h>

enum {
    NETS = 200,
    POINTS = 20,
    DEEPEST = 4, /* layers behind the input, at most */
    WIDEST = 5,
    CURVE = 120 /* cells of the curves */
};

/* A random net with activation `kind` in its hidden layers; parameters in w. */
static kw_net *random_net(kw_rng *r, int L, kw_activation_kind kind, double *w)
{
    int width[DEEPEST + 1];
    kw_activation_kind sigma[DEEPEST];
    kw_net *n;

    for (int l = 0; l <= L; l++)
        width[l] = 1 + kw_rng_below(r, WIDEST);
    for (int l = 0; l < L; l++)
        sigma[l] = l + 1 < L ? kind : KW_IDENTITY;
    n = kw_mlp_new(L, width, sigma);
    for (int i = 0; i < n->parameters; i++)
        w[i] = kw_rng_below(r, 7) - 3;
    return n;
}

/* The largest difference between the net and the affine map A p + c that agrees with it at 0
   and at the unit vectors, over random points; *offset is the largest entry of c. */
static double from_affine(const kw_net *n, const double *w, kw_rng *r, double *offset)
{
    double A[WIDEST][WIDEST], c[WIDEST] = {0}, y[WIDEST] = {0}, most = 0;
    kw_net_work *work = kw_net_work_new(n, 1);

    for (int column = -1; column < n->in; column++) {
        double p[WIDEST] = {0};

        if (column >= 0)
            p[column] = 1;
        kw_net_forward(n, w, 1, p, work, column < 0 ? c : y);
        for (int i = 0; column >= 0 && i < n->out; i++)
            A[i][column] = y[i] - c[i];
    }
    *offset = 0;
    for (int i = 0; i < n->out; i++)
        *offset = fmax(*offset, fabs(c[i]));
    for (int point = 0; point < POINTS; point++) {
        double p[WIDEST];

        for (int j = 0; j < n->in; j++)
            p[j] = kw_rng_below(r, 21) - 10;
        kw_net_forward(n, w, 1, p, work, y);
        for (int i = 0; i < n->out; i++) {
            double sum = c[i];

            for (int j = 0; j < n->in; j++)
                sum += A[i][j] * p[j];
            most = fmax(most, fabs(y[i] - sum));
        }
    }
    kw_net_work_free(work);
    return most;
}

/* Random nets without activations, and the same with ReLU. */
static void report_affine(kw_out *report)
{
    enum { ROOM = DEEPEST * WIDEST * (WIDEST + 1) };
    double straight = 0;
    int shifted = 0, bent = 0;

    for (uint64_t i = 0; i < NETS; i++) {
        int L = 2 + (int)i % (DEEPEST - 1);
        kw_rng r = kw_rng_at(56, 0, i, 0), same = r;
        double w[ROOM], offset, ignored;
        kw_net *n = random_net(&r, L, KW_IDENTITY, w);
        kw_net *relu = random_net(&same, L, KW_RELU, w);

        straight = fmax(straight, from_affine(n, w, &r, &offset));
        shifted += offset > 0;
        bent += from_affine(relu, w, &same, &ignored) > 0;
        kw_net_free(n);
        kw_net_free(relu);
    }
    kw_claim_real(report, "mlp.linear.collapse", straight);
    kw_claim_count(report, "mlp.linear.offset", shifted);
    kw_claim_count(report, "mlp.linear.relu", bent);
}

/* One net, the same parameters, three activations. */
static void write_bends(kw_out *f)
{
    const int width[] = {1, 4, 4, 1};
    const kw_activation_kind kinds[] = {KW_IDENTITY, KW_TANH, KW_RELU};

    for (int k = 0; k < 3; k++) {
        const kw_activation_kind sigma[] = {kinds[k], kinds[k], KW_IDENTITY};
        kw_net *n = kw_mlp_new(3, width, sigma);
        kw_net_work *work = kw_net_work_new(n, 1);
        double w[33];
        kw_rng r = kw_rng_at(57, 0, 2, 0);

        for (int i = 0; i < n->parameters; i++)
            w[i] = 3 * kw_rng_uniform(&r) - 1.5;
        kw_out_section(f, kw_activation_name(kinds[k]), "p x");
        for (int i = 0; i <= CURVE; i++) {
            double p = 8.0 * i / CURVE - 4, x;

            kw_net_forward(n, w, 1, &p, work, &x);
            kw_out_number(f, p);
            kw_out_number(f, x);
            kw_out_row(f);
        }
        kw_net_work_free(work);
        kw_net_free(n);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_linear"), *report = kw_claim_new("ex_linear");

    report_affine(report);
    write_bends(f);
    return kw_out_close(f) | kw_out_close(report);
}
