/* meshes.h -- what the tests of hierarchical meshes share: random meshes, each with a twin.

   The twin of a mesh is a table of the cells of one fine grid, which says for each of them how
   deep the domains reach: depth[c] = m if c lies in Omega^0 .. Omega^m and no further. Every
   question has an answer by going through the table, without flat indices of cells, maps or
   trees. */
#ifndef MESHES_H
#define MESHES_H

#include "mesh.h"
#include "need.h"
#include "test.h"
#include <stdlib.h>
#include <string.h>

enum { D_MOST = KW_TENSOR_D, OUTSIDE = 0, COVERED = 1, ACTIVE = 2 };

typedef struct twin {
    kw_mesh *mesh;
    int D, finest;            /* the level of the table */
    int cells[D_MOST], total; /* of the table */
    double *edge[D_MOST];     /* cells[h] + 1 breakpoints */
    unsigned char *depth;
} twin;

/* Zeroed memory; an int counts here. */
static inline void *room_for(int count, size_t size)
{
    return kw_need_memory((size_t)count, size);
}

/* Steps a multi-index through low <= at < high, last direction first; 0 behind the end. */
static inline int step(int D, const int *low, const int *high, int *at)
{
    KW_NEED(1 <= D && D <= D_MOST, "D = %d", D);
    for (int h = D - 1; h >= 0; h--) {
        if (++at[h] < high[h])
            return 1;
        at[h] = low[h];
    }
    return 0;
}

/* --- spaces --- */

/* A space of degree d whose knots are multiples of 1/2: 1 .. `most` spans of 1/2 or 1, inner
   knots of every multiplicity up to d+1, most of them simple; open or with auxiliary knots 0,
   1/2 or 1 apart. */
static inline kw_bspline *meshes_space(kw_rng *r, int d, int most)
{
    double t[256];
    int spans = 1 + kw_rng_below(r, most), open = kw_rng_below(r, 2), count = d + 1;
    kw_bspline *s;

    t[d] = kw_rng_below(r, 5) / 2.0 - 1;
    for (int i = 1; i <= spans; i++) {
        int copies =
            i < spans && kw_rng_below(r, 3) == 0 ? 1 + kw_rng_below(r, d + 1) : 1;
        double x = t[count - 1] + (1 + kw_rng_below(r, 2)) / 2.0;

        while (copies-- > 0)
            t[count++] = x;
    }
    for (int i = 1; i <= d; i++) {
        t[d - i] = t[d - i + 1] - (open ? 0 : kw_rng_below(r, 3) / 2.0);
        t[count - 1 + i] = t[count - 2 + i] + (open ? 0 : kw_rng_below(r, 3) / 2.0);
    }
    s = kw_bspline_new(d, count - 1, t);
    return s;
}

/* The product of D spaces, which are handed over. */
static inline kw_tensor *meshes_product(int D, kw_bspline *const *s)
{
    kw_tensor *g = kw_tensor_new(D, (const kw_bspline *const *)s);

    for (int h = 0; h < D; h++)
        kw_bspline_free(s[h]);
    return g;
}

/* D spaces of degree d on `cells` equal cells of [0, cells]. */
static inline kw_tensor *meshes_uniform(int D, int d, int cells)
{
    kw_bspline *s[D_MOST] = {NULL};

    for (int h = 0; h < D; h++)
        s[h] = kw_bspline_new_open_uniform(d, cells, 0, cells);
    return meshes_product(D, s);
}

/* --- twins --- */

/* The mesh of g with nothing refined, and a table for levels 0 .. finest; g is handed over. */
static inline twin twin_new(kw_tensor *g, int finest)
{
    twin w = {.mesh = kw_mesh_new(g), .D = g->D, .finest = finest, .total = 1};

    for (int h = 0; h < g->D; h++) {
        const kw_bspline *s = g->s[h];
        int cells = 0, parts = 1 << finest;

        w.edge[h] = room_for(s->n * parts + 1, sizeof *w.edge[h]);
        w.edge[h][0] = s->t[s->d];
        for (int i = s->d; i < s->n; i++)
            if (s->t[i] < s->t[i + 1]) {
                double *e = w.edge[h] + cells * parts;

                e[parts] = s->t[i + 1];
                for (int half = parts / 2; half > 0; half /= 2)
                    for (int at = half; at < parts; at += 2 * half)
                        e[at] = e[at - half] + (e[at + half] - e[at - half]) / 2;
                cells++;
            }
        w.cells[h] = cells * parts;
        w.total *= w.cells[h];
    }
    w.depth = room_for(w.total, 1);
    kw_tensor_free(g);
    return w;
}

static inline void twin_free(twin *w)
{
    kw_mesh_free(w->mesh);
    for (int h = 0; h < w->D; h++)
        free(w->edge[h]);
    free(w->depth);
}

static inline int twin_flat(const twin *w, const int *cell)
{
    int flat = 0;

    for (int h = 0; h < w->D; h++)
        flat = flat * w->cells[h] + cell[h];
    return flat;
}

/* How deep the domains reach on a cell of a level. */
static inline int twin_depth(const twin *w, int level, const int *cell)
{
    int corner[D_MOST];

    for (int h = 0; h < w->D; h++)
        corner[h] = cell[h] << (w->finest - level);
    return w->depth[twin_flat(w, corner)];
}

/* Refines the table as kw_mesh_refine does a mesh; how many cells were refined now. */
static inline int twin_refine(twin *w, int level, const int *low, const int *high)
{
    int from[D_MOST] = {0}, to[D_MOST] = {0}, at[D_MOST] = {0}, done = 0;

    KW_NEED(1 <= w->D && w->D <= D_MOST, "D = %d", w->D);
    for (int h = 0; h < w->D; h++) {
        at[h] = from[h] = low[h] << (w->finest - level);
        to[h] = high[h] << (w->finest - level);
        if (from[h] == to[h])
            return 0;
    }
    do {
        unsigned char *depth = &w->depth[twin_flat(w, at)];

        done += *depth == level;
        *depth = (unsigned char)(*depth + (*depth == level));
    } while (step(w->D, from, to, at));
    return done >> w->D * (w->finest - level); /* table cells of one cell */
}

/* Refines both and checks that they agree in how much was done. */
static inline void refine_both(twin *w, int level, const int *low, const int *high)
{
    int want = twin_refine(w, level, low, high);
    int got = kw_mesh_refine(w->mesh, level, low, high);

    CHECK(got == want, "level %d: %d cells, not %d", level, got, want);
}

/* The same with the box of low <= cell < high in every direction. */
static inline void refine_cube(twin *w, int level, int low, int high)
{
    const int from[D_MOST] = {low, low, low}, to[D_MOST] = {high, high, high};

    refine_both(w, level, from, to);
}

/* A random box of cells of a level, never empty. */
static inline void random_box(kw_rng *r, const twin *w, int level, int *low, int *high)
{
    for (int h = 0; h < w->D; h++) {
        int cells = w->mesh->level[level].cells[h];

        low[h] = kw_rng_below(r, cells);
        high[h] = low[h] + 1 + kw_rng_below(r, cells - low[h]);
    }
}

/* Up to four random boxes a level, level after level. */
static inline void refine_at_random(kw_rng *r, twin *w)
{
    int low[D_MOST], high[D_MOST];

    for (int level = 0; level < w->finest && level < w->mesh->levels; level++)
        for (int left = 1 + kw_rng_below(r, 4); left > 0; left--) {
            random_box(r, w, level, low, high);
            refine_both(w, level, low, high);
        }
}

/* A random mesh: degrees 1 .. highest, up to `most` spans a direction, levels 0 .. finest. */
static inline twin random_twin(kw_rng *r, int D, int highest, int most, int finest)
{
    kw_bspline *s[D_MOST] = {NULL};
    twin w;

    for (int h = 0; h < D; h++)
        s[h] = meshes_space(r, 1 + kw_rng_below(r, highest), most);
    w = twin_new(meshes_product(D, s), finest);
    refine_at_random(r, &w);
    return w;
}

/* The domain split into everything on every level, or not at all. */
static inline void refine_everything(twin *w)
{
    const int zero[D_MOST] = {0};

    for (int level = 0; level < w->finest; level++)
        refine_both(w, level, zero, w->mesh->level[level].cells);
}

/* The table cells of the support of function j of a level. */
static inline void twin_support(const twin *w, int level, const int *j, int *low,
                                int *high)
{
    for (int h = 0; h < w->D; h++) {
        const kw_bspline *s = w->mesh->level[level].s[h];

        low[h] = 0;
        high[h] = w->cells[h];
        while (w->edge[h][low[h]] < s->t[j[h]])
            low[h]++;
        while (w->edge[h][high[h]] > s->t[j[h] + s->d + 1])
            high[h]--;
    }
}

/* The largest m for which the support of function j of a level lies in Omega^m. */
static inline int support_depth(const twin *w, int level, const int *j)
{
    int low[D_MOST] = {0}, high[D_MOST] = {0}, at[D_MOST], least = w->finest;

    twin_support(w, level, j, low, high);
    memcpy(at, low, sizeof at);
    do {
        int depth = w->depth[twin_flat(w, at)];

        least = depth < least ? depth : least;
    } while (step(w->D, low, high, at));
    return least;
}

/* What (14) says of function j of a level. */
static inline int twin_status(const twin *w, int level, const int *j)
{
    int depth = support_depth(w, level, j);

    return depth < level ? OUTSIDE : depth == level ? ACTIVE : COVERED;
}

/* The numbers of functions of a level in each direction; returns their product. */
static inline int functions_of(const twin *w, int level, int *n)
{
    int product = 1;

    for (int h = 0; h < w->D; h++) {
        n[h] = w->mesh->level[level].s[h]->n;
        product *= n[h];
    }
    return product;
}

/* The active functions of all levels by (14). */
static inline int twin_count(const twin *w)
{
    const int zero[D_MOST] = {0};
    int count = 0;

    for (int level = 0; level < w->mesh->levels; level++) {
        int n[D_MOST] = {0}, j[D_MOST] = {0};

        functions_of(w, level, n);
        do
            count += twin_status(w, level, j) == ACTIVE;
        while (step(w->D, zero, n, j));
    }
    return count;
}

/* --- rounding ---

   On its way from its own level to a cell a coefficient goes through at most levels - 1 changes
   of level, each of which costs a direction 5d roundings of the matrix (spline.h), a product
   and d sums. The values of B-splines cost 5d roundings a direction and the products of the
   directions; a THB-spline a product and a sum for each local function beside. No coefficient
   of a THB-spline and no entry of a matrix is negative, so errors are relative to the sum of
   the absolute values of the terms of the B-splines. */

/* Changes of level: from the first to the last. */
static inline int change_roundings(const kw_mesh *m)
{
    int sum = 0;

    for (int h = 0; h < m->D; h++)
        sum += 6 * m->level[0].s[h]->d + 1;
    return (m->levels - 1) * sum;
}

/* A B-spline of D directions. */
static inline int product_roundings(const kw_mesh *m)
{
    int sum = 0;

    for (int h = 0; h < m->D; h++)
        sum += 5 * m->level[0].s[h]->d + 1;
    return sum;
}

/* Local functions of a cell. */
static inline int local_functions(const kw_mesh *m)
{
    int product = 1;

    for (int h = 0; h < m->D; h++)
        product *= m->level[0].s[h]->d + 1;
    return product;
}

/* A THB-spline. */
static inline int truncated_roundings(const kw_mesh *m)
{
    return change_roundings(m) + product_roundings(m) + local_functions(m) + 1;
}

/* --- points --- */

/* A random point of the domain: one coordinate in four is an edge of a cell, one in eight an
   end. */
static inline void random_place(kw_rng *r, const twin *w, double *x)
{
    for (int h = 0; h < w->D; h++) {
        const double *e = w->edge[h];
        int last = w->cells[h], kind = kw_rng_below(r, 8);

        if (kind == 0)
            x[h] = e[kw_rng_below(r, 2) * last];
        else if (kind <= 2)
            x[h] = e[kw_rng_below(r, last + 1)];
        else
            x[h] = test_random_in(r, e[0], e[last]);
        x[h] = x[h] < e[last] ? x[h] : e[last];
    }
}

#endif
