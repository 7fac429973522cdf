/* Meshes -- what goes wrong when a domain follows the grid of its own level.

   What to see: top, Omega^1 is one cell of level 1, half a cell of level 0: that cell is no
   longer active, its other half is not refined, and a hole is left. Bottom, Omega^1 is a union
   of cells of level 0, and every point lies in one active cell.

   Book: section 1.1, the nested domains, the hierarchical mesh, Remark 8.
   Claims: hb.mesh.*
   Chosen here: two cells on [0,2] for the smallest example; 100 random domains. */

#include "claim.h"  /* what we found, for the ledger */
#include "meshes.h" /* meshes that follow the rule */
#include "out.h"    /* columns for gnuplot */
#include "rng.h"    /* random domains */

enum { CELLS = 2, MOST = 16, DOMAINS = 100 };

/* How often each half cell is covered by active cells, when Omega^1 is any set of half cells.
   inside[i] says whether half cell i belongs to it; an active cell of level 0 is one that
   meets Omega^1 nowhere, as the printed definition has it for open cells. */
static void cover(int cells, const int *inside, int *covered)
{
    for (int i = 0; i < 2 * cells; i++)
        covered[i] = inside[i]; /* the active cells of level 1 */
    for (int c = 0; c < cells; c++)
        if (!inside[2 * c] && !inside[2 * c + 1]) {
            covered[2 * c]++;
            covered[2 * c + 1]++;
        }
}

static int count_holes(int cells, const int *inside)
{
    int covered[2 * MOST], holes = 0;

    cover(cells, inside, covered);
    for (int i = 0; i < 2 * cells; i++)
        holes += covered[i] == 0;
    return holes;
}

static void write_example(kw_out *f, const char *name, const int *inside)
{
    int covered[2 * MOST];

    cover(CELLS, inside, covered);
    kw_out_section(f, name, "x inside covered");
    for (int i = 0; i < 2 * CELLS; i++) {
        kw_out_number(f, (i + 0.5) / 2);
        kw_out_number(f, inside[i]);
        kw_out_number(f, covered[i]);
        kw_out_row(f);
    }
}

/* Random domains of half cells (or, with whole != 0, of whole cells) that leave a hole. */
static int random_domains_with_holes(int whole)
{
    kw_rng r = kw_rng_at(27, 0, 0, (uint64_t)whole);
    int with_holes = 0;

    for (int i = 0; i < DOMAINS; i++) {
        int cells = 2 + kw_rng_below(&r, MOST - 1), inside[2 * MOST];

        for (int c = 0; c < 2 * cells; c++)
            inside[c] = whole && c % 2 ? inside[c - 1] : kw_rng_below(&r, 2);
        with_holes += count_holes(cells, inside) > 0;
    }
    return with_holes;
}

/* In the library's meshes: cells of the finest grid that do not lie in exactly one active
   cell, over random meshes in D = 1, 2, 3. */
static long long badly_covered(void)
{
    long long bad = 0;

    for (int D = 1; D <= KW_TENSOR_D; D++)
        for (uint64_t i = 0; i < 20; i++) {
            kw_mesh *m = random_mesh(28, i, D);
            long long total = 1, sum = 0;

            for (int h = 0; h < D; h++)
                total *= m->level[m->levels - 1].cells[h];
            for (int level = 0; level < m->levels; level++)
                sum += kw_mesh_active(m, level) << D * (m->levels - 1 - level);
            bad += sum != total;
            kw_mesh_free(m);
        }
    return bad;
}

int main(void)
{
    static const int lax[2 * CELLS] = {1, 0, 0, 0}, strict[2 * CELLS] = {1, 1, 0, 0};
    kw_out *f = kw_out_data("ex_mesh"), *report = kw_claim_new("ex_mesh");

    write_example(f, "lax", lax);
    write_example(f, "strict", strict);
    kw_claim_count(report, "hb.mesh.hole", count_holes(CELLS, lax));
    kw_claim_count(report, "hb.mesh.strict", count_holes(CELLS, strict));
    kw_claim_count(report, "hb.mesh.random", random_domains_with_holes(0));
    kw_claim_count(report, "hb.mesh.random.strict", random_domains_with_holes(1));
    kw_claim_count(report, "hb.mesh.tessellation", badly_covered());
    return kw_out_close(f) | kw_out_close(report);
}
