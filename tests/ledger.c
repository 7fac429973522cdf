/* ledger -- judges what the drivers report against the ledger and the errata.

   ledger CLAIMS ERRATA ITEMS REPORTS DRIVER...
     CLAIMS   chapters/claims.tsv: id, kind, printed, ours, tol, where, note
     ERRATA   chapters/ERRATA.md: sections `## ER-..' with lines `- Ledger:' and `- Shown by:'
     ITEMS    lines `Def 1 3': the numbered items that must appear in a `where'
     REPORTS  the folder of the drivers' reports, REPORTS/DRIVER.tsv

   Prints a line `ok - ...' for each claim that holds and `not ok - ...' for each defect;
   exits 0 if there is none, 1 if there are some, 2 if a file cannot be read. */

#include "need.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 7, LONGEST = 4096 };

typedef struct claim {
    char *id, *kind, *printed, *ours, *tol, *where, *note;
    const char *driver;  /* who reported it; NULL if nobody did */
    const char *erratum; /* the erratum that names it; NULL if none does */
} claim;

typedef struct ledger {
    claim *claims;
    int count, defects;
} ledger;

static void defect(ledger *all, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void defect(ledger *all, const char *format, ...)
{
    va_list values;

    all->defects++;
    printf("not ok - ");
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
    putchar('\n');
}

/* --- reading --- */

static FILE *open_or_exit(const char *path)
{
    FILE *f = fopen(path, "r");

    if (!f) {
        perror(path);
        exit(2);
    }
    return f;
}

/* The next line without its end, or NULL. */
static char *read_line(FILE *f, const char *path, char *line)
{
    if (!fgets(line, LONGEST, f))
        return NULL;
    if (!strchr(line, '\n') && !feof(f)) {
        fprintf(stderr, "%s: a line of more than %d characters: %.40s...\n", path,
                LONGEST - 2, line);
        exit(2);
    }
    line[strcspn(line, "\n")] = 0;
    return line;
}

static char *copy(const char *s)
{
    size_t size = strlen(s) + 1;

    return memcpy(kw_need_memory(size, 1), s, size);
}

/* Cuts `line` at its tabs; the number of fields, counted beyond `most` too. */
static int split(char *line, char **field, int most)
{
    int count = 0;

    for (char *tab; line; line = tab) {
        tab = strchr(line, '\t');
        if (tab)
            *tab++ = 0;
        if (count < most)
            field[count] = line;
        count++;
    }
    return count;
}

static claim *find(const ledger *all, const char *id)
{
    for (int i = 0; i < all->count; i++)
        if (strcmp(all->claims[i].id, id) == 0)
            return &all->claims[i];
    return NULL;
}

static int is_number(const char *s, double *value)
{
    char *end;

    *value = strtod(s, &end);
    return end != s && *end == 0 && isfinite(*value);
}

static int is_range(const char *s, double *low, double *high)
{
    char text[LONGEST], *dots;

    snprintf(text, sizeof text, "%s", s);
    dots = strstr(text, "..");
    if (!dots)
        return 0;
    *dots = 0;
    return is_number(text, low) && is_number(dots + 2, high) && *low <= *high;
}

/* Does `ours` (and `tol`) have the form that the kind wants? */
static int well_formed(const claim *c)
{
    double a, b;

    if (strcmp(c->kind, "count") == 0)
        return is_number(c->ours, &a) && a == floor(a);
    if (strcmp(c->kind, "real") == 0)
        return is_number(c->ours, &a) && is_number(c->tol, &b) && b >= 0;
    if (strcmp(c->kind, "max") == 0)
        return is_number(c->ours, &a);
    if (strcmp(c->kind, "range") == 0)
        return is_range(c->ours, &a, &b);
    if (strcmp(c->kind, "true") == 0)
        return strcmp(c->ours, "true") == 0 || strcmp(c->ours, "false") == 0;
    return strcmp(c->kind, "none") == 0 && c->note[0] && strcmp(c->note, "-") != 0;
}

static void read_claims(ledger *all, const char *path)
{
    FILE *f = open_or_exit(path);
    char text[LONGEST], *field[COLUMNS];

    for (int line = 1; read_line(f, path, text); line++) {
        claim c = {.driver = NULL};
        int fields;

        if (text[0] == 0 || text[0] == '#')
            continue;
        fields = split(text, field, COLUMNS);
        if (fields != COLUMNS) {
            defect(all, "%s:%d: %d columns instead of %d: %s", path, line, fields,
                   COLUMNS, text);
            continue;
        }
        c.id = copy(field[0]);
        c.kind = copy(field[1]);
        c.printed = copy(field[2]);
        c.ours = copy(field[3]);
        c.tol = copy(field[4]);
        c.where = copy(field[5]);
        c.note = copy(field[6]);
        if (find(all, c.id))
            defect(all, "%s:%d: claim %s stands there twice", path, line, c.id);
        if (!well_formed(&c))
            defect(all, "%s:%d: claim %s: kind %s with ours `%s', tol `%s', note `%s'",
                   path, line, c.id, c.kind, c.ours, c.tol, c.note);
        all->claims = realloc(all->claims, (size_t)(all->count + 1) * sizeof c);
        KW_NEED(all->claims, "memory for %d claims", all->count + 1);
        all->claims[all->count++] = c;
    }
    fclose(f);
}

/* --- judging --- */

static int holds(const claim *c, const char *reported)
{
    double value = 0, ours = 0, low = 0, high = 0;
    int number = is_number(reported, &value);

    if (strcmp(c->kind, "true") == 0)
        return strcmp(reported, c->ours) == 0;
    if (!number)
        return 0;
    is_number(c->ours, &ours);
    if (strcmp(c->kind, "count") == 0)
        return value == ours && !strpbrk(reported, ".e");
    if (strcmp(c->kind, "real") == 0)
        return fabs(value - ours) <= strtod(c->tol, NULL) * fabs(ours);
    if (strcmp(c->kind, "max") == 0)
        return value <= ours;
    if (strcmp(c->kind, "range") == 0)
        return is_range(c->ours, &low, &high) && low <= value && value <= high;
    return 0; /* kind none: nothing to report */
}

static void read_report(ledger *all, const char *folder, const char *driver)
{
    char path[LONGEST], text[LONGEST], *field[2];
    FILE *f;

    snprintf(path, sizeof path, "%s/%s.tsv", folder, driver);
    f = open_or_exit(path);
    while (read_line(f, path, text)) {
        claim *c;

        if (split(text, field, 2) != 2) {
            defect(all, "%s: `%s' is not an id and a value", path, text);
            continue;
        }
        c = find(all, field[0]);
        if (!c) {
            defect(all, "claim %s, reported by %s, is not in the ledger", field[0],
                   driver);
            continue;
        }
        if (c->driver)
            defect(all, "claim %s is reported twice, by %s and by %s", c->id, c->driver,
                   driver);
        c->driver = driver;
        if (holds(c, field[1]))
            printf("ok - claim %s: %s (%s)\n", c->id, field[1], driver);
        else
            defect(all, "claim %s, reported by %s: %s, but the ledger has %s %s (tol %s)",
                   c->id, driver, field[1], c->kind, c->ours, c->tol);
    }
    fclose(f);
}

static void check_reported(ledger *all)
{
    for (int i = 0; i < all->count; i++) {
        const claim *c = &all->claims[i];
        int computed = strcmp(c->kind, "none") != 0;

        if (computed && !c->driver)
            defect(all, "claim %s is reported by no driver", c->id);
        if (!computed && !c->driver)
            printf("# claim %s is not computed: %s\n", c->id, c->note);
    }
}

/* --- errata --- */

/* Does what the book prints differ from what the construction gives? */
static int differs(const claim *c)
{
    double printed, ours, low, high;

    if (strcmp(c->printed, "-") == 0 || strcmp(c->printed, c->ours) == 0)
        return 0;
    if (strcmp(c->kind, "none") == 0)
        return 0;
    if (!is_number(c->printed, &printed))
        return 1;
    if (strcmp(c->kind, "range") == 0 && is_range(c->ours, &low, &high))
        return printed < low || printed > high;
    if (!is_number(c->ours, &ours))
        return 1;
    return strcmp(c->kind, "max") == 0 ? printed > ours : printed != ours;
}

static int separates(char c)
{
    return c == 0 || c == ' ' || c == ',';
}

/* Is `word` an item of the comma-separated `list`? */
static int listed(const char *list, const char *word)
{
    size_t length = strlen(word);

    for (const char *s = list; (s = strstr(s, word)); s += length)
        if ((s == list || separates(s[-1])) && separates(s[length]))
            return 1;
    return 0;
}

/* What a finished section must have: a claim that differs, and programs that show them. */
static void check_erratum(ledger *all, const char *erratum, char *ids,
                          const char *programs)
{
    int differ = 0;

    for (char *id = strtok(ids, ", "); id; id = strtok(NULL, ", ")) {
        claim *c = find(all, id);

        if (!c) {
            defect(all, "erratum %s names claim %s, which is not in the ledger", erratum,
                   id);
            continue;
        }
        if (!c->erratum)
            c->erratum = copy(erratum);
        differ += differs(c);
        if (c->driver && !listed(programs, c->driver))
            defect(all, "erratum %s: claim %s is shown by %s, not by `%s'", erratum, id,
                   c->driver, programs);
    }
    if (!differ)
        defect(all, "erratum %s: none of its claims differs from the print", erratum);
}

static void check_errata(ledger *all, const char *path)
{
    static const char LEDGER[] = "- Ledger:", SHOWN[] = "- Shown by:";
    FILE *f = open_or_exit(path);
    char text[LONGEST], erratum[64] = "", ids[LONGEST] = "", programs[LONGEST] = "";
    int more = 1;

    while (more) {
        more = read_line(f, path, text) != NULL;
        if (!more || strncmp(text, "## ER-", 6) == 0) {
            if (erratum[0])
                check_erratum(all, erratum, ids, programs);
            ids[0] = programs[0] = 0;
            if (more)
                snprintf(erratum, sizeof erratum, "%.*s", (int)strcspn(text + 3, " ."),
                         text + 3);
        } else if (strncmp(text, LEDGER, sizeof LEDGER - 1) == 0)
            snprintf(ids, sizeof ids, "%s", text + sizeof LEDGER - 1);
        else if (strncmp(text, SHOWN, sizeof SHOWN - 1) == 0)
            snprintf(programs, sizeof programs, "%s", text + sizeof SHOWN - 1);
    }
    fclose(f);
    for (int i = 0; i < all->count; i++) {
        const claim *c = &all->claims[i];

        if (differs(c) && !c->erratum)
            defect(all, "claim %s: printed %s, ours %s, and no erratum in %s", c->id,
                   c->printed, c->ours, path);
    }
}

/* --- coverage --- */

static void check_items(ledger *all, const char *path)
{
    FILE *f = open_or_exit(path);
    char text[LONGEST], kind[16], item[48];
    int first, last;

    while (read_line(f, path, text)) {
        if (text[0] == '#')
            continue;
        if (sscanf(text, "%15s %d %d", kind, &first, &last) != 3) {
            defect(all, "%s: `%s' is not an item and its first and last number", path,
                   text);
            continue;
        }
        for (int i = first; i <= last; i++) {
            int found = 0;

            snprintf(item, sizeof item, "%s %d", kind, i);
            for (int j = 0; j < all->count && !found; j++)
                found = listed(all->claims[j].where, item);
            if (!found)
                defect(all, "%s has no line in the ledger", item);
        }
    }
    fclose(f);
}

static void release(ledger *all)
{
    for (int i = 0; i < all->count; i++) {
        claim *c = &all->claims[i];
        char *owned[] = {c->id, c->kind, c->printed, c->ours, c->tol, c->where, c->note};

        for (size_t j = 0; j < sizeof owned / sizeof *owned; j++)
            free(owned[j]);
        free((char *)c->erratum);
    }
    free(all->claims);
}

int main(int argc, char **argv)
{
    ledger all = {NULL, 0, 0};

    if (argc < 5) {
        fprintf(stderr, "usage: ledger CLAIMS ERRATA ITEMS REPORTS DRIVER...\n");
        return 2;
    }
    read_claims(&all, argv[1]);
    for (int i = 5; i < argc; i++)
        read_report(&all, argv[4], argv[i]);
    check_reported(&all);
    check_errata(&all, argv[2]);
    check_items(&all, argv[3]);
    release(&all);
    return all.defects > 0;
}
