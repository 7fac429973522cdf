#include "twoscale.h"
#include <string.h>

void kw_twoscale_between(const kw_mesh *m, int level, const int *cell, const int *child,
                         kw_twoscale *s)
{
    const kw_mesh_level *coarse = &m->level[level], *fine = &m->level[level + 1];

    s->D = m->D;
    for (int h = 0; h < m->D; h++) {
        int d = coarse->s[h]->d, first = fine->span[h][child[h]] - d;

        s->k[h] = d + 1;
        for (int f = 0; f <= d; f++) /* blossoms at the inner knots of fine functions */
            kw_bspline_blossom_knots(coarse->s[h], coarse->span[h][cell[h]],
                                     fine->s[h]->t + first + f + 1,
                                     s->a[h] + f * (d + 1));
    }
}

/* The k entries of a line are `inner` numbers apart; there are outer x inner lines. Most
   coefficients of most functions are zero, and cost nothing. */
static void apply_direction(int k, const double *restrict a, int outer, int inner,
                            const double *restrict from, double *restrict to)
{
    memset(to, 0, (size_t)outer * (size_t)k * (size_t)inner * sizeof *to);
    for (int o = 0; o < outer; o++)
        for (int j = 0; j < k; j++)
            for (int i = 0; i < inner; i++) {
                double c = from[(o * k + j) * inner + i];

                if (c == 0)
                    continue;
                for (int f = 0; f < k; f++)
                    to[(o * k + f) * inner + i] += a[f * k + j] * c;
            }
}

void kw_twoscale_apply(const kw_twoscale *s, int size, double *c, double *work)
{
    int outer = 1, inner = size;

    for (int h = 0; h < s->D; h++) {
        inner /= s->k[h];
        apply_direction(s->k[h], s->a[h], outer, inner, c, work);
        memcpy(c, work, (size_t)size * sizeof *c);
        outer *= s->k[h];
    }
}
