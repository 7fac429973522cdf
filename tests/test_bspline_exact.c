/* B-splines against exact fractions: degrees 0 .. 4, knots at halves, every multiplicity,
   auxiliary knots of three kinds, points at quarters of the knots' grid. Knots and points
   are exact in a double, so all rounding is the program's: 5d roundings of terms whose
   absolute values have the known sum (spline.h), and one for turning the fraction into a
   double. */
#include "rational.h"
#include "spline.h"

enum { HIGHEST = 4, KNOTS = 4 * (HIGHEST + 1), STEPS = 8 /* points in [j, j+1) */ };

typedef struct exact {
    int d, n;
    rational t[KNOTS];
    kw_bspline *s;
} exact;

/* the distances, in halves, of one auxiliary knot from the one before, in turn */
static const int AUXILIARY[3][2] = {{0, 0}, {2, 3}, {0, 3}};

/* Interior knots at 1/2 and 2, the domain [0,3]. */
static exact exact_new(int d, int m1, int m2, const int *auxiliary)
{
    exact e = {.d = d, .n = d + 1 + m1 + m2};
    double t[KNOTS];
    int half[KNOTS], last = d;

    half[last] = 0;
    for (int i = 0; i < m1; i++)
        half[++last] = 1;
    for (int i = 0; i < m2; i++)
        half[++last] = 4;
    half[++last] = 6;
    for (int i = 1; i <= d; i++) {
        half[d - i] = half[d - i + 1] - auxiliary[i % 2];
        half[last + i] = half[last + i - 1] + auxiliary[i % 2];
    }
    for (int i = 0; i <= e.n + d; i++) {
        e.t[i] = rational_new(half[i], 2);
        t[i] = half[i] / 2.0;
    }
    e.s = kw_bspline_new(d, e.n, t);
    return e;
}

/* The exact value as a double; the right end of the domain from the left. */
static double exact_value(const exact *e, int j, int r, rational x, int from_left)
{
    return rational_double(rational_bspline(e->t + j, e->d, r, x, from_left));
}

/* Compares rows 0 .. d+1 of derivatives on span i with the exact ones. */
static void compare_rows(const exact *e, int i, rational x, int from_left,
                         const double *row)
{
    double size[K];

    for (int q = 0; q <= e->d + 1; q++) {
        derivative_size(e->s, i, rational_double(x), q, size);
        for (int l = 0; l <= e->d; l++) {
            double want = exact_value(e, i - e->d + l, q, x, from_left);
            double got = row[q * (e->d + 1) + l];

            CHECK(fabs(got - want) <= bound(5 * e->d + 1, size[l]),
                  "d = %d, derivative %d, function %d at %lld/%lld: %.17g, %.17g", e->d,
                  q, i - e->d + l, x.p, x.q, got, want);
        }
    }
}

static void basis_and_derivatives(const exact *e)
{
    double value[ROOM], basis[K], size[K];
    int d = e->d;

    for (int p = 0; p <= 3 * STEPS; p++) {
        rational x = rational_new(p, STEPS);
        double at = rational_double(x);
        int i = kw_bspline_derivatives(e->s, at, d + 1, value) + d;

        compare_rows(e, i, x, p == 3 * STEPS, value);
        kw_bspline_basis(e->s, at, basis);
        derivative_size(e->s, i, at, 0, size);
        for (int l = 0; l <= d; l++)
            CHECK(fabs(basis[l] - exact_value(e, i - d + l, 0, x, p == 3 * STEPS)) <=
                      bound(5 * d + 1, size[l]),
                  "d = %d, function %d at %d/%d: %.17g", d, i - d + l, p, STEPS,
                  basis[l]);
    }
}

static void both_ends_of_each_span(const exact *e)
{
    double value[ROOM];
    int d = e->d;

    for (int i = d; i < e->n; i++) {
        double left = e->s->t[i], right = e->s->t[i + 1];

        if (left == right)
            continue;
        kw_bspline_derivatives_on(e->s, i, left, d + 1, value);
        compare_rows(e, i, e->t[i], 0, value);
        kw_bspline_derivatives_on(e->s, i, right, d + 1, value);
        compare_rows(e, i, e->t[i + 1], 1, value);
    }
}

/* One function at every point from before the first knot to behind the last. */
static void one_function(const exact *e)
{
    for (int p = -5 * STEPS; p <= 8 * STEPS; p += 2) {
        rational x = rational_new(p, STEPS);
        int from_left = p == 3 * STEPS;

        for (int j = 0; j < e->n; j++)
            for (int q = 0; q <= e->d + 1; q++) {
                rational size = rational_terms(e->t + j, e->d, q, x, from_left, 1);
                double want = exact_value(e, j, q, x, from_left);
                double got = kw_bspline_one(e->s, j, q, rational_double(x));

                CHECK(fabs(got - want) <= bound(5 * e->d + 1, rational_double(size)),
                      "d = %d, derivative %d, function %d at %d/%d: %.17g, %.17g", e->d,
                      q, j, p, STEPS, got, want);
            }
    }
}

/* piece[q] = width^q / q! times the q-th derivative at the span's left end: three more
   roundings for each power and one for the product. */
static void pieces(const exact *e)
{
    double piece[ROOM], size[K] = {0};
    int d = e->d;

    for (int i = d; i < e->n; i++) {
        rational scale = {1, 1};

        if (e->s->t[i] == e->s->t[i + 1])
            continue;
        kw_bspline_pieces(e->s, i, piece);
        for (int q = 0; q <= d; q++) {
            derivative_size(e->s, i, e->s->t[i], q, size);
            for (int l = 0; l <= d; l++) {
                rational want = rational_bspline(e->t + i - d + l, d, q, e->t[i], 0);
                double got = piece[l * (d + 1) + q];
                double error = bound(8 * d + 2, rational_double(scale) * size[l]);

                want = rational_mul(scale, want);
                CHECK(fabs(got - rational_double(want)) <= error,
                      "d = %d, function %d, u^%d: %.17g, %lld/%lld", d, i - d + l, q, got,
                      want.p, want.q);
            }
            scale = rational_mul(scale, rational_sub(e->t[i + 1], e->t[i]));
            scale = rational_div(scale, (rational){q + 1, 1});
        }
    }
}

static void greville(const exact *e)
{
    for (int j = 0; j < e->n; j++) {
        rational sum = {0, 1};
        double want, got = kw_bspline_greville(e->s, j);

        if (e->d == 0) /* the middle */
            sum = rational_div(rational_add(e->t[j], e->t[j + 1]), (rational){2, 1});
        for (int i = 1; i <= e->d; i++)
            sum = rational_add(sum, e->t[j + i]);
        if (e->d > 0)
            sum = rational_div(sum, (rational){e->d, 1});
        want = rational_double(sum);
        /* sums of halves are exact: the quotient is the only rounding, in both */
        CHECK(got == want, "d = %d, function %d: %.17g, %.17g", e->d, j, got, want);
    }
}

/* --- over all the spaces --- */

static void over_exact_spaces(void (*holds)(const exact *e))
{
    for (int d = 0; d <= HIGHEST; d++)
        for (int m1 = 1; m1 <= d + 1; m1++)
            for (int m2 = 1; m2 <= d + 1; m2++)
                for (int kind = 0; kind < 3; kind++) {
                    exact e = exact_new(d, m1, m2, AUXILIARY[kind]);

                    holds(&e);
                    kw_bspline_free(e.s);
                }
}

static void exact_basis(void)
{
    over_exact_spaces(basis_and_derivatives);
}

static void exact_ends(void)
{
    over_exact_spaces(both_ends_of_each_span);
}

static void exact_one(void)
{
    over_exact_spaces(one_function);
}

static void exact_pieces(void)
{
    over_exact_spaces(pieces);
}

static void exact_greville(void)
{
    over_exact_spaces(greville);
}

/* The fractions themselves: the quadratic on 0, 1, 2, 3 is 1/8, 3/4, 1/8 at the middles. */
static void fractions(void)
{
    const rational t[] = {{0, 1}, {1, 1}, {2, 1}, {3, 1}};
    const rational want[] = {{1, 8}, {3, 4}, {1, 8}};
    rational got =
        rational_add(rational_new(2, -4), rational_div((rational){1, 1}, t[3]));

    CHECK(got.p == -1 && got.q == 6, "%lld/%lld", got.p, got.q);
    for (int i = 0; i < 3; i++) {
        got = rational_bspline(t, 2, 0, rational_new(2 * i + 1, 2), 0);
        CHECK(got.p == want[i].p && got.q == want[i].q, "%lld/%lld", got.p, got.q);
    }
}

static void fraction_too_long(void)
{
    rational_mul((rational){LLONG_MAX, 1}, (rational){2, 1});
}

static void overflow_aborts(void)
{
    test_aborts("9223372036854775807 * 2", fraction_too_long);
}

int main(void)
{
    test_run("rational: sums, quotients and a quadratic B-spline", fractions);
    test_run("rational: what does not fit aborts", overflow_aborts);
    test_run("bspline: values and derivatives are the exact fractions", exact_basis);
    test_run("bspline: so they are at both ends of each span", exact_ends);
    test_run("bspline: so is one function, in the domain and outside", exact_one);
    test_run("bspline: so are the polynomial pieces", exact_pieces);
    test_run("bspline: so are the Greville points", exact_greville);
    return test_end();
}
