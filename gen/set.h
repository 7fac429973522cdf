/* set.h -- data sets: what a family is, and what becomes of its samples.

   A family makes samples. Sample i of a seed is a pure function of (seed, i, parameters): its
   random numbers are those of kw_rng_at(seed, stream of the family, i, field), and nothing else
   enters. So any part of a set can be made anywhere, in any order.

   A sample has arrays: rows of columns, of doubles or of integers. An array either has the same
   number of rows in every sample, or it is ragged; then the array `counts`, the first of a family
   that has a ragged one, has a column of the same name, with its rows in that sample. The plan
   of a call (gen_plan) lists the arrays.

   A set is what one call describes: the samples first .. first+count-1, in up to three splits,
   which are ranges of the index one behind the other: train, validation, test. Each split is cut
   into the same number of shards. On the disk:

     DIR/points/train-00003-of-00010.npy     array `points`, split train, shard 3 of 10
     DIR/points/train-00003-of-00010.csv     the same as CSV: sample, row, then the columns
     DIR/xml/train-0000000000000000042.xml   a file of its own for sample 42
     DIR/shards/00003-of-00010.done          the call, bytes and sums of all files of a shard
     DIR/datapackage.json  DATASHEET.md  SHA256SUMS    once all shards are there

   NPY: an array of equal rows has the shape (samples, rows, columns), a ragged one (rows of all
   samples, columns). Either way shards are joined by concatenation along the first axis, and so
   are CSV files, all but the first without their header.

   Every file appears whole (lib/out). A shard is complete when its .done file is there, which is
   written last; then it is left alone, else it is made again. A process that makes a shard holds
   a lock on DIR/shards/K-of-S.begun, which goes away with the process, however it ends; one that
   writes the three files beside them, on S-of-S.begun. All these begin with the call, so a
   folder never mixes two sets.

   One concept a file:
     call.c    the command line of a family, and its text that names the set
     plan.c    arrays, samples, ranges of shards, paths
     table.c   rows of one array into a CSV or NPY file
     shard.c   one shard: all its files, then their sums
     folder.c  beginning a folder, locks, what is complete
     about.c   datapackage.json, DATASHEET.md, SHA256SUMS
     make.c    all shards of a call, by several processes
     verify.c  gen verify
   and a file for each family, gen_<family>.c. */
#ifndef GEN_SET_H
#define GEN_SET_H

#include "rng.h"
#include <stddef.h>
#include <stdint.h>

enum {
    GEN_ARRAYS = 8,      /* of a family, at most */
    GEN_PARAMETERS = 12, /* the same */
    GEN_FORMATS = 6,     /* the same, with csv and npy */
    GEN_JOBS = 1024,     /* of a call, at most */
    GEN_NAME = 32,       /* characters of a name, with the 0 */
    GEN_TEXT = 1024,     /* of the text of a call, of the columns of an array */
    GEN_PATH = 4096
};

/* --- parameters of a family --- */

typedef enum gen_kind {
    GEN_WHOLE, /* an integer */
    GEN_REAL,
    GEN_RANGE, /* integers "4-8", or "6", which is "6-6" */
    GEN_WORD   /* one of some words */
} gen_kind;

typedef struct gen_parameter {
    const char *name; /* as it is typed, "--degree" */
    gen_kind kind;
    const char *standard; /* the value if it is left out */
    double least, most;   /* of a number, both ends included */
    const char *words;    /* of a word: all that may stand there, "uniform normal" */
    const char *about;    /* a line of help */
} gen_parameter;

/* --- calls --- */

typedef enum gen_split { GEN_TRAIN, GEN_VALIDATION, GEN_TEST, GEN_SPLITS } gen_split;
extern const char *const gen_split_name[GEN_SPLITS];

typedef struct gen_family gen_family;

typedef struct gen_call {
    const gen_family *family;
    uint64_t seed, first, count; /* first + count <= 2^63 */
    uint64_t part[GEN_SPLITS];   /* samples of each split; their sum is count */
    int format[GEN_FORMATS]; /* is it wanted? 0 is csv, 1 npy, then those of the family */
    int shards;
    int shard; /* the only one to be made, or -1 */
    int jobs;
    char out[GEN_PATH / 2];
    double
        low[GEN_PARAMETERS]; /* the value; the number of a word; the low end of a range */
    double high[GEN_PARAMETERS]; /* the high end of a range, else the same */
    char text
        [GEN_TEXT]; /* the call that makes the set, but for --out: all options that a byte
                            of it depends on, each with its value, always in the same order */
} gen_call;

enum { GEN_CSV = 0, GEN_NPY = 1, GEN_OWN_FORMAT = 2 };

/* Reads the words behind the name of the family. An exit status, after a message if it is not 0. */
int gen_call_read(gen_call *c, const gen_family *family, int count, char *const *word);

/* The same from the text of a call, as it stands in a file; `path` is for the message. */
int gen_call_read_text(gen_call *c, const char *text, const char *path);

/* Writes c->text, from all that was read. */
void gen_call_write_text(gen_call *c);

/* The help of a family. */
void gen_call_help(const gen_family *family);

/* Has parameter p the value that it has when it is left out? */
int gen_is_standard(const gen_call *c, int p);

/* Parameter p as an integer. */
int gen_whole(const gen_call *c, int p);

/* An integer, uniform in the range of parameter p. */
int gen_draw(const gen_call *c, int p, kw_rng *r);

/* --- plans and samples --- */

typedef struct gen_array {
    char name[GEN_NAME];
    const char *about;
    int integer; /* integers in all columns, else doubles */
    int rows;    /* in every sample; 0 if the array is ragged */
    int columns;
    char column[GEN_TEXT]; /* their names, separated by blanks */
} gen_array;

typedef struct gen_plan {
    int arrays;
    gen_array array[GEN_ARRAYS];
} gen_plan;

/* Adds an array of doubles; returns its number, counted from 0. `columns` has the names,
   separated by blanks. rows = 0 makes it ragged. */
int gen_plan_add(gen_plan *p, const char *name, int rows, const char *columns,
                 const char *about);

/* The same for integers. */
int gen_plan_add_integers(gen_plan *p, const char *name, int rows, const char *columns,
                          const char *about);

/* The names letter1 letter2 .. of `count` columns, and behind them `rest`: text[0..GEN_TEXT-1]. */
void gen_plan_numbered(const char *letter, int count, const char *rest, char *text);

typedef struct gen_sample {
    const gen_plan *plan;
    uint64_t index;
    int rows[GEN_ARRAYS];
    double *value
        [GEN_ARRAYS]; /* rows x columns; owned. Integers are doubles here, below 2^53 */
    size_t room[GEN_ARRAYS];
} gen_sample;

/* Room for `rows` rows of an array, which the family fills: rows x columns numbers. */
double *gen_rows(gen_sample *s, int array, int rows);

void gen_sample_free(gen_sample *s); /* what it owns */

/* --- families --- */

struct gen_family {
    const char *name;
    const char *summary; /* a line of `gen --help` */
    const char
        *about; /* what a sample is: the first part of the help, and the datasheet */
    const char
        *example; /* options of the worked call of the help, behind --count and --out */
    const char *
        recipes; /* the end of the help: calls of the literature; NULL if there are none */
    uint64_t stream; /* half of the key of its random numbers; no two have the same */
    gen_parameter parameter[GEN_PARAMETERS]; /* those behind the last have no name */
    const char
        *format[GEN_FORMATS - GEN_OWN_FORMAT]; /* files of their own for each sample */
    /* Do the parameters fit together? An exit status, after a message. NULL: they always do. */
    int (*check)(const gen_call *c);
    void (*plan)(const gen_call *c, gen_plan *p);
    /* What `make` works with, made once; NULL if there is nothing. */
    void *(*work_new)(const gen_call *c);
    void (*work_free)(void *work);
    /* Fills all arrays of the sample s->index. */
    void (*make)(const gen_call *c, void *work, gen_sample *s);
    /* Writes one file of the sample in a format of the family, 0 is the first. 0, or 1 after a
       message on stderr. */
    int (*write)(const gen_call *c, const gen_sample *s, int format, const char *path);
};

extern const gen_family *const gen_families[];
extern const int gen_family_count;

/* The family of that name, or NULL. */
const gen_family *gen_family_find(const char *name);

/* The random numbers of one purpose, `field`, for sample s. */
kw_rng gen_rng(const gen_call *c, const gen_sample *s, uint64_t field);

/* --- places --- */

/* The name of a format of the call: "csv", "npy", "xml". */
const char *gen_format_name(const gen_call *c, int format);

/* The samples begin .. end-1 of one shard of a split. */
void gen_range(const gen_call *c, gen_split split, int shard, uint64_t *begin,
               uint64_t *end);

/* Paths relative to the folder of the set, path[0 .. GEN_PATH-1]: a table, the file of one
   sample, the stamp of a shard ("begun", "done"). */
void gen_path_table(const gen_call *c, const gen_array *a, gen_split split, int shard,
                    int format, char *path);
void gen_path_sample(const gen_call *c, gen_split split, int format, uint64_t index,
                     char *path);
void gen_path_stamp(const gen_call *c, int shard, const char *state, char *path);

/* The folder of the set and a relative path, joined. */
void gen_path_join(const gen_call *c, const char *relative, char *path);

/* Calls visit(with, relative path) for each file of a shard, always in the same order, until one
   returns a number other than 0, which it returns. */
int gen_each_file(const gen_call *c, const gen_plan *p, int shard,
                  int (*visit)(void *with, const char *relative), void *with);

/* --- tables (table.c) --- */

typedef struct gen_table gen_table;

/* A table at `path` (not relative). Never NULL. */
gen_table *gen_table_new(const gen_array *a, int format, const char *path);

/* Appends the rows of one sample; the first is sample 0 of the table. 1 if writing has failed. */
int gen_table_add(gen_table *t, uint64_t index, int rows, const double *value);

/* Has writing failed? */
int gen_table_failed(const gen_table *t);

/* Completes the file and frees t. 0, or 1 after a message. */
int gen_table_close(gen_table *t);

/* Gives the file up, and frees t. */
void gen_table_drop(gen_table *t);

/* --- progress (make.c) --- */

typedef struct gen_progress {
    uint64_t done, total; /* samples of this process */
    int shown;   /* is standard error a terminal, and this the process that shows it? */
    int written; /* has a line been written? */
    long last;   /* the second of that, at first of the beginning */
    long parent; /* the process that a worker ends with; 0 if there is none */
} gen_progress;

/* One sample more. On a terminal a line a second, from the second second on, in place of the one
   before; a worker ends if its parent has. */
void gen_progress_step(gen_progress *g);

/* --- shards and folders --- */

/* Makes a shard, unless it is complete. An exit status, after a message if it is not 0. */
int gen_shard_make(const gen_call *c, const gen_plan *p, int shard, gen_progress *g);

/* Begins the folder of the set, or finds that it is of this call. An exit status, after a
   message. */
int gen_folder_begin(const gen_call *c, const gen_plan *p);

/* Locks a shard for this process and writes the call into its stamp; shard c->shards stands for the
   files beside the set. Returns what gen_folder_unlock needs, or -1 after a message. Unlocking a
   shard that is done removes the stamp. */
int gen_folder_lock(const gen_call *c, int shard);
void gen_folder_unlock(const gen_call *c, int shard, int lock, int done);

/* Is there a stamp of a shard that somebody has begun, and perhaps not lived to finish? */
int gen_folder_begun(const gen_call *c, int shard);

/* Is the shard complete: its .done file there, of this call, and all files it names, with as
   many bytes as it says? */
int gen_folder_complete(const gen_call *c, int shard);

/* The call of the set in a folder, the first that its stamps name: text[0..GEN_TEXT-1]. 0 if
   there is none. */
int gen_folder_call(const char *folder, char *text);

/* Calls visit(with, sum, relative path) for each file that a .done file names, until one returns
   a number other than 0, which it returns; -1 if there is no such file of this call.
   *bytes is what the files have together, as it says (NULL if nobody asks). */
int gen_folder_each(const gen_call *c, int shard,
                    int (*visit)(void *with, const char *sum, const char *relative),
                    void *with, uint64_t *bytes);

/* --- what lies beside a set (about.c) --- */

/* Writes DATASHEET.md, datapackage.json and SHA256SUMS. An exit status, after a message. */
int gen_about(const gen_call *c, const gen_plan *p);

/* --- commands --- */

/* Makes a set: the words behind the name of the family. */
int gen_make(const gen_family *family, int count, char *const *word);

/* gen verify DIR. */
int gen_verify(int count, char *const *word);

#endif
