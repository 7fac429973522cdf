#!/bin/sh
# weave_test.sh -- weaving stops when it should: a small good book is woven, twice to the same
# bytes, and with one thing broken at a time it stops with one line that names the place and the
# defect, and leaves the old page alone.
set -u

root=$(cd "$(dirname "$0")/../.." && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/out
# shellcheck source=tests/result.inc
. "$root/tests/result.inc"
cd "$place" || exit 1

note="for a < b, beta_{j,k} .. (x-1)_+^2 in kw_mesh_new, bs.tau 3u^3 <= 2^-53, w . P +-1 on 8 x 9, the book's (-3/4)"

blank=$(printf '\342\200\257') # narrow, does not break

# claim ID KIND PRINTED OURS WHERE -- a line of the ledger
claim() {
    printf '%s\t%s\t%s\t%s\t0\t%s\t%s\n' "$1" "$2" "$3" "$4" "$5" "$note" >>chapters/claims.tsv
}

good() {
    rm -rf chapters lib figures tests reports CITATION.cff
    mkdir -p chapters/1-one lib figures tests reports
    ln -s "$root/chapters/book" chapters/book
    cp "$root/chapters/references.bib" chapters
    cp "$root/CITATION.cff" .
    claim bs.fig4.pieces count - 4 'Fig 4'
    claim tp.fig6.functions count 72 72 'Text 1'
    claim a.off count 63 72 'Def 3'
    claim a.large count 1234567 -20000 'Text 1'
    claim a.same count 56 56 'Eq 10'
    claim a.zero count - 0 'Text 1'
    claim a.none none - - 'Rem 5'
    claim a.real real - 0.70710678118654752 'Text 1'
    claim a.small max - -4.8e-15 'Text 1'
    claim a.range range 487049.58 0..1.5 'Text 1'
    printf '# Errata\n\n## ER-09. A typo\n\n- Place: here, t_{n+1} = .. = t_{n+k},\n  a -> b\n- Ledger: a.off\n- Shown by: ex_one\n' \
        >chapters/ERRATA.md
    printf 'Def 3 3\nRem 5 5\nEq 10 10\nFig 4 4\n' >tests/items.txt
    cat >chapters/1-one/fig04.c <<'END_OF_C'
/* Figure 4 -- A thing.

   What to see: it is
   there, if a < b.

   Book: section 1.
   Chosen here: the thing. */
int main(void)
{
    return 0;
}
END_OF_C
    sed 's/Figure 4/Example/; s/Chosen here.*/*\//' chapters/1-one/fig04.c >chapters/1-one/ex_one.c
    printf 'bs.fig4.pieces\t4\n' >reports/fig04.tsv
    printf '%s\t1\n' tp.fig6.functions a.off a.same a.zero a.real a.small a.range >reports/ex_one.tsv
    cat >lib/twice.c <<'END_OF_C'
int twice(int a);

/* Twice a,
   by a sum. */
int twice(int a)
{
    return a + a;
}

int thrice(int a)
{
    return twice(a) + a;
}
END_OF_C
    echo '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>' >figures/fig04.svg
    cat >chapters/1-one/chapter.md <<'END_OF_TEXT'
# One

## What the section shows

There are [a.off]{.ours} of them, not [a.off]{.printed} (ER-09), in [12]{.chosen} cells [@farin2002].
See Definition 3, Remark 5, equation (10) and Figure 4, and `ex_one.c`; [a.real]{.ours}, [a.small]{.ours}, [a.range]{.ours}.

::: {.code file="lib/twice.c" function="twice"}
:::

![What is seen.](../../figures/fig04.svg)

Then $\ell x^{10}$, by `f(100)`, has [a.zero]{.no} exceptions (THB-splines).

| two | columns |
|-----|---------|
| and | a long line of their source, which would make the table as wide as the page is |

## Exercise: two

::: {.answer}
Two.
:::
END_OF_TEXT
}

# edit FILE SCRIPT -- sed in place
edit() {
    sed "$2" "$1" >edited
    cmp -s "$1" edited && echo "not ok - weave: nothing to edit in $1: $2"
    cat edited >"$1"
}

text=chapters/1-one/chapter.md

weave() {
    chapters/book/weave.sh reports "$1" >out 2>&1
}

# has NAME TEXT -- the woven page holds the text
has() {
    tr '\n' ' ' <page.html | grep -qF -e "$2"
    result $? "weave: $1"
}

# lacks NAME TEXT -- the woven page does not hold the text
lacks() {
    ! tr '\n' ' ' <page.html | grep -qF -e "$2"
    result $? "weave: $1"
}

# defect NAME PLACE TEXT -- weaving stops with one line that holds both texts
defect() {
    echo old >page.html
    weave page.html
    status=$?
    [ "$status" != 0 ] && [ "$(cat page.html)" = old ] && [ "$(ls page.html*)" = page.html ] &&
        [ "$(grep -c '^weave: ' out)" = 1 ] && grep -F -e "$2" out | grep -qF -e "$3"
    result $? "weave: stops at $1"
    good
}

good
weave page.html && weave again.html && cmp page.html again.html >out
result $? "weave: a good book is woven, twice to the same bytes"
has "a number of ours" '<a class="ours" href="#claim-a.off" title="a.off: computed by ex_one">72</a>'
has "a number that is printed" '<a class="printed" href="#claim-a.off" title="a.off: printed in the book">63</a>'
has "a word for a zero" '<a class="ours" href="#claim-a.zero" title="a.zero: computed by ex_one">no</a> exceptions'
has "a long number is cut" '>0.7071</a>'
has "a small number has a power of ten" '>−4.8·10<sup>−15</sup></a>'
has "large numbers in groups of three" "count: <b>−20${blank}000</b>; printed 1${blank}234${blank}567."
has "a long number above ten thousand is whole" "printed 487${blank}050"
has "a range" '>0 to 1.5</a>'
has "a function with its comment and its lines" '<code>twice</code>, <a href="#lib/twice.c">lib/twice.c</a>, lines 3 to 8<'
lacks "no other function" 'id="cb2"'
has "a whole program" 'id="lib/twice.c"><summary>lib/twice.c <span class="size">13 lines</span></summary><pre><code>int twice(int a);'
has "a figure with its title, caption and what to see" 'it is there, if a &lt; b.'
has "a reference" '<a href="#ER-09">ER-09</a>'
has "an equation" '<a href="#Eq-10">equation (10)</a>'
has "a formula with its comma" '<span class="together"><math'
has "a word with a hyphen" '<span class="together">(THB-splines).</span>'
has "the letter l is a letter" '<mi>ℓ</mi>'
lacks "a table of a fixed width" '<col '
has "how large a lesson is" '<a href="#one">One</a></th><td>2</td><td>22</td><td>8</td><td>1</td>'
has "how large a program is" 'fig04.c <span class="size">11 lines, 1 claim</span>'
has "a source" 'id="ref-farin2002"'
has "an answer that is folded" '<details class="answer">'
has "a verdict: corrected" '<td class="corrected">corrected: <a href="#ER-09">ER-09</a></td>'
has "a verdict: reproduced" '<td class="reproduced">reproduced</td>'
has "a verdict: under a stated reading" '<td class="reproduced">reproduced under a stated reading</td>'
has "a verdict: not computable" '<td class="not"><a href="#claim-a.none">not computable</a></td>'
has "a note in symbols" 'for a &lt; b, β<sub>j,k</sub> … (x-1)<sub>+</sub><sup>2</sup> in kw_mesh_new, bs.tau 3u<sup>3</sup> ≤ 2<sup>−53</sup>, w · P ±1 on 8 × 9, '"the book’s (−3/4)"
has "an erratum in symbols" 'here, t<sub>n+1</sub> = … = t<sub>n+k</sub>, a → b'
has "an erratum's claims" 'Ledger: <a href="#claim-a.off">a.off</a>'
lacks "no script" '<script'
lacks "no file but itself" 'src="figures'

edit $text 's/a.off]{.ours/a.of]{.ours/'
defect "a claim that is not in the ledger" "$text" 'claim a.of,'
edit $text 's/a.real]{.ours/a.real]{.printed/'
defect "a printed number that the book does not print" "$text" 'printed number of claim a.real'
edit $text 's/a.real]{.ours/a.none]{.ours/'
defect "a number of a claim that is not computed" "$text" 'ours number of claim a.none'
edit reports/ex_one.tsv '/a.real/d'
defect "a number that no driver reports" "$text" 'claim a.real, which no driver reports'
edit $text 's/12]{.chosen/12]{.choosen/'
defect "a mark that is not known" "$text" 'unknown class choosen'
edit $text 's/^Then/::: {.anwser}\nTwo.\n:::\n\n&/'
defect "a block that is not known" "$text" 'unknown class anwser'
edit $text 's/\[12\]{.chosen}/12/'
defect "a number that is typed by hand" "$text, What the section shows" 'types a number by hand: 12'
edit $text 's/\[a.zero\]{.no}/[a.same]{.no}/'
defect "a word for a number that is not zero" "$text" "says \`no' of claim a.same, which is 56"
# shellcheck disable=SC2016  # the dollars of formulas
edit $text 's/\$.*\$/$x = 12.5$/'
defect "a formula that ends in a number" "$text" 'in a formula: x = 12.5'
# shellcheck disable=SC2016
edit $text 's/\$.*\$/$10^{-3}$/'
defect "a formula that is a number" "$text" 'in a formula: 10^{-3}'
edit $text 's/^## Exercise: two/## An exercise/'
defect "a lesson without an exercise" "$text" 'lacks what every lesson has: exercise'
mkdir chapters/2-two
sed 's/^# One/# Two/; s/^## Exercise: two/## Exercise: three/' $text >chapters/2-two/chapter.md
defect "two lessons with the same heading" chapters/2-two "What the section shows', as has $text"
edit $text 's/What is seen/What 144 cells are/'
defect "a number in a caption" "$text" 'types a number by hand: 144'
edit $text 's/12]{.chosen} cells/12]{.chosen} *cells (of 3.14)*/'
defect "a decimal number in italics" "$text" '3.14'
edit $text 's/^## What/## The 25/'
defect "a number in a heading" "$text" 'types a number by hand: 25'
edit $text 's/"twice"/"four"/'
defect "a function that is not defined" "$text" 'four is not defined in lib/twice.c'
edit lib/twice.c '/^int thrice/,/^}/d'
edit $text 's/"twice"/"thrice"/'
defect "a function that is called and not defined" "$text" 'thrice is not defined'
edit $text 's/twice.c"/none.c"/'
defect "a function from a file that is not there" "$text" 'lib/none.c is not there'
edit $text 's/fig04.svg/fig05.svg/'
defect "a figure that no driver draws" "$text" 'fig05.svg, which is the figure of no driver'
edit $text 's/!\[[^]]*\]/![]/'
defect "a figure without a caption" "$text" 'fig04 without a caption'
edit chapters/1-one/fig04.c 's/What to see/See/'
defect "a figure whose driver does not say what to see" fig04.c 'what to see'
edit $text 's/ex_one.c/ex_two.c/'
defect "a program that is not there" "$text" 'names ex_two.c'
cp lib/twice.c chapters/1-one/twice.c
printf '' >reports/twice.tsv
edit $text 's/ex_one.c/twice.c/'
weave page.html
result $? "weave: of two files with one name the driver is meant"
good
: >lib/same.h
: >chapters/1-one/same.h
edit $text 's/ex_one.c/same.h/'
defect "a name that two files have" "$text" 'names same.h'
edit $text 's/ER-09/ER-08/'
defect "an erratum that is not there" "$text" 'names ER-08'
edit $text 's/ Remark 5,//'
defect "an item of the book that no lesson explains" chapters 'Rem 5 of the book is explained in no lesson'
edit chapters/ERRATA.md 's/here/*here*/'
defect "accidental italics in the errata" chapters/ERRATA.md 'here'
edit chapters/ERRATA.md "s/here/\`here' and \`there'/"
defect "quotes that are code by accident in the errata" chapters/ERRATA.md "here' and"
edit chapters/ERRATA.md "s/here/the \`name \`here\`'/"
defect "code in quotes in the errata" chapters/ERRATA.md 'name '
edit tests/items.txt 's/Fig 4 4/Fig 4 5/'
edit $text 's/Figure 4/Figures 4 and 5/'
defect "an item without a line in the ledger" tests/items.txt 'Fig 5 has no line'

# what pandoc itself finds has lines of its own
# stops NAME TEXT
stops() {
    echo old >page.html
    ! weave page.html && [ "$(cat page.html)" = old ] && grep -qF -e "$2" out
    result $? "weave: stops at $1"
    good
}
edit $text 's/farin2002/nobody1999/'
stops "a source that is not listed" nobody1999
rm figures/fig04.svg
stops "a picture that is not there" figures/fig04.svg
rm reports/ex_one.tsv
stops "a report that is not there" reports/ex_one.tsv
rm chapters/claims.tsv
stops "a ledger that is not there" chapters/claims.tsv
chapters/book/weave.sh >out 2>&1
[ $? = 2 ] && grep -q '^usage: weave.sh ' out
result $? "weave: without arguments it shows its usage"

exit "$failed"
