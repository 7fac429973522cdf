/* Which functions are active: the selection (14) by going through all functions and all cells of
   a table (meshes.h), Kraft's count, and counts that are known. */
#include "active.h"
#include "meshes.h"

enum { MESHES = 40 };

/* What kw_active says of function j of a level, as one of the three words. */
static int word(int status)
{
    return status >= KW_ACTIVE_FIRST     ? ACTIVE
           : status == KW_ACTIVE_COVERED ? COVERED
                                         : OUTSIDE;
}

/* --- against the table --- */

/* Function j of a level; `next` active functions came before it. */
static void check_function(const twin *w, const kw_active *a, int level, const int *j,
                           int next)
{
    int want = twin_status(w, level, j), status = kw_active_status(a, level, j);
    int found = kw_active_find(a, level, j), at[D_MOST], back = -1;

    CHECK(word(status) == want, "level %d, function %d, ..: %d, not %d", level, j[0],
          status, want);
    CHECK(found == (want == ACTIVE ? next : -1), "level %d: %d, next %d", level, found,
          next);
    if (found < 0)
        return;
    CHECK(status == KW_ACTIVE_FIRST + found, "%d, %d", status, found);
    kw_active_function(a, found, &back, at);
    CHECK(back == level && memcmp(at, j, (size_t)w->D * sizeof *j) == 0,
          "function %d: level %d, not %d", found, back, level);
}

static void check_selection(const twin *w, const kw_active *a)
{
    const int zero[D_MOST] = {0};
    int next = 0;

    for (int level = 0; level < w->mesh->levels; level++) {
        int n[D_MOST] = {0}, j[D_MOST] = {0};

        CHECK(a->start[level] == next, "level %d: %d, %d", level, a->start[level], next);
        functions_of(w, level, n);
        do {
            check_function(w, a, level, j, next);
            next += twin_status(w, level, j) == ACTIVE;
        } while (step(w->D, zero, n, j));
    }
    CHECK(a->size == next && a->start[w->mesh->levels] == next, "%d, %d", a->size, next);
    CHECK(kw_active_kraft(w->mesh) == next, "%lld, %d", kw_active_kraft(w->mesh), next);
}

/* The local functions of each cell, and that they are those that are not zero on it. */
static void check_cells(const twin *w, const kw_active *a)
{
    int *is = room_for(a->local, sizeof *is);

    for (int level = 0; level < w->mesh->levels; level++) {
        const int zero[D_MOST] = {0};
        int cell[D_MOST] = {0};

        do {
            int low[D_MOST] = {0}, high[D_MOST] = {0}, j[D_MOST], f = 0;

            kw_active_box(w->mesh, level, cell, low, high);
            kw_active_of_cell(a, level, cell, is);
            memcpy(j, low, sizeof j);
            do {
                int from[D_MOST], to[D_MOST];

                twin_support(w, level, j, from, to);
                for (int h = 0; h < w->D; h++) {
                    int corner = cell[h] << (w->finest - level);

                    CHECK(from[h] <= corner && corner < to[h], "level %d, function %d",
                          level, j[h]);
                }
                CHECK(is[f++] == kw_active_status(a, level, j), "level %d", level);
            } while (step(w->D, low, high, j));
            CHECK(f == a->local, "%d, %d local functions", f, a->local);
        } while (step(w->D, zero, w->mesh->level[level].cells, cell));
    }
    free(is);
}

static void check_witnesses(const twin *w, const kw_active *a)
{
    for (int i = 0; i < a->size; i++) {
        int cell[D_MOST] = {-1, -1, -1}, level, j[D_MOST], low[D_MOST], high[D_MOST];
        int of_cell = kw_active_cell(a, i, cell);

        kw_active_function(a, i, &level, j);
        CHECK(of_cell == level, "function %d: level %d, not %d", i, of_cell, level);
        CHECK(twin_depth(w, level, cell) == level,
              "function %d: cell %d, .. is not active", i, cell[0]);
        twin_support(w, level, j, low, high);
        for (int h = 0; h < w->D; h++) {
            int corner = cell[h] << (w->finest - level);

            CHECK(low[h] <= corner && corner < high[h], "function %d, direction %d", i,
                  h);
        }
    }
}

static void check_all(const twin *w)
{
    kw_active *a = kw_active_new(w->mesh);

    check_selection(w, a);
    check_cells(w, a);
    check_witnesses(w, a);
    kw_active_free(a);
}

static void random_meshes(int D, int highest, int most, int finest)
{
    for (int sample = 0; sample < MESHES; sample++) {
        kw_rng r = kw_rng_at(32, (uint64_t)D, (uint64_t)sample, 0);
        twin w = random_twin(&r, D, highest, most, finest);

        check_all(&w);
        twin_free(&w);
    }
}

static void one_direction(void)
{
    random_meshes(1, 4, 6, 4);
}

static void two_directions(void)
{
    random_meshes(2, 4, 4, 2);
}

static void three_directions(void)
{
    random_meshes(3, 2, 2, 2);
}

/* --- degenerate meshes --- */

static void nothing_refined(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        twin w = twin_new(meshes_uniform(D, 2, 3), 1);
        kw_active *a = kw_active_new(w.mesh);
        int n[D_MOST];

        CHECK(a->size == functions_of(&w, 0, n), "%d functions", a->size);
        kw_active_free(a);
        check_all(&w);
        twin_free(&w);
    }
}

static void everything_refined(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        twin w = twin_new(meshes_uniform(D, 2, 2), 2);
        kw_active *a;
        int n[D_MOST];

        refine_everything(&w);
        a = kw_active_new(w.mesh);
        CHECK(a->start[1] == 0 && a->start[2] == 0, "%d, %d", a->start[1], a->start[2]);
        CHECK(a->size == functions_of(&w, 2, n), "%d functions", a->size);
        kw_active_free(a);
        check_all(&w);
        twin_free(&w);
    }
}

/* One cell, refined, and again its first child, and again. */
static void one_cell(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int d = 0; d <= 3; d++) {
            twin w = twin_new(meshes_uniform(D, d, 1), 3);

            for (int level = 0; level < 3; level++)
                refine_cube(&w, level, 0, 1);
            check_all(&w);
            twin_free(&w);
        }
}

/* A refined cell with no refined neighbour holds no support of degree 2, so Omega^1 brings no
   function at all. */
static void isolated_cells(void)
{
    twin w = twin_new(meshes_uniform(2, 2, 7), 2);
    kw_active *a;

    for (int c = 1; c <= 5; c += 2)
        refine_cube(&w, 0, c, c + 1);
    a = kw_active_new(w.mesh);
    CHECK(a->size == 81 && a->start[1] == 81, "%d, %d", a->size, a->start[1]);
    kw_active_free(a);
    check_all(&w);
    twin_free(&w);
}

/* At the corner of an open mesh even one cell holds supports: 1 x 1 of those of degree 1. */
static void corners_hold_functions(void)
{
    twin w = twin_new(meshes_uniform(2, 1, 3), 1);
    kw_active *a;

    refine_cube(&w, 0, 0, 1);
    a = kw_active_new(w.mesh);
    /* level 0: 16 but the corner's own function; level 1: those of knots 0 and 1/2 */
    CHECK(a->start[1] == 15 && a->size == 19, "%d, %d", a->start[1], a->size);
    kw_active_free(a);
    check_all(&w);
    twin_free(&w);
}

/* --- known counts --- */

static void check_counts(const kw_mesh *m, const int *functions, const int *cells)
{
    kw_active *a = kw_active_new(m);
    int sum = 0;

    CHECK(m->levels == 3, "%d levels", m->levels);
    for (int level = 0; level < 3; level++) {
        int here = a->start[level + 1] - a->start[level];

        CHECK(here == functions[level], "level %d: %d functions", level, here);
        CHECK(!cells || kw_mesh_active(m, level) == cells[level], "level %d: %lld cells",
              level, kw_mesh_active(m, level));
        sum += here;
    }
    CHECK(a->size == sum && kw_active_kraft(m) == sum, "%d, %lld", sum,
          kw_active_kraft(m));
    kw_active_free(a);
}

static void two_nested_squares(void)
{
    const int functions[] = {36, 3, 16}, cells[] = {12, 7, 36};
    twin w = twin_new(meshes_uniform(2, 2, 4), 2);

    refine_cube(&w, 0, 1, 3);
    refine_cube(&w, 1, 2, 5);
    check_counts(w.mesh, functions, cells);
    check_all(&w);
    twin_free(&w);
}

/* Figure 9: Omega^1 are the cells with i+j in {4,5}, Omega^2 those of level 1 in it with
   |i-j| <= 9. */
static void diagonal_of_figure_9(void)
{
    const int functions[] = {100, 8, 76};
    twin w = twin_new(meshes_uniform(2, 2, 8), 2);

    for (int level = 0; level < 2; level++)
        for (int i = 0; i < 8 << level; i++)
            for (int j = 0; j < 8 << level; j++) {
                const int low[D_MOST] = {i, j}, high[D_MOST] = {i + 1, j + 1};

                if (level == 0 ? i + j == 4 || i + j == 5 : abs(i - j) <= 9)
                    refine_both(&w, level, low, high);
            }
    check_counts(w.mesh, functions, NULL);
    for (int h = 0; h < 2; h++) {
        kw_bspline *s = kw_mesh_new_direction(w.mesh, h);

        CHECK(s->n == 27, "direction %d: %d functions", h, s->n);
        kw_bspline_free(s);
    }
    check_all(&w);
    twin_free(&w);
}

/* --- misuse --- */

static kw_active *small(void)
{
    return kw_active_new(kw_mesh_new(meshes_uniform(2, 2, 3)));
}

static void level_beyond(void)
{
    const int j[] = {0, 0};

    kw_active_status(small(), 1, j);
}

static void level_before(void)
{
    const int j[] = {0, 0};

    kw_active_find(small(), -1, j);
}

static void index_beyond(void)
{
    const int j[] = {0, 5};

    kw_active_find(small(), 0, j);
}

static void index_before(void)
{
    const int j[] = {-1, 0};

    kw_active_status(small(), 0, j);
}

static void function_beyond(void)
{
    int level, j[2];

    kw_active_function(small(), 25, &level, j);
}

static void function_before(void)
{
    int cell[2];

    kw_active_cell(small(), -1, cell);
}

static void too_many_local(void)
{
    kw_active_new(kw_mesh_new(meshes_uniform(3, 16, 1)));
}

static void misuse_aborts(void)
{
    test_aborts("level 1, not in 0 .. 0", level_beyond);
    test_aborts("level -1, not in 0 .. 0", level_before);
    test_aborts("index 5 of direction 1 on level 0, not in 0 .. 4", index_beyond);
    test_aborts("index -1 of direction 0 on level 0, not in 0 .. 4", index_before);
    test_aborts("function 25, not in 0 .. 24", function_beyond);
    test_aborts("function -1, not in 0 .. 24", function_before);
    test_aborts("4913 functions on a cell, more than 4096", too_many_local);
}

static void nothing_may_be_freed(void)
{
    kw_active_free(NULL);
}

int main(void)
{
    test_run("active: in one direction the selection is (14)", one_direction);
    test_run("active: in two directions the selection is (14)", two_directions);
    test_run("active: in three directions the selection is (14)", three_directions);
    test_run("active: with nothing refined all functions are active", nothing_refined);
    test_run("active: with everything refined those of the last level are",
             everything_refined);
    test_run("active: one cell may be refined again and again", one_cell);
    test_run("active: isolated cells bring no function", isolated_cells);
    test_run("active: at a corner of open knots one cell brings functions",
             corners_hold_functions);
    test_run("active: two nested squares have 36 + 3 + 16 functions on 12 + 7 + 36 cells",
             two_nested_squares);
    test_run("active: the diagonal of Figure 9 has 100 + 8 + 76 functions, and 27 x 27",
             diagonal_of_figure_9);
    test_run("active: levels and indices out of range abort", misuse_aborts);
    test_run("active: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
