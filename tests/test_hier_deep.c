/* A mesh that is deep, and what a caller may not do. */
#include "hier.h"
#include "meshes.h"
#include "spline.h"
#include <math.h>

enum { LEVELS = 9, CELLS = 16, PLACES = 2000 };

/* 16 x 16 cells, refined along the diagonal: on each level the cells with |i-j| <= 2, as far as
   they lie in the domain. A table of all cells would have 2^24. */
static kw_mesh *diagonal(int levels)
{
    kw_mesh *m;
    kw_tensor *g = meshes_uniform(2, 2, CELLS);

    m = kw_mesh_new(g);
    kw_tensor_free(g);
    for (int level = 0; level + 1 < levels; level++)
        for (int i = 0; i < CELLS << level; i++) {
            int last = CELLS << level;
            const int low[] = {i, i < 2 ? 0 : i - 2};
            const int high[] = {i + 1, i + 3 < last ? i + 3 : last};

            kw_mesh_refine(m, level, low, high);
        }
    return m;
}

/* How many cells of a level lie in the band |i-j| <= width. */
static long long band(int cells, int width)
{
    long long inside = cells;

    for (int off = 1; off <= width; off++)
        inside += 2 * (cells - off);
    return inside;
}

/* On every level a cell of the band lies in the domain, for |i-j| <= 2 gives parents that are at
   most 1 apart. So its cells are those of the band, and it has the children of the band of the
   level before but its own. */
static void cells_are_counted(void)
{
    kw_mesh *m = diagonal(LEVELS);

    CHECK(m->levels == LEVELS, "%d levels", m->levels);
    for (int level = 0; level < LEVELS; level++) {
        int cells = CELLS << level;
        long long all = level > 0 ? 4 * band(cells / 2, 2) : (long long)cells * cells;
        long long want = all - (level + 1 < LEVELS ? band(cells, 2) : 0);

        CHECK(kw_mesh_active(m, level) == want, "level %d: %lld, %lld", level,
              kw_mesh_active(m, level), want);
    }
    kw_mesh_free(m);
}

/* The selection, Kraft's recursion, the leaves and the sum one on it. */
static void bases_are_what_they_should(void)
{
    kw_mesh *m = diagonal(LEVELS);
    kw_hier *b = kw_hier_new(m);
    kw_rng r = kw_rng_at(40, 0, 0, 0);
    int *index = room_for(b->most, sizeof *index);
    double *value = room_for(b->most + GUARD, sizeof *value);
    long long cells = 0;

    CHECK(b->active->size == kw_active_kraft(m), "%d, %lld", b->active->size,
          kw_active_kraft(m));
    for (int level = 0; level < LEVELS; level++)
        cells += kw_mesh_active(m, level);
    CHECK(b->tree->leaves == cells, "%d leaves, %lld cells", b->tree->leaves, cells);
    for (int p = 0; p < PLACES; p++) {
        double x[2], sum = 0;
        int count;

        x[0] = test_random_in(&r, 0, CELLS);
        x[1] = p % 2 ? test_random_in(&r, 0, CELLS) : x[0];
        poison(value, b->most);
        count = kw_hier_at(b, KW_THB, NULL, x, index, value);
        for (int i = 0; i < count; i++) {
            CHECK(value[i] >= 0, "function %d: %g", index[i], value[i]);
            sum += value[i];
        }
        CHECK(fabs(sum - 1) <= bound(truncated_roundings(m) + count, 1), "1 + %g",
              sum - 1);
    }
    free(index);
    free(value);
    kw_hier_free(b);
    kw_mesh_free(m);
}

/* From one depth to the next the diagonal is twice as long. If memory follows the functions, a
   function takes as many bytes at either, but for the tables: these grow by doubling and are
   a quarter to a half full, so their share may differ by a factor of two. */
static void memory_follows_the_functions(void)
{
    double each[2];

    for (int i = 0; i < 2; i++) {
        kw_mesh *m = diagonal(5 + 2 * i);
        kw_hier *b = kw_hier_new(m);

        each[i] = (double)kw_hier_bytes(b) / b->active->size;
        CHECK(kw_hier_bytes(b) >= b->numbers * sizeof(double), "%zu bytes",
              kw_hier_bytes(b));
        kw_hier_free(b);
        kw_mesh_free(m);
    }
    CHECK(each[1] < 2 * each[0], "%g and %g bytes a function", each[0], each[1]);
}

/* On a line of cells, what a cell more takes: a knot, with its place among the edges, in the table
   of spans and in the list of them; a function; a leaf, which is a node with d+1 functions of
   its own. Tables with room for more functions are left out. */
static void memory_is_counted(void)
{
    enum { DEGREE = 2, FEW = 100, MANY = 1100 };
    const size_t cell = sizeof(double) + 3 * sizeof(int) + sizeof(uint64_t) +
                        sizeof(kw_hier_leaf) + sizeof(kw_celltree_node) +
                        sizeof(kw_hier_own) + (DEGREE + 1) * sizeof(kw_hier_function);
    size_t bytes[2];

    for (int i = 0; i < 2; i++) {
        kw_tensor *g = meshes_uniform(1, DEGREE, i ? MANY : FEW);
        kw_mesh *m = kw_mesh_new(g);
        kw_hier *b = kw_hier_new(m);
        const kw_map *table = b->active->status[0];

        bytes[i] =
            kw_hier_bytes(b) - table->room * (sizeof *table->key + sizeof *table->value);
        kw_hier_free(b);
        kw_mesh_free(m);
        kw_tensor_free(g);
    }
    CHECK(bytes[1] - bytes[0] == (MANY - FEW) * cell, "%zu bytes for %d cells of %zu",
          bytes[1] - bytes[0], MANY - FEW, cell);
}

/* --- misuse --- */

static kw_hier *small(void)
{
    return kw_hier_new(kw_mesh_new(meshes_uniform(2, 2, 3)));
}

static const double INSIDE[] = {1, 1};

static void function_beyond(void)
{
    kw_hier_one(small(), KW_THB, 25, NULL, INSIDE);
}

static void function_before(void)
{
    kw_hier_one(small(), KW_HB, -1, NULL, INSIDE);
}

/* Evaluates at (x, y), differentiating `order` times in direction 1. */
static void evaluate(kw_hier_kind kind, double x, double y, int order)
{
    const double at[] = {x, y};
    const int orders[] = {0, order};
    int index[9];
    double value[9];

    kw_hier_at(small(), kind, orders, at, index, value);
}

static void beyond_thb(void)
{
    evaluate(KW_THB, 1, 3.5, 0);
}

static void beyond_hb(void)
{
    evaluate(KW_HB, -0.5, 1, 0);
}

static void nowhere(void)
{
    evaluate(KW_THB, NAN, 1, 0);
}

static void negative_order(void)
{
    evaluate(KW_HB, 1, 1, -1);
}

static void cell_beyond(void)
{
    double value[9];

    kw_hier_local(small(), 9, NULL, INSIDE, value);
}

static void negative_count(void)
{
    kw_hier_at_many(small(), KW_HB, NULL, -1, INSIDE, NULL, NULL, NULL);
}

static void misuse_aborts(void)
{
    test_aborts("-1 points", negative_count);
    test_aborts("function 25, not in 0 .. 24", function_beyond);
    test_aborts("function -1, not in 0 .. 24", function_before);
    test_aborts("x = 3.5 outside the domain [0, 3]", beyond_thb);
    test_aborts("x = -0.5 outside the domain [0, 3]", beyond_hb);
    test_aborts("x = nan outside the domain", nowhere);
    test_aborts("derivative -1", negative_order);
    test_aborts("cell 9, not in 0 .. 8", cell_beyond);
}

static void nothing_may_be_freed(void)
{
    kw_hier_free(NULL);
}

int main(void)
{
    test_run("hier: nine levels along a diagonal have the cells of the band",
             cells_are_counted);
    test_run("hier: there both counts agree, and THB-splines add up to one",
             bases_are_what_they_should);
    test_run("hier: memory follows the functions", memory_follows_the_functions);
    test_run("hier: its bytes are all counted", memory_is_counted);
    test_run("hier: indices, points and orders out of range abort", misuse_aborts);
    test_run("hier: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
