#include "truncation.h"
#include "need.h"
#include <stdlib.h>
#include <string.h>

enum { SPARE = 8 };

kw_truncation *kw_truncation_new(int local)
{
    kw_truncation *t = kw_need_memory(1, sizeof *t);

    t->local = local;
    return t;
}

void kw_truncation_free(kw_truncation *t)
{
    if (!t)
        return;
    free(t->index);
    free(t->row);
    free(t->work);
    free(t);
}

/* Room for `count` functions. */
static void make_room(kw_truncation *t, int count)
{
    size_t numbers;

    if (count <= t->room)
        return;
    t->room = count + count / 2 + SPARE;
    numbers = (size_t)t->local * (size_t)t->room;
    t->index = realloc(t->index, (size_t)t->room * sizeof *t->index);
    t->row = realloc(t->row, numbers * sizeof *t->row);
    t->work = realloc(t->work, numbers * sizeof *t->work);
    KW_NEED(t->index && t->row && t->work, "memory for %d functions on a cell", t->room);
}

static double *row_of(const kw_truncation *t, int f)
{
    return t->row + (size_t)f * (size_t)t->count;
}

/* --- from a cell to its child --- */

/* Is every local function of the cell one that Definition 5 cuts off from coarser ones? Then
   nothing is left of these, and nothing has to be computed. */
static int all_cut_off(const int *is, int local)
{
    for (int f = 0; f < local; f++)
        if (is[f] < KW_ACTIVE_COVERED)
            return 0;
    return 1;
}

/* Sets what Definition 5 cuts off to zero. [source text, (15), (16)] */
static void cut_off(kw_truncation *t, const int *is)
{
    for (int f = 0; f < t->local; f++)
        if (is[f] >= KW_ACTIVE_COVERED)
            memset(row_of(t, f), 0, (size_t)t->count * sizeof *t->row);
}

static int is_zero(const kw_truncation *t, int i)
{
    for (int f = 0; f < t->local; f++)
        if (row_of(t, f)[i] != 0)
            return 0;
    return 1;
}

/* Drops the functions of which nothing is left. */
static void drop_zeros(kw_truncation *t)
{
    int kept = 0;

    for (int i = 0; i < t->count; i++) {
        if (is_zero(t, i))
            continue;
        t->index[kept] = t->index[i];
        for (int f = 0; kept < i && f < t->local; f++)
            row_of(t, f)[kept] = row_of(t, f)[i];
        kept++;
    }
    for (int f = 1; kept < t->count && f < t->local; f++)
        memmove(t->row + (size_t)f * (size_t)kept, row_of(t, f),
                (size_t)kept * sizeof *t->row);
    t->count = kept;
}

void kw_truncation_refine(const kw_truncation *cell, const kw_twoscale *halves, int child,
                          const int *is, kw_truncation *t)
{
    int numbers = cell->count * cell->local;

    t->count = 0;
    if (cell->count == 0 || all_cut_off(is, cell->local))
        return;
    make_room(t, cell->count);
    t->count = cell->count;
    memcpy(t->index, cell->index, (size_t)t->count * sizeof *t->index);
    memcpy(t->row, cell->row, (size_t)numbers * sizeof *t->row);
    kw_twoscale_apply(halves, child, numbers, t->row, t->work);
    cut_off(t, is);
    drop_zeros(t);
}

/* --- the active functions of a level --- */

void kw_truncation_add(kw_truncation *t, const int *is)
{
    const int before = t->count;
    double *wider;
    int next = before;

    for (int f = 0; f < t->local; f++)
        t->count += is[f] >= KW_ACTIVE_FIRST;
    if (t->count == before)
        return;
    make_room(t, t->count);
    wider = t->work;
    memset(wider, 0, (size_t)t->local * (size_t)t->count * sizeof *wider);
    for (int f = 0; f < t->local; f++, wider += t->count) {
        memcpy(wider, t->row + (size_t)f * (size_t)before,
               (size_t)before * sizeof *wider);
        if (is[f] >= KW_ACTIVE_FIRST) {
            t->index[next] = is[f] - KW_ACTIVE_FIRST;
            wider[next++] = 1;
        }
    }
    wider = t->work;
    t->work = t->row;
    t->row = wider;
}
