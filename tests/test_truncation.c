/* The table of THB-splines on a cell, on meshes where its numbers follow by hand. */
#include "meshes.h"
#include "truncation.h"

enum { LOCAL = 3, OTHER = KW_ACTIVE_OUTSIDE };

/* Quadratics on unit spans, of which the middle ones have no end in their support: a B-spline is
   1/4, 3/4, 3/4, 1/4 of those of half the span. */
static void quadratic_halves(kw_twoscale *halves)
{
    kw_tensor *g = meshes_uniform(1, 2, 8);
    kw_mesh *m = kw_mesh_new(g);
    const int cell[] = {4}, end[] = {5};

    kw_tensor_free(g);
    kw_mesh_refine(m, 0, cell, end);
    kw_twoscale_of_cell(m, 0, cell, halves);
    kw_mesh_free(m);
}

/* Functions 5, 6 and 7 are the local ones of the cell. */
static kw_truncation *three(void)
{
    const int is[] = {KW_ACTIVE_FIRST + 5, KW_ACTIVE_FIRST + 6, KW_ACTIVE_FIRST + 7};
    kw_truncation *t = kw_truncation_new(LOCAL);

    kw_truncation_add(t, is);
    return t;
}

static void same_table(const kw_truncation *t, int count, const int *index,
                       const double *row)
{
    CHECK(t->count == count, "%d functions, not %d", t->count, count);
    for (int i = 0; i < count; i++)
        CHECK(t->index[i] == index[i], "%d: %d, not %d", i, t->index[i], index[i]);
    for (int i = 0; i < LOCAL * count; i++)
        CHECK(t->row[i] == row[i], "number %d: %g, not %g", i, t->row[i], row[i]);
}

static void active_ones_are_themselves(void)
{
    const int index[] = {5, 6, 7};
    const double row[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    kw_truncation *t = three();

    same_table(t, 3, index, row);
    kw_truncation_free(t);
}

/* One row for each local function of the half, one column for each of 5, 6, 7. */
static void halves_follow_the_relation(void)
{
    const int index[] = {5, 6, 7}, is[] = {OTHER, OTHER, OTHER};
    const double first[] = {0.75, 0.25, 0, 0.25, 0.75, 0, 0, 0.75, 0.25};
    const double second[] = {0.25, 0.75, 0, 0, 0.75, 0.25, 0, 0.25, 0.75};
    kw_truncation *t = three(), *half = kw_truncation_new(LOCAL);
    kw_twoscale halves;

    quadratic_halves(&halves);
    kw_truncation_refine(t, &halves, 0, is, half);
    same_table(half, 3, index, first);
    kw_truncation_refine(t, &halves, 1, is, half);
    same_table(half, 3, index, second);
    kw_truncation_free(t);
    kw_truncation_free(half);
}

/* The first half: without its first two local functions nothing is left of 5; without all, of
   none of them. Whether these are covered or active, they are cut off. */
static void what_is_cut_off(void)
{
    const int index[] = {6, 7, 9},
              two[] = {KW_ACTIVE_COVERED, KW_ACTIVE_FIRST + 9, OTHER};
    const int all[] = {KW_ACTIVE_COVERED, KW_ACTIVE_FIRST, KW_ACTIVE_FIRST + 1};
    const double row[] = {0, 0, 0, 0, 0.75, 0.25};
    const double with_active[] = {0, 0, 0, 0, 0, 1, 0.75, 0.25, 0};
    kw_truncation *t = three(), *half = kw_truncation_new(LOCAL);
    kw_twoscale halves;

    quadratic_halves(&halves);
    kw_truncation_refine(t, &halves, 0, two, half);
    same_table(half, 2, index, row);
    kw_truncation_add(half, two);
    same_table(half, 3, index, with_active);
    kw_truncation_refine(t, &halves, 0, all, half);
    same_table(half, 0, index, row);
    kw_truncation_free(t);
    kw_truncation_free(half);
    kw_truncation_free(NULL);
}

int main(void)
{
    test_run("truncation: an active function is one of the local ones",
             active_ones_are_themselves);
    test_run("truncation: halves of a cell follow the two-scale relation",
             halves_follow_the_relation);
    test_run("truncation: what lies in finer domains is cut off, zeros are dropped",
             what_is_cut_off);
    return test_end();
}
