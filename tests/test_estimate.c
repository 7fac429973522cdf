/* The estimates of memory: never less than what is taken then, and not much more. */
#include "estimate.h"
#include "hier.h"
#include "meshes.h"
#include <stdio.h>

enum { MESHES = 40 };

/* Rooms of arrays may be twice what is in them, and in tables half of the places are empty; the
   first rooms of small arrays and the tables of the walk down count for nothing much where a
   mesh is large. */
static const double most_times = 4, first_rooms = 1e4;

/* Both estimates against the bytes that there are in the end. */
static void held(const kw_mesh *m)
{
    kw_active *a = kw_active_new(m);
    kw_hier *b = kw_hier_new(m);
    double bytes = (double)kw_hier_bytes(b), guess = kw_estimate_hier(a),
           tables = m->levels * (16.0 * a->local * b->most + 2e5 + first_rooms);

    CHECK(guess >= bytes, "D = %d, %d levels: %g, %g bytes", m->D, m->levels, guess,
          bytes);
    CHECK(guess <= most_times * bytes + tables, "D = %d, %d levels: %g, %g bytes", m->D,
          m->levels, guess, bytes);
    CHECK(kw_estimate_active(m) < guess, "%g, %g", kw_estimate_active(m), guess);
    kw_hier_free(b);
    kw_active_free(a);
}

static void random_meshes(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(61, (uint64_t)D, (uint64_t)sample, 0);
            twin w = random_twin(&r, D, D == 3 ? 3 : 5,
                                 D == 1   ? 60
                                 : D == 2 ? 12
                                          : 4,
                                 D == 3 ? 2 : 4);

            held(w.mesh);
            twin_free(&w);
        }
}

/* Degree d, n cells a direction; the cells below `to` are refined, on all levels but the last,
   and `shrink` less of them each time. */
static kw_mesh *nested(int D, int d, int n, int to, int levels, int shrink)
{
    kw_tensor *g = meshes_uniform(D, d, n);
    kw_mesh *m = kw_mesh_new(g);

    kw_tensor_free(g);
    for (int level = 0; level + 1 < levels; level++, to = 2 * to - shrink) {
        const int low[D_MOST] = {0}, high[] = {to, to, to};

        kw_mesh_refine(m, level, low, high);
    }
    return m;
}

/* Domains whose edges follow each other closely, so that many levels meet on a cell. */
static void many_levels_on_a_cell(void)
{
    for (int shrink = 1; shrink <= 4; shrink++) {
        kw_mesh *line = nested(1, 9, 40, 20, 9, shrink),
                *square = nested(2, 5, 12, 8, 4, shrink),
                *cube = nested(3, 2, 8, 5, 3, shrink);

        held(line);
        held(square);
        held(cube);
        kw_mesh_free(line);
        kw_mesh_free(square);
        kw_mesh_free(cube);
    }
}

/* The active functions themselves: their indices, and two numbers a place of the tables. */
static void selections(void)
{
    kw_mesh *m = nested(2, 3, 64, 40, 4, 6);
    kw_active *a = kw_active_new(m);
    double bytes = 8.0 * a->size;

    for (int level = 0; level < m->levels; level++)
        bytes += 12.0 * (double)a->status[level]->room;
    CHECK(kw_estimate_active(m) >= bytes, "%g, %g bytes", kw_estimate_active(m), bytes);
    CHECK(kw_estimate_active(m) <= most_times * bytes, "%g, %g bytes",
          kw_estimate_active(m), bytes);
    kw_active_free(a);
    kw_mesh_free(m);
}

/* A cell and a function: 64 functions on each of 20^3 + 8 10^3 cells. */
static void pairs(void)
{
    kw_mesh *m = nested(3, 3, 20, 10, 2, 0);

    CHECK(kw_estimate_pairs(m) == 64 * (8000 + 8000), "%.0f", kw_estimate_pairs(m));
    CHECK(kw_estimate_numbers(m) == 64 * 64 * 16000, "%.0f", kw_estimate_numbers(m));
    kw_mesh_free(m);
}

/* Where nothing is refined nothing is carried: 8 bytes for each of the 64 functions of a cell, by
   half more while the lists grow, and about 100 for the cell; a table of 2^20 places for 67^3
   functions, and a list of these. With local^2 numbers a cell it would be 8.6e9. */
static void no_coarser_functions(void)
{
    kw_mesh *m = nested(3, 3, 64, 0, 1, 0);
    kw_active *a = kw_active_new(m);
    double cells = 64 * 64 * 64, guess = kw_estimate_hier(a);

    CHECK(guess >= cells * (64 * 12 + 40 + 48 + 16) + 0x1p20 * 12, "%g", guess);
    CHECK(guess <= 1.2 * (cells * (64 * 12 + 40 + 48 + 16 + 16) + 0x1p20 * 18), "%g",
          guess);
    kw_active_free(a);
    kw_mesh_free(m);
}

int main(void)
{
    test_run("estimate: on random meshes bases take no more, and no less than a quarter",
             random_meshes);
    test_run("estimate: so they do where many levels meet on a cell",
             many_levels_on_a_cell);
    test_run("estimate: active functions take no more", selections);
    test_run("estimate: cells with their functions, and with pairs of these", pairs);
    test_run("estimate: nothing is carried where nothing is refined",
             no_coarser_functions);
    return test_end();
}
