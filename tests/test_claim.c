#include "claim.h"
#include "test.h"
#include <float.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#define NAME "test_claim_sample"
static const char PATH[] = KW_BUILD "/claims/" NAME ".tsv";

/* the file as text, "" if there is none */
static void read_report(char *text, size_t size)
{
    FILE *f = fopen(PATH, "rb");
    size_t length = 0;

    if (f) {
        length = fread(text, 1, size - 1, f);
        fclose(f);
    }
    text[length] = 0;
}

static void a_report_has_a_line_a_claim(void)
{
    static const char expected[] = "a.count\t-7\n"
                                   "a.large\t9223372036854775807\n"
                                   "a.real\t0.10000000000000001\n"
                                   "a.epsilon\t2.2204460492503131e-16\n"
                                   "a.true\ttrue\n"
                                   "a.false\tfalse\n";
    char text[500];
    kw_out *report = kw_claim_new(NAME);

    kw_claim_count(report, "a.count", -7);
    kw_claim_count(report, "a.large", LLONG_MAX);
    kw_claim_real(report, "a.real", 0.1);
    kw_claim_real(report, "a.epsilon", DBL_EPSILON);
    kw_claim_true(report, "a.true", 12);
    kw_claim_true(report, "a.false", 0);
    CHECK(kw_out_close(report) == 0, "%s", PATH);
    read_report(text, sizeof text);
    CHECK(strcmp(text, expected) == 0, "%s", text);
    remove(PATH);
}

static void a_report_is_not_there_before_its_end(void)
{
    char text[100];
    kw_out *report = kw_claim_new(NAME);

    kw_claim_count(report, "a.count", 1);
    read_report(text, sizeof text);
    CHECK(text[0] == 0, "%s", text);
    CHECK(kw_out_close(report) == 0, "%s", PATH);
    read_report(text, sizeof text);
    CHECK(strcmp(text, "a.count\t1\n") == 0, "%s", text);
    remove(PATH);
}

int main(void)
{
    test_run("claim: a report has a line a claim", a_report_has_a_line_a_claim);
    test_run("claim: a report is not there before its end",
             a_report_is_not_there_before_its_end);
    return test_end();
}
