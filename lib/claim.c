#include "claim.h"
#include "need.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

kw_out *kw_claim_new(const char *driver)
{
    static const char format[] = KW_BUILD "/claims/%s.tsv";
    size_t size = strlen(driver) + sizeof format;
    char *path = kw_need_memory(size, 1);
    kw_out *report;

    snprintf(path, size, format, driver);
    report = kw_out_new(path);
    free(path);
    return report;
}

void kw_claim_count(kw_out *report, const char *id, long long value)
{
    kw_out_text(report, "%s\t%lld\n", id, value);
}

void kw_claim_real(kw_out *report, const char *id, double value)
{
    kw_out_text(report, "%s\t%.17g\n", id, value);
}

void kw_claim_true(kw_out *report, const char *id, int holds)
{
    kw_out_text(report, "%s\t%s\n", id, holds ? "true" : "false");
}
