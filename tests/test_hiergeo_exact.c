/* The representation of a THB-spline on one level against whole numbers (exact.h): the level, every
   coefficient, and that the B-splines of the box are the function. */
#include "exact.h"
#include "hiergeo.h"
#include "spline.h"

enum { MESHES = 20, PLACES = 8 };

/* One function of a mesh, as the library represents it. */
typedef struct shown {
    int level, first[D_MOST], count[D_MOST];
    double *c;
} shown;

/* Where B-spline j stands in the box, or -1. */
static int place_in_box(int D, const shown *s, const int *j)
{
    int place = 0;

    for (int h = 0; h < D; h++) {
        int at = j[h] - s->first[h];

        if (at < 0 || at >= s->count[h])
            return -1;
        place = place * s->count[h] + at;
    }
    return place;
}

/* The level is the last one on which Definition 5 drops something, and the coefficients there are
   the exact ones: changes of level, and three roundings for the exact fraction. */
static void check_coefficients(const exact *e, int i, const shown *s)
{
    const int zero[D_MOST] = {0}, *mother = e->mother[i];
    int cut, n[D_MOST] = {0}, j[D_MOST] = {0}, at = 0, unused;
    wide scale = e->scale[mother[0]] / e->scale[s->level];
    wide *c = exact_thb(e, mother, e->levels - 1, &cut);

    CHECK(s->level == cut, "function %d: level %d, not %d", i, s->level, cut);
    free(c);
    c = exact_thb(e, mother, s->level, &unused);
    functions_of(e->w, s->level, n);
    do {
        double want = (double)c[at++] / (double)scale, got = 0;
        int place = place_in_box(e->w->D, s, j);

        if (place >= 0)
            got = s->c[place];
        CHECK(fabs(got - want) <= bound(change_roundings(e->w->mesh) + 3, want),
              "function %d, level %d: %.17g, not %.17g", i, s->level, got, want);
    } while (step(e->w->D, zero, n, j));
    free(c);
}

/* The box lies in the grid of its level. */
static void check_box(const twin *w, int i, const shown *s)
{
    for (int h = 0; h < w->D; h++)
        CHECK(s->count[h] >= 1 && s->first[h] >= 0 &&
                  s->first[h] + s->count[h] <= w->mesh->level[s->level].s[h]->n,
              "function %d: %d from %d in direction %d", i, s->count[h], s->first[h], h);
}

/* Evaluated by univariate functions the box is what kw_hier_one gives. */
static void check_places(const exact *e, const kw_hier *b, int i, const shown *s,
                         kw_rng *r)
{
    const int zero[D_MOST] = {0};
    const kw_mesh *m = e->w->mesh;

    for (int p = 0; p < PLACES; p++) {
        double x[D_MOST] = {0}, sum = 0, got;
        int at[D_MOST] = {0}, f = 0;

        random_place(r, e->w, x);
        do {
            double product = s->c[f++];

            for (int h = 0; h < m->D && product != 0; h++)
                product *=
                    kw_bspline_one(m->level[s->level].s[h], s->first[h] + at[h], 0, x[h]);
            sum += product;
        } while (step(m->D, zero, s->count, at));
        got = kw_hier_one(b, KW_THB, i, NULL, x);
        CHECK(fabs(got - sum) <= bound(2 * truncated_roundings(m), got + sum),
              "function %d: %.17g, not %.17g", i, got, sum);
    }
}

static void over_meshes(int D, int highest, int most, int finest)
{
    for (int sample = 0; sample < MESHES; sample++) {
        kw_rng r = kw_rng_at(42, (uint64_t)D, (uint64_t)sample, 0);
        twin w = random_twin(&r, D, highest, most, finest);
        exact *e = exact_new(&w);
        kw_hier *b = kw_hier_new(w.mesh);

        CHECK(b->active->size == e->size, "%d, %d", b->active->size, e->size);
        for (int i = 0; i < e->size; i++) {
            shown s;

            s.level = kw_hiergeo_new_representation(b, i, s.first, s.count, &s.c);
            check_box(&w, i, &s);
            check_coefficients(e, i, &s);
            check_places(e, b, i, &s, &r);
            free(s.c);
        }
        kw_hier_free(b);
        exact_free(e);
        twin_free(&w);
    }
}

static void one_direction(void)
{
    over_meshes(1, 4, 5, 3);
}

static void two_directions(void)
{
    over_meshes(2, 3, 2, 2);
}

static void three_directions(void)
{
    over_meshes(3, 2, 2, 1);
}

/* With nothing refined a function is its own representation. */
static void one_function(void)
{
    for (int D = 1; D <= D_MOST; D++) {
        twin w = twin_new(meshes_uniform(D, 2, 2), 0);
        kw_hier *b = kw_hier_new(w.mesh);

        for (int i = 0; i < b->active->size; i++) {
            int level, j[D_MOST], first[D_MOST], count[D_MOST];
            double *c;
            int on = kw_hiergeo_new_representation(b, i, first, count, &c);

            kw_active_function(b->active, i, &level, j);
            CHECK(on == level && c[0] == 1, "level %d, %g", on, c[0]);
            for (int h = 0; h < D; h++)
                CHECK(first[h] == j[h] && count[h] == 1, "%d, %d", first[h], count[h]);
            free(c);
        }
        kw_hier_free(b);
        twin_free(&w);
    }
}

/* The index of beta_{i,j} of level 0. */
static int at_level_0(const kw_hier *b, int i, int j)
{
    const int both[] = {i, j};

    return kw_active_find(b->active, 0, both);
}

/* Eight by eight cells of degree 2, the cells on the diagonal refined twelve times. In no cell is
   room for a function, but in the corners: from (5,5) nothing is cut, and from (1,1), with the
   knots 0,0,1,2, the corner's share of level 1 alone. A dense box of the last level would have
   2^28 coefficients. */
static void deep_and_narrow(void)
{
    static const double line[] = {1.0 / 2, 3.0 / 4, 1.0 / 4};
    kw_tensor *g = meshes_uniform(2, 2, 8);
    kw_mesh *m = kw_mesh_new(g);
    kw_hier *b;
    int first[2], count[2], level;
    double *c;

    for (int l = 0; l < 12; l++)
        for (int i = 0; i < 8 << l; i++) {
            const int low[] = {i, i}, high[] = {i + 1, i + 1};

            kw_mesh_refine(m, l, low, high);
        }
    b = kw_hier_new(m);
    level = kw_hiergeo_new_representation(b, at_level_0(b, 5, 5), first, count, &c);
    CHECK(level == 0 && count[0] == 1 && count[1] == 1 && c[0] == 1, "level %d: %d x %d",
          level, count[0], count[1]);
    free(c);
    level = kw_hiergeo_new_representation(b, at_level_0(b, 1, 1), first, count, &c);
    CHECK(level == 1 && count[0] == 3 && count[1] == 3, "level %d: %d x %d", level,
          count[0], count[1]);
    for (int i = 0; i < 9; i++)
        CHECK(c[i] == (i > 0 ? line[i / 3] * line[i % 3] : 0), "%d: %g", i, c[i]);
    free(c);
    kw_hier_free(b);
    kw_mesh_free(m);
    kw_tensor_free(g);
}

static void function_beyond(void)
{
    int first[2], count[2];
    double *c;

    kw_hiergeo_new_representation(kw_hier_new(kw_mesh_new(meshes_uniform(2, 2, 3))), 25,
                                  first, count, &c);
}

static void misuse_aborts(void)
{
    test_aborts("function 25, not in 0 .. 24", function_beyond);
}

int main(void)
{
    test_run("hiergeo: in one direction representations are exact", one_direction);
    test_run("hiergeo: in two directions representations are exact", two_directions);
    test_run("hiergeo: in three directions representations are exact", three_directions);
    test_run("hiergeo: what is not truncated represents itself", one_function);
    test_run("hiergeo: on a deep and narrow mesh representations stay small",
             deep_and_narrow);
    test_run("hiergeo: a function that is none aborts", misuse_aborts);
    return test_end();
}
