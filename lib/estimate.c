#include "estimate.h"
#include "celltree.h"
#include "hier.h"
#include "truncation.h"
#include <math.h>
#include <stdlib.h>

enum { D_MOST = KW_TENSOR_D };

/* How much of a growing array is in reserve: one that doubles, and those of celltree.c and
   hier.c, which grow by halves. Room that is added to a large array moves, it is not copied. */
static const double doubling = 2, by_halves = 1.5;

/* The bytes of a map with `keys` keys: map.c has a power of two of places, twice as many as keys
   at least. */
static double map_bytes(double keys)
{
    double places = 16;

    while (places < 2 * keys)
        places *= 2;
    return places * (double)(sizeof(uint64_t) + sizeof(int));
}

static double all_cells(const kw_mesh *m, int level)
{
    return (double)kw_mesh_active(m, level) + m->level[level].count;
}

static double local_functions(const kw_mesh *m)
{
    double local = 1;

    for (int h = 0; h < m->D; h++)
        local *= m->level[0].s[h]->d + 1;
    return local;
}

double kw_estimate_pairs(const kw_mesh *m)
{
    double cells = 0;

    for (int level = 0; level < m->levels; level++)
        cells += all_cells(m, level);
    return cells * local_functions(m);
}

double kw_estimate_numbers(const kw_mesh *m)
{
    return kw_estimate_pairs(m) * local_functions(m);
}

/* The functions of a level that are not zero on some cell of Omega^level, at most: on the
   halves of one refined cell there are d+2 in a direction, on those of all refined cells those
   of the box around them. */
static double functions_met(const kw_mesh *m, int level)
{
    const kw_mesh_level *l = &m->level[level];
    int low[D_MOST] = {0}, high[D_MOST] = {0};
    double apart = level > 0 ? m->level[level - 1].count : HUGE_VAL, box = 1;

    for (int h = 0; h < m->D; h++) {
        low[h] = level > 0 ? l->cells[h] : 0;
        high[h] = level > 0 ? 0 : l->cells[h] - 1;
    }
    for (int i = 0; level > 0 && i < m->level[level - 1].count; i++) {
        int parent[D_MOST] = {0};

        kw_mesh_multi(m, level - 1, m->level[level - 1].list[i], parent);
        for (int h = 0; h < m->D; h++) {
            low[h] = 2 * parent[h] < low[h] ? 2 * parent[h] : low[h];
            high[h] = 2 * parent[h] + 1 > high[h] ? 2 * parent[h] + 1 : high[h];
        }
    }
    for (int h = 0; h < m->D; h++) {
        apart *= l->s[h]->d + 2;
        box *= l->span[h][high[h]] - l->span[h][low[h]] + l->s[h]->d + 1;
    }
    return fmin(apart, box);
}

/* The bytes of a mesh: knots with their tables, and refined cells. */
static double mesh_bytes(const kw_mesh *m)
{
    double bytes = 0;

    for (int level = 0; level < m->levels; level++) {
        const kw_mesh_level *l = &m->level[level];

        bytes += map_bytes(l->count) + doubling * l->count * (double)sizeof *l->list;
        for (int h = 0; h < m->D; h++)
            bytes += (l->s[h]->n + l->s[h]->d + 1) *
                     (double)(sizeof *l->s[h]->t + sizeof *l->s[h]->before +
                              sizeof *l->span[h] + sizeof *l->edge[h]);
    }
    return bytes;
}

double kw_estimate_active(const kw_mesh *m)
{
    double bytes = 2 * mesh_bytes(m), most = 0;

    for (int level = 0; level < m->levels; level++) {
        double functions = functions_met(m, level), map = map_bytes(functions);

        bytes += map + doubling * functions * (double)sizeof(uint64_t);
        /* for a while: the list of cells, twice while it is sorted, and the map before it grew */
        most = fmax(most, map / 2 + 2 * all_cells(m, level) * (double)sizeof(uint64_t));
    }
    return bytes + most;
}

/* What kw_hier_new puts into its arrays. */
typedef struct contents {
    double own;     /* local functions that are kept: the active ones of all cells, and on
                       leaves that carry coarser ones the others, too */
    double carried; /* coarser functions on a leaf, and */
    double numbers; /* their coefficients */
    double most;    /* functions on a cell */
} contents;

/* Counts a cell and all below it; `coarser` active functions of coarser levels meet it. */
static void count_contents(const kw_active *a, int level, const int *cell, double coarser,
                           contents *c)
{
    int is[KW_ACTIVE_LOCAL], outside = 0, own = 0;

    kw_active_of_cell(a, level, cell, is);
    for (int f = 0; f < a->local; f++) { /* NOLINTNEXTLINE: all of them are set */
        outside += is[f] == KW_ACTIVE_OUTSIDE;
        own += is[f] >= KW_ACTIVE_FIRST;
    }
    c->own += own;
    c->most = fmax(c->most, coarser + own);
    coarser = outside > 0 ? coarser : 0; /* else Definition 5 cuts them all off */
    if (!kw_mesh_refined(a->mesh, level, cell)) {
        c->own += coarser > 0 ? outside : 0;
        c->carried += coarser;
        c->numbers += coarser * outside;
        return;
    }
    for (int child = 0; child < 1 << a->mesh->D; child++) {
        int at[D_MOST] = {0};

        for (int h = 0; h < a->mesh->D; h++)
            at[h] = 2 * cell[h] + (child >> h & 1);
        count_contents(a, level + 1, at, coarser + own, c);
    }
}

double kw_estimate_hier(const kw_active *a)
{
    const kw_mesh *m = a->mesh;
    contents c = {0, 0, 0, 0};
    double cells = 0, leaves = 0, tables;

    for (int level = 0; level < m->levels; level++) {
        leaves += (double)kw_mesh_active(m, level);
        cells += all_cells(m, level);
    }
    for (long long i = 0; i < (long long)all_cells(m, 0); i++) {
        int cell[D_MOST] = {0};

        kw_mesh_multi(m, 0, (uint64_t)i, cell);
        count_contents(a, 0, cell, 0, &c);
    }
    /* of the walk down: on each level two tables of coefficients, and two small ones */
    tables =
        m->levels * (by_halves * c.most * (2 * a->local + 1) * (double)sizeof(double) +
                     sizeof(kw_twoscale) + sizeof(int) * KW_ACTIVE_LOCAL);
    return kw_estimate_active(m) + tables + leaves * (double)sizeof(kw_hier_leaf) +
           cells * (by_halves * (double)sizeof(kw_celltree_node) + sizeof(kw_hier_own)) +
           by_halves *
               (c.own * (double)sizeof(kw_hier_function) +
                c.carried * (double)sizeof(int) + c.numbers * (double)sizeof(double));
}
