# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Read a surface from a file of any format that the examples know."""

import os

import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {
    ".obj": vtkOBJReader,
    ".off": vtkdgg.vtkDGGOFFReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".vtk": vtkPolyDataReader,
    ".vtp": vtkXMLPolyDataReader,
}


class MeshFileError(Exception):
    """The file cannot be read as a surface; the text says why."""


def make_reader(path):
    """Reader for the file, chosen by its extension."""
    extension = os.path.splitext(path)[1].lower()
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
