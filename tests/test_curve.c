/* Spline curves: two ways to a point, blossoms, derivatives, and what a curve inherits from
   its control points.

   Roundings. A sum of d+1 products of the local functions has 5d of the functions and d+1
   of its own. In a step of de Boor's algorithm the weight w = (u - left) / (right - left)
   has three and 1-w one more, but of terms 1 and w; the two products and the sum bring the
   error of a step to at most 8 u (|1-w| + |w|) times the size of what it averages. Where
   all weights are in [0,1] that is at most 8d u times the largest coefficient. */
#include "curve.h"
#include "spline.h"

enum { N = 3, COEFFICIENTS = 12 * K * N, POINTS = 20 };

static double c[COEFFICIENTS]; /* the control points of the curve under test */

static void random_coefficients(kw_rng *r, const kw_bspline *s)
{
    for (int i = 0; i < s->n * N; i++)
        c[i] = test_random_in(r, -5, 5);
}

/* the smallest and largest coordinate a of the control points first .. first+d */
static void local_range(const kw_bspline *s, int first, int a, double *low, double *high)
{
    *low = *high = c[first * N + a];
    for (int j = first; j <= first + s->d; j++) {
        *low = fmin(*low, c[j * N + a]);
        *high = fmax(*high, c[j * N + a]);
    }
}

/* --- points --- */

/* The sum over all functions, each by itself; de Boor; and the convex hull. */
static void point_is_the_sum(const kw_bspline *s, kw_rng *r)
{
    double point[N + GUARD], deboor[N + GUARD], low, high;
    int d = s->d;

    random_coefficients(r, s);
    for (int p = 0; p < POINTS; p++) {
        double x = test_random_point(r, s);

        poison(point, N);
        poison(deboor, N);
        kw_curve_point(s, N, c, x, point);
        kw_curve_deboor(s, N, c, x, deboor);
        CHECK(written(point, N) && written(deboor, N), "d = %d", d);
        for (int a = 0; a < N; a++) {
            double sum = 0, largest;

            local_range(s, kw_bspline_span(s, x) - d, a, &low, &high);
            largest = fmax(fabs(low), fabs(high));
            for (int j = 0; j < s->n; j++)
                sum += c[j * N + a] * kw_bspline_one(s, j, 0, x);
            CHECK(fabs(point[a] - sum) <= bound(12 * d + 2, largest),
                  "d = %d, x = %.17g: %.17g, %.17g", d, x, point[a], sum);
            CHECK(fabs(point[a] - deboor[a]) <= bound(14 * d + 1, largest),
                  "d = %d, x = %.17g: %.17g, de Boor %.17g", d, x, point[a], deboor[a]);
            low -= bound(6 * d + 1, largest);
            high += bound(6 * d + 1, largest);
            CHECK(low <= point[a] && point[a] <= high,
                  "d = %d, %.17g outside [%.17g, %.17g]", d, point[a], low, high);
        }
    }
}

static void check_end(const kw_bspline *s, double x, const double *control)
{
    double point[N], deboor[N];

    kw_curve_point(s, N, c, x, point);
    kw_curve_deboor(s, N, c, x, deboor);
    for (int a = 0; a < N; a++) {
        /* all other functions are exactly zero there */
        CHECK(fabs(point[a] - control[a]) <= bound(6 * s->d + 1, fabs(control[a])),
              "d = %d: %.17g, %.17g", s->d, point[a], control[a]);
        /* and the weights are exactly 0 or 1 */
        CHECK(deboor[a] == control[a], "d = %d: %.17g, %.17g", s->d, deboor[a],
              control[a]);
    }
}

static void end_points(const kw_bspline *s, kw_rng *r)
{
    random_coefficients(r, s);
    if (s->t[0] == s->t[s->d])
        check_end(s, s->t[s->d], c);
    if (s->t[s->n + s->d] == s->t[s->n])
        check_end(s, s->t[s->n], c + (s->n - 1) * N);
}

/* The curve of the mapped control points A c_j + b is the mapped curve. A mapped point has
   at most 4 roundings (a product and three sums) of terms of size |A| |c| + |b|; a curve
   point 6d+1. */
static void affine_invariance(const kw_bspline *s, kw_rng *r)
{
    static double mapped[COEFFICIENTS];
    double A[N][N], b[N], size[N], point[N], image[N];
    int d = s->d;

    random_coefficients(r, s);
    for (int a = 0; a < N; a++) {
        b[a] = test_random_in(r, -5, 5);
        size[a] = fabs(b[a]);
        for (int e = 0; e < N; e++) {
            A[a][e] = test_random_in(r, -2, 2);
            size[a] += 5 * fabs(A[a][e]);
        }
    }
    for (int i = 0; i < s->n * N; i++) {
        int a = i % N;

        mapped[i] = b[a];
        for (int e = 0; e < N; e++)
            mapped[i] += A[a][e] * c[i - a + e];
    }
    for (int p = 0; p < POINTS; p++) {
        double x = test_random_point(r, s);

        kw_curve_point(s, N, mapped, x, image);
        kw_curve_point(s, N, c, x, point);
        for (int a = 0; a < N; a++) {
            double want = b[a];

            for (int e = 0; e < N; e++)
                want += A[a][e] * point[e];
            CHECK(fabs(image[a] - want) <= bound(12 * d + 10, size[a]),
                  "d = %d: %.17g, %.17g", d, image[a], want);
        }
    }
}

/* --- derivatives --- */

/* The sum over the local functions of |c_j| (coordinate a) times the size of the q-th
   derivative. */
static double sum_size(const kw_bspline *s, int i, double x, int q, int a)
{
    double size[K], sum = 0;

    derivative_size(s, i, x, q, size);
    for (int j = 0; j <= s->d; j++)
        sum += fabs(c[(i - s->d + j) * N + a]) * size[j];
    return sum;
}

static void derivatives_are_sums(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], point[N];
    int d = s->d;

    random_coefficients(r, s);
    for (int order = 0; order <= d + 2; order++) {
        double x = test_random_point(r, s);
        int i = kw_bspline_span(s, x);

        poison(value, (order + 1) * N);
        kw_curve_derivatives(s, N, c, x, order, value);
        CHECK(written(value, (order + 1) * N), "d = %d, r = %d", d, order);
        kw_curve_point(s, N, c, x, point);
        for (int l = 0; l < (order + 1) * N; l++) {
            int q = l / N, a = l % N;
            double sum = 0, size = sum_size(s, i, x, q, a);

            if (x == s->t[s->n] && q > 0 && q <= d)
                continue; /* one-sided derivatives: the test of Marsden's identity */
            for (int j = 0; j < s->n; j++)
                sum += c[j * N + a] * kw_bspline_one(s, j, q, x);
            CHECK(fabs(value[l] - sum) <= bound(12 * d + 2, size),
                  "d = %d, derivative %d: %.17g, %.17g", d, q, value[l], sum);
            CHECK(q <= d || value[l] == 0, "d = %d, derivative %d: %g", d, q, value[l]);
            CHECK(q > 0 || fabs(value[l] - point[a]) <= bound(12 * d + 2, size), "%g",
                  point[a]);
        }
    }
}

/* Marsden's identity: with c_j the product of t[j+m] - y over m = 1 .. d the spline is
   (x-y)^d. A coefficient has 2d-1 roundings, the sum 6d+1 of its terms; the power and its
   factors at most 3d. */
static void powers(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], y = test_random_in(r, s->t[s->d], s->t[s->n]);
    int d = s->d;

    for (int j = 0; j < s->n; j++) {
        c[j * N] = 1;
        for (int m = 1; m <= d; m++)
            c[j * N] *= s->t[j + m] - y;
        c[j * N + 1] = c[j * N + 2] = 0;
    }
    for (int p = 0; p < POINTS; p++) {
        double x = p == 0 ? s->t[s->n] : test_random_point(r, s);
        int i = kw_bspline_span(s, x);

        kw_curve_derivatives(s, N, c, x, d, value);
        for (int q = 0; q <= d; q++) {
            double want = 1;

            for (int m = 0; m < d; m++)
                want *= m < q ? d - m : x - y;
            CHECK(fabs(value[q * N] - want) <=
                      bound(8 * d, sum_size(s, i, x, q, 0)) + bound(3 * d, fabs(want)),
                  "d = %d, derivative %d at %.17g: %.17g, %.17g", d, q, x, value[q * N],
                  want);
        }
    }
}

/* Coefficients alpha + beta g_j give the line alpha + beta x. With M = |alpha| + |beta|
   max |t| a coefficient has d+2 roundings of at most M, which the derivatives' sizes
   magnify; the sum 6d+1. */
static void linear_precision(const kw_bspline *s, kw_rng *r)
{
    double value[ROOM], alpha = test_random_in(r, -3, 3), beta = test_random_in(r, -3, 3);
    int d = s->d;
    double M = fabs(alpha) + fabs(beta) * fmax(fabs(s->t[0]), fabs(s->t[s->n + d]));

    for (int i = 0; i < s->n * N; i++)
        c[i] = alpha + beta * kw_bspline_greville(s, i / N);
    for (int p = 0; p < POINTS && d > 0; p++) {
        double x = test_random_point(r, s), size[K];
        int span = kw_bspline_span(s, x);

        kw_curve_derivatives(s, N, c, x, d, value);
        for (int q = 0; q <= d; q++) {
            double want = q == 0 ? alpha + beta * x : q == 1 ? beta : 0, error = 0;

            derivative_size(s, span, x, q, size);
            for (int j = 0; j <= d; j++)
                error += bound(7 * d + 5, M * size[j]);
            CHECK(fabs(value[q * N] - want) <= error,
                  "d = %d, derivative %d: %.17g, %.17g", d, q, value[q * N], want);
        }
    }
}

/* --- blossoms --- */

/* The size of coordinate a of the blossom: de Boor's algorithm with absolute values. */
static double deboor_size(const kw_bspline *s, int i, int a, const double *u)
{
    double b[K] = {0};
    int d = s->d, first = i - d;

    for (int j = 0; j <= d; j++)
        b[j] = fabs(c[(first + j) * N + a]);
    for (int p = 1; p <= d; p++)
        for (int j = d; j >= p; j--) {
            double left = s->t[first + j], right = s->t[first + j + d + 1 - p];
            double w = (u[p - 1] - left) / (right - left);

            b[j] = fabs(1 - w) * b[j - 1] + fabs(w) * b[j];
        }
    return b[d];
}

/* The blossom against the sum of the basis' blossom weights, and the same arguments in
   another order. */
static void blossom(const kw_bspline *s, kw_rng *r)
{
    double u[K], turned[K], weight[K], size[K], point[N + GUARD], again[N];
    int d = s->d, i = random_span(r, s), turn = d > 0 ? kw_rng_below(r, d) : 0;

    random_coefficients(r, s);
    for (int p = 0; p < d; p++)
        u[p] = random_dyadic(r);
    for (int p = 0; p < d; p++)
        turned[p] = u[p < turn ? turn - 1 - p : p];
    poison(point, N);
    kw_curve_blossom(s, i, N, c, u, point);
    CHECK(written(point, N), "d = %d", d);
    kw_curve_blossom(s, i, N, c, turned, again);
    kw_bspline_blossom(s, i, u, weight);
    blossom_size(s, i, u, 0, size);
    for (int a = 0; a < N; a++) {
        double sum = 0, error = bound(8 * d, deboor_size(s, i, a, u));
        double error_again = bound(8 * d, deboor_size(s, i, a, turned));
        double error_sum = 0;

        for (int j = 0; j <= d; j++) {
            sum += weight[j] * c[(i - d + j) * N + a];
            error_sum += bound(6 * d + 1, size[j] * fabs(c[(i - d + j) * N + a]));
        }
        CHECK(fabs(point[a] - sum) <= error + error_sum, "d = %d: %.17g, %.17g", d,
              point[a], sum);
        CHECK(fabs(point[a] - again[a]) <= error + error_again, "d = %d: %.17g, %.17g", d,
              point[a], again[a]);
    }
}

/* Affine in each argument: u = a + w (b-a) with multiples of 1/1024 and w of 1/4 is exact. */
static void blossom_is_affine(const kw_bspline *s, kw_rng *r)
{
    double u[K], at_a[N], at_b[N], between[N];
    int d = s->d, i = random_span(r, s);

    random_coefficients(r, s);
    for (int p = 0; p < d; p++)
        u[p] = random_dyadic(r);
    for (int p = 0; p < d; p++) {
        double a = u[p], b = random_dyadic(r), w = (kw_rng_below(r, 17) - 8) / 4.0;
        double size[N];

        kw_curve_blossom(s, i, N, c, u, at_a);
        for (int e = 0; e < N; e++)
            size[e] = fabs(1 - w) * deboor_size(s, i, e, u);
        u[p] = b;
        kw_curve_blossom(s, i, N, c, u, at_b);
        for (int e = 0; e < N; e++)
            size[e] += fabs(w) * deboor_size(s, i, e, u);
        u[p] = a + w * (b - a);
        kw_curve_blossom(s, i, N, c, u, between);
        for (int e = 0; e < N; e++) {
            double mean = (1 - w) * at_a[e] + w * at_b[e];

            size[e] += deboor_size(s, i, e, u);
            CHECK(fabs(between[e] - mean) <= bound(8 * d + 3, size[e]),
                  "d = %d, argument %d: %.17g, %.17g", d, p, between[e], mean);
        }
    }
}

/* d equal arguments give the point, and d knots in a row one control point. */
static void blossom_at_knots(const kw_bspline *s, kw_rng *r)
{
    double u[K], point[N], value[N], x = test_random_point(r, s);
    int d = s->d, i = kw_bspline_span(s, x);

    random_coefficients(r, s);
    for (int p = 0; p < d; p++)
        u[p] = x;
    kw_curve_blossom(s, i, N, c, u, value);
    kw_curve_point(s, N, c, x, point);
    for (int a = 0; a < N; a++)
        CHECK(fabs(value[a] - point[a]) <= bound(14 * d + 1, 5), "d = %d: %.17g, %.17g",
              d, value[a], point[a]);
    for (int j = i - d; j <= i; j++) {
        const double *knots = s->t + j + 1;

        kw_curve_blossom(s, i, N, c, knots, value);
        for (int a = 0; a < N; a++)
            CHECK(fabs(value[a] - c[j * N + a]) <=
                      bound(8 * d, deboor_size(s, i, a, knots)),
                  "d = %d, %d: %.17g, %.17g", d, j, value[a], c[j * N + a]);
    }
}

/* --- closed curves --- */

/* The partition is dyadic, so the knots at the two ends are exact shifts, and the two sides
   differ by rounding alone. */
static void closed_curves(void)
{
    for (int sample = 0; sample < SPACES; sample++) {
        kw_rng r = kw_rng_at(41, 0, (uint64_t)sample, 0);
        int d = kw_rng_below(&r, 10), L = 1 + kw_rng_below(&r, 4), mu[4], period;
        double tau[5] = {random_dyadic(&r)}, left[ROOM], right[ROOM], given[ROOM];
        kw_bspline *s;

        for (int i = 1; i <= L; i++) {
            tau[i] = tau[i - 1] + (1 + kw_rng_below(&r, 200)) / 64.0;
            mu[i - 1] = 1 + kw_rng_below(&r, d + 1);
        }
        s = kw_bspline_new_periodic(d, L, tau, mu);
        period = s->n - d;
        poison(c, s->n * N);
        for (int i = 0; i < period * N; i++)
            c[i] = test_random_in(&r, -5, 5);
        memcpy(given, c, sizeof(double) * (size_t)(period * N));
        kw_curve_close(s, N, c);
        CHECK(same_bits(c, given, period * N), "d = %d: given coefficients changed", d);
        CHECK(written(c, s->n * N), "d = %d, n = %d", d, s->n);
        for (int i = period * N; i < s->n * N; i++)
            CHECK(c[i] == c[i - period * N], "d = %d, coefficient %d: %g", d, i, c[i]);
        kw_curve_derivatives(s, N, c, tau[0], d, left);
        kw_curve_derivatives(s, N, c, tau[L], d, right);
        for (int l = 0; l < d * N; l++) {
            int q = l / N, a = l % N;
            double size =
                sum_size(s, d, tau[0], q, a) + sum_size(s, s->n - 1, tau[L], q, a);

            CHECK(fabs(left[l] - right[l]) <= bound(6 * d + 1, size),
                  "d = %d, derivative %d: %.17g, %.17g", d, q, left[l], right[l]);
        }
        kw_bspline_free(s);
    }
}

/* Far beyond the degree all derivatives are zero, and nothing else is written. */
static void order_100(const kw_bspline *s, kw_rng *r)
{
    enum { ORDER = 100 };
    double value[(ORDER + 1) * N + GUARD], lower[K * N], x = test_random_point(r, s);

    random_coefficients(r, s);
    poison(value, (ORDER + 1) * N);
    kw_curve_derivatives(s, N, c, x, ORDER, value);
    kw_curve_derivatives(s, N, c, x, s->d, lower);
    CHECK(written(value, (ORDER + 1) * N), "d = %d", s->d);
    CHECK(same_bits(value, lower, (s->d + 1) * N), "d = %d", s->d);
    for (int i = (s->d + 1) * N; i < (ORDER + 1) * N; i++)
        CHECK(value[i] == 0, "d = %d, order %d: %g", s->d, i / N, value[i]);
}

/* --- many points --- */

static void many_points(const kw_bspline *s, kw_rng *r)
{
    static double value[POINTS * ROOM], single[POINTS * ROOM];
    double x[POINTS];
    int order = kw_rng_below(r, s->d + 3), size = (order + 1) * N;

    random_coefficients(r, s);
    for (int p = 0; p < POINTS; p++) {
        x[p] = test_random_point(r, s);
        kw_curve_point(s, N, c, x[p], single + p * N);
    }
    poison(value, POINTS * N);
    kw_curve_point_many(s, N, c, POINTS, x, value);
    CHECK(written(value, POINTS * N), "d = %d", s->d);
    CHECK(same_bits(value, single, POINTS * N), "d = %d", s->d);
    for (int p = 0; p < POINTS; p++)
        kw_curve_deboor(s, N, c, x[p], single + p * N);
    poison(value, POINTS * N);
    kw_curve_deboor_many(s, N, c, POINTS, x, value);
    CHECK(written(value, POINTS * N), "d = %d", s->d);
    CHECK(same_bits(value, single, POINTS * N), "d = %d", s->d);
    for (int p = 0; p < POINTS; p++)
        kw_curve_derivatives(s, N, c, x[p], order, single + p * size);
    poison(value, POINTS * size);
    kw_curve_derivatives_many(s, N, c, POINTS, x, order, value);
    CHECK(written(value, POINTS * size), "d = %d", s->d);
    CHECK(same_bits(value, single, POINTS * size), "d = %d, r = %d", s->d, order);
}

/* More points than are taken at a time, odd and even counts, and none. */
static void longer_than_a_batch(const kw_bspline *s, kw_rng *r)
{
    enum { MOST = 1100 };
    static double x[MOST], value[MOST * 2 * N + GUARD];
    int count = kw_rng_below(r, 5) ? kw_rng_below(r, MOST + 1) : 0;
    int order = kw_rng_below(r, 2), size = (order + 1) * N;
    double one[2 * N];

    random_coefficients(r, s);
    for (int i = 0; i < count; i++)
        x[i] = test_random_point(r, s);
    poison(value, count * size);
    kw_curve_derivatives_many(s, N, c, count, x, order, value);
    CHECK(written(value, count * size), "%d points, d = %d", count, s->d);
    for (int i = 0; i < count; i++) {
        kw_curve_derivatives(s, N, c, x[i], order, one);
        CHECK(same_bits(one, value + i * size, size), "point %d of %d, d = %d", i, count,
              s->d);
    }
}

int main(void)
{
    const int all = KW_BSPLINE_DEGREE;

    run_over_spaces("curve: a point is the sum, is de Boor's, is in the convex hull", 6,
                    point_is_the_sum);
    run_over_spaces("curve: so at degrees up to 31", all, point_is_the_sum);
    run_over_spaces("curve: open knots make the ends the first and last control point",
                    all, end_points);
    run_over_spaces("curve: affine maps of the control points map the curve", 6,
                    affine_invariance);
    run_over_spaces("curve: derivatives are the sums of the functions'", 6,
                    derivatives_are_sums);
    run_over_spaces("curve: derivatives of order 100 are zero", all, order_100);
    run_over_spaces("curve: powers and their derivatives come out (Marsden)", 6, powers);
    run_over_spaces("curve: Greville coefficients give a line", 6, linear_precision);
    run_over_spaces("curve: the blossom is symmetric, and a sum of weights", 6, blossom);
    run_over_spaces("curve: the blossom is affine in each argument", 6,
                    blossom_is_affine);
    run_over_spaces("curve: the blossom has points and control points", 8,
                    blossom_at_knots);
    test_run("curve: a closed curve is smooth at the seam up to d-1", closed_curves);
    run_over_spaces("curve: many points are points one by one, bit for bit", 8,
                    many_points);
    run_over_spaces("curve: so are more points than are taken at a time, and none", 8,
                    longer_than_a_batch);
    return test_end();
}
