#include "cellbasis.h"
#include "recursion.h"

enum { K = KW_BSPLINE_DEGREE + 1 };

/* --- one direction after the other --- */

static void products(const kw_mesh_level *l, int D, const int *span, const int *r,
                     const double *x, double *value)
{
    double factor[K];
    int size = 1; /* products so far; the same loop as in kw_tensor_basis */

    value[0] = 1;
    for (int h = 0; h < D; h++) {
        int k = l->s[h]->d + 1;

        kw_bspline_derivative_on(l->s[h], span[h], x[h], r ? r[h] : 0, factor);
        for (int a = size - 1; a >= 0; a--)
            for (int i = k - 1; i >= 0; i--) /* NOLINTNEXTLINE: both are set */
                value[a * k + i] = value[a] * factor[i];
        size *= k;
    }
}

/* --- surfaces of degree 2 and 3: values ---

   Both directions go through the recursion abreast, with a degree that is a constant for
   compilers that like to unroll its loops. */

static inline void surface(int d, const kw_mesh_level *l, const int *span,
                           const double *x, double *value)
{
    const double *s = l->s[0]->t + span[0] + 1, *t = l->s[1]->t + span[1] + 1;
    kw_pair factor[K];

    factor[0] = (kw_pair){1, 1};
    for (int p = 1; p <= d; p++)
        kw_recursion_raise_both(p, s, t, (kw_pair){x[0], x[1]}, factor, factor);
    for (int i = 0; i <= d; i++)
        for (int j = 0; j <= d; j++)
            value[i * (d + 1) + j] = factor[i][0] * factor[j][1];
}

void kw_cellbasis_at(const kw_mesh *m, int level, const int *span, const int *r,
                     const double *x, double *value)
{
    const kw_mesh_level *l = &m->level[level];
    const int values_on_surface = !r && m->D == 2 && l->s[0]->d == l->s[1]->d;

    if (values_on_surface && l->s[0]->d == 2)
        surface(2, l, span, x, value);
    else if (values_on_surface && l->s[0]->d == 3)
        surface(3, l, span, x, value);
    else
        products(l, m->D, span, r, x, value);
}
