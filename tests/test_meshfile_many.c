/* Mesh files of a million lines, as a program may write that refines cell by cell. */
#include "meshes.h"
#include "meshfile.h"
#include "out.h"
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MANY = 1000000, CELLS = 256, SIDE = 9 };

static const char *const path = KW_BUILD "/tests/meshfile-many";

static FILE *new_file(void)
{
    FILE *f;

    mkdir(KW_BUILD, 0777);
    mkdir(KW_BUILD "/tests", 0777);
    f = fopen(path, "wb");
    KW_NEED(f, "%s", path);
    return f;
}

/* The mesh of the file, which is closed and removed. */
static kw_mesh *mesh_of(FILE *f)
{
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m;

    fclose(f);
    m = kw_meshfile_read(path, message);
    CHECK(m, "%s", message);
    unlink(path);
    return m;
}

static void a_million_lines_are_read(void)
{
    FILE *f = new_file();
    kw_mesh *m;

    fputs("degree 2 2\nknots 0 0 0 1 2 3 4 4 4\nknots 0 0 0 1 2 3 4 4 4\n", f);
    for (int i = 0; i < MANY; i++) {
        int level = i % 3, at = i % ((4 << level) - 1);

        fprintf(f, "refine %d  %d %d  %d %d\n", level, at, at, at + 2, at + 2);
    }
    m = mesh_of(f);
    CHECK(m && m->levels == 4, "%d levels", m ? m->levels : 0);
    kw_mesh_free(m);
}

/* Each cell is named a thousand times. */
static void a_million_boxes_may_overlap(void)
{
    FILE *f = new_file();
    kw_mesh *m;

    fputs("degree 0 0\n", f);
    for (int h = 0; h < 2; h++) {
        fputs("knots", f);
        for (int i = 0; i <= CELLS; i++)
            fprintf(f, " %d", i);
        fputs("\n", f);
    }
    for (int i = 0; i < MANY; i++) {
        int places = CELLS - SIDE + 1, a = i % places, b = i / places % places;

        fprintf(f, "refine 0  %d %d  %d %d\n", a, b, a + SIDE, b + SIDE);
    }
    m = mesh_of(f);
    CHECK(m && kw_mesh_active(m, 1) == 4 * CELLS * CELLS, "%lld cells",
          m ? kw_mesh_active(m, 1) : 0);
    kw_mesh_free(m);
}

int main(void)
{
    test_run("meshfile: a million lines are read", a_million_lines_are_read);
    test_run("meshfile: a million boxes that overlap are read",
             a_million_boxes_may_overlap);
    return test_end();
}
