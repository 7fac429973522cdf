"""meshes_read.py meshio|vtk FOLDER .. -- that library reads the VTU or PLY files of a set: the cells are as
many as the set says and of the right kind, each with its level; a mesh has its corners where the cell
is; a cloud has its points, for meshio with their parameters."""

import csv
import glob
import sys

KIND = {1: ("line", 3), 2: ("quad", 9), 3: ("hexahedron", 12)}  # in meshio, in VTK


def rows_of(folder, array, sample):
    with open(f"{folder}/{array}/train-00000-of-00001.csv", newline="") as f:
        return [row for row in csv.DictReader(f) if int(row["sample"]) == sample]


def read_meshio(path):
    """Points, kinds of the cells, their corners, levels, u and v."""
    import meshio
    mesh = meshio.read(path)
    cells = [block for block in mesh.cells if block.type != "vertex"]
    kinds = [block.type for block in cells for _ in block.data]
    corners = [list(cell) for block in cells for cell in block.data]
    levels = [int(x) for part in mesh.cell_data.get("level", []) for x in part]
    return mesh.points, kinds, corners, levels, [mesh.point_data.get(k) for k in "uv"]


def read_vtk(path):
    import vtk
    reader = vtk.vtkXMLUnstructuredGridReader() if path.endswith("vtu") else vtk.vtkPLYReader()
    failures = []
    reader.AddObserver("ErrorEvent", lambda *what: failures.append(what))
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    assert not failures and grid.GetNumberOfPoints() > 0, f"{path}: cannot be read"
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    kinds, corners = [], []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)  # the same object for each cell
        kinds.append(cell.GetCellType())
        corners.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
    levels = grid.GetCellData().GetArray("level")
    levels = levels and [int(levels.GetValue(i)) for i in range(levels.GetNumberOfTuples())]
    return points, kinds, corners, levels, [None, None]


def check_mesh(found, folder, sample, library):
    points, kinds, corners, levels, _ = found
    rows = rows_of(folder, "cells", sample)
    D = sum(name in rows[0] for name in ("c1", "c2", "c3"))
    assert levels == [int(row["level"]) for row in rows], "levels"
    assert kinds == [KIND[D][library == "vtk"]] * len(rows), "kinds of cells"
    assert len(points) == len(rows) * 2 ** D, "points"
    if glob.glob(folder + "/coefficients"):
        return  # a geometry: its corners are images
    cells = max((int(row["c1"]) + 1) / 2 ** int(row["level"]) for row in rows)  # of level 0
    for row, cell in zip(rows, corners):
        n = cells * 2 ** int(row["level"])
        low = [int(row[f"c{h + 1}"]) / n for h in range(D)]
        for k, point in enumerate(cell):  # around the lower face, then around the upper one
            high = [k % 4 in (1, 2), k % 4 >= 2, k >= 4]
            wanted = [low[h] + high[h] / n if h < D else 0 for h in range(3)]
            assert list(points[point]) == wanted, f"corner {k} of {row}"


def check_cloud(found, folder, sample, library):
    points, _, _, _, parameters = found
    rows = rows_of(folder, "points", sample)
    place = ["noisy_x", "noisy_y", "noisy_z"]
    if "x" not in rows[0]:
        place[:2] = "uv"  # a graph of a function lies over its parameters
    near = 2 ** -23 if library == "vtk" else 0  # VTK keeps single precision there
    assert len(points) == len(rows) > 0, "points"
    for i, row in enumerate(rows):
        for k in range(3):
            wanted = float(row[place[k]])
            assert abs(points[i][k] - wanted) <= near * abs(wanted), f"point {i}"
        for name, u in zip("uv", parameters):
            assert library == "vtk" or u[i] == float(row[name]), f"{name} of point {i}"


def main(library, folder):
    read = {"meshio": read_meshio, "vtk": read_vtk}[library]
    names = sorted(glob.glob(folder + "/vtu/train-*.vtu") + glob.glob(folder + "/ply/train-*.ply"))
    assert names, "no files"
    for name in names:
        check = check_mesh if name.endswith("vtu") else check_cloud
        check(read(name), folder, int(name[-23:-4]), library)


if __name__ == "__main__":
    for argument in sys.argv[2:]:
        main(sys.argv[1], argument)
