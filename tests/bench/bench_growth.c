/* bench_growth.c -- how cost grows with points, degree, spans and levels: all that should stay
   flat, and what does not. Writes build/bench.dat, which tests/bench/ex_bench.gp draws.

   Unless a table says otherwise: degree 3, 100 spans, POINTS random points, coefficients in R^3;
   hierarchical splines of degree 2 on a mesh refined along its diagonal. */
#include "bench.h"
#include "need.h"
#include "out.h"
#include "work_hier.h"
#include "work_spline.h"
#include <malloc.h>
#include <stdio.h>
#include <string.h>

enum {
    POINTS = 100000,
    FEWEST = 1000,
    SIZES = 5, /* of sets of points: 10^3 .. 10^7 */
    DEGREES = 7,
    SPREADS = 6, /* of spans: 10 .. 10^6 */
    SPANS = 100,
    CELLS = 16,
    LEVELS = 12,
    FEW = 1000, /* points on levels: so few that what they need stays in the cache */
    ROOM = 8    /* numbers of a point */
};

/* A word above each column. */
static void print_header(const char *header)
{
    while (*header) {
        int length = (int)strcspn(header, " ");

        printf("%15.*s", length, header);
        header += length + (header[length] == ' ');
    }
    printf("\n");
}

/* One table and one section of the data: a row for each of `rows` sizes, with the medians of
   `columns` tasks each. */
static void show(kw_out *f, const char *section, const char *header, int rows,
                 const double *size, int columns, bench_task *task)
{
    bench_run(rows * columns, task);
    printf("\nnanoseconds by %s\n", section);
    print_header(header);
    kw_out_section(f, section, header);
    for (int i = 0; i < rows; i++) {
        printf("%15.0f", size[i]);
        kw_out_number(f, size[i]);
        for (int j = 0; j < columns; j++) {
            printf("%15.1f", task[i * columns + j].median);
            kw_out_number(f, task[i * columns + j].median);
        }
        kw_out_row(f);
        printf("\n");
    }
    fflush(stdout);
}

/* The columns of the first three tables. */
static void set_pair(bench_task *task, spline_work *w)
{
    task[0] = (bench_task){.work = work_basis, .with = w, .per = w->count};
    task[1] = (bench_task){.work = work_curve, .with = w, .per = w->count};
}

static const char *const pair = "size basis curve";

static void by_points(kw_out *f)
{
    spline_work part[SIZES], *all;
    double size[SIZES];
    bench_task task[2 * SIZES];
    int count = FEWEST;

    for (int i = 0; i < SIZES; i++, count *= 10)
        size[i] = count;
    all = spline_work_new(3, SPANS, 1, (int)size[SIZES - 1], 4);
    for (int i = 0; i < SIZES; i++) {
        part[i] = *all;
        part[i].count = (int)size[i];
        set_pair(&task[2 * i], &part[i]);
    }
    show(f, "points", pair, SIZES, size, 2, task);
    spline_work_free(all);
}

static void by_degree(kw_out *f)
{
    spline_work *w[DEGREES];
    double size[DEGREES];
    bench_task task[2 * DEGREES];

    for (int i = 0; i < DEGREES; i++) {
        size[i] = i + 1;
        w[i] = spline_work_new(i + 1, SPANS, 1, POINTS, ROOM);
        set_pair(&task[2 * i], w[i]);
    }
    show(f, "degree", pair, DEGREES, size, 2, task);
    for (int i = 0; i < DEGREES; i++)
        spline_work_free(w[i]);
}

static void by_spans(kw_out *f)
{
    spline_work *w[SPREADS];
    double size[SPREADS];
    bench_task task[2 * SPREADS];
    int spans = 10;

    for (int i = 0; i < SPREADS; i++, spans *= 10) {
        size[i] = spans;
        w[i] = spline_work_new(3, spans, 1, POINTS, ROOM);
        set_pair(&task[2 * i], w[i]);
    }
    show(f, "spans", pair, SPREADS, size, 2, task);
    for (int i = 0; i < SPREADS; i++)
        spline_work_free(w[i]);
}

static void by_levels(kw_out *f)
{
    enum { ROWS = LEVELS / 2, COLUMNS = 4 };
    hier_work *w[ROWS], hb[ROWS];
    double size[ROWS];
    bench_task task[ROWS * COLUMNS];

    for (int i = 0; i < ROWS; i++) {
        bench_task *t = &task[i * COLUMNS];

        size[i] = 2 * i + 2;
        w[i] = hier_work_new(2, CELLS, (int)size[i] - 1, FEW);
        hb[i] = *w[i];
        hb[i].kind = KW_HB;
        t[0] =
            (bench_task){.work = work_build, .with = w[i], .per = w[i]->b->active->size};
        t[1] = (bench_task){.work = work_hierpieces, .with = w[i], .per = FEW};
        t[2] = (bench_task){.work = work_functions, .with = w[i], .per = FEW};
        t[3] = (bench_task){.work = work_functions, .with = &hb[i], .per = FEW};
    }
    show(f, "levels", "size build-function surface-point THB-functions HB-functions",
         ROWS, size, COLUMNS, task);
    print_header("size functions bytes-each listed-a-point");
    for (int i = 0; i < ROWS; i++) {
        printf("%15.0f%15d%15.0f%15.1f\n", size[i], w[i]->b->active->size,
               (double)kw_hier_bytes(w[i]->b) / w[i]->b->active->size, w[i]->listed);
        hier_work_free(w[i]);
    }
}

int main(void)
{
    kw_out *f = kw_out_new(KW_BUILD "/bench.dat");

    /* A basis is built in new memory each time, whatever was built before. */
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
    by_points(f);
    by_degree(f);
    by_spans(f);
    by_levels(f);
    KW_NEED(kw_out_close(f) == 0, "no data");
    return 0;
}
