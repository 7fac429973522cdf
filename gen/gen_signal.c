/* gen signal -- small images and sequences with bars, edges and shifts, for convolutions. */
#include "draw.h"
#include "gen.h"
#include "set.h"
#include <string.h>

/* In the order of the parameters and of the arrays. */
enum { KIND, HEIGHT, WIDTH, NOISE };
enum { LABELS, CLEAN, NOISY };
enum { BARS, EDGES, SHIFTS };

/* Purposes of random numbers. */
enum { WHICH, WHICH_NOISE };

static int check(const gen_call *c)
{
    if (gen_whole(c, KIND) == SHIFTS && gen_whole(c, WIDTH) < 8)
        return gen_say(GEN_BAD_CALL,
                       "--width %d and --kind shifts: the pattern has 5 columns, "
                       "a width of 8 is needed",
                       gen_whole(c, WIDTH));
    return GEN_GOOD;
}

static void plan(const gen_call *c, gen_plan *p)
{
    char columns[GEN_TEXT];

    gen_plan_numbered("p", gen_whole(c, WIDTH), "", columns);
    gen_plan_add_integers(
        p, "labels", 1, "class y x",
        "the class, and the place of the bar, edge or pattern: line y, column x");
    gen_plan_add(p, "clean", gen_whole(c, HEIGHT), columns,
                 "the image, a row a line, 0 to 1");
    gen_plan_add(p, "noisy", gen_whole(c, HEIGHT), columns, "the same with noise");
}

/* A level or an upright line: class 0 or 1. */
static void bar(int height, int width, kw_rng *r, double *label, double *x)
{
    const int upright = kw_rng_below(r, 2) == 1;
    const int at = kw_rng_below(r, upright ? width : height);

    label[0] = upright;
    label[1] = upright ? 0 : at;
    label[2] = upright ? at : 0;
    for (int i = 0; i < (upright ? height : width); i++)
        x[upright ? i * width + at : at * width + i] = 1;
}

/* Light behind a line: below it, above it, to the right or to the left of it, classes 0 to 3.
   Row or column `at` is the first behind the line. */
static void edge(int height, int width, kw_rng *r, double *label, double *x)
{
    const int class = height > 1 ? kw_rng_below(r, 4) : 2 + kw_rng_below(r, 2);
    const int upright = class >= 2, size = upright ? width : height;
    const int at = size > 1 ? 1 + kw_rng_below(r, size - 1) : 0;

    label[0] = class;
    label[1] = upright ? 0 : at;
    label[2] = upright ? at : 0;
    for (int i = 0; i < height; i++)
        for (int j = 0; j < width; j++)
            x[i * width + j] = ((upright ? j : i) >= at) == (class % 2 == 0);
}

/* The same pattern at a random place: rising (class 0) or falling (class 1), and zero around
   it. On an image it stands in one row. */
static void shift(int height, int width, kw_rng *r, double *label, double *x)
{
    enum { LENGTH = 5 };
    const int class = kw_rng_below(r, 2), row = kw_rng_below(r, height);
    const int column = kw_rng_below(r, width - LENGTH + 1);

    label[0] = class;
    label[1] = row;
    label[2] = column;
    for (int i = 0; i < LENGTH; i++)
        x[row * width + column + i] = (class == 0 ? i + 1 : LENGTH - i) / (double)LENGTH;
}

static void make(const gen_call *c, void *work, gen_sample *s)
{
    static void (*const draw[])(int, int, kw_rng *, double *, double *) = {bar, edge,
                                                                           shift};
    const int height = gen_whole(c, HEIGHT), width = gen_whole(c, WIDTH);
    double *clean = gen_rows(s, CLEAN, height), *noisy = gen_rows(s, NOISY, height);
    kw_rng r = gen_rng(c, s, WHICH), noise = gen_rng(c, s, WHICH_NOISE);

    (void)work;
    memset(clean, 0, (size_t)(height * width) * sizeof *clean);
    draw[gen_whole(c, KIND)](height, width, &r, gen_rows(s, LABELS, 1), clean);
    gen_draw_noise(&noise, c->low[NOISE], height * width, clean, noisy);
}

const gen_family gen_signal = {
    .name = "signal",
    .summary = "small images and sequences with bars, edges and shifted patterns",
    .about = "A sample is an image (a sequence is one of height 1), exact and with "
             "normal noise, with\n"
             "its class and the place of what is in it:\n"
             "\n"
             "    bars    a level (0) or an upright (1) line of ones\n"
             "    edges   ones below (0), above (1), right (2) or left (3) of a line; "
             "the row or column\n"
             "            in the label is the first behind the line\n"
             "    shifts  five pixels that rise (0) or fall (1), from 1/5 to 1, anywhere "
             "in a row\n",
    .example = "--kind edges --height 6 --width 6",
    .stream = 4,
    .parameter =
        {
            [KIND] = {"--kind", GEN_WORD, "bars", 0, 0, "bars edges shifts",
                      "what is in it"},
            [HEIGHT] = {"--height", GEN_WHOLE, "8", 1, 128, NULL, "rows"},
            [WIDTH] = {"--width", GEN_WHOLE, "8", 2, 128, NULL, "columns"},
            [NOISE] = {"--noise", GEN_REAL, "0.1", 0, 1000, NULL,
                       "standard deviation of the noise"},
        },
    .check = check,
    .plan = plan,
    .make = make,
};
