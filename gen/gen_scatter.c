/* gen scatter -- scattered samples of surfaces that are known everywhere. */
#include "draw.h"
#include "elementary.h"
#include "gen.h"
#include "need.h"
#include "ply.h"
#include "set.h"
#include <math.h>
#include <stdlib.h>

/* In the order of the parameters and of the arrays. */
enum { SURFACE, SAMPLING, POINTS_OF, VOIDS_OF, NOISE };
enum { COUNTS, POINTS, VOIDS };
enum { FRANKE, RIDGE, PEAK, STEP };
enum { UNIFORM, GRADED, VOID };
enum { MOST_POINTS = 1000000, MOST_VOIDS = 10 };
enum { PART = 256 /* points that are made at once: they stay in the cache */ };

/* Purposes of random numbers. */
enum { HOW_MANY, WHERE, WHICH_NOISE, WHICH_VOIDS };

typedef struct work {
    double u[PART], v[PART], z[PART], noisy[PART], exponent[4][PART], power[PART];
} work;

static int check(const gen_call *c)
{
    if (gen_whole(c, SAMPLING) == VOID && c->high[VOIDS_OF] == 0)
        return gen_say(GEN_BAD_CALL, "--sampling voids and --voids 0: there is none");
    if (gen_whole(c, SAMPLING) != VOID && !gen_is_standard(c, VOIDS_OF))
        return gen_say(GEN_BAD_CALL, "--voids: only --sampling voids has some");
    return GEN_GOOD;
}

static int most_voids(const gen_call *c)
{
    return gen_whole(c, SAMPLING) == VOID ? (int)c->high[VOIDS_OF] : 0;
}

static void plan(const gen_call *c, gen_plan *p)
{
    const int points =
        c->low[POINTS_OF] == c->high[POINTS_OF] ? gen_whole(c, POINTS_OF) : 0;

    gen_plan_add_integers(p, "counts", 1, "points voids", "rows of the other arrays");
    gen_plan_add(p, "points", points, "u v z noisy_z",
                 "a point of the unit square, the surface there, the same with noise");
    if (most_voids(c) > 0)
        gen_plan_add(p, "voids", 0, "u v radius", "disks in which there is no point");
}

static void *work_new(const gen_call *c)
{
    (void)c;
    return kw_need_memory(1, sizeof(work));
}

/* --- surfaces on the unit square --- */

/* Four Gaussian bumps.
   [Franke: Scattered data interpolation, tests of some methods, Math. Comp. 38 (1982)] */
static void franke(work *w, int n)
{
    static const double weight[] = {0.75, 0.75, 0.5, -0.2};

    for (int i = 0; i < n; i++) {
        double x = 9 * w->u[i], y = 9 * w->v[i];

        w->exponent[0][i] = -((x - 2) * (x - 2) + (y - 2) * (y - 2)) / 4;
        w->exponent[1][i] = -(x + 1) * (x + 1) / 49 - (y + 1) / 10;
        w->exponent[2][i] = -((x - 7) * (x - 7) + (y - 3) * (y - 3)) / 4;
        w->exponent[3][i] = -(x - 4) * (x - 4) - (y - 7) * (y - 7);
        w->z[i] = 0;
    }
    for (int k = 0; k < 4; k++) {
        kw_exp_many(n, w->exponent[k], w->power);
        for (int i = 0; i < n; i++)
            w->z[i] += weight[k] * w->power[i];
    }
}

/* exp(-200 (u - v)^2): steep across the diagonal, constant along it */
static void ridge(work *w, int n)
{
    for (int i = 0; i < n; i++) {
        double across = w->u[i] - w->v[i];

        w->exponent[0][i] = -200 * across * across;
    }
    kw_exp_many(n, w->exponent[0], w->z);
}

/* exp(-100 r^2), r the distance to the middle */
static void peak(work *w, int n)
{
    for (int i = 0; i < n; i++) {
        double x = w->u[i] - 0.5, y = w->v[i] - 0.5;

        w->exponent[0][i] = -100 * (x * x + y * y);
    }
    kw_exp_many(n, w->exponent[0], w->z);
}

/* tanh(50 (r - 0.6)), r the distance to the origin: smooth, but steep along an arc */
static void step(work *w, int n)
{
    for (int i = 0; i < n; i++) {
        double r = sqrt(w->u[i] * w->u[i] + w->v[i] * w->v[i]);

        w->exponent[0][i] = 50 * (r - 0.6);
    }
    kw_tanh_many(n, w->exponent[0], w->z);
}

/* --- samples --- */

static int in_a_void(const double *row, int voids, double u, double v)
{
    for (int k = 0; k < voids; k++, row += 3) {
        double x = u - row[0], y = v - row[1];

        if (x * x + y * y < row[2] * row[2])
            return 1;
    }
    return 0;
}

/* Radii up to 0.15: ten disks leave more than a quarter of the square. */
static int make_voids(const gen_call *c, gen_sample *s, int count)
{
    double *row;
    kw_rng r = gen_rng(c, s, WHICH_VOIDS);

    if (most_voids(c) == 0)
        return 0;
    row = gen_rows(s, VOIDS, count);
    for (int k = 0; k < count; k++, row += 3) {
        row[0] = kw_rng_uniform(&r);
        row[1] = kw_rng_uniform(&r);
        row[2] = 0.05 + 0.1 * kw_rng_uniform(&r);
    }
    return count;
}

static void make_places(const gen_call *c, const gen_sample *s, int voids, kw_rng *r,
                        work *w, int n)
{
    const int sampling = gen_whole(c, SAMPLING);

    for (int i = 0; i < n; i++) {
        double u, v;

        do {
            u = kw_rng_uniform(r);
            v = kw_rng_uniform(r);
            if (sampling ==
                GRADED) { /* the density falls as 1/sqrt from the lower left */
                u *= u;
                v *= v;
            }
        } while (voids > 0 && in_a_void(s->value[VOIDS], voids, u, v));
        w->u[i] = u;
        w->v[i] = v;
    }
}

static void put_rows(const work *w, int n, double *row)
{
    for (int i = 0; i < n; i++, row += 4) {
        row[0] = w->u[i];
        row[1] = w->v[i];
        row[2] = w->z[i];
        row[3] = w->noisy[i];
    }
}

static void make(const gen_call *c, void *work_of, gen_sample *s)
{
    static void (*const surface[])(work *, int) = {franke, ridge, peak, step};
    work *w = work_of;
    kw_rng how_many = gen_rng(c, s, HOW_MANY);
    kw_rng where = gen_rng(c, s, WHERE), noise = gen_rng(c, s, WHICH_NOISE);
    const int n = gen_draw(c, POINTS_OF, &how_many);
    const int voids = make_voids(c, s, gen_draw(c, VOIDS_OF, &how_many));
    double *counts = gen_rows(s, COUNTS, 1), *row = gen_rows(s, POINTS, n);

    counts[0] = n;
    counts[1] = voids;
    for (int i = 0; i < n; i += PART) {
        const int part = n - i < PART ? n - i : PART;

        make_places(c, s, voids, &where, w, part);
        surface[gen_whole(c, SURFACE)](w, part);
        gen_draw_noise(&noise, c->low[NOISE], part, w->z, w->noisy);
        put_rows(w, part, row + (size_t)4 * (size_t)i);
    }
}

/* The noisy points, with their parameters. */
static int write(const gen_call *c, const gen_sample *s, int format, const char *path)
{
    (void)c;
    (void)format;
    return gen_ply_cloud(path, s->rows[POINTS], 4, s->value[POINTS],
                         (const int[]){0, 1, 3, 0, 1});
}

const gen_family gen_scatter = {
    .name = "scatter",
    .summary = "scattered points of surfaces that are known everywhere",
    .about = "A sample is a cloud of points (u, v) of the unit square with the height z "
             "of a surface\n"
             "there, exact and with normal noise. The surfaces:\n"
             "\n"
             "    franke  Franke's function: two peaks, a dip and a slope\n"
             "    ridge   exp(-200 (u - v)^2), along the diagonal\n"
             "    peak    exp(-100 ((u - 1/2)^2 + (v - 1/2)^2))\n"
             "    step    tanh(50 (sqrt(u^2 + v^2) - 0.6)), along an arc\n"
             "\n"
             "Points are uniform; or graded, the squares of uniform ones, so that they "
             "are dense at the\n"
             "lower left; or uniform outside of some disks, the voids.\n",
    .example = "--surface ridge --points 200 --sampling voids --voids 2-4",
    .stream = 2,
    .parameter =
        {
            [SURFACE] = {"--surface", GEN_WORD, "franke", 0, 0, "franke ridge peak step",
                         "which one"},
            [SAMPLING] = {"--sampling", GEN_WORD, "uniform", 0, 0, "uniform graded voids",
                          "where the points are"},
            [POINTS_OF] = {"--points", GEN_RANGE, "1000", 1, MOST_POINTS, NULL, "points"},
            [VOIDS_OF] = {"--voids", GEN_RANGE, "3", 0, MOST_VOIDS, NULL,
                          "disks without points, for --sampling voids"},
            [NOISE] = {"--noise", GEN_REAL, "0.01", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .format = {"ply"},
    .check = check,
    .plan = plan,
    .work_new = work_new,
    .work_free = free,
    .make = make,
    .write = write,
};
