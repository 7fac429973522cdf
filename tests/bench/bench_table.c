/* bench_table.c -- what evaluation costs: the median of several runs of each work, what that is
   compared with, and whether the aim holds. Where the GNU Scientific Library is installed it
   does the same works in turn with ours. All medians, with the least and the most of the runs,
   go to build/bench.csv.

   Unless a name says otherwise: degree 3, 100 spans, random points, coefficients in R^3. */
#include "bench.h"
#include "machine.h"
#include "need.h"
#include "out.h"
#include "work_gsl.h"
#include "work_hier.h"
#include "work_net.h"
#include "work_spline.h"
#include <malloc.h>
#include <stdio.h>

enum {
    POINTS = 1000000,
    FEW = 20000, /* points for a peer that looks at every knot */
    SPANS = 100,
    MANY_SPANS = 10000,
    REFINED = 100000, /* coefficients */
    NUMBERS = WORK_N * (1 + WORK_DERIVATIVES),
    CELLS = 16,
    LEVELS = 5, /* of the mesh with the points */
    BUILT_LEVELS = 8,
    PEERS = 5
};

/* The rows of the table; those of the peer come last, so that they can be left out. */
enum {
    BASIS,
    MANY,
    CURVE,
    CURVE2,
    SURFACE,
    GRID,
    REFINE,
    REFINE_SPACE,
    BASIS2,
    THB_BASIS,
    SURFACE2,
    THB_SURFACE,
    BUILD,
    MLP,
    MULTIPLY_ADD,
    FUSED,
    TRIAD,
    OURS,
    GSL_BASIS = OURS,
    GSL_MANY,
    GSL_CURVE,
    GSL_CURVE2,
    GSL_SURFACE,
    ALL
};

/* A rate is given as so many units in a nanosecond, all else as so many nanoseconds. */
typedef struct row {
    const char *what, *who, *unit;
    double nanoseconds; /* of a unit */
    int rate;
} row;

static const row name[ALL] = {
    [BASIS] = {"basis", "knotwork", "ns/point", 1, 0},
    [MANY] = {"basis-10000", "knotwork", "ns/point", 1, 0},
    [CURVE] = {"curve", "knotwork", "ns/point", 1, 0},
    [CURVE2] = {"curve2", "knotwork", "ns/point", 1, 0},
    [SURFACE] = {"surface", "knotwork", "ns/point", 1, 0},
    [GRID] = {"grid", "knotwork", "ns/point", 1, 0},
    [REFINE] = {"refine", "knotwork", "ms", 1e6, 0},
    [REFINE_SPACE] = {"refine-space", "knotwork", "ms", 1e6, 0},
    [BASIS2] = {"biquadratic-basis", "knotwork", "ns/point", 1, 0},
    [THB_BASIS] = {"thb-basis", "knotwork", "ns/point", 1, 0},
    [SURFACE2] = {"biquadratic-surface", "knotwork", "ns/point", 1, 0},
    [THB_SURFACE] = {"thb-surface", "knotwork", "ns/point", 1, 0},
    [BUILD] = {"thb-build", "knotwork", "us/function", 1e3, 0},
    [MLP] = {"mlp", "knotwork", "ns/sample", 1, 0},
    [MULTIPLY_ADD] = {"multiply-add", "machine", "Gflop/s", 2, 1},
    [FUSED] = {"fused-multiply-add", "machine", "Gflop/s", 2, 1},
    [TRIAD] = {"memory", "machine", "GB/s", 1, 1},
    [GSL_BASIS] = {"basis", "gsl", "ns/point", 1, 0},
    [GSL_MANY] = {"basis-10000", "gsl", "ns/point", 1, 0},
    [GSL_CURVE] = {"curve", "gsl", "ns/point", 1, 0},
    [GSL_CURVE2] = {"curve2", "gsl", "ns/point", 1, 0},
    [GSL_SURFACE] = {"surface", "gsl", "ns/point", 1, 0}};

/* --- what is compared --- */

/* `what` takes so many times as long as `against`, and `most` is the aim (0: none). */
typedef struct comparison {
    int what, against;
    double most;
} comparison;

static const comparison compared[] = {
    {BASIS, GSL_BASIS, 1 / 8.0}, {MANY, GSL_MANY, 0},          {MANY, BASIS, 2},
    {CURVE, GSL_CURVE, 1 / 8.0}, {CURVE2, GSL_CURVE2, 0.2},    {SURFACE, GSL_SURFACE, 0},
    {SURFACE, CURVE, 3},         {GRID, CURVE, 0.5},           {THB_BASIS, BASIS2, 4},
    {THB_BASIS, SURFACE2, 4},    {THB_SURFACE, SURFACE2, 1.5}, {MLP, FUSED, 2.5},
    {MLP, MULTIPLY_ADD, 0}};

/* What takes at most so many units. */
static const struct limit {
    int what;
    double most;
} limited[] = {{REFINE, 1}, {BUILD, 4.5}};

static double in_units(int i, double time)
{
    return name[i].rate ? name[i].nanoseconds / time : time / name[i].nanoseconds;
}

static void print_row(kw_out *csv, int i, const bench_task *t)
{
    double median = in_units(i, t->median), min = in_units(i, t->min),
           max = in_units(i, t->max);
    double least = name[i].rate ? max : min, most = name[i].rate ? min : max;

    printf("%-20s %-9s %-12s %8.2f %8.2f %8.2f\n", name[i].what, name[i].who,
           name[i].unit, median, least, most);
    kw_out_text(csv, "%s,%s,%s,%.6g,%.6g,%.6g\n", name[i].what, name[i].who, name[i].unit,
                median, least, most);
}

static void print_rows(int rows, const bench_task *task)
{
    kw_out *csv = kw_out_new(KW_BUILD "/bench.csv");

    printf("work                 who       unit           median    least     most\n");
    kw_out_text(csv, "work,who,unit,median,min,max\n");
    for (int i = 0; i < rows; i++)
        print_row(csv, i, &task[i]);
    KW_NEED(kw_out_close(csv) == 0, "no table");
}

static const char *judged(double found, double most)
{
    return most <= 0 ? "" : found <= most ? "holds" : "does not hold";
}

/* Medians, and behind them the least of all runs: where these differ much, the machine had other
   work to do, and another run tells more. products: the multiply-adds of a sample. */
static void print_comparisons(int rows, const bench_task *task, double products)
{
    printf(
        "\nwork                 takes  (least)  of                                aim\n");
    for (size_t i = 0; i < sizeof compared / sizeof *compared; i++) {
        const comparison *c = &compared[i];
        double ratio, least, each = c->what == MLP ? products : 1;

        if (c->against >= rows)
            continue;
        ratio = bench_ratio(&task[c->what], &task[c->against]) / each;
        least = task[c->what].min / task[c->against].min / each;
        printf("%-20s %6.3f (%6.3f) %-9s %-19s", name[c->what].what, ratio, least,
               name[c->against].who, name[c->against].what);
        if (c->most > 0)
            printf(" %6.3f  %s", c->most, judged(ratio, c->most));
        printf("\n");
    }
    for (size_t i = 0; i < sizeof limited / sizeof *limited; i++) {
        int what = limited[i].what;
        double found = in_units(what, task[what].median);

        printf("%-20s %6.3f (%6.3f) %-29s %6.3f  %s\n", name[what].what, found,
               in_units(what, task[what].min), name[what].unit, limited[i].most,
               judged(found, limited[i].most));
    }
}

/* --- the works --- */

typedef struct works {
    spline_work *cubic, *many, *bicubic, *biquadratic;
    grid_work *grid;
    refine_work *refine;
    hier_work *hier, *built;
    net_work *net;
    machine *machine;
} works;

static works new_works(void)
{
    works w = {.cubic = spline_work_new(3, SPANS, 1, POINTS, NUMBERS),
               .many = spline_work_new(3, MANY_SPANS, 1, POINTS, NUMBERS),
               .bicubic = spline_work_new(3, SPANS, 2, POINTS, NUMBERS),
               .biquadratic = spline_work_new(2, SPANS, 2, POINTS, NUMBERS),
               .refine = refine_work_new(3, REFINED),
               .hier = hier_work_new(2, CELLS, LEVELS - 1, POINTS),
               .built = hier_work_new(2, CELLS, BUILT_LEVELS - 1, 1),
               .net = net_work_new((const int[]){2, 64, 64, 1}),
               .machine = machine_new()};

    w.grid = grid_work_new(w.bicubic);
    return w;
}

static void free_works(works *w)
{
    spline_work_free(w->cubic);
    spline_work_free(w->many);
    grid_work_free(w->grid);
    spline_work_free(w->bicubic);
    spline_work_free(w->biquadratic);
    refine_work_free(w->refine);
    hier_work_free(w->hier);
    hier_work_free(w->built);
    net_work_free(w->net);
    machine_free(w->machine);
}

static void set_tasks(works *w, bench_task *task)
{
    const bench_task ours[OURS] = {
        [BASIS] = {.work = work_basis, .with = w->cubic, .per = POINTS},
        [MANY] = {.work = work_basis, .with = w->many, .per = POINTS},
        [CURVE] = {.work = work_curve, .with = w->cubic, .per = POINTS},
        [CURVE2] = {.work = work_curve2, .with = w->cubic, .per = POINTS},
        [SURFACE] = {.work = work_surface, .with = w->bicubic, .per = POINTS},
        [GRID] = {.work = work_grid,
                  .with = w->grid,
                  .per = (double)WORK_GRID * WORK_GRID},
        [REFINE] = {.work = work_refine, .with = w->refine, .per = 1},
        [REFINE_SPACE] = {.work = work_refine_space, .with = w->refine, .per = 1},
        [BASIS2] = {.work = work_basis2, .with = w->biquadratic, .per = POINTS},
        [THB_BASIS] = {.work = work_functions, .with = w->hier, .per = POINTS},
        [SURFACE2] = {.work = work_surface, .with = w->biquadratic, .per = POINTS},
        [THB_SURFACE] = {.work = work_hierpieces, .with = w->hier, .per = POINTS},
        [BUILD] = {.work = work_build,
                   .with = w->built,
                   .per = w->built->b->active->size},
        [MLP] = {.work = work_step, .with = w->net, .per = WORK_BATCH},
        [MULTIPLY_ADD] = {.work = machine_multiply_add,
                          .with = w->machine,
                          .per = MACHINE_MULTIPLY_ADDS},
        [FUSED] = {.work = machine_fused,
                   .with = w->machine,
                   .per = MACHINE_MULTIPLY_ADDS},
        [TRIAD] = {.work = machine_triad, .with = w->machine, .per = MACHINE_BYTES}};

    for (int i = 0; i < OURS; i++)
        task[i] = ours[i];
}

/* The peer's works, after a look whether they give the same numbers. */
static void set_peers(const gsl_peer *gsl, const works *w, gsl_work **peer,
                      bench_task *task)
{
    const struct pair {
        int ours, theirs, count, numbers;
        const spline_work *work;
        bench_work *run;
    } pair[PEERS] = {{BASIS, GSL_BASIS, POINTS, 4, w->cubic, gsl->basis},
                     {MANY, GSL_MANY, FEW, 4, w->many, gsl->basis},
                     {CURVE, GSL_CURVE, POINTS, WORK_N, w->cubic, gsl->curve},
                     {CURVE2, GSL_CURVE2, POINTS, NUMBERS, w->cubic, gsl->curve2},
                     {SURFACE, GSL_SURFACE, POINTS, WORK_N, w->bicubic, gsl->surface}};

    for (int i = 0; i < PEERS; i++) {
        const struct pair *p = &pair[i];
        double difference;

        peer[i] = gsl->make(p->work, p->count, p->numbers);
        task[p->theirs] = (bench_task){.work = p->run, .with = peer[i], .per = p->count};
        task[p->ours].work(task[p->ours].with);
        p->run(peer[i]);
        difference = gsl->difference(peer[i], (size_t)p->count * (size_t)p->numbers,
                                     p->work->value);
        /* second derivatives of 100 spans are as large as 10^5 */
        KW_NEED(difference <= 1e-9, "%s: a difference of %g", name[p->ours].what,
                difference);
    }
}

int main(void)
{
    const gsl_peer *gsl = gsl_peer_there();
    bench_task task[ALL];
    gsl_work *peer[PEERS];
    works w;

    /* A basis is built in new memory each time, whatever was built before. */
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
    w = new_works();
    set_tasks(&w, task);
    if (gsl)
        set_peers(gsl, &w, peer, task);
    else
        printf("GSL is not installed (libgsl-dev): no comparison with it\n");
    printf("thb-build: %d functions on %d levels; mlp: 2-64-64-1, a step of %d samples, "
           "%.0f multiply-adds each\n\n",
           w.built->b->active->size, BUILT_LEVELS, WORK_BATCH, net_multiply_adds(w.net));
    bench_run(gsl ? ALL : OURS, task);
    print_rows(gsl ? ALL : OURS, task);
    print_comparisons(gsl ? ALL : OURS, task, net_multiply_adds(w.net));
    for (int i = 0; gsl && i < PEERS; i++)
        gsl->drop(peer[i]);
    free_works(&w);
    return 0;
}
