/* gen.c -- the command line: families that make sets, and commands. */
#include "gen.h"
#include "active.h"
#include "meshfile.h"
#include "set.h"
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const gen_command *const commands[] = {&gen_count, &gen_reference};

enum { COMMANDS = sizeof commands / sizeof *commands };

/* --- what the commands share --- */

int gen_say(int status, const char *format, ...)
{
    va_list values;

    fputs("gen: ", stderr);
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    return status;
}

kw_mesh *gen_mesh(const char *path)
{
    char message[KW_MESHFILE_MESSAGE];
    kw_mesh *m = kw_meshfile_read(path, message);

    if (!m)
        gen_say(GEN_BAD_INPUT, "%s", message);
    return m;
}

/* --- help --- */

static void print_help(void)
{
    printf("usage: gen FAMILY --count N --out DIR [--option VALUE ...]\n"
           "       gen verify DIR\n"
           "       gen COMMAND --option VALUE ...\n"
           "\n"
           "Makes data sets with known ground truth, and prints what implementations of\n"
           "hierarchical splines can be checked against.\n"
           "\n"
           "Families:\n");
    for (int i = 0; i < gen_family_count; i++)
        printf("  %-10s %s\n", gen_families[i]->name, gen_families[i]->summary);
    printf(
        "\n"
        "A sample depends on the seed and its index alone: a set is the same to the "
        "byte\n"
        "in one piece or in many, on any machine. A call that was cut off goes on where\n"
        "it was if it is given again.\n"
        "\n"
        "Commands:\n"
        "  verify     sums, counts and splits of a set\n");
    for (int i = 0; i < COMMANDS; i++)
        printf("  %-10s %s\n", commands[i]->name, commands[i]->summary);
    printf("\n"
           "  gen FAMILY --help      options, and a worked call\n"
           "  gen COMMAND --help     the same\n"
           "  gen --help             this text\n"
           "  gen --version          the version\n"
           "\n"
           "Exit status: 0, 1 for bad input or output, 2 for a bad call.\n");
}

/* --- the command line --- */

static int is_option(const gen_option *o, const char *word)
{
    return o->name && strcmp(o->name, word) == 0;
}

static int wants_help(int count, char *const *word)
{
    for (int i = 0; i < count; i++)
        if (strcmp(word[i], "--help") == 0)
            return 1;
    return 0;
}

/* Puts the value of each option into value[0..GEN_OPTIONS-1]. */
static int read_options(const gen_command *c, int count, char *const *word,
                        const char **value)
{
    for (int i = 0; i < count; i += 2) {
        int o = 0;

        while (o < GEN_OPTIONS && !is_option(&c->option[o], word[i]))
            o++;
        if (o == GEN_OPTIONS)
            return gen_say(GEN_BAD_CALL, "%s has no option `%s'; see gen %s --help",
                           c->name, word[i], c->name);
        if (value[o])
            return gen_say(GEN_BAD_CALL, "%s is given twice", word[i]);
        if (i + 1 == count || strncmp(word[i + 1], "--", 2) == 0)
            return gen_say(GEN_BAD_CALL, "%s has no value", word[i]);
        value[o] = word[i + 1];
    }
    for (int o = 0; o < GEN_OPTIONS; o++)
        if (c->option[o].needed && !value[o])
            return gen_say(GEN_BAD_CALL, "%s needs %s; see gen %s --help", c->name,
                           c->option[o].name, c->name);
    return GEN_GOOD;
}

static int run_command(const gen_command *c, int count, char *const *word)
{
    const char *value[GEN_OPTIONS] = {NULL};
    int status;

    if (wants_help(count, word)) {
        fputs(c->help, stdout);
        return GEN_GOOD;
    }
    status = read_options(c, count, word, value);
    return status == GEN_GOOD ? c->run(value) : status;
}

static int run_family(const gen_family *family, int count, char *const *word)
{
    if (!wants_help(count, word))
        return gen_make(family, count, word);
    gen_call_help(family);
    return GEN_GOOD;
}

static int run_verify(int count, char *const *word)
{
    if (!wants_help(count, word))
        return gen_verify(count, word);
    fputs(
        "usage: gen verify DIR\n\n"
        "Checks the set in DIR: are all shards there, have all files the sums they were "
        "made\n"
        "with, and are the samples in them those of their range, so that no two splits\n"
        "share one? Names every defect; the exit status is 0 if there is none. Remove "
        "what it\n"
        "names and give the call again: it is made anew.\n",
        stdout);
    return GEN_GOOD;
}

static int run(int count, char *const *word)
{
    const gen_family *family = count > 0 ? gen_family_find(word[0]) : NULL;

    if (count == 0)
        return gen_say(GEN_BAD_CALL, "no command; see gen --help");
    if (family)
        return run_family(family, count - 1, word + 1);
    if (strcmp(word[0], "verify") == 0)
        return run_verify(count - 1, word + 1);
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(word[0], commands[i]->name) == 0)
            return run_command(commands[i], count - 1, word + 1);
    if (strcmp(word[0], "--help") != 0 && strcmp(word[0], "--version") != 0)
        return gen_say(GEN_BAD_CALL, "no command `%s'; see gen --help", word[0]);
    if (count > 1)
        return gen_say(GEN_BAD_CALL, "`%s' behind %s", word[1], word[0]);
    if (strcmp(word[0], "--version") == 0)
        puts("knotwork-gen " GEN_VERSION);
    else
        print_help();
    return GEN_GOOD;
}

int main(int count, char **word)
{
    int status = run(count > 0 ? count - 1 : 0, word + 1);

    if (ferror(stdout) || fflush(stdout) != 0) /* a full disk may show only here */
        return gen_say(GEN_BAD_INPUT, "cannot write to the standard output: %s",
                       strerror(errno));
    return status;
}
