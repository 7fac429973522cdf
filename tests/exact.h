/* exact.h -- HB- and THB-splines straight from Definitions 4 and 5, in whole numbers.

   A fraction is an integer over a denominator that a whole table shares, so that sums and
   products are those of integers. What does not fit into 127 bits aborts: a result that comes
   back is exact. Nothing here asks the library: knots of finer levels, two-scale relations,
   selection and truncation are made anew. Only small meshes will do. */
#ifndef EXACT_H
#define EXACT_H

#include "meshes.h"
#include "rational.h"

__extension__ typedef __int128 wide;
__extension__ typedef unsigned __int128 unsigned_wide;

enum { EXACT_KNOTS = 128, EXACT_LEVELS = 4 };

static inline wide wide_size(wide a)
{
    return a < 0 ? -a : a;
}

static inline wide wide_mul(wide a, wide b)
{
    const wide most = (wide)(~(unsigned_wide)0 >> 1);
    wide half = (wide)1 << 62;
    wide p = wide_size(a), q = wide_size(b), product;

    KW_NEED((p < half && q < half) || p == 0 || q <= most / p, "%g * %g", (double)a,
            (double)b);
    product = (wide)((unsigned_wide)p * (unsigned_wide)q);
    return (a < 0) == (b < 0) ? product : -product;
}

static inline wide wide_add(wide a, wide b)
{
    const wide half = (wide)1 << 126;

    KW_NEED(wide_size(a) < half && wide_size(b) < half, "%g + %g", (double)a, (double)b);
    return a + b;
}

/* The space of one direction on one level. */
typedef struct exact_line {
    int d, n;
    rational t[EXACT_KNOTS];
    wide *fine; /* next n x n: column j is beta_j in the functions of the next level, */
    long long scale; /* times scale */
} exact_line;

/* The mesh, and the THB-splines on the finest level. */
typedef struct exact {
    const twin *w;
    int levels, size;
    exact_line line[EXACT_LEVELS][D_MOST];
    int (*mother)[1 + D_MOST]; /* size: level and multi-index */
    wide **c;                  /* size: all coefficients on the finest level .. */
    wide scale[EXACT_LEVELS];  /* .. times scale[level of the mother] */
} exact;

/* --- two-scale relations, one knot after the other --- */

/* Gives `count` fractions one denominator, which is returned. */
static inline long long common(int count, const rational *a, wide *value)
{
    long long scale = 1;

    for (int i = 0; i < count; i++) {
        rational missing = rational_new(a[i].q, scale);

        scale = rational_product(scale, missing.p);
    }
    for (int i = 0; i < count; i++)
        value[i] = wide_mul(a[i].p, scale / a[i].q);
    return scale;
}

/* Inserts x into the knots t of `n` functions. The matrix a is functions x columns: beta_j is a
   share of the new beta_j and the rest of the new beta_{j+1}. [Boehm, CAD 12 (1980)] */
static inline void insert_one(int d, int n, rational *t, rational x, int columns,
                              rational *a)
{
    const rational zero = {0, 1}, one = {1, 1};
    int i = n + d;

    while (i >= 0 && rational_less(x, t[i]))
        i--;
    for (int j = n; j >= 0; j--) {
        rational w = one; /* the share of the old beta_j */

        if (j > i)
            w = zero;
        else if (j > i - d)
            w = rational_div(rational_sub(x, t[j]), rational_sub(t[j + d], t[j]));
        for (int c = 0; c < columns; c++) {
            rational here = j < n ? rational_mul(w, a[j * columns + c]) : zero;
            rational rest = j > 0 ? a[(j - 1) * columns + c] : zero;

            rest = rational_mul(rational_sub(one, w), rest);
            a[j * columns + c] = rational_add(here, rest);
        }
    }
    for (int q = n + d + 1; q > i + 1; q--)
        t[q] = t[q - 1];
    t[i + 1] = x;
}

/* Halves every span of `coarse`, between the auxiliary knots too; of all the functions those
   that live in the domain are the next level. */
static inline void halve(exact_line *coarse, exact_line *fine)
{
    int d = coarse->d, n = coarse->n, now = n, first = 0;
    rational *t = room_for(2 * EXACT_KNOTS, sizeof *t);
    rational *a = room_for(2 * (n + d) * n, sizeof *a);

    KW_NEED(2 * (n + d) + 1 <= EXACT_KNOTS, "%d knots", n + d + 1);
    memcpy(t, coarse->t, sizeof coarse->t);
    for (int i = 0; i < n * n; i++)
        a[i] = (rational){i % (n + 1) == 0, 1};
    for (int i = 0; i < n + d; i++) {
        rational middle = rational_add(coarse->t[i], coarse->t[i + 1]);

        if (rational_less(coarse->t[i], coarse->t[i + 1]))
            insert_one(d, now++, t, rational_mul(middle, (rational){1, 2}), n, a);
    }
    while (!rational_less(coarse->t[d], t[first + d + 1])) /* ends in the domain */
        first++;
    fine->d = d;
    fine->n = 0;
    while (first + fine->n < now && rational_less(t[first + fine->n], coarse->t[n]))
        fine->n++;
    memcpy(fine->t, t + first, (size_t)(fine->n + d + 1) * sizeof *t);
    coarse->fine = room_for(fine->n * n, sizeof *coarse->fine);
    coarse->scale = common(fine->n * n, a + first * n, coarse->fine);
    free(t);
    free(a);
}

/* --- truncation --- */

/* Applies the matrix of direction h: c is outer x n x inner. */
static inline wide *exact_direction(const exact_line *l, int next, int outer, int inner,
                                    const wide *c)
{
    wide *to = room_for(outer * next * inner, sizeof *to);

    for (int o = 0; o < outer; o++)
        for (int j = 0; j < l->n; j++)
            for (int i = 0; i < inner; i++) {
                wide from = c[(o * l->n + j) * inner + i];

                for (int f = 0; f < next && from != 0; f++) {
                    wide *sum = &to[(o * next + f) * inner + i];

                    *sum = wide_add(*sum, wide_mul(l->fine[f * l->n + j], from));
                }
            }
    return to;
}

/* Writes coefficients of a level in functions of the next one; c is freed. */
static inline wide *exact_refine(const exact *e, int level, wide *c)
{
    int outer = 1, inner = 1;

    for (int h = 0; h < e->w->D; h++)
        inner *= e->line[level][h].n;
    for (int h = 0; h < e->w->D; h++) {
        int next = e->line[level + 1][h].n;
        wide *to;

        inner /= e->line[level][h].n;
        to = exact_direction(&e->line[level][h], next, outer, inner, c);
        free(c);
        c = to;
        outer *= next;
    }
    return c;
}

/* Drops the coefficients of functions whose support lies in Omega^level; returns whether one
   of them was not zero. [source text, (15)] */
static inline int exact_truncate(const exact *e, int level, wide *c)
{
    const int zero[D_MOST] = {0};
    int n[D_MOST] = {0}, j[D_MOST] = {0}, at = 0, dropped = 0;

    functions_of(e->w, level, n);
    do {
        if (c[at] != 0 && support_depth(e->w, level, j) >= level) {
            c[at] = 0;
            dropped = 1;
        }
        at++;
    } while (step(e->w->D, zero, n, j));
    return dropped;
}

/* tau with this mother on level `to`; *cut is the last level that dropped something. */
static inline wide *exact_thb(const exact *e, const int *mother, int to, int *cut)
{
    int n[D_MOST] = {0}, flat = 0;
    wide *c = room_for(functions_of(e->w, mother[0], n), sizeof *c);

    for (int h = 0; h < e->w->D; h++)
        flat = flat * n[h] + mother[1 + h];
    c[flat] = 1;
    *cut = mother[0];
    for (int level = mother[0] + 1; level <= to; level++) {
        c = exact_refine(e, level - 1, c);
        *cut = exact_truncate(e, level, c) ? level : *cut;
    }
    return c;
}

/* --- all of it --- */

static inline void exact_lines(exact *e)
{
    for (int h = 0; h < e->w->D; h++) {
        const kw_bspline *s = e->w->mesh->level[0].s[h];
        exact_line *l = &e->line[0][h];

        l->d = s->d;
        l->n = s->n;
        for (int i = 0; i <= s->n + s->d; i++)
            l->t[i] = rational_new((long long)(2 * s->t[i]), 2);
        for (int level = 0; level + 1 < e->levels; level++)
            halve(&e->line[level][h], &e->line[level + 1][h]);
    }
}

/* The knots of the twin are multiples of 1/2. */
static inline exact *exact_new(const twin *w)
{
    const int zero[D_MOST] = {0};
    exact *e = room_for(1, sizeof *e);
    int count = twin_count(w), unused;

    e->w = w;
    e->levels = w->mesh->levels;
    KW_NEED(e->levels <= EXACT_LEVELS, "%d levels", e->levels);
    exact_lines(e);
    e->scale[e->levels - 1] = 1;
    for (int level = e->levels - 2; level >= 0; level--) {
        e->scale[level] = e->scale[level + 1];
        for (int h = 0; h < w->D; h++)
            e->scale[level] = wide_mul(e->scale[level], e->line[level][h].scale);
    }
    e->mother = room_for(count, sizeof *e->mother);
    e->c = room_for(count, sizeof *e->c);
    for (int level = 0; level < e->levels; level++) {
        int n[D_MOST] = {0}, j[D_MOST] = {0};

        functions_of(w, level, n);
        do {
            if (twin_status(w, level, j) != ACTIVE)
                continue;
            e->mother[e->size][0] = level;
            memcpy(e->mother[e->size] + 1, j, sizeof j);
            e->c[e->size] = exact_thb(e, e->mother[e->size], e->levels - 1, &unused);
            e->size++;
        } while (step(w->D, zero, n, j));
    }
    return e;
}

static inline void exact_free(exact *e)
{
    for (int i = 0; i < e->size; i++)
        free(e->c[i]);
    for (int level = 0; level < e->levels; level++)
        for (int h = 0; h < e->w->D; h++)
            free(e->line[level][h].fine);
    free(e->c);
    free(e->mother);
    free(e);
}

/* --- at a point --- */

/* The derivatives at a point of all univariate functions, of every level and direction, times
   scale; with sign +1 the sums of the absolute values of their terms (rational.h). */
typedef struct exact_point {
    wide value[EXACT_LEVELS][D_MOST][EXACT_KNOTS];
    long long scale[EXACT_LEVELS][D_MOST];
} exact_point;

static inline void exact_at(const exact *e, const int *r, const rational *x, int sign,
                            exact_point *p)
{
    for (int level = 0; level < e->levels; level++)
        for (int h = 0; h < e->w->D; h++) {
            const exact_line *l = &e->line[level][h];
            int from_left = !rational_less(x[h], l->t[l->n]);
            rational v[EXACT_KNOTS];

            for (int j = 0; j < l->n; j++)
                v[j] = rational_terms(l->t + j, l->d, r[h], x[h], from_left, sign);
            p->scale[level][h] = common(l->n, v, p->value[level][h]);
        }
}

/* Function j of a level, times the scales of the level. */
static inline wide exact_product(const exact *e, const exact_point *p, int level,
                                 const int *j)
{
    wide product = 1;

    for (int h = 0; h < e->w->D; h++)
        product = wide_mul(product, p->value[level][h][j[h]]);
    return product;
}

static inline wide exact_scale(const exact *e, const exact_point *p, int level)
{
    wide product = 1;

    for (int h = 0; h < e->w->D; h++)
        product = wide_mul(product, p->scale[level][h]);
    return product;
}

/* HB-spline i. Two conversions and a quotient are rounded. */
static inline double exact_hb(const exact *e, const exact_point *p, int i)
{
    int level = e->mother[i][0];

    return (double)exact_product(e, p, level, e->mother[i] + 1) /
           (double)exact_scale(e, p, level);
}

/* THB-spline i times *scale. */
static inline wide exact_tau(const exact *e, const exact_point *p, int i, wide *scale)
{
    const int zero[D_MOST] = {0};
    int n[D_MOST] = {0}, j[D_MOST] = {0}, at = 0, top = e->levels - 1;
    wide sum = 0;

    functions_of(e->w, top, n);
    do {
        wide c = e->c[i][at++];

        if (c != 0)
            sum = wide_add(sum, wide_mul(c, exact_product(e, p, top, j)));
    } while (step(e->w->D, zero, n, j));
    *scale = wide_mul(e->scale[e->mother[i][0]], exact_scale(e, p, top));
    return sum;
}

#endif
