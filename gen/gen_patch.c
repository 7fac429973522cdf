/* gen patch -- scattered points of spline surfaces with their boundary in order. */
#include "draw.h"
#include "elementary.h"
#include "gen.h"
#include "graph.h"
#include "need.h"
#include "ply.h"
#include "set.h"
#include "tensor.h"
#include "xml.h"
#include <stdlib.h>

/* In the order of the parameters and of the arrays. */
enum { DEGREE, CELLS, INTERIOR, BOUNDARY, SHAKE, HEIGHT, SCALE, NEIGHBOURS, NOISE };
enum { COUNTS, CONTROLS, POINTS, LABELS, TRANSFORM, EDGES };
enum { NONE, UNIT };

/* Purposes of random numbers. */
enum { WHICH_CONTROLS, WHICH_ROTATION, WHICH_INTERIOR, WHICH_BOUNDARY, WHICH_NOISE };

enum { D = 2, N = 3, COLUMNS = D + 2 * N /* u v x y z noisy_x noisy_y noisy_z */ };

typedef struct work {
    kw_tensor *g;
    double *u, *clean, *noisy, *sorted, *sort; /* D, N, N, 1 and 1 a point */
    int *place;
} work;

static int points_of(const gen_call *c)
{
    return gen_whole(c, INTERIOR) + 4 * gen_whole(c, BOUNDARY);
}

static int controls_of(const gen_call *c)
{
    const int n = gen_whole(c, DEGREE) + gen_whole(c, CELLS);

    return n * n;
}

static int check(const gen_call *c)
{
    if (gen_whole(c, NEIGHBOURS) >= points_of(c))
        return gen_say(GEN_BAD_CALL, "--neighbours %d of %d points",
                       gen_whole(c, NEIGHBOURS), points_of(c));
    if (gen_whole(c, NEIGHBOURS) > 0 && points_of(c) > 20000)
        return gen_say(GEN_BAD_CALL,
                       "--neighbours of %d points: the search is for 20000 at "
                       "most; --neighbours 0 leaves it out",
                       points_of(c));
    return GEN_GOOD;
}

static void plan(const gen_call *c, gen_plan *p)
{
    gen_plan_add_integers(p, "counts", 1, "controls points labels edges",
                          "rows of the other arrays");
    gen_plan_add(
        p, "controls", controls_of(c), "x y z",
        "control points of the surface, the second direction fastest; its knots are "
        "equal cells of [0,1], the ends repeated");
    gen_plan_add(p, "points", points_of(c), "u v x y z noisy_x noisy_y noisy_z",
                 "the interior, then the boundary once around: parameters, points of the "
                 "surface, the same with noise");
    gen_plan_add_integers(
        p, "labels", points_of(c), "side",
        "0 in the interior; 1 to 4 on the sides v = 0, u = 1, v = 1, u = 0");
    gen_plan_add(
        p, "transform", 1, "rotation shift_x shift_y shift_z factor",
        "what was done to the control points: rotated about the z-axis by the angle, "
        "shifted, multiplied by the factor");
    if (gen_whole(c, NEIGHBOURS) > 0)
        gen_plan_add_integers(
            p, "edges", 0, "from to",
            "the nearest neighbours of the noisy points, each pair once");
}

static void *work_new(const gen_call *c)
{
    const size_t points = (size_t)points_of(c), side = (size_t)gen_whole(c, BOUNDARY);
    kw_bspline *s =
        kw_bspline_new_open_uniform(gen_whole(c, DEGREE), gen_whole(c, CELLS), 0, 1);
    work *w = kw_need_memory(1, sizeof *w);

    w->g = kw_tensor_new(D, (const kw_bspline *const[]){s, s});
    w->u = kw_need_memory(points * D, sizeof *w->u);
    w->clean = kw_need_memory(points * N, sizeof *w->clean);
    w->noisy = kw_need_memory(points * N, sizeof *w->noisy);
    w->sorted = kw_need_memory(side, sizeof *w->sorted);
    w->sort = kw_need_memory(side, sizeof *w->sort);
    w->place = kw_need_memory(side + 1, sizeof *w->place);
    kw_bspline_free(s);
    return w;
}

static void work_free(void *work_of)
{
    work *w = work_of;

    kw_tensor_free(w->g);
    free(w->u);
    free(w->clean);
    free(w->noisy);
    free(w->sorted);
    free(w->sort);
    free(w->place);
    free(w);
}

/* --- the surface --- */

/* Greville points, shaken by a part of their distance; z uniform in [0, height). */
static void make_controls(const gen_call *c, const gen_sample *s, const kw_tensor *g,
                          double *x)
{
    const int n = g->s[0]->n;
    const double shake = c->low[SHAKE] / (n - 1), height = c->low[HEIGHT];
    kw_rng r = gen_rng(c, s, WHICH_CONTROLS);

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++, x += N) {
            x[0] = kw_bspline_greville(g->s[0], i) + shake * (2 * kw_rng_uniform(&r) - 1);
            x[1] = kw_bspline_greville(g->s[1], j) + shake * (2 * kw_rng_uniform(&r) - 1);
            x[2] = height * kw_rng_uniform(&r);
        }
}

static void rotate(double angle, int count, double *x)
{
    const double cosine = kw_cos(angle), sine = kw_sin(angle);

    for (int i = 0; i < count; i++, x += N) {
        double x0 = x[0];

        x[0] = cosine * x0 - sine * x[1];
        x[1] = sine * x0 + cosine * x[1];
    }
}

static void bounds(int count, const double *x, double *low, double *high)
{
    for (int h = 0; h < N; h++) {
        low[h] = high[h] = x[h];
        for (int i = 1; i < count; i++) {
            double value = x[i * N + h];

            low[h] = value < low[h] ? value : low[h];
            high[h] = value > high[h] ? value : high[h];
        }
    }
}

/* The smallest coordinates become 0 and, if that is wanted, the largest extent 1. */
static void transform(const gen_call *c, gen_sample *s, int count, double *x)
{
    double *row = gen_rows(s, TRANSFORM, 1), low[N], high[N], extent = 0;
    kw_rng r = gen_rng(c, s, WHICH_ROTATION);

    row[0] = 0x1.921fb54442d18p+2 * kw_rng_uniform(&r);
    rotate(row[0], count, x);
    bounds(count, x, low, high);
    for (int h = 0; h < N; h++) {
        row[1 + h] = -low[h];
        extent = high[h] - low[h] > extent ? high[h] - low[h] : extent;
    }
    row[4] = gen_whole(c, SCALE) == UNIT ? 1 / extent : 1;
    for (int i = 0; i < count * N; i++)
        x[i] = (x[i] + row[1 + i % N]) * row[4];
}

/* --- points --- */

/* Once around, each side from its corner on, parameters ascending along the way. */
static void make_boundary(const gen_call *c, const gen_sample *s, work *w, double *u,
                          double *label)
{
    const int side = gen_whole(c, BOUNDARY);
    kw_rng r = gen_rng(c, s, WHICH_BOUNDARY);

    for (int k = 0; k < 4; k++) {
        gen_draw_sorted(&r, side, w->sorted, w->sort, w->place);
        w->sorted[0] = 0;
        for (int i = 0; i < side; i++, u += D) {
            double along = k < 2 ? w->sorted[i] : 1 - w->sorted[i];

            u[k % 2] = along;
            u[1 - k % 2] = k == 1 || k == 2;
            *label++ = k + 1;
        }
    }
}

static void make_points(const gen_call *c, gen_sample *s, work *w)
{
    const int interior = gen_whole(c, INTERIOR), count = points_of(c);
    double *row = gen_rows(s, POINTS, count), *label = gen_rows(s, LABELS, count);
    kw_rng r = gen_rng(c, s, WHICH_INTERIOR), noise = gen_rng(c, s, WHICH_NOISE);

    gen_draw_uniform(&r, 0, 1, interior * D, w->u);
    for (int i = 0; i < interior; i++)
        label[i] = 0;
    make_boundary(c, s, w, w->u + interior * D, label + interior);
    kw_tensor_point_many(w->g, N, s->value[CONTROLS], NULL, count, w->u, w->clean);
    gen_draw_noise(&noise, c->low[NOISE], count * N, w->clean, w->noisy);
    for (int i = 0; i < count; i++, row += COLUMNS) {
        for (int h = 0; h < D; h++)
            row[h] = w->u[i * D + h];
        for (int h = 0; h < N; h++) {
            row[D + h] = w->clean[i * N + h];
            row[D + N + h] = w->noisy[i * N + h];
        }
    }
}

/* Returns how many there are. */
static int make_edges(gen_sample *s, int array, int count, const double *x, int k)
{
    kw_graph *g = kw_graph_new_nearest(count, N, x, k);
    int edges = g->start[count] / 2;
    double *row = gen_rows(s, array, edges);

    for (int i = 0; i < count; i++)
        for (int e = g->start[i]; e < g->start[i + 1]; e++)
            if (i < g->to[e]) {
                *row++ = i;
                *row++ = g->to[e];
            }
    kw_graph_free(g);
    return edges;
}

static void make(const gen_call *c, void *work_of, gen_sample *s)
{
    work *w = work_of;
    const int count = points_of(c), controls = controls_of(c),
              k = gen_whole(c, NEIGHBOURS);
    double *counts = gen_rows(s, COUNTS, 1), *x = gen_rows(s, CONTROLS, controls);

    make_controls(c, s, w->g, x);
    transform(c, s, controls, x);
    make_points(c, s, w);
    counts[0] = controls;
    counts[1] = counts[2] = count;
    counts[3] = k > 0 ? make_edges(s, EDGES, count, w->noisy, k) : 0;
}

static int write(const gen_call *c, const gen_sample *s, int format, const char *path)
{
    static const int place[] = {5, 6, 7, 0, 1};
    kw_bspline *b;
    kw_tensor *g;
    int failed;

    if (format == 0)
        return gen_ply_cloud(path, s->rows[POINTS], COLUMNS, s->value[POINTS], place);
    b = kw_bspline_new_open_uniform(gen_whole(c, DEGREE), gen_whole(c, CELLS), 0, 1);
    g = kw_tensor_new(D, (const kw_bspline *const[]){b, b});
    failed = gen_xml_surface(path, g, N, s->value[CONTROLS]);
    kw_tensor_free(g);
    kw_bspline_free(b);
    return failed;
}

const gen_family gen_patch = {
    .name = "patch",
    .summary = "scattered points of spline surfaces, their boundary in order, neighbours",
    .about =
        "A sample is a spline surface over the unit square, given by its control points, "
        "and\n"
        "points of it at known parameters: scattered ones in the interior, and the "
        "boundary\n"
        "once around from (0,0), each of the four sides from its corner on. Control "
        "points are\n"
        "Greville points, shaken, with a uniform height, then rotated, shifted and "
        "scaled.\n"
        "Neighbours: two points are joined if one is among the nearest of the other.\n",
    .example = "--interior 100 --boundary 10",
    .recipes = "Recipes of the literature, as far as a call can follow them:\n"
               "\n"
               "  --degree 2 --cells 1 --interior 1000 --neighbours 10\n"
               "    bi-degree (2,2) patches, after Giannelli, Imperatore, Mantzaflaris, "
               "Scholz: Learning\n"
               "    meshless parameterization with graph convolutional neural networks, "
               "2023, and\n"
               "    BIDGCN: boundary-informed dynamic graph convolutional network for "
               "adaptive spline\n"
               "    fitting of scattered data, Neural Comput. Appl. 2024\n",
    .stream = 6,
    .parameter =
        {
            [DEGREE] = {"--degree", GEN_WHOLE, "2", 1, 5, NULL, "in both directions"},
            [CELLS] = {"--cells", GEN_WHOLE, "1", 1, 32, NULL, "in each direction"},
            [INTERIOR] = {"--interior", GEN_WHOLE, "1000", 0, 100000, NULL,
                          "points inside"},
            [BOUNDARY] = {"--boundary", GEN_WHOLE, "32", 1, 10000, NULL,
                          "points on a side"},
            [SHAKE] = {"--shake", GEN_REAL, "0.3", 0, 1, NULL,
                       "largest shift of a control point, in mean distances"},
            [HEIGHT] = {"--height", GEN_REAL, "1", 0, 100, NULL, "of the control points"},
            [SCALE] = {"--scale", GEN_WORD, "unit", 0, 0, "none unit",
                       "to the largest extent 1, or not at all"},
            [NEIGHBOURS] = {"--neighbours", GEN_WHOLE, "8", 0, 100, NULL,
                            "nearest ones that a point is joined with; 0: no edges"},
            [NOISE] = {"--noise", GEN_REAL, "0", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .format = {"ply", "xml"},
    .check = check,
    .plan = plan,
    .work_new = work_new,
    .work_free = work_free,
    .make = make,
    .write = write,
};
