/* The limits of mesh files: the same for who reads and who writes, and none of them a surprise. */
#include "meshes.h"
#include "meshfile.h"
#include "out.h"
#include <stdarg.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TEXT = 1 << 14 };

/* A text in the making. */
typedef struct text {
    char letters[TEXT];
    int size;
} text;

static void add(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(text *t, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    t->size += vsnprintf(t->letters + t->size, (size_t)(TEXT - t->size), format, values);
    va_end(values);
    KW_NEED(t->size < TEXT, "%d characters", t->size);
}

/* `cells` unit cells in each of D directions, of degree 0. */
static void add_grid(text *t, int D, int cells)
{
    t->size = 0;
    add(t, "degree%s\n", D == 1 ? " 0" : " 0 0 0");
    for (int h = 0; h < D; h++) {
        add(t, "knots");
        for (int i = 0; i <= cells; i++)
            add(t, " %d", i);
        add(t, "\n");
    }
}

static kw_mesh *parse(const text *t, char *message)
{
    return kw_meshfile_parse(t->letters, (size_t)t->size, "m.mesh", message);
}

/* --- knots --- */

/* A first cell that is refined again and again is written, and read again. */
static void deep(int cells, int levels)
{
    const char *path = KW_BUILD "/tests/meshfile-deep";
    kw_tensor *g = meshes_uniform(1, 1, cells);
    kw_mesh *m = kw_mesh_new(g), *again;
    char message[KW_MESHFILE_MESSAGE];
    const int low = 0, high = 1;

    kw_tensor_free(g);
    for (int level = 0; level + 1 < levels; level++)
        kw_mesh_refine(m, level, &low, &high);
    CHECK(kw_meshfile_write(m, path) == 0, "%s", path);
    kw_mesh_free(m);
    again = kw_meshfile_read(path, message);
    CHECK(again && again->levels == levels, "%s", message);
    kw_mesh_free(again);
    unlink(path);
}

static void deep_meshes_come_back(void)
{
    mkdir(KW_BUILD "/tests", 0777);
    deep(16, 19);
    deep(1, KW_MESH_LEVELS);
}

/* 16 cells and 22 levels: 16 (2^22 - 1) + 22 knots, 22 - 16 too many. */
static void too_many_knots(void)
{
    text *t = room_for(1, sizeof *t);
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m;

    add_grid(t, 1, 16);
    for (int level = 0; level < 21; level++)
        add(t, "refine %d 0 1\n", level);
    m = parse(t, message);
    CHECK(!m, "%d levels", m ? m->levels : 0);
    CHECK(strcmp(message, "m.mesh:23: with level 21 the mesh would have 67108870 knots, "
                          "more than 67108864") == 0,
          "%s", message);
    kw_mesh_free(m);
    free(t);
}

/* --- cells --- */

static void refused(const text *t, const char *what)
{
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m = parse(t, message);

    CHECK(!m, "accepted; not refused with %s", what);
    CHECK(strstr(message, what), "`%s' has no `%s'", message, what);
    kw_mesh_free(m);
}

/* 400^3 = 64e6 cells; a refined one adds 8. */
static void too_many_cells(void)
{
    text *t = room_for(1, sizeof *t);

    add_grid(t, 3, 400);
    add(t, "refine 0  0 0 0  400 400 2\nrefine 0  0 0 0  400 400 3\n");
    refused(t, "m.mesh:6: with this box the levels would have 67840000 cells, more than "
               "67108864");
    add_grid(t, 3, 407);
    refused(t, "m.mesh: 67419143 functions on level 0, more than 67108864");
    free(t);
}

/* Cells that are refined already add none, nor do those outside their domain. */
static void cells_count_once(void)
{
    text *t = room_for(1, sizeof *t);
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m;

    add_grid(t, 3, 400);
    for (int times = 0; times < 2; times++)
        add(t, "refine 0  0 0 0  400 400 2\n");
    for (int times = 0; times < 2; times++)
        add(t, "refine 1  0 0 3  800 50 800\n");
    m = parse(t, message);
    CHECK(m, "%s", message);
    CHECK(m && kw_mesh_active(m, 1) == 800 * 800 * 4 - 800 * 50, "%lld cells",
          m ? kw_mesh_active(m, 1) : 0);
    kw_mesh_free(m);
    free(t);
}

/* --- steps --- */

/* 17 times 64e6 cells: nothing is begun. */
static void too_many_steps(void)
{
    text *t = room_for(1, sizeof *t);

    add_grid(t, 3, 400);
    for (int times = 0; times < 17; times++)
        add(t, "refine 0  0 0 0  400 400 400\n");
    refused(t, "m.mesh:21: the boxes of level 0 to this one have 1088000000 cells, more "
               "than 1073741824; name cells only once");
    free(t);
}

/* --- writing --- */

static void write_too_large(void)
{
    kw_tensor *g = meshes_uniform(3, 0, 407);
    kw_mesh *m = kw_mesh_new(g);
    int failed = kw_meshfile_write(m, KW_BUILD "/tests/meshfile-large");

    kw_tensor_free(g);
    kw_mesh_free(m);
    KW_NEED(!failed, "kw_meshfile_write returned %d", failed);
}

static void what_cannot_be_read_is_not_written(void)
{
    test_aborts("kw_meshfile_write returned 1", write_too_large);
    test_aborts("not written: 67419143 cells", write_too_large);
    CHECK(access(KW_BUILD "/tests/meshfile-large", F_OK) != 0, "the file is there");
}

int main(void)
{
    test_run("meshfile: deep meshes come back", deep_meshes_come_back);
    test_run("meshfile: more than 2^26 knots are refused", too_many_knots);
    test_run("meshfile: more than 2^26 cells are refused", too_many_cells);
    test_run("meshfile: a cell counts once", cells_count_once);
    test_run("meshfile: more than 2^30 steps are refused before the first",
             too_many_steps);
    test_run("meshfile: what cannot be read is not written",
             what_cannot_be_read_is_not_written);
    return test_end();
}
