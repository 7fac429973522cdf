/* gen mesh -- random nested hierarchical meshes and their counts. */
#include "hierset.h"
#include "meshfile.h"
#include "vtu.h"
#include "xml.h"

enum { MESH, XML, VTU };

static void plan(const gen_call *c, gen_plan *p)
{
    hierset_plan(c, p, " functions");
}

static void make(const gen_call *c, void *work, gen_sample *s)
{
    kw_mesh *m = hierset_new(c, s);
    kw_active *a = kw_active_new(m);

    (void)work;
    hierset_fill(c, s, a)[0] = a->size;
    kw_active_free(a);
    kw_mesh_free(m);
}

static int write(const gen_call *c, const gen_sample *s, int format, const char *path)
{
    kw_mesh *m = hierset_new(c, s);
    int failed = format == MESH  ? kw_meshfile_write(m, path)
                 : format == XML ? gen_xml_mesh(path, m)
                                 : gen_vtu_mesh(path, m, NULL, NULL);

    kw_mesh_free(m);
    return failed;
}

const gen_family gen_family_mesh = {
    .name = "mesh",
    .summary = "random nested hierarchical meshes and their counts",
    .about = "A sample is a hierarchical mesh of the unit interval, square or cube: its "
             "active cells, and\n"
             "how many cells and functions each level has. Cells of every level that are "
             "refined:\n"
             "\n"
             "    diagonal   those that meet the line x = y = z; in one direction, a "
             "random point\n"
             "    boxes      those with their middle in a random box, one in the other\n"
             "    front      those that meet a random circle or sphere\n"
             "    scattered  each with the probability 1/3\n"
             "\n"
             "The format mesh is read by gen count and gen reference.\n",
    .example = "--cells 4 --levels 3 --format csv,npy,mesh,vtu",
    .stream = 7,
    .parameter =
        {
            HIER_FIRST_PARAMETERS,
        },
    .format = {"mesh", "xml", "vtu"},
    .check = hierset_check,
    .plan = plan,
    .make = make,
    .write = write,
};
