#!/bin/sh
# chapters_test.sh [CHAPTERS] -- what a chapter's text refers to is there: ledger ids,
# functions, pictures, sources. Every picture is in some chapter, with a caption, and one of a
# data set (gen/NAME.gp) in README.md, with a text in its place; every driver is
# named in a chapter or in README.md; and no number of two digits or more is typed by hand in
# a chapter; every label of an axis stands in the picture. Runs in the folder of README.md and figures/.
#
# In a chapter.md
#   [id]{.ours} and [id]{.printed}               take a number from the ledger
#   [id]{.no} and [id]{.none}                    say of ours in a word that it is zero
#   [12]{.chosen}                                is a number that we chose
#   ::: {.code file="F" function="NAME"}         pulls in a function
#   ![Caption.](../../figures/NAME.svg)          shows the figure of driver NAME
#   equation (12)                                is a number of the book's
#   [@key]                                       cites chapters/references.bib
set -u

chapters=${1:-chapters}
found=$(mktemp) || exit 1
trap 'rm -f "$found"' EXIT

# check_text TEXT -- a line for everything in this chapter that refers to nothing
check_text() {
    text=$1
    grep -oE '\[[^]@ ]+\]\{\.(ours|printed|none|no)\}' "$text" | while read -r claim; do
        id=${claim#?} id=${id%%]*}
        awk -F'\t' -v id="$id" '$1 == id { found = 1 } END { exit !found }' "$chapters/claims.tsv" ||
            echo "$text names claim $id, which is not in the ledger"
    done
    grep -oE 'file="[^"]+" function="[^"]+"' "$text" | while IFS='"' read -r _ file _ name _; do
        { [ -f "$file" ] && grep -qE "^[a-z].*\\b$name\\(" "$file"; } ||
            echo "$text pulls $name from $file, where it is not defined"
    done
    grep -oE '!\[[^]]*\]\([^)]*\)' "$text" | while read -r shown; do
        picture=${shown##*\(} picture=${picture%)}
        [ -f "$(dirname "$text")/$picture" ] || echo "$text shows $picture, which is not there"
        case $shown in
        '![]('*) echo "$text shows $picture without a caption" ;;
        esac
    done
    grep -oE '@[a-z]+[0-9]{4}' "$text" | while read -r key; do
        grep -q "{${key#@}," "$chapters/references.bib" ||
            echo "$text cites ${key#@}, which is not in $chapters/references.bib"
    done
    # shellcheck disable=SC2016  # the dollars of formulas
    # what is left without code, math, attributes, references and links
    sed -e 's/`[^`]*`//g' -e 's/\$[^$]*\$//g' -e 's/\[[^]]*\]{[^}]*}//g' -e 's/\[@[^]]*\]//g' \
        -e 's/([^)]*\.svg)//g' -e 's/ER-[0-9]*//g' -e 's/[Ee]quation ([0-9]*)//g' \
        -e 's/\(Figure\|Definition\|Remark\|figure\|definition\|remark\) [0-9][0-9]*//g' "$text" |
        grep -nE '(^|[^A-Za-z0-9_.])[0-9]{2,}' | sed "s|^|$text types a number by hand, line |"
}

# check_labels PLOT PICTURE -- a line for every axis whose label the picture lacks: gnuplot drops
# one that has no room, without a word. Looked for up to its first index, as in x_2.
check_labels() {
    grep -oE 'set [xyz]label "[^"]+"' "$1" | cut -d'"' -f2 | while read -r label; do
        grep -qF -e ">${label%%_*}<" "$2" || echo "$2 lacks the label '$label' of $1"
    done
}

# names NAME FILE ... -- is NAME.c or NAME.svg in one of the files?
names() {
    name=$1
    shift
    cat "$@" | grep -qE "(^|[^A-Za-z0-9_])$name\\.(c|svg)"
}

{
    for text in "$chapters"/*/chapter.md; do
        check_text "$text"
    done
    for picture in figures/*.svg; do
        name=$(basename "$picture" .svg)
        if [ -f "gen/$name.gp" ]; then
            grep -qE "!\\[[^]]+\\]\\(figures/$name\\.svg\\)" README.md ||
                echo "$picture is not in README.md, or without a text in its place"
            continue
        fi
        [ "$(find "$chapters" -name "$name.c" | wc -l)" = 1 ] ||
            echo "$picture has no driver $name.c"
        cat "$chapters"/*/chapter.md | grep -q "/$name\\.svg" || echo "$picture is in no chapter"
    done
    for plot in "$chapters"/*/*.gp; do
        name=$(basename "$plot" .gp)
        if [ -f "figures/$name.svg" ]; then
            check_labels "$plot" "figures/$name.svg"
        else
            echo "$plot has no committed figures/$name.svg"
        fi
    done
    for driver in "$chapters"/*/*.c; do
        name=$(basename "$driver" .c)
        names "$name" "$chapters"/*/chapter.md README.md ||
            echo "$driver is named in no chapter, nor in README.md"
    done
} >"$found"

sed 's/^/not ok - /' "$found"
[ -s "$found" ] && exit 1
echo "ok - the chapters refer to what is there"
