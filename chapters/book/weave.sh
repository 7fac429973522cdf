#!/bin/sh
# weave.sh REPORTS PAGE -- weaves the lessons, the C, the figures and the ledger into one HTML
# file that needs nothing else. REPORTS is the folder of the drivers' reports. Runs in the folder
# of the Makefile. What refers to nothing stops it, with a line for each such place, and then
# PAGE is left as it was.
set -eu
export LC_ALL=C.UTF-8

[ $# = 2 ] || { echo "usage: weave.sh REPORTS PAGE" >&2; exit 2; }
reports=$1 page=$2
book=$(cd "$(dirname "$0")" && pwd)

command -v pandoc >/dev/null || { echo "pandoc is missing: make setup-book" >&2; exit 1; }
mkdir -p "$(dirname "$page")"
trap 'rm -f "$page.part"' EXIT
REPORTS=$reports pandoc --from=markdown --to=html5 --standalone --self-contained \
    --fail-if-warnings --mathml --toc --toc-depth=3 --template="$book/page.html" \
    --css="$book/page.css" --lua-filter="$book/book.lua" --citeproc \
    --bibliography=chapters/references.bib --metadata=link-citations \
    --output="$page.part" "$book/front.md"
mv "$page.part" "$page"
