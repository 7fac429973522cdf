/* diagonal.h -- a mesh that is refined along the diagonal, again and again. */
#ifndef DIAGONAL_H
#define DIAGONAL_H

#include "../3-thb-splines/meshes.h"

/* cells x cells cells of the unit square, refined so many times: on every level but the last
   those with |i-j| <= degree. */
static inline kw_mesh *new_diagonal(int degree, int cells, int times)
{
    kw_mesh *m = uniform_mesh(2, degree, cells);

    for (int l = 0; l < times; l++) {
        int last = cells << l;

        for (int i = 0; i < last; i++) {
            int low[] = {i, i > degree ? i - degree : 0};
            int high[] = {i + 1, i + degree < last ? i + degree + 1 : last};

            kw_mesh_refine(m, l, low, high);
        }
    }
    return m;
}

#endif
