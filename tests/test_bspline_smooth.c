/* Smoothness at the knots, and blossoms, by property over random spaces. */
#include "spline.h"

/* --- smoothness: at a knot as smooth as its multiplicity m in the function's own knots
   says, derivatives up to d-m continuous and the next one not --- */

static int own_multiplicity(const kw_bspline *s, int j, double z)
{
    int m = 0;

    for (int i = j; i <= j + s->d + 1; i++)
        m += s->t[i] == z;
    return m;
}

/* By how much the derivative of order q = d-m+1 of beta_j jumps at z. beta_j is
   (t[j+k] - t[j]) times the divided difference at its own knots y of (y - x)_+^d, and that
   has the q-th derivative's jump -(-1)^q d! in the term 1/(m-1)! / prod of (z - t[i]) over
   the knots t[i] other than z. At most 3(d+3) + 2d roundings. */
static double known_jump(const kw_bspline *s, int j, double z, int m)
{
    int d = s->d;
    double jump =
        (d - m) % 2 == 0 ? s->t[j + d + 1] - s->t[j] : s->t[j] - s->t[j + d + 1];

    for (int i = j; i <= j + d + 1; i++)
        if (s->t[i] != z)
            jump /= z - s->t[i];
    for (int p = m; p <= d; p++) /* d! / (m-1)! */
        jump *= p;
    return jump;
}

/* the rows of the derivatives on a span, as one function of the whole space sees them */
typedef struct side {
    int span;
    double value[ROOM], size[ROOM];
} side;

static void side_at(const kw_bspline *s, int span, double z, side *a)
{
    a->span = span;
    kw_bspline_derivatives_on(s, span, z, s->d, a->value);
    for (int q = 0; q <= s->d; q++)
        derivative_size(s, span, z, q, a->size + q * (s->d + 1));
}

static double entry(const double *rows, const side *a, int d, int j, int q)
{
    int l = j - (a->span - d);

    return 0 <= l && l <= d ? rows[q * (d + 1) + l] : 0;
}

static void compare_sides(const kw_bspline *s, double z, const side *left,
                          const side *right)
{
    int d = s->d;

    for (int j = left->span - d; j <= right->span; j++) {
        int m = own_multiplicity(s, j, z);
        double known = m > 0 ? known_jump(s, j, z, m) : 0;

        for (int q = 0; q <= d - m + 1 && q <= d; q++) {
            double jump =
                entry(right->value, right, d, j, q) - entry(left->value, left, d, j, q);
            double error = bound(5 * d + 1, entry(right->size, right, d, j, q) +
                                                entry(left->size, left, d, j, q));
            double expected = q == d - m + 1 ? known : 0;

            error += bound(5 * d + 9, fabs(expected));
            CHECK(fabs(jump - expected) <= error,
                  "d = %d, function %d, knot %.17g (%d times), derivative %d: %g, %g", d,
                  j, z, m, q, jump, expected);
        }
        CHECK(m == 0 || known != 0, "d = %d, function %d, knot %.17g", d, j, z);
    }
}

static void smoothness(const kw_bspline *s, kw_rng *r)
{
    side left, right;

    (void)r;
    for (int i = s->d; i < s->n; i++) {
        double z = s->t[i + 1];

        if (s->t[i] == z || z == s->t[s->n])
            continue;
        side_at(s, i, z, &left);
        side_at(s, kw_bspline_span(s, z), z, &right);
        compare_sides(s, z, &left, &right);
    }
}

/* On knots 0, 1, 2, .. of small multiplicities the jump is far above all rounding, so the
   first discontinuous derivative shows as such. */
static void first_jump_shows(void)
{
    const double tau[] = {0, 1, 2, 3};
    side left, right;

    for (int d = 0; d <= 6; d++)
        for (int m = 1; m <= d + 1; m++) {
            kw_bspline *s = kw_bspline_new_open(d, 3, tau, (int[]){m, 1});
            int i = kw_bspline_span(s, 1);

            side_at(s, d, 1, &left);
            side_at(s, i, 1, &right);
            for (int j = 0; j < s->n; j++) {
                int own = own_multiplicity(s, j, 1), q = d - own + 1;
                double jump = q > d ? 1
                                    : entry(right.value, &right, d, j, q) -
                                          entry(left.value, &left, d, j, q);

                CHECK(fabs(jump) > 0.01, "d = %d, m = %d, function %d: %g", d, m, j,
                      jump);
            }
            kw_bspline_free(s);
        }
}

/* --- blossoms --- */

static void random_arguments(kw_rng *r, const kw_bspline *s, double *u)
{
    for (int p = 0; p < s->d; p++)
        u[p] = random_dyadic(r);
}

static void checked_blossom(const kw_bspline *s, int i, const double *u, double *value)
{
    poison(value, s->d + 1);
    kw_bspline_blossom(s, i, u, value);
    CHECK(written(value, s->d + 1), "d = %d", s->d);
}

static void blossom_is_symmetric(const kw_bspline *s, kw_rng *r)
{
    double u[K], first[ROOM], second[ROOM], size1[K], size2[K];
    int i = random_span(r, s), d = s->d;

    random_arguments(r, s, u);
    checked_blossom(s, i, u, first);
    blossom_size(s, i, u, 0, size1);
    for (int p = d - 1; p > 0; p--) { /* shuffle */
        int other = kw_rng_below(r, p + 1);
        double kept = u[p];

        u[p] = u[other];
        u[other] = kept;
    }
    checked_blossom(s, i, u, second);
    blossom_size(s, i, u, 0, size2);
    for (int j = 0; j <= d; j++)
        CHECK(fabs(first[j] - second[j]) <= bound(5 * d, size1[j] + size2[j]),
              "d = %d, weight %d: %g, %g", d, j, first[j], second[j]);
}

/* f(.., a + w (b-a), ..) = (1-w) f(.., a, ..) + w f(.., b, ..), where w is a multiple of
   1/4 and so all arguments are exact; three more roundings for the right side. */
static void blossom_is_affine(const kw_bspline *s, kw_rng *r)
{
    double u[K], at_a[ROOM], at_b[ROOM], between[ROOM], size_a[K], size_b[K], size[K];
    int i = random_span(r, s), d = s->d;

    for (int p = 0; p < d; p++) {
        double a = random_dyadic(r), b = random_dyadic(r);
        double w = (kw_rng_below(r, 17) - 8) / 4.0;

        random_arguments(r, s, u);
        u[p] = a;
        checked_blossom(s, i, u, at_a);
        blossom_size(s, i, u, 0, size_a);
        u[p] = b;
        checked_blossom(s, i, u, at_b);
        blossom_size(s, i, u, 0, size_b);
        u[p] = a + w * (b - a);
        checked_blossom(s, i, u, between);
        blossom_size(s, i, u, 0, size);
        for (int j = 0; j <= d; j++) {
            double mean = (1 - w) * at_a[j] + w * at_b[j];
            double all = fabs(1 - w) * size_a[j] + fabs(w) * size_b[j] + size[j];

            CHECK(fabs(between[j] - mean) <= bound(5 * d + 3, all),
                  "d = %d, argument %d, weight %d: %g, %g", d, p, j, between[j], mean);
        }
    }
}

static void blossom_on_the_diagonal(const kw_bspline *s, kw_rng *r)
{
    double u[K], value[ROOM], basis[K];

    for (int point = 0; point < 10; point++) {
        double x = test_random_point(r, s);
        int i = kw_bspline_span(s, x), d = s->d;

        for (int p = 0; p < d; p++)
            u[p] = x;
        checked_blossom(s, i, u, value);
        kw_bspline_basis(s, x, basis);
        for (int j = 0; j <= d; j++)
            CHECK(fabs(value[j] - basis[j]) <= bound(10 * d, basis[j]), "%d at %.17g", j,
                  x);
    }
}

/* The arguments t[j+1] .. t[j+d] give coefficient j: weight 1, and 0 for all others. */
static void blossom_is_dual(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], size[K];
    int i = random_span(r, s), d = s->d;

    for (int j = i - d; j <= i; j++) {
        checked_blossom(s, i, s->t + j + 1, value);
        blossom_size(s, i, s->t + j + 1, 0, size);
        for (int l = 0; l <= d; l++)
            CHECK(fabs(value[l] - (l == j - (i - d))) <= bound(5 * d, size[l]),
                  "d = %d, function %d, weight %d: %g", d, j, l, value[l]);
    }
}

/* --- blossoms at increasing arguments --- */

/* The increasing arguments in the order that the header promises: first those up to the
   span, from it to the left, then the others to the right. */
static void order_outwards(const kw_bspline *s, int i, const double *u, double *outwards)
{
    int count = 0;

    for (int p = s->d - 1; p >= 0; p--)
        if (u[p] <= s->t[i])
            outwards[count++] = u[p];
    for (int p = 0; p < s->d; p++)
        if (u[p] > s->t[i])
            outwards[count++] = u[p];
}

static void knots_blossom_is_the_blossom(const kw_bspline *s, kw_rng *r)
{
    double u[K] = {0}, outwards[K] = {0}, value[ROOM], other[ROOM], size1[K], size2[K];
    int i = random_span(r, s), d = s->d;

    u[0] = random_dyadic(r);
    for (int p = 1; p < d; p++) /* one in four is repeated */
        u[p] = u[p - 1] + kw_rng_below(r, 4) * 0.25;
    order_outwards(s, i, u, outwards);
    blossom_size(s, i, outwards, 0, size1);
    blossom_size(s, i, u, 0, size2);
    poison(value, d + 1);
    kw_bspline_blossom_knots(s, i, u, value);
    CHECK(written(value, d + 1), "d = %d", d);
    kw_bspline_blossom(s, i, u, other);
    for (int j = 0; j <= d; j++)
        CHECK(fabs(value[j] - other[j]) <= bound(5 * d, size1[j] + size2[j]),
              "d = %d, weight %d: %g, %g", d, j, value[j], other[j]);
}

/* All knots of s and one more between each two: between any arguments in a row no knot of s
   is left out, so no weight is negative, nothing cancels, and the error of each is relative:
   the sum of the weights is 1 to 6d roundings. */
static void knots_blossom_cancels_nothing(const kw_bspline *s, kw_rng *r)
{
    double fine[24 * K] = {0}, value[ROOM];
    int d = s->d, count = 0;

    for (int i = 0; i <= s->n + d; i++) {
        fine[count++] = s->t[i];
        if (i < s->n + d && s->t[i] < s->t[i + 1])
            fine[count++] = test_random_in(r, s->t[i], s->t[i + 1]);
    }
    for (int j = 0; j + d < count; j++) {
        double sum = 0;

        if (fine[j] < s->t[d] || fine[j] >= s->t[s->n])
            continue;
        kw_bspline_blossom_knots(s, kw_bspline_span(s, fine[j]), fine + j + 1, value);
        for (int l = 0; l <= d; l++) {
            CHECK(value[l] >= 0, "d = %d, weight %d: %g", d, l, value[l]);
            sum += value[l];
        }
        CHECK(fabs(sum - 1) <= bound(6 * d, 1), "d = %d: %.17g", d, sum);
    }
}

/* The knots of s themselves give weight 1 within rounding, and exactly 0 otherwise. */
static void knots_blossom_is_dual(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM];
    int i = random_span(r, s), d = s->d;

    for (int j = i - d; j <= i; j++) {
        kw_bspline_blossom_knots(s, i, s->t + j + 1, value);
        for (int l = 0; l <= d; l++)
            CHECK(fabs(value[l] - (l == j - (i - d))) <= bound(5 * d, l == j - (i - d)),
                  "d = %d, function %d, weight %d: %g", d, j, l, value[l]);
    }
}

int main(void)
{
    run_over_spaces("bspline: smooth of order d - multiplicity, then a known jump", 6,
                    smoothness);
    run_over_spaces("bspline: so at degrees up to 31", KW_BSPLINE_DEGREE, smoothness);
    test_run("bspline: the first discontinuous derivative does jump", first_jump_shows);
    run_over_spaces("bspline: a blossom is symmetric", 8, blossom_is_symmetric);
    run_over_spaces("bspline: a blossom is affine in each argument", 8,
                    blossom_is_affine);
    run_over_spaces("bspline: a blossom is the basis on the diagonal", KW_BSPLINE_DEGREE,
                    blossom_on_the_diagonal);
    run_over_spaces("bspline: a blossom at d knots in a row is one coefficient", 8,
                    blossom_is_dual);
    run_over_spaces("bspline: at increasing arguments it is the same blossom", 8,
                    knots_blossom_is_the_blossom);
    run_over_spaces("bspline: at the knots of a finer space nothing cancels in it",
                    KW_BSPLINE_DEGREE, knots_blossom_cancels_nothing);
    run_over_spaces("bspline: at its own knots it is one coefficient and no other",
                    KW_BSPLINE_DEGREE, knots_blossom_is_dual);
    return test_end();
}
