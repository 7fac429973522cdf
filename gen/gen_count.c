/* gen count -- how many active cells and functions each level of a mesh has. */
#include "active.h"
#include "gen.h"
#include "size.h"
#include <stdio.h>

static int run(const char *const *value)
{
    kw_mesh *m = gen_mesh(value[0]);
    kw_active *a;

    if (!m)
        return GEN_BAD_INPUT;
    if (size_check_active(m, value[0]) != GEN_GOOD) {
        kw_mesh_free(m);
        return GEN_BAD_INPUT;
    }
    a = kw_active_new(m);
    puts("level,active_cells,functions");
    for (int l = 0; l < m->levels; l++)
        printf("%d,%lld,%d\n", l, kw_mesh_active(m, l), a->start[l + 1] - a->start[l]);
    kw_active_free(a);
    kw_mesh_free(m);
    return GEN_GOOD;
}

const gen_command gen_count = {
    .name = "count",
    .summary = "active cells and functions of each level of a mesh",
    .help =
        "usage: gen count --mesh FILE\n"
        "\n"
        "Prints CSV, a line for each level of a hierarchical mesh: how many cells of\n"
        "the level are not refined, and how many of its B-splines are in the\n"
        "hierarchical basis (HB and THB have equally many).\n"
        "\n"
        "  --mesh FILE  lines `degree' (one a direction), `knots' (a line a direction),\n"
        "               `refine LEVEL LOW ... HIGH ...' (the cells LOW .. HIGH-1)\n"
        "\n"
        "A level halves every span t, t' of the level before, at the double\n"
        "t + (t' - t) / 2. Auxiliary spans, outside the domain, are halved too, and the\n"
        "d knots nearest to the domain are kept on each side: for degree 2 the knots\n"
        "-2 -1 0 1 .. become -1 -0.5 0 0.5 1 .. , at an open end 0 0 0 1 .. become\n"
        "0 0 0 0.5 1 .. .\n"
        "\n" SIZE_HELP "\n"
        "For example, 4 x 4 cells of degree 2, their inner 2 x 2 cells refined, and\n"
        "of these the inner part once more, in boxes.mesh:\n"
        "\n"
        "  degree 2 2\n"
        "  knots 0 0 0 1 2 3 4 4 4\n"
        "  knots 0 0 0 1 2 3 4 4 4\n"
        "  refine 0  1 1  3 3\n"
        "  refine 1  2 2  5 5\n"
        "\n"
        "gen count --mesh boxes.mesh prints\n"
        "\n"
        "  level,active_cells,functions\n"
        "  0,12,36\n"
        "  1,7,3\n"
        "  2,36,16\n",
    .option = {{"--mesh", 1}},
    .run = run,
};
