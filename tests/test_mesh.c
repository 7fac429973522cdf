/* Meshes against the table of their finest cells (meshes.h). Every answer is a count, an index or
   a knot, so every comparison is exact. */
#include "mesh.h"
#include "meshes.h"
#include "spline.h"

enum { MESHES = 40, PLACES = 60 };

static const int ZERO[D_MOST] = {0};

/* --- what holds for every mesh --- */

/* The active cells tile the domain, each table cell once, and lie as deep as they should. */
static void check_tiles(const twin *w)
{
    char *covered = room_for(w->total, 1);

    for (int level = 0; level < w->mesh->levels; level++) {
        int cell[D_MOST] = {0};

        do {
            int depth = twin_depth(w, level, cell), low[D_MOST], high[D_MOST], at[D_MOST];

            CHECK(kw_mesh_inside(w->mesh, level, cell) == (depth >= level), "%d", level);
            CHECK(kw_mesh_refined(w->mesh, level, cell) == (depth > level), "%d", level);
            if (!kw_mesh_inside(w->mesh, level, cell) ||
                kw_mesh_refined(w->mesh, level, cell))
                continue;
            for (int h = 0; h < D_MOST; h++) {
                at[h] = low[h] = cell[h] << (w->finest - level);
                high[h] = (cell[h] + 1) << (w->finest - level);
            }
            do {
                CHECK(w->depth[twin_flat(w, at)] == level, "level %d", level);
                covered[twin_flat(w, at)]++;
            } while (step(w->D, low, high, at));
        } while (step(w->D, ZERO, w->mesh->level[level].cells, cell));
    }
    for (int c = 0; c < w->total; c++)
        CHECK(covered[c] == 1, "cell %d is covered %d times", c, covered[c]);
    free(covered);
}

/* kw_mesh_cells is sorted and has every cell of Omega^level; flat and multi are inverse;
   kw_mesh_active counts. */
static void check_lists(const twin *w)
{
    for (int level = 0; level < w->mesh->levels; level++) {
        long long count, next = 0, active = 0;
        uint64_t *list = kw_mesh_cells(w->mesh, level, &count), flat = 0;
        int cell[D_MOST] = {0}, back[D_MOST];

        do {
            CHECK(kw_mesh_flat(w->mesh, level, cell) == flat, "level %d", level);
            kw_mesh_multi(w->mesh, level, flat, back);
            CHECK(memcmp(back, cell, (size_t)w->D * sizeof *cell) == 0, "%d", back[0]);
            if (twin_depth(w, level, cell) >= level) {
                CHECK(next < count && list[next] == flat, "level %d", level);
                next++;
            }
            active += twin_depth(w, level, cell) == level;
            flat++;
        } while (step(w->D, ZERO, w->mesh->level[level].cells, cell));
        CHECK(next == count, "level %d: %lld of %lld", level, next, count);
        CHECK(kw_mesh_active(w->mesh, level) == active, "level %d: %lld, %lld", level,
              kw_mesh_active(w->mesh, level), active);
        free(list);
    }
}

/* The table cell of x: behind an inner edge, at the right end the last one. */
static int table_cell(const twin *w, int h, double x)
{
    int c = 0;

    while (c + 1 < w->cells[h] && w->edge[h][c + 1] <= x)
        c++;
    return c;
}

static void check_place(const twin *w, const double *x)
{
    int at[D_MOST], cell[D_MOST], level = kw_mesh_locate(w->mesh, x, cell);

    for (int h = 0; h < w->D; h++) {
        at[h] = table_cell(w, h, x[h]);
        CHECK(cell[h] == at[h] >> (w->finest - level), "direction %d of %.17g: %d, %d", h,
              x[h], cell[h], at[h]);
    }
    CHECK(level == w->depth[twin_flat(w, at)], "level %d, not %d", level,
          w->depth[twin_flat(w, at)]);
}

static void check_locate(const twin *w, kw_rng *r)
{
    double x[D_MOST];
    int corner = 0;

    for (int p = 0; p < PLACES; p++) {
        random_place(r, w, x);
        check_place(w, x);
    }
    for (; corner < 1 << w->D; corner++) {
        for (int h = 0; h < w->D; h++)
            x[h] = w->edge[h][(corner >> h & 1) * w->cells[h]];
        check_place(w, x);
    }
}

/* Does breakpoint c of direction h bound an active cell? Of an active cell of level m that holds
   a table cell beside it, the edges are the multiples of 2^(finest - m). */
static int bounds_a_cell(const twin *w, int h, int c)
{
    int at[D_MOST] = {0};

    do {
        int width = 1 << (w->finest - w->depth[twin_flat(w, at)]);

        if ((at[h] == c || at[h] + 1 == c) && c % width == 0)
            return 1;
    } while (step(w->D, ZERO, w->cells, at));
    return 0;
}

/* The knots of level 0 and the new breakpoints that bound a cell, each once. */
static void check_directions(const twin *w)
{
    for (int h = 0; h < w->D; h++) {
        const kw_bspline *s = w->mesh->level[0].s[h];
        kw_bspline *smallest = kw_mesh_new_direction(w->mesh, h);
        int added = 0;

        for (int c = 0; c <= w->cells[h]; c++) {
            double x = w->edge[h][c];
            int before = kw_bspline_multiplicity(s, x);
            int want = before > 0 ? before : bounds_a_cell(w, h, c);

            CHECK(kw_bspline_multiplicity(smallest, x) == want, "knot %g: %d, not %d", x,
                  kw_bspline_multiplicity(smallest, x), want);
            added += want - before;
        }
        CHECK(smallest->n == s->n + added && smallest->d == s->d, "%d, %d + %d",
              smallest->n, s->n, added);
        for (int i = 0; i <= s->d; i++) {
            double left = smallest->t[i], right = smallest->t[smallest->n + i];

            CHECK(left == s->t[i], "knot %d: %g", i, left);
            CHECK(right == s->t[s->n + i], "knot %d from the right: %g", i, right);
        }
        kw_bspline_free(smallest);
    }
}

static void check_all(const twin *w, kw_rng *r)
{
    check_tiles(w);
    check_lists(w);
    check_locate(w, r);
    check_directions(w);
}

/* --- over random meshes --- */

typedef void twin_property(twin *w, kw_rng *r);

static void over_meshes(twin_property *holds)
{
    static const int most[] = {0, 6, 4, 2}, finest[] = {0, 4, 3, 2};

    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(34, (uint64_t)D, (uint64_t)sample, 0);
            twin w = random_twin(&r, D, 4, most[D], finest[D]);

            holds(&w, &r);
            twin_free(&w);
        }
}

static void tiles(twin *w, kw_rng *r)
{
    (void)r;
    check_tiles(w);
}

static void lists(twin *w, kw_rng *r)
{
    (void)r;
    check_lists(w);
}

static void directions(twin *w, kw_rng *r)
{
    (void)r;
    check_directions(w);
}

static void locations(twin *w, kw_rng *r)
{
    check_locate(w, r);
}

static int same_mesh(const kw_mesh *a, const kw_mesh *b)
{
    int same = a->D == b->D && a->levels == b->levels;

    for (int level = 0; level < a->levels && same; level++) {
        long long here, there;
        uint64_t *p = kw_mesh_cells(a, level, &here),
                 *q = kw_mesh_cells(b, level, &there);

        same = here == there && memcmp(p, q, (size_t)here * sizeof *p) == 0;
        same = same && a->level[level].count == b->level[level].count;
        for (int h = 0; h < a->D && same; h++) {
            const kw_bspline *s = a->level[level].s[h], *t = b->level[level].s[h];

            same = s->d == t->d && s->n == t->n && same_bits(s->t, t->t, s->n + s->d + 1);
        }
        free(p);
        free(q);
    }
    return same;
}

/* Boxes that are refined already change nothing, and a copy goes its own way. */
static void again(twin *w, kw_rng *r)
{
    kw_mesh *copy = kw_mesh_new_copy(w->mesh), *before = kw_mesh_new_copy(w->mesh);

    CHECK(same_mesh(copy, w->mesh), "D = %d", w->D);
    for (int level = 0; level < w->mesh->levels - 1; level++)
        for (int i = 0; i < w->mesh->level[level].count; i++) {
            int low[D_MOST], high[D_MOST], done;

            kw_mesh_multi(w->mesh, level, w->mesh->level[level].list[i], low);
            for (int h = 0; h < w->D; h++)
                high[h] = low[h] + 1;
            done = kw_mesh_refine(w->mesh, level, low, high);
            CHECK(done == 0, "level %d: %d cells", level, done);
        }
    CHECK(same_mesh(before, w->mesh), "D = %d", w->D);
    kw_mesh_refine(copy, 0, ZERO, copy->level[0].cells);
    CHECK(same_mesh(before, w->mesh), "D = %d: the copy is no copy", w->D);
    check_all(w, r);
    kw_mesh_free(copy);
    kw_mesh_free(before);
}

/* Cell by cell in reverse order, one box for all: the same mesh. The box of a whole level is
   larger than the children of Omega^level, so the library walks through these instead. */
static void one_by_one(twin *w, kw_rng *r)
{
    kw_mesh *other = kw_mesh_new_copy(w->mesh);
    int level = w->mesh->levels - 1, done = 0;
    const int *cells = w->mesh->level[level].cells;
    int at[D_MOST] = {0}, all;

    (void)r;
    do {
        int low[D_MOST] = {0}, high[D_MOST] = {0};

        for (int h = 0; h < w->D; h++) {
            low[h] = cells[h] - 1 - at[h];
            high[h] = low[h] + 1;
        }
        done += kw_mesh_refine(other, level, low, high);
    } while (step(w->D, ZERO, cells, at));
    all = kw_mesh_refine(w->mesh, level, ZERO, cells);
    CHECK(all == done, "%d and %d cells", all, done);
    CHECK(same_mesh(w->mesh, other), "D = %d", w->D);
    kw_mesh_free(other);
}

static void tiling(void)
{
    over_meshes(tiles);
}

static void listing(void)
{
    over_meshes(lists);
}

static void locating(void)
{
    over_meshes(locations);
}

static void smallest_directions(void)
{
    over_meshes(directions);
}

static void repeating(void)
{
    over_meshes(again);
}

static void boxes_and_children(void)
{
    over_meshes(one_by_one);
}

/* --- degenerate meshes --- */

static void nothing_refined(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        kw_rng r = kw_rng_at(35, 0, (uint64_t)D, 0);
        twin w = twin_new(meshes_uniform(D, 2, 3), 1);

        refine_cube(&w, 0, 1, 1); /* an empty box */
        CHECK(w.mesh->levels == 1, "%d levels", w.mesh->levels);
        check_all(&w, &r);
        twin_free(&w);
    }
}

static void everything_refined(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        kw_rng r = kw_rng_at(35, 1, (uint64_t)D, 0);
        twin w = twin_new(meshes_uniform(D, 3, 2), 2);

        refine_everything(&w);
        CHECK(kw_mesh_active(w.mesh, 0) == 0 && kw_mesh_active(w.mesh, 1) == 0, "%d", D);
        CHECK(kw_mesh_active(w.mesh, 2) == w.total, "%d cells", w.total);
        check_all(&w, &r);
        twin_free(&w);
    }
}

/* One cell whose corner is refined; and a level that has no active cell between two that have. */
static void one_cell_and_a_hidden_level(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        kw_rng r = kw_rng_at(35, 2, (uint64_t)D, 0);
        twin corner = twin_new(meshes_uniform(D, 1, 1), 4);
        twin hidden = twin_new(meshes_uniform(D, 1, 3), 2);

        for (int level = 0; level < 4; level++)
            refine_cube(&corner, level, 0, 1);
        refine_cube(&hidden, 0, 1, 2);
        refine_cube(&hidden, 1, 2, 4);
        CHECK(kw_mesh_active(hidden.mesh, 1) == 0, "%lld",
              kw_mesh_active(hidden.mesh, 1));
        check_all(&corner, &r);
        check_all(&hidden, &r);
        twin_free(&corner);
        twin_free(&hidden);
    }
}

static void isolated_cells(void)
{
    kw_rng r = kw_rng_at(35, 3, 0, 0);
    twin w = twin_new(meshes_uniform(2, 2, 5), 3);

    for (int level = 0; level < 3; level++)
        for (int c = 0; c < 5 << level; c += 2)
            refine_cube(&w, level, c, c + 1);
    check_all(&w, &r);
    twin_free(&w);
}

int main(void)
{
    test_run("mesh: active cells tile the domain, each place once", tiling);
    test_run("mesh: lists of cells are sorted and complete", listing);
    test_run("mesh: a point lies in one active cell, at edges in the one behind",
             locating);
    test_run("mesh: the smallest tensor product has the knots that bound cells",
             smallest_directions);
    test_run("mesh: refining again does nothing, and copies are equal and separate",
             repeating);
    test_run("mesh: cell by cell and one large box give the same mesh",
             boxes_and_children);
    test_run("mesh: nothing refined is a mesh", nothing_refined);
    test_run("mesh: everything refined is a mesh", everything_refined);
    test_run("mesh: one cell is a mesh, and a level may have no active cell",
             one_cell_and_a_hidden_level);
    test_run("mesh: isolated cells are a mesh", isolated_cells);
    return test_end();
}
