#include "test.h"
#include "need.h"
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SHOWN = 5 }; /* failures of one test that are printed */

static int failed_checks, failed_tests;

void test_failed(const char *file, int line, const char *condition, const char *format,
                 ...)
{
    va_list values;

    if (failed_checks++ >= SHOWN)
        return;
    printf("# %s:%d: %s: ", file, line, condition);
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
    putchar('\n');
}

void test_run(const char *name, void (*test)(void))
{
    failed_checks = 0;
    test();
    if (failed_checks > 0)
        printf("not ok - %s (%d checks failed)\n", name, failed_checks);
    else
        printf("ok - %s\n", name);
    failed_tests += failed_checks > 0;
    fflush(stdout);
}

int test_end(void)
{
    return failed_tests > 0;
}

void test_aborts(const char *text, void (*call)(void))
{
    int channel[2], status;
    char message[1024];
    size_t length = 0;
    ssize_t got;
    pid_t child;

    fflush(NULL);
    KW_NEED(pipe(channel) == 0, "no pipe for `%s'", text);
    child = fork();
    KW_NEED(child >= 0, "no process for `%s'", text);
    if (child == 0) {
        dup2(channel[1], STDERR_FILENO);
        close(channel[0]);
        close(channel[1]);
        call();
        _exit(0);
    }
    close(channel[1]);
    while ((got = read(channel[0], message + length, sizeof message - 1 - length)) > 0)
        length += (size_t)got;
    message[length] = 0;
    close(channel[0]);
    waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT, "`%s' did not abort", text);
    CHECK(strstr(message, text), "`%s' is not in `%s'", text, message);
}

double test_random_in(kw_rng *r, double low, double high)
{
    return low + (high - low) * kw_rng_uniform(r);
}

kw_bspline *test_random_space(kw_rng *r, int highest)
{
    enum { SPANS = 6, K = KW_BSPLINE_DEGREE + 1 };
    const double width[] = {1, 0.01, 30};
    double t[2 * K + SPANS * K];
    int d = kw_rng_below(r, highest + 1), spans = 1 + kw_rng_below(r, SPANS);
    int open = kw_rng_below(r, 2), count = d + 1;
    double x = test_random_in(r, -2, 2), first, last;
    kw_bspline *s;

    t[d] = x;
    for (int i = 1; i <= spans; i++) {
        int copies = i < spans ? 1 + kw_rng_below(r, d + 1) : 1;

        x += test_random_in(r, 0.5, 1) * width[kw_rng_below(r, 3)];
        while (copies-- > 0)
            t[count++] = x;
    }
    first = t[d + 1] - t[d];
    last = t[count - 1] - t[count - 2];
    for (int i = 1; i <= d; i++) {
        t[d - i] = t[d - i + 1] - (open ? 0 : kw_rng_below(r, 3) * first);
        t[count - 1 + i] = t[count - 2 + i] + (open ? 0 : kw_rng_below(r, 3) * last);
    }
    s = kw_bspline_new(d, count - 1, t);
    return s;
}

double test_random_point(kw_rng *r, const kw_bspline *s)
{
    double a = s->t[s->d], b = s->t[s->n], x;

    switch (kw_rng_below(r, 8)) {
    case 0:
        return kw_rng_below(r, 2) ? a : b;
    case 1:
    case 2:
        return s->t[s->d + kw_rng_below(r, s->n - s->d + 1)];
    default:
        x = test_random_in(r, a, b);
        return x < b ? x : b;
    }
}

void test_poison(double *a, int count)
{
    for (int i = 0; i < count; i++)
        a[i] = NAN;
}
