/* need.h -- what a function needs of its caller, and memory that is there.

   A caller's mistake is no error to be handled: KW_NEED prints where it happened, the
   condition and the offending values on stderr, and the program aborts. What can fail in
   honest use (a file, a command line, a singular system) is returned instead. */
#ifndef KW_NEED_H
#define KW_NEED_H

#include <stddef.h>

/* Aborts with a message unless `condition` holds. After the condition stands a printf
   format with its values: KW_NEED(d >= 0, "degree %d", d). A comparison with NaN is
   false, so a range check written as `a <= x && x <= b` catches NaN too. */
#define KW_NEED(condition, ...)                                                          \
    ((condition) ? (void)0 : kw_need_failed(__FILE__, __LINE__, #condition, __VA_ARGS__))

/* Prints "file:line: need `condition`: message" on stderr and aborts. */
_Noreturn void kw_need_failed(const char *file, int line, const char *condition,
                              const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* `count` objects of `size` bytes each, all zero; the caller frees. Aborts with the
   number of bytes if there is no memory for them. Never NULL, even for count 0. */
void *kw_need_memory(size_t count, size_t size);

/* The same for `count` numbers, from the beginning of a line of the processor's cache on: no
   vector of them then lies across two lines. For what is read again and again. */
double *kw_need_numbers(size_t count);

#endif
