#!/bin/sh
# sets_test.sh -- programs of others read the sets and find the same: NumPy, Octave, meshio, VTK,
# xmllint, jsonschema, sha256sum, and a reader of our own for splines in G+Smo's XML. What is not
# installed is skipped with a word. Each check is shown to fail on a file that somebody touched. Runs in
# the folder of the Makefile; BUILD is the folder of the programs; PYTHON may name a Python.
set -u

readme=$PWD/README.md
outside=$PWD/tests/outside
schema=$outside/datapackage.schema.json
python=${PYTHON:-/usr/bin/python3} # the one that Debian's packages are for
[ -x "$python" ] || python=python3
# shellcheck source=tests/gen.inc
. tests/gen.inc

# Is the command there, or the module of Python? If not, one word.
has() {
    command -v "$1" >"$said" || { echo "# skipped: there is no $1" && return 1; }
}
has_module() {
    "$python" -c "import $1" >"$said" 2>&1 || { echo "# skipped: there is no $1 for $python" && return 1; }
}

# holds NAME COMMAND ... -- the command ends well
holds() {
    name=$1
    shift
    "$@" >"$said" 2>&1
    result $? "outside: $name"
}

# fails NAME WORDS COMMAND ... -- the command says these words and ends badly
fails() {
    name=$1
    words=$2
    shift 2
    ! "$@" >"$said" 2>&1 && grep -q -e "$words" "$said"
    result $? "outside: $name"
}

# reads PROGRAM ARGUMENT ... -- a program in Python of this folder
reads() {
    program=$1
    shift
    "$python" -B "$outside/$program.py" "$@"
}

# make FOLDER OPTION ... -- a set in that folder
make() {
    folder=$1
    shift
    "$gen" "$@" --out "$folder" >"$said" 2>&1
    result $? "outside: gen $*"
}

make curve curve --count 4 --test 1 --controls 5-9 --points 5-9 --degree 4 --dim 3 --knots random \
    --format csv,npy,xml
make patch patch --count 2 --cells 3 --degree 3 --interior 20 --boundary 3 --noise 0.1 \
    --format csv,npy,ply,xml
make scatter scatter --count 3 --points 30 --format csv,npy,ply
make classes classes --count 3 --points 20
make signal signal --count 4
make graph graph --seed 7 --count 3
make mesh1 mesh --seed 1 --count 3 --dim 1 --cells 8 --kind diagonal --format csv,npy,xml,vtu
make mesh2 mesh --seed 1 --count 3 --dim 2 --cells 4 --format csv,npy,xml,vtu,mesh
make mesh3 mesh --seed 1 --count 2 --dim 3 --cells 4 --degree 1 --format csv,npy,xml,vtu
make thb1 thb --seed 1 --count 3 --dim 1 --cells 4 --kind diagonal --points 12 --format csv,npy,xml,vtu
make thb2 thb --seed 1 --count 3 --dim 2 --cells 4 --points 12 --format csv,npy,xml,vtu
make thb3 thb --seed 1 --count 1 --dim 3 --cells 3 --points 12 --format csv,npy,xml,vtu
make hb2 thb --seed 1 --count 2 --dim 2 --cells 4 --basis hb --degree 3 --points 12 --format csv,npy,xml,vtu
sets='curve patch scatter classes signal graph mesh1 mesh2 mesh3 thb1 thb2 thb3 hb2'

# --- sums and metadata ---
if has sha256sum; then
    for set in $sets; do
        holds "sha256sum: $set" sh -c "cd $set && sha256sum -c --quiet SHA256SUMS"
    done
fi
# told SET FROM TO -- a copy `told` of the set, its metadata changed
told() {
    rm -rf told && cp -r "$1" told && sed -i "s|$2|$3|" told/datapackage.json
}
if has "$python"; then
    # shellcheck disable=SC2086  # a list of words
    holds "Data Packages of all families" reads package_holds "$schema" $sets
    while IFS='|' read -r from to words; do
        told scatter "$from" "$to"
        fails "Data Package: not with $to" "$words" reads package_holds "$schema" told
    done <<END_OF_LIES
"bytes": 1|"bytes": 2|bytes
"sha256:.|"sha256:0|sum
"row", "type"|"line", "type"|key is no column
"noisy_z"|"z"|a column twice
"ply/train-0000000000000000000|"ply/train-0000000000000000009|No such file
"number"|"integer"|invalid literal
END_OF_LIES
    if has_module jsonschema; then
        while IFS='|' read -r from to words; do
            told scatter "$from" "$to"
            fails "JSON schema: not with $to" "$words" reads package_holds "$schema" told
        done <<END_OF_LIES
"resources":|"files":|required property
"path": "points/|"path": "../points/|does not match
"name": "knot|"name": "Knot|does not match
"name": "CC0-1.0", "path"|"title"|not valid under any
"type": "table", ||required property
"format": "npy"|"format": "exe"|is not one of
END_OF_LIES
    fi
fi

# --- NumPy ---
if has_module numpy; then
    # shellcheck disable=SC2086
    holds "NumPy reads all families" reads numpy_reads files $sets
    holds "NumPy cuts ragged arrays by counts" reads numpy_reads ragged curve mesh2 thb2
    holds "NumPy has the same random numbers" reads numpy_reads philox graph
    cp -r graph other
    printf 5 | dd of=other/nodes/train-00000-of-00001.npy bs=1 seek=133 conv=notrunc 2>/dev/null
    fails "NumPy finds another number in NPY" AssertionError reads numpy_reads files other
    fails "NumPy finds another random number" AssertionError reads numpy_reads philox other

    # The README's own call and its lines in Python.
    sed -n '/^    import numpy/,/^$/s/^    //p' "$readme" >load.py
    call=$(sed -n 's,^    build/bin/gen \(curve .*--out curves\)$,\1,p' "$readme")
    # shellcheck disable=SC2086  # a list of words
    [ -n "$call" ] && "$gen" $call && echo 'assert points.ndim == 3' >>load.py &&
        "$python" load.py >"$said" 2>&1
    result $? "outside: what the README loads is there"
fi

# --- Octave ---
if has octave-cli; then
    for table in curve/points curve/counts scatter/points graph/nodes thb2/coefficients mesh3/cells; do
        NAME=$table/train-00000-of-00001 octave-cli -q "$outside/octave_reads.m" >"$said" 2>&1
        result $? "outside: Octave reads $table"
    done
    rm -rf other
    cp -r graph other
    sed -i '2s/,0\./,0.5/' other/nodes/*.csv
    ! NAME=other/nodes/train-00000-of-00001 octave-cli -q "$outside/octave_reads.m" >"$said" 2>&1 &&
        grep -q '^error: ASSERT' "$said"
    result $? "outside: Octave finds another number"
fi

# --- VTU and PLY ---
rm -rf other
cp -r mesh2 other
for file in other/vtu/*; do
    awk '/Name="level"/ { getline line; print; print line + 1; next } { print }' "$file" >level && cp level "$file"
done
mkdir cut cut/vtu cut/cells
cp mesh2/cells/*.csv cut/cells
for file in mesh2/vtu/*; do
    sed '8d' "$file" >cut/vtu/"$(basename "$file")"
done
for library in meshio vtk; do
    has_module $library || continue
    holds "$library reads clouds" reads meshes_read $library patch scatter
    holds "$library reads meshes" reads meshes_read $library mesh1 mesh2 mesh3 thb1 thb2 thb3 hb2
    fails "$library finds another level" levels reads meshes_read $library other
    fails "$library finds a lost corner" Error reads meshes_read $library cut
done

# --- G+Smo's XML ---
if has xmllint; then
    grammar="xmllint --noout --relaxng $outside/gismo.rng"
    # shellcheck disable=SC2086
    holds "the grammar of G+Smo's XML" $grammar ./*/xml/*.xml "$outside/known_thb.xml"
    file=$(grep -l '<box' thb2/xml/*.xml | head -n 1)
    while IFS='|' read -r from to; do
        sed "s|$from|$to|" "$file" >wrong.xml
        # shellcheck disable=SC2086
        fails "the grammar of G+Smo's XML: not $to" 'fails to validate' $grammar wrong.xml
    done <<'END_OF_LIES'
<box level="1">\([0-9]*\) |<box level="1">
type="THBSpline2"|type="THBSpline"
index="1"|index="2"
geoDim="3"|geoDim="z"
 id="0"|
<box level="1">|<box level="0">
END_OF_LIES
fi
if has "$python"; then
    # known FILE WANTED -- the reader finds what G+Smo itself gives at (0.1, 0.2)
    known() {
        reads gismo_reads value "$1" 0.1 0.2 >"$said" 2>&1
        [ "$(tr '\n' ' ' <"$said")" = "$2 " ]
        result $? "outside: the reader agrees with G+Smo: $2"
    }
    known "$outside/known_thb.xml" 'functions 8 4 value 0.1 0.2 0.32'
    sed 's/THB/HB/' "$outside/known_thb.xml" >known.xml
    known known.xml 'functions 8 4 value 0.2 0.4 0.32'
    sed '/<coefs/,/<.coefs>/d; s/degree="1">0 0 0.5 1 1</degree="2">0 0 0 1 2 3 4 4 4</
        s/<box.*/<box level="1">2 2 6 6<\/box><box level="2">4 4 10 10<\/box>/' "$outside/known_thb.xml" >known.xml
    known known.xml 'functions 36 3 16'
    holds "G+Smo's XML has the points of curves and patches" reads gismo_reads points curve patch
    holds "G+Smo's XML has the points of hierarchies" reads gismo_reads points thb1 thb2 thb3 hb2
    holds "G+Smo's XML has the functions of meshes" reads gismo_reads counts mesh1 mesh2 mesh3 thb2 hb2
    rm -rf other
    cp -r thb2 other
    sed -i '/<coefs/,/<.coefs>/s/0\.[0-9]*$/0.5/' other/xml/*
    fails "another coefficient gives other points" ' off,' reads gismo_reads points other
    cp thb2/xml/* other/xml
    sed -i '/<box level="1">/{x;s/^/x/;/^x$/{x;d};x}' other/xml/*
    fails "a lost box gives other functions" 'functions,' reads gismo_reads counts other
    cp thb2/xml/* other/xml
    sed -i 's/THB/HB/' other/xml/*
    fails "the untruncated basis gives other points" ' off,' reads gismo_reads points other
fi

exit $failed
