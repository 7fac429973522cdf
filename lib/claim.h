/* claim.h -- the numbers that a driver found, for the ledger to judge.

   A driver reports what it computed under the ledger's id; it does not know what is
   expected. `make check` compares the reports with chapters/claims.tsv. */
#ifndef KW_CLAIM_H
#define KW_CLAIM_H

#include "out.h"

/* The report of a driver, build/claims/<driver>.tsv, with one line `id TAB value` a
   claim. Close it with kw_out_close, last of all: the plot waits for this file. */
kw_out *kw_claim_new(const char *driver);

/* Reports a number of things (ledger kinds count, max and range). */
void kw_claim_count(kw_out *report, const char *id, long long value);

/* Reports a real number (ledger kinds real, max and range). */
void kw_claim_real(kw_out *report, const char *id, double value);

/* Reports whether a statement holds (ledger kind true). */
void kw_claim_true(kw_out *report, const char *id, int holds);

#endif
