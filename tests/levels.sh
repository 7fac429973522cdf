#!/bin/sh
# levels.sh [LIB] -- holds the order of the includes: lib/LEVELS gives every module its
# level, and a file of the library includes headers of its own level or below.
lib=${1:-lib}

awk -v lib="$lib" '
function module(path) {
    sub(/.*\//, "", path)
    sub(/\.[ch]$/, "", path)
    return path
}
function defect(text) {
    print "not ok - " text
    defects++
}
FILENAME == lib "/LEVELS" {
    if ($1 !~ /^#/)
        for (i = 2; i <= NF; i++)
            level[$i] = $1
    next
}
FNR == 1 && !(module(FILENAME) in level) {
    defect(FILENAME " has no level in " lib "/LEVELS")
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, part, "\"")
    here = module(FILENAME)
    there = module(part[2])
    if (!(there in level))
        defect(FILENAME " includes " part[2] ", which has no level in " lib "/LEVELS")
    else if (level[there] > level[here])
        defect(FILENAME " (level " level[here] ") includes " part[2] " (level " level[there] ")")
}
END {
    if (!defects)
        print "ok - includes go down the levels only"
    exit defects > 0
}' "$lib/LEVELS" "$lib"/*.[ch]
