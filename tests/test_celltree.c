/* The tree of cells: every point is led to the cell that holds it. */
#include "celltree.h"
#include "meshes.h"

enum { MESHES = 60, PLACES = 50, MANY = 150 };

/* Each leaf is an active cell, and each active cell one leaf; the search takes the same halves
   as kw_mesh_locate, level by level. */
static void check_places(const twin *w, kw_rng *r)
{
    kw_celltree *t = kw_celltree_new(w->mesh);
    long long active = 0;

    for (int level = 0; level < w->mesh->levels; level++)
        active += kw_mesh_active(w->mesh, level);
    CHECK(t->leaves == active, "%d leaves, %lld active cells", t->leaves, active);
    for (int p = 0; p < PLACES; p++) {
        double x[D_MOST];
        int want[D_MOST] = {0}, cell[D_MOST] = {0}, level = 0, node;

        random_place(r, w, x);
        node = kw_celltree_root(t, x, cell);
        while (t->node[node].child >= 0) {
            node = kw_celltree_below(t, node, x, cell);
            level++;
        }
        CHECK(kw_celltree_leaf(t, x) == -1 - t->node[node].child, "leaf %d",
              kw_celltree_leaf(t, x));
        CHECK(level == kw_mesh_locate(w->mesh, x, want), "level %d", level);
        for (int h = 0; h < w->D; h++)
            CHECK(cell[h] == want[h], "direction %d: cell %d, not %d", h, cell[h],
                  want[h]);
    }
    kw_celltree_free(t);
}

/* Many points are led where each of them is; one more than there are is not written. */
static void check_many(const twin *w, kw_rng *r)
{
    kw_celltree *t = kw_celltree_new(w->mesh);
    double *x = room_for(MANY * w->D, sizeof *x);
    int leaf[MANY + 1], count = kw_rng_below(r, MANY + 1);

    for (int p = 0; p < count; p++)
        random_place(r, w, x + p * w->D);
    leaf[count] = -7;
    kw_celltree_leaf_many(t, count, x, leaf);
    CHECK(leaf[count] == -7, "more than %d leaves", count);
    for (int p = 0; p < count; p++) {
        int cell[D_MOST] = {0}, node = kw_celltree_root(t, x + p * w->D, cell);

        while (t->node[node].child >= 0)
            node = kw_celltree_below(t, node, x + p * w->D, cell);
        CHECK(leaf[p] == -1 - t->node[node].child, "point %d of %d: leaf %d", p, count,
              leaf[p]);
    }
    free(x);
    kw_celltree_free(t);
}

static void places(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(44, (uint64_t)D, (uint64_t)sample, 0);
            twin w = random_twin(&r, D, 3, 4, 3);

            check_places(&w, &r);
            check_many(&w, &r);
            twin_free(&w);
        }
}

/* Different active cells have different leaves: the middles of all of them, counted. */
static void leaves_are_cells(void)
{
    kw_rng r = kw_rng_at(45, 0, 0, 0);
    twin w = random_twin(&r, 2, 2, 4, 3);
    kw_celltree *t = kw_celltree_new(w.mesh);
    int *met = room_for(t->leaves, sizeof *met), cell[D_MOST];

    for (int level = 0; level < w.mesh->levels; level++) {
        const kw_mesh_level *l = &w.mesh->level[level];
        long long count;
        uint64_t *list = kw_mesh_cells(w.mesh, level, &count);

        for (long long i = 0; i < count; i++) {
            double x[D_MOST];

            kw_mesh_multi(w.mesh, level, list[i], cell);
            for (int h = 0; h < w.D; h++) {
                const double *edge = l->s[h]->t + l->span[h][cell[h]];

                x[h] = (edge[0] + edge[1]) / 2;
            }
            if (!kw_mesh_refined(w.mesh, level, cell))
                met[kw_celltree_leaf(t, x)]++;
        }
        free(list);
    }
    for (int i = 0; i < t->leaves; i++)
        CHECK(met[i] == 1, "leaf %d is that of %d cells", i, met[i]);
    free(met);
    kw_celltree_free(t);
    twin_free(&w);
}

static void beyond(void)
{
    const double x[] = {1, 3.5};
    int cell[2];
    kw_tensor *g = meshes_uniform(2, 2, 3);

    kw_celltree_root(kw_celltree_new(kw_mesh_new(g)), x, cell);
}

static void negative_count(void)
{
    kw_tensor *g = meshes_uniform(2, 2, 3);

    kw_celltree_leaf_many(kw_celltree_new(kw_mesh_new(g)), -1, NULL, NULL);
}

static void misuse_aborts(void)
{
    kw_celltree_free(NULL);
    test_aborts("-1 points", negative_count);
    test_aborts("x = 3.5 outside the domain [0, 3]", beyond);
}

int main(void)
{
    test_run("celltree: a point is led to the cell that holds it", places);
    test_run("celltree: each active cell is one leaf", leaves_are_cells);
    test_run("celltree: a point outside aborts, and a negative count", misuse_aborts);
    return test_end();
}
