/* Symmetries -- what takes the place of translations on a graph.

   What to see: nothing to look at. A convolution on a grid is a linear map that commutes with
   translations, and that leaves one number a tap of the filter. On a graph the permutations
   that keep the edges take their place: on a circle they add a mirror, so that a filter has to be
   symmetric; other graphs have none but the identity, and then everything commutes.

   Book: section 1.2, on the convolution on a grid and the translations on a graph.
   Claims: gcn.symmetry.*
   Chosen here: a circle of eight nodes, with and without a direction, and six nodes: a
   triangle with a tail of one node and another of two. All permutations of the nodes are
   tried. */

#include "claim.h" /* what we found, for the ledger */
#include "out.h"   /* reports are files */

enum { MOST = 8 };

/* The next permutation in lexicographic order; 0 behind the last one. */
static int next_permutation(int n, int *p)
{
    int i = n - 2, j = n - 1, kept;

    while (i >= 0 && p[i] > p[i + 1])
        i--;
    if (i < 0)
        return 0;
    while (p[j] < p[i])
        j--;
    kept = p[i];
    p[i] = p[j];
    p[j] = kept;
    for (int a = i + 1, b = n - 1; a < b; a++, b--) {
        kept = p[a];
        p[a] = p[b];
        p[b] = kept;
    }
    return 1;
}

/* The permutations of n nodes that leave all arrows (joined, n x n) where they
   are; and the dimension of the linear maps that commute with each of them, the
   number of classes of entries (i,j) that such a map must give the same value. */
static int count_symmetries(int n, const char *joined, int *maps)
{
    int p[MOST] = {0}, class[MOST * MOST], symmetries = 0;

    for (int i = 0; i < n; i++)
        p[i] = i;
    for (int e = 0; e < n * n; e++)
        class[e] = e;
    do {
        int same = 1;

        for (int e = 0; e < n * n && same; e++)
            same = joined[e] == joined[p[e / n] * n + p[e % n]];
        symmetries += same;
        for (int e = 0; same && e < n * n; e++) {
            int a = class[e], b = class[p[e / n] * n + p[e % n]];

            for (int c = 0; a != b && c < n * n; c++)
                class[c] = class[c] == b ? a : class[c];
        }
    } while (next_permutation(n, p));
    *maps = 0;
    for (int e = 0; e < n * n; e++)
        *maps += class[e] == e;
    return symmetries;
}

static void join(int n, char *joined, int i, int j, int both)
{
    joined[i * n + j] = 1;
    if (both)
        joined[j * n + i] = 1;
}

int main(void)
{
    static const int tails[6][2] = {{1, 2}, {2, 5}, {5, 1}, {0, 1}, {2, 3}, {3, 4}};
    kw_out *report = kw_claim_new("ex_symmetries");
    char arrows[MOST * MOST] = {0}, circle[MOST * MOST] = {0}, triangle[6 * 6] = {0};
    int maps;

    for (int i = 0; i < MOST; i++) {
        join(MOST, arrows, i, (i + 1) % MOST, 0);
        join(MOST, circle, i, (i + 1) % MOST, 1);
    }
    for (int e = 0; e < 6; e++)
        join(6, triangle, tails[e][0], tails[e][1], 1);

    kw_claim_count(report, "gcn.symmetry.grid", count_symmetries(MOST, arrows, &maps));
    kw_claim_count(report, "gcn.symmetry.grid.maps", maps);
    kw_claim_count(report, "gcn.symmetry.circle", count_symmetries(MOST, circle, &maps));
    kw_claim_count(report, "gcn.symmetry.circle.maps", maps);
    kw_claim_count(report, "gcn.symmetry.none", count_symmetries(6, triangle, &maps));
    kw_claim_count(report, "gcn.symmetry.none.maps", maps);
    return kw_out_close(report);
}
