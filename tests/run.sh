#!/bin/sh
# run.sh LOG PROGRAM [ARGUMENT ...] -- runs a check and keeps what it prints in LOG. Its exit
# status must fit its results, 1 if there is a `not ok` and 0 if there is none; with any other
# one (a sanitizer's, a signal's, an early exit) the check was cut off.
log=$1
shift
"$@" >"$log" 2>&1
status=$?
bad=0
grep -q '^not ok - ' "$log" && bad=1
if [ "$status" != "$bad" ]; then
    echo "not ok - $1 ended with status $status" >>"$log"
fi
