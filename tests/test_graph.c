/* Graphs against tables: every edge of a random graph is also an entry of a square table,
   and every question has an answer by going through it. Indices and sums of small integers:
   all exact. */
#include "graph.h"
#include "graphs.h"
#include "test.h"
#include <math.h>

enum { GRAPHS = 400 };

static void check_table(const kw_graph *g, const double *table)
{
    CHECK(g->start[0] == 0, "%d", g->start[0]);
    for (int i = 0; i < g->n; i++) {
        int e = g->start[i];

        for (int j = 0; j < g->n; j++) {
            double want = table[i * g->n + j];
            int there = e < g->start[i + 1] && g->to[e] == j;

            CHECK(there == (want > 0), "edge %d, %d", i, j);
            if (there) {
                CHECK(g->weight[e] == want, "edge %d, %d: %g, not %g", i, j, g->weight[e],
                      want);
                e++;
            }
        }
        CHECK(e == g->start[i + 1], "node %d: %d entries too many", i,
              g->start[i + 1] - e);
    }
}

static void edges_are_stored_at_both_ends(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(401, 0, sample, 0);
        double table[MOST * MOST];
        kw_graph *g = graphs_random(&r, 1, table), *copy = kw_graph_new_copy(g);

        check_table(g, table);
        kw_graph_free(g);
        check_table(copy, table);
        kw_graph_free(copy);
    }
}

static void a_weight_is_one_unless_given(void)
{
    const int end[] = {2, 0, 1, 2};
    const double table[] = {0, 0, 1, 0, 0, 1, 1, 1, 0};
    kw_graph *g = kw_graph_new(3, 2, end, NULL), *lonely = kw_graph_new(1, 0, NULL, NULL);

    check_table(g, table);
    CHECK(lonely->n == 1 && lonely->start[1] == 0, "%d", lonely->start[1]);
    kw_graph_free(g);
    kw_graph_free(lonely);
}

static void renumbering_moves_the_table(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(402, 0, sample, 0);
        double table[MOST * MOST], moved[MOST * MOST] = {0};
        kw_graph *g = graphs_random(&r, 1, table), *renumbered;
        int to[MOST] = {0};

        graphs_shuffle(&r, g->n, to);
        for (int i = 0; i < g->n; i++)
            for (int j = 0; j < g->n; j++)
                moved[to[i] * g->n + to[j]] = table[i * g->n + j];
        renumbered = kw_graph_new_renumbered(g, to);
        check_table(renumbered, moved);
        kw_graph_free(renumbered);
        kw_graph_free(g);
    }
}

static void degrees_are_row_sums(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(403, 0, sample, 0);
        double table[MOST * MOST], degree[MOST];
        kw_graph *g = graphs_random(&r, 1, table);

        test_poison(degree, MOST);
        kw_graph_degrees(g, degree);
        for (int i = 0; i < g->n; i++) {
            double sum = 0;

            for (int j = 0; j < g->n; j++)
                sum += table[i * g->n + j];
            CHECK(degree[i] == sum, "node %d: %g, not %g", i, degree[i], sum);
        }
        CHECK(g->n == MOST || isnan(degree[g->n]), "written behind node %d", g->n - 1);
        kw_graph_free(g);
    }
}

/* Shortest ways between all pairs [Floyd, Warshall]; n where there is none. */
static void all_hops(int n, const double *table, int *hops)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            hops[i * n + j] = i == j ? 0 : table[i * n + j] > 0 ? 1 : n;
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                if (hops[i * n + k] + hops[k * n + j] < hops[i * n + j])
                    hops[i * n + j] = hops[i * n + k] + hops[k * n + j];
}

static void hops_are_shortest_ways(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(404, 0, sample, 0);
        double table[MOST * MOST];
        kw_graph *g = graphs_random(&r, 1, table);
        int want[MOST * MOST] = {0}, work[MOST], hops[MOST];

        all_hops(g->n, table, want);
        for (int i = 0; i < g->n; i++) {
            kw_graph_hops(g, i, work, hops);
            for (int j = 0; j < g->n; j++) {
                int way = want[i * g->n + j];

                CHECK(hops[j] == (way < g->n ? way : -1), "from %d to %d: %d", i, j,
                      hops[j]);
            }
        }
        kw_graph_free(g);
    }
}

/* Two nodes have the same number if and only if there is a way; and a number first appears
   one above all before it. */
static void components_are_numbered_in_order(void)
{
    int seen[MOST + 1] = {0};

    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(405, 0, sample, 0);
        double table[MOST * MOST];
        kw_graph *g = graphs_random(&r, 1, table);
        int hops[MOST * MOST] = {0}, work[MOST], component[MOST], count, next = 0;

        all_hops(g->n, table, hops);
        count = kw_graph_components(g, work, component);
        for (int i = 0; i < g->n; i++) {
            CHECK(0 <= component[i] && component[i] <= next, "node %d: %d", i,
                  component[i]);
            next += component[i] == next;
            for (int j = 0; j < g->n; j++)
                CHECK((component[i] == component[j]) == (hops[i * g->n + j] < g->n),
                      "nodes %d and %d: %d, %d", i, j, component[i], component[j]);
        }
        CHECK(next == count, "%d components, not %d", count, next);
        seen[count]++;
        kw_graph_free(g);
    }
    CHECK(seen[1] > 0 && seen[2] > 0 && seen[3] > 0, "%d, %d, %d", seen[1], seen[2],
          seen[3]);
}

/* --- nearest neighbours --- */

/* Is j among the k nearest of i? Counts those that come before it. Integer points: distances
   are exact. */
static int is_near(int n, int D, const double *x, int k, int i, int j)
{
    double to_j = 0;
    int before = 0;

    for (int h = 0; h < D; h++)
        to_j += (x[i * D + h] - x[j * D + h]) * (x[i * D + h] - x[j * D + h]);
    for (int q = 0; q < n; q++) {
        double to_q = 0;

        for (int h = 0; h < D; h++)
            to_q += (x[i * D + h] - x[q * D + h]) * (x[i * D + h] - x[q * D + h]);
        before += q != i && (to_q < to_j || (to_q == to_j && q < j));
    }
    return i != j && before < k;
}

/* Points of a small grid: many distances are equal, and some points too. */
static void nearest_points_are_joined(void)
{
    for (uint64_t sample = 0; sample < GRAPHS; sample++) {
        kw_rng r = kw_rng_at(406, 0, sample, 0);
        int n = 2 + kw_rng_below(&r, MOST - 1), D = 1 + kw_rng_below(&r, 3),
            k = 1 + kw_rng_below(&r, n - 1);
        double x[MOST * 3] = {0}, table[MOST * MOST] = {0};
        kw_graph *g;

        for (int i = 0; i < n * D; i++)
            x[i] = kw_rng_below(&r, 4);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                table[i * n + j] = is_near(n, D, x, k, i, j) || is_near(n, D, x, k, j, i);
        g = kw_graph_new_nearest(n, D, x, k);
        check_table(g, table);
        for (int i = 0; i < n; i++)
            CHECK(g->start[i + 1] - g->start[i] >= k, "node %d: %d neighbours", i,
                  g->start[i + 1] - g->start[i]);
        kw_graph_free(g);
    }
}

/* --- misuse --- */

static void edge_to_nowhere(void)
{
    const int end[] = {0, 1, 1, 3};

    kw_graph_new(3, 2, end, NULL);
}

static void edge_from_nowhere(void)
{
    const int end[] = {-1, 1};

    kw_graph_new(3, 1, end, NULL);
}

static void loop(void)
{
    const int end[] = {0, 1, 2, 2};

    kw_graph_new(3, 2, end, NULL);
}

static void edge_twice(void)
{
    const int end[] = {0, 2, 0, 1, 2, 0};

    kw_graph_new(3, 3, end, NULL);
}

static void weigh(double w)
{
    const int end[] = {0, 1};

    kw_graph_new(2, 1, end, &w);
}

static void weight_nan(void)
{
    weigh(NAN);
}

static void weight_zero(void)
{
    weigh(0);
}

static void weight_infinite(void)
{
    weigh(INFINITY);
}

static void no_nodes(void)
{
    kw_graph_new(0, 0, NULL, NULL);
}

static void less_than_no_edges(void)
{
    kw_graph_new(2, -1, NULL, NULL);
}

static void point_nan(void)
{
    const double x[] = {0, 0, 1, 0, 0, NAN};

    kw_graph_new_nearest(3, 2, x, 1);
}

static void all_are_near(void)
{
    const double x[] = {0, 1, 2};

    kw_graph_new_nearest(3, 1, x, 3);
}

static void none_is_near(void)
{
    const double x[] = {0, 1, 2};

    kw_graph_new_nearest(3, 1, x, 0);
}

static void points_nowhere(void)
{
    const double x[] = {0};

    kw_graph_new_nearest(3, 0, x, 1);
}

static void renumber(int a, int b)
{
    const int end[] = {0, 1}, to[] = {a, b};

    kw_graph_new_renumbered(kw_graph_new(2, 1, end, NULL), to);
}

static void same_number(void)
{
    renumber(1, 1);
}

static void number_beyond(void)
{
    renumber(0, 2);
}

static void hops_from_nowhere(void)
{
    const int end[] = {0, 1};
    int work[2], hops[2];

    kw_graph_hops(kw_graph_new(2, 1, end, NULL), 2, work, hops);
}

static void mistakes_are_named(void)
{
    test_aborts("edge 1 joins nodes 1 and 3, not in 0 .. 2", edge_to_nowhere);
    test_aborts("edge 0 joins nodes -1 and 1, not in 0 .. 2", edge_from_nowhere);
    test_aborts("edge 1 joins node 2 with itself", loop);
    test_aborts("nodes 0 and 2 are joined twice", edge_twice);
    test_aborts("edge 0 has the weight nan", weight_nan);
    test_aborts("edge 0 has the weight 0", weight_zero);
    test_aborts("edge 0 has the weight inf", weight_infinite);
    test_aborts("n = 0 nodes", no_nodes);
    test_aborts("-1 edges", less_than_no_edges);
    test_aborts("coordinate 1 of point 2 is nan", point_nan);
    test_aborts("k = 3 neighbours among 3 points", all_are_near);
    test_aborts("k = 0 neighbours among 3 points", none_is_near);
    test_aborts("n = 3 points, D = 0", points_nowhere);
    test_aborts("nodes 0 and 1 both become 1", same_number);
    test_aborts("node 1 becomes 2, not in 0 .. 1", number_beyond);
    test_aborts("node 2, not in 0 .. 1", hops_from_nowhere);
    kw_graph_free(NULL);
}

int main(void)
{
    test_run("graph: edges are stored at both ends, in ascending rows",
             edges_are_stored_at_both_ends);
    test_run("graph: a weight is one unless given", a_weight_is_one_unless_given);
    test_run("graph: renumbering moves rows and columns", renumbering_moves_the_table);
    test_run("graph: degrees are row sums", degrees_are_row_sums);
    test_run("graph: hops are shortest ways", hops_are_shortest_ways);
    test_run("graph: components are numbered in order", components_are_numbered_in_order);
    test_run("graph: the k nearest are joined, ties by index", nearest_points_are_joined);
    test_run("graph: mistakes abort and are named", mistakes_are_named);
    return test_end();
}
