/* hierset.h -- random hierarchical meshes, for the families mesh and thb, whose first parameters
   are the same. */
#ifndef GEN_HIERSET_H
#define GEN_HIERSET_H

#include "active.h"
#include "set.h"

/* The first parameters of both families, and their first arrays. */
enum { HIER_DIM, HIER_DEGREE, HIER_CELLS, HIER_LEVELS, HIER_KIND, HIER_PARAMETERS };
enum { HIER_COUNTS, HIER_PER_LEVEL, HIER_ACTIVE, HIER_ARRAYS };

/* What gen --help and the reader of calls know of these parameters: the first rows of
   gen_family.parameter. */
#define HIER_FIRST_PARAMETERS                                                            \
    [HIER_DIM] = {"--dim", GEN_WHOLE, "2", 1, 3, NULL, "directions"},                    \
    [HIER_DEGREE] = {"--degree", GEN_WHOLE, "2", 1, 5, NULL, "in all directions"},       \
    [HIER_CELLS] = {"--cells", GEN_WHOLE, "8", 1, 64, NULL, "of level 0, a direction"},  \
    [HIER_LEVELS] = {"--levels", GEN_WHOLE, "3", 1, 10, NULL, "at most"},                \
    [HIER_KIND] = {"--kind",                                                             \
                   GEN_WORD,                                                             \
                   "boxes",                                                              \
                   0,                                                                    \
                   0,                                                                    \
                   "diagonal boxes front scattered",                                     \
                   "where it is refined"}

int hierset_check(const gen_call *c);

/* Adds the first arrays; `more` are further columns of `counts`. */
void hierset_plan(const gen_call *c, gen_plan *p, const char *more);

/* The mesh of a sample; the caller frees. */
kw_mesh *hierset_new(const gen_call *c, const gen_sample *s);

/* Fills the first arrays but for what `more` stands for; returns the row of counts from there. */
double *hierset_fill(const gen_call *c, gen_sample *s, const kw_active *a);

/* The corners of a cell: low[0..D-1] and high[0..D-1]. */
void hierset_corners(const kw_mesh *m, int level, const int *cell, double *low,
                     double *high);

#endif
