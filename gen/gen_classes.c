/* gen classes -- points of two classes, for the perceptron and the MLP. */
#include "draw.h"
#include "elementary.h"
#include "gen.h"
#include "normal.h"
#include "set.h"
#include <math.h>

/* In the order of the parameters and of the arrays. */
enum { KIND, POINTS_OF, DIM, MARGIN, NOISE };
enum { COUNTS, POINTS, LABELS, SEPARATOR };
enum { SEPARABLE, XOR, RINGS, SPIRALS };
enum { MOST_POINTS = 100000, MOST_DIM = 16 };

/* Purposes of random numbers. */
enum { HOW_MANY, WHERE, WHICH_SEPARATOR, WHICH_NOISE };

static const double PI = 0x1.921fb54442d18p+1;

static int check(const gen_call *c)
{
    if (gen_whole(c, KIND) != SEPARABLE && gen_whole(c, DIM) != 2)
        return gen_say(GEN_BAD_CALL, "--dim %d: only --kind separable has other than 2",
                       gen_whole(c, DIM));
    if (gen_whole(c, KIND) == SEPARABLE && c->low[NOISE] > 0)
        return gen_say(GEN_BAD_CALL,
                       "--noise %g and --kind separable: the margin would be "
                       "unknown",
                       c->low[NOISE]);
    return GEN_GOOD;
}

static void plan(const gen_call *c, gen_plan *p)
{
    const int points =
        c->low[POINTS_OF] == c->high[POINTS_OF] ? gen_whole(c, POINTS_OF) : 0;
    char x[GEN_TEXT], w[GEN_TEXT];
    const int noisy = gen_whole(c, KIND) != SEPARABLE;

    gen_plan_numbered("x", gen_whole(c, DIM), noisy ? " noisy_x1 noisy_x2" : "", x);
    gen_plan_numbered("w", gen_whole(c, DIM), " b margin", w);
    gen_plan_add_integers(p, "counts", 1, "points labels", "rows of the other arrays");
    gen_plan_add(p, "points", points, x,
                 noisy ? "the points, exact and with noise" : "the points");
    gen_plan_add_integers(p, "labels", points, "label", "their classes, -1 and 1");
    if (gen_whole(c, KIND) == SEPARABLE)
        gen_plan_add(
            p, "separator", 1, w,
            "label (w x + b) >= margin for all points, with |w| = 1; for two points "
            "it is equal but for rounding");
}

/* --- separable --- */

/* A unit vector and an offset: label (w x + b) is to be margin at least. */
static void make_separator(const gen_call *c, gen_sample *s)
{
    const int dim = gen_whole(c, DIM);
    double *w = gen_rows(s, SEPARATOR, 1), length = 0;
    kw_rng r = gen_rng(c, s, WHICH_SEPARATOR);

    kw_normal_many(&r, dim, w);
    for (int h = 0; h < dim; h++)
        length += w[h] * w[h];
    length = sqrt(length);
    for (int h = 0; h < dim; h++)
        w[h] /= length;
    w[dim] = 0.2 * (2 * kw_rng_uniform(&r) - 1);
    w[dim + 1] = c->low[MARGIN];
}

/* A point of the cube [-1,1]^dim on the side of its label, moved along w by the margin away from
   the plane; the first of each class is put at the margin itself. */
static void separable(const gen_call *c, const gen_sample *s, int i, kw_rng *r, double *x)
{
    const int dim = gen_whole(c, DIM), label = i % 2 == 0 ? 1 : -1;
    const double *w = s->value[SEPARATOR];
    double distance = w[dim], shift;

    gen_draw_uniform(r, -1, 1, dim, x);
    for (int h = 0; h < dim; h++)
        distance += w[h] * x[h];
    shift = label * (fabs(distance) + w[dim + 1]) - distance;
    if (i < 2)
        shift = label * w[dim + 1] - distance;
    for (int h = 0; h < dim; h++)
        x[h] += shift * w[h];
}

/* --- not separable --- */

/* A point of the quadrants of the sign of the label, `margin` away from the axes. */
static void exclusive_or(const gen_call *c, int label, kw_rng *r, double *x)
{
    const double sign = kw_rng_below(r, 2) == 0 ? 1 : -1, margin = c->low[MARGIN];

    x[0] = sign * (margin + kw_rng_uniform(r));
    x[1] = sign * label * (margin + kw_rng_uniform(r));
}

static void ring(const gen_call *c, int label, kw_rng *r, double *x)
{
    const double angle = 2 * PI * kw_rng_uniform(r);
    const double radius = label > 0 ? 1 : 1 + 2 * c->low[MARGIN];

    x[0] = radius * kw_cos(angle);
    x[1] = radius * kw_sin(angle);
}

/* Two arms of one and a half turns, half a turn apart. */
static void spiral(const gen_call *c, int label, kw_rng *r, double *x)
{
    const double along = kw_rng_uniform(r), angle = 3 * PI * along;
    const double radius = label * (along + c->low[MARGIN]);

    x[0] = radius * kw_cos(angle);
    x[1] = radius * kw_sin(angle);
}

static void make(const gen_call *c, void *work, gen_sample *s)
{
    const int dim = gen_whole(c, DIM), kind = gen_whole(c, KIND);
    const int columns = kind == SEPARABLE ? dim : 2 * dim;
    kw_rng r = gen_rng(c, s, HOW_MANY), noise = gen_rng(c, s, WHICH_NOISE);
    const int n = gen_draw(c, POINTS_OF, &r);
    double *counts = gen_rows(s, COUNTS, 1), *x = gen_rows(s, POINTS, n);
    double *label = gen_rows(s, LABELS, n);

    (void)work;
    counts[0] = counts[1] = n;
    r = gen_rng(c, s, WHERE);
    if (kind == SEPARABLE)
        make_separator(c, s);
    for (int i = 0; i < n; i++, x += columns) {
        label[i] = i % 2 == 0 ? 1 : -1;
        if (kind == SEPARABLE)
            separable(c, s, i, &r, x);
        else if (kind == XOR)
            exclusive_or(c, (int)label[i], &r, x);
        else if (kind == RINGS)
            ring(c, (int)label[i], &r, x);
        else
            spiral(c, (int)label[i], &r, x);
        if (kind != SEPARABLE)
            gen_draw_noise(&noise, c->low[NOISE], dim, x, x + dim);
    }
}

const gen_family gen_classes = {
    .name = "classes",
    .summary = "points of two classes: separable, XOR, rings, spirals",
    .about = "A sample is a cloud of points of two classes, -1 and 1, in turn.\n"
             "\n"
             "    separable  a plane w x + b = 0 with |w| = 1 keeps the classes apart; "
             "each has a\n"
             "               point at the distance `margin` and none nearer\n"
             "    xor        the label is the sign of x1 x2; no point nearer to an axis "
             "than `margin`\n"
             "    rings      circles of radius 1 and 1 + 2 margin\n"
             "    spirals    two arms of one and a half turns, the inner ends 2 margin "
             "apart\n",
    .example = "--points 40 --margin 0.2",
    .stream = 3,
    .parameter =
        {
            [KIND] = {"--kind", GEN_WORD, "separable", 0, 0,
                      "separable xor rings spirals", "which ones"},
            [POINTS_OF] = {"--points", GEN_RANGE, "200", 2, MOST_POINTS, NULL,
                           "points, of both classes together"},
            [DIM] = {"--dim", GEN_WHOLE, "2", 1, MOST_DIM, NULL,
                     "coordinates, for --kind separable"},
            [MARGIN] = {"--margin", GEN_REAL, "0.1", 0, 10, NULL, "see above"},
            [NOISE] = {"--noise", GEN_REAL, "0", 0, 10, NULL,
                       "standard deviation of normal noise, but for --kind separable"},
        },
    .check = check,
    .plan = plan,
    .make = make,
};
