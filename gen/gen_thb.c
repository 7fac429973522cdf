/* gen thb -- THB- or HB-spline geometries on random hierarchical meshes. */
#include "draw.h"
#include "hierpieces.h"
#include "hierset.h"
#include "meshfile.h"
#include "need.h"
#include "vtu.h"
#include "xml.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Behind the parameters and arrays of hierset.h. */
enum { BASIS = HIER_PARAMETERS, POINTS_OF, HEIGHT, NOISE };
enum { COEFFICIENTS = HIER_ARRAYS, POINTS };
enum { MESH, XML, VTU };

/* Purposes of random numbers. */
enum { WHICH_COEFFICIENTS, WHERE, WHICH_NOISE };

enum { MOST = KW_TENSOR_D + 1 }; /* coordinates of a point: D, and the height */

static kw_hier_kind kind_of(const gen_call *c)
{
    return gen_whole(c, BASIS) == 0 ? KW_THB : KW_HB;
}

static void plan(const gen_call *c, gen_plan *p)
{
    static const char *const coefficients[] = {"level j1 x z", "level j1 j2 x y z",
                                               "level j1 j2 j3 x y z w"};
    static const char *const points[] = {"u x z noisy_x noisy_z",
                                         "u v x y z noisy_x noisy_y noisy_z",
                                         "u v t x y z w noisy_x noisy_y noisy_z noisy_w"};
    const int D = gen_whole(c, HIER_DIM);

    hierset_plan(c, p, " coefficients points");
    gen_plan_add(
        p, "coefficients", 0, coefficients[D - 1],
        "the functions of the basis, by level and multi-index, and their coefficients");
    gen_plan_add(p, "points", gen_whole(c, POINTS_OF), points[D - 1],
                 "parameters, points of the geometry there, the same with noise");
}

/* The rows level, j, coefficient: Greville points, and a uniform height that halves from level to
   level. THB-splines with these coefficients give x = u, y = v, .. */
static void make_coefficients(const gen_call *c, gen_sample *s, const kw_active *a)
{
    const int D = a->mesh->D;
    double *row = gen_rows(s, COEFFICIENTS, a->size);
    kw_rng r = gen_rng(c, s, WHICH_COEFFICIENTS);

    for (int i = 0; i < a->size; i++) {
        int level, j[KW_TENSOR_D];

        kw_active_function(a, i, &level, j);
        *row++ = level;
        for (int h = 0; h < D; h++)
            *row++ = j[h];
        for (int h = 0; h < D; h++)
            *row++ = kw_bspline_greville(a->mesh->level[level].s[h], j[h]);
        *row++ = ldexp(c->low[HEIGHT] * (2 * kw_rng_uniform(&r) - 1), -level);
    }
}

/* The geometry that the rows describe; the caller frees. */
static kw_hierpieces *new_geometry(const gen_call *c, const gen_sample *s,
                                   const kw_hier *b, double **coefficients)
{
    const int D = gen_whole(c, HIER_DIM), N = D + 1, size = s->rows[COEFFICIENTS];
    double *x = kw_need_memory((size_t)size * (size_t)N, sizeof *x);

    for (int i = 0; i < size; i++)
        memcpy(x + i * N, s->value[COEFFICIENTS] + i * (1 + D + N) + 1 + D,
               (size_t)N * sizeof *x);
    *coefficients = x;
    return kw_hierpieces_new(b, kind_of(c), N, x);
}

static void make_points(const gen_call *c, gen_sample *s, const kw_hierpieces *geometry)
{
    const int D = gen_whole(c, HIER_DIM), N = D + 1, count = gen_whole(c, POINTS_OF);
    double *row = gen_rows(s, POINTS, count);
    kw_rng r = gen_rng(c, s, WHERE), noise = gen_rng(c, s, WHICH_NOISE);

    for (int i = 0; i < count; i++, row += D + 2 * N) {
        gen_draw_uniform(&r, 0, 1, D, row);
        kw_hierpieces_point(geometry, NULL, row, row + D);
        gen_draw_noise(&noise, c->low[NOISE], N, row + D, row + D + N);
    }
}

static void make(const gen_call *c, void *work, gen_sample *s)
{
    kw_mesh *m = hierset_new(c, s);
    kw_hier *b = kw_hier_new(m);
    double *counts = hierset_fill(c, s, b->active), *coefficients;
    kw_hierpieces *geometry;

    (void)work;
    make_coefficients(c, s, b->active);
    geometry = new_geometry(c, s, b, &coefficients);
    make_points(c, s, geometry);
    counts[0] = b->active->size;
    counts[1] = gen_whole(c, POINTS_OF);
    kw_hierpieces_free(geometry);
    free(coefficients);
    kw_hier_free(b);
    kw_mesh_free(m);
}

/* --- files --- */

/* In three directions there is no room for the height. */
static void place(void *with, const double *x, double *point)
{
    const kw_hierpieces *geometry = with;
    double all[MOST];

    kw_hierpieces_point(geometry, NULL, x, all);
    for (int k = 0; k < 3 && k < geometry->N; k++)
        point[k] = all[k];
}

static int write_geometry(const gen_call *c, const gen_sample *s, const kw_mesh *m,
                          int format, const char *path)
{
    kw_hier *b = kw_hier_new(m);
    double *x;
    kw_hierpieces *geometry = new_geometry(c, s, b, &x);
    int failed = format == XML ? gen_xml_hier(path, b, kind_of(c), geometry->N, x)
                               : gen_vtu_mesh(path, m, place, geometry);

    kw_hierpieces_free(geometry);
    free(x);
    kw_hier_free(b);
    return failed;
}

static int write(const gen_call *c, const gen_sample *s, int format, const char *path)
{
    kw_mesh *m = hierset_new(c, s);
    int failed = format == MESH ? kw_meshfile_write(m, path)
                                : write_geometry(c, s, m, format, path);

    kw_mesh_free(m);
    return failed;
}

const gen_family gen_thb = {
    .name = "thb",
    .summary = "THB- and HB-spline geometries on random hierarchical meshes",
    .about = "A sample is a geometry over the unit interval, square or cube in the "
             "THB-splines (or\n"
             "HB-splines) of a random hierarchical mesh, and points of it. The mesh is "
             "one of the kinds\n"
             "of gen mesh --help. Coefficients are Greville points and a random height, "
             "which halves\n"
             "from level to level; so in THB-splines the geometry is the graph of a "
             "function.\n",
    .example = "--cells 4 --levels 3 --points 50 --format csv,npy,xml",
    .stream = 8,
    .parameter =
        {
            HIER_FIRST_PARAMETERS,
            [BASIS] = {"--basis", GEN_WORD, "thb", 0, 0, "thb hb", "the functions"},
            [POINTS_OF] = {"--points", GEN_WHOLE, "1000", 1, 1000000, NULL, "points"},
            [HEIGHT] = {"--height", GEN_REAL, "1", 0, 1000, NULL, "of level 0, at most"},
            [NOISE] = {"--noise", GEN_REAL, "0", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .format = {"mesh", "xml", "vtu"},
    .check = hierset_check,
    .plan = plan,
    .make = make,
    .write = write,
};
