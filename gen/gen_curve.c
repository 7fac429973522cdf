/* gen curve -- spline curves with known parameters, knots and control points. */
#include "curve.h"
#include "draw.h"
#include "gen.h"
#include "need.h"
#include "normal.h"
#include "set.h"
#include "xml.h"
#include <stdlib.h>

/* In the order of the parameters and of the arrays. */
enum { DEGREE, CONTROLS_OF, DIM, POINTS_OF, LAW, PARAMETERS, KNOTS_OF, NOISE };
enum { COUNTS, KNOTS, CONTROLS, POINTS };
enum { NORMAL, UNIFORM, WALK };
enum { SORTED, PINNED, EQUAL };
enum { MOST_CONTROLS = 100, MOST_POINTS = 100000 };

/* Purposes of random numbers. */
enum { HOW_MANY, WHICH_KNOTS, WHICH_CONTROLS, WHICH_PARAMETERS, WHICH_NOISE };

typedef struct work {
    double *t, *sort, *clean, *noisy; /* parameters; room to sort them; points */
    int *place;
} work;

static int check(const gen_call *c)
{
    if (c->low[CONTROLS_OF] <= c->low[DEGREE])
        return gen_say(GEN_BAD_CALL, "--controls %g: degree %g needs %g at least",
                       c->low[CONTROLS_OF], c->low[DEGREE], c->low[DEGREE] + 1);
    if (gen_whole(c, PARAMETERS) == PINNED && c->low[POINTS_OF] < 2)
        return gen_say(GEN_BAD_CALL,
                       "--points %g and --parameters pinned: both ends are 2 points",
                       c->low[POINTS_OF]);
    return GEN_GOOD;
}

static void plan(const gen_call *c, gen_plan *p)
{
    const int spatial = gen_whole(c, DIM) == 3, degree = gen_whole(c, DEGREE);
    const int controls =
        c->low[CONTROLS_OF] == c->high[CONTROLS_OF] ? gen_whole(c, CONTROLS_OF) : 0;
    const int points =
        c->low[POINTS_OF] == c->high[POINTS_OF] ? gen_whole(c, POINTS_OF) : 0;

    gen_plan_add_integers(p, "counts", 1, "knots controls points",
                          "rows of the other arrays; the degree is knots - controls - 1");
    gen_plan_add(p, "knots", controls > 0 ? controls + degree + 1 : 0, "knot",
                 "the knot vector, from 0 to 1");
    gen_plan_add(p, "controls", controls, spatial ? "x y z" : "x y",
                 "the control points");
    gen_plan_add(p, "points", points,
                 spatial ? "t x y z noisy_x noisy_y noisy_z" : "t x y noisy_x noisy_y",
                 "ascending parameters, points of the curve there, the same with noise");
}

static void *work_new(const gen_call *c)
{
    work *w = kw_need_memory(1, sizeof *w);
    const size_t most = (size_t)c->high[POINTS_OF], dim = (size_t)gen_whole(c, DIM);

    w->t = kw_need_memory(most, sizeof *w->t);
    w->sort = kw_need_memory(most, sizeof *w->sort);
    w->clean = kw_need_memory(most * dim, sizeof *w->clean);
    w->noisy = kw_need_memory(most * dim, sizeof *w->noisy);
    w->place = kw_need_memory(most + 1, sizeof *w->place);
    return w;
}

static void work_free(void *work_of)
{
    work *w = work_of;

    free(w->t);
    free(w->sort);
    free(w->clean);
    free(w->noisy);
    free(w->place);
    free(w);
}

/* Knots of full multiplicity at 0 and 1, and one between them for each control point more than
   degree+1: at equal distances, or off by at most 0.4 of that. */
static void make_knots(const gen_call *c, const gen_sample *s, int n, double *t)
{
    const int d = gen_whole(c, DEGREE), spans = n - d;
    kw_rng r = gen_rng(c, s, WHICH_KNOTS);

    for (int i = 0; i <= d; i++) {
        t[i] = 0;
        t[n + i] = 1;
    }
    for (int i = 1; i < spans; i++) {
        double shift = gen_whole(c, KNOTS_OF) == 0 ? 0 : 0.8 * kw_rng_uniform(&r) - 0.4;

        t[d + i] = (i + shift) / spans;
    }
}

static void make_controls(const gen_call *c, const gen_sample *s, int count, double *x)
{
    const int dim = gen_whole(c, DIM), law = gen_whole(c, LAW);
    kw_rng r = gen_rng(c, s, WHICH_CONTROLS);

    if (law == UNIFORM) {
        gen_draw_uniform(&r, 0, 1, count * dim, x);
        return;
    }
    kw_normal_many(&r, count * dim, x);
    for (int i = dim; law == WALK && i < count * dim; i++)
        x[i] += x[i - dim];
}

static void make_parameters(const gen_call *c, const gen_sample *s, work *w, int count)
{
    const int how = gen_whole(c, PARAMETERS);
    kw_rng r = gen_rng(c, s, WHICH_PARAMETERS);

    if (how == EQUAL)
        for (int i = 0; i < count; i++)
            w->t[i] = count > 1 ? (double)i / (count - 1) : 0.5;
    else
        gen_draw_sorted(&r, count, w->t, w->sort, w->place);
    if (how == PINNED) {
        w->t[count - 1] = 1;
        w->t[0] = 0;
    }
}

static void make_points(const gen_call *c, gen_sample *s, work *w,
                        const kw_bspline *space, const double *controls, int count)
{
    const int dim = gen_whole(c, DIM);
    double *row = gen_rows(s, POINTS, count);
    kw_rng r = gen_rng(c, s, WHICH_NOISE);

    make_parameters(c, s, w, count);
    kw_curve_point_many(space, dim, controls, count, w->t, w->clean);
    gen_draw_noise(&r, c->low[NOISE], count * dim, w->clean, w->noisy);
    for (int i = 0; i < count; i++) {
        *row++ = w->t[i];
        for (int h = 0; h < dim; h++) {
            row[h] = w->clean[i * dim + h];
            row[dim + h] = w->noisy[i * dim + h];
        }
        row += 2 * dim;
    }
}

static void make(const gen_call *c, void *work_of, gen_sample *s)
{
    const int d = gen_whole(c, DEGREE);
    kw_rng r = gen_rng(c, s, HOW_MANY);
    const int n = gen_draw(c, CONTROLS_OF, &r), points = gen_draw(c, POINTS_OF, &r);
    double *t = gen_rows(s, KNOTS, n + d + 1);
    double *counts = gen_rows(s, COUNTS, 1), *controls = gen_rows(s, CONTROLS, n);
    kw_bspline *space;

    counts[0] = n + d + 1;
    counts[1] = n;
    counts[2] = points;
    make_knots(c, s, n, t);
    make_controls(c, s, n, controls);
    space = kw_bspline_new(d, n, t);
    make_points(c, s, work_of, space, controls, points);
    kw_bspline_free(space);
}

static int write(const gen_call *c, const gen_sample *s, int format, const char *path)
{
    kw_bspline *space =
        kw_bspline_new(gen_whole(c, DEGREE), s->rows[CONTROLS], s->value[KNOTS]);
    int failed = gen_xml_curve(path, space, gen_whole(c, DIM), s->value[CONTROLS]);

    (void)format;
    kw_bspline_free(space);
    return failed;
}

const gen_family gen_curve = {
    .name = "curve",
    .summary = "spline curves with their parameters, knots and control points",
    .about = "A sample is a planar or spatial spline curve: its knots, its control "
             "points, points of\n"
             "it at known parameters, and the same points with normal noise. A curve "
             "with degree + 1\n"
             "control points is a Bezier curve.\n",
    .example = "--degree 2 --controls 4-8 --points 30-50",
    .recipes =
        "Recipes of the literature, as far as a call can follow them:\n"
        "\n"
        "  --degree 3 --controls 4 --points 7 --noise 0\n"
        "    polynomial curves with normal control points and 2d+1 sorted parameters, "
        "after\n"
        "    Scholz, Juettler: Parameterization for polynomial curve approximation via "
        "residual\n"
        "    deep neural networks, CAGD 85 (2021)\n"
        "  --degree 3 --controls 6 --points 100 --parameters pinned --law walk\n"
        "    curves of 100 points, after Laube, Franz, Umlauf: Deep learning "
        "parametrization for\n"
        "    B-spline curve approximation, 3DV 2018\n"
        "  --degree 3 --controls 4-8 --points 30-50 --parameters pinned --law uniform\n"
        "    cubic curves of few control points and noisy points, after Zou, Zhu, Wu, "
        "Yang:\n"
        "    SplineGen: Approximating unorganized points through generative AI, CAD 178 "
        "(2025)\n",
    .stream = 1,
    .parameter =
        {
            [DEGREE] = {"--degree", GEN_WHOLE, "3", 1, 5, NULL, "degree"},
            [CONTROLS_OF] = {"--controls", GEN_RANGE, "6", 2, MOST_CONTROLS, NULL,
                             "control points"},
            [DIM] = {"--dim", GEN_WHOLE, "2", 2, 3, NULL, "in the plane or in space"},
            [POINTS_OF] = {"--points", GEN_RANGE, "100", 1, MOST_POINTS, NULL,
                           "points of a curve"},
            [LAW] = {"--law", GEN_WORD, "normal", 0, 0, "normal uniform walk",
                     "how control points are drawn (a walk has normal steps)"},
            [PARAMETERS] =
                {"--parameters", GEN_WORD, "sorted", 0, 0, "sorted pinned equal",
                 "random in order, the same with both ends, or in equal steps"},
            [KNOTS_OF] = {"--knots", GEN_WORD, "equal", 0, 0, "equal random",
                          "distances of the inner knots"},
            [NOISE] = {"--noise", GEN_REAL, "0.01", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .format = {"xml"},
    .check = check,
    .plan = plan,
    .work_new = work_new,
    .work_free = work_free,
    .make = make,
    .write = write,
};
