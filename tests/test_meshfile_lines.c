/* Malformed mesh files: for each one the message has the file, the line and what stands there. */
#include "meshes.h"
#include "meshfile.h"
#include <stdio.h>

#define SQUARE "degree 2 2\nknots 0 0 0 1 2 3 4 4 4\nknots 0 0 0 1 2 3 4 4 4\n"
#define LINE "degree 1\nknots 0 0 1 2 2\n"

/* A text and two pieces of the message: the place, and the offence. */
typedef struct wrong {
    const char *text, *place, *offence;
} wrong;

static void refused(int count, const wrong *list)
{
    for (int i = 0; i < count; i++) {
        char message[KW_MESHFILE_MESSAGE] = "";
        size_t size = strlen(list[i].text);
        kw_mesh *m = kw_meshfile_parse(list[i].text, size, "m.mesh", message);

        CHECK(!m, "accepted: %s", list[i].text);
        CHECK(strncmp(message, list[i].place, strlen(list[i].place)) == 0,
              "`%s' does not begin with `%s'", message, list[i].place);
        CHECK(strstr(message, list[i].offence), "`%s' has no `%s'", message,
              list[i].offence);
        kw_mesh_free(m);
    }
}

#define REFUSED(list) refused((int)(sizeof(list) / sizeof *(list)), list)

static void words(void)
{
    static const wrong list[] = {
        {"degrees 2\n", "m.mesh:1: ", "`degrees`"},
        {"\n\nDegree 2\n", "m.mesh:3: ", "`Degree`"},
        {LINE "refin 0 0 1\n", "m.mesh:3: ", "`refin`"},
        {LINE "refine0 0 1\n", "m.mesh:3: ", "`refine0`"},
        {LINE "# fine\n\r\n0 0 1\n", "m.mesh:5: ", "`0`"},
        {"\xef\xbb\xbf"
         "degree 1\n",
         "m.mesh:1: ", "degree`"},
        {"degree 1\rknots 0 0 1 1\r", "m.mesh:1: ", "`knots`"},
    };

    REFUSED(list);
}

static void degrees(void)
{
    static const wrong list[] = {
        {"degree\n", "m.mesh:1: ", "without a number"},
        {"degree # 2\n", "m.mesh:1: ", "without a number"},
        {"degree -1\n", "m.mesh:1: ", "-1"},
        {"degree 32\n", "m.mesh:1: ", "32"},
        {"degree 2 99999999999999999999\n", "m.mesh:1: ", "99999999999999999999"},
        {"degree 4294967298\n", "m.mesh:1: ", "4294967298"},
        {"degree 2.5\n", "m.mesh:1: ", "`2.5`"},
        {"degree 2x\n", "m.mesh:1: ", "`2x`"},
        {"degree two\n", "m.mesh:1: ", "`two`"},
        {"degree 1e1\n", "m.mesh:1: ", "`1e1`"},
        {"degree 0x2\n", "m.mesh:1: ", "`0x2`"},
        {"degree 2,2\n", "m.mesh:1: ", "`2,2`"},
        {"degree nan\n", "m.mesh:1: ", "`nan`"},
        {"degree 1 1 1 1\n", "m.mesh:1: ", "more than 3"},
        {"degree 2\ndegree 2\n", "m.mesh:2: ", "second `degree`"},
        {LINE "degree 2\n", "m.mesh:3: ", "not nested"},
    };

    REFUSED(list);
}

static void knots(void)
{
    static const wrong list[] = {
        {"knots 0 0 1 1\ndegree 1\n", "m.mesh:1: ", "before `degree`"},
        {"degree 1\nknots\n", "m.mesh:2: ", "0 knots"},
        {"degree 1\nknots 0 0 1\n", "m.mesh:2: ", "3 knots"},
        {"degree 2\nknots 0 0 0 1 1\n", "m.mesh:2: ", "5 knots"},
        {"degree 1\nknots 0 0 x 1\n", "m.mesh:2: ", "`x`"},
        {"degree 1\nknots 0 0 1,5 2 2\n", "m.mesh:2: ", "`1,5`"},
        {"degree 1\nknots 0 0 1.5.2 2 2\n", "m.mesh:2: ", "`1.5.2`"},
        {"degree 1\nknots 0 0 nan 1 1\n", "m.mesh:2: ", "`nan`"},
        {"degree 1\nknots 0 0 -NAN(1) 1 1\n", "m.mesh:2: ", "`-NAN(1)`"},
        {"degree 1\nknots 0 0 1 inf inf\n", "m.mesh:2: ", "`inf`"},
        {"degree 1\nknots -Infinity 0 1 1\n", "m.mesh:2: ", "`-Infinity`"},
        {"degree 1\nknots 0 0 1e999 1e999\n", "m.mesh:2: ", "`1e999`"},
        {"degree 1\nknots 0 0 2 1 3 3\n", "m.mesh:2: ", "1 after 2"},
        {"degree 1\nknots 1 1 0 0\n", "m.mesh:2: ", "0 after 1"},
        {"degree 1\nknots 0 0 1 1 1 2 2\n", "m.mesh:2: ", "knot 1 "},
        {"degree 1\nknots 0 0 0 1 1\n", "m.mesh:2: ", "knot 0 "},
        {"degree 0\nknots 0 1 1 2\n", "m.mesh:2: ", "knot 1 "},
        {"degree 2\nknots 0 1 1 1 2 3\n", "m.mesh:2: ", "empty span"},
        {"degree 2\nknots 0 1 2 2 2 3\n", "m.mesh:2: ", "empty span"},
        {"degree 1\nknots 0 0 1 1\nknots 0 0 1 1\n", "m.mesh:3: ", "more `knots`"},
        {"degree 1 1\nknots 0 0 1 1\n", "m.mesh: ", "fewer `knots`"},
        {"degree 1\n", "m.mesh: ", "fewer `knots`"},
    };

    REFUSED(list);
}

/* Finite knots whose distance is not. */
static void knots_too_far_apart(void)
{
    static const wrong list[] = {
        {"degree 0\nknots -1e308 1e308\n", "m.mesh:2: ", "e+308"},
        {"degree 1\nknots -1.5e308 -1.5e308 0 1.5e308 1.5e308\n", "m.mesh:2: ", "e+308"},
    };

    REFUSED(list);
}

static void refine_lines(void)
{
    static const wrong list[] = {
        {"refine 0 0 1\n", "m.mesh:1: ", "before `degree`"},
        {"degree 1\nrefine 0 0 1\n", "m.mesh:2: ", "before all `knots`"},
        {"degree 1 1\nknots 0 0 1 1\nrefine 0 0 0 1 1\n", "m.mesh:3: ", "before all"},
        {SQUARE "refine\n", "m.mesh:4: ", "level is missing"},
        {SQUARE "refine 0\n", "m.mesh:4: ", "low corner is missing"},
        {SQUARE "refine 0 0\n", "m.mesh:4: ", "low corner is missing"},
        {SQUARE "refine 0 0 0\n", "m.mesh:4: ", "high corner is missing"},
        {SQUARE "refine 0 0 0 1\n", "m.mesh:4: ", "high corner is missing"},
        {SQUARE "refine 0 0 0 1 # 1\n", "m.mesh:4: ", "high corner is missing"},
        {SQUARE "refine 0 0 0 1 1 1\n",
         "m.mesh:4: ", "more than a level and two corners"},
        {SQUARE "refine 0 0 0 1 1 x\n",
         "m.mesh:4: ", "more than a level and two corners"},
        {SQUARE "refine a 0 0 1 1\n", "m.mesh:4: ", "`a`"},
        {SQUARE "refine 0 0 b 1 1\n", "m.mesh:4: ", "`b`"},
        {SQUARE "refine 0 0 0 1 1.0\n", "m.mesh:4: ", "`1.0`"},
        {SQUARE "refine 0 0 0 1 nan\n", "m.mesh:4: ", "`nan`"},
    };

    REFUSED(list);
}

static void boxes(void)
{
    static const wrong list[] = {
        {SQUARE "refine 0 0 0 5 4\n", "m.mesh:4: ", "cell 4 of direction 0"},
        {SQUARE "refine 0 0 0 4 9\n", "m.mesh:4: ", "cell 8 of direction 1"},
        {SQUARE "refine 0 7 0 8 4\n", "m.mesh:4: ", "cell 7 of direction 0"},
        {SQUARE "refine 0 0 0 2147483647 4\n", "m.mesh:4: ", "cell 2147483646"},
        {SQUARE "refine 0 0 0 2147483648 4\n", "m.mesh:4: ", "2147483648"},
        {SQUARE "refine 0 0 0 99999999999999999999 4\n",
         "m.mesh:4: ", "99999999999999999999"},
        {SQUARE "refine 0 -1 0 4 4\n", "m.mesh:4: ", "-1"},
        {SQUARE "refine 0 0 0 4 -4\n", "m.mesh:4: ", "-4"},
        {SQUARE "refine 0 2 0 2 4\n", "m.mesh:4: ", "empty box"},
        {SQUARE "refine 0 3 0 2 4\n", "m.mesh:4: ", "empty box"},
        {SQUARE "refine 0 0 0 1 1\nrefine 1 0 0 9 8\n",
         "m.mesh:5: ", "cell 8 of direction 0"},
        {SQUARE "refine 1 0 0 9 8\nrefine 0 0 0 1 1\n", "m.mesh:4: ", "the 8 cells"},
    };

    REFUSED(list);
}

static void levels(void)
{
    static const wrong list[] = {
        {SQUARE "refine 1 0 0 1 1\n", "m.mesh:4: ", "level 1 skips"},
        {SQUARE "refine 0 0 0 1 1\nrefine 2 0 0 1 1\n", "m.mesh:5: ", "level 2 skips"},
        {SQUARE "refine 2 0 0 1 1\nrefine 0 0 0 1 1\n", "m.mesh:4: ", "level 2 skips"},
        /* the box of level 1 misses Omega^1, so there is no level 2 */
        {SQUARE "refine 0 0 0 1 1\nrefine 1 4 4 8 8\nrefine 2 0 0 1 1\n",
         "m.mesh:6: ", "level 2 skips"},
        {SQUARE "refine -1 0 0 1 1\n", "m.mesh:4: ", "-1"},
        {SQUARE "refine 23 0 0 1 1\n", "m.mesh:4: ", "23"},
        {SQUARE "refine 1000000000000 0 0 1 1\n", "m.mesh:4: ", "1000000000000"},
        {SQUARE "refine 0.5 0 0 1 1\n", "m.mesh:4: ", "`0.5`"},
    };

    REFUSED(list);
}

/* Between neighbouring doubles there is no middle. */
static void levels_without_room(void)
{
    static const wrong list[] = {
        {"degree 1\nknots 1 1 1.0000000000000002 1.0000000000000002\nrefine 0 0 1\n",
         "m.mesh:3: ", "1.0000000000000002"},
        {"degree 1\nknots 0 0 5e-324 1 1\nrefine 0 1 2\n", "m.mesh:3: ", "no number"},
        {"degree 1\nknots 1 1 1.0000000000000004 1.0000000000000004\n"
         "refine 0 0 1\nrefine 1 0 1\n",
         "m.mesh:4: ", "level 2"},
    };

    REFUSED(list);
}

/* Every byte of a good file left out, or made another one: a mesh or a message, never an
   abort. The bytes are those that tell words, lines and numbers apart. */
static void every_byte_may_be_wrong(void)
{
    static const char good[] = "degree 1 0\nknots 0 0 .5 1 1\nknots 0 1 2\n"
                               "refine 0 0 0 1 2\nrefine 1 0 1 2 3 # end\n";
    static const char bytes[] = {0,   ' ', '\n', '\r', '#', '-',
                                 '.', '0', '1',  '9',  'e', 'x'};
    char text[sizeof good], message[KW_MESHFILE_MESSAGE];

    for (size_t at = 0; at < sizeof good - 1; at++) {
        kw_mesh *m = kw_meshfile_parse(good, at, "m.mesh", message);

        CHECK(!m == (message[0] != 0), "cut at %zu: `%s'", at, message);
        kw_mesh_free(m);
        for (size_t b = 0; b < sizeof bytes; b++) {
            memcpy(text, good, sizeof good);
            text[at] = bytes[b];
            m = kw_meshfile_parse(text, sizeof good - 1, "m.mesh", message);
            CHECK(!m == (message[0] != 0), "byte %zu: `%s'", at, message);
            kw_mesh_free(m);
        }
    }
}

int main(void)
{
    test_run("meshfile: an unknown word is refused", words);
    test_run("meshfile: a degree is one whole number 0 .. 31 a direction", degrees);
    test_run("meshfile: knots are finite, ascending, not too many, not too few", knots);
    test_run("meshfile: knots that are too far apart are refused", knots_too_far_apart);
    test_run("meshfile: a refine line has a level and two corners", refine_lines);
    test_run("meshfile: boxes are not empty and lie in the grid of their level", boxes);
    test_run("meshfile: no level is skipped, and none too deep", levels);
    test_run("meshfile: a level whose knots have no middle is refused",
             levels_without_room);
    test_run("meshfile: with any byte wrong there is a mesh or a message",
             every_byte_may_be_wrong);
    return test_end();
}
