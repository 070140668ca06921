# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a file of the command line holds: a surface, curves or a cloud."""

import argparse

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from .. import arguments, writing


class MeshFileError(ValueError):
    """The file does not hold what a command needs; the text says why."""


def triangles_of(contents, path):
    """The triangles in it; polygons and strips are triangulated, lines and verts left out."""
    triangulate = vtkTriangleFilter()
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.SetInputData(contents)
    mesh = vtkdgg.check(triangulate)
    if mesh.GetNumberOfPolys() == 0:
        raise MeshFileError(f"{path}: holds no surface")
    return mesh


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


def finite_points(contents, path):
    """The contents, or where points are not finite the others alone."""
    points = vtk_to_numpy(contents.GetPoints().GetData())
    finite = np.isfinite(points).all(axis=1)
    if not finite.any():
        raise MeshFileError(f"{path}: none of its points is finite")
    return contents if finite.all() else arguments.polydata(points[finite].astype(float))


def writable(path, kind):
    """The path, after a check that its format holds an answer of the kind in writing.FORMATS."""
    extension = writing.extension_of(path)
    if extension not in writing.FORMATS[kind]:
        known = " ".join(writing.FORMATS[kind])
        name = repr(extension) if extension else "a file without extension"
        raise argparse.ArgumentTypeError(f"{path}: {name} cannot hold {kind}; expected {known}")
    return path


def names_of(data):
    """The names of the arrays that have one."""
    return list(filter(None, map(data.GetArrayName, range(data.GetNumberOfArrays()))))
