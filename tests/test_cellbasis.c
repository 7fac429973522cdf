/* The local functions of a cell: those of the tensor product of its level, to the bit. */
#include "cellbasis.h"
#include "meshes.h"
#include "spline.h"

enum { MESHES = 60, PLACES = 20, FUNCTIONS = 256 };

/* At random places, on the level of the active cell, with random orders. */
static void compare(const twin *w, kw_rng *r)
{
    const kw_mesh *m = w->mesh;
    double got[FUNCTIONS + GUARD], want[FUNCTIONS];

    for (int p = 0; p < PLACES; p++) {
        int cell[D_MOST], span[D_MOST] = {0}, order[D_MOST], first[D_MOST];
        int level, local = local_functions(m);
        const kw_bspline *s[D_MOST] = {NULL};
        kw_tensor *g;
        double x[D_MOST];

        random_place(r, w, x);
        level = kw_mesh_locate(m, x, cell);
        for (int h = 0; h < w->D; h++) {
            s[h] = m->level[level].s[h];
            span[h] = m->level[level].span[h][cell[h]];
            order[h] = kw_rng_below(r, s[h]->d + 2);
        }
        g = kw_tensor_new(w->D, s);
        for (int derived = 0; derived < 2; derived++) {
            const int *orders = derived ? order : NULL;

            poison(got, local);
            kw_cellbasis_at(m, level, span, orders, x, got);
            kw_tensor_basis(g, orders, x, first, want);
            CHECK(written(got, local) && same_bits(got, want, local),
                  "D = %d, level %d, derivatives: %d", w->D, level, derived);
        }
        kw_tensor_free(g);
    }
}

static void on_random_meshes(void)
{
    static const int highest[] = {0, 5, 4, 3}, most[] = {0, 6, 4, 2};

    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(46, (uint64_t)D, (uint64_t)sample, 0);
            twin w = random_twin(&r, D, highest[D], most[D], 4 - D);

            compare(&w, &r);
            twin_free(&w);
        }
}

static void negative_order(void)
{
    const int span[] = {2, 2}, order[] = {0, -1};
    const double x[] = {0.5, 0.5};
    double value[9];

    kw_cellbasis_at(kw_mesh_new(meshes_uniform(2, 2, 3)), 0, span, order, x, value);
}

static void misuse_aborts(void)
{
    test_aborts("derivative -1", negative_order);
}

int main(void)
{
    test_run("cellbasis: the tensor product of the cell's level, to the bit",
             on_random_meshes);
    test_run("cellbasis: a negative order aborts", misuse_aborts);
    return test_end();
}
