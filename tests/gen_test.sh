#!/bin/sh
# gen_test.sh -- the program gen: counts and values that are known or follow by hand, the
# calls that its help shows, and what it says to a bad call or a bad file. Runs in the folder
# of the Makefile; BUILD is the folder of the programs.
set -u

gen=$(cd "${BUILD:-build}/bin" && pwd)/gen
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
failed=0

# result STATUS NAME -- prints what came out; what was said is in `out` and `err`
result() {
    if [ "$1" = 0 ]; then
        echo "ok - gen: $2"
    else
        echo "not ok - gen: $2"
        head -n 20 out err | sed 's/^/# /'
        failed=1
    fi
}

# call ARGUMENT ... -- runs gen; its status is in $status, its words are in out and err
call() {
    "$gen" "$@" >out 2>err
    status=$?
}

# good NAME -- the last call went well and silently
good() {
    [ "$status" = 0 ] && [ ! -s err ]
    result $? "$1"
}

# same NAME -- the last call went well and printed what stands on the standard input
same() {
    cat >wanted
    [ "$status" = 0 ] && [ ! -s err ] && cmp -s out wanted
    result $? "$1"
}

# bad STATUS NAME TEXT -- the last call said TEXT on stderr, in one line, and nothing else
bad() {
    [ "$status" = "$1" ] && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] && grep -q -F -e "$3" err
    result $? "$2"
}

# sums NAME BAD POINTS -- of every point p = 0 .. POINTS-1 the last column of out adds up to
# a sum s for which the awk condition BAD does not hold; size[p] is that of absolute values
sums() {
    awk -F, -v points="$3" 'NR > 1 { sum[$1] += $NF; size[$1] += $NF < 0 ? -$NF : $NF }
        END { for (p = 0; p < points; p++) { s = sum[p] + 0; if ('"$2"') exit 1 } }' out
    result $? "$1"
}

# ordered NAME -- the lines of out ascend by point, level and multi-index; no value is zero
ordered() {
    sed 1d out >body
    awk -F, '{ NF--; print }' body >keys
    sort -u -n -k 1,1 -k 2,2 -k 3,3 -k 4,4 -k 5,5 keys | cmp -s - keys &&
        awk -F, '$NF == 0 { exit 1 }' body
    result $? "$1"
}

# --- counts ---
cat >boxes.mesh <<'END'
degree 2 2
knots 0 0 0 1 2 3 4 4 4
knots 0 0 0 1 2 3 4 4 4
refine 0  1 1  3 3
refine 1  2 2  5 5
END
call count --mesh boxes.mesh
same "counts of two boxes" <<'END'
level,active_cells,functions
0,12,36
1,7,3
2,36,16
END

# Figure 9: the level-0 cells with i+j in {4,5}, and of them the level-1 cells with |i-j| <= 9
awk 'BEGIN {
    print "degree 2 2\nknots 0 0 0 1 2 3 4 5 6 7 8 8 8\nknots 0 0 0 1 2 3 4 5 6 7 8 8 8"
    for (i = 0; i < 8; i++)
        for (j = 0; j < 8; j++)
            if (i + j == 4 || i + j == 5)
                print "refine 0 ", i, j, " ", i + 1, j + 1
    for (i = 0; i < 16; i++)
        for (j = 0; j < 16; j++)
            if (i - j <= 9 && j - i <= 9)
                print "refine 1 ", i, j, " ", i + 1, j + 1
}' >band.mesh
call count --mesh band.mesh
awk -F, 'NR > 1 { print $3 }' out | tr '\n' ' ' | grep -q '^100 8 76 $'
result $? "functions of a band"

printf 'degree 0\r\nknots 0 1 3 # two cells\r\n' >plain.mesh
call count --mesh plain.mesh
printf 'level,active_cells,functions\n0,2,2\n' | same "counts where nothing is refined"

printf 'degree 1\nknots 0 0 1 1\nrefine 0 0 1\nrefine 1 0 2\n' >all.mesh
call count --mesh all.mesh
printf 'level,active_cells,functions\n0,0,0\n1,0,0\n2,4,5\n' | same "counts where all is refined"

# --- a short file that asks for too much ---
# grid D DEGREE CELLS [TO] -- a mesh of unit cells, open knots; the cells below TO are refined
grid() {
    awk -v D="$1" -v d="$2" -v n="$3" -v to="${4:-0}" 'BEGIN {
        knots = "knots"
        for (i = -d; i <= n + d; i++)
            knots = knots " " (i < 0 ? 0 : n < i ? n : i)
        for (h = 0; h < D; h++) {
            degree = degree " " d
            all = all knots "\n"
            low = low " 0"
            high = high " " to
        }
        printf "degree%s\n%s", degree, all
        if (to > 0)
            print "refine 0 " low " " high
    }'
}
printf 'x1,x2\n1,1\n' >one2.csv
printf 'x1,x2,x3\n1,1,1\n' >one3.csv
# heavy NAME TEXT D DEGREE CELLS [TO] -- neither counted nor evaluated, but refused with TEXT
heavy() {
    name=$1 text=$2
    shift 2
    grid "$@" >heavy.mesh
    call count --mesh heavy.mesh
    bad 1 "no counts: $name" "heavy.mesh$text"
    call reference --mesh heavy.mesh --at "one$1.csv" --basis thb
    bad 1 "no values: $name" "heavy.mesh$text"
}
heavy "all of 400^3 cells refined" ':5: with this box the levels would have 576000000 cells' 3 0 400 400
heavy "all of 200^3 cells refined" ':5: with this box the levels would have 72000000 cells' 3 2 200 200
heavy "8190^2 cells" ': its basis needs about 4.56e+09 bytes, more than 4.29e+09' 2 0 8190
heavy "degree 5 on 180^3 cells" ': its basis needs about 1.26e+09 steps, more than 1.07e+09' 3 5 180
grid 3 15 6 >heavy.mesh
call count --mesh heavy.mesh
printf 'level,active_cells,functions\n0,216,9261\n' | same "counts of degree 15 in space"
grid 3 15 20 >heavy.mesh
call reference --mesh heavy.mesh --at one3.csv --basis thb
bad 1 "no values: degree 15 in space" 'heavy.mesh: its basis needs about 1.34e+11 numbers, more than 3.44e+10'
grid 3 5 40 20 >heavy.mesh
call reference --mesh heavy.mesh --at one3.csv --basis thb
bad 1 "no values: coarser functions on many cells" 'heavy.mesh: its basis needs about'
# Of local^2 numbers a cell it would take 8.6e9 bytes, but nothing is carried from level to level.
grid 3 3 64 >cubic.mesh
call reference --mesh cubic.mesh --at one3.csv --basis thb
sums "values on 64^3 cells" 's < 1 - 1e-14 || s > 1 + 1e-14' 1
grid 3 3 20 8 >cubic.mesh
call reference --mesh cubic.mesh --at one3.csv --basis thb
sums "values on 20^3 cells, some refined" 's < 1 - 1e-14 || s > 1 + 1e-14' 1

# --- values by hand ---
# Degree 1 on [0,1], [1,2]; the right cell is halved. Level 0 keeps the hats at 0 and at 1;
# the hat at 2 lies in the refined part. Of level 1 the hats at 1.5 and 2 lie there (j = 3, 4).
# HB at 1.25: hat at 1 is 1 - 0.25, hat at 1.5 is 0.25/0.5. THB: the hat at 1 has the
# coefficient 1/2 at 1.5, which is cut off: 0.75 - 0.5 * 0.5. At 2 only j = 4 is left.
printf 'degree 1\nknots 0 0 1 2 2\nrefine 0  1  2\n' >hats.mesh
printf 'x1\n0\n0.25\n1\n1.25\n2\n' >hats.csv
call reference --mesh hats.mesh --at hats.csv --basis hb
same "HB hats" <<'END'
point,level,j1,value
0,0,0,1
1,0,0,0.75
1,0,1,0.25
2,0,1,1
3,0,1,0.75
3,1,3,0.5
4,1,4,1
END
call reference --mesh hats.mesh --at hats.csv --basis thb
same "THB hats" <<'END'
point,level,j1,value
0,0,0,1
1,0,0,0.75
1,0,1,0.25
2,0,1,1
3,0,1,0.5
3,1,3,0.5
4,1,4,1
END
# Slopes: of the hats -1 and 1 on [0,1]; at 1 and 1.25, from behind, -1/0.5 of the truncated
# hat and 1/0.5; at 2, from within, -2 and 2 of the last two.
call reference --mesh hats.mesh --at hats.csv --basis thb --derivative 1
same "slopes of THB hats" <<'END'
point,level,j1,value
0,0,0,-1
0,0,1,1
1,0,0,-1
1,0,1,1
2,0,1,-2
2,1,3,2
3,0,1,-2
3,1,3,2
4,1,3,-2
4,1,4,2
END
# Degree 2, one cell [0,1]^2: products of the Bernstein polynomials (1-x)^2, 2x(1-x), x^2; at
# (1/2, 1) they are 1/4, 1/2, 1/4 and 0, 0, 1. The derivative by x1 at (1/2, 1): -1, 0, 1.
printf 'degree 2 2\nknots 0 0 0 1 1 1\nknots 0 0 0 1 1 1\n' >cell.mesh
printf 'x1,x2\n0.5,1\n' >cell.csv
call reference --basis thb --at cell.csv --mesh cell.mesh
printf 'point,level,j1,j2,value\n0,0,0,2,0.25\n0,0,1,2,0.5\n0,0,2,2,0.25\n' |
    same "Bernstein polynomials at the right end"
call reference --basis thb --at cell.csv --mesh cell.mesh --derivative 1,0
printf 'point,level,j1,j2,value\n0,0,0,2,-1\n0,0,2,2,1\n' | same "their derivative"
call reference --basis hb --at cell.csv --mesh cell.mesh --derivative 0,3
printf 'point,level,j1,j2,value\n' | same "a derivative above the degree is zero"

# --- properties, D = 1, 2, 3; points on knots, at both ends, and between ---
{ sed 's/degree.*/degree 3/; s/knots 0/knots 0 0/; s/4$/4 4/' boxes.mesh |
    sed '3d; s/^refine \(.\)  \(.\) .  \(.\) ./refine \1  \2  \3/'; } >line.mesh
cat >space.mesh <<'END'
degree 1 2 3
knots 0 0 1 2 2
knots 0 0 0 1 1 2 2 2
knots -3 -2 -1 0 1 2 3 4 5
refine 0  0 0 0  1 2 2
refine 0  1 1 1  2 2 2
refine 1  0 1 1  2 4 4
END
awk 'BEGIN { print "x1"; for (i = 0; i <= 16; i++) print i / 4 }' >line.csv
awk 'BEGIN { print "x1,x2"; for (i = 0; i <= 16; i++) for (j = 0; j <= 16; j++)
    print i / 4 "," j / 4 }' >boxes.csv
awk 'BEGIN { print "x1,x2,x3"; for (i = 0; i <= 6; i++) for (j = 0; j <= 6; j++)
    for (k = 0; k <= 6; k++) print i / 3 "," j / 3 "," k / 3 }' >space.csv
# Values are promised to 1e-14. Derivatives are held to 1e-13 of the sum of their absolute values:
# each comes from at most 3 (6d + 1) + 3 (5d + 1) + 64 < 200 roundings (tests/meshes.h), 2.2e-14 of its
# terms; the rest is room for terms four times as large as what they leave.
orders=1
for name in line boxes space; do
    points=$(($(wc -l <$name.csv) - 1))
    call reference --mesh $name.mesh --at $name.csv --basis thb
    good "THB in $name.mesh"
    ordered "order of lines in $name.mesh"
    sums "THB add up to 1 in $name.mesh" 's < 1 - 1e-14 || s > 1 + 1e-14' "$points"
    awk -F, 'NR > 1 && $NF < 0 { exit 1 }' out
    result $? "THB are not negative in $name.mesh"
    call reference --mesh $name.mesh --at $name.csv --basis thb --derivative $orders
    ordered "order of derivatives in $name.mesh"
    sums "derivatives add up to 0 in $name.mesh" \
        'size[p] == 0 || s * s > 1e-26 * size[p] * size[p]' "$points"
    call reference --mesh $name.mesh --at $name.csv --basis hb
    ordered "order of HB in $name.mesh"
    sums "HB add up to 1 or more in $name.mesh" 's < 1 - 1e-14' "$points"
    awk -F, '{ sum[$1] += $NF } END { for (p in sum) if (sum[p] > 1.01) exit 0; exit 1 }' out
    result $? "HB add up to more than 1 somewhere in $name.mesh"
    orders=$orders,0
done

sed 's/$/\r/' boxes.csv >crlf.csv
printf '4,4' | cat boxes.csv - >open.csv
call reference --mesh boxes.mesh --at boxes.csv --basis thb
mv out before
call reference --mesh boxes.mesh --at crlf.csv --basis thb
same "lines may end with CRLF" <before
call reference --mesh boxes.mesh --at open.csv --basis thb
[ "$(sed -n '$s/,.*,/,/p' out)" = 289,1 ]
result $? "the last line needs no end"
echo 'x1,x2' >none.csv
call reference --mesh boxes.mesh --at none.csv --basis hb
echo 'point,level,j1,j2,value' | same "no points, no values"

# --- help and version ---
call --version
[ "$(cat out)" = "knotwork-gen $(sed 's/.* //' out)" ]
good "--version"
call --help
grep -q 'gen count' out && grep -q 'gen reference' out
good "--help names the commands"
# example COMMAND FILES -- the indented blocks of `gen COMMAND --help` behind "For example"
# are these files, and the last block is what the call above it prints
example() {
    call "$1" --help
    mv out help
    awk -v files="$2 wanted" '
        /^For example/ { split(files, file, " "); example = 1; n = 1 }
        example && /^  / { sub(/^  /, ""); print >file[n]; block = 1; next }
        example && /^gen / { print >"call" }
        block && !/^$/ { n++; block = 0 }' help
    # shellcheck disable=SC2046  # a list of words
    call $(sed 's/^gen //; s/ prints$//' call)
    mv wanted printed
    same "the example of gen $1 --help" <printed
}
example count boxes.mesh
example reference 'hats.mesh points.csv'

# --- bad calls ---
call
bad 2 "no command" 'no command'
call paint
bad 2 "an unknown command" '`paint'"'"
call --mesh boxes.mesh
bad 2 "an option before the command" '`--mesh'"'"
call --version now
bad 2 "a word behind --version" '`now'"'"
call count
bad 2 "a missing option" 'needs --mesh'
call count boxes.mesh
bad 2 "a file without an option" '`boxes.mesh'"'"
call count --mesh
bad 2 "an option without a value" '--mesh has no value'
call count --mesh boxes.mesh --mesh boxes.mesh
bad 2 "an option twice" '--mesh is given twice'
call count --mesh boxes.mesh --basis thb
bad 2 "an option of another command" '`--basis'"'"
call reference --mesh --at boxes.csv --basis thb
bad 2 "an option in place of a value" '--mesh has no value'
call reference --mesh boxes.mesh --basis thb
bad 2 "no points" 'needs --at'
call reference --mesh boxes.mesh --at boxes.csv
bad 2 "no basis" 'needs --basis'
call reference --mesh boxes.mesh --at boxes.csv --basis nurbs
bad 2 "an unknown basis" '`nurbs'"'"
for orders in 1 1,2,3 1,-1 -1,1 a,b 1.5,0 '1,' ',1' ' 1,1' 1,1x 99999999999999999999,0 ''; do
    call reference --mesh boxes.mesh --at boxes.csv --basis thb --derivative "$orders"
    bad 2 "orders of derivatives: $orders" "\`$orders'"
done

# --- bad files ---
call count --mesh none.mesh
bad 1 "a mesh that is not there" 'none.mesh: No such file or directory'
call count --mesh .
bad 1 "a folder for a mesh" '.: Is a directory'
echo 'refine 0  0 0  5 1' | cat boxes.mesh - >wide.mesh
call count --mesh wide.mesh
bad 1 "a mesh with a cell outside" 'wide.mesh:6: cell 4 of direction 0'
: >empty.mesh
call reference --mesh empty.mesh --at boxes.csv --basis thb
bad 1 "an empty mesh" 'empty.mesh: no '
{ echo 'degree 31 31 31' && awk 'BEGIN { for (h = 0; h < 3; h++) { printf "knots"
    for (i = 0; i < 64; i++) printf " %d", (i >= 32)
    print "" } }'; } >high.mesh
call count --mesh high.mesh
bad 1 "degrees too high" '32768 functions on a cell'

# points NAME TEXT LINES -- the points LINES (as printf prints them) are refused with TEXT
points() {
    # shellcheck disable=SC2059  # a format on purpose
    printf "$3" >points.csv
    call reference --mesh boxes.mesh --at points.csv --basis thb
    bad 1 "points: $1" "points.csv:$2"
}
points "an empty file" '1: the file is empty' ''
points "no header" '1: the first line is `0,0'"', not \`x1,x2'" '0,0\n'
points "a header of one column" '1: the first line is `x1'"'" 'x1\n0\n'
points "an empty line" '3: `'"' has 0 columns, not 2" 'x1,x2\n0,0\n\n'
points "one column" '2: `0.5'"' has 1 columns, not 2" 'x1,x2\n0.5\n'
points "three columns" '2: `0,0,0'"' has 3 columns, not 2" 'x1,x2\n0,0,0\n'
points "an empty column" '2: x2 is `'"', which is no number" 'x1,x2\n0,\n'
points "a blank behind a comma" '2: x2 is ` '"', which is no number" 'x1,x2\n0.5, \n'
points "a blank before a comma" '2: x1 is ` '"', which is no number" 'x1,x2\n ,0\n'
points "a tab" '3: x2 is `	'"', which is no number" 'x1,x2\n0,0\n0,\t\n'
points "a word" '4: x1 is `a'"', which is no number" 'x1,x2\n0,0\n1,1\na,0\n'
points "a number with more behind it" '2: x2 is `1e'"', which is no number" 'x1,x2\n0,1e\n'
points "a hexadecimal number" '2: x1 is `0x1'"', which is no number" 'x1,x2\n0x1,1\n'
points "a NaN" '2: x1 is `nan'"', which is not finite" 'x1,x2\nnan,0\n'
points "an infinity" '2: x2 is `-inf'"', which is not finite" 'x1,x2\n0,-inf\n'
points "a number that is too large" '2: x2 is `1e999'"', which is not finite" 'x1,x2\n0,1e999\n'
points "left of the domain" '2: x1 is -1e-300, outside the domain [0, 4]' 'x1,x2\n-1e-300,0\n'
points "behind the domain" '3: x2 is 4.1, outside the domain [0, 4]' 'x1,x2\n4,4\n0,4.1\n'
points "a zero byte" '2: a zero byte' 'x1,x2\n0\0000,0\n'
points "a very long line" '2: more than 1000 characters' "x1,x2\n0,%02000d\n"
points "a very long header" '1: more than 1000 characters' "%02000d"
printf 'x1\n \n' >blank.csv
call reference --mesh hats.mesh --at blank.csv --basis thb
bad 1 "points: a blank line" 'blank.csv:2: x1 is ` '"', which is no number"
printf 'x1,x2\n 0.5 ,\t1\t\n' >blank.csv
call reference --mesh cell.mesh --at blank.csv --basis thb
printf 'point,level,j1,j2,value\n0,0,0,2,0.25\n0,0,1,2,0.5\n0,0,2,2,0.25\n' |
    same "blanks around numbers"
call reference --mesh boxes.mesh --at . --basis thb
bad 1 "a folder for points" '.: Is a directory'
call reference --mesh boxes.mesh --at none --basis thb
bad 1 "points that are not there" 'none: No such file or directory'

# Degree 2 on a cell of length 1e-200: its second derivatives have the size 1e400.
printf 'degree 2\nknots 0 0 0 1e-200 1e-200 1e-200\n' >tiny.mesh
printf 'x1\n0\n' >tiny.csv
call reference --mesh tiny.mesh --at tiny.csv --basis thb --derivative 2
bad 1 "a derivative that no number holds" 'tiny.csv: point 0: a value is not finite'

# --- output ---
# full NAME ARGUMENT ... -- on a full disk gen says so
full() {
    name=$1
    shift
    "$gen" "$@" 2>err >/dev/full
    status=$?
    : >out
    bad 1 "$name" 'cannot write to the standard output: No space left on device'
}
if [ -w /dev/full ]; then
    full "a full disk" count --mesh boxes.mesh
    full "a full disk for much" reference --mesh boxes.mesh --at boxes.csv --basis thb
    full "a full disk for the help" --help
else
    echo "# skipped: there is no /dev/full here"
fi

exit $failed
