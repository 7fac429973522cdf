#!/bin/sh
# draw.sh PLOT DATA PICTURE -- lets gnuplot draw PICTURE, whole or not at all. Any word that
# gnuplot says is an error: it goes on after most of its warnings with half a picture.
set -eu

if ! command -v gnuplot >/dev/null; then
    echo "gnuplot is missing; run: make setup" >&2
    exit 1
fi
words=$(gnuplot -e "data = '$2'; image = '$3.tmp'" figures/style.gp "$1" 2>&1) || words="$words
gnuplot failed"
if [ -n "$words" ]; then
    rm -f "$3.tmp"
    echo "cannot draw $3 from $1: $words" >&2
    exit 1
fi
# A thin outline for the cells of a surface. gnuplot's own `border` writes a group a cell,
# four times the file.
if grep -q 'with pm3d' "$1"; then
    sed -i "s/<g stroke='none' shape-rendering='crispEdges'>/<g stroke='#505050' stroke-width='0.3' stroke-linejoin='round'>/" "$3.tmp"
fi
mv "$3.tmp" "$3"
