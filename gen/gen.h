/* gen.h -- the program gen: `gen FAMILY ...` makes data sets (set.h), `gen COMMAND --option VALUE
   ...` prints reference numbers, one command a file.

   A command says which options it has; gen.c reads the command line and runs it. Whatever
   goes wrong is said on stderr, with the file and the line, or with the option:
     exit 0  all is well
     exit 1  a file, a point or the standard output is bad
     exit 2  the call itself is
   A command checks all of its input before it writes the first line. */
#ifndef GEN_H
#define GEN_H

#include "mesh.h"

#define GEN_VERSION "0.1"

enum { GEN_GOOD = 0, GEN_BAD_INPUT = 1, GEN_BAD_CALL = 2 };

enum { GEN_OPTIONS = 8 }; /* a command has at most */

typedef struct gen_option {
    const char *name; /* as it is typed, "--mesh" */
    int needed;       /* may it not be left out? */
} gen_option;

typedef struct gen_command {
    const char *name;
    const char *summary;            /* a line of `gen --help` */
    const char *help;               /* all of `gen COMMAND --help` */
    gen_option option[GEN_OPTIONS]; /* those behind the last have no name */
    /* value[i] was given to option[i]; NULL if that was left out. Returns the exit status. */
    int (*run)(const char *const *value);
} gen_command;

extern const gen_command gen_count;
extern const gen_command gen_reference;

/* Says "gen: " and the message on stderr; returns status. */
int gen_say(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The mesh of a file; the caller frees. NULL after a message on stderr. */
kw_mesh *gen_mesh(const char *path);

#endif
