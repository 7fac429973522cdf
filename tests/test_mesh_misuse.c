/* What a caller of a mesh may not do: the process that tries ends by abort. */
#include "mesh.h"
#include "meshes.h"
#include <math.h>

static const int ZERO[D_MOST] = {0};

static kw_mesh *small(void)
{
    return kw_mesh_new(meshes_uniform(2, 2, 3));
}

static void refine_level_beyond(void)
{
    const int high[] = {1, 1};

    kw_mesh_refine(small(), 1, ZERO, high);
}

static void refine_level_before(void)
{
    const int high[] = {1, 1};

    kw_mesh_refine(small(), -1, ZERO, high);
}

static void box_beyond(void)
{
    const int high[] = {1, 4};

    kw_mesh_refine(small(), 0, ZERO, high);
}

static void box_before(void)
{
    const int low[] = {-1, 0}, high[] = {1, 1};

    kw_mesh_refine(small(), 0, low, high);
}

static void box_backwards(void)
{
    const int low[] = {2, 0}, high[] = {1, 1};

    kw_mesh_refine(small(), 0, low, high);
}

static void cell_beyond(void)
{
    const int cell[] = {0, 3};

    kw_mesh_inside(small(), 0, cell);
}

static void point_beyond(void)
{
    const double x[] = {1, 3.5};
    int cell[2];

    kw_mesh_locate(small(), x, cell);
}

static void cells_of_no_level(void)
{
    long long count;

    kw_mesh_cells(small(), 2, &count);
}

static void no_direction(void)
{
    kw_mesh_new_direction(small(), 2);
}

static void multi_of_no_level(void)
{
    int cell[2];

    kw_mesh_multi(small(), 1, 0, cell);
}

static void active_of_no_level(void)
{
    kw_mesh_active(small(), -1);
}

static void refined_cell_before(void)
{
    const int cell[] = {-1, 0};

    kw_mesh_refined(small(), 0, cell);
}

static void nowhere(void)
{
    const double x[] = {NAN, 0};
    int cell[2];

    kw_mesh_locate(small(), x, cell);
}

/* Three directions of 2^10 cells that are refined until a level would have 2^63 of them. */
static void too_many_cells(void)
{
    kw_mesh *m = kw_mesh_new(meshes_uniform(3, 1, 1024));
    const int one[] = {1, 1, 1};

    for (int level = 0; level < 12; level++)
        kw_mesh_refine(m, level, ZERO, one);
}

static void boxes_lie_in_the_level(void)
{
    test_aborts("level 1, not in 0 .. 0", refine_level_beyond);
    test_aborts("level -1, not in 0 .. 0", refine_level_before);
    test_aborts("cells 0 .. 3 of direction 1 on level 0, not in 0 .. 2", box_beyond);
    test_aborts("cells -1 .. 0 of direction 0 on level 0, not in 0 .. 2", box_before);
    test_aborts("cells 2 .. 0 of direction 0 on level 0", box_backwards);
}

static void cells_lie_in_the_level(void)
{
    test_aborts("cell 3 of direction 1 on level 0, not in 0 .. 2", cell_beyond);
    test_aborts("cell -1 of direction 0 on level 0, not in 0 .. 2", refined_cell_before);
    test_aborts("level 2, not in 0 .. 0", cells_of_no_level);
    test_aborts("level 1, not in 0 .. 0", multi_of_no_level);
    test_aborts("level -1, not in 0 .. 0", active_of_no_level);
    test_aborts("direction 2, not in 0 .. 1", no_direction);
}

static void points_lie_in_the_domain(void)
{
    test_aborts("x = 3.5 outside the domain [0, 3]", point_beyond);
    test_aborts("x = nan outside the domain [0, 3]", nowhere);
}

static void indices_stay_small(void)
{
    test_aborts("functions on level 11", too_many_cells);
}

static void nothing_may_be_freed(void)
{
    kw_mesh_free(NULL);
}

int main(void)
{
    test_run("mesh: levels and boxes outside abort", boxes_lie_in_the_level);
    test_run("mesh: cells, levels and directions outside abort", cells_lie_in_the_level);
    test_run("mesh: points outside abort", points_lie_in_the_domain);
    test_run("mesh: more cells than an index may count abort", indices_stay_small);
    test_run("mesh: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
