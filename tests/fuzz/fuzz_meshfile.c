/* fuzz_meshfile.c -- the reader of mesh files under random text: it must accept the text or
   say what is wrong, within bounded time and memory. What it accepts and is small is built:
   the two ways to count agree, and THB-splines add up to one. `make fuzz` runs it. */
#include "hier.h"
#include "meshfile.h"
#include "need.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_CELLS = 400,        /* of all levels */
    MOST_IN_DIRECTION = 512, /* on the deepest level */
    MOST_LOCAL = 64,
    PARTS = 4 /* points a direction: its domain in so many parts */
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int is_small(const kw_mesh *m)
{
    const kw_mesh_level *deepest = &m->level[m->levels - 1];
    double cells = 1, local = 1;

    for (int h = 0; h < m->D; h++) {
        cells *= m->level[0].cells[h];
        local *= m->level[0].s[h]->d + 1;
        if (deepest->cells[h] > MOST_IN_DIRECTION)
            return 0;
    }
    for (int l = 0; l < m->levels; l++)
        cells += (double)m->level[l].count * (1 << m->D);
    return cells <= MOST_CELLS && local <= MOST_LOCAL;
}

/* Point i, 0 <= i < (PARTS+1)^D, of a grid with both ends of the domain. */
static void grid_point(const kw_mesh *m, int i, double *x)
{
    for (int h = 0; h < m->D; h++) {
        const kw_bspline *s = m->level[0].s[h];
        double a = s->t[s->d], b = s->t[s->n], share = (double)(i % (PARTS + 1)) / PARTS;

        x[h] = i % (PARTS + 1) == PARTS ? b : a + share * (b - a);
        i /= PARTS + 1;
    }
}

static void check_unity(const kw_hier *b)
{
    const kw_mesh *m = b->active->mesh;
    int points = 1, *index = kw_need_memory((size_t)b->most, sizeof *index);
    double *value = kw_need_memory((size_t)b->most, sizeof *value);

    for (int h = 0; h < m->D; h++)
        points *= PARTS + 1;
    for (int i = 0; i < points; i++) {
        double x[KW_TENSOR_D], sum = 0;
        int count;

        grid_point(m, i, x);
        count = kw_hier_at(b, KW_THB, NULL, x, index, value);
        for (int f = 0; f < count; f++)
            sum += value[f];
        KW_NEED(fabs(sum - 1) < 1e-12, "the values at point %d add up to %.17g", i, sum);
    }
    free(index);
    free(value);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char message[KW_MESHFILE_MESSAGE] = "";
    kw_mesh *m = kw_meshfile_parse((const char *)data, size, "random", message);

    KW_NEED((m == NULL) == (message[0] != 0), "message `%s'", message);
    if (m && is_small(m)) {
        kw_hier *b = kw_hier_new(m);
        long long kraft = kw_active_kraft(m);

        KW_NEED(b->active->size == kraft, "%d functions, by Kraft %lld", b->active->size,
                kraft);
        check_unity(b);
        kw_hier_free(b);
    }
    kw_mesh_free(m);
    return 0;
}
