/* HB- and THB-splines by their properties on random meshes, knots of any size, degrees 0 .. 4. The
   bounds are counts of roundings (meshes.h). */
#include "hier.h"
#include "dense.h"
#include "meshes.h"
#include "spline.h"

enum { MESHES = 25, PLACES = 40 };

static const kw_hier_kind KIND[] = {KW_HB, KW_THB};

/* A mesh and its bases. */
typedef struct bases {
    twin w;
    kw_hier *b;
    int size;
} bases;

typedef void hier_property(const bases *q, kw_rng *r);

static bases bases_new(kw_rng *r, int D, int sample)
{
    static const int finest[] = {0, 4, 3, 1}, highest[] = {0, 4, 3, 2};
    kw_bspline *s[D_MOST] = {NULL};
    bases q = {0};

    for (int h = 0; h < D; h++)
        s[h] = sample % 2 ? test_random_space(r, highest[D])
                          : meshes_space(r, kw_rng_below(r, highest[D] + 1), 4);
    q.w = twin_new(meshes_product(D, s), D == 2 && sample % 2 ? 1 : finest[D]);
    refine_at_random(r, &q.w);
    q.b = kw_hier_new(q.w.mesh);
    q.size = q.b->active->size;
    return q;
}

static void bases_free(bases *q)
{
    kw_hier_free(q->b);
    twin_free(&q->w);
}

static void over_meshes(hier_property *holds)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(37, (uint64_t)D, (uint64_t)sample, 0);
            bases q = bases_new(&r, D, sample);

            holds(&q, &r);
            bases_free(&q);
        }
}

/* All functions at x: value[0..size-1], zero where the library lists none. Returns how many it
   lists. */
static int all_at(const bases *q, kw_hier_kind kind, const int *r, const double *x,
                  double *value)
{
    int *index = room_for(q->size, sizeof *index), count;
    double *listed = room_for(q->size + GUARD, sizeof *listed);

    poison(listed, q->size);
    count = kw_hier_at(q->b, kind, r, x, index, listed);
    CHECK(count <= q->b->most, "%d of %d", count, q->b->most);
    CHECK(isnan(listed[count]), "more than %d values", count);
    memset(value, 0, (size_t)q->size * sizeof *value);
    for (int i = 0; i < count; i++) {
        CHECK(i == 0 || index[i - 1] < index[i], "%d behind %d", index[i], index[i - 1]);
        CHECK(!isnan(listed[i]), "function %d", index[i]);
        value[index[i]] = listed[i];
    }
    free(index);
    free(listed);
    return count;
}

/* Place p of a mesh: first all corners, then random ones. */
static void place(const bases *q, kw_rng *r, int p, double *x)
{
    random_place(r, &q->w, x);
    for (int h = 0; h < q->w.D && p < 1 << q->w.D; h++)
        x[h] = q->w.edge[h][(p >> h & 1) * q->w.cells[h]];
}

/* --- values --- */

static void unity(const bases *q, kw_rng *r)
{
    double x[D_MOST], *value = room_for(q->size, sizeof *value);

    for (int p = 0; p < PLACES; p++) {
        double sum = 0;
        int count;

        place(q, r, p, x);
        count = all_at(q, KW_THB, NULL, x, value);
        for (int i = 0; i < q->size; i++) {
            CHECK(value[i] >= 0, "function %d: %g", i, value[i]);
            sum += value[i];
        }
        CHECK(fabs(sum - 1) <= bound(truncated_roundings(q->w.mesh) + count, 1),
              "D = %d: the sum is 1 + %g", q->w.D, sum - 1);
    }
    free(value);
}

/* Does a domain finer than the function's level meet its support? */
static int is_truncated(const twin *w, int level, const int *j)
{
    int low[D_MOST] = {0}, high[D_MOST] = {0}, at[D_MOST];

    twin_support(w, level, j, low, high);
    memcpy(at, low, sizeof at);
    do
        if (w->depth[twin_flat(w, at)] > level)
            return 1;
    while (step(w->D, low, high, at));
    return 0;
}

/* HB-splines are the products of their B-splines, and 0 <= tau <= beta; tau is beta where no finer
   domain meets the support. */
static void products(const bases *q, kw_rng *r)
{
    const kw_mesh *m = q->w.mesh;
    double x[D_MOST], *hb = room_for(q->size, sizeof *hb);
    double *thb = room_for(q->size, sizeof *thb);

    for (int p = 0; p < PLACES; p++) {
        place(q, r, p, x);
        all_at(q, KW_HB, NULL, x, hb);
        all_at(q, KW_THB, NULL, x, thb);
        for (int i = 0; i < q->size; i++) {
            double beta = 1, off;
            int level, j[D_MOST];

            kw_active_function(q->b->active, i, &level, j);
            for (int h = 0; h < q->w.D; h++)
                beta *= kw_bspline_one(m->level[level].s[h], j[h], 0, x[h]);
            off = bound(product_roundings(m), beta);
            CHECK(fabs(hb[i] - beta) <= 2 * off, "function %d: %.17g, %.17g", i, hb[i],
                  beta);
            off += bound(truncated_roundings(m), beta);
            CHECK(thb[i] <= beta + off, "function %d: %.17g > %.17g", i, thb[i], beta);
            CHECK(is_truncated(&q->w, level, j) || thb[i] >= beta - off,
                  "function %d: %.17g < %.17g", i, thb[i], beta);
        }
    }
    free(hb);
    free(thb);
}

/* The derivatives of a sum that is one are zero, and those of an order above the degree too. */
static void slopes(const bases *q, kw_rng *r)
{
    const kw_mesh *m = q->w.mesh;
    double x[D_MOST], *value = room_for(q->size, sizeof *value);

    for (int p = 0; p < PLACES; p++) {
        double sum = 0, terms = 1;
        int order[D_MOST] = {0}, cell[D_MOST] = {0}, level, count, above = 0;

        place(q, r, p, x);
        level = kw_mesh_locate(m, x, cell);
        for (int h = 0; h < q->w.D; h++) {
            const kw_mesh_level *l = &m->level[level];
            double size[K], along = 0;

            order[h] = kw_rng_below(r, l->s[h]->d + 2);
            above = above || order[h] > l->s[h]->d;
            derivative_size(l->s[h], l->span[h][cell[h]], x[h], order[h], size);
            for (int f = 0; f <= l->s[h]->d; f++)
                along += size[f];
            terms *= along;
        }
        count = all_at(q, KW_THB, order, x, value);
        for (int i = 0; i < q->size; i++) {
            sum += value[i];
            CHECK(!above || value[i] == 0, "function %d: %g", i, value[i]);
        }
        sum -= order[0] + order[1] + order[2] == 0;
        CHECK(fabs(sum) <= bound(truncated_roundings(m) + count, terms),
              "orders %d, %d, %d: %g of %g", order[0], order[1], order[2], sum, terms);
    }
    free(value);
}

/* One function is what the list says, to the bit. */
static void ones(const bases *q, kw_rng *r)
{
    double *value = room_for(q->size, sizeof *value), x[D_MOST];
    int order[D_MOST] = {0};

    for (int h = 0; h < q->w.D; h++)
        order[h] = kw_rng_below(r, 3);
    for (int p = 0; p < PLACES; p++) {
        place(q, r, p, x);
        for (int k = 0; k < 2; k++) {
            all_at(q, KIND[k], order, x, value);
            for (int i = 0; i < q->size; i++) {
                double one = kw_hier_one(q->b, KIND[k], i, order, x);

                CHECK(one == value[i], "function %d: %.17g, %.17g", i, one, value[i]);
            }
        }
    }
    free(value);
}

/* Many points have what each of them has, to the bit. */
static void together(const bases *q, kw_rng *r)
{
    const int most = q->b->most;
    double x[PLACES * D_MOST], *value = room_for(PLACES * most + GUARD, sizeof *value);
    double *alone = room_for(most, sizeof *alone);
    int *index = room_for(PLACES * most, sizeof *index), found[PLACES], order[D_MOST];
    int *alone_index = room_for(most, sizeof *alone_index);

    for (int h = 0; h < q->w.D; h++)
        order[h] = kw_rng_below(r, 2);
    for (int p = 0; p < PLACES; p++)
        place(q, r, p, x + p * q->w.D);
    for (int k = 0; k < 2; k++) {
        poison(value, PLACES * most);
        kw_hier_at_many(q->b, KIND[k], order, PLACES, x, found, index, value);
        CHECK(isnan(value[PLACES * most]), "more than %d rows", PLACES);
        for (int p = 0; p < PLACES; p++) {
            int count =
                kw_hier_at(q->b, KIND[k], order, x + p * q->w.D, alone_index, alone);

            CHECK(found[p] == count, "%d functions, not %d", found[p], count);
            CHECK(same_bits(alone, value + p * most, count), "point %d", p);
            CHECK(memcmp(alone_index, index + p * most, (size_t)count * sizeof *index) ==
                      0,
                  "point %d", p);
        }
    }
    free(value);
    free(alone);
    free(index);
    free(alone_index);
}

static void unity_and_signs(void)
{
    over_meshes(unity);
}

static void products_and_order(void)
{
    over_meshes(products);
}

static void derivatives_of_one(void)
{
    over_meshes(slopes);
}

static void one_function(void)
{
    over_meshes(ones);
}

static void many_points(void)
{
    over_meshes(together);
}

/* --- spans --- */

/* All functions of both kinds at (d_h+1)^D points of each cell of the table: what vanishes there
   vanishes on the cell. Row: a point; columns: HB, then THB. */
static double *collocation(const bases *q, int *rows)
{
    const twin *w = &q->w;
    int low[D_MOST] = {0}, many[D_MOST] = {0}, at[D_MOST] = {0}, row = 0;
    double *A;

    *rows = w->total * local_functions(w->mesh);
    A = room_for(*rows * 2 * q->size, sizeof *A);
    for (int h = 0; h < w->D; h++)
        many[h] = w->cells[h] * (w->mesh->level[0].s[h]->d + 1);
    do {
        double x[D_MOST];

        for (int h = 0; h < w->D; h++) {
            int k = w->mesh->level[0].s[h]->d + 1;
            const double *e = w->edge[h] + at[h] / k;

            x[h] = e[0] + (e[1] - e[0]) * (at[h] % k + 0.5) / k;
        }
        all_at(q, KW_HB, NULL, x, A + (2 * row) * q->size);
        all_at(q, KW_THB, NULL, x, A + (2 * row + 1) * q->size);
        row++;
    } while (step(w->D, low, many, at));
    return A;
}

static int rank_of(int rows, int columns, int stride, const double *A)
{
    double *copy = room_for(rows * columns, sizeof *copy), gap;
    int rank;

    for (int i = 0; i < rows; i++)
        memcpy(copy + i * columns, A + i * stride, (size_t)columns * sizeof *A);
    rank = kw_dense_rank(rows, columns, copy, &gap);
    CHECK(gap > 1000, "the rank %d hangs on the tolerance: a gap of %g", rank, gap);
    free(copy);
    return rank;
}

static void spans_agree(void)
{
    for (int D = 1; D <= 2; D++)
        for (int sample = 0; sample < 8; sample++) {
            kw_rng r = kw_rng_at(38, (uint64_t)D, (uint64_t)sample, 0);
            bases q = {.w = random_twin(&r, D, D == 1 ? 3 : 2, 2, 3 - D)};
            double *A;
            int rows, hb, thb, both;

            q.b = kw_hier_new(q.w.mesh);
            q.size = q.b->active->size;
            A = collocation(&q, &rows);
            hb = rank_of(rows, q.size, 2 * q.size, A);
            thb = rank_of(rows, q.size, 2 * q.size, A + q.size);
            both = rank_of(rows, 2 * q.size, 2 * q.size, A);
            CHECK(hb == q.size && thb == q.size && both == q.size,
                  "%d functions: ranks %d, %d, together %d", q.size, hb, thb, both);
            free(A);
            bases_free(&q);
        }
}

/* --- degenerate meshes --- */

/* With everything refined `finest` times the bases are, to the bit, that of the tensor product. */
static void is_tensor_product(int D, int d, int finest)
{
    kw_rng r = kw_rng_at(39, (uint64_t)D, (uint64_t)d, (uint64_t)finest);
    kw_tensor *g = meshes_uniform(D, d, 2);
    bases q = {.w = twin_new(meshes_uniform(D, d, 2), finest)};
    double x[D_MOST], *value, *want;

    refine_everything(&q.w);
    q.b = kw_hier_new(q.w.mesh);
    q.size = q.b->active->size;
    for (int level = 0; level < finest; level++) {
        kw_tensor *fine = kw_tensor_new_dyadic(g);

        kw_tensor_free(g);
        g = fine;
    }
    value = room_for(q.size, sizeof *value);
    want = room_for(kw_tensor_local(g), sizeof *want);
    CHECK(q.size == kw_tensor_dimension(g), "%d functions", q.size);
    for (int p = 0; p < PLACES; p++) {
        int first[D_MOST] = {0}, high[D_MOST], j[D_MOST];

        place(&q, &r, p, x);
        kw_tensor_basis(g, NULL, x, first, want);
        for (int k = 0; k < 2; k++) {
            int f = 0;

            CHECK(all_at(&q, KIND[k], NULL, x, value) == kw_tensor_local(g), "D = %d", D);
            for (int h = 0; h < D_MOST; h++) {
                high[h] = first[h] + d + 1;
                j[h] = first[h];
            }
            do {
                double got = value[kw_tensor_flat(g, j)];

                CHECK(got == want[f], "%.17g, not %.17g", got, want[f]);
                f++;
            } while (step(D, first, high, j));
        }
    }
    free(value);
    free(want);
    kw_tensor_free(g);
    bases_free(&q);
}

static void tensor_products(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int d = 0; d <= 3; d++)
            for (int finest = 0; finest <= (D == 3 ? 1 : 2); finest++)
                is_tensor_product(D, d, finest);
}

int main(void)
{
    test_run("hier: THB-splines are not negative and add up to one, also at corners",
             unity_and_signs);
    test_run("hier: HB-splines are products, and truncation makes nothing larger",
             products_and_order);
    test_run("hier: derivatives of all orders add up to zero", derivatives_of_one);
    test_run("hier: one function is what the list says", one_function);
    test_run("hier: many points have what each of them has", many_points);
    test_run("hier: both bases are independent and span the same space", spans_agree);
    test_run("hier: refined nowhere or everywhere they are the tensor product",
             tensor_products);
    return test_end();
}
