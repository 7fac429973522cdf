/* xml.c -- splines as files of G+Smo. */
#include "xml.h"
#include "need.h"
#include "out.h"
#include <stdlib.h>

static kw_out *begin(const char *path)
{
    kw_out *f = kw_out_new(path);

    kw_out_text(f, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n");
    return f;
}

static int end(kw_out *f)
{
    kw_out_text(f, "</xml>\n");
    return kw_out_close(f);
}

static void put_knots(kw_out *f, const kw_bspline *s)
{
    kw_out_text(f, "<KnotVector degree=\"%d\">", s->d);
    for (int i = 0; i <= s->n + s->d; i++)
        kw_out_text(f, i > 0 ? " %.17g" : "%.17g", s->t[i]);
    kw_out_text(f, "</KnotVector>");
}

static void put_point(kw_out *f, int N, const double *c)
{
    for (int k = 0; k < N; k++)
        kw_out_text(f, k > 0 ? " %.17g" : "%.17g", c[k]);
    kw_out_text(f, "\n");
}

static void put_directions(kw_out *f, int D, kw_bspline *const *s)
{
    for (int h = 0; h < D; h++) {
        kw_out_text(f, "   <Basis type=\"BSplineBasis\" index=\"%d\">", h);
        put_knots(f, s[h]);
        kw_out_text(f, "</Basis>\n");
    }
}

int gen_xml_curve(const char *path, const kw_bspline *s, int N, const double *c)
{
    kw_out *f = begin(path);

    kw_out_text(f,
                " <Geometry type=\"BSpline\" id=\"0\">\n  <Basis type=\"BSplineBasis\">");
    put_knots(f, s);
    kw_out_text(f, "</Basis>\n  <coefs geoDim=\"%d\">\n", N);
    for (int j = 0; j < s->n; j++)
        put_point(f, N, c + j * N);
    kw_out_text(f, "  </coefs>\n </Geometry>\n");
    return end(f);
}

int gen_xml_surface(const char *path, const kw_tensor *g, int N, const double *c)
{
    kw_out *f = begin(path);

    KW_NEED(g->D == 2, "%d directions", g->D);
    kw_out_text(f, " <Geometry type=\"TensorBSpline2\" id=\"0\">\n"
                   "  <Basis type=\"TensorBSplineBasis2\">\n");
    put_directions(f, 2, g->s);
    kw_out_text(f, "  </Basis>\n  <coefs geoDim=\"%d\">\n", N);
    for (int j = 0; j < g->s[1]->n; j++)
        for (int i = 0; i < g->s[0]->n; i++)
            put_point(f, N, c + (i * g->s[1]->n + j) * N);
    kw_out_text(f, "  </coefs>\n </Geometry>\n");
    return end(f);
}

/* --- hierarchies --- */

/* Each refined cell of level l is a box of two cells of level l+1 in each direction. */
static void put_boxes(kw_out *f, const kw_mesh *m)
{
    int cell[KW_TENSOR_D];

    for (int l = 0; l + 1 < m->levels; l++) {
        const kw_mesh_level *level = &m->level[l];

        for (int i = 0; i < level->count; i++) {
            kw_mesh_multi(m, l, level->list[i], cell);
            kw_out_text(f, "   <box level=\"%d\">", l + 1);
            for (int h = 0; h < m->D; h++)
                kw_out_text(f, "%d ", 2 * cell[h]);
            for (int h = 0; h < m->D; h++)
                kw_out_text(f, h > 0 ? " %d" : "%d", 2 * cell[h] + 2);
            kw_out_text(f, "</box>\n");
        }
    }
}

/* A basis that is no part of a geometry has an `id`, by which a file is asked for it. */
static void put_basis(kw_out *f, const kw_mesh *m, const char *kind, const char *id)
{
    kw_out_text(f, "  <Basis type=\"%sBasis", kind);
    if (m->D > 1)
        kw_out_text(f, "%d", m->D);
    kw_out_text(f, "\"%s>\n", id);
    if (m->D > 1)
        kw_out_text(f, "   <Basis type=\"TensorBSplineBasis%d\">\n", m->D);
    put_directions(f, m->D, m->level[0].s);
    if (m->D > 1)
        kw_out_text(f, "   </Basis>\n");
    put_boxes(f, m);
    kw_out_text(f, "  </Basis>\n");
}

int gen_xml_mesh(const char *path, const kw_mesh *m)
{
    kw_out *f = begin(path);

    put_basis(f, m, "THBSpline", " id=\"0\"");
    return end(f);
}

/* A function by level and multi-index, to be put in the order of G+Smo. */
typedef struct place {
    int level, j[KW_TENSOR_D], index;
} place;

static int compare(const void *a, const void *b)
{
    const place *p = a, *q = b;

    if (p->level != q->level)
        return p->level < q->level ? -1 : 1;
    for (int h = KW_TENSOR_D - 1; h >= 0; h--)
        if (p->j[h] != q->j[h])
            return p->j[h] < q->j[h] ? -1 : 1;
    return 0;
}

int gen_xml_hier(const char *path, const kw_hier *b, kw_hier_kind kind, int N,
                 const double *c)
{
    const kw_active *a = b->active;
    const char *name = kind == KW_THB ? "THBSpline" : "HBSpline";
    place *all = kw_need_memory((size_t)a->size, sizeof *all);
    kw_out *f = begin(path);

    for (int i = 0; i < a->size; i++) {
        all[i].index = i;
        kw_active_function(a, i, &all[i].level, all[i].j);
    }
    qsort(all, (size_t)a->size, sizeof *all, compare);
    kw_out_text(f, " <Geometry type=\"%s", name);
    kw_out_text(f, a->mesh->D > 1 ? "%d\" id=\"0\">\n" : "\" id=\"0\">\n", a->mesh->D);
    put_basis(f, a->mesh, name, "");
    kw_out_text(f, "  <coefs geoDim=\"%d\">\n", N);
    for (int i = 0; i < a->size; i++)
        put_point(f, N, c + all[i].index * N);
    kw_out_text(f, "  </coefs>\n </Geometry>\n");
    free(all);
    return end(f);
}
