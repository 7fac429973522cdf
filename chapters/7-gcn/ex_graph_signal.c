/* Graph signal -- a graph network and an MLP learn the same task.

   What to see: a smooth signal on the cells of an adaptive mesh is hidden under noise, and
   two networks learn from pairs of signals to find it. The graph network knows which cells
   are neighbours, and a few pairs are enough; the MLP has to learn that as well, and needs
   hundreds; with a thousand it does a little better.

   Book: section 1.2, graph networks for data with a mesh structure.
   Claims: gcn.signal.*
   Chosen here: all of it. The mesh, signals and noise of signals.h; two Chebyshev layers of
   degree 3 with 4 channels and tanh between them; an MLP with 32 hidden units and tanh;
   Adam on batches of 8, at most 200 steps at rate 0.03 for the one and 1000 at 0.003 for the
   other, with which each does well, and at most 80 times through the pairs; 32 more pairs, which
   no step uses, say when to stop; 200 pairs for the test; three seeds, each for signals and
   weights. */

#include "claim.h"      /* what we found, for the ledger */
#include "gcn.h"        /* layers on the graph of the mesh */
#include "loss.h"       /* what is to be small */
#include "meshgraph.h"  /* cells and their neighbours */
#include "mlp.h"        /* the other network */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include "signals.h"    /* the mesh, and signals on it */
#include "supervised.h" /* a network, a loss and pairs make a task */
#include "train.h"      /* training */
#include <math.h>
#include <stdlib.h>

enum {
    CHANNELS = 4,
    DEGREE = 3,
    HIDDEN = 32,
    SIZES = 4,
    LARGEST = 1024,
    VALIDATION = 32,
    TEST = 200,
    PAIRS = LARGEST + VALIDATION + TEST,
    BATCH = 8,
    EPOCHS = 80, /* at most, where pairs are few */
    SEEDS = 3
};

static const int SIZE[SIZES] = {16, 64, 256, LARGEST}; /* pairs for the steps */

/* --- two networks --- */

typedef struct model {
    kw_net *net;
    kw_gcn *layer[2]; /* NULL in the MLP */
    double rate;
    int steps;
} model;

static model graph_model(const kw_graph *g)
{
    model m = {.net = kw_net_new(g->n), .rate = 0.03, .steps = 200};

    m.layer[0] = kw_gcn_new_chebyshev(g, 1, CHANNELS, DEGREE);
    m.layer[1] = kw_gcn_new_chebyshev(g, CHANNELS, 1, DEGREE);
    kw_net_add_gcn(m.net, m.layer[0]);
    kw_net_add_activation(m.net, KW_TANH);
    kw_net_add_gcn(m.net, m.layer[1]);
    return m;
}

static model mlp_model(const kw_graph *g)
{
    const int width[3] = {g->n, HIDDEN, g->n};
    const kw_activation_kind sigma[2] = {KW_TANH, KW_IDENTITY};
    model m = {.net = kw_mlp_new(2, width, sigma), .rate = 0.003, .steps = 1000};

    return m;
}

static void model_free(model *m)
{
    kw_net_free(m->net);
    kw_gcn_free(m->layer[0]);
    kw_gcn_free(m->layer[1]);
}

/* --- the task: pairs of a noisy and a clean signal --- */

static kw_supervised *new_task(const model *m, const signals *d)
{
    return kw_supervised_new(m->net, kw_loss_squared, PAIRS, d->noisy, d->clean, BATCH);
}

/* 0, 1, .. */
static void number(int count, int *list)
{
    for (int i = 0; i < count; i++)
        list[i] = i;
}

/* Trains from scratch on the first `training` pairs; w: all parameters. */
static void learn(const model *m, kw_supervised *task, uint64_t seed, int training,
                  double *w)
{
    int list[LARGEST + VALIDATION], epochs = m->steps * BATCH / training;
    const kw_train_plan plan = {.objective = kw_supervised_mean,
                                .problem = task,
                                .parameters = m->net->parameters,
                                .training = training,
                                .validation = VALIDATION,
                                .training_sample = list,
                                .validation_sample = list + LARGEST,
                                .epochs = epochs < EPOCHS ? epochs : EPOCHS,
                                .batch = BATCH,
                                .seed = seed};
    kw_optimizer *adam = kw_optimizer_new(KW_ADAM, m->net->parameters, m->rate);
    kw_train *run;

    number(LARGEST + VALIDATION, list);
    run = kw_train_new(&plan);
    kw_net_init(m->net, seed, w);
    KW_NEED(kw_train_run(run, adam, w) == 0, "no training with %d pairs", training);
    kw_train_free(run);
    kw_optimizer_free(adam);
}

/* The squared error, its mean over the cells and over the test pairs. */
static double test_error(kw_supervised *task, const double *w)
{
    double sum = 0;

    for (int i = 0; i < TEST; i++) {
        const int pair = LARGEST + VALIDATION + i;

        sum += kw_supervised_mean(task, 1, &pair, w, NULL);
    }
    return sum / ((double)TEST * task->net->out);
}

/* The same of what does nothing. */
static double noise_of(const signals *d, int n)
{
    double sum = 0;

    for (int i = (LARGEST + VALIDATION) * n; i < PAIRS * n; i++)
        sum += (d->noisy[i] - d->clean[i]) * (d->noisy[i] - d->clean[i]);
    return sum / (TEST * n);
}

/* --- all seeds --- */

typedef struct findings {
    double graph[SIZES][SEEDS], mlp[SIZES][SEEDS]; /* test errors */
    double moved[SEEDS]; /* of the graph network of SIZE[0] on the other mesh */
    double noise[SEEDS];
} findings;

/* Trains a model for all sizes; first: its parameters for SIZE[0]. */
static void learn_all(const model *m, kw_supervised *task, int seed,
                      double (*error)[SEEDS], double *first)
{
    double *w = kw_need_memory((size_t)m->net->parameters, sizeof *w);

    for (int size = 0; size < SIZES; size++) {
        double *here = size == 0 ? first : w;

        learn(m, task, (uint64_t)seed, SIZE[size], here);
        error[size][seed] = test_error(task, here);
    }
    free(w);
}

/* The cells, and the first test pair with what the networks make of it. */
static void write_cells(kw_out *f, const kw_meshgraph *cells, kw_supervised *graph,
                        const double *graph_w, kw_supervised *mlp, const double *mlp_w)
{
    const int pair = LARGEST + VALIDATION, n = cells->graph->n;

    kw_supervised_mean(graph, 1, &pair, graph_w, NULL);
    kw_supervised_mean(mlp, 1, &pair, mlp_w, NULL);
    kw_out_section(f, "cells", "x y x_low x_high y_low y_high clean noisy graph mlp");
    for (int i = 0; i < n; i++) {
        double low[2], high[2];

        for (int h = 0; h < 2; h++)
            cell_ends(cells, i, h, &low[h], &high[h]);
        kw_out_number(f, (low[0] + high[0]) / 2);
        kw_out_number(f, (low[1] + high[1]) / 2);
        for (int h = 0; h < 2; h++) {
            kw_out_number(f, low[h]);
            kw_out_number(f, high[h]);
        }
        kw_out_number(f, graph->batch_target[i]);
        kw_out_number(f, graph->batch_x[i]);
        kw_out_number(f, graph->y[i]);
        kw_out_number(f, mlp->y[i]);
        kw_out_row(f);
    }
}

static void learn_seed(kw_out *f, const kw_meshgraph *cells, const kw_meshgraph *other,
                       int seed, findings *all)
{
    model graph = graph_model(cells->graph), mlp = mlp_model(cells->graph);
    model moved = graph_model(other->graph);
    signals here = signals_new(cells, 731 + (uint64_t)seed, PAIRS);
    signals there = signals_new(other, 731 + (uint64_t)seed, PAIRS);
    kw_supervised *graph_task = new_task(&graph, &here);
    kw_supervised *mlp_task = new_task(&mlp, &here);
    kw_supervised *moved_task = new_task(&moved, &there);
    double *graph_w = kw_need_memory((size_t)graph.net->parameters, sizeof *graph_w);
    double *mlp_w = kw_need_memory((size_t)mlp.net->parameters, sizeof *mlp_w);

    learn_all(&graph, graph_task, seed, all->graph, graph_w);
    learn_all(&mlp, mlp_task, seed, all->mlp, mlp_w);
    all->noise[seed] = noise_of(&here, cells->graph->n);
    all->moved[seed] = test_error(moved_task, graph_w);
    if (seed == 0)
        write_cells(f, cells, graph_task, graph_w, mlp_task, mlp_w);
    free(graph_w);
    free(mlp_w);
    kw_supervised_free(graph_task);
    kw_supervised_free(mlp_task);
    kw_supervised_free(moved_task);
    signals_free(&here);
    signals_free(&there);
    model_free(&graph);
    model_free(&mlp);
    model_free(&moved);
}

typedef struct spread {
    double mean, least, most;
} spread;

static spread over_seeds(const double *a)
{
    spread s = {0, a[0], a[0]};

    for (int i = 0; i < SEEDS; i++) {
        s.mean += a[i] / SEEDS;
        s.least = fmin(s.least, a[i]);
        s.most = fmax(s.most, a[i]);
    }
    return s;
}

static void write_spread(kw_out *f, const double *a)
{
    spread s = over_seeds(a);

    kw_out_number(f, s.mean);
    kw_out_number(f, s.least);
    kw_out_number(f, s.most);
}

static void write_errors(kw_out *f, const findings *all)
{
    kw_out_section(f, "errors",
                   "pairs graph graph_least graph_most mlp mlp_least mlp_most noise");
    for (int size = 0; size < SIZES; size++) {
        kw_out_number(f, SIZE[size]);
        write_spread(f, all->graph[size]);
        write_spread(f, all->mlp[size]);
        kw_out_number(f, over_seeds(all->noise).mean);
        kw_out_row(f);
    }
}

int main(void)
{
    kw_out *f = kw_out_data("ex_graph_signal"), *report = kw_claim_new("ex_graph_signal");
    kw_meshgraph *cells = new_cells(0), *other = new_cells(2);
    model graph = graph_model(cells->graph), mlp = mlp_model(cells->graph);
    findings all;
    int mlp_better = 0; /* seeds in which it is, with the most pairs */

    for (int seed = 0; seed < SEEDS; seed++) {
        learn_seed(f, cells, other, seed, &all);
        mlp_better += all.mlp[SIZES - 1][seed] < all.graph[SIZES - 1][seed];
    }
    write_errors(f, &all);

    kw_claim_count(report, "gcn.signal.cells", cells->graph->n);
    kw_claim_count(report, "gcn.signal.sides", cells->graph->start[cells->graph->n] / 2);
    kw_claim_count(report, "gcn.signal.parameters.graph", graph.net->parameters);
    kw_claim_count(report, "gcn.signal.parameters.mlp", mlp.net->parameters);
    kw_claim_real(report, "gcn.signal.noise", over_seeds(all.noise).mean);
    kw_claim_real(report, "gcn.signal.few.graph", over_seeds(all.graph[0]).mean);
    kw_claim_real(report, "gcn.signal.few.mlp", over_seeds(all.mlp[0]).mean);
    kw_claim_real(report, "gcn.signal.many.graph", over_seeds(all.graph[SIZES - 1]).mean);
    kw_claim_real(report, "gcn.signal.many.mlp", over_seeds(all.mlp[SIZES - 1]).mean);
    kw_claim_count(report, "gcn.signal.many.better", mlp_better);
    kw_claim_real(report, "gcn.signal.moved", over_seeds(all.moved).mean);

    model_free(&graph);
    model_free(&mlp);
    kw_meshgraph_free(cells);
    kw_meshgraph_free(other);
    return kw_out_close(f) | kw_out_close(report);
}
