/* diagram.h -- how the drivers of this lesson draw a net: a column of units for each layer, a
   line for each edge that is found by trial. */
#ifndef DIAGRAM_H
#define DIAGRAM_H

#include "mlp.h"
#include "need.h"
#include "out.h"
#include <stdlib.h>

/* Units of layer l = 0 .. L. */
static inline int layer_units(const kw_net *n, int l)
{
    int first;

    return l == 0 ? n->in : kw_mlp_affine(n, l, &first)->out;
}

/* The height of unit i of a column of `units`, the first on top, centred at 0. */
static inline double unit_height(int units, int i)
{
    return (units - 1) / 2.0 - i;
}

/* The sections units, edges and layers of a diagram. Returns the number of edges. */
static inline int write_diagram(kw_out *f, const kw_net *n)
{
    int L = kw_mlp_depth(n), edges = 0;

    kw_out_section(f, "units", "layer unit y");
    for (int l = 0; l <= L; l++)
        for (int i = 0; i < layer_units(n, l); i++) {
            kw_out_number(f, l);
            kw_out_number(f, i);
            kw_out_number(f, unit_height(layer_units(n, l), i));
            kw_out_row(f);
        }
    kw_out_section(f, "edges", "layer from y to y");
    for (int l = 1; l <= L; l++) {
        int first;
        const kw_affine *a = kw_mlp_affine(n, l, &first);
        int *edge = kw_need_memory((size_t)a->out * (size_t)a->in, sizeof *edge);

        edges += kw_mlp_edges(n, l, edge);
        for (int i = 0; i < a->out; i++)
            for (int j = 0; j < a->in; j++) {
                if (!edge[i * a->in + j])
                    continue;
                kw_out_number(f, l);
                kw_out_number(f, j);
                kw_out_number(f, unit_height(a->in, j));
                kw_out_number(f, i);
                kw_out_number(f, unit_height(a->out, i));
                kw_out_row(f);
            }
        free(edge);
    }
    kw_out_section(f, "layers", "layer units");
    for (int l = 0; l <= L; l++) {
        kw_out_number(f, l);
        kw_out_number(f, layer_units(n, l));
        kw_out_row(f);
    }
    return edges;
}

#endif
