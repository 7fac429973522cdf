#!/bin/sh
# gen_run_test.sh -- a run of gen: memory that does not grow with the set, and a line of progress on
# a terminal alone. Runs in the folder of the Makefile; BUILD is the folder of the programs.
set -u

# shellcheck source=tests/gen.inc
. tests/gen.inc

# --- memory: that of the largest sample, however many there are ---
# bounded OPTIONS -- the call needs less than 64 MB, all of it counted
bounded() {
    # shellcheck disable=SC2086,SC3045
    (ulimit -v 62500 && exec "$gen" $1 --format npy --out bounded) >"$said" 2>&1
    result $? "run: in 64 MB: $1"
    rm -rf bounded
}
# shellcheck disable=SC3045  # a shell without it skips this
if (ulimit -v 62500 && "$gen" --version) >/dev/null 2>&1; then
    bounded 'scatter --count 2 --points 1000000'
    bounded 'curve --count 2 --points 100000 --dim 3'
    bounded 'curve --count 200000 --degree 1 --controls 2 --points 1 --noise 0'
else
    echo "# skipped: memory cannot be limited here, or a sanitizer needs more"
fi

# --- progress: on a terminal alone. The process is stopped for two seconds on its way ---
cat >slow <<'END'
"$1" patch --count 60 --out "$2" &
while [ ! -e "$2"/points/train-00000-of-00001.npy.tmp ] && kill -0 $!; do
    :
done
kill -STOP $!
sleep 2
kill -CONT $!
wait $!
END
sh slow "$gen" piped 2>&1 | cat >out &
if script --version 2>/dev/null | grep -q util-linux; then
    script -qec "sh slow '$gen' shown" /dev/null </dev/null >terminal
    status=$?
    tr '\r' '\n' <terminal | sed '/^$/d' >"$said"
    [ "$status" = 0 ] && [ "$(wc -l <"$said")" -ge 2 ] && tail -n 1 "$said" | grep -q '^gen: 100 %$' &&
        ! grep -q -v -E '^gen: [0-9]+ %$' "$said"
    result $? "run: a line of progress on a terminal"
else
    echo "# skipped: there is no script of util-linux to give a terminal"
fi
wait
cp out "$said"
[ ! -s out ] && [ -e piped/SHA256SUMS ]
result $? "run: no word of it in a pipe"

exit $failed
