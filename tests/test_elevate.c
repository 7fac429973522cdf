#include "elevate.h"
#include "spline.h"

enum { HIGHEST = 5, MOST = 200, POINTS = 10 };

/* Roundings of an elevated coefficient. A weight is a mean of d+1 blossoms of 5d each, a
   quotient and d+1 sums (spline.h); then come a product and d+1 sums. All terms are
   positive: the arguments are knots of the space itself. */
static int elevated_roundings(int d)
{
    return 7 * d + 5;
}

static void random_coefficients(kw_rng *r, int count, double *c)
{
    for (int i = 0; i < count; i++)
        c[i] = test_random_in(r, -1, 1);
}

/* The q-th derivative of the curve at x from the left or the right (N = 1), and in *size
   the sum of the absolute values of the terms of its functions. */
static double one_sided(const kw_bspline *s, const double *c, double x, int q, int left,
                        double *size)
{
    double value[K * K], sizes[K], sum = 0;
    int i = kw_bspline_span(s, x);

    while (left && i > s->d && s->t[i] >= x)
        i--;
    while (s->t[i] == s->t[i + 1]) /* x begins the domain */
        i++;
    kw_bspline_derivatives_on(s, i, x, q, value);
    derivative_size(s, i, x, q, sizes);
    *size = 0;
    for (int j = 0; j <= s->d; j++) {
        sum += value[q * (s->d + 1) + j] * c[i - s->d + j];
        *size += sizes[j];
    }
    return sum;
}

/* Both curves have the same derivatives of order 0 .. s->d + 1, from both sides; the last of
   s is zero. The coefficients e may be off by `off`. */
static void check_curve(kw_rng *r, const kw_bspline *s, const double *c,
                        const kw_bspline *elevated, const double *e, double off)
{
    for (int p = 0; p < POINTS; p++) {
        double x = test_random_point(r, s);

        for (int q = 0; q <= s->d + 1; q++) {
            double size, elevated_size, most;
            int left = p % 2;
            double a = one_sided(s, c, x, q, left, &size);
            double b = one_sided(elevated, e, x, q, left, &elevated_size);

            most = bound(6 * elevated->d + 2, size + (1 + off) * elevated_size) +
                   off * elevated_size;
            CHECK(fabs(a - b) <= most, "d = %d, derivative %d at %.17g: %g, %g, bound %g",
                  s->d, q, x, a, b, most);
        }
    }
}

static void the_curve_stays(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *elevated = kw_elevate_new(s);
    double c[MOST], e[MOST + GUARD], off = bound(elevated_roundings(s->d), 1);

    random_coefficients(r, s->n, c);
    poison(e, elevated->n);
    kw_elevate(s, elevated, 1, c, e);
    CHECK(written(e, elevated->n), "n = %d", elevated->n);
    check_curve(r, s, c, elevated, e, off);
    kw_bspline_free(elevated);
}

static void twice_is_two_degrees(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *once = kw_elevate_new(s), *twice = kw_elevate_new(once);
    double c[MOST], e[MOST], f[MOST];

    random_coefficients(r, s->n, c);
    kw_elevate(s, once, 1, c, e);
    kw_elevate(once, twice, 1, e, f);
    CHECK(twice->d == s->d + 2, "d = %d", twice->d);
    check_curve(r, s, c, twice, f,
                bound(elevated_roundings(s->d) + elevated_roundings(s->d + 1), 1));
    kw_bspline_free(once);
    kw_bspline_free(twice);
}

/* The weights are positive and add up to one: elevated coefficients are averages. */
static void the_polygon_stays_in_the_hull(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *elevated = kw_elevate_new(s);
    double c[MOST], e[MOST], low = 1, high = -1;
    double off = bound(elevated_roundings(s->d), 1);

    random_coefficients(r, s->n, c);
    kw_elevate(s, elevated, 1, c, e);
    for (int i = 0; i < s->n; i++) {
        low = fmin(low, c[i]);
        high = fmax(high, c[i]);
    }
    for (int i = 0; i < elevated->n; i++)
        CHECK(low - off <= e[i] && e[i] <= high + off,
              "d = %d, coefficient %d of %d: %.17g not in [%g, %g]", s->d, i, elevated->n,
              e[i], low, high);
    kw_bspline_free(elevated);
}

/* Every knot of the domain once more, n one more for each break and one for the degree. */
static void knots_appear_once_more(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *elevated = kw_elevate_new(s);
    int breaks = 0;

    (void)r;
    for (int i = s->d; i <= s->n; i++) {
        int before = kw_bspline_multiplicity(s, s->t[i]);
        int after = kw_bspline_multiplicity(elevated, s->t[i]);

        breaks += s->d < i && i < s->n && s->t[i - 1] < s->t[i];
        CHECK(after == before + 1, "knot %.17g: %d, then %d", s->t[i], before, after);
    }
    CHECK(elevated->d == s->d + 1, "d = %d and %d", s->d, elevated->d);
    CHECK(elevated->n == s->n + 1 + breaks, "n = %d and %d, %d breaks", s->n, elevated->n,
          breaks);
    CHECK(elevated->t[elevated->d] == s->t[s->d], "%g", elevated->t[elevated->d]);
    CHECK(elevated->t[elevated->n] == s->t[s->n], "%g", elevated->t[elevated->n]);
    kw_bspline_free(elevated);
}

static void coordinates_are_independent(const kw_bspline *s, kw_rng *r)
{
    enum { N = 3 };
    kw_bspline *elevated = kw_elevate_new(s);
    double c[N * MOST] = {0}, e[N * MOST + GUARD], one[MOST], alone[MOST];

    random_coefficients(r, N * s->n, c);
    poison(e, N * elevated->n);
    kw_elevate(s, elevated, N, c, e);
    CHECK(written(e, N * elevated->n), "n = %d", elevated->n);
    for (int a = 0; a < N; a++) {
        for (int i = 0; i < s->n; i++)
            one[i] = c[i * N + a];
        kw_elevate(s, elevated, 1, one, alone);
        for (int i = 0; i < elevated->n; i++)
            CHECK(alone[i] == e[i * N + a], "%g, %g", alone[i], e[i * N + a]);
    }
    kw_bspline_free(elevated);
}

/* c'_i = i/(d+1) c_{i-1} + (1 - i/(d+1)) c_i [Farin, ch. 6]; the formula here costs five
   roundings more. */
static void bezier_points_follow_the_formula(void)
{
    kw_rng r = kw_rng_at(71, 0, 0, 0);

    for (int d = 0; d < KW_BSPLINE_DEGREE; d++) {
        kw_bspline *s = kw_bspline_new_open_uniform(d, 1, 0, 1);
        kw_bspline *elevated = kw_elevate_new(s);
        double c[K], e[K + 1 + GUARD];

        random_coefficients(&r, d + 1, c);
        poison(e, d + 2);
        kw_elevate(s, elevated, 1, c, e);
        CHECK(written(e, d + 2) && elevated->n == d + 2, "d = %d", d);
        for (int i = 0; i <= d + 1; i++) {
            double w = (double)i / (d + 1), before = i > 0 ? c[i - 1] : 0;
            double wanted = w * before + (1 - w) * (i <= d ? c[i] : 0);

            CHECK(fabs(e[i] - wanted) <= bound(elevated_roundings(d) + 5, 1),
                  "d = %d, point %d: %.17g, not %.17g", d, i, e[i], wanted);
        }
        kw_bspline_free(s);
        kw_bspline_free(elevated);
    }
}

/* On simple auxiliary knots far out the arguments of a blossom lie on both sides of its span.
   Taken from the span outwards every term is positive, so a constant stays one up to the count
   above at any degree; in increasing order terms of either sign would grow with the degree. */
static void auxiliary_knots_cost_no_digits(void)
{
    enum { D = 24, CELLS = 3, N = D + CELLS };
    kw_bspline *s = kw_bspline_new_uniform(D, CELLS, 0, CELLS);
    kw_bspline *elevated = kw_elevate_new(s);
    double c[N], e[MOST];

    for (int i = 0; i < N; i++)
        c[i] = 1;
    kw_elevate(s, elevated, 1, c, e);
    for (int i = 0; i < elevated->n; i++)
        CHECK(fabs(e[i] - 1) <= bound(elevated_roundings(D), 1), "coefficient %d: %.17g",
              i, e[i]);
    kw_bspline_free(s);
    kw_bspline_free(elevated);
}

static void a_constant_by_pieces_gets_double_knots(void)
{
    const double t[] = {0, 1, 3}, c[] = {5, 7}, wanted[] = {0, 0, 1, 1, 3, 3};
    kw_bspline *s = kw_bspline_new(0, 2, t), *elevated = kw_elevate_new(s);
    double e[4];

    CHECK(elevated->d == 1 && elevated->n == 4, "d = %d, n = %d", elevated->d,
          elevated->n);
    for (int i = 0; i < 6; i++)
        CHECK(elevated->t[i] == wanted[i], "t[%d] = %g", i, elevated->t[i]);
    kw_elevate(s, elevated, 1, c, e);
    for (int i = 0; i < 4; i++)
        CHECK(e[i] == c[i / 2], "coefficient %d is %g", i, e[i]);
    kw_bspline_free(s);
    kw_bspline_free(elevated);
}

static void elevate_the_highest_degree(void)
{
    kw_elevate_new(kw_bspline_new_open_uniform(KW_BSPLINE_DEGREE, 1, 0, 1));
}

static void elevate_by_two(void)
{
    double c[3] = {0}, e[5];

    kw_elevate(kw_bspline_new_open_uniform(2, 1, 0, 1),
               kw_bspline_new_open_uniform(4, 1, 0, 1), 1, c, e);
}

static void elevate_to_more_functions(void)
{
    double c[3] = {0}, e[5];

    kw_elevate(kw_bspline_new_open_uniform(2, 1, 0, 1),
               kw_bspline_new_open_uniform(3, 2, 0, 1), 1, c, e);
}

static void elevate_to_other_knots(void)
{
    const double knots[] = {0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1};
    double c[4] = {0}, e[6];

    kw_elevate(kw_bspline_new_open_uniform(2, 2, 0, 1), kw_bspline_new(3, 6, knots), 1, c,
               e);
}

static void elevate_to_other_auxiliary_knots(void)
{
    const double knots[] = {-3, 0, 0, 0, 1, 1, 1, 1};
    double c[3] = {0}, e[4];

    kw_elevate(kw_bspline_new_open_uniform(2, 1, 0, 1), kw_bspline_new(3, 4, knots), 1, c,
               e);
}

static void impossible_degrees_abort(void)
{
    test_aborts("degree 32, not in 0 .. 31", elevate_the_highest_degree);
    test_aborts("degrees 2 and 4", elevate_by_two);
}

static void another_space_aborts(void)
{
    test_aborts("5 functions, not the 4 of kw_elevate_new", elevate_to_more_functions);
    test_aborts("t[4] = 0.25, not the 0.5 of kw_elevate_new", elevate_to_other_knots);
    test_aborts("t[0] = -3, not the 0 of kw_elevate_new",
                elevate_to_other_auxiliary_knots);
}

int main(void)
{
    run_over_spaces("elevate: the curve stays where it is, with all derivatives", HIGHEST,
                    the_curve_stays);
    run_over_spaces("elevate: twice is two degrees", HIGHEST, twice_is_two_degrees);
    run_over_spaces("elevate: the polygon stays in the hull", HIGHEST,
                    the_polygon_stays_in_the_hull);
    run_over_spaces("elevate: every knot of the domain appears once more", HIGHEST,
                    knots_appear_once_more);
    run_over_spaces("elevate: coordinates do not mix", HIGHEST,
                    coordinates_are_independent);
    test_run("elevate: Bezier points follow the formula",
             bezier_points_follow_the_formula);
    test_run("elevate: a constant by pieces gets double knots",
             a_constant_by_pieces_gets_double_knots);
    test_run("elevate: degree 31 and a jump of two degrees abort",
             impossible_degrees_abort);
    test_run("elevate: a space that is not the elevated one aborts",
             another_space_aborts);
    test_run("elevate: auxiliary knots cost no digits", auxiliary_knots_cost_no_digits);
    return test_end();
}
