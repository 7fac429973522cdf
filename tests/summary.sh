#!/bin/sh
# summary.sh LOG ... -- shows what failed in the logs of the checks and counts them all. A log
# without a single result is a failure too.
passed=0 failed=0
for log; do
    ok=$(grep -c '^ok - ' "$log") bad=$(grep -c '^not ok - ' "$log")
    if [ $((ok + bad)) = 0 ]; then
        echo "not ok - $log holds no result"
        cat "$log"
        bad=1
    elif [ "$bad" -gt 0 ]; then
        echo "$log:"
        grep -v '^ok - ' "$log" | grep -v '^# claim '
    fi
    passed=$((passed + ok)) failed=$((failed + bad))
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
