#include "insert.h"
#include "curve.h"
#include "spline.h"
#include <stdlib.h>
#include <string.h>

enum {
    HIGHEST = 5, /* degree of the random spaces */
    MOST = 200,  /* functions of a space */
    MORE = 6,    /* knots that are inserted */
    POINTS = 10
};

/* Roundings of a coefficient. One average of Boehm's: w and 1 - w have three each, their
   own products, the sum and the rounding of 1 - w make eight, on a convex combination. A
   row of the Oslo matrix: 5d in each weight (spline.h), then a product and d sums. No term is
   negative where, as here, the fine auxiliary knots contain the coarse ones. */
enum { BOEHM = 8 };

static int oslo(int d)
{
    return 6 * d + 2;
}

/* --- helpers --- */

/* Coefficients in [-1,1); so are all that come from them by averaging, up to rounding. */
static void random_coefficients(kw_rng *r, int count, double *c)
{
    for (int i = 0; i < count; i++)
        c[i] = test_random_in(r, -1, 1);
}

/* A point inside the domain that may become a knot once more. */
static double random_new_knot(kw_rng *r, const kw_bspline *s)
{
    double x = test_random_point(r, s);

    while (x == s->t[s->d] || x == s->t[s->n] || kw_bspline_multiplicity(s, x) > s->d)
        x = test_random_point(r, s);
    return x;
}

/* s with some more knots, one after the other; c (n x 1) becomes, by Boehm's rule, its
   coefficients. *added is how many. */
static kw_bspline *refine(kw_rng *r, const kw_bspline *s, double *c, int *added)
{
    kw_bspline *fine = kw_bspline_new_copy(s);

    *added = 1 + kw_rng_below(r, MORE);
    for (int i = 0; i < *added; i++) {
        double x = random_new_knot(r, fine), finer[MOST];
        kw_bspline *next = kw_insert_new_knot(fine, x);

        kw_insert_boehm(fine, x, 1, c, finer);
        memcpy(c, finer, (size_t)next->n * sizeof *c);
        kw_bspline_free(fine);
        fine = next;
    }
    return fine;
}

/* The q-th derivative at x of the polynomial piece on span i (N = 1), and in *size the sum
   of the absolute values of the terms of its functions. */
static double piece(const kw_bspline *s, const double *c, int i, double x, int q,
                    double *size)
{
    double value[K * K], sizes[K], sum = 0;

    kw_bspline_derivatives_on(s, i, x, q, value);
    derivative_size(s, i, x, q, sizes);
    *size = 0;
    for (int j = 0; j <= s->d; j++) {
        sum += value[q * (s->d + 1) + j] * c[i - s->d + j];
        *size += sizes[j];
    }
    return sum;
}

/* The pieces on span i of s and on span j of fine are the same polynomial near x: all
   derivatives agree, where the coefficients f may be off by `off`. */
static void check_pieces(const kw_bspline *s, const double *c, int i,
                         const kw_bspline *fine, const double *f, int j, double off,
                         double x)
{
    for (int q = 0; q <= s->d; q++) {
        double coarse_size, fine_size;
        double a = piece(s, c, i, x, q, &coarse_size);
        double b = piece(fine, f, j, x, q, &fine_size);
        double most =
            bound(6 * s->d + 2, coarse_size + (1 + off) * fine_size) + off * fine_size;

        CHECK(fabs(a - b) <= most, "d = %d, derivative %d at %.17g: %g and %g, bound %g",
              s->d, q, x, a, b, most);
    }
}

static void check_curve(kw_rng *r, const kw_bspline *s, const double *c,
                        const kw_bspline *fine, const double *f, double off)
{
    for (int p = 0; p < POINTS; p++) {
        double x = test_random_point(r, s);

        check_pieces(s, c, kw_bspline_span(s, x), fine, f, kw_bspline_span(fine, x), off,
                     x);
    }
}

/* --- Boehm --- */

static void boehm_keeps_the_curve(const kw_bspline *s, kw_rng *r)
{
    double c[MOST], f[MOST + GUARD], x = random_new_knot(r, s);
    kw_bspline *fine = kw_insert_new_knot(s, x);

    CHECK(fine->n == s->n + 1 && fine->d == s->d, "n = %d, d = %d", fine->n, fine->d);
    CHECK(kw_bspline_multiplicity(fine, x) == kw_bspline_multiplicity(s, x) + 1, "%g", x);
    random_coefficients(r, s->n, c);
    poison(f, fine->n);
    kw_insert_boehm(s, x, 1, c, f);
    CHECK(written(f, fine->n), "d = %d, n = %d", s->d, s->n);
    check_curve(r, s, c, fine, f, bound(BOEHM, 1));
    kw_bspline_free(fine);
}

/* Coordinates do not mix: N of them give what each gives alone, to the bit. */
static void coordinates_are_independent(const kw_bspline *s, kw_rng *r)
{
    enum { N = 3 };
    double c[N * MOST], f[N * MOST + GUARD], o[N * MOST + GUARD], one[MOST], alone[MOST];
    double x = random_new_knot(r, s);
    kw_bspline *fine = kw_insert_new_knot(s, x);

    random_coefficients(r, N * s->n, c);
    poison(f, N * fine->n);
    poison(o, N * fine->n);
    kw_insert_boehm(s, x, N, c, f);
    kw_insert_oslo(s, fine, N, c, o);
    CHECK(written(f, N * fine->n) && written(o, N * fine->n), "n = %d", s->n);
    for (int a = 0; a < N; a++) {
        for (int i = 0; i < s->n; i++)
            one[i] = c[i * N + a];
        kw_insert_boehm(s, x, 1, one, alone);
        for (int i = 0; i < fine->n; i++)
            CHECK(alone[i] == f[i * N + a], "Boehm: %g, %g", alone[i], f[i * N + a]);
        kw_insert_oslo(s, fine, 1, one, alone);
        for (int i = 0; i < fine->n; i++)
            CHECK(alone[i] == o[i * N + a], "Oslo: %g, %g", alone[i], o[i * N + a]);
    }
    kw_bspline_free(fine);
}

/* The span that ends at x or holds it. */
static int span_before(const kw_bspline *s, double x)
{
    int i = kw_bspline_span(s, x);

    while (s->t[i] >= x)
        i--;
    return i;
}

/* A knot up to k times: there the curve may jump, and it does not. */
static void a_full_knot_keeps_both_sides(const kw_bspline *s, kw_rng *r)
{
    double c[MOST], f[MOST], finer[MOST], x = random_new_knot(r, s), off;
    kw_bspline *fine = kw_bspline_new_copy(s);
    int added = 0;

    random_coefficients(r, s->n, c);
    memcpy(f, c, sizeof c);
    for (; kw_bspline_multiplicity(fine, x) <= s->d; added++) {
        kw_bspline *next = kw_insert_new_knot(fine, x);

        kw_insert_boehm(fine, x, 1, f, finer);
        memcpy(f, finer, sizeof f);
        kw_bspline_free(fine);
        fine = next;
    }
    off = bound(BOEHM * added, 1);
    check_pieces(s, c, kw_bspline_span(s, x), fine, f, kw_bspline_span(fine, x), off, x);
    check_pieces(s, c, span_before(s, x), fine, f, span_before(fine, x), off, x);
    check_curve(r, s, c, fine, f, off);
    kw_bspline_free(fine);
}

enum { COORDINATES = 5 }; /* at most: pairs, and one alone */

/* The coefficients of fine by one knot after the other, from left to right. */
static void one_by_one(const kw_bspline *s, const kw_bspline *fine, int N, double *c)
{
    double finer[COORDINATES * MOST];
    kw_bspline *now = kw_bspline_new_copy(s);

    for (int i = 0; now->n < fine->n; i++) {
        kw_bspline *next;

        if (now->t[i] == fine->t[i])
            continue;
        next = kw_insert_new_knot(now, fine->t[i]);
        kw_insert_boehm(now, fine->t[i], N, c, finer);
        memcpy(c, finer, (size_t)(next->n * N) * sizeof *c);
        kw_bspline_free(now);
        now = next;
    }
    kw_bspline_free(now);
}

/* In one walk they are the same numbers. */
static void all_at_once_is_one_by_one(const kw_bspline *s, kw_rng *r)
{
    double c[COORDINATES * MOST], all[COORDINATES * MOST + GUARD];
    int N = 1 + kw_rng_below(r, COORDINATES), added;
    kw_bspline *fine = refine(r, s, c, &added);

    random_coefficients(r, N * s->n, c);
    poison(all, N * fine->n);
    kw_insert_boehm_all(s, fine, N, c, all);
    CHECK(written(all, N * fine->n), "n = %d", fine->n);
    one_by_one(s, fine, N, c);
    for (int i = 0; i < N * fine->n; i++)
        CHECK(all[i] == c[i], "d = %d, N = %d, %d of %d: %.17g, %.17g", s->d, N, i,
              N * fine->n, all[i], c[i]);
    kw_bspline_free(fine);
}

static int is_open(const kw_bspline *s)
{
    return s->t[0] == s->t[s->d] && s->t[s->n] == s->t[s->n + s->d];
}

/* Open knots: then the auxiliary knots of the halves are the same. */
static void halving_all_at_once(const kw_bspline *s, kw_rng *r)
{
    enum { N = 3 };
    double c[N * MOST], all[N * MOST + GUARD], rows[N * MOST];
    kw_bspline *fine;

    if (!is_open(s))
        return;
    fine = kw_insert_new_dyadic(s);
    random_coefficients(r, N * s->n, c);
    poison(all, N * fine->n);
    kw_insert_boehm_all(s, fine, N, c, all);
    CHECK(written(all, N * fine->n), "n = %d", fine->n);
    kw_insert_oslo(s, fine, N, c, rows);
    for (int i = 0; i < N * fine->n; i++) /* each of at most d knots has averaged it */
        CHECK(fabs(all[i] - rows[i]) <= bound(BOEHM * s->d + oslo(s->d), 1),
              "d = %d, %d: %.17g, %.17g", s->d, i, all[i], rows[i]);
    kw_bspline_free(fine);
}

/* --- Oslo --- */

static void boehm_again_and_again_is_oslo(const kw_bspline *s, kw_rng *r)
{
    double c[MOST], f[MOST], o[MOST + GUARD];
    int added;
    kw_bspline *fine;

    random_coefficients(r, s->n, c);
    memcpy(f, c, sizeof c);
    fine = refine(r, s, f, &added);
    poison(o, fine->n);
    kw_insert_oslo(s, fine, 1, c, o);
    CHECK(written(o, fine->n), "n = %d", fine->n);
    for (int i = 0; i < fine->n; i++)
        CHECK(fabs(f[i] - o[i]) <= bound(BOEHM * added + oslo(s->d), 1),
              "d = %d, %d knots, coefficient %d of %d: %.17g and %.17g", s->d, added, i,
              fine->n, f[i], o[i]);
    check_curve(r, s, c, fine, o, bound(oslo(s->d), 1));
    kw_bspline_free(fine);
}

static void oslo_rows_are_averages(const kw_bspline *s, kw_rng *r)
{
    double unused[MOST] = {0}, alpha[K + GUARD];
    int added;
    kw_bspline *fine[] = {refine(r, s, unused, &added), kw_insert_new_dyadic(s)};

    for (int which = 0; which < 2; which++) {
        for (int i = 0; i < fine[which]->n; i++) {
            double sum = 0;
            int first;

            poison(alpha, s->d + 1);
            first = kw_insert_oslo_row(s, fine[which], i, alpha);
            CHECK(written(alpha, s->d + 1), "row %d", i);
            CHECK(0 <= first && first + s->d < s->n, "first %d of %d", first, s->n);
            for (int j = 0; j <= s->d; j++) {
                CHECK(alpha[j] >= 0, "d = %d, row %d: %g", s->d, i, alpha[j]);
                sum += alpha[j];
            }
            CHECK(fabs(sum - 1) <= bound(6 * s->d + 1, 1), "d = %d: %.17g", s->d, sum);
        }
        kw_bspline_free(fine[which]);
    }
}

/* The refined polygon stays where the coarse one is, coordinate by coordinate. */
static void polygons_stay_in_the_hull(const kw_bspline *s, kw_rng *r)
{
    double c[MOST], f[MOST], o[MOST], low = 1, high = -1, off;
    kw_bspline *fine, *dyadic = kw_insert_new_dyadic(s);
    int added;

    random_coefficients(r, s->n, c);
    memcpy(f, c, sizeof c);
    fine = refine(r, s, f, &added);
    kw_insert_oslo(s, dyadic, 1, c, o);
    for (int i = 0; i < s->n; i++) {
        low = fmin(low, c[i]);
        high = fmax(high, c[i]);
    }
    off = bound(BOEHM * added + oslo(s->d), 1);
    for (int i = 0; i < fine->n; i++)
        CHECK(low - off <= f[i] && f[i] <= high + off, "Boehm: %.17g", f[i]);
    for (int i = 0; i < dyadic->n; i++)
        CHECK(low - off <= o[i] && o[i] <= high + off, "dyadic: %.17g", o[i]);
    check_curve(r, s, c, dyadic, o, bound(oslo(s->d), 1));
    kw_bspline_free(fine);
    kw_bspline_free(dyadic);
}

/* The fine space may have other auxiliary knots. Then blossoms are taken outside the span:
   each of the d steps multiplies the absolute values by at most (|right-u| + |u-left|) /
   (right-left) <= 1 + 2 * 9 here, as right - left >= 1 and no knot is farther away. */
static void auxiliary_knots_are_free(void)
{
    const double coarse_t[] = {-2, -1, -1, 0, 1, 3, 4, 5, 6, 7};
    const double fine_t[] = {-5, -4, -3, 0, 1, 2, 3, 4, 4, 4, 4};
    kw_bspline *s = kw_bspline_new(3, 6, coarse_t), *fine = kw_bspline_new(3, 7, fine_t);
    double c[6], o[7], off = bound(oslo(3), 19 * 19 * 19);
    kw_rng r = kw_rng_at(62, 0, 0, 0);

    random_coefficients(&r, 6, c);
    kw_insert_oslo(s, fine, 1, c, o);
    check_curve(&r, s, c, fine, o, off);
    kw_bspline_free(s);
    kw_bspline_free(fine);
}

/* --- two scales --- */

/* column j of the Oslo matrix by its rows */
static double oslo_entry(const kw_bspline *s, const kw_bspline *fine, int i, int j)
{
    double alpha[K];
    int first = kw_insert_oslo_row(s, fine, i, alpha);

    return first <= j && j <= first + s->d ? alpha[j - first] : 0;
}

/* Values are sums of positive terms: 5d roundings in a function and 5d in a coefficient,
   a product and at most d sums. */
static void check_column(kw_rng *r, const kw_bspline *s, const kw_bspline *fine, int j,
                         int most)
{
    double column[MOST + GUARD], x = test_random_point(r, s), sum = 0;
    int first = -1, count;

    poison(column, MOST);
    count = kw_insert_two_scale(s, fine, j, &first, column);
    CHECK(0 < count && count <= most, "%d coefficients, at most %d", count, most);
    CHECK(written(column, count), "hole among %d coefficients", count);
    for (int i = 0; i < fine->n; i++) {
        double wanted = oslo_entry(s, fine, i, j);
        int inside = first <= i && i < first + count;

        CHECK((inside ? column[i - first] : 0) == wanted, "row %d: %g", i, wanted);
        if (inside)
            sum += column[i - first] * kw_bspline_one(fine, i, 0, x);
    }
    CHECK(fabs(sum - kw_bspline_one(s, j, 0, x)) <= bound(16 * s->d + 2, sum),
          "d = %d, function %d at %.17g: %g, not %g", s->d, j, x, sum,
          kw_bspline_one(s, j, 0, x));
}

static void a_function_is_a_sum_of_finer_ones(const kw_bspline *s, kw_rng *r)
{
    double unused[MOST] = {0};
    int added;
    kw_bspline *fine = refine(r, s, unused, &added), *dyadic = kw_insert_new_dyadic(s);

    for (int j = 0; j < s->n; j++) {
        check_column(r, s, fine, j, s->d + 1 + added);
        check_column(r, s, dyadic, j, is_open(s) ? s->d + 2 : dyadic->n);
    }
    kw_bspline_free(fine);
    kw_bspline_free(dyadic);
}

/* With auxiliary knots of its own a fine space may give a function coefficients below zero,
   and a zero between two others: here, in exact arithmetic, -13/16, 0, 7/16 to begin with; the
   terms of each have a sum of absolute values below 8. */
static void two_scale_on_free_auxiliary_knots(void)
{
    enum { J = 2 };
    const double coarse_t[] = {-9, -1, -1, -1, 0, 1, 3, 3, 4, 5, 6, 7, 8};
    const double fine_t[] = {-7, -6, -2.5, 0, 0, 0.5, 1, 3, 3, 4, 5, 6, 7, 8};
    kw_bspline *s = kw_bspline_new(4, 8, coarse_t), *fine = kw_bspline_new(4, 9, fine_t);
    double column[MOST + GUARD];
    int first = -1, count;

    poison(column, MOST);
    count = kw_insert_two_scale(s, fine, J, &first, column);
    CHECK(written(column, count), "hole among %d coefficients", count);
    CHECK(first == 0 && count > 2, "first %d, count %d", first, count);
    CHECK(fabs(column[0] + 0.8125) <= bound(20, 8), "%.17g", column[0]);
    CHECK(column[1] == 0, "%.17g", column[1]);
    CHECK(fabs(column[2] - 0.4375) <= bound(20, 8), "%.17g", column[2]);
    for (int i = 0; i < fine->n; i++)
        CHECK((i < count ? column[i] : 0) == oslo_entry(s, fine, i, J), "row %d", i);
    kw_bspline_free(s);
    kw_bspline_free(fine);
}

/* --- misuse: spaces for the calls below --- */

static kw_bspline *given, *other;
static double scratch[MOST];

static void oslo_row_of_other(void)
{
    kw_insert_oslo_row(given, other, 0, scratch);
}

static void two_scale_of_other(void)
{
    int first;

    kw_insert_two_scale(given, other, 0, &first, scratch);
}

static void all_of_other(void)
{
    kw_insert_boehm_all(given, other, 1, scratch, scratch);
}

static void nothing_of_other(void)
{
    kw_insert_boehm_all(given, other, 0, scratch, scratch);
}

static void all_at_once_needs_its_knots(void)
{
    const double half[] = {0, 0, 0.5, 1, 1}, third[] = {0, 0, 0.25, 0.75, 1, 1};
    const double outside[] = {-1, 0, 0.5, 1, 1};

    given = kw_bspline_new(1, 3, half);
    other = kw_bspline_new(1, 4, third);
    test_aborts("the coarse knot 0.5 (t[2]) is missing", all_of_other);
    test_aborts("N = 0", nothing_of_other);
    kw_bspline_free(other);
    other = kw_bspline_new(1, 3, outside);
    test_aborts("other auxiliary knots: 0 and -1", all_of_other);
    kw_bspline_free(other);
    other = kw_bspline_new_open_uniform(2, 6, 0, 1);
    test_aborts("degrees 1 and 2", all_of_other);
    kw_bspline_free(other);
    other = kw_bspline_new_open_uniform(1, 1, 0, 1); /* coarser than given */
    test_aborts("the coarse knot 0.5 (t[2]) is missing", all_of_other);
    kw_bspline_free(other);
    kw_bspline_free(given);
}

static void other_degree_or_domain(void)
{
    given = kw_bspline_new_open_uniform(2, 3, 0, 1);
    other = kw_bspline_new_open_uniform(3, 6, 0, 1);
    test_aborts("degrees 2 and 3", oslo_row_of_other);
    test_aborts("degrees 2 and 3", two_scale_of_other);
    kw_bspline_free(other);
    other = kw_bspline_new_open_uniform(2, 6, 0, 2);
    test_aborts("domains [0, 1] and [0, 2]", oslo_row_of_other);
    test_aborts("domains [0, 1] and [0, 2]", two_scale_of_other);
    kw_bspline_free(other);
    other = kw_bspline_new_open_uniform(2, 6, -2, 1);
    test_aborts("domains [0, 1] and [-2, 1]", two_scale_of_other);
    kw_bspline_free(other);
    kw_bspline_free(given);
}

static void uniform_coefficients_are_binomial(void)
{
    const double scaled[3][6] = {{1, 2, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}};
    const int degree[] = {1, 3, 4};

    for (int which = 0; which < 3; which++) {
        int d = degree[which], first;
        kw_bspline *s = kw_bspline_new_uniform(d, 8, 0, 8);
        kw_bspline *fine = kw_insert_new_dyadic(s);
        double column[MOST];

        for (int j = d; j + d < s->n; j++) { /* support inside the domain */
            int count = kw_insert_two_scale(s, fine, j, &first, column);

            CHECK(count == d + 2, "d = %d: %d", d, count);
            CHECK(first == 2 * j - d, "d = %d: first %d for %d", d, first, j);
            for (int i = 0; i < count && i < 6; i++) {
                double wanted = ldexp(scaled[which][i], -d);

                CHECK(fabs(column[i] - wanted) <= bound(5 * d, wanted), "d = %d: %.17g",
                      d, column[i]);
            }
        }
        kw_bspline_free(s);
        kw_bspline_free(fine);
    }
}

int main(void)
{
    run_over_spaces("insert: Boehm leaves the curve where it is", HIGHEST,
                    boehm_keeps_the_curve);
    run_over_spaces("insert: coordinates do not mix", HIGHEST,
                    coordinates_are_independent);
    run_over_spaces("insert: a knot k times leaves both sides where they are", HIGHEST,
                    a_full_knot_keeps_both_sides);
    run_over_spaces("insert: all knots at once are one after the other, to the bit",
                    HIGHEST, all_at_once_is_one_by_one);
    run_over_spaces("insert: halving all at once is Oslo", HIGHEST, halving_all_at_once);
    test_run("insert: all at once needs every coarse knot, the auxiliary ones too",
             all_at_once_needs_its_knots);
    run_over_spaces("insert: Boehm again and again is Oslo", HIGHEST,
                    boehm_again_and_again_is_oslo);
    run_over_spaces("insert: rows of the Oslo matrix are averages", HIGHEST,
                    oslo_rows_are_averages);
    run_over_spaces("insert: refined polygons stay in the hull", HIGHEST,
                    polygons_stay_in_the_hull);
    test_run("insert: auxiliary knots are the fine space's own affair",
             auxiliary_knots_are_free);
    run_over_spaces("insert: a function is a sum of finer ones", HIGHEST,
                    a_function_is_a_sum_of_finer_ones);
    test_run("insert: uniform two-scale coefficients are binomial",
             uniform_coefficients_are_binomial);
    test_run("insert: two scales on free auxiliary knots, zeros and signs",
             two_scale_on_free_auxiliary_knots);
    test_run("insert: rows and columns need one degree and domain",
             other_degree_or_domain);
    return test_end();
}
