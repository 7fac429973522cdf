#!/bin/sh
# gen_peers_test.sh -- other programs read the sets and find the same: NumPy (files and random
# numbers) and meshio (meshes). What is not installed is skipped with a word. Runs in the
# folder of the Makefile; BUILD is the folder of the programs; PYTHON may name a Python.
# shellcheck disable=SC2016  # Python's text, on purpose
set -u

gen=$(cd "${BUILD:-build}/bin" && pwd)/gen
python=${PYTHON:-python3}
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/said
# shellcheck source=tests/result.inc
. tests/result.inc
cd "$place" || exit 1

# peer NAME MODULE PROGRAM -- the program in Python, which needs the module, ends well
peer() {
    if "$python" -c "import $2" >"$said" 2>&1; then
        "$python" -c "$3" >"$said" 2>&1
        result $? "peers: $1"
    else
        echo "# skipped: $1: no $2 for $python"
    fi
}

for family in curve patch scatter mesh thb classes signal graph; do
    "$gen" $family --seed 7 --count 5 --test 2 --out $family >"$said" 2>&1
    result $? "peers: gen $family"
done
"$gen" mesh --seed 7 --count 3 --dim 3 --cells 3 --format csv,vtu --out space >"$said" 2>&1
"$gen" thb --seed 7 --count 3 --kind front --format csv,vtu --out surface >"$said" 2>&1

peer "NumPy finds the same numbers in NPY and CSV" numpy '
import glob, numpy
names = glob.glob("*/*/*.npy")
assert len(names) > 60
for name in names:
    a = numpy.load(name)
    b = numpy.loadtxt(name[:-3] + "csv", delimiter=",", skiprows=1, ndmin=2)[:, 2:]
    assert (a.reshape(-1, a.shape[-1]) == b).all(), name'

# The places of the nodes of sample i: the key is (seed, stream of the family), the counter (0, 0,
# i, field 1). NumPy adds 1 to its counter before the first block.
peer "NumPy has the same random numbers" numpy '
import numpy
nodes = numpy.load("graph/nodes/train-00000-of-00001.npy")
for i in range(3):
    philox = numpy.random.Philox(key=[7, 5], counter=(1 << 192) + (i << 128) - 1)
    assert (numpy.random.Generator(philox).random((100, 2)) == nodes[i, :, :2]).all(), i'

peer "meshio reads meshes with their levels" meshio '
import csv, meshio
for folder, kind in (("space", "hexahedron"), ("surface", "quad")):
    rows = [row for row in csv.DictReader(open(folder + "/cells/train-00000-of-00001.csv"))]
    for i in range(3):
        mesh = meshio.read(folder + "/vtu/train-%019d.vtu" % i)
        wanted = [int(row["level"]) for row in rows if row["sample"] == str(i)]
        assert [block.type for block in mesh.cells] == [kind]
        assert list(mesh.cell_data["level"][0]) == wanted'

exit $failed
