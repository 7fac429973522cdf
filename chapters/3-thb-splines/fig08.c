/* Figure 8 -- The HB basis of degree 2 on two levels.

   What to see: of the coarse functions (a) those remain that reach out of the refined domain
   (c); of the fine ones (b) those that live in it (d); together they are the HB basis (e).

   Book: section 1.1, Definition 4, (13), (14).
   Claims: hb.fig8.*
   Chosen here: the domain Omega^1 = [1/4, 3/4]. The book draws one and prints none. */

#include "claim.h"  /* what we found, for the ledger */
#include "hier.h"   /* the basis */
#include "meshes.h" /* the mesh to begin with */
#include "out.h"    /* columns for gnuplot */

enum { DEGREE = 2, CELLS = 8, LOW = 2, HIGH = 6, SAMPLES = 240 };

/* Which functions of a level a panel shows. */
typedef enum choice { ALL, ACTIVE } choice;

/* One curve on its support. */
static void write_function(kw_out *f, const kw_bspline *s, int level, int j)
{
    for (int i = 0; i <= SAMPLES; i++) {
        double x = (double)i / SAMPLES;

        if (x < s->t[j] || x > s->t[j + s->d + 1])
            continue;
        kw_out_number(f, x);
        kw_out_number(f, kw_bspline_one(s, j, 0, x));
        kw_out_number(f, j);
        kw_out_number(f, level);
        kw_out_row(f);
    }
    kw_out_gap(f);
}

/* A panel with functions of the levels first .. last; returns how many. */
static int write_panel(kw_out *f, const char *name, const kw_active *a, choice which,
                       int first, int last)
{
    int count = 0;

    kw_out_section(f, name, "x value function level");
    for (int level = first; level <= last; level++) {
        const kw_bspline *s = a->mesh->level[level].s[0];

        for (int j = 0; j < s->n; j++)
            if (which == ALL || kw_active_find(a, level, &j) >= 0) {
                write_function(f, s, level, j);
                count++;
            }
    }
    return count;
}

/* Interior knots of a space on open knots. */
static int interior_knots(const kw_bspline *s)
{
    return s->n - s->d - 1;
}

/* Functions of the basis that a panel with the active functions of one level leaves out. */
static int left_out(const kw_active *a, int shown)
{
    int count = 0;

    for (int i = 0; i < a->size; i++) {
        int level, j;

        kw_active_function(a, i, &level, &j);
        count += level != shown;
    }
    return count;
}

int main(void)
{
    kw_out *f = kw_out_data("fig08"), *report = kw_claim_new("fig08");
    kw_mesh *m = uniform_mesh(1, DEGREE, CELLS);
    kw_active *a;
    int coarse, fine, both;

    refine_interval(m, 0, LOW, HIGH);
    a = kw_active_new(m);
    write_panel(f, "coarse", a, ALL, 0, 0);
    write_panel(f, "fine", a, ALL, 1, 1);
    coarse = write_panel(f, "active coarse", a, ACTIVE, 0, 0);
    fine = write_panel(f, "active fine", a, ACTIVE, 1, 1);
    both = write_panel(f, "basis", a, ACTIVE, 0, 1);
    kw_out_section(f, "domain", "low high");
    kw_out_number(f, (double)LOW / CELLS);
    kw_out_number(f, (double)HIGH / CELLS);
    kw_out_row(f);

    kw_claim_count(report, "hb.fig8.knots.coarse", interior_knots(m->level[0].s[0]));
    kw_claim_count(report, "hb.fig8.knots.fine", interior_knots(m->level[1].s[0]));
    kw_claim_count(report, "hb.fig8.active.coarse", coarse);
    kw_claim_count(report, "hb.fig8.active.fine", fine);
    kw_claim_count(report, "hb.fig8.basis", both);
    kw_claim_count(report, "hb.fig8.panel-d", left_out(a, 1));

    kw_active_free(a);
    kw_mesh_free(m);
    return kw_out_close(f) | kw_out_close(report);
}
