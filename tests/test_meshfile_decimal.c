/* Meshes of decimal knots, which no double is. Finer knots are t + (t' - t) / 2 in double
   precision, and with respect to these doubles values are right to 1e-14.

   Here all is made anew, in long doubles: the B-splines by the recursion, two-scale relations by
   Boehm's rule one knot after the other, truncation as Definition 5 says it, on whole levels. */
#include "hier.h"
#include "meshes.h"
#include "meshfile.h"
#include "spline.h"
#include <stdio.h>

enum { LEVELS = 9, HIGHEST = 3, FUNCTIONS = 1 << 11, POINTS = 300 };

typedef struct line {
    int d, n[LEVELS];
    double t[LEVELS][FUNCTIONS + HIGHEST + 1];
    double low[LEVELS + 1], high[LEVELS + 1]; /* the domains; the last one is empty */
} line;

/* Finer knots, and domains around 0.4: two cells of level 0, then four of each level. */
static void make_line(line *l, int d, kw_mesh **m)
{
    const char *const end[] = {"", " ", " 0.1 ", " 0.1 0.1 "};
    const char *const start[] = {"", " ", " 0.5 ", " 0.5 0.5 "};
    const double knots[] = {0.1, 0.2, 0.3, 0.4, 0.5};
    char text[1024], message[KW_MESHFILE_MESSAGE];
    int size =
        snprintf(text, sizeof text, "degree %d\nknots 0.1%s0.1 0.2 0.3 0.4 0.5%s0.5\n", d,
                 end[d], start[d]);

    l->d = d;
    l->n[0] = d + 4;
    for (int i = 0; i <= 2 * d + 4; i++)
        l->t[0][i] = knots[i < d ? 0 : i > d + 4 ? 4 : i - d];
    for (int level = 0; level < LEVELS; level++) {
        int at = 3 << level, wide = level > 0 ? 2 : 1, count = 0;
        const double *t = l->t[level];

        if (level == 0) {
            l->low[0] = t[d];
            l->high[0] = t[l->n[0]];
        }
        l->low[level + 1] = t[d + at - wide]; /* inner knots are simple */
        l->high[level + 1] = t[d + at + wide];
        if (level + 1 == LEVELS)
            break;
        size += snprintf(text + size, sizeof text - (size_t)size, "refine %d %d %d\n",
                         level, at - wide, at + wide);
        for (int i = 0; i <= l->n[level] + d; i++) {
            l->t[level + 1][count++] = t[i];
            if (i < l->n[level] + d && t[i] < t[i + 1])
                l->t[level + 1][count++] = t[i] + (t[i + 1] - t[i]) / 2;
        }
        l->n[level + 1] = count - d - 1;
    }
    *m = kw_meshfile_parse(text, (size_t)size, "decimal.mesh", message);
    KW_NEED(*m, "%s", message);
}

/* Does the support of function j of a level lie in Omega^domain? */
static int lies_in(const line *l, int level, int j, int domain)
{
    return domain < LEVELS && l->low[domain] <= l->t[level][j] &&
           l->t[level][j + l->d + 1] <= l->high[domain];
}

/* The B-spline on the knots t[0 .. d+1]. [source text, Definition 3, corrected] */
static long double value_of(const double *t, int d, double x, double right_end)
{
    long double sum = 0;

    if (x < t[0] || x > t[d + 1])
        return 0;
    if (d == 0)
        return (t[0] <= x && x < t[1]) ||
               (x == right_end && t[0] < x && t[1] == right_end);
    if (t[d] > t[0])
        sum += ((long double)x - t[0]) / ((long double)t[d] - t[0]) *
               value_of(t, d - 1, x, right_end);
    if (t[d + 1] > t[1])
        sum += ((long double)t[d + 1] - x) / ((long double)t[d + 1] - t[1]) *
               value_of(t + 1, d - 1, x, right_end);
    return sum;
}

/* Coefficients of a level become those of the next one. [Boehm, CAD 12 (1980)] */
static void refine(const line *l, int level, long double *c)
{
    static double t[FUNCTIONS + HIGHEST + 1];
    int n = l->n[level], d = l->d;

    memcpy(t, l->t[level], sizeof t);
    for (int i = d; i < n; i++) {
        double x = t[i] + (t[i + 1] - t[i]) / 2;

        for (int j = n; j >= 0; j--) {
            long double w =
                j <= i - d ? 1
                : j > i    ? 0
                           : ((long double)x - t[j]) / ((long double)t[j + d] - t[j]);
            long double here = j < n ? w * c[j] : 0;

            c[j] = here + (j > 0 ? (1 - w) * c[j - 1] : 0);
        }
        memmove(t + i + 2, t + i + 1, (size_t)(n + d - i) * sizeof *t);
        t[++i] = x;
        n++;
    }
    KW_NEED(n == l->n[level + 1], "%d functions, %d", n, l->n[level + 1]);
}

/* THB-spline j of a level in the functions of the last level. */
static void truncated(const line *l, int level, int j, long double *c)
{
    memset(c, 0, FUNCTIONS * sizeof *c);
    c[j] = 1;
    for (; level + 1 < LEVELS; level++) {
        refine(l, level, c);
        for (int i = 0; i < l->n[level + 1]; i++)
            if (lies_in(l, level + 1, i, level + 1))
                c[i] = 0;
    }
}

static double random_near(kw_rng *r, const line *l, int p)
{
    int domain = p % LEVELS;
    double x = test_random_in(r, l->low[domain], l->high[domain]);

    if (p % 5 == 0) /* a knot of the finest level */
        x = l->t[LEVELS - 1][l->d + kw_rng_below(r, l->n[LEVELS - 1] - l->d + 1)];
    return p == 0 ? l->high[0] : x;
}

/* Function i of b, which is function j of a level, at many points. */
static void check_function(const line *l, const kw_hier *b, int i, int level, int j)
{
    static long double c[FUNCTIONS];
    kw_rng r = kw_rng_at(62, (uint64_t)l->d, (uint64_t)i, 0);

    truncated(l, level, j, c);
    for (int p = 0; p < POINTS; p++) {
        double x = random_near(&r, l, p), end = l->high[0];
        long double hb = value_of(l->t[level] + j, l->d, x, end), thb = 0;
        const double *t = l->t[LEVELS - 1];

        for (int f = 0; f < l->n[LEVELS - 1]; f++)
            if (c[f] != 0 && t[f] <= x && x <= t[f + l->d + 1])
                thb += c[f] * value_of(t + f, l->d, x, end);
        CHECK(fabs(kw_hier_one(b, KW_HB, i, NULL, &x) - (double)hb) <= 1e-14,
              "HB %d at %.17g: %.17g", i, x, (double)hb);
        CHECK(fabs(kw_hier_one(b, KW_THB, i, NULL, &x) - (double)thb) <= 1e-14,
              "THB %d at %.17g: %.17g", i, x, (double)thb);
    }
}

static void decimal(int d)
{
    line *l = room_for(1, sizeof *l);
    kw_mesh *m;
    kw_hier *b;
    int found = 0;

    make_line(l, d, &m);
    b = kw_hier_new(m);
    CHECK(m->levels == LEVELS, "%d levels", m->levels);
    for (int level = 0; level < LEVELS; level++) {
        const kw_bspline *s = m->level[level].s[0];

        CHECK(s->n == l->n[level] && same_bits(s->t, l->t[level], s->n + d + 1),
              "the knots of level %d", level);
        for (int j = 0; j < l->n[level]; j++)
            if (lies_in(l, level, j, level) && !lies_in(l, level, j, level + 1))
                check_function(l, b, found++, level, j);
    }
    CHECK(found == b->active->size, "%d functions, %d", found, b->active->size);
    kw_hier_free(b);
    kw_mesh_free(m);
    free(l);
}

static void hats(void)
{
    decimal(1);
}

static void parabolas(void)
{
    decimal(2);
}

static void cubics(void)
{
    decimal(3);
}

/* (0.1 + 0.5) / 2 is 0.3, but 0.1 + (0.5 - 0.1) / 2 the double behind it. */
static void middles(void)
{
    static const char text[] = "degree 0\nknots 0.1 0.5\nrefine 0 0 1\n";
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m = kw_meshfile_parse(text, sizeof text - 1, "m.mesh", message);
    double middle;

    KW_NEED(m, "%s", message);
    middle = m->level[1].s[0]->t[1];
    CHECK(middle == 0.30000000000000004, "%.17g", middle);
    kw_mesh_free(m);
}

/* Auxiliary spans are halved too, and the d nearest knots kept: the example of meshfile.h. */
static void auxiliary_knots(void)
{
    static const char text[] =
        "degree 2\nknots -2 -1 0 1 2 3 4\nrefine 0 0 1\nrefine 1 0 1\n";
    static const double first[] = {-1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5, 3};
    static const double second[] = {-0.5, -0.25, 0,    0.25, 0.5,  0.75, 1,
                                    1.25, 1.5,   1.75, 2,    2.25, 2.5};
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m = kw_meshfile_parse(text, sizeof text - 1, "m.mesh", message);

    KW_NEED(m, "%s", message);
    CHECK(m->level[1].s[0]->n == 6 && same_bits(m->level[1].s[0]->t, first, 9), "%d",
          m->level[1].s[0]->n);
    CHECK(m->level[2].s[0]->n == 10 && same_bits(m->level[2].s[0]->t, second, 13), "%d",
          m->level[2].s[0]->n);
    kw_mesh_free(m);
}

int main(void)
{
    test_run("meshfile: decimal knots halved eight times, degree 1", hats);
    test_run("meshfile: decimal knots halved eight times, degree 2", parabolas);
    test_run("meshfile: decimal knots halved eight times, degree 3", cubics);
    test_run("meshfile: the middle of two doubles is t + (t' - t) / 2", middles);
    test_run("meshfile: auxiliary knots of finer levels", auxiliary_knots);
    return test_end();
}
