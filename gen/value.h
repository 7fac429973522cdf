/* value.h -- the value of one option, from the word on the command line. Each function returns
   GEN_GOOD, or GEN_BAD_CALL after a message that shows the word. */
#ifndef GEN_VALUE_H
#define GEN_VALUE_H

#include "set.h"

/* An integer of the option `name`, 0 .. most. */
int gen_value_integer(const char *name, const char *text, uint64_t most, uint64_t *value);

/* A value of parameter p: a number within its bounds, a range of two, or the place of a word in
   its list. *low == *high but for a range. */
int gen_value_read(const gen_parameter *p, const char *text, double *low, double *high);

#endif
