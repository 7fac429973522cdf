#!/bin/sh
# input_test.sh -- bad input end to end: folders that are not there, a full disk, tools that
# are missing, a malformed plot. Each is said with its path, exits 1 and leaves no half of a
# file. Runs in the folder of the Makefile; BUILD is the folder of the programs.
set -u

build=${BUILD:-build}
root=$PWD
driver=$(cd "$build/bin" && pwd)/fig04
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/out
# shellcheck source=tests/result.inc
. tests/result.inc

# --- a driver that cannot write ---
# fails NAME PATH REASON -- the driver exits 1, names the path and the reason, and leaves no
# temporary; a driver writes relative to the folder where it runs
fails() {
    (cd "$place/run" && "$driver") >"$place/out" 2>&1
    status=$?
    [ "$status" = 1 ] && grep -F -e "$2" "$place/out" | grep -q -F -e "$3" &&
        [ -z "$(find "$place/run" -name '*.tmp')" ]
    result $? "input: $1"
}

# folders NAME ... -- an empty folder to run in, with these below $build
folders() {
    rm -rf "$place/run"
    mkdir -p "$place/run/$build"
    for name; do
        mkdir "$place/run/$build/$name"
    done
}

data=$build/data/fig04.dat report=$build/claims/fig04.tsv

check_driver() {
    folders
    fails "no folder for the data" "$data" 'No such file or directory'
    fails "no folder for the report" "$report" 'No such file or directory'
    [ -z "$(find "$place/run" -type f)" ]
    result $? "input: without folders no file is written"

    folders claims
    echo old >"$place/run/$build/data"
    fails "a file where the folder should be" "$data" 'Not a directory'
    [ "$(cat "$place/run/$build/data")" = old ]
    result $? "input: the file in the way is left alone"

    if [ -w /dev/full ]; then
        folders claims data
        echo old >"$place/run/$data"
        ln -s /dev/full "$place/run/$data.tmp"
        fails "a full disk for the data" "$data" 'No space left on device'
        [ "$(head -c 9 "$place/run/$data")" = old ]
        result $? "input: older data are left alone"

        folders claims data
        echo old >"$place/run/$report"
        ln -s /dev/full "$place/run/$report.tmp"
        fails "a full disk for the report" "$report" 'No space left on device'
        [ "$(head -c 9 "$place/run/$report")" = old ]
        result $? "input: an older report is left alone"
    else
        echo "# skipped: there is no /dev/full here"
    fi

    folders claims data
    (cd "$place/run" && "$driver") >"$place/out" 2>&1 &&
        [ -s "$place/run/$data" ] && [ -s "$place/run/$report" ] &&
        [ -z "$(find "$place/run" -name '*.tmp')" ]
    result $? "input: with folders the files are there"
}

case $build in
/*) echo "# skipped: the drivers write to $build wherever they run" ;;
*) check_driver ;;
esac

# --- drawing ---
# A folder with these tools alone, to be the whole PATH.
tools() {
    rm -rf "$place/path"
    mkdir "$place/path"
    for tool; do
        ln -s "$(command -v "$tool")" "$place/path/$tool"
    done
}

tools rm mv
echo 'plot data' >"$place/plot.gp"
echo '1 2' >"$place/plot.dat"
PATH=$place/path "$root/figures/draw.sh" "$place/plot.gp" "$place/plot.dat" "$place/plot.svg" \
    >"$place/out" 2>&1
status=$?
[ "$status" = 1 ] && [ "$(wc -l <"$place/out")" -eq 1 ] && grep -q 'make setup' "$place/out" &&
    [ ! -e "$place/plot.svg" ]
result $? "input: without gnuplot one line says what to run"

# malformed NAME SCRIPT -- the plot fails and names itself; no picture, an old one stays
malformed() {
    echo "$2" >"$place/bad.gp"
    rm -f "$place/new.svg"
    echo old >"$place/old.svg"
    for picture in new old; do
        figures/draw.sh "$place/bad.gp" "$place/plot.dat" "$place/$picture.svg" \
            >"$place/out" 2>&1
        status=$?
        [ "$status" = 1 ] && grep -q -F -e "$place/bad.gp" "$place/out" &&
            [ ! -e "$place/$picture.svg.tmp" ]
        result $? "input: $1 ($picture picture)"
    done
    [ ! -e "$place/new.svg" ] && [ "$(cat "$place/old.svg")" = old ]
    result $? "input: $1: no picture is made or changed"
}

if command -v gnuplot >/dev/null; then
    malformed "a plot of missing data" "plot '$place/missing.dat'"
    malformed "a plot that is no gnuplot" 'plot sin(x'
    malformed "a plot of a missing section" 'plot data index "missing" using 1:2'
    printf '1 2\n2 3\n' >"$place/plot.dat"
    figures/draw.sh "$place/plot.gp" "$place/plot.dat" "$place/plot.svg" >"$place/out" 2>&1 &&
        grep -q '</svg>' "$place/plot.svg" && [ ! -e "$place/plot.svg.tmp" ]
    result $? "input: a good plot is drawn"
else
    echo "# skipped: there is no gnuplot here"
fi

# --- installing ---
# stub NAME LINE -- a tool of our own
stub() {
    printf '#!/bin/sh\n%s\n' "$2" >"$place/path/$1"
    chmod +x "$place/path/$1"
}

# install STATUS TEXT NAME -- asks for two tools that are not there and one that is
install() {
    PATH=$place/path .ci/install tr:none no-such-tool:first,second no-other:third \
        >"$place/out" 2>&1
    status=$?
    [ "$status" = "$1" ] && grep -q -F -e "$2" "$place/out"
    result $? "input: $3"
}

tools tr
install 1 'missing: no-such-tool no-other' "without apt-get the missing tools are named"
stub id 'echo 1000'
stub apt-get 'echo apt-get "$@"'
install 1 'run as root: apt-get install first second third' "without sudo the command is shown"
stub sudo 'echo as root; "$@"'
install 0 'as root' "sudo is used where it is needed"
stub id 'echo 0'
install 0 'first second third' "root installs the packages"
! grep -q 'as root' "$place/out"
result $? "input: root needs no sudo"
stub apt-get 'echo broken; exit 100'
install 100 broken "what apt-get says is passed on"
PATH=$place/path .ci/install tr:none >"$place/out" 2>&1 && [ ! -s "$place/out" ]
result $? "input: nothing is installed when nothing is missing"

exit "$failed"
