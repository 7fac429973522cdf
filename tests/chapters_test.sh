#!/bin/sh
# chapters_test.sh [CHAPTERS] -- what a chapter's text refers to is there: ledger ids,
# functions, figures, sources; every picture and every driver is shown in some lesson's text
# or in the README; and no number of two digits or more is typed by hand in a chapter.
#
# In a chapter.md
#   [id]{.ours} and [id]{.printed}               take a number from the ledger
#   [12]{.chosen}                                is a number that we chose
#   ::: {.code file="F" function="NAME"}         pulls in a function
#   ![](../../figures/NAME.svg)                  shows the figure of driver NAME
#   equation (12)                                is a number of the book's
#   [@key]                                       cites chapters/references.bib
chapters=${1:-chapters}
defects=0

defect() {
    echo "not ok - $1"
    defects=$((defects + 1))
}

for text in "$chapters"/*/chapter.md; do
    grep -oE '\[[^]@ ]+\]\{\.(ours|printed)\}' "$text" | while read -r claim; do
        id=${claim#?} id=${id%%]*}
        awk -F'\t' -v id="$id" '$1 == id { found = 1 } END { exit !found }' "$chapters/claims.tsv" ||
            echo "$text names claim $id, which is not in the ledger"
    done
    grep -oE 'file="[^"]+" function="[^"]+"' "$text" | while IFS='"' read -r _ file _ name _; do
        grep -qE "^[a-z].*\\b$name\\(" "$file" ||
            echo "$text pulls $name from $file, where it is not defined"
    done
    grep -oE '!\[[^]]*\]\([^)]*\)' "$text" | sed 's/.*(\(.*\))/\1/' | while read -r picture; do
        [ -f "$(dirname "$text")/$picture" ] || echo "$text shows $picture, which is not there"
    done
    grep -oE '@[a-z]+[0-9]{4}' "$text" | while read -r key; do
        grep -q "{${key#@}," "$chapters/references.bib" ||
            echo "$text cites ${key#@}, which is not in $chapters/references.bib"
    done
    # shellcheck disable=SC2016  # the dollars of formulas
    # what is left without code, math, attributes, references and links
    sed -e 's/`[^`]*`//g' -e 's/\$[^$]*\$//g' -e 's/\[[^]]*\]{[^}]*}//g' -e 's/\[@[^]]*\]//g' \
        -e 's/([^)]*\.svg)//g' -e 's/ER-[0-9]*//g' -e 's/equation ([0-9]*)//g' "$text" |
        grep -nE '(^|[^A-Za-z0-9_.])[0-9]{2,}' | sed "s|^|$text types a number by hand, line |"
done >"${TMPDIR:-/tmp}/chapters.$$"
while read -r line; do
    defect "$line"
done <"${TMPDIR:-/tmp}/chapters.$$"
rm -f "${TMPDIR:-/tmp}/chapters.$$"

for picture in figures/*.svg; do
    name=$(basename "$picture" .svg)
    [ "$(find "$chapters" -name "$name.c" | wc -l)" = 1 ] || defect "$picture has no driver $name.c"
    cat "$chapters"/*/chapter.md | grep -q "/$name.svg" || defect "$picture is in no chapter"
done
for plot in "$chapters"/*/*.gp; do
    name=$(basename "$plot" .gp)
    [ -f "figures/$name.svg" ] || defect "$plot has no committed figures/$name.svg"
done
[ "$defects" = 0 ] && echo "ok - the chapters refer to what is there"
[ "$defects" = 0 ]
