#!/bin/sh
# gen_golden_test.sh -- small sets of every family have the sums of tests/gen_golden.txt, with any
# compiler and on any machine. Runs in the folder of the Makefile; BUILD is the folder of the programs,
# RUN what runs them if they are for another machine.
set -u

golden=$PWD/tests/gen_golden.txt
# shellcheck source=tests/gen.inc
. tests/gen.inc

while read -r sum options; do
    # shellcheck disable=SC2086  # lists of words
    ${RUN:-} "$gen" $options --out golden >"$said" 2>&1 </dev/null &&
        ${RUN:-} "$gen" verify golden >"$said" 2>&1 </dev/null && grep -q "^$sum " "$said"
    result $? "golden: gen $options is $sum"
    rm -rf golden
done <"$golden"

# shellcheck disable=SC2086
${RUN:-} "$gen" --help | awk '/^Families/ { on = 1; next } /^$/ { on = 0 } on { print $1 }' >families
cut -d' ' -f2 "$golden" | sort -u >covered
sort families | comm -23 - covered >"$said"
[ -s families ] && [ ! -s "$said" ]
result $? "golden: there is a set of each family"

exit $failed
