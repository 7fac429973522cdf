/* Learning -- a performance that improves with experience.

   What to see: four programs on two tasks. Experience is a number of inputs with their labels;
   performance is the share of wrong answers, over all inputs that there are. One program does
   not learn. One remembers. The Perceptron and a network generalize, but the Perceptron only
   on the one task: what learns, learns with respect to a class of tasks.

   Book: section 1.2, Definition 6.
   Claims: learn.vote.*, learn.product.*
   Chosen here: tasks, programs and all their numbers; the book has none. Inputs are nine signs,
   so there are 512; the label is what most of the signs are, or the product of the first
   two. */

#include "bits.h"       /* the inputs */
#include "claim.h"      /* what we found, for the ledger */
#include "mlp.h"        /* a network */
#include "need.h"       /* memory; a training that works */
#include "out.h"        /* columns for gnuplot */
#include "perceptron.h" /* the Perceptron */
#include "power.h"      /* what a table forgets */
#include "rng.h"        /* random samples */
#include "supervised.h" /* the network's loss */
#include "train.h"      /* its training */
#include <math.h>
#include <stdlib.h>

enum {
    BITS = 9,
    INPUTS = 1 << BITS,
    SIZES = 7, /* 4, 8, .., 256 samples */
    LEAST = 4,
    MOST = LEAST << (SIZES - 1),
    REPEATS = 20,
    PASSES = 100,       /* of the Perceptron's rule over the samples, at most */
    HIDDEN = 8,         /* units of the network */
    BATCH = 8,          /* samples a step */
    SAMPLE_STEPS = 4096 /* of the network's training, all epochs together */
};

enum { TASKS = 2, PROGRAMS = 4, CONSTANT = 0, TABLE, PERCEPTRON, NETWORK };

static const double RATE = 0.02;
static const uint64_t SEED = 401;

/* --- tasks: the label of an input --- */

typedef double task(const double *signs);

static double vote(const double *signs)
{
    return majority(BITS, signs);
}

static double product(const double *signs)
{
    return signs[0] * signs[1];
}

/* --- programs: from experience to an answer for each of all inputs --- */

typedef struct experience {
    uint64_t seed;                 /* for programs that use chance */
    int m;                         /* samples */
    int number[MOST], input[MOST]; /* 0 .. m-1; which inputs */
    double signs[MOST * BITS], label[MOST];
} experience;

typedef void program(const experience *e, const double *all, double *answer);

static void constant(const experience *e, const double *all, double *answer)
{
    (void)e;
    (void)all;
    for (int i = 0; i < INPUTS; i++)
        answer[i] = 1;
}

/* Remembers what it has seen. */
static void table(const experience *e, const double *all, double *answer)
{
    constant(e, all, answer);
    for (int i = 0; i < e->m; i++)
        answer[e->input[i]] = e->label[i];
}

static void perceptron(const experience *e, const double *all, double *answer)
{
    double w[BITS + 1] = {0};
    int clean;

    kw_perceptron_train(BITS, e->m, e->signs, e->label, 1, PASSES, w, &clean);
    for (int i = 0; i < INPUTS; i++)
        answer[i] = kw_perceptron_decide(BITS, w, all + i * BITS);
}

/* One hidden layer, trained on the logistic loss by Adam. */
static void network(const experience *e, const double *all, double *answer)
{
    const int width[] = {BITS, HIDDEN, 1};
    const kw_activation_kind sigma[] = {KW_TANH, KW_IDENTITY};
    kw_net *n = kw_mlp_new(2, width, sigma);
    kw_supervised *mean =
        kw_supervised_new(n, kw_loss_logistic, e->m, e->signs, e->label, BATCH);
    kw_net_work *work = kw_net_work_new(n, INPUTS);
    kw_optimizer *adam = kw_optimizer_new(KW_ADAM, n->parameters, RATE);
    double *w = kw_need_memory((size_t)n->parameters, sizeof *w);
    const kw_train_plan plan = {.objective = kw_supervised_mean,
                                .problem = mean,
                                .parameters = n->parameters,
                                .training = e->m,
                                .training_sample = e->number,
                                .epochs = SAMPLE_STEPS / e->m,
                                .batch = BATCH,
                                .seed = e->seed};
    kw_train *training = kw_train_new(&plan);
    int failed;

    kw_net_init(n, e->seed + 1000, w);
    failed = kw_train_run(training, adam, w);
    KW_NEED(!failed, "the network after %d samples", e->m);
    kw_net_forward(n, w, INPUTS, all, work, answer);
    for (int i = 0; i < INPUTS; i++)
        answer[i] = answer[i] >= 0 ? 1 : -1;
    kw_train_free(training);
    kw_optimizer_free(adam);
    kw_net_work_free(work);
    kw_supervised_free(mean);
    kw_net_free(n);
    free(w);
}

/* --- performance after experience --- */

/* The first m random samples of a repeat. */
static void gather(task *label, const double *all, uint64_t repeat, int m, experience *e)
{
    kw_rng r = kw_rng_at(SEED, 1, repeat, 0);

    e->seed = SEED + 1 + repeat;
    e->m = m;
    for (int i = 0; i < m; i++) {
        e->number[i] = i;
        e->input[i] = kw_rng_below(&r, INPUTS);
        for (int j = 0; j < BITS; j++)
            e->signs[i * BITS + j] = all[e->input[i] * BITS + j];
        e->label[i] = label(e->signs + i * BITS);
    }
}

/* The share of all inputs that the program answers wrongly. */
static double share_wrong(program *learn, task *label, const double *all, uint64_t repeat,
                          int m)
{
    experience e;
    double answer[INPUTS];
    int wrong = 0;

    gather(label, all, repeat, m, &e);
    learn(&e, all, answer);
    for (int i = 0; i < INPUTS; i++)
        wrong += answer[i] != label(all + i * BITS);
    return (double)wrong / INPUTS;
}

/* One program on one task: its errors in every repeat, for every size of experience. */
typedef struct curve {
    double error[REPEATS][SIZES];
} curve;

static void try_program(program *learn, task *label, const double *all, curve *c)
{
    for (int k = 0; k < REPEATS; k++)
        for (int s = 0; s < SIZES; s++)
            c->error[k][s] = share_wrong(learn, label, all, (uint64_t)k, LEAST << s);
}

static double mean_error(const curve *c, int s)
{
    double sum = 0;

    for (int k = 0; k < REPEATS; k++)
        sum += c->error[k][s];
    return sum / REPEATS;
}

static double least_error(const curve *c, int s)
{
    double least = 1;

    for (int k = 0; k < REPEATS; k++)
        least = fmin(least, c->error[k][s]);
    return least;
}

static double greatest_error(const curve *c, int s)
{
    double most = 0;

    for (int k = 0; k < REPEATS; k++)
        most = fmax(most, c->error[k][s]);
    return most;
}

/* Repeats in which the most experience leaves fewer errors than the least. */
static int improved(const curve *c)
{
    int count = 0;

    for (int k = 0; k < REPEATS; k++)
        count += c->error[k][SIZES - 1] < c->error[k][0];
    return count;
}

/* --- what the table should do: an input is unseen with probability (1 - 1/INPUTS)^m --- */

/* Mean and standard deviation of the share of inputs that are labelled -1, which half of all
   are, and unseen. */
static double table_mean(int m)
{
    return power(1 - 1.0 / INPUTS, m) / 2;
}

static double table_deviation(int m)
{
    double half = INPUTS / 2.0, mean = table_mean(m);
    double pairs = (half - 1) / half * power(1 - 2.0 / INPUTS, m) / 4;

    return sqrt(pairs + mean / INPUTS - mean * mean);
}

/* The table's mean over the repeats, where it is farthest from that, in standard deviations. */
static double table_off(const curve *c)
{
    double most = 0;

    for (int s = 0; s < SIZES; s++) {
        double off = fabs(mean_error(c, s) - table_mean(LEAST << s));

        most = fmax(most, off / (table_deviation(LEAST << s) / sqrt(REPEATS)));
    }
    return most;
}

/* --- columns and claims --- */

static void write_curve(kw_out *f, const char *name, const curve *c)
{
    kw_out_section(f, name, "samples mean least greatest");
    for (int s = 0; s < SIZES; s++) {
        kw_out_number(f, LEAST << s);
        kw_out_number(f, mean_error(c, s));
        kw_out_number(f, least_error(c, s));
        kw_out_number(f, greatest_error(c, s));
        kw_out_row(f);
    }
}

static void report_vote(kw_out *report, const curve *c)
{
    const int s64 = 4;

    kw_claim_count(report, "learn.vote.constant", improved(&c[CONSTANT]));
    kw_claim_count(report, "learn.vote.table", improved(&c[TABLE]));
    kw_claim_count(report, "learn.vote.perceptron", improved(&c[PERCEPTRON]));
    kw_claim_count(report, "learn.vote.network", improved(&c[NETWORK]));
    kw_claim_real(report, "learn.vote.table.64", table_mean(LEAST << s64));
    kw_claim_real(report, "learn.vote.table.off", table_off(&c[TABLE]));
    kw_claim_real(report, "learn.vote.perceptron.64", mean_error(&c[PERCEPTRON], s64));
    kw_claim_real(report, "learn.vote.network.64", mean_error(&c[NETWORK], s64));
}

static void report_product(kw_out *report, const curve *c)
{
    double least = 1, most = 0;

    for (int s = 0; s < SIZES; s++) {
        least = fmin(least, least_error(&c[PERCEPTRON], s));
        most = fmax(most, greatest_error(&c[PERCEPTRON], s));
    }
    kw_claim_count(report, "learn.product.constant", improved(&c[CONSTANT]));
    kw_claim_count(report, "learn.product.table", improved(&c[TABLE]));
    kw_claim_count(report, "learn.product.network", improved(&c[NETWORK]));
    kw_claim_real(report, "learn.product.table.off", table_off(&c[TABLE]));
    kw_claim_real(report, "learn.product.perceptron.least", least);
    kw_claim_real(report, "learn.product.perceptron.greatest", most);
    kw_claim_real(report, "learn.product.perceptron.256",
                  mean_error(&c[PERCEPTRON], SIZES - 1));
    kw_claim_real(report, "learn.product.network.64", mean_error(&c[NETWORK], 4));
    kw_claim_real(report, "learn.product.network.256",
                  mean_error(&c[NETWORK], SIZES - 1));
}

int main(void)
{
    static const char *const name[TASKS][PROGRAMS] = {
        {"vote constant", "vote table", "vote perceptron", "vote network"},
        {"product constant", "product table", "product perceptron", "product network"}};
    static task *const tasks[TASKS] = {vote, product};
    static program *const programs[PROGRAMS] = {constant, table, perceptron, network};
    static curve c[TASKS][PROGRAMS];
    kw_out *f = kw_out_data("ex_learning"), *report = kw_claim_new("ex_learning");
    double all[INPUTS * BITS];

    fill_inputs(BITS, all);
    for (int t = 0; t < TASKS; t++)
        for (int p = 0; p < PROGRAMS; p++) {
            try_program(programs[p], tasks[t], all, &c[t][p]);
            write_curve(f, name[t][p], &c[t][p]);
        }
    report_vote(report, c[0]);
    report_product(report, c[1]);
    return kw_out_close(f) | kw_out_close(report);
}
