#!/bin/sh
# gen_fault_test.sh -- whatever happens to gen, no file has its final name before it is whole, and the
# same call makes the set after all: killed at many moments, a full disk, files that may not grow, no
# rights. Runs in the folder of the Makefile; BUILD is the folder of the programs.
set -u

place=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$place"; rm -rf "$place"' EXIT
cp "${BUILD:-build}/bin/gen" "$place/gen"
gen=$place/gen # where other users find it
said=$place/said
# shellcheck source=tests/result.inc
. tests/result.inc
chmod 755 "$place"
cd "$place" || exit 1
options='--seed 3 --count 25 --validation 5 --test 3 --shards 4 --format csv,npy,xml --controls 4-8'

# call ARGUMENT ... -- runs gen, as nobody in particular if $as_nobody says how; its status is in
# $status, its words in out and err
as_nobody=
call() {
    $as_nobody "$gen" "$@" >out 2>err
    status=$?
    cat out err >"$said"
}

# good NAME -- the last call went well, without a word on stderr
good() {
    [ "$status" = 0 ] && [ ! -s err ]
    result $? "fault: $1"
}

# bad NAME TEXT -- the last call said TEXT, in one line on stderr, and nothing else
bad() {
    [ "$status" = 1 ] && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] && grep -q -F -e "$2" err
    result $? "fault: $1"
}

# same A B NAME -- two folders are the same to the byte
same() {
    diff -r "$1" "$2" >"$said" 2>&1
    result $? "fault: $3"
}

# wholesome FOLDER -- what stands under a final name is what stands there in the whole set
wholesome() {
    diff -rq "$1" whole | grep -v -e '^Only in whole' -e "^Only in $1.*\.tmp$" -e "^Only in $1.*\.begun$"
    [ $? = 1 ]
}

begun=$(date +%s%N)
# shellcheck disable=SC2086  # a list of words
call curve $options --out whole
ended=$(date +%s%N)
good "the whole set"

# --- killed at many moments of the time that the whole set took, and a little later ---
# cut_off K OPTION ... -- a call that is killed after K parts of 20 of that time
cut_off() {
    delay=$(awk "BEGIN { printf \"%.4f\", $1 * ($ended - $begun) / 2e10 }")
    shift
    timeout -s KILL "$delay" "$gen" curve "$@" --out killed >"$said" 2>&1
}
torn=0
cuts=0
for jobs in 1 2; do
    for k in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22; do
        rm -rf killed
        # shellcheck disable=SC2086
        cut_off $k $options --jobs $jobs
        [ -d killed ] && [ ! -e killed/SHA256SUMS ] && cuts=$((cuts + 1))
        [ ! -d killed ] || wholesome killed >>"$said" 2>&1 || torn=$((torn + 1))
    done
done
echo "# $cuts calls were cut off, $torn left a torn file" | tee "$said"
[ "$torn" = 0 ] && [ "$cuts" -gt 0 ]
result $? "fault: killed at any moment, no half file has its final name"
for k in 5 5 8 8 12; do
    # shellcheck disable=SC2086
    cut_off $k $options
done
# shellcheck disable=SC2086
call curve $options --out killed
good "begun again and again, completed at last"
same whole killed "the same after all, and nothing is left over"
rm -rf killed

# --- what somebody else is at work on ---
# held FILE COMMAND ... -- the command, while another process holds the lock on the file
held() {
    python3 -c '
import fcntl, subprocess, sys
f = open(sys.argv[1], "w")
fcntl.lockf(f, fcntl.LOCK_EX)
sys.exit(subprocess.call(sys.argv[2:], stdout=open("out", "w"), stderr=open("err", "w")))' "$@"
    status=$?
}
if command -v python3 >/dev/null; then
    cp -r whole shared
    rm shared/shards/00000-of-00004.done
    # shellcheck disable=SC2086
    held shared/shards/00000-of-00004.begun "$gen" curve $options --out shared --shard 0
    bad "a shard that another process makes" 'another process is at work on it'
    cp whole/shards/00000-of-00004.done shared/shards
    # shellcheck disable=SC2086
    held shared/shards/00004-of-00004.begun "$gen" curve $options --out shared
    bad "the files beside a set that another process writes" '00004-of-00004.begun: another process is at work on it'
    # shellcheck disable=SC2086
    call curve $options --out shared
    good "the other process has ended"
    same whole shared "the same after all, and no stamp is left"
fi

# --- the same call twice at the same time: both write the files beside the set ---
call curve --count 400 --points 2 --format xml --out twice
cp -r twice once
odd=0
for pause in 0 0 0 1 1 1 2 2 2 3; do
    "$gen" curve --count 400 --points 2 --format xml --out twice >out 2>&1 &
    sleep 0.00$pause
    "$gen" curve --count 400 --points 2 --format xml --out twice >err 2>&1 && wait $! &&
        diff -r once twice >"$said" 2>&1 || odd=$((odd + 1))
    wait
done
[ "$odd" = 0 ]
result $? "fault: two calls at the same time leave the set that one leaves"
rm -rf twice once

# --- no room ---
if [ -w /dev/full ]; then
    mkdir -p full/points full/shards
    ln -s /dev/full full/points/train-00000-of-00001.npy.tmp
    call curve --count 100 --out full
    bad "a full disk" 'cannot write full/points/train-00000-of-00001.npy: No space left'
    find full -type f ! -name '*.begun' >"$said"
    [ ! -s "$said" ]
    result $? "fault: a full disk leaves no file"
    call curve --count 100 --out full
    good "there is room again"
else
    echo "# skipped: there is no /dev/full here"
fi

# Files may not be longer than so many blocks of 512 bytes: the first that is fails, wherever it is.
ends=0
for blocks in 1 2 4 8 16 24; do
    rm -rf small
    # shellcheck disable=SC2086
    (trap '' XFSZ && ulimit -f $blocks && exec "$gen" curve $options --out small) >out 2>err
    status=$?
    cat out err >"$said"
    [ "$status" = 1 ] && [ ! -s out ] && grep -q 'cannot write .*: File too large' err &&
        wholesome small >>"$said" 2>&1 && ends=$((ends + 1))
done
[ "$ends" = 6 ]
result $? "fault: files that may not grow end the call with a message"
# shellcheck disable=SC2086
call curve $options --out small
good "they may again"
same whole small "the same after they may"

# A disk of a few pages, in a name space of its own, so that nothing is left of it.
mkdir disk
if unshare -m mount -t tmpfs none disk 2>"$said"; then
    for pages in 12 20 30 40 60 80 100; do
        rm -rf full_disk after
        # shellcheck disable=SC2016,SC2086  # for the other shell
        unshare -m sh -c '
            mount -t tmpfs -o size=$((4096 * $1)) none disk
            gen=$2
            shift 2
            "$gen" curve "$@" --out disk/set >out 2>err
            status=$?
            cp -r disk/set full_disk
            mount -o remount,size=16m disk && "$gen" curve "$@" --out disk/set >again 2>&1 &&
                cp -r disk/set after
            exit $status' sh "$pages" "$gen" $options
        status=$?
        cat out err >"$said"
        [ "$status" = 1 ] && [ ! -s out ] && grep -q ': No space left on device' err &&
            wholesome full_disk >>"$said" 2>&1
        result $? "fault: a disk of $pages pages is full"
        same whole after "room after $pages pages: the same"
    done
else
    echo "# skipped: a small disk: $(cat "$said")"
fi

# --- no rights ---
if [ "$(id -u)" = 0 ]; then
    as_nobody='setpriv --reuid 65534 --regid 65534 --clear-groups'
fi
if $as_nobody "$gen" --version >"$said" 2>&1; then
    mkdir locked theirs
    chmod 555 locked
    chmod 777 theirs
    call curve --count 1 --out locked
    bad "a read-only folder" 'cannot make the folder locked/shards: Permission denied'
    call curve --count 1 --out locked/deeper
    bad "a read-only parent" 'cannot make the folder locked/deeper: Permission denied'
    # shellcheck disable=SC2086
    call curve $options --out theirs/set
    good "a folder with rights"
    rm theirs/set/shards/00000-of-00004.done
    chmod 555 theirs/set/points
    # shellcheck disable=SC2086
    call curve $options --out theirs/set
    [ "$status" = 1 ] && [ ! -s out ] &&
        grep -q 'cannot write theirs/set/points/train-00000-of-00004.csv: Permission denied' err &&
        wholesome theirs/set >"$said" 2>&1
    result $? "fault: an array's folder is read-only; what was there stays"
    chmod 755 theirs/set/points
    chmod 000 theirs/set/points/train-00001-of-00004.npy
    call verify theirs/set
    grep -q 'theirs/set/points/train-00001-of-00004.npy: Permission denied' err
    result $? "fault: verify says what it may not read"
    chmod 644 theirs/set/points/train-00001-of-00004.npy
    # shellcheck disable=SC2086
    call curve $options --out theirs/set
    good "with rights again"
    same whole theirs/set "the same with rights"
else
    echo "# skipped: read-only folders: root may write into them, and there is no setpriv"
fi
as_nobody=

# --- something else in the place of a file or a folder ---
call curve --count 1 --out none/deeper
bad "no parent" 'cannot make the folder none/deeper: No such file or directory'
echo words >file
call curve --count 1 --out file
bad "a file in place of the folder" 'cannot make the folder file'
mkdir -p taken/shards taken/points/train-00000-of-00001.npy
call curve --count 1 --out taken
bad "a folder in place of a file" 'cannot write taken/points/train-00000-of-00001.npy: Is a directory'
[ ! -e taken/shards/00000-of-00001.done ]
result $? "fault: the shard is not complete then"

# --- a power failure: files of the right length that hold something else ---
cp -r whole dark
for file in points/train-00002-of-00004.npy knots/test-00001-of-00004.csv; do
    size=$(wc -c <"dark/$file")
    head -c "$size" /dev/zero >"dark/$file"
done
call verify dark
[ "$status" = 1 ] && [ "$(grep -c 'its sum is not the one it was made with' err)" = 2 ]
result $? "fault: verify names the files that hold zeros"
sed -n 's/^gen: \(.*\): its sum is not.*/\1/p' err | xargs rm
# shellcheck disable=SC2086
call curve $options --out dark
good "removed, they are made again"
same whole dark "the same after a power failure"

exit $failed
