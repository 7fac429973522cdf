#include "tensor.h"
#include "test.h"
#include <math.h>

/* Two directions: 5 functions of degree 2 and 4 of degree 1, on [0,3] x [0,3]. The process
   that asks for them ends by abort. */
static kw_tensor *pair(void)
{
    const kw_bspline *s[] = {kw_bspline_new_open_uniform(2, 3, 0, 3),
                             kw_bspline_new_open_uniform(1, 3, 0, 3)};

    return kw_tensor_new(2, s);
}

static void no_direction(void)
{
    const kw_bspline *s[] = {kw_bspline_new_open_uniform(2, 3, 0, 3)};

    kw_tensor_new(0, s);
}

static void four_directions(void)
{
    const kw_bspline *one = kw_bspline_new_open_uniform(2, 3, 0, 3);
    const kw_bspline *s[] = {one, one, one, one};

    kw_tensor_new(4, s);
}

static void directions_are_1_to_3(void)
{
    test_aborts("D = 0, not in 1 .. 3", no_direction);
    test_aborts("D = 4, not in 1 .. 3", four_directions);
}

/* 65536 x 32768 = 2^31, one more than an int holds */
static void too_many_functions(void)
{
    const kw_bspline *s[] = {kw_bspline_new_open_uniform(0, 65536, 0, 1),
                             kw_bspline_new_open_uniform(0, 32768, 0, 1)};

    kw_tensor_new(2, s);
}

static void as_many_functions_as_an_int_holds(void)
{
    kw_bspline *s[] = {kw_bspline_new_open_uniform(0, 65536, 0, 1),
                       kw_bspline_new_open_uniform(0, 32767, 0, 1)};
    kw_tensor *g = kw_tensor_new(2, (const kw_bspline *const *)s);
    const int last[] = {65535, 32766};

    CHECK(kw_tensor_dimension(g) == 65536 * 32767, "%d", kw_tensor_dimension(g));
    CHECK(kw_tensor_flat(g, last) == 65536 * 32767 - 1, "%d", kw_tensor_flat(g, last));
    kw_tensor_free(g);
    kw_bspline_free(s[0]);
    kw_bspline_free(s[1]);
    test_aborts("more than 2147483647 functions", too_many_functions);
}

static void flat_beyond(void)
{
    const int j[] = {0, 4};

    kw_tensor_flat(pair(), j);
}

static void flat_before(void)
{
    const int j[] = {-1, 0};

    kw_tensor_flat(pair(), j);
}

static void multi_beyond(void)
{
    int j[2];

    kw_tensor_multi(pair(), 20, j);
}

static void multi_before(void)
{
    int j[2];

    kw_tensor_multi(pair(), -1, j);
}

static void one_beyond(void)
{
    const int j[] = {5, 0};
    const double x[] = {1, 1};

    kw_tensor_one(pair(), j, NULL, x);
}

static void another_direction(void)
{
    kw_tensor_new_direction(pair(), 2, kw_bspline_new_open_uniform(2, 3, 0, 3));
}

static void indices_are_in_range(void)
{
    test_aborts("index 4 of direction 1, not in 0 .. 3", flat_beyond);
    test_aborts("index -1 of direction 0, not in 0 .. 4", flat_before);
    test_aborts("index 20, not in 0 .. 19", multi_beyond);
    test_aborts("index -1, not in 0 .. 19", multi_before);
    test_aborts("function 5, not in 0 .. 4", one_beyond);
    test_aborts("direction 2, not in 0 .. 1", another_direction);
}

static const double NONE[20] = {0};

/* Evaluates at (x, y), differentiating `order` times in direction 1. */
static void evaluate(double x, double y, int order)
{
    const double at[] = {x, y};
    const int orders[] = {0, order};
    double point[1];

    kw_tensor_point(pair(), 1, NONE, orders, at, point);
}

static void outside_to_the_right(void)
{
    evaluate(1, 3.5, 0);
}

static void outside_to_the_left(void)
{
    evaluate(-0.5, 1, 0);
}

static void nowhere(void)
{
    evaluate(NAN, 1, 0);
}

static void negative_order(void)
{
    evaluate(1, 1, -1);
}

static void grid_outside(void)
{
    const double x[] = {1, 4}, y[] = {1};
    const double *const lines[] = {x, y};
    const int count[] = {2, 1};
    double work[8], point[2];

    kw_tensor_grid(pair(), 1, NONE, NULL, count, lines, work, point);
}

static void negative_count(void)
{
    const double x[] = {1, 1};
    double point[1];

    kw_tensor_point_many(pair(), 1, NONE, NULL, -1, x, point);
}

static void grid_of_a_negative_count(void)
{
    const double x[] = {1};
    const double *const lines[] = {x, x};
    const int count[] = {1, -4};
    double work[8], point[2];

    kw_tensor_grid(pair(), 1, NONE, NULL, count, lines, work, point);
}

static void room_for_a_negative_count(void)
{
    const int count[] = {-5, 1};

    kw_tensor_grid_work(pair(), 1, count);
}

static void no_coordinate(void)
{
    const double x[] = {1, 1};
    double point[1];

    kw_tensor_point(pair(), 0, NONE, NULL, x, point);
}

static void points_are_in_the_domain(void)
{
    test_aborts("x = 3.5 outside the domain [0, 3]", outside_to_the_right);
    test_aborts("x = -0.5 outside the domain [0, 3]", outside_to_the_left);
    test_aborts("x = nan outside the domain", nowhere);
    test_aborts("x = 4 outside the domain [0, 3]", grid_outside);
    test_aborts("derivative -1", negative_order);
    test_aborts("N = 0", no_coordinate);
    test_aborts("-1 points", negative_count);
    test_aborts("-4 points in direction 1", grid_of_a_negative_count);
    test_aborts("-5 points in direction 0", room_for_a_negative_count);
}

static void refine_to_a_coarser_space(void)
{
    kw_tensor *g = pair();
    const kw_bspline *coarse = kw_bspline_new_open_uniform(2, 2, 0, 3);
    double work[20], out[20];

    kw_tensor_refine(g, kw_tensor_new_direction(g, 0, coarse), 1, NONE, work, out);
}

static void refine_to_fewer_directions(void)
{
    kw_tensor *g = pair();
    const kw_bspline *s[] = {g->s[0]};
    double work[20], out[20];

    kw_tensor_refine(g, kw_tensor_new(1, s), 1, NONE, work, out);
}

static void refined_spaces_are_nested(void)
{
    test_aborts("the coarse knot 1 (t[3]) is missing", refine_to_a_coarser_space);
    test_aborts("2 and 1 directions", refine_to_fewer_directions);
}

static void nothing_may_be_freed(void)
{
    kw_tensor_free(NULL);
}

int main(void)
{
    test_run("tensor: no direction and four directions abort", directions_are_1_to_3);
    test_run("tensor: more functions than an int counts abort",
             as_many_functions_as_an_int_holds);
    test_run("tensor: indices out of range abort", indices_are_in_range);
    test_run("tensor: points outside and impossible orders abort",
             points_are_in_the_domain);
    test_run("tensor: spaces that are not nested abort", refined_spaces_are_nested);
    test_run("tensor: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
