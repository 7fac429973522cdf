#!/bin/sh
# gen_readme_test.sh -- the README's calls make what it says: one set, one by several processes, one by
# GNU parallel and one by a Slurm array, which here is a loop that sets what Slurm sets. They are
# taken from the README as they stand, but for the folder and sizes: 4 shards of 40 samples. Runs in
# the folder of the Makefile; BUILD is the folder of the programs.
set -u

readme=$PWD/README.md
programs=$(cd "${BUILD:-build}/bin" && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/said
# shellcheck source=tests/result.inc
. tests/result.inc
cd "$place" || exit 1
mkdir build
ln -s "$programs" build/bin

# line PATTERN FOLDER -- the lines of code of the README that match, made small
line() {
    grep -e "^    .*$1" "$readme" |
        sed "s/^    //; s/--count 100000/--count 40/; s/--shards 64/--shards 4/; s/--jobs 8/--jobs 2/
             s/--out big/--out $2/; s/0-63/0-3/; s/seq 0 63/seq 0 3/"
}

# run NAME FILE -- bash finds the lines well written, and they go well
run() {
    bash -n "$2" >"$said" 2>&1 && [ -s "$2" ] && bash -e "$2" >"$said" 2>&1
    result $? "readme: $1"
}

line '--out curves$' curves >call
line 'gen verify curves' curves >>call
run "a set, and verify" call
line '--jobs' jobs >call
run "by several processes" call
[ -e jobs/SHA256SUMS ] && [ "$(find jobs/points -name 'train-*-of-00004.npy' | wc -l)" = 4 ]
result $? "readme: 4 shards, and the sums beside them"

# finish FOLDER NAME -- `the same call without --shard' completes the set, which is that of --jobs
finish() {
    line '--jobs' "$1" | sed 's/ --jobs 2//' >call
    [ ! -e "$1"/SHA256SUMS ] && [ "$(find "$1"/shards -name '*.done' | wc -l)" = 4 ]
    result $? "readme: $2: 4 shards are complete"
    run "$2: the same call without --shard" call
    diff -r jobs "$1" >"$said" 2>&1
    result $? "readme: $2: the same set"
}

line '#!/bin/sh\|#SBATCH\|SLURM_ARRAY_TASK_ID' slurm >job
tasks=$(sed -n 's/^#SBATCH --array=\([0-9]*\)-\([0-9]*\)$/\1 \2/p' job)
[ "$tasks" = '0 3' ] && [ "$(head -n 1 job)" = '#!/bin/sh' ] && [ "$(wc -l <job)" = 3 ]
result $? "readme: the Slurm array has a task for each shard"
for task in 2 0 3 1; do
    SLURM_ARRAY_TASK_ID=$task
    export SLURM_ARRAY_TASK_ID
    run "task $task of the Slurm array" job
done
finish slurm Slurm

if command -v parallel >/dev/null && parallel --version 2>/dev/null | grep -q '^GNU'; then
    HOME=$place # where it keeps its own notes
    export HOME
    line 'parallel --joblog' parallel >job
    sed 's/seq 0 3/seq 0 1/' job >half
    run "GNU parallel, two shards of four" half
    touch -d 2001-01-01 parallel/points/*.npy
    run "GNU parallel, with --resume" job
    [ "$(sed 1d log | wc -l)" = 4 ] && [ "$(find parallel/points -name '*.npy' ! -newermt 2002-01-01 | wc -l)" = 2 ]
    result $? "readme: GNU parallel goes on where it was"
    finish parallel "GNU parallel"
else
    echo "# skipped: there is no GNU parallel"
fi

exit $failed
