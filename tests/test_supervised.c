#include "supervised.h"
#include "mlp.h"
#include "test.h"
#include "train.h"
#include <math.h>
#include <stddef.h>

enum { IN = 2, OUT = 3, COUNT = 9, BATCH = 4, MOST = 64 };

static double x[COUNT * IN], target[COUNT * OUT], w[MOST];

/* A small net with random parameters, and random samples with numbers for targets. */
static kw_net *new_net(uint64_t seed)
{
    static const int width[] = {IN, 4, OUT};
    static const kw_activation_kind sigma[] = {KW_TANH, KW_IDENTITY};
    kw_net *n = kw_mlp_new(2, width, sigma);
    kw_rng r = kw_rng_at(81, 0, seed, 0);

    for (int i = 0; i < n->parameters; i++)
        w[i] = test_random_in(&r, -1, 1);
    for (int i = 0; i < COUNT * IN; i++)
        x[i] = test_random_in(&r, -2, 2);
    for (int i = 0; i < COUNT * OUT; i++)
        target[i] = test_random_in(&r, -1, 1);
    return n;
}

/* The mean over chosen samples is that over their rows, one by one: the same products in the
   same order, and a division by 4. */
static void it_takes_the_samples_that_it_is_told(void)
{
    static const int sample[BATCH] = {7, 0, 7, 3};
    kw_net *n = new_net(0);
    kw_supervised *s = kw_supervised_new(n, kw_loss_squared, COUNT, x, target, BATCH);
    double value = kw_supervised_mean(s, BATCH, sample, w, NULL), sum = 0;

    for (int i = 0; i < BATCH; i++)
        sum += kw_supervised_mean(s, 1, &sample[i], w, NULL);
    CHECK(fabs(value - sum / BATCH) <= 16 * 0x1p-53 * value, "%.17g, not %.17g", value,
          sum / BATCH);
    kw_supervised_free(s);
    kw_supervised_free(NULL);
    kw_net_free(n);
}

/* Central differences: 4 points at a distance of 1e-3 have an error below 1e-11 here, and the
   rounding of some 200 operations on numbers of order one, 3e-14, is multiplied by 1500. */
static void the_gradient_is_that_of_the_mean(void)
{
    static const int sample[] = {1, 8, 4};
    const double h = 1e-3;

    for (uint64_t seed = 0; seed < 20; seed++) {
        kw_net *n = new_net(seed);
        kw_supervised *s = kw_supervised_new(n, kw_loss_squared, COUNT, x, target, BATCH);
        double dw[MOST], value[5];

        test_poison(dw, MOST);
        kw_supervised_mean(s, 3, sample, w, dw);
        for (int i = 0; i < n->parameters; i++) {
            double at = w[i], slope;

            for (int k = -2; k <= 2; k++) {
                w[i] = at + k * h;
                value[k + 2] = kw_supervised_mean(s, 3, sample, w, NULL);
            }
            w[i] = at;
            slope = (8 * (value[3] - value[1]) - (value[4] - value[0])) / (12 * h);
            CHECK(fabs(dw[i] - slope) <= 1e-10, "%.12g, not %.12g", dw[i], slope);
        }
        CHECK(isnan(dw[n->parameters]), "wrote too far");
        kw_supervised_free(s);
        kw_net_free(n);
    }
}

/* `Exactly one of the two', by each of the losses for two classes. */
static void a_net_learns_exclusive_or(void)
{
    static const double P[] = {0, 0, 0, 1, 1, 0, 1, 1}, label[] = {-1, 1, 1, -1};
    static const int width[] = {2, 8, 1}, all[] = {0, 1, 2, 3};
    static const kw_activation_kind sigma[] = {KW_TANH, KW_IDENTITY};
    kw_loss *const loss[] = {kw_loss_logistic, kw_loss_hinge, kw_loss_squared};

    for (int i = 0; i < 3; i++) {
        kw_net *n = kw_mlp_new(2, width, sigma);
        kw_supervised *s = kw_supervised_new(n, loss[i], 4, P, label, 4);
        kw_train_plan plan = {.objective = kw_supervised_mean,
                              .problem = s,
                              .parameters = n->parameters,
                              .training = 4,
                              .training_sample = all,
                              .epochs = 300,
                              .batch = 2};
        kw_train *t = kw_train_new(&plan);
        kw_optimizer *o = kw_optimizer_new(KW_ADAM, n->parameters, 0.05);
        double v[MOST];

        kw_net_init(n, 1, v);
        CHECK(kw_train_run(t, o, v) == 0, "loss %d: lost", i);
        kw_net_forward(n, v, 4, P, s->work, s->y);
        for (int k = 0; k < 4; k++)
            CHECK(s->y[k] * label[k] > 0, "loss %d, sample %d: %g", i, k, s->y[k]);
        kw_optimizer_free(o);
        kw_train_free(t);
        kw_supervised_free(s);
        kw_net_free(n);
    }
}

/* --- misuse --- */

static kw_supervised *small;

static void no_samples(void)
{
    kw_supervised_new(small->net, small->loss, 0, x, target, 1);
}

static void no_batch(void)
{
    kw_supervised_new(small->net, small->loss, 1, x, target, 0);
}

static void call(int count, int first)
{
    const int sample[] = {first, 0, 0, 0, 0};

    kw_supervised_mean(small, count, sample, w, NULL);
}

static void empty_batch(void)
{
    call(0, 0);
}

static void large_batch(void)
{
    call(BATCH + 1, 0);
}

static void unknown_sample(void)
{
    call(1, COUNT);
}

static void negative_sample(void)
{
    call(1, -1);
}

static void misuse_aborts(void)
{
    kw_net *n = new_net(0);

    small = kw_supervised_new(n, kw_loss_squared, COUNT, x, target, BATCH);
    test_aborts("0 samples", no_samples);
    test_aborts("batches of 0", no_batch);
    test_aborts("0 samples, not 1 .. 4", empty_batch);
    test_aborts("5 samples, not 1 .. 4", large_batch);
    test_aborts("sample 9, not 0 .. 8", unknown_sample);
    test_aborts("sample -1, not 0 .. 8", negative_sample);
    kw_supervised_free(small);
    kw_net_free(n);
}

int main(void)
{
    test_run("supervised: it takes the samples that it is told",
             it_takes_the_samples_that_it_is_told);
    test_run("supervised: the gradient is that of the mean",
             the_gradient_is_that_of_the_mean);
    test_run("supervised: a net learns the exclusive or", a_net_learns_exclusive_or);
    test_run("supervised: misuse aborts and names the value", misuse_aborts);
    return test_end();
}
