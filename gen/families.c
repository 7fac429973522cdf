/* families.c -- all families, in the order of the help. */
#include "set.h"
#include <string.h>

extern const gen_family gen_curve;
extern const gen_family gen_scatter;
extern const gen_family gen_classes;
extern const gen_family gen_patch;
extern const gen_family gen_family_mesh;
extern const gen_family gen_thb;
extern const gen_family gen_signal;
extern const gen_family gen_graph;

const gen_family *const gen_families[] = {&gen_curve,       &gen_patch, &gen_scatter,
                                          &gen_family_mesh, &gen_thb,   &gen_classes,
                                          &gen_signal,      &gen_graph};
const int gen_family_count = sizeof gen_families / sizeof *gen_families;

const gen_family *gen_family_find(const char *name)
{
    for (int i = 0; i < gen_family_count; i++)
        if (strcmp(gen_families[i]->name, name) == 0)
            return gen_families[i];
    return NULL;
}
