/* The local functions, their derivatives, pieces and blossoms, and one function anywhere,
   by property over random spaces. */
#include "spline.h"

static double sum_of(const double *a, int count)
{
    double sum = 0;

    for (int i = 0; i < count; i++)
        sum += a[i];
    return sum;
}

/* --- values --- */

static void right_end(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], x = s->t[s->n], sum;
    int d = s->d, first;

    (void)r;
    poison(value, d + 1);
    first = kw_bspline_basis(s, x, value);
    sum = sum_of(value, d + 1);
    CHECK(written(value, d + 1), "d = %d", d);
    CHECK(first == s->n - 1 - d && kw_bspline_span(s, x) == s->n - 1,
          "first = %d, n = %d", first, s->n);
    /* positive terms: 5d roundings each and d of the sum */
    CHECK(fabs(sum - 1) <= bound(6 * d, 1), "d = %d: %.17g", d, sum);
    if (s->t[s->n + d] > x)
        return;
    for (int j = 0; j < d; j++)
        CHECK(value[j] == 0, "open knots, function %d of the last span: %g", j, value[j]);
    CHECK(fabs(value[d] - 1) <= bound(5 * d, 1), "open knots, last: %.17g", value[d]);
    CHECK(fabs(kw_bspline_one(s, s->n - 1, 0, x) - 1) <= bound(5 * d, 1), "d = %d", d);
}

static void unity(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM];
    int d = s->d;

    for (int point = 0; point < 30; point++) {
        double x = test_random_point(r, s), sum;

        poison(value, d + 1);
        kw_bspline_basis(s, x, value);
        CHECK(written(value, d + 1), "d = %d, x = %.17g", d, x);
        sum = sum_of(value, d + 1);
        CHECK(fabs(sum - 1) <= bound(6 * d, 1), "d = %d, x = %.17g: %.17g", d, x, sum);
        for (int j = 0; j <= d; j++)
            CHECK(0 <= value[j] && value[j] <= 1 + bound(5 * d, 1), "function %d: %g", j,
                  value[j]);
    }
}

static void span(const kw_bspline *s, kw_rng *r)
{
    const double *t = s->t;

    for (int j = s->d; j < s->n; j++) {
        int i = kw_bspline_span(s, t[j]);

        CHECK(s->d <= i && i < s->n, "span %d at knot %d", i, j);
        CHECK(t[i] == t[j] && t[j] < t[i + 1], "span %d at knot %d", i, j);
        if (t[j] == t[j + 1])
            continue;
        i = kw_bspline_span(s, nextafter(t[j + 1], t[j]));
        CHECK(i == j, "span %d just before knot %d", i, j + 1);
    }
    CHECK(kw_bspline_span(s, t[s->n]) == s->n - 1, "n = %d", s->n);
    for (int point = 0; point < 30; point++) {
        double x = test_random_point(r, s);
        int i = kw_bspline_span(s, x);

        CHECK(t[i] < t[i + 1] && t[i] <= x && (x < t[i + 1] || i == s->n - 1),
              "span %d at %.17g", i, x);
    }
}

/* Knots that pile up at one end, so that nearly all of them share a bucket of the table; spans
   of next to no length; huge and tiny domains. */
static void spans_of_graded_knots(void)
{
    enum { SPANS = 60 };
    static const double ratio[] = {0.5, 2, 1e-5, 1e5, 1 - 0x1p-50},
                        size[] = {1, 1e300, 1e-300};

    for (int g = 0; g < 5; g++)
        for (int z = 0; z < 3; z++)
            for (int d = 0; d <= 3; d++) {
                double tau[SPANS + 1], width = 1;
                int L = 0;
                kw_bspline *s;
                kw_rng r = kw_rng_at(77, (uint64_t)g, (uint64_t)z, (uint64_t)d);

                tau[0] = size[z] * -1;
                for (int i = 1; i <= SPANS; i++, width *= ratio[g]) {
                    double x = tau[L] + size[z] * width;

                    if (x > tau[L] && x < 1e305)
                        tau[++L] = x;
                }
                s = kw_bspline_new_open(d, L, tau, NULL);
                span(s, &r);
                kw_bspline_free(s);
            }
}

static void local_support(const kw_bspline *s, kw_rng *r)
{
    const double *t = s->t;
    double low = t[0] - 1, high = t[s->n + s->d] + 1;

    for (int j = 0; j < s->n; j++) {
        double a = t[j], b = t[j + s->d + 1];
        double outside[] = {low,
                            high,
                            nextafter(a, low),
                            nextafter(b, high),
                            test_random_in(r, low, a),
                            test_random_in(r, b, high)};
        double inside = a + (b - a) * test_random_in(r, 0.001, 0.999);

        for (int p = 0; p < 6; p++)
            for (int q = 0; q <= s->d + 1; q++)
                CHECK(outside[p] == b || kw_bspline_one(s, j, q, outside[p]) == 0,
                      "derivative %d of function %d at %.17g", q, j, outside[p]);
        CHECK(kw_bspline_one(s, j, 0, inside) > 0, "function %d at %.17g", j, inside);
    }
}

static void basis_is_each_function(const kw_bspline *s, kw_rng *r)
{
    double value[K];

    for (int point = 0; point < 10; point++) {
        double x = test_random_point(r, s);
        int first = kw_bspline_basis(s, x, value);

        for (int j = 0; j < s->n; j++) {
            double one = kw_bspline_one(s, j, 0, x);
            double local = first <= j && j <= first + s->d ? value[j - first] : 0;

            CHECK(fabs(one - local) <= bound(10 * s->d, local), "d = %d, %d, x = %.17g",
                  s->d, j, x);
        }
    }
}

/* --- one function, where no domain helps --- */

/* The space on the same knots and d+1 more on each side, simple ones: function j of s is
   function j+d+1 of it, and its domain holds every knot of s. */
static kw_bspline *more_knots(const kw_bspline *s)
{
    double t[12 * K];
    int more = s->d + 1, count = s->n + s->d + 1;

    for (int i = 0; i < more; i++) {
        t[i] = s->t[0] - more + i;
        t[more + count + i] = s->t[count - 1] + 1 + i;
    }
    for (int i = 0; i < count; i++)
        t[more + i] = s->t[i];
    return kw_bspline_new(s->d, s->n + 2 * more, t);
}

static void compare_with_local(const kw_bspline *s, const kw_bspline *wide, double x,
                               int highest)
{
    double value[ROOM], size[K];
    int d = s->d, end = wide->n - 1 - d; /* the span of s behind its last knot */
    int i = kw_bspline_span(wide, x);

    if (x == s->t[s->n]) /* the right end of s: from the left */
        for (i = end; wide->t[i] == x || wide->t[i] == wide->t[i + 1];)
            i--;
    kw_bspline_derivatives_on(wide, i, x, highest, value);
    for (int q = 0; q <= highest; q++) {
        derivative_size(wide, i, x, q, size);
        for (int j = 0; j < s->n; j++) {
            int l = j + d + 1 - (i - d);
            double local = 0 <= l && l <= d ? value[q * (d + 1) + l] : 0;
            double error = 0 <= l && l <= d ? bound(10 * d, size[l]) : 0;
            double one = kw_bspline_one(s, j, q, x);

            CHECK(fabs(one - local) <= error,
                  "d = %d, derivative %d of %d at %.17g: %g, %g", d, q, j, x, one, local);
        }
    }
}

static void one_function_anywhere(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *wide = more_knots(s);
    double low = wide->t[s->d], high = wide->t[wide->n], end = s->t[s->n];

    for (int point = 0; point < 10; point++) {
        double x = test_random_in(r, low, high);

        compare_with_local(s, wide, x, s->d + 1);
    }
    for (int i = 0; i <= s->n + s->d; i++)
        compare_with_local(s, wide, s->t[i], s->t[i] == end ? 0 : s->d + 1);
    kw_bspline_free(wide);
}

static void one_function_right_end(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *wide = more_knots(s);

    (void)r;
    compare_with_local(s, wide, s->t[s->n], s->d + 1);
    kw_bspline_free(wide);
}

/* --- derivatives --- */

static void derivative_rows(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], basis[K] = {0}, size[K];
    int d = s->d, k = d + 1;

    for (int order = 0; order <= d + 2; order += 1 + d / 8) {
        double x = test_random_point(r, s);
        int i = kw_bspline_span(s, x), first;

        poison(value, (order + 1) * k);
        first = kw_bspline_derivatives(s, x, order, value);
        CHECK(written(value, (order + 1) * k), "d = %d, r = %d", d, order);
        CHECK(first == i - d && first == kw_bspline_basis(s, x, basis), "first %d",
              first);
        for (int q = 0; q <= order; q++) {
            derivative_size(s, i, x, q, size);
            for (int j = 0; j <= d; j++) {
                double v = value[q * k + j];
                double one = x < s->t[s->n] ? kw_bspline_one(s, first + j, q, x) : v;

                CHECK(fabs(v - one) <= bound(10 * d, size[j]), "%d-th at %g: %g, %g", q,
                      x, v, one);
                CHECK(q != 0 || fabs(v - basis[j]) <= bound(10 * d, basis[j]), "%d", j);
                CHECK(q <= d || v == 0, "d = %d, derivative %d: %g", d, q, v);
            }
        }
    }
}

static void derivatives_sum_to_zero(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], size[K];
    int d = s->d, k = d + 1;

    for (int point = 0; point < 5; point++) {
        double x = test_random_point(r, s);
        int i = kw_bspline_span(s, x);

        kw_bspline_derivatives(s, x, d, value);
        for (int q = 1; q <= d; q++) {
            double sum = sum_of(value + q * k, k);

            derivative_size(s, i, x, q, size);
            CHECK(fabs(sum) <= bound(6 * d, sum_of(size, k)), "d = %d, derivative %d: %g",
                  d, q, sum);
        }
    }
}

/* The largest size of a q-th derivative on a span of this width: each differentiation of
   degree p gives at most twice p / width, for the supports contain the span. */
static double largest_derivative(int d, int q, double width)
{
    double size = q <= d ? 1 : 0;

    for (int p = d; p > d - q && p > 0; p--)
        size *= 2 * p / width;
    return size;
}

/* (f(x+h) - f(x-h)) / 2h = f'(x) + h^2/6 f'''(somewhere in between). The points are
   multiples of h, a power of 2, so they are exact. */
static void derivatives_are_slopes(const kw_bspline *s, kw_rng *r)
{
    double before[ROOM], at[ROOM], after[ROOM];
    int d = s->d, k = d + 1, i = random_span(r, s);
    double width = s->t[i + 1] - s->t[i], h = ldexp(1, ilogb(width) - 10);
    double x = floor((s->t[i] + width * test_random_in(r, 0.25, 0.75)) / h) * h;

    kw_bspline_derivatives_on(s, i, x - h, d + 1, before);
    kw_bspline_derivatives_on(s, i, x, d + 1, at);
    kw_bspline_derivatives_on(s, i, x + h, d + 1, after);
    for (int q = 1; q <= d + 1; q++) {
        double error = h * h / 6 * largest_derivative(d, q + 2, width) +
                       bound(5 * d + 2, largest_derivative(d, q - 1, width) / h) +
                       bound(5 * d, largest_derivative(d, q, width));

        for (int j = 0; j <= d; j++) {
            int l = (q - 1) * k + j;
            double slope = (after[l] - before[l]) / (2 * h);

            CHECK(fabs(slope - at[l + k]) <= error, "d = %d, derivative %d: %g, %g", d, q,
                  slope, at[l + k]);
        }
    }
}

/* --- polynomial pieces --- */

/* The r-th derivative of sum of piece[q] u^q, u = (x - a) / width, with respect to x. */
static double piece_derivative(const double *piece, int d, double u, double width, int r)
{
    double value = 0;

    for (int q = d; q >= r; q--) {
        double factor = 1;

        for (int p = q; p > q - r; p--)
            factor *= p;
        value = value * u + factor * piece[q];
    }
    for (int p = 0; p < r; p++)
        value /= width;
    return value;
}

/* size[0..d] of the r-th derivatives at x by their Taylor sums around t[i] */
static void taylor_size(const kw_bspline *s, int i, double x, int r, double *size)
{
    double derivative[K], power = 1; /* (x - t[i])^(q-r) / (q-r)! */

    for (int j = 0; j <= s->d; j++)
        size[j] = 0;
    for (int q = r; q <= s->d; q++) {
        derivative_size(s, i, s->t[i], q, derivative);
        for (int j = 0; j <= s->d; j++)
            size[j] += power * derivative[j];
        power *= fabs(x - s->t[i]) / (q - r + 1);
    }
}

/* Every piece of span i against the derivatives at x: 5d roundings of those. A coefficient
   piece[q] has 5d, of h^q/q! 3q and their product 1; its factor at most r; of Horner's
   scheme 5 a step (3 of them u's own) and 1; h and the divisions by it 2r. All in all at
   most 8d + 1 + 5d + 1 + 3d. */
static void compare_pieces(const kw_bspline *s, int i, double x, int highest)
{
    double piece[ROOM], value[ROOM], size[K], taylor[K];
    int d = s->d, k = d + 1;
    double width = s->t[i + 1] - s->t[i], u = (x - s->t[i]) / width;

    poison(piece, k * k);
    kw_bspline_pieces(s, i, piece);
    CHECK(written(piece, k * k), "d = %d", d);
    kw_bspline_derivatives_on(s, i, x, d, value);
    for (int q = 0; q <= d && q <= highest; q++) {
        derivative_size(s, i, x, q, size);
        taylor_size(s, i, x, q, taylor);
        for (int j = 0; j <= d; j++) {
            double got = piece_derivative(piece + j * k, d, u, width, q);
            double error = bound(5 * d, size[j]) + bound(16 * d + 2, taylor[j]);

            CHECK(fabs(got - value[q * k + j]) <= error, "d = %d, %d-th at %g: %g, %g", d,
                  q, x, got, value[q * k + j]);
        }
    }
}

static void pieces_have_the_values(const kw_bspline *s, kw_rng *r)
{
    int i = random_span(r, s);

    for (int point = 0; point < 8; point++)
        compare_pieces(s, i, test_random_in(r, s->t[i], s->t[i + 1]), 0);
    compare_pieces(s, s->n - 1, s->t[s->n], 0);
}

static void pieces_have_the_derivatives(const kw_bspline *s, kw_rng *r)
{
    int i = random_span(r, s);

    for (int point = 0; point < 8; point++)
        compare_pieces(s, i, test_random_in(r, s->t[i], s->t[i + 1]), s->d);
}

static void left_derivatives(const kw_bspline *s, kw_rng *r)
{
    (void)r;
    for (int i = s->d; i < s->n; i++)
        if (s->t[i] < s->t[i + 1]) {
            compare_pieces(s, i, s->t[i + 1], s->d);
            compare_pieces(s, i, s->t[i], s->d);
        }
}

/* u^3/6, (1+3u+3u^2-3u^3)/6, (4-6u^2+3u^3)/6, (1-u)^3/6: knots and differences are whole
   numbers, so only quotients round, at most the 8d + 1 times counted above. */
static void cardinal_pieces(void)
{
    static const double six[4][4] = {
        {1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
    kw_bspline *s = kw_bspline_new_uniform(3, 5, -1, 4);

    for (int i = s->d; i < s->n; i++) {
        double piece[ROOM], size[K] = {0}, factorial = 1;

        kw_bspline_pieces(s, i, piece);
        for (int q = 0; q <= 3; factorial *= ++q) {
            derivative_size(s, i, s->t[i], q, size);
            for (int j = 0; j <= 3; j++)
                CHECK(fabs(piece[4 * j + q] - six[j][q] / 6) <=
                          bound(8 * 3 + 2, size[j] / factorial),
                      "span %d, piece %d, u^%d: %.17g", i, j, q, piece[4 * j + q]);
        }
    }
    kw_bspline_free(s);
}

int main(void)
{
    const int all = KW_BSPLINE_DEGREE;

    run_over_spaces("bspline: at the right end the functions add up to 1", 6, right_end);
    run_over_spaces("bspline: so at degrees up to 31", all, right_end);
    run_over_spaces("bspline: functions are positive and add up to 1", 6, unity);
    run_over_spaces("bspline: so at degrees up to 31, too", all, unity);
    run_over_spaces("bspline: the span of x begins at or before it", 6, span);
    run_over_spaces("bspline: a function is zero outside its support", 6, local_support);
    run_over_spaces("bspline: the basis is its functions one by one", all,
                    basis_is_each_function);
    run_over_spaces("bspline: a function goes on outside the domain", 6,
                    one_function_anywhere);
    run_over_spaces(
        "bspline: one function's derivatives at the right end are the left ones", 6,
        one_function_right_end);
    run_over_spaces("bspline: derivatives are those of each function, zero above d", 6,
                    derivative_rows);
    run_over_spaces("bspline: so they are at degrees up to 31", all, derivative_rows);
    run_over_spaces("bspline: derivatives of all functions add up to 0", all,
                    derivatives_sum_to_zero);
    run_over_spaces("bspline: derivatives are limits of slopes", 5,
                    derivatives_are_slopes);
    run_over_spaces("bspline: pieces have the values", 8, pieces_have_the_values);
    run_over_spaces("bspline: pieces have the derivatives", 6,
                    pieces_have_the_derivatives);
    run_over_spaces("bspline: derivatives on a span reach both its ends", 6,
                    left_derivatives);
    test_run("bspline: spans of graded knots, of huge and of tiny domains",
             spans_of_graded_knots);
    test_run("bspline: the cardinal cubic has the four known pieces", cardinal_pieces);
    return test_end();
}
