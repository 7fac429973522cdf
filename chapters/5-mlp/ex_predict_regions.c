/* Exercise 5 -- into how many regions three ReLU units cut the plane.

   What to see: nothing to look at. Where a net is affine its gradient stays the same, so the
   gradients at the points of a grid are counted, each once. No net has more of them than the
   plane has regions; the most over many nets is what they can do.

   Book: section 1.2, Remarks 9 and 10.
   Claims: mlp.predict.*
   Chosen here: 200 random nets of small integers, a grid of 41 x 41 points. Biases are halves
   of odd numbers, so that no point lies on a line where the net bends. */

#include "claim.h" /* what we found, for the ledger */
#include "mlp.h"   /* the nets */
#include "out.h"   /* reports are files */
#include "rng.h"   /* weights and biases */

enum { NETS = 200, IN = 2, HIDDEN = 3, FAR = 20 };
enum { PARAMETERS = HIDDEN * (IN + 2) + 1, PATTERNS = 1 << HIDDEN };

static kw_net *new_net(int L, const int *width)
{
    static const kw_activation_kind sigma[] = {KW_RELU, KW_RELU, KW_IDENTITY};

    return kw_mlp_new(L, width, sigma + 3 - L);
}

/* Small integers, and a half more in the biases of the hidden units. */
static void draw(const kw_net *n, uint64_t sample, double *w)
{
    kw_rng r = kw_rng_at(59, 0, sample, 0);

    for (int i = 0; i < n->parameters; i++) {
        int is_bias = HIDDEN * IN <= i && i < HIDDEN * (IN + 1);

        w[i] = kw_rng_below(&r, 19) - 9 + (is_bias ? 0.5 : 0);
    }
}

/* The different gradients that the output of n has on the grid; all of them are integers. */
static int count_gradients(const kw_net *n, const double *w)
{
    kw_net_work *work = kw_net_work_new(n, 1);
    double found[PATTERNS + 1][IN], dw[PARAMETERS] = {0}, y;
    const double one = 1;
    int count = 0;

    for (int i = -FAR; i <= FAR; i++)
        for (int j = -FAR; j <= FAR; j++) {
            const double p[IN] = {i, j};
            int k = 0;

            kw_net_forward(n, w, 1, p, work, &y);
            kw_net_backward(n, w, 1, p, &y, &one, work, found[count], dw);
            while (found[k][0] != found[count][0] || found[k][1] != found[count][1])
                k++;
            count += k == count;
        }
    kw_net_work_free(work);
    return count;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_predict_regions");
    kw_net *n = new_net(2, (const int[]){IN, HIDDEN, 1});
    kw_net *deeper = new_net(3, (const int[]){IN, HIDDEN, HIDDEN, 1});
    double w[PARAMETERS] = {0};
    int most = 0;

    for (uint64_t sample = 0; sample < NETS; sample++) {
        int count;

        draw(n, sample, w);
        count = count_gradients(n, w);
        most = count > most ? count : most;
    }

    kw_claim_count(report, "mlp.predict.regions", most);
    kw_claim_count(report, "mlp.predict.deeper", kw_mlp_count(deeper));
    kw_net_free(n);
    kw_net_free(deeper);
    return kw_out_close(report);
}
