/* Exercise 3 -- how small may a refined domain be?

   What to see: nothing to look at. On a domain of one cell no finer function finds room; on two
   cells some do, while no coarse one is dropped yet; on three a coarse one goes.

   Book: section 1.1, Definition 4.
   Claims: hb.predict.*
   Chosen here: degree 2 on eight equal cells of the line, the domain in the interior. */

#include "active.h" /* which functions are selected */
#include "claim.h"  /* what we found, for the ledger */
#include "meshes.h" /* the mesh to begin with */
#include "out.h"    /* reports are files */

enum { DEGREE = 2, CELLS = 8, LOW = 3, MOST = 3 };

/* The active functions of a level if Omega^1 has `cells` cells, from LOW on. */
static int count_active(int cells, int level)
{
    kw_mesh *m = uniform_mesh(1, DEGREE, CELLS);
    kw_active *a;
    int count = 0;

    refine_interval(m, 0, LOW, LOW + cells);
    a = kw_active_new(m);
    for (int i = 0; i < a->size; i++) {
        int own, j;

        kw_active_function(a, i, &own, &j);
        count += own == level;
    }
    kw_active_free(a);
    kw_mesh_free(m);
    return count;
}

int main(void)
{
    static const char *const dropped[MOST] = {
        "hb.predict.1.dropped", "hb.predict.2.dropped", "hb.predict.3.dropped"};
    static const char *const added[MOST] = {"hb.predict.1.added", "hb.predict.2.added",
                                            "hb.predict.3.added"};
    kw_out *report = kw_claim_new("ex_predict_domain");

    for (int cells = 1; cells <= MOST; cells++) {
        kw_claim_count(report, dropped[cells - 1],
                       CELLS + DEGREE - count_active(cells, 0));
        kw_claim_count(report, added[cells - 1], count_active(cells, 1));
    }
    return kw_out_close(report);
}
