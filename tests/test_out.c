#include "out.h"
#include "need.h"
#include "test.h"
#include <dirent.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TEXT = 4096 };
static char folder[500]; /* a temporary one, where all tests write */

/* --- files of the folder --- */

/* The path of a file of the folder; good until the call after the next. */
static const char *path_of(const char *name)
{
    static char path[2][sizeof folder + 300]; /* a name has at most 255 */
    static int turn;

    turn = !turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

static int is_there(const char *name)
{
    struct stat status;

    return lstat(path_of(name), &status) == 0;
}

/* Reads a file into text[0..TEXT-1], which a 0 ends; its length, or -1. */
static int read_file(const char *name, char *text)
{
    FILE *f = fopen(path_of(name), "rb");
    size_t length;

    text[0] = 0;
    if (!f)
        return -1;
    length = fread(text, 1, TEXT - 1, f);
    text[length] = 0;
    fclose(f);
    return (int)length;
}

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(path_of(name), "wb");

    KW_NEED(f && fputs(text, f) >= 0 && fclose(f) == 0, "cannot write %s", name);
}

static void empty_folder(void)
{
    DIR *all = opendir(folder);

    KW_NEED(all, "cannot read %s", folder);
    for (const struct dirent *entry; (entry = readdir(all));)
        if (entry->d_name[0] != '.')
            remove(path_of(entry->d_name));
    closedir(all);
}

/* --- what is said on stderr --- */

/* From here on what is said on stderr goes to a file; returns the old stderr. */
static int listen_to_stderr(void)
{
    int before = dup(STDERR_FILENO);
    FILE *words = fopen(path_of("words"), "wb");

    KW_NEED(before >= 0 && words, "cannot listen in %s", folder);
    dup2(fileno(words), STDERR_FILENO);
    fclose(words);
    return before;
}

/* Until here; message[0..TEXT-1] is what was said. */
static void stop_listening(int before, char *message)
{
    dup2(before, STDERR_FILENO);
    close(before);
    read_file("words", message);
    remove(path_of("words"));
}

static int close_and_listen(kw_out *f, char *message)
{
    int before = listen_to_stderr(), result = kw_out_close(f);

    stop_listening(before, message);
    return result;
}

/* Closing f fails with a message that names `name` and `reason`. */
static void check_fails(kw_out *f, const char *name, const char *reason)
{
    char message[TEXT];
    int result = close_and_listen(f, message);

    CHECK(result == 1, "%s: %d", name, result);
    CHECK(strstr(message, path_of(name)), "%s", message);
    CHECK(strstr(message, reason), "%s", message);
    CHECK(strchr(message, '\n') == message + strlen(message) - 1, "%s", message);
}

/* --- whole or not there --- */

static void a_file_appears_whole(void)
{
    char text[TEXT];
    kw_out *f = kw_out_new(path_of("good"));

    kw_out_text(f, "%d %s\n", 12, "monkeys");
    CHECK(!is_there("good"), "before its end");
    CHECK(is_there("good.tmp"), "no temporary");
    CHECK(close_and_listen(f, text) == 0, "%s", text);
    CHECK(text[0] == 0, "%s", text);
    CHECK(!is_there("good.tmp"), "the temporary is left");
    read_file("good", text);
    CHECK(strcmp(text, "12 monkeys\n") == 0, "%s", text);
}

static void an_older_file_is_replaced_at_the_end(void)
{
    char text[TEXT];
    kw_out *f;

    write_file("older", "old\n");
    f = kw_out_new(path_of("older"));
    kw_out_text(f, "new\n");
    read_file("older", text);
    CHECK(strcmp(text, "old\n") == 0, "%s", text);
    CHECK(kw_out_close(f) == 0, "older");
    read_file("older", text);
    CHECK(strcmp(text, "new\n") == 0, "%s", text);
}

static void a_missing_folder_is_said(void)
{
    kw_out *f = kw_out_new(path_of("none/file"));

    kw_out_text(f, "words that go nowhere\n");
    kw_out_section(f, "s", "x");
    kw_out_number(f, 1);
    kw_out_row(f);
    check_fails(f, "none/file", "No such file or directory");
    CHECK(!is_there("none"), "the folder was made");
}

static void a_folder_in_the_way_is_said(void)
{
    kw_out *f;

    KW_NEED(mkdir(path_of("taken"), 0700) == 0, "cannot make %s", path_of("taken"));
    f = kw_out_new(path_of("taken"));
    kw_out_text(f, "words\n");
    check_fails(f, "taken", "directory");
    CHECK(is_there("taken") && !is_there("taken.tmp"), "folder %d", is_there("taken"));
    rmdir(path_of("taken"));
}

/* `lines` lines to a full disk: few are noticed when they are flushed at the end, many
   on the way */
static void fill_disk(int lines)
{
    char text[TEXT];
    kw_out *f;

    write_file("full", "old\n");
    KW_NEED(symlink("/dev/full", path_of("full.tmp")) == 0, "no link in %s", folder);
    f = kw_out_new(path_of("full"));
    for (int i = 0; i < lines; i++)
        kw_out_text(f, "%80d\n", i);
    check_fails(f, "full", "No space left on device");
    CHECK(!is_there("full.tmp"), "the temporary is left");
    read_file("full", text);
    CHECK(strcmp(text, "old\n") == 0, "%s", text);
}

static void a_full_disk_is_said(void)
{
    if (access("/dev/full", W_OK) != 0) {
        printf("# skipped: there is no /dev/full here\n");
        return;
    }
    fill_disk(1);
    fill_disk(10000);
}

static void a_beginning_may_come_last(void)
{
    char text[TEXT];
    kw_out *f = kw_out_new(path_of("late"));

    kw_out_text(f, "???? words");
    kw_out_begin_with(f, "four", 4);
    kw_out_bytes(f, " and\0more\n", 10);
    CHECK(!kw_out_failed(f), "late");
    CHECK(kw_out_close(f) == 0, "late");
    CHECK(read_file("late", text) == 20, "%s", text);
    CHECK(memcmp(text, "four words and\0more\n", 20) == 0, "%s", text);
}

static void a_file_may_be_given_up(void)
{
    char text[TEXT];
    kw_out *f;

    write_file("kept", "old\n");
    f = kw_out_new(path_of("kept"));
    kw_out_text(f, "new\n");
    kw_out_drop(f);
    CHECK(!is_there("kept.tmp"), "the temporary is left");
    read_file("kept", text);
    CHECK(strcmp(text, "old\n") == 0, "%s", text);

    f = kw_out_new(path_of("none/file"));
    CHECK(kw_out_failed(f), "none/file");
    kw_out_begin_with(f, "words", 5);
    kw_out_drop(f);
    CHECK(!is_there("none"), "the folder was made");
}

/* --- arrays --- */

/* The preamble and header of one block of 128 bytes, the dictionary being `words`. */
static void check_npy(const char *name, const char *words, const unsigned char *data,
                      int bytes)
{
    char text[TEXT], header[119];
    int length = read_file(name, text);

    snprintf(header, sizeof header, "%-117s\n", words);
    CHECK(length == 128 + bytes, "%d bytes", length);
    CHECK(memcmp(text, "\x93NUMPY\x01\x00\x76\x00", 10) == 0, "preamble of %s", name);
    CHECK(memcmp(text + 10, header, 118) == 0, "%.118s", text + 10);
    CHECK(memcmp(text + 128, data, (size_t)bytes) == 0, "data of %s", name);
}

static void npy_files_are_exact_to_the_byte(void)
{
    const double a[] = {1, -2, 0.5, 0.1, 0, 1e300};
    const unsigned char bytes[] = {
        0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0,    0,    0,    0,    0,    0,    0,    0xc0,
        0, 0, 0, 0, 0, 0, 0xe0, 0x3f, 0x9a, 0x99, 0x99, 0x99, 0x99, 0x99, 0xb9, 0x3f,
        0, 0, 0, 0, 0, 0, 0,    0,    0x9c, 0x75, 0x00, 0x88, 0x3c, 0xe4, 0x37, 0x7e};
    const size_t table[] = {3, 2}, line[] = {3};

    CHECK(kw_out_npy(path_of("table.npy"), 2, table, a) == 0, "table");
    check_npy("table.npy", "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }",
              bytes, 48);
    CHECK(kw_out_npy(path_of("line.npy"), 1, line, a) == 0, "line");
    check_npy("line.npy", "{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }",
              bytes, 24);
}

static void npy_data_begin_at_a_multiple_of_64(void)
{
    const size_t large = SIZE_MAX;
    size_t shape[4];

    /* an empty array: the header alone; the digits run over the end of a block */
    for (int dimensions = 1; dimensions <= 4; dimensions++)
        for (size_t size = 1; size < large / 10; size *= 10) {
            char text[TEXT] = {0};
            int length;

            for (int i = 0; i < dimensions; i++)
                shape[i] = i == 0 ? 0 : size;
            CHECK(kw_out_npy(path_of("empty.npy"), dimensions, shape, NULL) == 0,
                  "empty");
            length = read_file("empty.npy", text);
            CHECK(length % 64 == 0 && text[length - 1] == '\n', "%d bytes", length);
            CHECK((unsigned char)text[8] + 256 * (unsigned char)text[9] + 10 == length,
                  "%d bytes", length);
        }
}

static void npy_of_no_dimension(void)
{
    const size_t shape[] = {1};
    const double a[] = {1};

    kw_out_npy(path_of("npy"), 0, shape, a);
}

static void npy_of_five_dimensions(void)
{
    const size_t shape[] = {1, 1, 1, 1, 1};
    const double a[] = {1};

    kw_out_npy(path_of("npy"), 5, shape, a);
}

static void npy_needs_1_to_4_dimensions(void)
{
    test_aborts("0 dimensions", npy_of_no_dimension);
    test_aborts("5 dimensions", npy_of_five_dimensions);
}

/* Equal, and zeros of the same sign. */
static int same_bits(double a, double b)
{
    return a == b && signbit(a) == signbit(b);
}

static void csv_gives_back_the_same_doubles(void)
{
    enum { ROWS = 30, COLUMNS = 3 };
    double a[ROWS * COLUMNS] = {0.1, -0.0, DBL_MAX, DBL_MIN, DBL_TRUE_MIN, 1.0 / 3, 1e22};
    char text[TEXT], *next;
    kw_rng r = kw_rng_at(41, 0, 0, 0);

    for (int i = 7; i < ROWS * COLUMNS; i++)
        a[i] = ldexp(kw_rng_uniform(&r) - 0.5, kw_rng_below(&r, 600) - 300);
    CHECK(kw_out_csv(path_of("a.csv"), "x,y,z", ROWS, COLUMNS, a) == 0, "a.csv");
    CHECK(read_file("a.csv", text) < TEXT - 1, "longer than %d", TEXT);
    CHECK(strncmp(text, "x,y,z\n0.10000000000000001,-0,", 29) == 0, "%.29s", text);
    next = text + strcspn(text, "\n");
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        char before = *next++, wanted = i % COLUMNS == 0 ? '\n' : ',';
        double value = strtod(next, &next);

        CHECK(before == wanted, "`%c' before number %d", before, i);
        CHECK(same_bits(value, a[i]), "%.17g, not %.17g", value, a[i]);
    }
    CHECK(strcmp(next, "\n") == 0, "`%s' at the end", next);
}

/* Arrays are for readers that know NaN and infinity: they go through as they are. */
static void arrays_take_any_double(void)
{
    enum { COUNT = 3, DATA = 128 };
    const double a[COUNT] = {NAN, INFINITY, -INFINITY};
    const size_t shape[] = {COUNT};
    char text[TEXT], *next;
    double back[COUNT];

    CHECK(kw_out_csv(path_of("a.csv"), "x,y,z", 1, COUNT, a) == 0, "a.csv");
    read_file("a.csv", text);
    next = text + strcspn(text, "\n") + 1;
    for (int i = 0; i < COUNT; i++, next++) {
        double value = strtod(next, &next);

        CHECK(isnan(a[i]) ? isnan(value) : value == a[i], "number %d: %g", i, value);
    }
    CHECK(kw_out_npy(path_of("a.npy"), 1, shape, a) == 0, "a.npy");
    CHECK(read_file("a.npy", text) == DATA + sizeof a, "a.npy");
    memcpy(back, text + DATA, sizeof back); /* on a little-endian machine */
    CHECK(isnan(back[0]) && back[1] == a[1] && back[2] == a[2], "%g, %g, %g", back[0],
          back[1], back[2]);
}

static void arrays_fail_as_files_do(void)
{
    const size_t shape[] = {1};
    const double a[] = {1};
    char message[TEXT];
    int before = listen_to_stderr();
    int csv = kw_out_csv(path_of("none/a.csv"), "x", 1, 1, a);
    int npy = kw_out_npy(path_of("none/a.npy"), 1, shape, a);

    stop_listening(before, message);
    CHECK(csv == 1 && npy == 1, "%d and %d", csv, npy);
    CHECK(strstr(message, path_of("none/a.csv")), "%s", message);
    CHECK(strstr(message, path_of("none/a.npy")), "%s", message);
}

/* --- columns --- */

static void columns_have_their_format(void)
{
    static const char expected[] = "# one\n# x y\n1 -0.5\n0.10000000000000001 0\n\n2 3\n"
                                   "\n\n# two\n# z\n7\n";
    const double one[] = {1, -0.5, 0.1, 0, 2, 3};
    char text[TEXT];
    kw_out *f = kw_out_new(path_of("columns"));

    kw_out_section(f, "one", "x y");
    for (int i = 0; i < 6; i++) {
        kw_out_number(f, one[i]);
        if (i % 2 == 1)
            kw_out_row(f);
        if (i == 3)
            kw_out_gap(f);
    }
    kw_out_section(f, "two", "z");
    kw_out_number(f, 7);
    kw_out_row(f);
    CHECK(kw_out_close(f) == 0, "columns");
    read_file("columns", text);
    CHECK(strcmp(text, expected) == 0, "%s", text);
}

/* A file with a row of two columns that holds one number. */
static kw_out *half_a_row(void)
{
    kw_out *f = kw_out_new(path_of("broken"));

    kw_out_section(f, "s", "x y");
    kw_out_number(f, 1);
    return f;
}

static void write_nan(void)
{
    kw_out_number(half_a_row(), NAN);
}

static void write_infinity(void)
{
    kw_out_number(half_a_row(), -INFINITY);
}

static void write_three_numbers(void)
{
    kw_out *f = half_a_row();

    kw_out_number(f, 2);
    kw_out_number(f, 3);
}

static void write_before_a_section(void)
{
    kw_out_number(kw_out_new(path_of("broken")), 1);
}

static void end_a_short_row(void)
{
    kw_out_row(half_a_row());
}

static void gap_in_a_row(void)
{
    kw_out_gap(half_a_row());
}

static void section_in_a_row(void)
{
    kw_out_section(half_a_row(), "t", "x");
}

static void close_in_a_row(void)
{
    kw_out_close(half_a_row());
}

static void malformed_rows_abort(void)
{
    static const char SHORT[] = "broken: a row of 2 columns ends after 1";

    test_aborts("broken: nan", write_nan);
    test_aborts("broken: -inf", write_infinity);
    test_aborts("broken: more than 2 columns", write_three_numbers);
    test_aborts("broken: more than 0 columns", write_before_a_section);
    test_aborts(SHORT, end_a_short_row);
    test_aborts(SHORT, gap_in_a_row);
    test_aborts(SHORT, section_in_a_row);
    test_aborts(SHORT, close_in_a_row);
    CHECK(!is_there("broken"), "a broken file is there");
}

int main(void)
{
    const char *place = getenv("TMPDIR");

    snprintf(folder, sizeof folder, "%s/knotwork.XXXXXX",
             place && *place ? place : "/tmp");
    KW_NEED(mkdtemp(folder), "no folder %s", folder);
    test_run("out: a file appears whole, without its temporary", a_file_appears_whole);
    test_run("out: an older file is replaced at the end, not before",
             an_older_file_is_replaced_at_the_end);
    test_run("out: a missing folder is said with the path", a_missing_folder_is_said);
    test_run("out: a folder in the way is said with the path",
             a_folder_in_the_way_is_said);
    test_run("out: a full disk is said and the older file stays", a_full_disk_is_said);
    test_run("out: the beginning of a file may come last", a_beginning_may_come_last);
    test_run("out: a file may be given up", a_file_may_be_given_up);
    test_run("out: NPY files are exact to the byte", npy_files_are_exact_to_the_byte);
    test_run("out: NPY data begin at a multiple of 64",
             npy_data_begin_at_a_multiple_of_64);
    test_run("out: NPY needs 1 to 4 dimensions", npy_needs_1_to_4_dimensions);
    test_run("out: CSV gives back the same doubles", csv_gives_back_the_same_doubles);
    test_run("out: arrays take any double", arrays_take_any_double);
    test_run("out: arrays fail as files do", arrays_fail_as_files_do);
    test_run("out: sections, rows and gaps have gnuplot's format",
             columns_have_their_format);
    test_run("out: a NaN, a short and a long row abort", malformed_rows_abort);
    empty_folder();
    rmdir(folder);
    return test_end();
}
