/* Figure 9, other readings -- which meshes give 184 functions, which 729, which both?

   What to see: each dot is a pair of dimensions that meshes of a declared family have, that of
   the hierarchical space and that of the smallest tensor product around it; the two lines are
   the printed numbers, and few meshes lie on both. Two meshes are ringed: that of Figure 9, and the
   one on 4 x 4 cells whose first number is the printed one and whose second is not.

   Book: section 1.1, the text around Figure 9.
   Claims: hb.fig9.uniform, hb.fig9.odd, hb.fig9.cubic.*, hb.fig9.search.*, hb.fig9.small.*,
   hb.fig9.other.*, hb.fig9.double
   Chosen here: the family. Bi-degree (2,2), N x N cells, N = 4 .. 8, three levels. Diagonal
   bands: |i-j| <= a on level 0, |i-j| <= b on level 1. Crossed bands: s <= i+j <= t on level
   0, |i-j| <= b on level 1. Omega^2 is what of its band lies in Omega^1. Different numbers a,
   b, s, t may refine the same cells: such a mesh counts once. Mirror images count as
   different. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* the functions of a mesh */
#include "meshes.h" /* the mesh to begin with */
#include "need.h"   /* memory */
#include "out.h"    /* columns for gnuplot */
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 2, LEAST = 4, MOST = 8, HIERARCHICAL = 184, TENSOR = 729, STEPS = 3 };

/* The two bands: first <= i-j or i+j <= last on level 0, |i-j| <= b on level 1. */
typedef struct bands {
    int cells, crossed, first, last, b;
} bands;

static kw_mesh *new_mesh(bands p)
{
    kw_mesh *m = uniform_mesh(2, DEGREE, p.cells);

    for (int i = 0; i < p.cells; i++)
        for (int j = 0; j < p.cells; j++) {
            int at = p.crossed ? i + j : i - j;

            if (p.first <= at && at <= p.last)
                refine_cell(m, 0, i, j);
        }
    for (int i = 0; m->levels > 1 && i < 2 * p.cells; i++)
        for (int j = 0; j < 2 * p.cells; j++)
            if (abs(i - j) <= p.b)
                refine_cell(m, 1, i, j);
    return m;
}

static int tensor_dimension(const kw_mesh *m)
{
    int n = 1;

    for (int h = 0; h < m->D; h++) {
        kw_bspline *s = kw_mesh_new_direction(m, h);

        n *= s->n;
        kw_bspline_free(s);
    }
    return n;
}

static void write_dot(kw_out *f, int hierarchical, int tensor)
{
    kw_out_number(f, hierarchical);
    kw_out_number(f, tensor);
    kw_out_row(f);
}

/* One bit for each cell of levels 0 and 1, set if it is refined: all there is to know of a
   mesh of three levels on N x N cells. */
enum { WORDS = (MOST * MOST + 4 * MOST * MOST) / 64 };
typedef struct refined {
    uint64_t word[WORDS];
} refined;

static refined refined_cells(const kw_mesh *m)
{
    uint64_t cells = 0; /* of the levels before */
    refined set = {{0}};

    for (int level = 0; level + 1 < STEPS; level++) {
        for (int i = 0; i < m->level[level].count; i++) {
            uint64_t bit = cells + m->level[level].list[i];

            set.word[bit / 64] |= (uint64_t)1 << bit % 64;
        }
        cells += (uint64_t)m->level[level].cells[0] * (uint64_t)m->level[level].cells[1];
    }
    return set;
}

/* What is found, and what was met before: the meshes of the present N, and the dots. */
typedef struct search {
    int meshes, hierarchical, tensor, both;
    refined seen[2 * MOST * (MOST + MOST * (2 * MOST - 1))]; /* bands for N = MOST */
    int seen_count;
    kw_map *dots;
} search;

/* Remembers the refined cells; returns whether they are new. */
static int is_new(search *all, refined set)
{
    for (int i = 0; i < all->seen_count; i++)
        if (memcmp(&all->seen[i], &set, sizeof set) == 0)
            return 0;
    all->seen[all->seen_count++] = set;
    return 1;
}

/* Counts a mesh that is new and has all three levels, and writes its dot, if that is new. */
static void look_at(kw_out *f, bands p, search *all)
{
    kw_mesh *m = new_mesh(p);

    if (m->levels == STEPS && is_new(all, refined_cells(m))) {
        int h = (int)kw_active_kraft(m), t = tensor_dimension(m);
        uint64_t dot = (uint64_t)h << 32 | (uint64_t)t;

        all->meshes++;
        all->hierarchical += h == HIERARCHICAL;
        all->tensor += t == TENSOR;
        all->both += h == HIERARCHICAL && t == TENSOR;
        if (kw_map_find(all->dots, dot) == KW_MAP_NONE) {
            kw_map_put(all->dots, dot, 0);
            write_dot(f, h, t);
        }
    }
    kw_mesh_free(m);
}

static void search_all(kw_out *f, kw_out *report)
{
    search *all = kw_need_memory(1, sizeof *all);

    all->dots = kw_map_new();
    kw_out_section(f, "meshes", "hierarchical tensor");
    for (int n = LEAST; n <= MOST; n++) {
        all->seen_count = 0;
        for (int b = 0; b < 2 * n; b++) {
            for (int a = 0; a < n; a++)
                look_at(f, (bands){n, 0, -a, a, b}, all);
            for (int first = 0; first <= 2 * n - 2; first++)
                for (int last = first; last <= 2 * n - 2; last++)
                    look_at(f, (bands){n, 1, first, last, b}, all);
        }
    }
    kw_claim_count(report, "hb.fig9.search.meshes", all->meshes);
    kw_claim_count(report, "hb.fig9.search.184", all->hierarchical);
    kw_claim_count(report, "hb.fig9.search.729", all->tensor);
    kw_claim_count(report, "hb.fig9.search.both", all->both);
    kw_map_free(all->dots);
    free(all);
}

/* Global uniform refinement: N cells become N 2^l, the dimension (N 2^l + 2)^2. Is one of them
   the printed number, and how many are odd? */
static void report_uniform(kw_out *report)
{
    int odd = 0, found = 0;

    for (int n = 1; n <= 40; n++) {
        kw_bspline *s = kw_bspline_new_open_uniform(DEGREE, n, 0, 1);

        for (int step = 1; step <= STEPS; step++) {
            const kw_bspline *both[2] = {s, s};
            kw_tensor *coarse = kw_tensor_new(2, both), *g = coarse;

            for (int i = 0; i < step; i++) {
                kw_tensor *fine = kw_tensor_new_dyadic(g);

                kw_tensor_free(g);
                g = fine;
            }
            odd += kw_tensor_dimension(g) % 2;
            found = found || kw_tensor_dimension(g) == TENSOR;
            kw_tensor_free(g);
        }
        kw_bspline_free(s);
    }
    kw_claim_true(report, "hb.fig9.uniform", found);
    kw_claim_count(report, "hb.fig9.odd", odd);
}

/* Bi-degree (3,3) on 6 x 6 cells, refined uniformly twice. */
static void report_cubic(kw_out *report)
{
    static const char *const id[] = {"hb.fig9.cubic.level0", "hb.fig9.cubic.level1",
                                     "hb.fig9.cubic.level2"};
    kw_mesh *m = uniform_mesh(2, 3, 6);

    for (int level = 0; level < STEPS; level++) {
        const int low[2] = {0, 0};
        const int high[2] = {m->level[level].cells[0], m->level[level].cells[1]};

        kw_claim_count(report, id[level],
                       m->level[level].s[0]->n * m->level[level].s[1]->n);
        kw_mesh_refine(m, level, low, high);
    }
    kw_mesh_free(m);
}

/* The mesh of Figure 9, and a third one with both numbers: one more cell is refined, alone, so
   that no finer function finds room in it, and its knot lines are there already. */
static void report_figure(kw_out *f, kw_out *report)
{
    kw_mesh *m = new_mesh((bands){8, 1, 4, 5, 9});

    write_dot(f, (int)kw_active_kraft(m), tensor_dimension(m));
    refine_cell(m, 0, 5, 5);
    kw_claim_count(report, "hb.fig9.other.hierarchical", kw_active_kraft(m));
    kw_claim_count(report, "hb.fig9.other.tensor", tensor_dimension(m));
    kw_mesh_free(m);
}

/* A mesh on 4 x 4 cells that has 184 functions, with another tensor product around it. */
static void report_small(kw_out *f, kw_out *report)
{
    static const char *const id[] = {"hb.fig9.small.level0", "hb.fig9.small.level1",
                                     "hb.fig9.small.level2"};
    kw_mesh *m = new_mesh((bands){4, 0, -1, 1, 7});
    kw_active *a = kw_active_new(m);

    write_dot(f, a->size, tensor_dimension(m));
    for (int level = 0; level < STEPS; level++)
        kw_claim_count(report, id[level], a->start[level + 1] - a->start[level]);
    kw_claim_count(report, "hb.fig9.small.tensor", tensor_dimension(m));
    kw_active_free(a);
    kw_mesh_free(m);
}

/* Bi-degree (2,2) on six cells whose middle knot is double, and stays so when all cells are
   halved twice. */
static void report_double(kw_out *report)
{
    const double tau[] = {0, 1, 2, 3, 4, 5, 6};
    const int mu[] = {1, 1, 2, 1, 1};
    kw_bspline *s = kw_bspline_new_open(2, 6, tau, mu);
    const kw_bspline *both[2] = {s, s};
    kw_tensor *g = kw_tensor_new(2, both), *once = kw_tensor_new_dyadic(g);
    kw_tensor *twice = kw_tensor_new_dyadic(once);

    kw_claim_count(report, "hb.fig9.double", kw_tensor_dimension(twice));
    kw_tensor_free(g);
    kw_tensor_free(once);
    kw_tensor_free(twice);
    kw_bspline_free(s);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_fig9_readings"),
           *report = kw_claim_new("ex_fig9_readings");

    search_all(f, report);
    report_uniform(report);
    report_cubic(report);
    kw_out_section(f, "printed", "hierarchical tensor");
    write_dot(f, HIERARCHICAL, TENSOR);
    kw_out_section(f, "marked", "hierarchical tensor");
    report_figure(f, report);
    report_small(f, report);
    report_double(report);
    return kw_out_close(f) | kw_out_close(report);
}
