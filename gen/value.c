#include "value.h"
#include "gen.h"
#include "need.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

int gen_value_integer(const char *name, const char *text, uint64_t most, uint64_t *value)
{
    char *end;

    KW_NEED(text, "%s has no value", name);
    errno = 0;
    *value = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != 0)
        return gen_say(GEN_BAD_CALL, "%s is `%s', not an integer from 0 on", name, text);
    if (errno == ERANGE || *value > most)
        return gen_say(GEN_BAD_CALL, "%s is %s, more than %llu", name, text,
                       (unsigned long long)most);
    return GEN_GOOD;
}

/* The place of `word` in a list of words separated by blanks; -1 if it is not there. */
static int find_word(const char *list, const char *word, size_t length)
{
    for (int place = 0; *list; place++) {
        size_t here = strcspn(list, " ");

        if (here == length && strncmp(list, word, length) == 0)
            return place;
        list += here + (list[here] == ' ');
    }
    return -1;
}

static int in_bounds(const gen_parameter *p, const char *text, double value)
{
    if (p->least <= value && value <= p->most)
        return GEN_GOOD;
    return gen_say(GEN_BAD_CALL, "%s is %s, not within %.10g .. %.10g", p->name, text,
                   p->least, p->most);
}

/* A number at the beginning of `text`; what comes behind it is at *end. */
static int read_number(const gen_parameter *p, const char *text, char **end,
                       double *value)
{
    size_t length = strspn(text, p->kind == GEN_REAL ? "+-.0123456789eE" : "0123456789");

    *value = strtod(text, end);
    if (*end == text || *end > text + length)
        return gen_say(GEN_BAD_CALL, "%s has `%s' in place of %s", p->name, text,
                       p->kind == GEN_REAL ? "a number" : "an integer");
    *value += 0; /* -0 becomes 0: the bytes differ, and the text of the call would not */
    return in_bounds(p, text, *value);
}

int gen_value_read(const gen_parameter *p, const char *text, double *low, double *high)
{
    char *end;
    int status;

    if (p->kind == GEN_WORD) {
        *low = *high = find_word(p->words, text, strlen(text));
        return *low >= 0 ? GEN_GOOD
                         : gen_say(GEN_BAD_CALL, "%s is `%s', none of: %s", p->name, text,
                                   p->words);
    }
    status = read_number(p, text, &end, low);
    *high = *low;
    if (status == GEN_GOOD && p->kind == GEN_RANGE && *end == '-')
        status = read_number(p, end + 1, &end, high);
    if (status != GEN_GOOD)
        return status;
    if (*end != 0)
        return gen_say(GEN_BAD_CALL, "%s is `%s', with `%s' behind the number", p->name,
                       text, end);
    if (*low > *high)
        return gen_say(GEN_BAD_CALL, "%s is `%s', from more to less", p->name, text);
    return GEN_GOOD;
}
