/* Weights -- the numbers with which HB-splines add up to one.

   What to see: weights that bring the sum to one exist on every mesh, there is one choice only,
   and none is negative; but on the small meshes shown some are zero, so that the scaled functions
   are fewer than a basis needs.

   Book: section 1.1, the text behind Figure 9.
   Claims: hb.weights.*, thb.eq19.level
   Chosen here: the two small meshes. In D = 1, 2, 3 each 30 random meshes, where roundings are
   bounded, and 30 dyadic ones of degree 1 and 2 with points that are multiples of 1/64, where
   nothing is rounded and we ask for equality. */

#include "claim.h"      /* what we found, for the ledger */
#include "hiergeo.h"    /* the weights */
#include "hierpieces.h" /* their sum at a point */
#include "meshes.h"     /* meshes */
#include "need.h"       /* memory */
#include "out.h"        /* columns for gnuplot */
#include <math.h>
#include <stdlib.h>

enum { MESHES = 30, POINTS = 40, SAMPLES = 240, PARTS = 64 };

/* A mesh on the line with Omega^1 = cells low .. high-1. */
static kw_hier *line(int degree, int cells, int low, int high)
{
    kw_mesh *m = uniform_mesh(1, degree, cells);
    kw_hier *b;

    refine_interval(m, 0, low, high);
    b = kw_hier_new(m);
    kw_mesh_free(m);
    return b;
}

static double *new_weights(const kw_hier *b)
{
    double *w = kw_need_memory((size_t)b->active->size, sizeof *w);

    kw_hiergeo_weights(b, w);
    return w;
}

/* How many weights are zero, to the last bit. */
static int count_zeros(const kw_hier *b)
{
    double *w = new_weights(b);
    int zeros = 0;

    for (int i = 0; i < b->active->size; i++)
        zeros += w[i] == 0;
    free(w);
    return zeros;
}

/* How many indices j belong to active functions of level 0 and of level 1. */
static int count_shared(const kw_active *a)
{
    int shared = 0;

    for (int j = 0; j < a->mesh->level[0].s[0]->n; j++)
        shared += kw_active_find(a, 0, &j) >= 0 && kw_active_find(a, 1, &j) >= 0;
    return shared;
}

/* Over some meshes. */
typedef struct findings {
    double least, most; /* weight */
    double sum;         /* how far the weighted sum is from one, at most */
    int with_zero;      /* meshes with a weight that is zero */
} findings;

/* At random points, which are multiples of 1/PARTS if dyadic != 0. */
static void look_at(const kw_hier *b, uint64_t sample, int dyadic, findings *all)
{
    const kw_mesh *m = b->active->mesh;
    kw_rng r = kw_rng_at(23, (uint64_t)dyadic, sample, (uint64_t)m->D);
    double *w = new_weights(b);
    kw_hierpieces *one = kw_hierpieces_new(b, KW_HB, 1, w);

    for (int i = 0; i < b->active->size; i++) {
        all->least = fmin(all->least, w[i]);
        all->most = fmax(all->most, w[i]);
    }
    all->with_zero += count_zeros(b) > 0;
    for (int p = 0; p < POINTS; p++) {
        double x[KW_TENSOR_D], sum = 0;

        for (int h = 0; h < m->D; h++)
            x[h] =
                dyadic ? (double)kw_rng_below(&r, PARTS + 1) / PARTS : kw_rng_uniform(&r);
        kw_hierpieces_point(one, NULL, x, &sum);
        all->sum = fmax(all->sum, fabs(sum - 1));
    }
    kw_hierpieces_free(one);
    free(w);
}

static findings look_at_all(int dyadic)
{
    findings all = {1, 0, 0, 0};

    for (int D = 1; D <= KW_TENSOR_D; D++)
        for (uint64_t i = 0; i < MESHES; i++) {
            kw_mesh *m =
                dyadic ? dyadic_mesh(22, i, D, 1 + (int)(i % 2)) : random_mesh(22, i, D);
            kw_hier *b = kw_hier_new(m);

            look_at(b, i, dyadic, &all);
            kw_hier_free(b);
            kw_mesh_free(m);
        }
    return all;
}

/* Each function, and each function times its weight. */
static void write_functions(kw_out *f, const char *name, const kw_hier *b)
{
    double *w = new_weights(b);

    kw_out_section(f, name, "x value weighted level");
    for (int i = 0; i < b->active->size; i++) {
        const kw_bspline *s;
        int level, j;

        kw_active_function(b->active, i, &level, &j);
        s = b->active->mesh->level[level].s[0];
        for (int q = 0; q <= SAMPLES; q++) {
            double x = (double)q / SAMPLES, value = kw_bspline_one(s, j, 0, x);

            if (x < s->t[j] || x > s->t[j + s->d + 1])
                continue;
            kw_out_number(f, x);
            kw_out_number(f, value);
            kw_out_number(f, w[i] * value);
            kw_out_number(f, level);
            kw_out_row(f);
        }
        kw_out_gap(f);
    }
    free(w);
}

int main(void)
{
    kw_out *f = kw_out_data("ex_weights"), *report = kw_claim_new("ex_weights");
    kw_hier *linear = line(1, 3, 1, 2), *quadratic = line(2, 8, 3, 5);
    findings rounded = look_at_all(0), exact = look_at_all(1);

    write_functions(f, "linear", linear);
    write_functions(f, "quadratic", quadratic);
    kw_claim_count(report, "hb.weights.linear.functions", linear->active->size);
    kw_claim_count(report, "hb.weights.linear.zero", count_zeros(linear));
    kw_claim_count(report, "hb.weights.quadratic.functions", quadratic->active->size);
    kw_claim_count(report, "hb.weights.quadratic.zero", count_zeros(quadratic));
    kw_claim_count(report, "thb.eq19.level", count_shared(quadratic->active));
    kw_hier_free(linear);
    kw_hier_free(quadratic);
    kw_claim_real(report, "hb.weights.sum", rounded.sum);
    kw_claim_real(report, "hb.weights.outside", fmax(-rounded.least, rounded.most - 1));
    kw_claim_true(report, "hb.weights.exists", exact.sum == 0);
    kw_claim_real(report, "hb.weights.least", exact.least);
    kw_claim_real(report, "hb.weights.most", exact.most);
    kw_claim_count(report, "hb.weights.with-zero", exact.with_zero);
    return kw_out_close(f) | kw_out_close(report);
}
