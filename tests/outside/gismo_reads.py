"""gismo_reads.py points|counts FOLDER ..
gismo_reads.py value FILE U .. -- a reader of G+Smo's XML of our own, in exact fractions.

It knows the format and the definitions, and nothing of lib/: a file gives the knots of level 0, boxes
in cells of their level, and coefficients level by level, direction 0 fastest. A function of level l is
active if its support lies in cells of level l and deeper, not all of them deeper (Kraft's selection).
A geometry is carried from level to level by inserting knots one by one [Boehm 1980]; where the basis
is truncated, what is carried to a function with its support in the next domain is dropped [Giannelli,
Juettler, Speleers 2012]. At the finest level it is a plain tensor-product spline.

points: each stored point is the value of its file at the stored parameters.
counts: each file of a mesh has as many functions on each level as the set says.
value: prints the functions of each level, and the value at U .. if there are coefficients."""

import csv
import glob
import itertools
import math
import sys
import xml.etree.ElementTree
from fractions import Fraction


def numbers(text):
    return [Fraction(float(word)) for word in text.split()]


class Spline:
    def __init__(self, path):
        root = xml.etree.ElementTree.parse(path).getroot()
        basis = root.find(".//Basis")
        self.truncated = basis.get("type").startswith("THB")
        directions = [b for b in basis.iter("Basis") if b.get("type") == "BSplineBasis"]
        self.degree = [int(b.find("KnotVector").get("degree")) for b in directions]
        self.knots = [[numbers(b.find("KnotVector").text) for b in directions]]  # of each level
        self.boxes = [(int(b.get("level")), [int(w) for w in b.text.split()])
                      for b in basis.findall("box")]
        self.levels = 1 + max([level for level, _ in self.boxes], default=0)
        for _ in range(1, self.levels):
            self.knots.append([with_middles(t) for t in self.knots[-1]])
        self.depth = self.table_of_depth()
        coefs = root.find(".//coefs")
        self.points = []
        if coefs is not None:
            dimension, all_numbers = int(coefs.get("geoDim")), numbers(coefs.text)
            self.points = [all_numbers[i:i + dimension] for i in range(0, len(all_numbers), dimension)]

    def table_of_depth(self):
        """How deep the boxes reach in each cell of the finest level."""
        cells = [range(len(set(t)) - 1) for t in self.knots[-1]]
        depth = {cell: 0 for cell in itertools.product(*cells)}
        for level, box in self.boxes:
            D, times = len(cells), 2 ** (self.levels - 1 - level)
            for cell in itertools.product(*[range(times * box[h], times * box[D + h]) for h in range(D)]):
                depth[cell] = max(depth[cell], level)
        return depth

    def functions(self, level):
        """All of a level, direction 0 fastest, each with the least depth on its support."""
        times, ranges = 2 ** (self.levels - 1 - level), []
        for d, t in zip(self.degree, self.knots[level]):
            place = {x: i for i, x in enumerate(sorted(set(t)))}
            ranges.append([range(times * place[t[j]], times * place[t[j + d + 1]])
                           for j in range(len(t) - d - 1)])
        for backwards in itertools.product(*[range(len(r)) for r in reversed(ranges)]):
            j = backwards[::-1]
            yield j, min(self.depth[c] for c in itertools.product(*[r[i] for r, i in zip(ranges, j)]))

    def active(self, level):
        return [j for j, least in self.functions(level) if least == level]

    def finest(self):
        """The coefficients of the geometry at the finest level, by multi-index."""
        grid, next_point = {}, iter(self.points)
        zero = [Fraction(0)] * len(self.points[0])
        for level in range(self.levels):
            if level > 0:
                for h in range(len(self.degree)):
                    grid = insert_all(grid, h, self.degree[h], self.knots[level - 1][h],
                                      self.knots[level][h])
            for j, least in self.functions(level):
                dropped = level == 0 or (self.truncated and least >= level)
                carried = zero if dropped else grid[j]
                own = next(next_point) if least == level else zero
                grid[j] = [a + b for a, b in zip(carried, own)]
        assert next(next_point, None) is None, "more coefficients than functions"
        return grid

    def value(self, grid, u):
        parts = [nonzero(d, t, x) for d, t, x in zip(self.degree, self.knots[-1], u)]
        sums = [Fraction(0)] * len(self.points[0])
        for choice in itertools.product(*parts):
            weight = math.prod(b for _, b in choice)
            for k, c in enumerate(grid[tuple(j for j, _ in choice)]):
                sums[k] += weight * c
        return sums

    def roundings(self):
        """Of a program that computes with doubles, as tests/meshes.h counts them, for a change of
        level and a product of univariate functions, and as often again for what comes to it."""
        change = sum(6 * d + 1 for d in self.degree)
        product = sum(5 * d + 1 for d in self.degree) + math.prod(d + 1 for d in self.degree) + 1
        return 2 * ((self.levels - 1) * change + product)

    def tolerance(self):
        """THB-splines add up to 1, HB-splines to no more than 1 on each level."""
        size = max(abs(c) for p in self.points for c in p)
        return self.roundings() * size * (1 if self.truncated else self.levels) / 2 ** 53


def with_middles(t):
    edges = sorted(set(t))
    return sorted(t + [(a + b) / 2 for a, b in zip(edges, edges[1:])])


def insert_all(grid, h, d, t, fine):
    """The same geometry with the knots `fine` in direction h, one knot after the other."""
    t = list(t)
    for x in [x for x in fine if x not in set(t)]:
        k = max(i for i in range(len(t) - 1) if t[i] <= x)
        rows = {}
        for j, c in grid.items():
            rows.setdefault(j[:h] + j[h + 1:], {})[j[h]] = c
        grid = {}
        for rest, row in rows.items():
            for i in range(len(t) - d):
                if i <= k - d:
                    new = row[i]
                elif i > k:
                    new = row[i - 1]
                else:
                    a = (x - t[i]) / (t[i + d] - t[i])
                    new = [a * p + (1 - a) * q for p, q in zip(row[i], row[i - 1])]
                grid[rest[:h] + (i,) + rest[h:]] = new
        t.insert(k + 1, x)
    return grid


def nonzero(d, t, x):
    """The B-splines that do not vanish at x, by the recursion of Cox and de Boor."""
    last = len(t) - d - 2
    span = max(j for j in range(d, last + 1) if t[j] <= x and t[j] < t[j + 1])
    b = {span: Fraction(1)}
    for e in range(1, d + 1):
        b = {j: (b.get(j, 0) and b[j] * (x - t[j]) / (t[j + e] - t[j])) +
                (b.get(j + 1, 0) and b[j + 1] * (t[j + e + 1] - x) / (t[j + e + 1] - t[j + 1]))
             for j in range(span - e, span + 1)}
    return list(b.items())


def rows_of(folder, array, sample):
    with open(f"{folder}/{array}/train-00000-of-00001.csv", newline="") as f:
        return [row[2:] for row in list(csv.reader(f))[1:] if int(row[0]) == sample]


def check_points(spline, folder, sample):
    grid, D, worst, rows = spline.finest(), len(spline.degree), 0, rows_of(folder, "points", sample)
    for row in rows:
        row = [Fraction(float(x)) for x in row]
        value = spline.value(grid, row[:D])
        worst = max([worst] + [abs(a - b) for a, b in zip(value, row[D:])])
    print(f"{folder} {sample}: {len(rows)} points, {float(worst):.2g} off, "
          f"{float(spline.tolerance()):.2g} allowed")
    assert rows and worst <= spline.tolerance()


def check_counts(spline, folder, sample):
    wanted = [int(row[2]) for row in rows_of(folder, "per_level", sample)]
    found = [len(spline.active(level)) for level in range(spline.levels)]
    print(f"{folder} {sample}: {found} functions, {wanted} wanted")
    assert sum(wanted) > 0 and found + [0] * (len(wanted) - len(found)) == wanted


def print_value(path, *u):
    spline = Spline(path)
    print("functions", *[len(spline.active(level)) for level in range(spline.levels)])
    if spline.points:
        value = spline.value(spline.finest(), [Fraction(x) for x in u])
        print("value", *[f"{float(x):g}" for x in value])


def check_all(what, folder):
    names = sorted(glob.glob(folder + "/xml/train-*.xml"))
    assert names, "no files"
    for name in names:
        what(Spline(name), folder, int(name[-23:-4]))


if __name__ == "__main__":
    if sys.argv[1] == "value":
        print_value(*sys.argv[2:])
    else:
        for argument in sys.argv[2:]:
            check_all({"points": check_points, "counts": check_counts}[sys.argv[1]], argument)
