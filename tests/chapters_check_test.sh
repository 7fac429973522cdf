#!/bin/sh
# chapters_check_test.sh -- chapters_test.sh fails when it should: a small good folder passes,
# and with one reference broken at a time it fails with a message that names it. Runs in the
# folder of the Makefile.
set -u

tests=$(cd tests && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/out
# shellcheck source=tests/result.inc
. tests/result.inc
cd "$place" || exit 1

good() {
    rm -rf chapters figures gen lib README.md
    mkdir -p chapters/1-one figures gen lib
    printf 'a.count\tcount\t63\t72\t-\tDef 1\tnote\n' >chapters/claims.tsv
    echo '@book{farin2002,' >chapters/references.bib
    echo 'int twice(int a)' >lib/twice.c
    : >chapters/1-one/shown.c
    echo 'set xlabel "x_2" offset 1,0' >chapters/1-one/shown.gp
    : >chapters/1-one/told.c
    : >chapters/1-one/listed.c
    echo '<tspan>x</tspan>' >figures/shown.svg
    : >gen/made.gp
    : >figures/made.svg
    echo '[listed](chapters/1-one/listed.c) ![A set.](figures/made.svg)' >README.md
    cat >chapters/1-one/chapter.md <<'END'
# One
There are [a.count]{.ours} of them, not [a.count]{.printed}, in [12]{.chosen} cells [@farin2002].
::: {.code file="lib/twice.c" function="twice"}
:::
![What is seen, with 3 cells.](../../figures/shown.svg)
Then $x^{10}$ by `f(100)` in equation (11), see ER-14 and `told.c`.
END
}

# edit SCRIPT -- sed in place, in the chapter
edit() {
    sed "$1" chapters/1-one/chapter.md >edited && mv edited chapters/1-one/chapter.md
}

# defect NAME TEXT TEXT -- the check exits 1 with one line of a defect that holds both texts
defect() {
    "$tests/chapters_test.sh" >out 2>&1
    status=$?
    [ "$status" = 1 ] && ! grep -q '^ok' out && [ "$(grep -c '^not ok - ' out)" = 1 ] &&
        grep -F -e "$2" out | grep -q -F -e "$3"
    result $? "chapters: $1"
    good
}

good
"$tests/chapters_test.sh" >out 2>&1 && grep -q '^ok - ' out
result $? "chapters: a good chapter passes"

edit 's/a.count]{.ours/a.none]{.ours/'
defect "a claim that is not in the ledger" 'claim a.none' 'not in the ledger'
edit 's/a.count]{.printed/a.coun]{.printed/'
defect "a claim whose name is the beginning of another" 'claim a.coun,' 'not in the ledger'
edit 's/a.count]{.ours/a.nought]{.none/'
defect "a word for a claim that is not in the ledger" 'claim a.nought' 'not in the ledger'
edit 's/"twice"/"thrice"/'
defect "a function that is not defined" 'pulls thrice' lib/twice.c
edit 's/twice.c"/none.c"/'
defect "a function from a file that is not there" 'pulls twice' lib/none.c
edit 's|(../../fig|(../fig|'
defect "a picture that is not there" '../figures/shown.svg' 'not there'
edit 's/!\[[^]]*]/![]/'
defect "a picture without a caption" 'shown.svg' 'without a caption'
edit 's/farin2002/boehm1980/'
defect "a source that is not listed" boehm1980 references.bib
edit 's/\[12\]{.chosen}/12/'
defect "a number that is typed by hand" 'types a number by hand' 'line 2'
edit 's/3 cells/36 cells/'
defect "a number in a caption" 'types a number by hand' 'line 5'
: >figures/stray.svg
edit 's/told.c/&, ..\/stray.svg/'
defect "a picture without a driver" figures/stray.svg 'no driver'
: >chapters/1-one/extra.c
: >figures/extra.svg
echo 'extra.c' >>README.md
defect "a picture that no chapter shows" figures/extra.svg 'in no chapter'
: >chapters/1-one/told.gp
defect "a plot without a picture" told.gp 'no committed figures/told.svg'
echo 'set ylabel "how often"' >>chapters/1-one/shown.gp
defect "a label that is not in the picture" figures/shown.svg "'how often'"
edit 's/told.c/told/'
defect "a driver that nobody names" told.c 'named in no chapter'
echo '[listed](chapters/1-one/listed.c) ![](figures/made.svg)' >README.md
defect "a picture of a data set without a text" figures/made.svg 'not in README.md'
echo '[listed](chapters/1-one/listed.c)' >README.md
defect "a picture of a data set that the README does not show" figures/made.svg 'not in README.md'
echo '![A set.](figures/made.svg)' >README.md
defect "a driver that the README no longer names" listed.c 'named in no chapter'
: >chapters/1-one/isted.c
defect "a driver whose name is the end of another" isted.c 'named in no chapter'

exit "$failed"
