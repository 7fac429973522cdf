/* Remark 6 -- without interior knots the products are products of Bernstein polynomials.

   What to see: nothing to look at. On k_h zeros and k_h ones in each direction there are
   k_1 k_2 k_3 functions, the products of (8), and a geometry is its Bernstein-Bezier form.

   Book: section 1.1, (11), Remark 6.
   Claims: tp.rem6.*
   Chosen here: D = 3, degrees 1, 2, 3, random coefficients. */

#include "bernstein.h" /* formula (8) */
#include "bspline.h"   /* the factors */
#include "claim.h"     /* what we found, for the ledger */
#include "out.h"       /* reports are files */
#include "rng.h"       /* coefficients */
#include "tensor.h"    /* their products */
#include <math.h>

enum { SAMPLES = 40 };

/* In D = 3 directions of degrees 1, 2, 3: the functions are the products of (8), and a
   geometry is the sum of its control values times them. */
static void report_remark6(kw_out *report)
{
    enum { D = 3, LOCAL = 2 * 3 * 4 };
    kw_bspline *s[D];
    double value[LOCAL], c[LOCAL], bernstein[D][D + 1];
    kw_rng r = kw_rng_at(9, 1, 0, 0);
    double basis = 0, form = 0;
    int off;
    kw_tensor *g;

    for (int h = 0; h < D; h++)
        s[h] = kw_bspline_new_open_uniform(h + 1, 1, 0, 1);
    g = kw_tensor_new(D, (const kw_bspline *const *)s);
    off = kw_tensor_dimension(g) != LOCAL || kw_tensor_local(g) != LOCAL;
    for (int j = 0; j < LOCAL; j++)
        c[j] = 2 * kw_rng_uniform(&r) - 1;
    for (int i = 0; i <= SAMPLES; i++) {
        const double x[D] = {(double)i / SAMPLES, 1 - (double)i / SAMPLES, 0.5};
        double sum = 0, point;
        int first[D];

        kw_tensor_basis(g, NULL, x, first, value);
        kw_tensor_point(g, 1, c, NULL, x, &point);
        for (int h = 0; h < D; h++)
            kw_bernstein_basis(h + 1, x[h], bernstein[h]);
        for (int flat = 0; flat < LOCAL; flat++) {
            double product;
            int j[D];

            kw_tensor_multi(g, flat, j);
            product = bernstein[0][j[0]] * bernstein[1][j[1]] * bernstein[2][j[2]];
            basis = fmax(basis, fabs(value[flat] - product));
            sum += c[flat] * product;
        }
        form = fmax(form, fabs(point - sum));
    }
    kw_tensor_free(g);
    for (int h = 0; h < D; h++)
        kw_bspline_free(s[h]);
    kw_claim_count(report, "tp.rem6.count", off);
    kw_claim_real(report, "tp.rem6.basis", basis);
    kw_claim_real(report, "tp.rem6.form", form);
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_tensor_bernstein");

    report_remark6(report);
    return kw_out_close(report);
}
