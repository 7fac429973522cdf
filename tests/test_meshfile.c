/* Mesh files: what is read is what was written; every malformed line is refused with file, line
   and what stands there. */
#include "meshfile.h"
#include "meshes.h"
#include "out.h"
#include "spline.h"
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#define SQUARE "degree 2 2\nknots 0 0 0 1 2 3 4 4 4\nknots 0 0 0 1 2 3 4 4 4\n"

enum { MESHES = 30 };

/* A path for a file of this program; the caller frees nothing. */
static const char *path_of(const char *name)
{
    static char path[256];

    mkdir(KW_BUILD, 0777);
    mkdir(KW_BUILD "/tests", 0777);
    snprintf(path, sizeof path, KW_BUILD "/tests/meshfile-%s", name);
    return path;
}

static void write_text(const char *path, const char *text, size_t size)
{
    FILE *f = fopen(path, "wb");

    KW_NEED(f, "%s", path);
    fwrite(text, 1, size, f);
    fclose(f);
}

/* Parses text that must be a mesh. */
static kw_mesh *parse(const char *text)
{
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m = kw_meshfile_parse(text, strlen(text), "m.mesh", message);

    CHECK(m, "%s", message);
    return m;
}

static int same_mesh(const kw_mesh *a, const kw_mesh *b)
{
    int same = a->D == b->D && a->levels == b->levels;

    for (int level = 0; level < a->levels && same; level++) {
        long long here, there;
        uint64_t *p = kw_mesh_cells(a, level, &here),
                 *q = kw_mesh_cells(b, level, &there);

        same = here == there && memcmp(p, q, (size_t)here * sizeof *p) == 0;
        for (int h = 0; h < a->D && same; h++) {
            const kw_bspline *s = a->level[level].s[h], *t = b->level[level].s[h];

            same = s->d == t->d && s->n == t->n && same_bits(s->t, t->t, s->n + s->d + 1);
        }
        free(p);
        free(q);
    }
    return same;
}

/* --- what is well --- */

static void round_trip(const twin *w)
{
    char message[KW_MESHFILE_MESSAGE];
    const char *path = path_of("round-trip");
    int failed = kw_meshfile_write(w->mesh, path);
    kw_mesh *m = kw_meshfile_read(path, message);

    CHECK(failed == 0, "%s", path);
    CHECK(m && same_mesh(m, w->mesh), "D = %d: %s", w->D, message);
    kw_mesh_free(m);
    unlink(path);
}

static void what_is_written_is_read(void)
{
    for (int D = 1; D <= D_MOST; D++)
        for (int sample = 0; sample < MESHES; sample++) {
            kw_rng r = kw_rng_at(36, (uint64_t)D, (uint64_t)sample, 0);
            kw_bspline *s[D_MOST] = {NULL};
            twin w = random_twin(&r, D, 4, 4, D == 3 ? 2 : 3);

            round_trip(&w);
            twin_free(&w);
            for (int h = 0; h < D; h++) /* knots that need all 17 digits */
                s[h] = test_random_space(&r, 4);
            w = twin_new(meshes_product(D, s), D == 1 ? 4 : 1);
            refine_at_random(&r, &w);
            round_trip(&w);
            twin_free(&w);
        }
}

/* The example of meshfile.h in the ways in which it may be typed: Omega^1 has 2 x 2 cells, Omega^2
   3 x 3 of the 4 x 4 in it. */
static void check_example(const char *text)
{
    const long long active[] = {12, 7, 36};
    kw_mesh *m = parse(text);

    if (!m)
        return;
    CHECK(m->D == 2 && m->levels == 3, "D = %d, %d levels", m->D, m->levels);
    for (int level = 0; level < 3; level++)
        CHECK(kw_mesh_active(m, level) == active[level], "level %d: %lld", level,
              kw_mesh_active(m, level));
    CHECK(m->level[0].s[1]->t[3] == 0.25 && m->level[2].s[0]->d == 2, "%g",
          m->level[0].s[1]->t[3]);
    kw_mesh_free(m);
}

static void the_example_is_read(void)
{
    check_example("degree 2 2\n"
                  "knots 0 0 0 0.25 0.5 0.75 1 1 1\n"
                  "knots 0 0 0 0.25 0.5 0.75 1 1 1\n"
                  "refine 0  0 0  2 2\n"
                  "refine 1  0 0  3 3\n");
    check_example("degree 2 2 # one a direction\r\n"
                  "knots\t0 0 0 .25 5e-1 0.75 1 1 1 # open\r\n"
                  "  knots 0 -0 +0 0.25 0x1p-1 0.75 1.0 1 1  \r\n\r\n"
                  "refine 0  0 0  2 2\r\n"
                  "refine 1  0 0  3 3\r\n");
    check_example("# levels in any order, boxes that overlap, no newline at the end\n\n\n"
                  "degree 2 2\n \t \n"
                  "knots 0 0 0 0.25 0.5 0.75 1 1 1\n#\n"
                  "knots 0 0 0 0.25 0.5 0.75 1 1 1\n"
                  "refine 1  1 0  3 3\n"
                  "refine 0  0 0  1 2#x\n"
                  "refine 1  0 0  3 3\n"
                  "refine 0  0 0  2 2\n"
                  "refine 0  1 1  2 2");
}

/* A box beyond Omega^1 is cut to it. */
static void boxes_are_cut(void)
{
    kw_mesh *m = parse(SQUARE "refine 0 1 1 3 3\nrefine 1 0 0 8 8\n");

    CHECK(kw_mesh_active(m, 2) == 64, "%lld cells", kw_mesh_active(m, 2));
    kw_mesh_free(m);
}

static void a_mesh_needs_no_refine_line(void)
{
    kw_mesh *one = parse("degree 0\nknots 0 1"), *three = parse("degree 1 0 31\n"
                                                                "knots 0 0 1 1\n"
                                                                "knots -1 0 1\n"
                                                                "knots 0 0 0 0 0 0 0 0 "
                                                                "0 0 0 0 0 0 0 0 0 0 0 0 "
                                                                "0 0 0 0 0 0 0 0 0 0 0 0 "
                                                                "1 1 1 1 1 1 1 1 1 1 1 1 "
                                                                "1 1 1 1 1 1 1 1 1 1 1 1 "
                                                                "1 1 1 1 1 1 1 1\n");

    CHECK(one->D == 1 && one->levels == 1, "%d levels", one->levels);
    CHECK(three->D == 3 && three->level[0].s[2]->d == 31, "D = %d", three->D);
    CHECK(kw_mesh_active(three, 0) == 2, "%lld cells", kw_mesh_active(three, 0));
    kw_mesh_free(one);
    kw_mesh_free(three);
}

/* --- what is not --- */

/* Files that cannot be read or written. */
static void refused_file(const char *path, const char *what)
{
    char message[KW_MESHFILE_MESSAGE] = "";
    kw_mesh *m = kw_meshfile_read(path, message);

    CHECK(!m, "%s", path);
    CHECK(strstr(message, path) && strstr(message, what), "`%s' about %s", message, path);
    kw_mesh_free(m);
}

static void no_such_file(void)
{
    refused_file(path_of("missing"), "No such file");
    refused_file(KW_BUILD, "directory");
    refused_file("", "No such file");
}

static void files_with_nothing_in_them(void)
{
    const char *path = path_of("empty");

    write_text(path, "", 0);
    refused_file(path, "no `degree` line");
    write_text(path, "# nothing\n\n", 11);
    refused_file(path, "no `degree` line");
    write_text(path, "degree 1\nknots 0 0 1 1\nrefine 0\0 0 1\n", 38);
    refused_file(path, ":3: a zero byte");
    write_text(path, SQUARE "refine 7 0 0 1 1\n", strlen(SQUARE) + 17);
    refused_file(path, ":4: level 7");
    unlink(path);
}

/* Says so on stderr and writes nothing. */
static void unwritable(void)
{
    kw_mesh *m = parse(SQUARE);
    int failed = kw_meshfile_write(m, KW_BUILD "/no/such/folder/mesh");

    kw_mesh_free(m);
    KW_NEED(!failed, "kw_meshfile_write returned %d", failed);
}

static void writing_may_fail(void)
{
    test_aborts("kw_meshfile_write returned 1", unwritable);
    test_aborts("no/such/folder/mesh", unwritable);
}

/* A long name or word does not run over the message. */
static void messages_have_an_end(void)
{
    static char name[4096], word[4096], message[KW_MESHFILE_MESSAGE + GUARD];
    kw_mesh *m;

    memset(name, 'n', sizeof name - 1);
    memset(word, 'w', sizeof word - 1);
    memset(message, 'g', sizeof message);
    m = kw_meshfile_parse(word, sizeof word - 1, name, message);
    CHECK(!m, "%s", message);
    CHECK(memchr(message, 0, KW_MESHFILE_MESSAGE), "no end");
    CHECK(strstr(message, "nnnn") && strstr(message, ":1: ") && strstr(message, "`wwww"),
          "%s", message);
    for (int i = 0; i < GUARD; i++)
        CHECK(message[KW_MESHFILE_MESSAGE + i] == 'g', "byte %d behind the end", i);
}

int main(void)
{
    test_run("meshfile: what is written is read again", what_is_written_is_read);
    test_run("meshfile: the example is read, with comments, blanks, CRLF, in any order",
             the_example_is_read);
    test_run("meshfile: boxes are cut to the domain of their level", boxes_are_cut);
    test_run("meshfile: nothing needs to be refined", a_mesh_needs_no_refine_line);
    test_run("meshfile: a missing file and a directory are refused with the reason",
             no_such_file);
    test_run("meshfile: files that are empty or no text are refused",
             files_with_nothing_in_them);
    test_run("meshfile: a file that cannot be written is reported", writing_may_fail);
    test_run("meshfile: messages end where they should", messages_have_an_end);
    return test_end();
}
