/* Coefficients of hierarchical splines: on cells, on finer meshes, of polynomials, and the weights
   of HB-splines. The bounds are counts of roundings (meshes.h). */
#include "geometry.h"
#include "hiergeo.h"
#include "meshes.h"
#include "spline.h"

enum { MESHES = 25, PLACES = 30 };

static const kw_hier_kind KIND[] = {KW_HB, KW_THB};

typedef struct bases {
    twin w;
    kw_hier *b;
    int size;
} bases;

typedef void geo_property(const bases *q, kw_rng *r);

static bases bases_of(twin w)
{
    bases q = {w, kw_hier_new(w.mesh), 0};

    q.size = q.b->active->size;
    return q;
}

static void bases_free(bases *q)
{
    kw_hier_free(q->b);
    twin_free(&q->w);
}

static void over_meshes(geo_property *holds)
{
    static const int highest[] = {0, 4, 3, 2}, most[] = {0, 5, 4, 2},
                     finest[] = {0, 4, 3, 2};

    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(41, (uint64_t)D, (uint64_t)sample, 0);
            bases q = bases_of(random_twin(&r, D, highest[D], most[D], finest[D]));

            holds(&q, &r);
            bases_free(&q);
        }
}

static double *random_coefficients(kw_rng *r, int count)
{
    double *c = room_for(count, sizeof *c);

    for (int i = 0; i < count; i++)
        c[i] = test_random_in(r, -1, 1);
    return c;
}

/* The sum of all functions at x; of the THB-splines it is one. */
static double total(const kw_hier *b, kw_hier_kind kind, const double *x)
{
    double sum = 0, *one = room_for(b->active->size, sizeof *one);

    for (int i = 0; i < b->active->size; i++)
        one[i] = 1;
    geometry_at(b, kind, 1, one, NULL, x, &sum);
    free(one);
    return sum;
}

/* The local functions of a cell at x, the last direction fastest. */
static void local_values(const kw_mesh *m, int level, const int *cell, const double *x,
                         double *value)
{
    double factor[K];
    int size = 1;

    value[0] = 1;
    for (int h = 0; h < m->D; h++) {
        const kw_mesh_level *l = &m->level[level];
        int k = l->s[h]->d + 1;

        kw_bspline_derivatives_on(l->s[h], l->span[h][cell[h]], x[h], 0, factor);
        for (int a = size - 1; a >= 0; a--)
            for (int i = k - 1; i >= 0; i--)
                value[a * k + i] = value[a] * factor[i];
        size *= k;
    }
}

/* --- local coefficients --- */

/* At a place in an active cell the coefficients of the cell, and of the cells of finer levels that
   hold the place, give the geometry. N = 2. */
static void locals(const bases *q, kw_rng *r)
{
    enum { N = 2 };
    const kw_mesh *m = q->w.mesh;
    int local = q->b->active->local;
    double *c = random_coefficients(r, N * q->size), x[D_MOST] = {0}, want[N];
    double *coefficient = room_for(N * local + GUARD, sizeof *c);
    double *value = room_for(local, sizeof *c);

    for (int p = 0; p < PLACES; p++) {
        int at[D_MOST] = {0}, level;

        random_place(r, &q->w, x);
        level = kw_mesh_locate(m, x, at);
        for (int fine = level; fine < m->levels; fine++) {
            for (int h = 0; h < q->w.D && fine > level; h++) {
                const kw_mesh_level *l = &m->level[fine];

                at[h] = l->edge[h][kw_bspline_span(l->s[h], x[h])];
            }
            local_values(m, fine, at, x, value);
            for (int k = 0; k < 2; k++) {
                double size = total(q->b, KIND[k], x);
                double most = 2 * bound(truncated_roundings(m) + q->b->most, size);

                poison(coefficient, N * local);
                kw_hiergeo_local(q->b, KIND[k], N, c, fine, at, coefficient);
                CHECK(written(coefficient, N * local), "level %d", fine);
                geometry_at(q->b, KIND[k], N, c, NULL, x, want);
                for (int a = 0; a < N; a++) {
                    double got = 0;

                    for (int f = 0; f < local; f++)
                        got += coefficient[f * N + a] * value[f];
                    CHECK(fabs(got - want[a]) <= most, "level %d in %d: %.17g, %.17g",
                          fine, level, got, want[a]);
                }
            }
        }
    }
    free(c);
    free(coefficient);
    free(value);
}

static void local_coefficients(void)
{
    over_meshes(locals);
}

/* --- finer meshes --- */

/* What the cell of x sums up in absolute terms: of each direction the local functions' r-th
   derivatives (spline.h). */
static double terms_at(const kw_mesh *m, const int *order, const double *x)
{
    int cell[D_MOST] = {0}, level = kw_mesh_locate(m, x, cell);
    double terms = 1;

    for (int h = 0; h < m->D; h++) {
        const kw_mesh_level *l = &m->level[level];
        double size[K], sum = 0;

        derivative_size(l->s[h], l->span[h][cell[h]], x[h], order[h], size);
        for (int f = 0; f <= l->s[h]->d; f++)
            sum += size[f];
        terms *= sum;
    }
    return terms;
}

/* The geometry stays where it is, with all its derivatives, and functions that stay keep their
   coefficients to the bit. */
static void check_refined(const bases *q, const bases *fine, kw_rng *r, const double *c)
{
    const kw_mesh *m = fine->w.mesh;
    double *out = room_for(fine->size + GUARD, sizeof *out), x[D_MOST], a, b;

    poison(out, fine->size);
    kw_hiergeo_refine(q->b, fine->b, KW_THB, 1, c, out);
    CHECK(written(out, fine->size), "%d functions", fine->size);
    for (int p = 0; p < PLACES; p++) {
        int order[D_MOST] = {0}, n = 2 * truncated_roundings(m) + change_roundings(m);
        double most;

        random_place(r, &q->w, x);
        for (int h = 0; h < q->w.D && p % 2; h++)
            order[h] = kw_rng_below(r, 3);
        geometry_at(q->b, KW_THB, 1, c, order, x, &a);
        geometry_at(fine->b, KW_THB, 1, out, order, x, &b);
        most = bound(n + q->b->most + fine->b->most,
                     terms_at(q->w.mesh, order, x) + terms_at(m, order, x));
        CHECK(fabs(a - b) <= most, "D = %d, orders %d, %d, %d: %.17g, %.17g", q->w.D,
              order[0], order[1], order[2], a, b);
    }
    for (int i = 0; i < q->size; i++) {
        int level, j[D_MOST], stays;

        kw_active_function(q->b->active, i, &level, j);
        stays = kw_active_find(fine->b->active, level, j);
        CHECK(stays < 0 || out[stays] == c[i], "function %d: %.17g, %.17g", i, out[stays],
              c[i]);
    }
    free(out);
}

/* The same mesh with more boxes refined, on all levels. */
static void refined(const bases *q, kw_rng *r)
{
    twin more = q->w;
    bases fine;
    double *c = random_coefficients(r, q->size);

    more.mesh = kw_mesh_new_copy(q->w.mesh);
    more.depth = room_for(more.total, 1);
    memcpy(more.depth, q->w.depth, (size_t)more.total);
    refine_at_random(r, &more);
    fine = bases_of(more);
    check_refined(q, &fine, r, c);
    check_refined(q, q, r, c); /* to itself */
    kw_hier_free(fine.b);
    kw_mesh_free(more.mesh);
    free(more.depth);
    free(c);
}

static void refinement(void)
{
    over_meshes(refined);
}

/* HB coefficients on uniform meshes of degree 1 and 2, all of them small integers, at points
   that are multiples of 1/16: nothing is rounded, and we ask for equality. */
static void check_exactly_refined(const bases *q, const bases *fine, kw_rng *r)
{
    enum { N = 2, PARTS = 16 };
    double *c = room_for(N * q->size, sizeof *c), x[D_MOST], a[N], b[N];
    double *out = room_for(N * fine->size + GUARD, sizeof *out);

    for (int i = 0; i < N * q->size; i++)
        c[i] = kw_rng_below(r, 9) - 4;
    poison(out, N * fine->size);
    kw_hiergeo_refine(q->b, fine->b, KW_HB, N, c, out);
    CHECK(written(out, N * fine->size), "%d functions", fine->size);
    for (int p = 0; p < PLACES; p++) {
        for (int h = 0; h < q->w.D; h++)
            x[h] =
                kw_rng_below(r, PARTS * q->w.mesh->level[0].cells[h] + 1) / (double)PARTS;
        geometry_at(q->b, KW_HB, N, c, NULL, x, a);
        geometry_at(fine->b, KW_HB, N, out, NULL, x, b);
        for (int k = 0; k < N; k++)
            CHECK(a[k] == b[k], "D = %d: %.17g, %.17g", q->w.D, a[k], b[k]);
    }
    for (int i = 0; i < N * q->size && q == fine; i++)
        CHECK(out[i] == c[i], "number %d: %g, %g", i, out[i], c[i]);
    free(c);
    free(out);
}

static void refinement_of_hb(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(43, (uint64_t)D, (uint64_t)sample, 0);
            twin w = twin_new(meshes_uniform(D, 1 + sample % 2, 8 >> D), 4 - D), more;
            bases q, fine;

            refine_at_random(&r, &w);
            more = w;
            more.mesh = kw_mesh_new_copy(w.mesh);
            q = bases_of(w);
            refine_at_random(&r, &more);
            fine = bases_of(more);
            check_exactly_refined(&q, &fine, &r);
            check_exactly_refined(&q, &q, &r); /* to itself */
            kw_hier_free(fine.b);
            kw_mesh_free(more.mesh);
            bases_free(&q);
        }
}

/* Two cells of degree 1, everything refined on [0,2]: beta_1 = fine beta_2 + half of its
   neighbours. Where the first cell was refined before, the fine function in its middle stays,
   and its coefficient grows by what beta_1 brought. */
static void hb_coefficients_may_change(void)
{
    static const double c[] = {1, 0, 0, 0};
    twin w = twin_new(meshes_uniform(1, 1, 2), 1);
    kw_hier *b, *fine;
    double out[5];

    refine_cube(&w, 0, 0, 1);
    b = kw_hier_new(w.mesh);
    CHECK(b->active->size == 4 && b->active->start[1] == 2, "%d", b->active->size);
    refine_cube(&w, 0, 0, 2);
    fine = kw_hier_new(w.mesh);
    CHECK(fine->active->size == 5 && fine->active->start[1] == 0, "%d",
          fine->active->size);
    kw_hiergeo_refine(b, fine, KW_HB, 1, c, out); /* beta_1 of level 0 */
    for (int i = 0; i < 5; i++)
        CHECK(out[i] == (i == 2 ? 1 : i % 2 ? 0.5 : 0), "function %d: %g", i, out[i]);
    kw_hier_free(b);
    kw_hier_free(fine);
    twin_free(&w);
}

/* --- polynomials --- */

/* The product of all x_h^d_h: the coefficient of a B-spline of any level is the product of its
   inner knots, for that is the blossom. THB-splines keep the coefficients of their mothers. A
   coefficient costs at most d roundings a direction and is at most a power of the largest
   knot. */
static void monomial(const bases *q, kw_rng *r)
{
    const kw_mesh *m = q->w.mesh;
    double *c = room_for(q->size, sizeof *c), x[D_MOST], largest = 1, got;
    int degrees = 0;

    for (int i = 0; i < q->size; i++) {
        int level, j[D_MOST];

        kw_active_function(q->b->active, i, &level, j);
        c[i] = 1;
        for (int h = 0; h < q->w.D; h++)
            for (int k = 1; k <= m->level[0].s[h]->d; k++)
                c[i] *= m->level[level].s[h]->t[j[h] + k];
    }
    for (int h = 0; h < q->w.D; h++) {
        const kw_bspline *s = m->level[0].s[h];

        largest *= pow(fmax(fabs(s->t[0]), fabs(s->t[s->n + s->d])), s->d);
        degrees += s->d;
    }
    for (int p = 0; p < PLACES; p++) {
        double want = 1;

        random_place(r, &q->w, x);
        for (int h = 0; h < q->w.D; h++)
            for (int k = 0; k < m->level[0].s[h]->d; k++)
                want *= x[h];
        geometry_at(q->b, KW_THB, 1, c, NULL, x, &got);
        CHECK(fabs(got - want) <=
                  bound(truncated_roundings(m) + q->b->most + 2 * degrees, largest),
              "D = %d: %.17g, %.17g", q->w.D, got, want);
    }
    free(c);
}

static void polynomials(void)
{
    over_meshes(monomial);
}

/* --- weights --- */

/* A weight is one minus a coefficient that went through all changes of level, with a sum on
   each: an absolute error, since coefficients are at most one. */
static double weight_error(const kw_mesh *m)
{
    return bound(change_roundings(m) + 2 * m->levels, 1);
}

static void weights(const bases *q, kw_rng *r)
{
    const kw_mesh *m = q->w.mesh;
    double *w = room_for(q->size + GUARD, sizeof *w), x[D_MOST], sum = 0;
    double off = weight_error(m);

    poison(w, q->size);
    kw_hiergeo_weights(q->b, w);
    CHECK(written(w, q->size), "%d functions", q->size);
    for (int i = 0; i < q->size; i++) {
        CHECK(-off <= w[i] && w[i] <= 1, "function %d: %.17g", i, w[i]);
        CHECK(i >= q->b->active->start[1] || w[i] == 1, "level 0: %.17g", w[i]);
    }
    for (int p = 0; p < PLACES; p++) {
        random_place(r, &q->w, x);
        geometry_at(q->b, KW_HB, 1, w, NULL, x, &sum);
        CHECK(fabs(sum - 1) <= (off + bound(product_roundings(m) + q->b->most, 1)) *
                                   total(q->b, KW_HB, x),
              "D = %d: 1 + %g", q->w.D, sum - 1);
    }
    free(w);
}

static void weights_add_up(void)
{
    over_meshes(weights);
}

/* The two smallest meshes on which a weight vanishes: level 1 has `fine` functions, each in the
   middle of Omega^1, where the coarse ones add up to one already. All numbers are multiples
   of 1/4. */
static void check_zero_weights(int d, int cells, int low, int high, int fine)
{
    twin w = twin_new(meshes_uniform(1, d, cells), 1);
    double weight[16];
    bases q;

    refine_cube(&w, 0, low, high);
    q = bases_of(w);
    CHECK(q.size == cells + d + fine, "%d functions", q.size);
    kw_hiergeo_weights(q.b, weight);
    for (int i = 0; i < q.size; i++)
        CHECK(weight[i] == (i < cells + d), "degree %d, function %d: %g", d, i,
              weight[i]);
    bases_free(&q);
}

static void weights_may_vanish(void)
{
    check_zero_weights(1, 3, 1, 2, 1);
    check_zero_weights(2, 4, 1, 3, 2);
}

/* With nothing or everything refined all weights are one. */
static void weights_of_one_level(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int finest = 0; finest <= 1; finest++) {
            twin w = twin_new(meshes_uniform(D, 2, 2), finest);
            double *weight;
            bases q;

            refine_everything(&w);
            q = bases_of(w);
            weight = room_for(q.size, sizeof *weight);
            kw_hiergeo_weights(q.b, weight);
            for (int i = 0; i < q.size; i++)
                CHECK(weight[i] == 1, "function %d: %.17g", i, weight[i]);
            free(weight);
            bases_free(&q);
        }
}

/* --- misuse --- */

static kw_hier *small(int degree, int cells, int is_refined)
{
    twin w = twin_new(meshes_uniform(2, degree, cells), 1);

    refine_cube(&w, 0, 0, is_refined);
    return kw_hier_new(w.mesh);
}

static const double NONE[64] = {0};

static void coarser(void)
{
    double out[64];

    kw_hiergeo_refine(small(2, 3, 3), small(2, 3, 0), KW_THB, 1, NONE, out);
}

static void elsewhere(void)
{
    double out[64];

    kw_hiergeo_refine(small(2, 3, 3), small(2, 3, 1), KW_THB, 1, NONE, out);
}

static void other_space(void)
{
    double out[64];

    kw_hiergeo_refine(small(2, 3, 0), small(1, 3, 0), KW_THB, 1, NONE, out);
}

static void level_beyond(void)
{
    const int cell[] = {0, 0};
    double local[9];

    kw_hiergeo_local(small(2, 3, 0), KW_THB, 1, NONE, 1, cell, local);
}

static void no_coordinate(void)
{
    const int cell[] = {0, 0};
    double local[9];

    kw_hiergeo_local(small(2, 3, 0), KW_THB, 0, NONE, 0, cell, local);
}

static void misuse_aborts(void)
{
    test_aborts("2 levels and only 1", coarser);
    test_aborts("of level 0 is not refined in the finer mesh", elsewhere);
    test_aborts("different spaces of level 0 in direction 0", other_space);
    test_aborts("level 1, not in 0 .. 0", level_beyond);
    test_aborts("N = 0", no_coordinate);
}

int main(void)
{
    test_run("hiergeo: local coefficients give the geometry, on finer cells too",
             local_coefficients);
    test_run("hiergeo: refinement leaves the geometry where it is", refinement);
    test_run("hiergeo: refinement of HB-splines, without any rounding", refinement_of_hb);
    test_run("hiergeo: HB coefficients of functions that stay may change",
             hb_coefficients_may_change);
    test_run("hiergeo: polynomials are reproduced", polynomials);
    test_run("hiergeo: with the weights HB-splines add up to one", weights_add_up);
    test_run("hiergeo: weights vanish on two small meshes", weights_may_vanish);
    test_run("hiergeo: on one level all weights are one", weights_of_one_level);
    test_run("hiergeo: meshes that are not finer, and no level, abort", misuse_aborts);
    return test_end();
}
