/* bench_hier.c -- what a hierarchical basis costs as levels are added along a diagonal: the
   columns should stay flat. The ratios are to the first row of each degree. */
#include "bench.h"
#include "hierpieces.h"
#include "need.h"
#include "rng.h"
#include <malloc.h>
#include <stdio.h>

/* So few points that what they need stays in the cache: the table shows work, not memory. */
enum { CELLS = 16, POINTS = 200, TURNS = 100, COLUMNS = 5 };

typedef struct task {
    kw_mesh *m;
    kw_hier *b;
    kw_hier_kind kind;
    double *x; /* POINTS x 2 */
    double *c; /* a coefficient for each function */
    kw_hierpieces *p;
    double *y;     /* POINTS */
    int *index;    /* b->most */
    double *value; /* b->most */
    double found;  /* functions that are not zero, on average */
} task;

/* 16 x 16 cells, refined so many times: on every level but the last the cells with
   |i-j| <= d. With 12 times the finest grid has 65536 x 65536 cells. */
static kw_mesh *new_diagonal(int d, int times)
{
    kw_bspline *s = kw_bspline_new_open_uniform(d, CELLS, 0, 1);
    const kw_bspline *both[] = {s, s};
    kw_tensor *g = kw_tensor_new(2, both);
    kw_mesh *m = kw_mesh_new(g);

    for (int l = 0; l < times; l++) {
        int cells = CELLS << l;

        for (int i = 0; i < cells; i++) {
            int low[] = {i, i > d ? i - d : 0};
            int high[] = {i + 1, i + d < cells ? i + d + 1 : cells};

            kw_mesh_refine(m, l, low, high);
        }
    }
    kw_tensor_free(g);
    kw_bspline_free(s);
    return m;
}

static double build(void *with)
{
    const task *t = with;
    kw_hier *b = kw_hier_new(t->m);
    double size = b->active->size;

    kw_hier_free(b);
    return size;
}

static double surface(void *with)
{
    const task *t = with;

    for (int turn = 0; turn < TURNS; turn++)
        kw_hierpieces_point_many(t->p, NULL, POINTS, t->x, t->y);
    return t->y[POINTS - 1];
}

static double functions(void *with)
{
    task *t = with;
    double found = 0;

    for (int turn = 0; turn < TURNS; turn++)
        for (int p = 0; p < POINTS; p++)
            found += kw_hier_at(t->b, t->kind, NULL, t->x + 2 * p, t->index, t->value) +
                     0 * t->value[0];
    t->found = found / (TURNS * POINTS);
    return found;
}

/* Half of the points anywhere, half of them in the finest cells. */
static void choose_points(double *x)
{
    kw_rng r = kw_rng_at(1, 0, 0, 0);

    for (int i = 0; i < POINTS; i++) {
        x[2 * i] = kw_rng_uniform(&r);
        x[2 * i + 1] = i % 2 == 0 ? kw_rng_uniform(&r) : x[2 * i];
    }
}

/* One row: time and bytes to build, per function; time of a surface point; time to list the
   functions at a point, for each of them: THB, HB. */
static int measure(int d, int times, double *column)
{
    task t = {.m = new_diagonal(d, times)};
    int size;

    t.b = kw_hier_new(t.m);
    size = t.b->active->size;
    t.x = kw_need_memory((size_t)2 * POINTS, sizeof *t.x);
    t.y = kw_need_memory(POINTS, sizeof *t.y);
    t.c = kw_need_memory((size_t)size, sizeof *t.c);
    t.index = kw_need_memory((size_t)t.b->most, sizeof *t.index);
    t.value = kw_need_memory((size_t)t.b->most, sizeof *t.value);
    for (int i = 0; i < size; i++)
        t.c[i] = i;
    choose_points(t.x);
    t.p = kw_hierpieces_new(t.b, KW_THB, 1, t.c);
    column[0] = bench_median(build, &t) / size;
    column[1] = (double)kw_hier_bytes(t.b) / size;
    column[2] = bench_median(surface, &t) / (POINTS * TURNS);
    t.kind = KW_THB;
    column[3] = bench_median(functions, &t) / (POINTS * TURNS) / t.found;
    t.kind = KW_HB;
    column[4] = bench_median(functions, &t) / (POINTS * TURNS) / t.found;
    free(t.x);
    free(t.y);
    free(t.c);
    free(t.index);
    free(t.value);
    kw_hierpieces_free(t.p);
    kw_hier_free(t.b);
    kw_mesh_free(t.m);
    return size;
}

int main(void)
{
    /* Else small bases would be built again and again in the same memory, and large ones in
       memory that is new each time, which costs as much again. */
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
    printf("hierarchical splines refined along a diagonal; in brackets the ratio to the "
           "first row of the degree\n"
           "                        to build, a function:           a surface point   "
           "a function that is not zero there\n"
           "degree times functions       ns              bytes              ns        "
           "   THB ns           HB ns\n");
    for (int d = 2; d <= 3; d++) {
        double first[COLUMNS] = {0}, column[COLUMNS];

        for (int times = 4; times <= 12; times += 2) {
            int size = measure(d, times, column);

            printf("%6d %5d %9d", d, times, size);
            for (int i = 0; i < COLUMNS; i++) {
                if (times == 4)
                    first[i] = column[i];
                printf("  %8.1f (%4.2f)", column[i], column[i] / first[i]);
            }
            printf("\n");
            fflush(stdout);
        }
    }
    return 0;
}
