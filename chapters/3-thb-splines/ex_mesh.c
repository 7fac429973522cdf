/* Meshes -- what goes wrong when a domain follows the grid of its own level.

   What to see: top, Omega^1 is one cell of level 1, half a cell of level 0: that cell is no
   longer active, its other half is not refined, and a hole is left. Bottom, Omega^1 is a union
   of cells of level 0, and every point lies in one active cell.

   Book: section 1.1, the nested domains, the hierarchical mesh, Remark 8.
   Claims: hb.mesh.*
   Chosen here: two cells on [0,2] for the picture (one would do for a hole, but then no cell of
   level 0 is active); 100 random domains of each kind; 20 random meshes each in D = 1, 2, 3. */

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

static void write_box(kw_out *f, double low, double high, int level)
{
    kw_out_number(f, low);
    kw_out_number(f, high);
    kw_out_number(f, level);
    kw_out_row(f);
}

/* The active cells with their level, and half cells in no active cell with level -1. */
static void write_example(kw_out *f, const char *name, const int *inside)
{
    int covered[2 * MOST];

    cover(CELLS, inside, covered);
    kw_out_section(f, name, "low high level");
    for (int c = 0; c < CELLS; c++)
        if (!inside[2 * c] && !inside[2 * c + 1])
            write_box(f, c, c + 1, 0);
    for (int i = 0; i < 2 * CELLS; i++)
        if (inside[i] || covered[i] == 0)
            write_box(f, i / 2.0, (i + 1) / 2.0, inside[i] ? 1 : -1);
}

/* Random domains of half cells that leave a hole. */
static int random_domains_with_holes(void)
{
    kw_rng r = kw_rng_at(27, 0, 0, 0);
    int with_holes = 0;

    for (int i = 0; i < DOMAINS; i++) {
        int cells = 2 + kw_rng_below(&r, MOST - 1), inside[2 * MOST];

        for (int c = 0; c < 2 * cells; c++)
            inside[c] = kw_rng_below(&r, 2);
        with_holes += count_holes(cells, inside) > 0;
    }
    return with_holes;
}

/* Does a cell of the finest level lie in exactly one active cell, and does the library find its
   middle there? */
static int well_covered(const kw_mesh *m, const int *cell)
{
    int finest = m->levels - 1, holder = 0, holders = 0, found[KW_TENSOR_D], same;
    double x[KW_TENSOR_D];

    for (int level = 0; level <= finest; level++) {
        int around[KW_TENSOR_D];

        for (int h = 0; h < m->D; h++)
            around[h] = cell[h] >> (finest - level);
        if (kw_mesh_inside(m, level, around) && !kw_mesh_refined(m, level, around)) {
            holder = level;
            holders++;
        }
    }
    for (int h = 0; h < m->D; h++) {
        double low, high;

        cell_ends(m, finest, h, cell[h], &low, &high);
        x[h] = (low + high) / 2;
    }
    same = kw_mesh_locate(m, x, found) == holder;
    for (int h = 0; h < m->D; h++)
        same = same && found[h] == cell[h] >> (finest - holder);
    return holders == 1 && same;
}

/* Cells of the finest level that are not well covered. */
static long long badly_covered(const kw_mesh *m)
{
    uint64_t cells = 1;
    long long bad = 0;

    for (int h = 0; h < m->D; h++)
        cells *= (uint64_t)m->level[m->levels - 1].cells[h];
    for (uint64_t flat = 0; flat < cells; flat++) {
        int cell[KW_TENSOR_D] = {0};

        kw_mesh_multi(m, m->levels - 1, flat, cell);
        bad += !well_covered(m, cell);
    }
    return bad;
}

/* The mesh of the picture, where the refined domain is a whole cell. */
static long long badly_covered_of_picture(void)
{
    kw_mesh *m = uniform_mesh(1, 1, CELLS);
    long long bad;

    refine_interval(m, 0, 0, 1);
    bad = badly_covered(m);
    kw_mesh_free(m);
    return bad;
}

/* Meshes with random domains of whole cells that leave a hole. */
static int random_meshes_with_holes(void)
{
    kw_rng r = kw_rng_at(27, 0, 0, 1);
    int with_holes = 0;

    for (int i = 0; i < DOMAINS; i++) {
        int cells = 2 + kw_rng_below(&r, MOST - 1);
        kw_mesh *m = uniform_mesh(1, 1, cells);

        for (int c = 0; c < cells; c++)
            if (kw_rng_below(&r, 2))
                refine_interval(m, 0, c, c + 1);
        with_holes += badly_covered(m) > 0;
        kw_mesh_free(m);
    }
    return with_holes;
}

/* Badly covered cells of random meshes in D = 1, 2, 3. */
static long long badly_covered_of_random(void)
{
    long long bad = 0;

    for (int D = 1; D <= KW_TENSOR_D; D++)
        for (uint64_t i = 0; i < 20; i++) {
            kw_mesh *m = random_mesh(28, i, D);

            bad += badly_covered(m);
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
    kw_claim_count(report, "hb.mesh.strict", badly_covered_of_picture());
    kw_claim_count(report, "hb.mesh.random", random_domains_with_holes());
    kw_claim_count(report, "hb.mesh.random.strict", random_meshes_with_holes());
    kw_claim_count(report, "hb.mesh.tessellation", badly_covered_of_random());
    return kw_out_close(f) | kw_out_close(report);
}
