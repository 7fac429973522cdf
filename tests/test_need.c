#include "need.h"
#include "test.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Needs value < limit; returns the line where it does. */
static int need_below(int value, int limit)
{
    const int here = __LINE__ + 1;
    KW_NEED(value < limit, "value %d, limit %d", value, limit);
    return here;
}

static void break_need(void)
{
    need_below(7, 4);
}

static void an_unmet_need_says_what_and_where(void)
{
    char text[200];

    snprintf(text, sizeof text, "%s:%d: need `value < limit`: value 7, limit 4\n",
             __FILE__, need_below(1, 4));
    test_aborts(text, break_need);
}

static void fail_directly(void)
{
    kw_need_failed("place.c", 12, "a != b", "%s and %g", "word", 0.5);
}

static void the_message_has_its_exact_form(void)
{
    test_aborts("place.c:12: need `a != b`: word and 0.5\n", fail_directly);
}

static void need_a_range(void)
{
    double x = NAN;

    KW_NEED(0 <= x && x <= 1, "x = %g", x);
}

static void a_range_check_catches_nan(void)
{
    test_aborts("x = nan", need_a_range);
}

static void a_met_need_costs_one_look(void)
{
    int looks = 0;

    KW_NEED(++looks > 0, "%d looks", looks);
    CHECK(looks == 1, "%d looks", looks);
}

static void memory_is_zero(void)
{
    for (size_t count = 1; count < 5000; count = 3 * count + 1) {
        unsigned char *p = kw_need_memory(count, 3);
        int dirty = 0;

        for (size_t i = 0; i < 3 * count; i++) {
            dirty += p[i] != 0;
            p[i] = 0xff; /* what calloc hands out next is likely this block again */
        }
        CHECK(dirty == 0, "%d of %zu bytes", dirty, 3 * count);
        free(p);
    }
}

static void numbers_begin_a_line(void)
{
    for (size_t count = 1; count < 5000; count = 3 * count + 1) {
        double *a = kw_need_numbers(count);
        int dirty = 0;

        CHECK((uintptr_t)a % 64 == 0, "%zu numbers at %p", count, (void *)a);
        for (size_t i = 0; i < count; i++) {
            dirty += a[i] != 0;
            a[i] = 1;
        }
        CHECK(dirty == 0, "%d of %zu numbers", dirty, count);
        free(a);
    }
}

static void no_memory_is_a_pointer_too(void)
{
    void *none = kw_need_memory(0, 8), *empty = kw_need_memory(8, 0);
    double *no_number = kw_need_numbers(0);

    CHECK(none && empty && no_number, "%p, %p and %p", none, empty, (void *)no_number);
    free(none);
    free(empty);
    free(no_number);
}

/* more than the address space; the product does not overflow */
static void ask_for_too_much(void)
{
    free(kw_need_memory(SIZE_MAX / 16, 8));
}

/* the product overflows a size_t to a small number */
static void ask_for_an_overflow(void)
{
    free(kw_need_memory(SIZE_MAX / 8 + 2, 8));
}

/* numbers whose bytes overflow a size_t, and some that do not */
static void ask_for_too_many_numbers(void)
{
    free(kw_need_numbers(SIZE_MAX / 4));
}

static void ask_for_many_numbers(void)
{
    free(kw_need_numbers(SIZE_MAX / 16));
}

static void absurd_sizes_abort(void)
{
    char text[100];

    snprintf(text, sizeof text, "memory for %zu objects of 8 bytes", SIZE_MAX / 16);
    test_aborts(text, ask_for_too_much);
    snprintf(text, sizeof text, "memory for %zu objects of 8 bytes", SIZE_MAX / 8 + 2);
    test_aborts(text, ask_for_an_overflow);
    snprintf(text, sizeof text, "memory for %zu numbers", SIZE_MAX / 4);
    test_aborts(text, ask_for_too_many_numbers);
    snprintf(text, sizeof text, "memory for %zu numbers", SIZE_MAX / 16);
    test_aborts(text, ask_for_many_numbers);
}

/* Under the address sanitizer an absurd size shall be NULL as it is without. */
const char *__asan_default_options(void); /* NOLINT: the sanitizer's own name */
const char *__asan_default_options(void)  /* NOLINT */
{
    return "allocator_may_return_null=1";
}

int main(void)
{
    test_run("need: an unmet need says file, line, condition and values",
             an_unmet_need_says_what_and_where);
    test_run("need: the message has its exact form", the_message_has_its_exact_form);
    test_run("need: a range check catches NaN", a_range_check_catches_nan);
    test_run("need: the condition is evaluated once", a_met_need_costs_one_look);
    test_run("need: memory is zero", memory_is_zero);
    test_run("need: numbers begin a line of the cache", numbers_begin_a_line);
    test_run("need: no memory is a pointer too", no_memory_is_a_pointer_too);
    test_run("need: an absurd size aborts with the number", absurd_sizes_abort);
    return test_end();
}
