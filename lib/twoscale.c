#include "twoscale.h"
#include <string.h>

void kw_twoscale_of_cell(const kw_mesh *m, int level, const int *cell, kw_twoscale *s)
{
    const kw_mesh_level *coarse = &m->level[level], *fine = &m->level[level + 1];

    s->D = m->D;
    for (int h = 0; h < m->D; h++) {
        int d = coarse->s[h]->d, span = coarse->span[h][cell[h]];

        s->k[h] = d + 1;
        for (int half = 0; half < 2; half++) {
            int first = fine->span[h][2 * cell[h] + half] - d;

            /* blossoms at the inner knots of fine functions */
            for (int f = 0; f <= d; f++)
                kw_bspline_blossom_knots(coarse->s[h], span,
                                         fine->s[h]->t + first + f + 1,
                                         s->a[h][half] + f * (d + 1));
        }
    }
}

/* The k entries of a line are `inner` numbers apart; there are outer x inner lines. About half
   of the matrix is zero. */
static void apply_direction(int k, const double *restrict a, int outer, int inner,
                            const double *restrict from, double *restrict to)
{
    memset(to, 0, (size_t)outer * (size_t)k * (size_t)inner * sizeof *to);
    for (int o = 0; o < outer; o++, from += k * inner)
        for (int f = 0; f < k; f++, to += inner)
            for (int j = 0; j < k; j++) {
                const double factor = a[f * k + j], *line = from + j * inner;

                if (factor == 0)
                    continue;
                for (int i = 0; i < inner; i++)
                    to[i] += factor * line[i];
            }
}

void kw_twoscale_apply(const kw_twoscale *s, int child, int size, double *restrict c,
                       double *restrict work)
{
    int outer = 1, inner = size;

    for (int h = 0; h < s->D; h++) {
        inner /= s->k[h];
        apply_direction(s->k[h], s->a[h][child >> h & 1], outer, inner, c, work);
        memcpy(c, work, (size_t)size * sizeof *c);
        outer *= s->k[h];
    }
}
