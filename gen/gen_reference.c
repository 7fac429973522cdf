/* gen reference -- values of the HB- or THB-splines of a mesh at given points. */
#include "gen.h"
#include "hier.h"
#include "need.h"
#include "points.h"
#include "size.h"
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* In the order of the command's options. */
enum { MESH, AT, BASIS, DERIVATIVE };

/* What is asked for, and room for the answer at one point. */
typedef struct task {
    kw_hier *b;
    kw_hier_kind kind;
    int r[KW_TENSOR_D]; /* orders of the derivative */
    size_t count;       /* of points */
    double *x;          /* count x D */
    int *index;         /* b->most functions */
    double *value;      /* and their values */
} task;

static int read_basis(const char *word, kw_hier_kind *kind)
{
    *kind = strcmp(word, "thb") == 0 ? KW_THB : KW_HB;
    if (*kind == KW_HB && strcmp(word, "hb") != 0)
        return gen_say(GEN_BAD_CALL, "--basis is `%s', not thb or hb", word);
    return GEN_GOOD;
}

/* The orders "a,b", one a direction. */
static int read_derivative(const char *word, int D, int *r)
{
    const char *at = word;

    for (int h = 0; h < D; h++) {
        char *end;
        long order = strtol(at, &end, 10);

        if (*at < '0' || *at > '9' || order > INT_MAX || *end != (h + 1 < D ? ',' : 0))
            return gen_say(GEN_BAD_CALL,
                           "--derivative is `%s', not %d orders, which are >= 0, "
                           "separated by commas",
                           word, D);
        r[h] = (int)order;
        at = end + 1;
    }
    return GEN_GOOD;
}

/* Knots very close to each other have derivatives that no double holds. Values lie in [0,1]. */
static int check_finite(const task *t, const char *path)
{
    int D = t->b->active->mesh->D, order = 0;

    for (int h = 0; h < D; h++)
        order = t->r[h] > order ? t->r[h] : order;
    for (size_t p = 0; order > 0 && p < t->count; p++) {
        int count =
            kw_hier_at(t->b, t->kind, t->r, t->x + p * (size_t)D, t->index, t->value);

        for (int i = 0; i < count; i++)
            if (!isfinite(t->value[i]))
                return gen_say(GEN_BAD_INPUT, "%s: point %zu: a value is not finite: %g",
                               path, p, t->value[i]);
    }
    return GEN_GOOD;
}

static void print_point(const task *t, size_t p)
{
    int D = t->b->active->mesh->D;
    int count = kw_hier_at(t->b, t->kind, t->r, t->x + p * (size_t)D, t->index, t->value);

    for (int i = 0; i < count; i++) {
        int level, j[KW_TENSOR_D];

        if (t->value[i] == 0)
            continue;
        kw_active_function(t->b->active, t->index[i], &level, j);
        printf("%zu,%d", p, level);
        for (int h = 0; h < D; h++)
            printf(",%d", j[h]);
        printf(",%.17g\n", t->value[i]);
    }
}

static void print_all(const task *t)
{
    printf("point,level");
    for (int h = 0; h < t->b->active->mesh->D; h++)
        printf(",j%d", h + 1);
    printf(",value\n");
    for (size_t p = 0; p < t->count && !ferror(stdout); p++)
        print_point(t, p);
}

static int answer(task *t, const kw_mesh *m, const char *mesh, const char *path)
{
    int status = size_check_basis(m, mesh);

    if (status != GEN_GOOD)
        return status;
    t->b = kw_hier_new(m);
    t->index = kw_need_memory((size_t)t->b->most, sizeof *t->index);
    t->value = kw_need_memory((size_t)t->b->most, sizeof *t->value);
    status = check_finite(t, path);
    if (status == GEN_GOOD)
        print_all(t);
    free(t->value);
    free(t->index);
    kw_hier_free(t->b);
    return status;
}

static int run(const char *const *value)
{
    task t = {.kind = KW_THB};
    kw_mesh *m;
    int status = read_basis(value[BASIS], &t.kind);

    if (status != GEN_GOOD)
        return status;
    m = gen_mesh(value[MESH]);
    if (!m)
        return GEN_BAD_INPUT;
    if (value[DERIVATIVE])
        status = read_derivative(value[DERIVATIVE], m->D, t.r);
    if (status == GEN_GOOD && points_read(value[AT], m, &t.count, &t.x) != 0)
        status = GEN_BAD_INPUT;
    if (status == GEN_GOOD)
        status = answer(&t, m, value[MESH], value[AT]);
    free(t.x);
    kw_mesh_free(m);
    return status;
}

const gen_command gen_reference = {
    .name = "reference",
    .summary = "values of HB- or THB-splines at points",
    .help =
        "usage: gen reference --mesh FILE --at POINTS --basis thb|hb [--derivative A,B]\n"
        "\n"
        "Prints CSV, a line for each function of the hierarchical basis that is not "
        "zero\n"
        "at a point, ordered by point, level and multi-index j. Points and indices "
        "count\n"
        "from 0; values have 17 digits, which give back the same double.\n"
        "\n"
        "  --mesh FILE       the mesh; see gen count --help\n"
        "  --at POINTS       CSV: the header x1,x2 (as many as directions), then a line\n"
        "                    for each point; points lie in the closed domain\n"
        "  --basis thb|hb    truncated hierarchical B-splines, or not truncated ones\n"
        "  --derivative A,B  orders, one a direction; the values themselves if left "
        "out.\n"
        "                    A derivative that jumps at an edge of cells is the one "
        "from\n"
        "                    behind the edge, at the right end the one from within\n"
        "\n"
        "Knots of finer levels are the doubles t + (t' - t) / 2, made level by level\n"
        "from those of the file; lib/meshfile.h says what becomes of auxiliary knots.\n"
        "With respect to these doubles values are right to n 2^-53, where L levels and\n"
        "the degrees d have at most\n"
        "\n"
        "  n = (L-1) sum (6d+1) + sum (5d+1) + product (d+1) + 1\n"
        "\n"
        "roundings: below 1e-14 for degree 2 in two directions and 3 levels. The tests\n"
        "hold 1e-14 for degrees 1 to 3 on 9 levels of decimal knots. Who takes exact\n"
        "middles of decimal knots, or (t + t') / 2, may get other knots, and values\n"
        "that differ by about ulp(t) / (t' - t). Derivatives are right to n 2^-53 times\n"
        "the sum of the absolute values of their terms, of size (2d / cell)^order: one\n"
        "that is zero may come out as a rounded zero, a line with a small number.\n"
        "\n" SIZE_HELP "\n"
        "For example, hats on two cells, the right one halved, in hats.mesh:\n"
        "\n"
        "  degree 1\n"
        "  knots 0 0 1 2 2\n"
        "  refine 0  1  2\n"
        "\n"
        "and in points.csv:\n"
        "\n"
        "  x1\n"
        "  0.25\n"
        "  1.25\n"
        "\n"
        "gen reference --mesh hats.mesh --at points.csv --basis thb prints\n"
        "\n"
        "  point,level,j1,value\n"
        "  0,0,0,0.75\n"
        "  0,0,1,0.25\n"
        "  1,0,1,0.5\n"
        "  1,1,3,0.5\n",
    .option = {{"--mesh", 1}, {"--at", 1}, {"--basis", 1}, {"--derivative", 0}},
    .run = run,
};
