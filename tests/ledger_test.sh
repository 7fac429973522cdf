#!/bin/sh
# ledger_test.sh -- the checkers fail when they should: a small good ledger passes, and with
# one thing broken at a time it fails with a message that names it. The same for levels.sh
# and summary.sh. Runs in the folder of the Makefile; BUILD is the folder of the programs.
set -u

ledger=$(cd "${BUILD:-build}/bin" && pwd)/ledger
tests=$(cd tests && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/out
# shellcheck source=tests/result.inc
. tests/result.inc
cd "$place" || exit 1

# line FILE FIELD ... -- appends the fields, separated by tabs
line() {
    file=$1
    shift
    (IFS='	' && printf '%s\n' "$*") >>"$file"
}

good() {
    rm -rf claims.tsv ERRATA.md items.txt reports
    mkdir reports
    line claims.tsv '# id' kind printed ours tol where note
    line claims.tsv a.count count 12 12 - 'Def 1' 'counted'
    line claims.tsv a.real real - 0.5 1e-3 'Def 2, Text 1.1' 'three digits'
    line claims.tsv a.max max - 10 - 'Eq 5' '-'
    line claims.tsv a.range range - 1..3 - 'Eq 6' '-'
    line claims.tsv a.true true true true - 'Fig 4' '-'
    line claims.tsv a.wrong count 63 72 - 'Fig 5' 'the caption'
    line claims.tsv a.none none - - - 'Def 3' 'a convention'
    cat >ERRATA.md <<END
# Errata
## ER-01. The caption
- Printed: 63.
- Ledger: a.wrong
- Shown by: two
END
    printf '# what must be there\nDef 1 3\nEq 5 6\nFig 4 5\n' >items.txt
    line reports/one.tsv a.count 12
    line reports/one.tsv a.real 0.5004
    line reports/one.tsv a.max 10
    line reports/one.tsv a.range 2.5
    line reports/one.tsv a.true true
    line reports/two.tsv a.wrong 72
}

# edit FILE SCRIPT -- sed in place
edit() {
    sed "$2" "$1" >edited && mv edited "$1"
}

judge() {
    "$ledger" claims.tsv ERRATA.md items.txt reports one two >out 2>&1
}

# defect NAME ID TEXT -- the judge exits 1 with one line of a defect that holds both texts
defect() {
    judge
    status=$?
    [ "$status" = 1 ] && grep '^not ok - ' out | grep -F -e "$2" | grep -q -F -e "$3"
    result $? "ledger: $1"
    good
}

# stop NAME TEXT -- the judge exits 2 and says why
stop() {
    judge
    status=$?
    [ "$status" = 2 ] && grep -q -F -e "$2" out
    result $? "ledger: $1"
    good
}

good
judge
result $? "ledger: a good ledger passes"
[ "$(grep -c '^ok - claim ' out)" = 6 ] && ! grep -q '^not ok' out &&
    grep -q '^# claim a.none is not computed: a convention' out
result $? "ledger: each claim has its line"

# --- values ---
edit reports/one.tsv 's/12/13/'
defect "a wrong count" a.count 13
edit reports/one.tsv 's/12/12.0/'
defect "a count that is no integer" a.count 12.0
edit reports/one.tsv 's/12/1.2e1/'
defect "a count with an exponent" a.count 1.2e1
edit reports/one.tsv 's/12/twelve/'
defect "a count that is no number" a.count twelve
edit reports/one.tsv 's/0.5004/0.5006/'
defect "a real off by more than tol" a.real 0.5006
edit reports/one.tsv 's/0.5004/nan/'
defect "a NaN" a.real nan
edit reports/one.tsv 's/0.5004/inf/'
defect "an infinity" a.real inf
edit reports/one.tsv 's/10/10.5/'
defect "a maximum exceeded" a.max 10.5
edit reports/one.tsv 's/2.5/3.01/'
defect "a value above its range" a.range 3.01
edit reports/one.tsv 's/2.5/0.99/'
defect "a value below its range" a.range 0.99
edit reports/one.tsv 's/	true/	false/'
defect "false instead of true" a.true false
edit claims.tsv 's/^a.true	true	true	true/a.true	true	-	false/'
defect "true instead of false" a.true 'true false'
edit reports/one.tsv 's/a.true	true/a.true	1/'
defect "a number instead of true" a.true "reported by one: 1"

# --- who reports what ---
line reports/one.tsv a.count 12
defect "a claim twice from one driver" a.count 'twice, by one and by one'
line reports/two.tsv a.count 12
defect "a claim from two drivers" a.count 'twice, by one and by two'
edit reports/one.tsv '/a.max/d'
defect "a claim that nobody reports" a.max 'reported by no driver'
: >reports/one.tsv
defect "an empty report" a.range 'reported by no driver'
line reports/two.tsv b.new 1
defect "a report that is not in the ledger" b.new 'not in the ledger'
line reports/two.tsv a.none true
defect "a report of what is not computed" a.none two
echo 'a.count 12' >>reports/two.tsv
defect "a report without a tab" 'reports/two.tsv' 'a.count 12'

# --- the ledger itself ---
line claims.tsv c.short count 1 1 - 'Def 1'
defect "a line of six columns" 'claims.tsv:9' '6 columns'
line claims.tsv c.long count 1 1 - 'Def 1' note more
defect "a line of eight columns" 'claims.tsv:9' '8 columns'
line claims.tsv a.max max - 10 - 'Eq 5' '-'
defect "an id that stands there twice" 'claims.tsv:9' 'a.max stands there twice'
edit claims.tsv 's/^a.max	max/a.max	most/'
defect "an unknown kind" a.max 'kind most'
edit claims.tsv 's/a convention/-/'
defect "nothing computed and no reason" a.none "note \`-'"
edit claims.tsv 's/a convention//'
defect "nothing computed and an empty reason" a.none "note \`'"
edit claims.tsv 's/1e-3/-/'
defect "a real without tol" a.real "tol \`-'"
edit claims.tsv 's/1e-3/-1e-3/'
defect "a negative tol" a.real "tol \`-1e-3'"
edit claims.tsv 's/1\.\.3/3..1/'
defect "a range that is upside down" a.range '3..1'
edit claims.tsv 's/12	12/12	12.5/'
defect "a count that is not whole" a.count 12.5
edit claims.tsv 's/	true	true	true/	true	-	yes/'
defect "neither true nor false" a.true "ours \`yes'"

# --- errata ---
edit claims.tsv 's/12	12/11	12/'
defect "printed differs and there is no erratum" a.count 'no erratum in ERRATA.md'
edit claims.tsv 's/	true	true	true/	true	false	true/'
defect "a printed statement differs and there is no erratum" a.true 'no erratum'
edit claims.tsv 's/range	-/range	4/'
defect "a printed value out of our range and there is no erratum" a.range 'no erratum'
: >ERRATA.md
defect "an erratum that was removed" a.wrong 'no erratum'
edit ERRATA.md 's/a.wrong/a.wrong, b.unknown/'
defect "an erratum of an unknown claim" ER-01 b.unknown
edit claims.tsv 's/63	72/72	72/'
defect "an erratum without a difference" ER-01 'none of its claims differs'
printf '## ER-02. Nothing\n- Ledger: a.count, a.max\n- Shown by: one\n' >>ERRATA.md
defect "a second erratum without a difference" ER-02 'none of its claims differs'
printf '## ER-03. No claim\n' >>ERRATA.md
defect "an erratum without a claim" ER-03 'none of its claims differs'
edit ERRATA.md 's/by: two/by: one/'
defect "an erratum shown by another program" a.wrong 'is shown by two'
edit ERRATA.md 's/by: two/by: twofold/'
defect "a program whose name begins like that of the erratum" a.wrong 'is shown by two'
edit ERRATA.md '/Shown by/d'
defect "an erratum shown by no program" a.wrong 'is shown by two'

# --- coverage ---
edit claims.tsv 's/Def 2, //'
defect "a definition without a line" 'Def 2' 'no line in the ledger'
edit claims.tsv 's/Def 2,/Def 20,/'
defect "another definition whose number begins alike" 'Def 2' 'no line in the ledger'
echo 'Rem 1 2' >>items.txt
defect "remarks without a line" 'Rem 2' 'no line in the ledger'
echo 'Rem one' >>items.txt
defect "an item without numbers" 'items.txt' 'Rem one'

# --- files ---
rm reports/two.tsv
stop "a missing report stops it" reports/two.tsv
rm claims.tsv
stop "a missing ledger stops it" claims.tsv
rm ERRATA.md
stop "missing errata stop it" ERRATA.md
rm items.txt
stop "missing items stop it" items.txt
awk 'BEGIN { while (i++ < 5000) printf "x"; print "" }' >>claims.tsv
stop "a line too long for it stops it" 'more than'
"$ledger" >out 2>&1
[ $? = 2 ] && grep -q '^usage: ledger ' out
result $? "ledger: without files it shows its usage"

# --- levels.sh ---
lay_library() {
    rm -rf lib
    mkdir lib
    printf '# levels\n0 base\n1 low wide\n2 high\n' >lib/LEVELS
    : >lib/base.h
    printf '#include "base.h"\n#include <math.h>\n' >lib/low.h
    printf '#include "low.h"\n' >lib/wide.c
    printf '#include "wide.h"\n#include "base.h"\n' >lib/high.c
}

# climb NAME TEXT TEXT -- levels.sh exits 1 with a line that holds both texts
climb() {
    "$tests/levels.sh" lib >out 2>&1
    status=$?
    [ "$status" = 1 ] && grep '^not ok - ' out | grep -F -e "$2" | grep -q -F -e "$3"
    result $? "levels: $1"
    lay_library
}

lay_library
"$tests/levels.sh" lib >out 2>&1
result $? "levels: includes that go down pass"
echo '#include "high.h"' >>lib/low.h
climb "an include that climbs" lib/low.h high.h
echo '# include "high.h"' >>lib/low.h
climb "an include that climbs, a blank behind the #" lib/low.h high.h
echo '  #include"high.h"' >>lib/low.h
climb "an include that climbs, blanks before the # and none behind" lib/low.h high.h
echo 'int stray;' >lib/stray.c
climb "a module without a level" lib/stray.c 'no level'
echo '#include "alien.h"' >>lib/high.c
climb "an include without a level" lib/high.c alien.h

# --- summary.sh ---
# summary NAME STATUS LAST LOG ... -- summary.sh exits with STATUS and ends with LAST
summary() {
    name=$1 wanted=$2 last=$3
    shift 3
    "$tests/summary.sh" "$@" >out 2>&1
    status=$?
    [ "$status" = "$wanted" ] && [ "$(tail -n 1 out)" = "$last" ]
    result $? "summary: $name"
}

printf 'ok - one\n# word\nok - two\n' >good.log
printf 'ok - three\nnot ok - four\n# because\n' >bad.log
: >empty.log
summary "good logs pass" 0 '4 passed, 0 failed' good.log good.log
summary "a failed check fails" 1 '3 passed, 1 failed' good.log bad.log
grep -q '^not ok - four' out && grep -q '^# because' out && grep -q '^bad.log:' out
result $? "summary: what failed is shown with its log"
summary "an empty log fails" 1 '2 passed, 1 failed' good.log empty.log
grep -q 'empty.log holds no result' out
result $? "summary: the empty log is named"
summary "a missing log fails" 1 '2 passed, 1 failed' good.log none.log

exit "$failed"
