/* xml.h -- splines as files of G+Smo: XML, the degree with each knot vector, coefficients in the
   order of G+Smo, direction 0 fastest. Numbers have 17 digits.
   [Juettler, Langer, Mantzaflaris, Moore, Zulehner: Geometry + Simulation Modules, PAMM 14
   (2014)] */
#ifndef GEN_XML_H
#define GEN_XML_H

#include "hier.h"

/* All return 0, or 1 after a message on stderr. c: coefficients, row-major, in R^N. */

/* A curve: `BSpline`. c is n x N. */
int gen_xml_curve(const char *path, const kw_bspline *s, int N, const double *c);

/* A surface in a space of two directions: `TensorBSpline2`. c is n_0 x n_1 x N. */
int gen_xml_surface(const char *path, const kw_tensor *g, int N, const double *c);

/* A hierarchical surface or curve: `THBSpline2` or `HBSpline2` and their like in 1 or 3
   directions. c is size x N in the order of active.h. */
int gen_xml_hier(const char *path, const kw_hier *b, kw_hier_kind kind, int N,
                 const double *c);

/* The hierarchical mesh alone, as the basis of THB-splines that it carries. */
int gen_xml_mesh(const char *path, const kw_mesh *m);

#endif
