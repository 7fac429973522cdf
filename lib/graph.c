#include "graph.h"
#include "need.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- making a graph --- */

/* A graph of n nodes with room for `entries` entries in its rows. */
static kw_graph *new_empty(int n, int entries)
{
    kw_graph *g = kw_need_memory(1, sizeof *g);

    KW_NEED(n >= 1 && n < INT_MAX, "n = %d nodes", n);
    g->n = n;
    g->start = kw_need_memory((size_t)n + 1, sizeof *g->start);
    g->to = kw_need_memory((size_t)entries, sizeof *g->to);
    g->weight = kw_need_memory((size_t)entries, sizeof *g->weight);
    return g;
}

/* From the lengths of the rows in start[1] .. start[n] to their beginnings; next[i], the
   next free place of row i, is set to its beginning. */
static void begin_rows(kw_graph *g, int *next)
{
    for (int i = 0; i < g->n; i++) {
        next[i] = g->start[i];
        g->start[i + 1] += g->start[i];
    }
}

static void add_entry(kw_graph *g, int *next, int i, int j, double weight)
{
    g->to[next[i]] = j;
    g->weight[next[i]++] = weight;
}

static void need_edge(int n, int e, int i, int j, double weight)
{
    KW_NEED(0 <= i && i < n && 0 <= j && j < n,
            "edge %d joins nodes %d and %d, not in 0 .. %d", e, i, j, n - 1);
    KW_NEED(i != j, "edge %d joins node %d with itself", e, i);
    KW_NEED(weight > 0 && isfinite(weight), "edge %d has the weight %g", e, weight);
}

/* The same graph with ascending rows: entries are handed out in the order of the nodes that
   they lead from, each to the row of the node it leads to. */
static kw_graph *new_sorted(const kw_graph *g, int *next)
{
    kw_graph *sorted = new_empty(g->n, g->start[g->n]);

    memcpy(sorted->start, g->start, ((size_t)g->n + 1) * sizeof *g->start);
    memcpy(next, g->start, (size_t)g->n * sizeof *next);
    for (int i = 0; i < g->n; i++)
        for (int e = g->start[i]; e < g->start[i + 1]; e++)
            add_entry(sorted, next, g->to[e], i, g->weight[e]);
    return sorted;
}

kw_graph *kw_graph_new(int n, int edges, const int *end, const double *weight)
{
    kw_graph *g, *sorted;
    int *next;

    KW_NEED(0 <= edges && edges <= INT_MAX / 2, "%d edges", edges);
    g = new_empty(n, 2 * edges);
    next = kw_need_memory((size_t)n, sizeof *next);
    for (int e = 0; e < edges; e++) {
        need_edge(n, e, end[2 * e], end[2 * e + 1], weight ? weight[e] : 1);
        g->start[end[2 * e] + 1]++;
        g->start[end[2 * e + 1] + 1]++;
    }
    begin_rows(g, next);
    for (int e = 0; e < edges; e++) {
        add_entry(g, next, end[2 * e], end[2 * e + 1], weight ? weight[e] : 1);
        add_entry(g, next, end[2 * e + 1], end[2 * e], weight ? weight[e] : 1);
    }
    sorted = new_sorted(g, next);
    for (int i = 0; i < n; i++)
        for (int e = sorted->start[i] + 1; e < sorted->start[i + 1]; e++)
            KW_NEED(sorted->to[e - 1] < sorted->to[e], "nodes %d and %d are joined twice",
                    i, sorted->to[e]);
    kw_graph_free(g);
    free(next);
    return sorted;
}

static double squared_distance(int D, const double *x, const double *y)
{
    double sum = 0;

    for (int h = 0; h < D; h++)
        sum += (x[h] - y[h]) * (x[h] - y[h]);
    return sum;
}

/* near[0..k-1]: the points nearest to point i, by insertion into a list in their order;
   `distance` has k numbers. */
static void nearest(int n, int D, const double *x, int i, int k, double *distance,
                    int *near)
{
    int count = 0;

    for (int j = 0; j < n; j++) {
        double d =
            squared_distance(D, x + (size_t)i * (size_t)D, x + (size_t)j * (size_t)D);
        int at = count;

        if (j == i || (count == k && !(d < distance[k - 1])))
            continue;
        if (count == k)
            at = k - 1;
        else
            count++;
        for (; at > 0 && d < distance[at - 1]; at--) {
            distance[at] = distance[at - 1];
            near[at] = near[at - 1];
        }
        distance[at] = d;
        near[at] = j;
    }
}

static int contains(int count, const int *list, int j)
{
    for (int q = 0; q < count; q++)
        if (list[q] == j)
            return 1;
    return 0;
}

kw_graph *kw_graph_new_nearest(int n, int D, const double *x, int k)
{
    int *near, *end, edges = 0;
    double *distance;
    kw_graph *g;

    KW_NEED(n >= 1 && D >= 1 && n <= INT_MAX / D, "n = %d points, D = %d", n, D);
    KW_NEED(1 <= k && k < n && n <= INT_MAX / (2 * k),
            "k = %d neighbours among %d points", k, n);
    for (int i = 0; i < n * D; i++)
        KW_NEED(isfinite(x[i]), "coordinate %d of point %d is %g", i % D, i / D, x[i]);
    near = kw_need_memory((size_t)n * (size_t)k, sizeof *near);
    end = kw_need_memory(2 * (size_t)n * (size_t)k, sizeof *end);
    distance = kw_need_memory((size_t)k, sizeof *distance);
    for (int i = 0; i < n; i++)
        nearest(n, D, x, i, k, distance, near + i * k);
    for (int i = 0; i < n; i++)
        for (int q = 0; q < k; q++) {
            int j = near[i * k + q];

            /* the pair is found from either end: the smaller one speaks for both */
            if (j < i && contains(k, near + j * k, i))
                continue;
            end[2 * edges] = i;
            end[2 * edges++ + 1] = j;
        }
    g = kw_graph_new(n, edges, end, NULL);
    free(near);
    free(end);
    free(distance);
    return g;
}

kw_graph *kw_graph_new_copy(const kw_graph *g)
{
    kw_graph *copy = new_empty(g->n, g->start[g->n]);
    size_t entries = (size_t)g->start[g->n];

    memcpy(copy->start, g->start, ((size_t)g->n + 1) * sizeof *g->start);
    memcpy(copy->to, g->to, entries * sizeof *g->to);
    memcpy(copy->weight, g->weight, entries * sizeof *g->weight);
    return copy;
}

kw_graph *kw_graph_new_renumbered(const kw_graph *g, const int *to)
{
    kw_graph *moved = new_empty(g->n, g->start[g->n]), *sorted;
    int *next = kw_need_memory((size_t)g->n, sizeof *next);

    for (int i = 0; i < g->n; i++)
        next[i] = -1;
    for (int i = 0; i < g->n; i++) {
        KW_NEED(0 <= to[i] && to[i] < g->n, "node %d becomes %d, not in 0 .. %d", i,
                to[i], g->n - 1);
        KW_NEED(next[to[i]] == -1, "nodes %d and %d both become %d", next[to[i]], i,
                to[i]);
        next[to[i]] = i;
        moved->start[to[i] + 1] = g->start[i + 1] - g->start[i];
    }
    begin_rows(moved, next);
    for (int i = 0; i < g->n; i++)
        for (int e = g->start[i]; e < g->start[i + 1]; e++)
            add_entry(moved, next, to[i], to[g->to[e]], g->weight[e]);
    sorted = new_sorted(moved, next);
    kw_graph_free(moved);
    free(next);
    return sorted;
}

void kw_graph_free(kw_graph *g)
{
    if (!g)
        return;
    free(g->start);
    free(g->to);
    free(g->weight);
    free(g);
}

/* --- asking --- */

void kw_graph_degrees(const kw_graph *g, double *degree)
{
    for (int i = 0; i < g->n; i++) {
        degree[i] = 0;
        for (int e = g->start[i]; e < g->start[i + 1]; e++)
            degree[i] += g->weight[e];
    }
}

/* Visits all nodes that a way leads to from node `from`, in the order of their hops, and
   that have the number -1; `from` gets the number `first`, and each node that of the one it
   is reached from plus `step`. */
static void visit(const kw_graph *g, int from, int first, int step, int *queue,
                  int *number)
{
    int count = 0;

    queue[count++] = from;
    number[from] = first;
    for (int q = 0; q < count; q++) {
        int i = queue[q];

        for (int e = g->start[i]; e < g->start[i + 1]; e++)
            if (number[g->to[e]] == -1) {
                number[g->to[e]] = number[i] + step;
                queue[count++] = g->to[e];
            }
    }
}

void kw_graph_hops(const kw_graph *g, int from, int *work, int *hops)
{
    KW_NEED(0 <= from && from < g->n, "node %d, not in 0 .. %d", from, g->n - 1);
    for (int i = 0; i < g->n; i++)
        hops[i] = -1;
    visit(g, from, 0, 1, work, hops);
}

int kw_graph_components(const kw_graph *g, int *work, int *component)
{
    int count = 0;

    for (int i = 0; i < g->n; i++)
        component[i] = -1;
    for (int i = 0; i < g->n; i++)
        if (component[i] == -1)
            visit(g, i, count++, 0, work, component);
    return count;
}
