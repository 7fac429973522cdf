#include "tensor.h"
#include "insert.h"
#include "spline.h"
#include <stdlib.h>

enum {
    N = 2,       /* coordinates of the geometries */
    ROUNDS = 40, /* random spaces a direction count */
    POINTS = 4,
    D3 = KW_TENSOR_D
};

/* --- random spaces, points and orders --- */

static kw_tensor *random_tensor(kw_rng *r, int D)
{
    const int highest[] = {0, 5, 3, 2};
    kw_bspline *s[D3] = {NULL};
    kw_tensor *g;

    for (int h = 0; h < D; h++)
        s[h] = test_random_space(r, highest[D]);
    g = kw_tensor_new(D, (const kw_bspline *const *)s);
    for (int h = 0; h < D; h++) /* g has copies */
        kw_bspline_free(s[h]);
    return g;
}

/* Coefficients in [-1,1), one N-tuple a function; the caller frees. */
static double *random_coefficients(kw_rng *r, const kw_tensor *g)
{
    int count = N * kw_tensor_dimension(g);
    double *c = malloc((size_t)count * sizeof *c);

    for (int i = 0; i < count; i++)
        c[i] = test_random_in(r, -1, 1);
    return c;
}

/* The first 2^D points of a space are the corners, the closed right ends before all. */
static void point_number(kw_rng *r, const kw_tensor *g, int number, double *x)
{
    for (int h = 0; h < g->D; h++) {
        const kw_bspline *s = g->s[h];

        if (number < 1 << g->D)
            x[h] = number >> h & 1 ? s->t[s->d] : s->t[s->n];
        else
            x[h] = test_random_point(r, s);
    }
}

/* Orders 0 .. d_h + 1, mostly small. */
static void random_orders(kw_rng *r, const kw_tensor *g, int *orders)
{
    for (int h = 0; h < g->D; h++)
        orders[h] = kw_rng_below(r, 1 + kw_rng_below(r, g->s[h]->d + 2));
}

/* --- bounds (spline.h) --- */

/* Of the local functions' derivatives at x, the sum of the absolute values of all terms,
   which is the product over the directions. */
static double size_of(const kw_tensor *g, const int *orders, const double *x)
{
    double product = 1;

    for (int h = 0; h < g->D; h++) {
        double size[K], sum = 0;

        derivative_size(g->s[h], kw_bspline_span(g->s[h], x[h]), x[h],
                        orders ? orders[h] : 0, size);
        for (int j = 0; j <= g->s[h]->d; j++)
            sum += size[j];
        product *= sum;
    }
    return product;
}

/* Roundings of a geometry at a point: 5d_h in each factor, D products with them, one with
   the coefficient; the sums over local functions, at most as many as there are. */
static int roundings(const kw_tensor *g)
{
    int count = g->D + 1 + kw_tensor_local(g);

    for (int h = 0; h < g->D; h++)
        count += 5 * g->s[h]->d;
    return count;
}

/* --- a property over random spaces in 1, 2 and 3 directions --- */

typedef void tensor_property(const kw_tensor *g, kw_rng *r);

static tensor_property *held;

static void over_spaces(void)
{
    for (int D = 1; D <= D3; D++)
        for (int round = 0; round < ROUNDS; round++) {
            kw_rng r = kw_rng_at(80, (uint64_t)D, (uint64_t)round, 0);
            kw_tensor *g = random_tensor(&r, D);

            held(g, &r);
            kw_tensor_free(g);
        }
}

static void run_over_tensors(const char *name, tensor_property *holds)
{
    held = holds;
    test_run(name, over_spaces);
}

/* --- indices --- */

static void indices_count_the_last_direction_first(const kw_tensor *g, kw_rng *r)
{
    int wanted[D3] = {0}, got[D3] = {-1, -1, -1}, dimension = kw_tensor_dimension(g);
    int product = 1, local = 1;

    (void)r;
    for (int h = 0; h < g->D; h++) {
        product *= g->s[h]->n;
        local *= g->s[h]->d + 1;
    }
    CHECK(dimension == product && kw_tensor_local(g) == local, "%d and %d", dimension,
          kw_tensor_local(g));
    for (int flat = 0; flat < dimension; flat++) {
        kw_tensor_multi(g, flat, got);
        for (int h = 0; h < g->D; h++)
            CHECK(got[h] == wanted[h], "flat %d, direction %d: %d, not %d", flat, h,
                  got[h], wanted[h]);
        CHECK(kw_tensor_flat(g, wanted) == flat, "%d, not %d", kw_tensor_flat(g, wanted),
              flat);
        /* an odometer: the last wheel turns first */
        for (int h = g->D - 1; h >= 0 && ++wanted[h] == g->s[h]->n; h--)
            wanted[h] = 0;
    }
}

/* --- functions --- */

/* The local functions in order, each the product of univariate values: to the bit. The
   sum of the values is one. NULL are the orders 0. */
static void the_basis_is_a_product(const kw_tensor *g, kw_rng *r)
{
    int local = kw_tensor_local(g), none[D3] = {0};
    double *value = malloc(((size_t)local + GUARD) * sizeof *value);

    for (int number = 0; number < POINTS + (1 << g->D); number++) {
        double x[D3], factor[D3][K], sum = 0;
        int first[D3], unity = number % 2 == 0;

        point_number(r, g, number, x);
        for (int h = 0; h < g->D; h++)
            kw_bspline_basis(g->s[h], x[h], factor[h]);
        poison(value, local);
        kw_tensor_basis(g, unity ? NULL : none, x, first, value);
        CHECK(written(value, local), "%d values", local);
        for (int flat = 0; flat < local; flat++) {
            double product = 1;
            int rest = flat, place[D3] = {0};

            for (int h = g->D - 1; h >= 0; h--) {
                place[h] = rest % (g->s[h]->d + 1);
                rest /= g->s[h]->d + 1;
            }
            for (int h = 0; h < g->D; h++)
                product *= factor[h][place[h]];
            CHECK(value[flat] == product, "value %d: %.17g, not %.17g", flat, value[flat],
                  product);
            sum += value[flat];
        }
        CHECK(fabs(sum - 1) <= bound(roundings(g), 1), "D = %d, point %d: %.17g", g->D,
              number, sum);
    }
    free(value);
}

/* One function's derivative is the local one's, and zero for all that are not local. */
static void one_function_is_that_of_the_basis(const kw_tensor *g, kw_rng *r)
{
    double *value = malloc((size_t)kw_tensor_local(g) * sizeof *value);

    for (int number = 0; number < POINTS; number++) {
        double x[D3];
        int first[D3], orders[D3], dimension = kw_tensor_dimension(g);

        point_number(r, g, number, x);
        random_orders(r, g, orders);
        kw_tensor_basis(g, orders, x, first, value);
        for (int flat = 0; flat < dimension; flat++) {
            double wanted = 0, got, most;
            int j[D3], place = 0, inside = 1;

            kw_tensor_multi(g, flat, j);
            for (int h = 0; h < g->D; h++) {
                inside = inside && first[h] <= j[h] && j[h] <= first[h] + g->s[h]->d;
                place = place * (g->s[h]->d + 1) + j[h] - first[h];
            }
            if (inside)
                wanted = value[place];
            got = kw_tensor_one(g, j, orders, x);
            most = inside ? bound(2 * roundings(g), size_of(g, orders, x)) : 0;
            CHECK(fabs(got - wanted) <= most, "D = %d, function %d: %g, not %g", g->D,
                  flat, got, wanted);
        }
    }
    free(value);
}

/* Mixed partials are products of univariate derivatives, to the bit. */
static void partials_are_products(const kw_tensor *g, kw_rng *r)
{
    int local = kw_tensor_local(g);
    double *value = malloc(((size_t)local + GUARD) * sizeof *value);

    for (int number = 0; number < 2 * POINTS; number++) {
        double x[D3], all[D3][(K + 1) * K];
        int first[D3], orders[D3];

        point_number(r, g, number, x);
        random_orders(r, g, orders);
        for (int h = 0; h < g->D; h++)
            kw_bspline_derivatives(g->s[h], x[h], orders[h], all[h]);
        poison(value, local);
        kw_tensor_basis(g, orders, x, first, value);
        CHECK(written(value, local), "%d values", local);
        for (int flat = 0; flat < local; flat++) {
            double size = size_of(g, orders, x), product = 1;

            for (int h = g->D - 1, rest = flat; h >= 0; h--) {
                int k = g->s[h]->d + 1;

                product *= all[h][orders[h] * k + rest % k];
                rest /= k;
            }
            CHECK(fabs(value[flat] - product) <= bound(2 * roundings(g), size),
                  "%g, not %g", value[flat], product);
        }
    }
    free(value);
}

/* --- geometries --- */

static void a_point_is_the_sum_over_all_functions(const kw_tensor *g, kw_rng *r)
{
    double *c = random_coefficients(r, g);
    int dimension = kw_tensor_dimension(g);

    for (int number = 0; number < POINTS; number++) {
        double x[D3], sum[N] = {0}, point[N + GUARD], most;
        int orders[D3];

        point_number(r, g, number, x);
        random_orders(r, g, orders);
        poison(point, N);
        kw_tensor_point(g, N, c, number ? orders : NULL, x, point);
        CHECK(written(point, N), "D = %d", g->D);
        for (int flat = 0; flat < dimension; flat++) {
            int j[D3];
            double value;

            kw_tensor_multi(g, flat, j);
            value = kw_tensor_one(g, j, number ? orders : NULL, x);
            for (int a = 0; a < N; a++)
                sum[a] += value * c[flat * N + a];
        }
        most = bound(2 * roundings(g), size_of(g, number ? orders : NULL, x));
        for (int a = 0; a < N; a++)
            CHECK(fabs(point[a] - sum[a]) <= most, "D = %d: %.17g, not %.17g", g->D,
                  point[a], sum[a]);
    }
    free(c);
}

/* The grid is that of the points one by one, up to the order of the sums; it fills its
   work space to the last number and nothing behind it. */
static void a_grid_is_its_points(const kw_tensor *g, kw_rng *r)
{
    double *c = random_coefficients(r, g), grid[3 * 4 * 5 * N + GUARD], x[D3][5] = {{0}};
    const double *lines[D3] = {x[0], x[1], x[2]};
    const int counts[D3] = {4, g->D > 1 ? 3 : 1, g->D > 2 ? 5 : 1};
    int orders[D3] = {0}, total = 1, work = (int)kw_tensor_grid_work(g, N, counts);
    double *space = malloc(((size_t)work + GUARD) * sizeof *space);

    random_orders(r, g, orders);
    for (int h = 0; h < g->D; h++) {
        total *= counts[h];
        x[h][0] = g->s[h]->t[g->s[h]->n]; /* the right end before all */
        for (int i = 1; i < counts[h]; i++)
            x[h][i] = test_random_point(r, g->s[h]);
    }
    poison(space, work);
    poison(grid, total * N);
    kw_tensor_grid(g, N, c, orders, counts, lines, space, grid);
    CHECK(written(space, work), "D = %d: work of %d", g->D, work);
    CHECK(written(grid, total * N), "D = %d: %d points", g->D, total);
    for (int i = 0; i < total; i++) {
        double at[D3], point[N];

        for (int h = D3 - 1, rest = i; h >= 0; rest /= counts[h--])
            at[h] = x[h][rest % counts[h]];
        kw_tensor_point_many(g, N, c, orders, 1, at, point);
        for (int a = 0; a < N; a++)
            CHECK(fabs(grid[i * N + a] - point[a]) <=
                      bound(2 * roundings(g), size_of(g, orders, at)),
                  "D = %d, point %d: %.17g, not %.17g", g->D, i, grid[i * N + a],
                  point[a]);
    }
    free(space);
    free(c);
}

static void many_points_are_points(const kw_tensor *g, kw_rng *r)
{
    double *c = random_coefficients(r, g), x[POINTS * D3], point[POINTS * N + GUARD];
    double one[N];

    for (int i = 0; i < POINTS; i++)
        point_number(r, g, i, x + (size_t)i * (size_t)g->D);
    poison(point, POINTS * N);
    kw_tensor_point_many(g, N, c, NULL, POINTS, x, point);
    CHECK(written(point, POINTS * N), "D = %d", g->D);
    for (int i = 0; i < POINTS; i++) {
        kw_tensor_point(g, N, c, NULL, x + (size_t)i * (size_t)g->D, one);
        for (int a = 0; a < N; a++)
            CHECK(one[a] == point[i * N + a], "%.17g, %.17g", one[a], point[i * N + a]);
    }
    free(c);
}

/* A geometry in R^M is its coordinates one by one, to the bit, at more points and grid lines than
   are taken at a time; a grid in one direction is its points. */
static void coordinates_do_not_mix(const kw_tensor *g, kw_rng *r)
{
    enum { COUNT = 67, MOST = 4 };
    int M = 1 + kw_rng_below(r, MOST), n = kw_tensor_dimension(g);
    double *c = malloc((size_t)(M + 1) * (size_t)n * sizeof *c), *alone = c + M * n;
    double x[COUNT * D3], point[COUNT * MOST + GUARD], one[COUNT];

    for (int i = 0; i < M * n; i++)
        c[i] = test_random_in(r, -1, 1);
    for (int i = 0; i < COUNT; i++)
        point_number(r, g, i, x + i * g->D);
    poison(point, COUNT * M);
    kw_tensor_point_many(g, M, c, NULL, COUNT, x, point);
    CHECK(written(point, COUNT * M), "D = %d", g->D);
    for (int a = 0; a < M; a++) {
        for (int i = 0; i < n; i++)
            alone[i] = c[i * M + a];
        kw_tensor_point_many(g, 1, alone, NULL, COUNT, x, one);
        for (int i = 0; i < COUNT; i++)
            CHECK(point[i * M + a] == one[i], "D = %d, M = %d, point %d: %.17g, %.17g",
                  g->D, M, i, point[i * M + a], one[i]);
    }
    if (g->D == 1) {
        double grid[COUNT * MOST + GUARD];
        const double *const lines[] = {x};
        const int count = COUNT;

        poison(grid, COUNT * M);
        kw_tensor_grid(g, M, c, NULL, &count, lines, NULL, grid);
        CHECK(written(grid, COUNT * M) && same_bits(grid, point, COUNT * M), "M = %d", M);
    }
    free(c);
}

static void no_points(const kw_tensor *g, kw_rng *r)
{
    const int count[D3] = {0};
    const double *const lines[D3] = {NULL};
    double *c = random_coefficients(r, g), point[GUARD];

    poison(point, 0);
    kw_tensor_point_many(g, N, c, NULL, 0, NULL, point);
    CHECK(kw_tensor_grid_work(g, N, count) == 0, "D = %d", g->D);
    kw_tensor_grid(g, N, c, NULL, count, lines, point, point);
    CHECK(written(point, 0), "D = %d", g->D);
    free(c);
}

/* --- refinement --- */

/* A refined coefficient has 6d + 2 roundings a direction on an average (test_insert.c). */
static void check_refined(kw_rng *r, const kw_tensor *g, const kw_tensor *fine)
{
    double *c = random_coefficients(r, g);
    int work = (int)kw_tensor_refine_work(g, fine, N),
        total = N * kw_tensor_dimension(fine);
    double *space = malloc(((size_t)work + GUARD) * sizeof *space);
    double *f = malloc(((size_t)total + GUARD) * sizeof *f);
    int refined = 0;

    poison(space, work);
    poison(f, total);
    kw_tensor_refine(g, fine, N, c, space, f);
    CHECK(written(space, work), "D = %d: work of %d", g->D, work);
    CHECK(written(f, total), "D = %d: %d coefficients", g->D, total);
    for (int h = 0; h < g->D; h++)
        refined += 6 * g->s[h]->d + 2;
    for (int number = 0; number < 8 + POINTS; number++) {
        double x[D3], a[N], b[N];

        point_number(r, g, number, x);
        kw_tensor_point(g, N, c, NULL, x, a);
        kw_tensor_point(fine, N, f, NULL, x, b);
        for (int i = 0; i < N; i++)
            CHECK(fabs(a[i] - b[i]) <= bound(2 * roundings(g) + refined, 1),
                  "D = %d, point %d: %.17g and %.17g", g->D, number, a[i], b[i]);
    }
    free(f);
    free(space);
    free(c);
}

static double random_inside(kw_rng *r, const kw_bspline *s)
{
    double x = test_random_point(r, s);

    while (kw_bspline_multiplicity(s, x) > 0)
        x = test_random_point(r, s);
    return x;
}

/* One knot line more in one direction leaves the others alone. */
static void a_knot_line_leaves_the_geometry(const kw_tensor *g, kw_rng *r)
{
    for (int h = 0; h < g->D; h++) {
        kw_bspline *s = kw_insert_new_knot(g->s[h], random_inside(r, g->s[h]));
        kw_tensor *fine = kw_tensor_new_direction(g, h, s);

        for (int i = 0; i < g->D; i++)
            CHECK(fine->s[i]->n == g->s[i]->n + (i == h), "direction %d: %d", i,
                  fine->s[i]->n);
        kw_bspline_free(s);
        check_refined(r, g, fine);
        kw_tensor_free(fine);
    }
}

static void halving_leaves_the_geometry(const kw_tensor *g, kw_rng *r)
{
    kw_tensor *fine = kw_tensor_new_dyadic(g);

    for (int h = 0; h < g->D; h++) {
        kw_bspline *s = kw_insert_new_dyadic(g->s[h]);

        CHECK(fine->s[h]->n == s->n && fine->s[h]->d == s->d, "n = %d", s->n);
        for (int i = 0; fine->s[h]->n == s->n && i <= s->n + s->d; i++)
            CHECK(fine->s[h]->t[i] == s->t[i], "t[%d] = %g", i, s->t[i]);
        kw_bspline_free(s);
    }
    check_refined(r, g, fine);
    check_refined(r, g, g); /* equal directions are allowed */
    kw_tensor_free(fine);
}

int main(void)
{
    run_over_tensors(
        "tensor: flat and multi-index are inverse, the last direction fastest",
        indices_count_the_last_direction_first);
    run_over_tensors("tensor: the basis is a product and sums to one, at corners too",
                     the_basis_is_a_product);
    run_over_tensors("tensor: one function is that of the basis",
                     one_function_is_that_of_the_basis);
    run_over_tensors("tensor: mixed partials are products of derivatives",
                     partials_are_products);
    run_over_tensors("tensor: a point is the sum over all functions",
                     a_point_is_the_sum_over_all_functions);
    run_over_tensors("tensor: a grid is its points and fills its work space exactly",
                     a_grid_is_its_points);
    run_over_tensors("tensor: many points are the points one by one",
                     many_points_are_points);
    run_over_tensors("tensor: so are many more, and each coordinate alone",
                     coordinates_do_not_mix);
    run_over_tensors("tensor: no points, nothing written", no_points);
    run_over_tensors("tensor: a knot line leaves the geometry where it is",
                     a_knot_line_leaves_the_geometry);
    run_over_tensors("tensor: halving all directions leaves the geometry where it is",
                     halving_leaves_the_geometry);
    return test_end();
}
