#!/bin/sh
# gen_set_test.sh -- data sets: the same bytes in any pieces, never mixed, checked by `gen verify`.
# Runs in the folder of the Makefile; BUILD is the folder of the programs.
set -u

# shellcheck source=tests/gen.inc
. tests/gen.inc
families=$("$gen" --help | awk '/^Families/ { on = 1; next } /^$/ { on = 0 } on { print $1 }')

# call ARGUMENT ... -- runs gen; its status is in $status, its words in out and err
call() {
    "$gen" "$@" >out 2>err
    status=$?
    cat out err >"$said"
}

# good NAME -- the last call went well, without a word on stderr
good() {
    [ "$status" = 0 ] && [ ! -s err ]
    result $? "set: $1"
}

# bad STATUS NAME TEXT -- the last call said TEXT, in one line on stderr, and nothing else
bad() {
    [ "$status" = "$1" ] && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] && grep -q -F -e "$3" err
    result $? "set: $2"
}

# faulty NAME TEXT -- verify names a defect with TEXT, and how many there are
faulty() {
    call verify "$1"
    [ "$status" = 1 ] && [ ! -s out ] && grep -q -F -e "$2" err && grep -q -E ' defects?$' err
    result $? "set: verify finds $2"
}

# same A B NAME -- two folders are the same to the byte
same() {
    diff -r "$1" "$2" >"$said" 2>&1
    result $? "set: $3"
}

# body FILE ... -- CSV files one behind the other, without their headers
body() {
    for file; do
        sed 1d "$file"
    done
}

# data FILE ... -- the numbers of NPY files one behind the other: the headers have 128 bytes
data() {
    for file; do
        tail -c +129 "$file"
    done
}

# --- every family: the same in one piece and in many ---
# pieces FAMILY -- 12 samples at once, in shards, and by a call for each range
pieces() {
    call "$1" --seed 7 --count 12 --out one
    good "$1: 12 samples at once"
    call "$1" --seed 7 --count 12 --shards 5 --out many
    good "$1: in 5 shards"
    call "$1" --seed 7 --count 4 --out low
    call "$1" --seed 7 --first 4 --count 8 --out high
    good "$1: in two calls"
    for array in one/*/train-00000-of-00001.csv; do
        array=$(basename "$(dirname "$array")")
        body one/"$array"/*.csv >wanted
        body many/"$array"/*.csv | cmp -s wanted - && body low/"$array"/*.csv high/"$array"/*.csv |
            cmp -s wanted - && data one/"$array"/*.npy >wanted &&
            data many/"$array"/*.npy | cmp -s wanted - &&
            data low/"$array"/*.npy high/"$array"/*.npy | cmp -s wanted -
        result $? "set: $1: $array is the same in any pieces"
    done
    call "$1" --seed 8 --count 12 --out other
    ! cmp -s one/SHA256SUMS other/SHA256SUMS
    result $? "set: $1: another seed, another set"
    rm -rf one many low high other
}

# worked FAMILY -- the call of its help makes a set that verify finds right
worked() {
    call "$1" --help
    # shellcheck disable=SC2046  # a list of words
    call $(sed -n 's/^  gen //p' out)
    good "$1: the call of its help"
    call verify "$1"
    good "$1: verify"
    if command -v sha256sum >/dev/null; then
        (cd "$1" && sha256sum -c --quiet SHA256SUMS) >"$said" 2>&1
        result $? "set: $1: sha256sum finds its sums right"
    fi
    if command -v python3 >/dev/null; then
        python3 -m json.tool "$1/datapackage.json" >"$said" 2>&1
        result $? "set: $1: datapackage.json is JSON"
    else
        echo "# skipped: there is no python3 to read the JSON"
    fi
    rm -rf "$1"
}

for family in $families; do
    pieces "$family"
    worked "$family"
done

# --- shards one by one, in any order, and by several processes ---
options='--seed 3 --count 25 --validation 5 --test 3 --shards 4 --format csv,npy,xml --controls 4-8'
# shellcheck disable=SC2086  # a list of words
call curve $options --out whole
good "4 shards of 3 splits"
for shard in 2 0 3 1; do
    # shellcheck disable=SC2086
    call curve $options --out parts --shard $shard
    good "shard $shard alone"
    if [ $shard = 0 ]; then
        call verify parts
        [ "$status" = 1 ] && grep -q 'shard 1 of 4 is missing' err &&
            grep -q 'shard 3 of 4 is missing' err
        result $? "set: verify names the missing shards"
    fi
done
# shellcheck disable=SC2086
call curve $options --out parts
good "the call without --shard completes the set"
same whole parts "the same, shard by shard"
# shellcheck disable=SC2086
call curve $options --out jobs --jobs 3
good "by 3 processes"
same whole jobs "the same, by 3 processes"
touch -d '2001-01-01' whole/points/train-00000-of-00004.npy
# shellcheck disable=SC2086
call curve $options --out whole
[ "$(find whole/points -name 'train-00000*.npy' -newermt '2002-01-01' | wc -l)" = 0 ]
result $? "set: a complete shard is left alone"
# killed between the two: the shard is done, and its other stamp is not yet removed
touch whole/shards/00001-of-00004.begun whole/shards/00004-of-00004.begun
# shellcheck disable=SC2086
call curve $options --out whole
[ "$status" = 0 ] && [ ! -e whole/shards/00001-of-00004.begun ] && [ ! -e whole/shards/00004-of-00004.begun ]
result $? "set: stamps of calls that were killed go away"
rm -rf parts jobs

# --- a folder of something else ---
mkdir mine
echo mine >mine/notes
call curve --count 1 --out mine
bad 1 "a folder of something else" 'mine is not empty and holds no set'
[ "$(ls mine)" = notes ]
result $? "set: it stays as it is"
cp -r whole kept
for other in '--seed 4 --count 25' '--seed 3 --count 26' '--seed 3 --count 25 --degree 2'; do
    # shellcheck disable=SC2086
    call curve $other --out kept
    bad 1 "the folder of another set: $other" 'kept holds another set: gen curve --seed 3'
done
same whole kept "it stays as it is"

# --- verify ---
faulty_file=kept/points/train-00001-of-00004.npy
printf X | dd of=$faulty_file bs=1 seek=200 conv=notrunc 2>/dev/null
faulty kept 'train-00001-of-00004.npy: its sum is not the one it was made with'
cp whole/points/train-00001-of-00004.npy $faulty_file
sed -i '$d' kept/points/train-00000-of-00004.csv
faulty kept 'train-00000-of-00004.csv: its sum is not'
rm kept/points/train-00000-of-00004.csv
faulty kept 'train-00000-of-00004.csv: No such file'
# shellcheck disable=SC2086
call curve $options --out kept
good "what was lost is made again"
same whole kept "the same again"
# the last sample for training in place of one for the test: the sums agree, the ranges do not
cp kept/counts/train-00000-of-00004.csv kept/counts/test-00003-of-00004.csv
faulty kept 'counts/test-00003-of-00004.csv: these are not the 1 samples from 24 on'
# shellcheck disable=SC2086
call curve $options --out kept
# shellcheck disable=SC2016  # sed's dollar
for lie in 1d 2d 3d '$d' '3s/^./x/' '1,2{h;d};3G' d; do
    cp whole/SHA256SUMS kept
    sed -i "$lie" kept/SHA256SUMS
    faulty kept 'SHA256SUMS: these are not the sums of the set'
done
rm kept/SHA256SUMS
faulty kept 'SHA256SUMS: No such file'
call verify mine
bad 1 "verify: no set" 'mine holds no set'
call verify
bad 2 "verify: no folder" 'needs the folder'
call verify whole kept
bad 2 "verify: two folders" 'needs the folder'
call verify whole
good "verify: a set that is right"
grep -q 'train 17, validation 5, test 3' out
result $? "set: verify counts"

# --- calls that are wrong ---
wrong() {
    text=$1
    shift
    call curve "$@"
    bad 2 "$*" "$text"
    [ ! -e new ]
    result $? "set: $*: nothing is made"
}
wrong 'needs --count' --out new
wrong 'needs --out' --count 1
wrong '--count is 0' --count 0 --out new
wrong '--count is `-1'"'" --count -1 --out new
wrong '--count is `ten'"'" --count ten --out new
wrong '--count is `1e3'"'" --count 1e3 --out new
wrong 'goes past 2^63' --first 9223372036854775807 --count 2 --out new
wrong '--first is 9223372036854775808, more than' --first 9223372036854775808 --count 1 --out new
wrong '--first is 99999999999999999999, more than' --first 99999999999999999999 --count 1 --out new
wrong '--seed is 18446744073709551616, more than' --seed 18446744073709551616 --count 1 --out new
wrong 'no option `--colour'"'" --count 1 --out new --colour red
wrong '--out has no value' --count 1 --out
wrong '--count is given twice' --count 1 --count 2 --out new
wrong 'are more than --count 5' --count 5 --validation 3 --test 3 --out new
wrong '--shard 4 of --shards 4' --count 5 --shards 4 --shard 4 --out new
wrong '--shards is 0' --count 5 --shards 0 --out new
wrong '--jobs is 0' --count 5 --jobs 0 --out new
wrong '--jobs share shards' --count 5 --shards 4 --jobs 2 --shard 1 --out new
wrong 'there are too few' --count 5 --shards 4 --jobs 5 --out new
wrong 'no format `hdf'"'" --count 5 --format csv,hdf --out new
wrong 'no format `'"'" --count 5 --format csv, --out new
wrong '--degree is 6, not within 1 .. 5' --count 5 --degree 6 --out new
wrong '--degree has `3.5'"'" --count 5 --degree 3.5 --out new
wrong '--noise has `nan'"'" --count 5 --noise nan --out new
wrong '--noise is -1, not within' --count 5 --noise -1 --out new
wrong '--law is `cubic'"'" --count 5 --law cubic --out new
wrong 'from more to less' --count 5 --points 8-4 --out new
wrong 'degree 3 needs 4 at least' --count 5 --controls 3 --out new
wrong 'both ends are 2 points' --count 5 --parameters pinned --points 1-4 --out new
call scatter --count 1 --voids 5 --out new
bad 2 "voids where there are none" 'only --sampling voids has some'
[ ! -e new ]
result $? "set: voids where there are none: nothing is made"

# Zero has one name and one set.
call classes --count 1 --points 2 --margin 0 --out zero
call classes --count 1 --points 2 --margin -0 --out minus
good "minus zero"
same zero minus "minus zero is zero"

# The last index there is.
call curve --first 9223372036854775807 --count 1 --out last
good "the last index"
grep -q '^9223372036854775807,0,' last/counts/train-00000-of-00001.csv
result $? "set: its number is in the file"
call curve --seed 18446744073709551615 --count 3 --shards 7 --out few
good "more shards than samples"
call verify few
good "verify: more shards than samples"

exit $failed
