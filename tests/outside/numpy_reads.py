"""numpy_reads.py files|ragged|philox FOLDER .. -- NumPy reads NPY and CSV, and has the same random numbers.

files: each array is the same in both files, with the types and the shape that the set says.
ragged: arrays with rows of all samples are cut by the column of `counts` that has their name.
philox: FOLDER is a set of graphs of 100 nodes with the seed 7. The places of the nodes of sample i are
the uniform numbers of the key (seed 7, stream 5) and the counter (0, 0, i, field 1); NumPy adds 1 to its
counter before the first block."""

import csv
import glob
import sys

import numpy


def files(folder):
    names = glob.glob(folder + "/*/*.npy")
    assert names, "no files"
    for name in names:
        a = numpy.load(name, allow_pickle=False)
        b = numpy.loadtxt(name[:-3] + "csv", delimiter=",", skiprows=1, ndmin=2)
        assert a.dtype in (numpy.dtype("<f8"), numpy.dtype("<i8")) and a.flags.c_contiguous, name
        assert (a.reshape(-1, a.shape[-1]) == b[:, 2:]).all(), name
        if a.ndim == 3:
            samples = len(set(b[:, 0]))
            assert a.shape[:2] == (samples, len(b) // samples), name


def ragged(folder):
    with open(folder + "/counts/train-00000-of-00001.csv", newline="") as f:
        columns = next(csv.reader(f))[2:]
    counts = numpy.load(folder + "/counts/train-00000-of-00001.npy")
    cut = 0
    for name in columns:
        for path in glob.glob(f"{folder}/{name}/train-00000-of-00001.npy"):
            a = numpy.load(path)
            if a.ndim == 2:
                parts = numpy.split(a, numpy.cumsum(counts[:, 0, columns.index(name)])[:-1])
                b = numpy.loadtxt(path[:-3] + "csv", delimiter=",", skiprows=1, ndmin=2)
                for i, part in enumerate(parts):
                    assert (part == b[b[:, 0] == i, 2:]).all(), f"{path}: sample {i}"
                cut += 1
    assert cut > 0, "no ragged array"


def philox(folder):
    nodes = numpy.load(folder + "/nodes/train-00000-of-00001.npy")
    for i in range(len(nodes)):
        source = numpy.random.Philox(key=[7, 5], counter=(1 << 192) + (i << 128) - 1)
        assert (numpy.random.Generator(source).random((100, 2)) == nodes[i, :, :2]).all(), i


if __name__ == "__main__":
    for argument in sys.argv[2:]:
        {"files": files, "ragged": ragged, "philox": philox}[sys.argv[1]](argument)
