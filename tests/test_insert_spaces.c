#include "insert.h"
#include "spline.h"
#include <stdlib.h>

/* --- dyadic spaces --- */

static void check_equal(const kw_bspline *a, const kw_bspline *b)
{
    CHECK(a->d == b->d && a->n == b->n, "d = %d and %d, n = %d and %d", a->d, b->d, a->n,
          b->n);
    for (int i = 0; a->n == b->n && i <= a->n + a->d; i++)
        CHECK(a->t[i] == b->t[i], "t[%d] = %.17g and %.17g", i, a->t[i], b->t[i]);
}

/* Knots and middles in order; the domain ends where it did, with the d next on each side. */
static void dyadic_knots_are_knots_and_middles(const kw_bspline *s, kw_rng *r)
{
    kw_bspline *fine = kw_insert_new_dyadic(s);
    int j = fine->d; /* the fine knot that is looked at */

    (void)r;
    for (int i = s->d; i < s->n; i++) {
        CHECK(fine->t[j++] == s->t[i], "t[%d] = %.17g", j - 1, fine->t[j - 1]);
        if (s->t[i] < s->t[i + 1]) {
            double middle = s->t[i] + (s->t[i + 1] - s->t[i]) / 2;

            CHECK(fine->t[j++] == middle, "t[%d] = %.17g", j - 1, fine->t[j - 1]);
        }
    }
    CHECK(j == fine->n && fine->t[j] == s->t[s->n], "n = %d and %d", fine->n, j);
    for (int side = -1; side <= 1; side += 2) {
        int i = side < 0 ? s->d : s->n, at = side < 0 ? fine->d : fine->n;

        for (int left = s->d; left > 0; i += side) {
            if (s->t[i] != s->t[i + side]) {
                double low = fmin(s->t[i], s->t[i + side]);

                at += side;
                left--;
                CHECK(fine->t[at] == low + fabs(s->t[i] - s->t[i + side]) / 2,
                      "middle t[%d] = %.17g", at, fine->t[at]);
            }
            if (left-- > 0) {
                at += side;
                CHECK(fine->t[at] == s->t[i + side], "t[%d] = %.17g", at, fine->t[at]);
            }
        }
    }
    kw_insert_need_nested(s, fine);
    kw_bspline_free(fine);
}

/* Families with a name are closed under halving; all numbers are exact. */
static void dyadic_families_stay_families(void)
{
    const double tau[] = {0, 1, 3, 4, 8}, halved[] = {0, 0.5, 1, 2, 3, 3.5, 4, 6, 8};
    const int mu[] = {1, 2, 1}, mu_halved[] = {1, 1, 1, 2, 1, 1, 1};

    for (int d = 1; d <= 6; d++) { /* a knot twice needs d >= 1 */
        kw_bspline *coarse[] = {
            kw_bspline_new_open_uniform(d, 5, 0, 5), kw_bspline_new_uniform(d, 5, -1, 4),
            kw_bspline_new_open(d, 4, tau, mu), kw_bspline_new_periodic(d, 4, tau, mu)};
        kw_bspline *wanted[] = {kw_bspline_new_open_uniform(d, 10, 0, 5),
                                kw_bspline_new_uniform(d, 10, -1, 4),
                                kw_bspline_new_open(d, 8, halved, mu_halved),
                                kw_bspline_new_periodic(d, 8, halved, mu_halved)};

        for (int i = 0; i < 4; i++) {
            kw_bspline *fine = kw_insert_new_dyadic(coarse[i]);

            check_equal(fine, wanted[i]);
            kw_insert_need_nested(coarse[i], fine);
            kw_bspline_free(fine);
            kw_bspline_free(coarse[i]);
            kw_bspline_free(wanted[i]);
        }
    }
}

/* --- what aborts --- */

static const double T[] = {0, 0, 0, 0.5, 0.75, 0.75, 0.75, 1, 1, 1}; /* d = 2 */

/* Inserts x into the space on T; the process that calls it ends here. */
static void insert(double x)
{
    kw_bspline *s = kw_bspline_new(2, 7, T);

    kw_bspline_free(kw_insert_new_knot(s, x));
    kw_bspline_free(s);
}

static void insert_before(void)
{
    insert(-0.25);
}

static void insert_behind(void)
{
    insert(1.25);
}

static void insert_at_the_left_end(void)
{
    insert(0);
}

static void insert_at_the_right_end(void)
{
    insert(1);
}

static void insert_nan(void)
{
    insert(NAN);
}

static void insert_too_often(void)
{
    insert(0.75);
}

static void boehm_at_the_end(void)
{
    kw_bspline *s = kw_bspline_new(2, 7, T);
    double c[7] = {0}, fine[8];

    kw_insert_boehm(s, 1, 1, c, fine);
}

static void misplaced_knots_abort(void)
{
    test_aborts("x = -0.25 outside the domain [0, 1]", insert_before);
    test_aborts("x = 1.25 outside the domain [0, 1]", insert_behind);
    test_aborts("x = 0 is not inside [0, 1]", insert_at_the_left_end);
    test_aborts("x = 1 is not inside [0, 1]", insert_at_the_right_end);
    test_aborts("x = nan", insert_nan);
    test_aborts("knot 0.75 appears more than 3 times", insert_too_often);
    test_aborts("x = 1 is not inside [0, 1]", boehm_at_the_end);
}

/* From the space on T to one of degree d on n + d + 1 knots t. */
static void need_nested(int d, int n, const double *t)
{
    kw_insert_need_nested(kw_bspline_new(2, 7, T), kw_bspline_new(d, n, t));
}

static void nest_without_a_knot(void)
{
    const double t[] = {0, 0, 0, 0.75, 0.75, 0.75, 0.8, 1, 1, 1};

    need_nested(2, 7, t);
}

static void nest_with_one_copy_less(void)
{
    const double t[] = {0, 0, 0, 0.5, 0.75, 0.75, 0.8, 0.9, 1, 1, 1};

    need_nested(2, 8, t);
}

static void nest_another_degree(void)
{
    const double t[] = {0, 0, 0.5, 0.75, 1, 1};

    need_nested(1, 4, t);
}

static void nest_another_domain(void)
{
    const double t[] = {0, 0, 0, 0.5, 0.75, 0.75, 0.75, 2, 2, 2};

    need_nested(2, 7, t);
}

static void oslo_into_a_coarser_space(void)
{
    const double t[] = {0, 0, 0, 1, 1, 1};
    double c[7] = {0}, out[3];

    kw_insert_oslo(kw_bspline_new(2, 7, T), kw_bspline_new(2, 3, t), 1, c, out);
}

static void spaces_that_are_not_nested_abort(void)
{
    test_aborts("the coarse knot 0.5 (t[3]) is missing", nest_without_a_knot);
    test_aborts("the coarse knot 0.75 (t[6]) is missing", nest_with_one_copy_less);
    test_aborts("degrees 2 and 1", nest_another_degree);
    test_aborts("domains [0, 1] and [0, 2]", nest_another_domain);
    test_aborts("the coarse knot 0.5 (t[3]) is missing", oslo_into_a_coarser_space);
}

static void row_out_of_range(void)
{
    kw_bspline *s = kw_bspline_new(2, 7, T);
    double alpha[3];

    kw_insert_oslo_row(s, s, 7, alpha);
}

static void column_out_of_range(void)
{
    kw_bspline *s = kw_bspline_new(2, 7, T);
    double column[7];
    int first;

    kw_insert_two_scale(s, s, -1, &first, column);
}

static void halve_a_span_of_two_neighbours(void)
{
    const double t[] = {0, 1, nextafter(1, 2)};

    kw_insert_new_dyadic(kw_bspline_new(0, 2, t));
}

static void indices_out_of_range_abort(void)
{
    test_aborts("function 7, not in 0 .. 6", row_out_of_range);
    test_aborts("function -1, not in 0 .. 6", column_out_of_range);
}

static void a_span_without_a_middle_aborts(void)
{
    test_aborts("no number between the knots 1 and 1.0000000000000002",
                halve_a_span_of_two_neighbours);
}

int main(void)
{
    run_over_spaces("insert: dyadic knots are the knots and the middles of the spans", 6,
                    dyadic_knots_are_knots_and_middles);
    test_run("insert: open, uniform and periodic spaces stay so when halved",
             dyadic_families_stay_families);
    test_run("insert: knots outside, at the ends or too often abort",
             misplaced_knots_abort);
    test_run("insert: spaces that are not nested abort and name the missing knot",
             spaces_that_are_not_nested_abort);
    test_run("insert: indices out of range abort", indices_out_of_range_abort);
    test_run("insert: a span without a middle aborts", a_span_without_a_middle_aborts);
    return test_end();
}
