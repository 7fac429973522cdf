/* The lines of a mesh file, before there is a mesh: what is kept of them. Complaints are tested with
   those of the file (test_meshfile*.c). */
#include "meshtext.h"
#include "test.h"
#include <string.h>

static const char name[] = "lines";

/* Boxes are kept as they stand, with their lines, even if there is no such cell. */
static void lines_are_kept(void)
{
    static const char text[] = "# a comment\n"
                               "degree 1 0\n"
                               "knots 0 0 1 1\n"
                               "\tknots 0 0.5 2 # three\r\n"
                               "\n"
                               "refine 7  1 2  3 4\n"
                               "refine 0  0 0  9 9";
    static const int want[2][5] = {{7, 1, 2, 3, 4}, {0, 0, 0, 9, 9}};
    char message[KW_MESHFILE_MESSAGE] = "";
    kw_meshtext t = {.name = name, .message = message};

    CHECK(kw_meshtext_read(&t, text, strlen(text)) == 0, "%s", message);
    CHECK(t.D == 2 && t.directions == 2, "%d, %d directions", t.D, t.directions);
    CHECK(t.s[0]->d == 1 && t.s[0]->n == 2, "degree %d, n = %d", t.s[0]->d, t.s[0]->n);
    CHECK(t.s[1]->d == 0 && t.s[1]->n == 2, "degree %d, n = %d", t.s[1]->d, t.s[1]->n);
    CHECK(t.s[1]->t[1] == 0.5 && t.s[1]->t[2] == 2, "%g, %g", t.s[1]->t[1], t.s[1]->t[2]);
    CHECK(t.boxes == 2 && t.box_line[0] == 6 && t.box_line[1] == 7, "%zu boxes", t.boxes);
    for (size_t i = 0; i < 2; i++)
        CHECK(memcmp(t.box[i], want[i], sizeof want[i]) == 0, "box %zu", i);
    kw_meshtext_clear(&t);
}

static void complaint(const char *text, const char *want)
{
    char message[KW_MESHFILE_MESSAGE] = "";
    kw_meshtext t = {.name = name, .message = message};

    CHECK(kw_meshtext_read(&t, text, strlen(text)) == 1, "`%s` is read", text);
    CHECK(strcmp(message, want) == 0, "%s, not %s", message, want);
    kw_meshtext_clear(&t);
}

/* With the line, or, on the file as a whole, without one. */
static void complaints_say_where(void)
{
    complaint("degree 1\nknots 0 0 x", "lines:2: knot `x` is no finite number");
    complaint("", "lines: no `degree` line");
    complaint("degree 1 1\nknots 0 0 1 1\n", "lines: fewer `knots` lines than degrees");
}

int main(void)
{
    test_run("meshtext: lines are kept as they stand", lines_are_kept);
    test_run("meshtext: complaints say where", complaints_say_where);
    return test_end();
}
