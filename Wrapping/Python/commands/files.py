# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of surfaces and of point clouds, in any format that is known."""

import os

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

READERS = {
    ".obj": vtkOBJReader,
    ".off": vtkdgg.vtkDGGOFFReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".vtk": vtkPolyDataReader,
    ".vtp": vtkXMLPolyDataReader,
}
WRITERS = {
    ".obj": vtkOBJWriter,
    ".pcd": vtkdgg.vtkPCDWriter,
    ".ply": vtkPLYWriter,
    ".stl": vtkSTLWriter,
    ".vtk": vtkPolyDataWriter,
    ".vtp": vtkXMLPolyDataWriter,
}
# Those in which point clouds come as well.
EXTENSIONS = sorted([*READERS, ".pcd", ".xyz"])


class MeshFileError(Exception):
    """The file cannot be read as a surface; the text says why."""


def extension_of(path):
    """What names the format."""
    return os.path.splitext(path)[1].lower()


def make_reader(path):
    """Reader for the file, chosen by its extension."""
    extension = extension_of(path)
    if extension not in READERS:
        known = " ".join(sorted(READERS))
        raise MeshFileError(f"{path}: unknown extension '{extension}'; known are {known}")
    if not os.path.isfile(path):
        raise MeshFileError(f"{path}: no such file")
    reader = READERS[extension]()
    reader.SetFileName(path)
    return reader


def read_all(path, reader=None):
    """All that the file holds, by this reader or the one that its extension asks for."""
    try:
        return vtkdgg.check(reader or make_reader(path))
    except vtkdgg.VTKError as error:
        reason = " ".join(str(error).split())
        raise MeshFileError(f"{path}: cannot be read ({reason})") from None


def triangles_of(contents, path):
    """The triangles in it; polygons and strips are triangulated, lines and verts left out."""
    triangulate = vtkTriangleFilter()
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.SetInputData(contents)
    mesh = vtkdgg.check(triangulate)
    ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    if len(ids) > 0 and not 0 <= ids.min() <= ids.max() < mesh.GetNumberOfPoints():
        wrong = ids.min() if ids.min() < 0 else ids.max()
        last = mesh.GetNumberOfPoints() - 1
        raise MeshFileError(f"{path}: a cell names point {wrong}, but the last is {last}")
    if mesh.GetNumberOfPolys() == 0:
        raise MeshFileError(f"{path}: holds no surface")
    return mesh


def read(path):
    """All that the file holds, which is a point at least."""
    contents = _read(path)
    if contents.GetNumberOfPoints() == 0:
        raise MeshFileError(f"{path}: holds no points")
    return contents


def _read(path):
    extension = extension_of(path)
    if extension not in EXTENSIONS:
        known = " ".join(EXTENSIONS)
        raise MeshFileError(f"{path}: unknown extension '{extension}'; known are {known}")
    if not os.path.isfile(path):
        raise MeshFileError(f"{path}: no such file")
    if extension == ".xyz":
        return cloud_of(read_xyz(path))
    if extension == ".pcd":
        reader = vtkdgg.vtkPCDReader()
        reader.SetFileName(path)
        return read_all(path, reader)
    return read_all(path)


def kind_of(contents):
    """What these are: a surface, if there is any polygon."""
    if contents.GetNumberOfPolys() + contents.GetNumberOfStrips() > 0:
        return "surface"
    return "curves" if contents.GetNumberOfLines() > 0 else "point cloud"


def is_cloud(contents):
    """Whether these are points, and no cell but vertices uses them. Curves are an error."""
    kind = kind_of(contents)
    if kind == "curves":
        raise MeshFileError("the file holds curves and no surface; --cloud looks at points only")
    return kind == "point cloud"


def points_of(contents):
    """The points alone, with their normals if there are any."""
    cloud = vtkPolyData()
    cloud.SetPoints(contents.GetPoints())
    cloud.GetPointData().SetNormals(contents.GetPointData().GetNormals())
    return cloud


def make_graph(contents):
    """The filter that makes a graph of these points."""
    if not hasattr(vtkdgg, "vtkPointCloudDGG"):
        raise MeshFileError("this vtkDGG has no graphs of point clouds: build it with DGG_WITH_PCL")
    graph = vtkdgg.vtkPointCloudDGG()
    graph.SetInputData(contents)
    return graph


def cloud_of(points):
    """Points without cells."""
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(vtk_points)
    return cloud


def finite_points(contents, path):
    """The contents, or where points are not finite the others alone."""
    points = vtk_to_numpy(contents.GetPoints().GetData())
    finite = np.isfinite(points).all(axis=1)
    if not finite.any():
        raise MeshFileError(f"{path}: none of its points is finite")
    return contents if finite.all() else cloud_of(points[finite])


def read_xyz(path):
    """The points of a text file: the first three numbers of each line, of which there may be more.

    Blanks, commas or semicolons part the numbers; `#` and `//` start comments; the first line may
    be the number of points. VTK's vtkSimplePointsReader ends at the first `nan`, takes normals and
    colours for points, and rounds to float.
    """
    points = []
    may_be_count = True
    # Any byte is a character of this encoding: comments may be in any other one.
    with open(path, encoding="latin-1") as file:
        for number, line in enumerate(file, 1):
            for mark in ("#", "//"):
                line = line.split(mark, 1)[0]
            words = line.replace(",", " ").replace(";", " ").split()
            if not words or (may_be_count and len(words) == 1 and words[0].isdigit()):
                may_be_count = may_be_count and not words
                continue
            may_be_count = False
            try:
                point = [float(word) for word in words[:3]]
            except ValueError:
                point = []
            if len(point) != 3:
                shown = ascii(line.strip()[:40])
                raise MeshFileError(f"{path}: line {number}: {shown} does not start with X Y Z")
            points.append(point)
    return np.array(points, dtype=float).reshape(-1, 3)


def write_xyz(path, data):
    """The points as text, three numbers a line."""
    np.savetxt(path, vtk_to_numpy(data.GetPoints().GetData()), fmt="%.17g")


def write_off(path, data):
    """The points and polygons as text. VTK has no writer for it."""
    surface = triangles_of(data, path) if data.GetNumberOfStrips() > 0 else data
    polygons = surface.GetPolys()
    begins = vtk_to_numpy(polygons.GetOffsetsArray())[1:-1]
    corners = np.split(vtk_to_numpy(polygons.GetConnectivityArray()), begins)
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{surface.GetNumberOfPoints()} {polygons.GetNumberOfCells()} 0\n")
        np.savetxt(file, vtk_to_numpy(surface.GetPoints().GetData()), fmt="%.17g")
        for ids in corners if polygons.GetNumberOfCells() > 0 else ():
            file.write(f"{len(ids)} {' '.join(map(str, ids))}\n")


TEXT_WRITERS = {".off": write_off, ".xyz": write_xyz}
WRITABLE = sorted([*WRITERS, *TEXT_WRITERS])
# By what is written, the formats that hold it.
FORMATS = {
    "surface": WRITABLE,
    "curves": [".obj", ".vtk", ".vtp"],
    "point cloud": [extension for extension in WRITABLE if extension != ".stl"],
    "graph": [".vtk", ".vtp"],
    "matrix": [".csv", ".npy"],
    "picture": [".png"],
}


def writable(path, kind):
    """The path, whose format holds this kind."""
    extension = extension_of(path)
    if extension not in FORMATS[kind]:
        known = " ".join(FORMATS[kind])
        raise MeshFileError(f"{path}: cannot write '{extension}' ({kind}); known are {known}")
    return path


def names_of(data):
    """The names of the arrays that have one."""
    return list(filter(None, map(data.GetArrayName, range(data.GetNumberOfArrays()))))


def left_out(path, data):
    """The names of what the format of the file does not hold of the data."""
    extension = extension_of(path)
    if extension in (".vtk", ".vtp"):
        return []
    points = data.GetPointData()
    names = names_of(data.GetCellData())
    if extension != ".pcd":
        both = points.GetNormals(), points.GetTCoords()
        kept = [array.GetName() for array in both if array and extension in (".obj", ".ply")]
        names += [name for name in names_of(points) if name not in kept]
    is_surface = kind_of(data) == "surface"
    return ["polygons", *names] if is_surface and extension in (".pcd", ".xyz") else names


def write(path, data):
    """Write a file; its extension chooses the format."""
    extension = extension_of(writable(path, kind_of(data)))
    if extension in TEXT_WRITERS:
        TEXT_WRITERS[extension](path, data)
        return
    writer = WRITERS[extension]()
    if hasattr(writer, "SetFileTypeToBinary"):
        writer.SetFileTypeToBinary()  # exact, and VTK does not read every NaN in a text
    writer.SetFileName(path)
    writer.SetInputData(data)
    vtkdgg.check(writer)
