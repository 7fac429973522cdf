/* Network -- a directed acyclic graph.

   What to see: nothing to look at. The units of a network and the edges between them, found by
   sending numbers through the layers of the library, are put into an order in which every edge
   leads forward; computing one unit after the other in this order gives what the network gives.

   Book: section 1.2, Definition 7.
   Claims: learn.dag.*
   Chosen here: random multi-layer perceptrons with ReLU, three architectures in particular,
   random graphs; integers, so that all is exact. */

#include "claim.h"   /* what we found, for the ledger */
#include "mlp.h"     /* networks */
#include "need.h"    /* memory */
#include "out.h"     /* reports are files */
#include "rng.h"     /* random networks and graphs */
#include "shuffle.h" /* random numbers for vertices */
#include <math.h>
#include <stdlib.h>

enum { CASES = 200, DEPTH = 4, WIDTH = 6, VERTICES = 12 };

static const uint64_t SEED = 421;

/* --- graphs --- */

typedef struct edge {
    int from, to;
    double weight;
} edge;

/* A vertex computes sigma(bias + the sum over its incoming edges of weight times value); an input
   has no incoming edge, and its bias is its value. */
typedef struct dag {
    int vertices, edges;
    double *bias;
    kw_activation_kind *sigma;
    edge *edge;
} dag;

static dag new_dag(int vertices, int most_edges)
{
    return (dag){.vertices = vertices,
                 .bias = kw_need_memory((size_t)vertices, sizeof(double)),
                 .sigma = kw_need_memory((size_t)vertices, sizeof(kw_activation_kind)),
                 .edge = kw_need_memory((size_t)most_edges, sizeof(edge))};
}

static void free_dag(dag *g)
{
    free(g->bias);
    free(g->sigma);
    free(g->edge);
}

/* Puts the vertices into an order in which every edge leads forward, and returns how many
   there are in it: all of them, unless there is a cycle. A vertex is next if no edge
   is left that leads to it. [Kahn: Topological sorting of large networks, 1962] */
static int sort(const dag *g, int *order)
{
    int *incoming = kw_need_memory((size_t)g->vertices, sizeof *incoming);
    int count = 0;

    for (int e = 0; e < g->edges; e++)
        incoming[g->edge[e].to]++;
    for (int v = 0; v < g->vertices; v++)
        if (incoming[v] == 0)
            order[count++] = v;
    for (int next = 0; next < count; next++)
        for (int e = 0; e < g->edges; e++)
            if (g->edge[e].from == order[next] && --incoming[g->edge[e].to] == 0)
                order[count++] = g->edge[e].to;
    free(incoming);
    return count;
}

/* Edges that do not lead forward in the order of all vertices. */
static int backward_edges(const dag *g, const int *order)
{
    int *place = kw_need_memory((size_t)g->vertices, sizeof *place), count = 0;

    for (int i = 0; i < g->vertices; i++)
        place[order[i]] = i;
    for (int e = 0; e < g->edges; e++)
        count += place[g->edge[e].from] >= place[g->edge[e].to];
    free(place);
    return count;
}

static int has_order(const dag *g)
{
    int *order = kw_need_memory((size_t)g->vertices, sizeof *order);
    int found = sort(g, order) == g->vertices && backward_edges(g, order) == 0;

    free(order);
    return found;
}

/* What the vertices compute, one after the other in this order. */
static void walk(const dag *g, const int *order, double *value)
{
    for (int i = 0; i < g->vertices; i++) {
        int v = order[i];
        double sum = g->bias[v];

        for (int e = 0; e < g->edges; e++)
            if (g->edge[e].to == v)
                sum += g->edge[e].weight * value[g->edge[e].from];
        value[v] = kw_activation_value(g->sigma[v], sum);
    }
}

/* --- networks as graphs --- */

static int count_units(int L, const int *width)
{
    int count = 0;

    for (int l = 0; l <= L; l++)
        count += width[l];
    return count;
}

/* The graph of a network with the parameters w and the inputs p. Unit i of all units, layer by
   layer, is vertex[i]. An edge is where a unit makes a difference to one of the next layer. */
static dag graph_of(const kw_net *n, const double *w, const double *p, const int *vertex,
                    int vertices)
{
    const int L = kw_mlp_depth(n);
    dag g = new_dag(vertices, n->parameters);

    for (int i = 0; i < n->in; i++)
        g.bias[vertex[i]] = p[i];
    for (int l = 1; l <= L; l++) {
        int first;
        const kw_affine *a = kw_mlp_affine(n, l, &first);
        const int *next = vertex + a->in;
        double *x = kw_need_memory((size_t)a->in, sizeof *x);
        double *rest = kw_need_memory((size_t)a->out, sizeof *rest);
        double *y = kw_need_memory((size_t)a->out, sizeof *y);

        kw_affine_forward(a, w + first, 1, x, rest);
        for (int i = 0; i < a->out; i++) {
            g.bias[next[i]] = rest[i];
            g.sigma[next[i]] = l < L ? KW_RELU : KW_IDENTITY;
        }
        for (int j = 0; j < a->in; j++) {
            x[j] = 1;
            kw_affine_forward(a, w + first, 1, x, y);
            x[j] = 0;
            for (int i = 0; i < a->out; i++)
                if (y[i] != rest[i])
                    g.edge[g.edges++] = (edge){vertex[j], next[i], y[i] - rest[i]};
        }
        vertex = next;
        free(x);
        free(rest);
        free(y);
    }
    return g;
}

/* -3 .. 3 without 0 */
static void random_integers(kw_rng *r, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = (1 + kw_rng_below(r, 3)) * (kw_rng_below(r, 2) ? 1 : -1);
}

typedef struct findings {
    int edges_off, without_order;
    double values_off;
} findings;

/* A network with ReLU between its layers and random integers for parameters and inputs p. Units
   get random numbers as vertices. Returns its edges, and adds what is off to *all. */
static int try_network(kw_rng *r, int L, const int *width, findings *all)
{
    kw_activation_kind sigma[DEPTH] = {KW_RELU, KW_RELU, KW_RELU, KW_RELU};
    const int units = count_units(L, width);
    double *value = kw_need_memory((size_t)units, sizeof *value);
    int *vertex = kw_need_memory((size_t)units, sizeof *vertex);
    int *order = kw_need_memory((size_t)units, sizeof *order);
    double *w, *p, *y;
    int wanted = 0, edges;
    kw_net *n;
    kw_net_work *work;
    dag g;

    sigma[L - 1] = KW_IDENTITY;
    n = kw_mlp_new(L, width, sigma);
    work = kw_net_work_new(n, 1);
    w = kw_need_memory((size_t)n->parameters, sizeof *w);
    p = kw_need_memory((size_t)n->in, sizeof *p);
    y = kw_need_memory((size_t)n->out, sizeof *y);
    random_integers(r, n->parameters, w);
    random_integers(r, n->in, p);
    shuffle(r, units, vertex);
    g = graph_of(n, w, p, vertex, units);

    for (int l = 1; l <= L; l++)
        wanted += width[l] * width[l - 1];
    edges = g.edges;
    all->edges_off += edges != wanted;
    if (sort(&g, order) == units && backward_edges(&g, order) == 0) {
        walk(&g, order, value);
        kw_net_forward(n, w, 1, p, work, y);
        for (int i = 0; i < n->out; i++) {
            double off = value[vertex[units - n->out + i]] - y[i];

            all->values_off = fmax(all->values_off, fabs(off));
        }
    } else
        all->without_order++;
    free_dag(&g);
    kw_net_work_free(work);
    kw_net_free(n);
    free(w);
    free(p);
    free(y);
    free(value);
    free(vertex);
    free(order);
    return edges;
}

static findings try_networks(void)
{
    findings all = {0, 0, 0};

    for (uint64_t i = 0; i < CASES; i++) {
        kw_rng r = kw_rng_at(SEED, 1, i, 0);
        int L = 1 + kw_rng_below(&r, DEPTH), width[DEPTH + 1];

        for (int l = 0; l <= L; l++)
            width[l] = 1 + kw_rng_below(&r, WIDTH);
        try_network(&r, L, width, &all);
    }
    return all;
}

/* --- graphs that are not made of layers, and graphs with a cycle --- */

/* Vertices joined at random, always a lower with a higher one, under random numbers. With a
   cycle: each is also joined with the next, and one edge leads back. */
static dag random_graph(kw_rng *r, int with_cycle)
{
    int vertex[VERTICES] = {0};
    int high = 1 + kw_rng_below(r, VERTICES - 1), low = kw_rng_below(r, high);
    dag g = new_dag(VERTICES, VERTICES * VERTICES);

    shuffle(r, VERTICES, vertex);
    for (int i = 0; i < VERTICES; i++)
        for (int j = i + 1; j < VERTICES; j++)
            if (kw_rng_below(r, 3) == 0 || (with_cycle && j == i + 1))
                g.edge[g.edges++] = (edge){vertex[i], vertex[j], 1};
    if (with_cycle)
        g.edge[g.edges++] = (edge){vertex[high], vertex[low], 1};
    return g;
}

/* How many of CASES random graphs have an order. */
static int count_ordered(int with_cycle)
{
    int count = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        kw_rng r = kw_rng_at(SEED, with_cycle ? 2 : 3, i, 0);
        dag g = random_graph(&r, with_cycle);

        count += has_order(&g);
        free_dag(&g);
    }
    return count;
}

int main(void)
{
    static const int small[] = {2, 3, 1}, middle[] = {4, 5, 3, 2, 2};
    static const int large[] = {784, 128, 64, 32, 10};
    kw_out *report = kw_claim_new("ex_network");
    findings all = try_networks();
    kw_rng r = kw_rng_at(SEED, 5, 0, 0);

    kw_claim_count(report, "learn.dag.small", try_network(&r, 2, small, &all));
    kw_claim_count(report, "learn.dag.middle", try_network(&r, 4, middle, &all));
    kw_claim_count(report, "learn.dag.large", try_network(&r, 4, large, &all));
    kw_claim_count(report, "learn.dag.unordered", all.without_order);
    kw_claim_count(report, "learn.dag.edges", all.edges_off);
    kw_claim_real(report, "learn.dag.values", all.values_off);
    kw_claim_count(report, "learn.dag.random", count_ordered(0));
    kw_claim_count(report, "learn.dag.cycle", count_ordered(1));
    return kw_out_close(report);
}
