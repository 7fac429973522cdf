/* HB- and THB-splines against whole numbers, straight from Definitions 4 and 5 (exact.h): random
   meshes in 1, 2, 3 directions, degrees 1 .. 4, knots at multiples of 1/2 of every
   multiplicity, open or not; points at edges, middles of cells and ends.

   Bounds are those of meshes.h. Knots and points are exact in a double; the exact number costs
   three roundings. For a value the sum of the absolute values of the terms is the value itself:
   in particular an exact zero must come out as zero. */
#include "exact.h"
#include "hier.h"
#include "spline.h"

enum { POINTS = 40 };

/* What the random meshes of a number of directions are like. */
typedef struct family {
    int D, highest, most, finest, meshes;
} family;

static const family FAMILY[] = {
    {1, 4, 4, 3, 80}, {2, 2, 3, 2, 15}, {2, 4, 2, 2, 12},
    {3, 1, 2, 2, 4},  {3, 2, 2, 1, 8},  {3, 4, 1, 1, 6},
};

enum { FAMILIES = sizeof FAMILY / sizeof *FAMILY };

/* One mesh in both ways. */
typedef struct pair {
    twin w;
    exact *e;
    kw_hier *b;
} pair;

/* --- points --- */

/* A multiple of half the width of the table's cell. */
static rational coordinate(kw_rng *r, const twin *w, int h)
{
    const double *e = w->edge[h];
    int kind = kw_rng_below(r, 8), last = w->cells[h], parts = 8 << w->finest;
    int cell = kw_rng_below(r, last);
    double x = (e[cell] + e[cell + 1]) / 2;

    if (kind < 4)
        x = e[kind == 0 ? 0 : kind == 1 ? last : cell];
    return rational_new((long long)(x * parts), parts);
}

/* --- comparison --- */

static int roundings(const exact *e, kw_hier_kind kind)
{
    const kw_mesh *m = e->w->mesh;

    return 3 + (kind == KW_HB ? product_roundings(m) : truncated_roundings(m));
}

/* The exact value of function i, and the sum of the absolute values of its terms. */
static double wanted(const exact *e, const exact_point *p, kw_hier_kind kind, int i)
{
    wide scale, sum;

    if (kind == KW_HB)
        return exact_hb(e, p, i);
    sum = exact_tau(e, p, i, &scale);
    return (double)sum / (double)scale;
}

/* All functions at one point: the library's list holds every one that is not zero, in order,
   and at most b->most of them. */
static void compare(const pair *q, kw_hier_kind kind, const int *r, const double *x,
                    const exact_point *p, const exact_point *terms)
{
    int size = q->e->size, *index = room_for(size, sizeof *index), count;
    double *value = room_for(size + GUARD, sizeof *value), largest = 0;

    poison(value, size);
    count = kw_hier_at(q->b, kind, r, x, index, value);
    CHECK(count <= q->b->most && isnan(value[count]), "%d of %d", count, q->b->most);
    for (int i = 0, at = 0; i < size; i++) {
        double want = wanted(q->e, p, kind, i), got = 0;
        double most = bound(roundings(q->e, kind), wanted(q->e, terms, kind, i));

        if (at < count && index[at] == i)
            got = value[at++];
        CHECK(fabs(got - want) <= most, "D = %d, kind %d, function %d: %.17g, %.17g (%g)",
              q->w.D, kind, i, got, want, most);
        CHECK(i + 1 < size || at == count, "%d of %d functions met", at, count);
        largest = fmax(largest, fabs(got - want));
    }
    CHECK(r || largest <= 1e-14, "%g", largest); /* what lib promises of values */
    free(index);
    free(value);
}

static void compare_at_points(kw_rng *r, const pair *q, int derivatives)
{
    exact_point *p = room_for(2, sizeof *p);

    for (int point = 0; point < POINTS; point++) {
        rational at[D_MOST] = {{0, 1}, {0, 1}, {0, 1}};
        int order[D_MOST] = {0};
        double x[D_MOST] = {0};

        for (int h = 0; h < q->w.D; h++) {
            at[h] = coordinate(r, &q->w, h);
            x[h] = rational_double(at[h]);
            order[h] = derivatives ? kw_rng_below(r, q->e->line[0][h].d + 2) : 0;
        }
        exact_at(q->e, order, at, -1, &p[0]);
        exact_at(q->e, order, at, 1, &p[1]);
        compare(q, KW_HB, derivatives ? order : NULL, x, &p[0], &p[1]);
        compare(q, KW_THB, derivatives ? order : NULL, x, &p[0], &p[1]);
    }
    free(p);
}

/* --- over the meshes --- */

typedef void mesh_property(kw_rng *r, const pair *q);

static void over_meshes(int D, mesh_property *holds)
{
    for (int f = 0; f < FAMILIES; f++)
        for (int sample = 0; sample < FAMILY[f].meshes; sample++) {
            const family *like = &FAMILY[f];
            kw_rng r = kw_rng_at(31, (uint64_t)f, (uint64_t)sample, 0);
            pair q;

            if (like->D != D)
                continue;
            q.w = random_twin(&r, D, like->highest, like->most, like->finest);
            q.e = exact_new(&q.w);
            q.b = kw_hier_new(q.w.mesh);
            CHECK(q.b->active->size == q.e->size, "%d, %d", q.b->active->size, q.e->size);
            holds(&r, &q);
            kw_hier_free(q.b);
            exact_free(q.e);
            twin_free(&q.w);
        }
}

static void values(kw_rng *r, const pair *q)
{
    compare_at_points(r, q, 0);
}

static void derivatives(kw_rng *r, const pair *q)
{
    compare_at_points(r, q, 1);
}

/* The exact functions themselves: no coefficient is negative, and the THB-splines add up to
   one without any rounding. */
static void exact_sum_is_one(kw_rng *r, const pair *q)
{
    const exact *e = q->e;
    int n[D_MOST], total = functions_of(&q->w, e->levels - 1, n);

    (void)r;
    for (int j = 0; j < total; j++) {
        wide sum = 0;

        for (int i = 0; i < e->size; i++) {
            wide to_common = e->scale[0] / e->scale[e->mother[i][0]];

            CHECK(e->c[i][j] >= 0, "%d, %d: %g", i, j, (double)e->c[i][j]);
            sum = wide_add(sum, wide_mul(to_common, e->c[i][j]));
        }
        CHECK(sum == e->scale[0], "coefficient %d: %g of %g", j, (double)sum,
              (double)e->scale[0]);
    }
}

/* Knots and numbers of functions of all levels are those that insertion gives. */
static void spaces_agree(kw_rng *r, const pair *q)
{
    (void)r;
    for (int level = 0; level < q->e->levels; level++)
        for (int h = 0; h < q->w.D; h++) {
            const exact_line *l = &q->e->line[level][h];
            const kw_bspline *s = q->w.mesh->level[level].s[h];

            CHECK(l->n == s->n && l->d == s->d, "%d, %d functions", l->n, s->n);
            for (int i = 0; i <= l->n + l->d && l->n == s->n; i++)
                CHECK(rational_double(l->t[i]) == s->t[i], "level %d, knot %d: %g", level,
                      i, s->t[i]);
        }
}

static void every_space_agrees(void)
{
    for (int D = 1; D <= D_MOST; D++)
        over_meshes(D, spaces_agree);
}

static void every_sum_is_one(void)
{
    for (int D = 1; D <= D_MOST; D++)
        over_meshes(D, exact_sum_is_one);
}

static void values_1(void)
{
    over_meshes(1, values);
}

static void values_2(void)
{
    over_meshes(2, values);
}

static void values_3(void)
{
    over_meshes(3, values);
}

static void derivatives_1(void)
{
    over_meshes(1, derivatives);
}

static void derivatives_2(void)
{
    over_meshes(2, derivatives);
}

static void derivatives_3(void)
{
    over_meshes(3, derivatives);
}

int main(void)
{
    test_run("hier: the spaces of all levels are those of knot insertion",
             every_space_agrees);
    test_run("hier: by Definition 5 THB-splines add up to one exactly", every_sum_is_one);
    test_run("hier: in one direction values are the exact fractions", values_1);
    test_run("hier: in two directions values are the exact fractions", values_2);
    test_run("hier: in three directions values are the exact fractions", values_3);
    test_run("hier: in one direction so are all derivatives", derivatives_1);
    test_run("hier: in two directions so are mixed derivatives", derivatives_2);
    test_run("hier: in three directions so are mixed derivatives", derivatives_3);
    return test_end();
}
