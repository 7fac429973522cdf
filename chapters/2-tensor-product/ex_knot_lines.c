/* Knot lines -- the regularity of a tensor product is that of its knot lines.

   What to see: nothing to look at. Across a knot line of multiplicity mu the derivative of
   order d - mu + 1 is the first that jumps; the multiplicity of other lines does not matter.

   Book: section 1.1, the text behind (10).
   Claims: tp.regularity.*
   Chosen here: the surface of ex_patch, and random control points where a line is double. */

#include "claim.h"  /* what we found, for the ledger */
#include "out.h"    /* reports are files */
#include "patch.h"  /* the example */
#include "rng.h"    /* control points */
#include "tensor.h" /* geometries */
#include <math.h>

enum { MOST = N1 * (N2 + 1), LOCAL = 3 * 3 };

/* The derivative of order r in direction h of the piece on span i of that direction, at x. */
static void one_sided(const kw_tensor *g, const double *c, int h, int i, int r,
                      const double *x, double *p)
{
    double factor[2][LOCAL], *along = factor[h] + (size_t)r * 3;
    int first[2];

    first[1 - h] = kw_bspline_basis(g->s[1 - h], x[1 - h], factor[1 - h]);
    first[h] = i - g->s[h]->d;
    kw_bspline_derivatives_on(g->s[h], i, x[h], 2, factor[h]);
    for (int a = 0; a < SPACE; a++)
        p[a] = 0;
    for (int q = 0; q < LOCAL; q++) {
        const int at[2] = {q / 3, q % 3};
        const int j[2] = {first[0] + at[0], first[1] + at[1]};

        for (int a = 0; a < SPACE; a++)
            p[a] += along[at[h]] * factor[1 - h][at[1 - h]] *
                    c[kw_tensor_flat(g, j) * SPACE + a];
    }
}

/* What is taken for no jump at most, and for a jump at least. */
typedef struct jumps {
    double zero, least;
} jumps;

/* The first order of derivative in direction h, from the value on, that jumps across the knot
   line between the spans left and right of that direction, in any coordinate at any of some
   points of the line; 3 if none does. */
static int first_jump(const kw_tensor *g, const double *c, int h, int left, int right,
                      jumps *seen)
{
    const double between = 1e-6; /* see the claims on what lies on either side */

    for (int r = 0; r <= 2; r++) {
        double jump = 0;

        for (int q = 0; q <= 10; q++) {
            double x[2] = {q / 10.0, q / 10.0}, before[SPACE], behind[SPACE];

            x[h] = g->s[h]->t[right];
            one_sided(g, c, h, left, r, x, before);
            one_sided(g, c, h, right, r, x, behind);
            for (int a = 0; a < SPACE; a++)
                jump = fmax(jump, fabs(before[a] - behind[a]));
        }
        if (jump > between) {
            seen->least = fmin(seen->least, jump);
            return r;
        }
        seen->zero = fmax(seen->zero, jump);
    }
    return 3;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_knot_lines");
    kw_tensor *g = new_patch(1), *line_twice = new_patch(2);
    kw_rng r = kw_rng_at(10, 1, 0, 0);
    jumps seen = {0, INFINITY};
    double c[MOST * SPACE];

    for (int i = 0; i < MOST * SPACE; i++)
        c[i] = 2 * kw_rng_uniform(&r) - 1;

    kw_claim_count(report, "tp.regularity.1", first_jump(g, points, 0, 2, 3, &seen));
    kw_claim_count(report, "tp.regularity.2", first_jump(g, points, 1, 2, 3, &seen));
    kw_claim_count(report, "tp.regularity.double",
                   first_jump(line_twice, c, 1, 2, 4, &seen));
    kw_claim_count(report, "tp.regularity.across",
                   first_jump(line_twice, c, 0, 2, 3, &seen));
    kw_claim_real(report, "tp.regularity.zero", seen.zero);
    kw_claim_real(report, "tp.regularity.least", seen.least);

    kw_tensor_free(g);
    kw_tensor_free(line_twice);
    return kw_out_close(report);
}
