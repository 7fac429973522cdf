#include "mlp.h"
#include "need.h"
#include <stdlib.h>

kw_net *kw_mlp_new(int L, const int *width, const kw_activation_kind *sigma)
{
    kw_net *n;

    KW_NEED(L >= 1, "L = %d", L);
    n = kw_net_new(width[0]);
    for (int l = 1; l <= L; l++) {
        kw_net_add_affine(n, width[l]);
        if (sigma[l - 1] != KW_IDENTITY)
            kw_net_add_activation(n, sigma[l - 1]);
    }
    return n;
}

int kw_mlp_depth(const kw_net *n)
{
    int L = 0;

    for (int i = 0; i < n->layers; i++) {
        kw_layer_kind kind = n->layer[i].kind;

        KW_NEED(kind == KW_LAYER_AFFINE || kind == KW_LAYER_ACTIVATION,
                "layer %d is no layer of a perceptron", i);
        L += kind == KW_LAYER_AFFINE;
    }
    return L;
}

const kw_affine *kw_mlp_affine(const kw_net *n, int l, int *first)
{
    int L = kw_mlp_depth(n), i = -1;

    KW_NEED(1 <= l && l <= L, "layer %d, not in 1 .. %d", l, L);
    while (l > 0)
        l -= n->layer[++i].kind == KW_LAYER_AFFINE;
    *first = n->layer[i].first;
    return &n->layer[i].is.affine;
}

/* --- counting by trial: all parameters are one, so that no two effects cancel --- */

static double *ones(int count)
{
    double *a = kw_need_memory((size_t)count, sizeof *a);

    for (int i = 0; i < count; i++)
        a[i] = 1;
    return a;
}

int kw_mlp_edges(const kw_net *n, int l, int *edge)
{
    int first, count = 0;
    const kw_affine *a = kw_mlp_affine(n, l, &first);
    double *w = ones(a->parameters), *x = kw_need_memory((size_t)a->in, sizeof *x);
    double *rest = kw_need_memory((size_t)a->out, sizeof *rest);
    double *y = kw_need_memory((size_t)a->out, sizeof *y);

    kw_affine_forward(a, w, 1, x, rest);
    for (int j = 0; j < a->in; j++) {
        x[j] = 1;
        kw_affine_forward(a, w, 1, x, y);
        x[j] = 0;
        for (int i = 0; i < a->out; i++) {
            count += y[i] != rest[i];
            if (edge)
                edge[i * a->in + j] = y[i] != rest[i];
        }
    }
    free(w);
    free(x);
    free(rest);
    free(y);
    return count;
}

int kw_mlp_count_weights(const kw_net *n, int l)
{
    return kw_mlp_edges(n, l, NULL);
}

int kw_mlp_count_biases(const kw_net *n, int l)
{
    int first, count = 0;
    const kw_affine *a = kw_mlp_affine(n, l, &first);
    double *w = ones(a->parameters), *x = kw_need_memory((size_t)a->in, sizeof *x);
    double *y = kw_need_memory((size_t)a->out, sizeof *y);

    kw_affine_forward(a, w, 1, x, y);
    for (int i = 0; i < a->out; i++)
        count += y[i] != 0;
    free(w);
    free(x);
    free(y);
    return count;
}

int kw_mlp_count(const kw_net *n)
{
    int count = 0;

    for (int l = 1; l <= kw_mlp_depth(n); l++)
        count += kw_mlp_count_weights(n, l) + kw_mlp_count_biases(n, l);
    return count;
}
