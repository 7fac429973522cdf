/* Geometries cell by cell: against the sum over all functions, and what a caller may not do. */
#include "geometry.h"
#include "hierpieces.h"
#include "meshes.h"
#include "spline.h"
#include <math.h>

enum { MESHES = 25, PLACES = 70 /* more than are taken at a time */, N_MOST = 3 };

static const kw_hier_kind KIND[] = {KW_HB, KW_THB};

static double *random_coefficients(kw_rng *r, int count)
{
    double *c = room_for(count, sizeof *c);

    for (int i = 0; i < count; i++)
        c[i] = test_random_in(r, -1, 1);
    return c;
}

/* A bound of the sum of the absolute values of all terms at x: the sum over the levels. */
static double terms_at(const kw_hier *b, const int *order, const double *x)
{
    const kw_mesh *m = b->active->mesh;
    double sum = 0;

    for (int level = 0; level < m->levels; level++) {
        double product = 1;

        for (int h = 0; h < m->D; h++) {
            const kw_bspline *s = m->level[level].s[h];
            double size[K], factor = 0;

            derivative_size(s, kw_bspline_span(s, x[h]), x[h], order[h], size);
            for (int i = 0; i <= s->d; i++)
                factor += size[i];
            product *= factor;
        }
        sum += product;
    }
    return sum;
}

static void compare(const twin *w, kw_rng *r)
{
    kw_hier *b = kw_hier_new(w->mesh);
    int N = 1 + kw_rng_below(r, N_MOST), order[D_MOST] = {0};
    double *c = random_coefficients(r, N * b->active->size);
    double x[PLACES * D_MOST], many[N_MOST * PLACES + GUARD];

    for (int h = 0; h < w->D; h++)
        order[h] = kw_rng_below(r, 3);
    for (int p = 0; p < PLACES; p++)
        random_place(r, w, x + p * w->D);
    for (int k = 0; k < 2; k++) {
        kw_hierpieces *pieces = kw_hierpieces_new(b, KIND[k], N, c);

        kw_hierpieces_point_many(pieces, order, 0, x, NULL); /* no points: no result */
        poison(many, N * PLACES);
        kw_hierpieces_point_many(pieces, order, PLACES, x, many);
        CHECK(written(many, N * PLACES), "D = %d", w->D);
        for (int p = 0; p < PLACES; p++) {
            const double *at = x + p * w->D;
            double alone[N_MOST + GUARD], want[N_MOST];
            double most =
                2 * bound(truncated_roundings(w->mesh) + b->most, terms_at(b, order, at));

            poison(alone, N);
            kw_hierpieces_point(pieces, order, at, alone);
            CHECK(written(alone, N) && same_bits(alone, many + N * p, N), "%d", p);
            geometry_at(b, KIND[k], N, c, order, at, want);
            for (int a = 0; a < N; a++)
                CHECK(fabs(alone[a] - want[a]) <= most, "%.17g, %.17g", alone[a],
                      want[a]);
        }
        kw_hierpieces_free(pieces);
    }
    free(c);
    kw_hier_free(b);
}

static void random_meshes(void)
{
    static const int highest[] = {0, 4, 3, 2}, most[] = {0, 5, 4, 2},
                     finest[] = {0, 4, 3, 2};

    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(43, (uint64_t)D, (uint64_t)sample, 0);
            twin w = random_twin(&r, D, highest[D], most[D], finest[D]);

            compare(&w, &r);
            twin_free(&w);
        }
}

/* --- misuse --- */

static kw_hier *small(void)
{
    return kw_hier_new(kw_mesh_new(meshes_uniform(2, 2, 3)));
}

static const double ZERO[64] = {0};

static void no_coordinate(void)
{
    kw_hierpieces_new(small(), KW_THB, 0, ZERO);
}

static void beyond(void)
{
    const double at[] = {1, 3.5};
    double point[1];

    kw_hierpieces_point(kw_hierpieces_new(small(), KW_HB, 1, ZERO), NULL, at, point);
}

static void negative_count(void)
{
    kw_hierpieces_point_many(kw_hierpieces_new(small(), KW_HB, 1, ZERO), NULL, -1, ZERO,
                             NULL);
}

static void misuse_aborts(void)
{
    kw_hierpieces_free(NULL);
    test_aborts("N = 0", no_coordinate);
    test_aborts("x = 3.5 outside the domain [0, 3]", beyond);
    test_aborts("-1 points", negative_count);
}

int main(void)
{
    test_run("hierpieces: the sum over all functions, on random meshes", random_meshes);
    test_run("hierpieces: misuse aborts with the value", misuse_aborts);
    return test_end();
}
