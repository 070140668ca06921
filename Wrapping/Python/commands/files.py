# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of contents of files: surfaces, curves and clouds."""

import argparse
import os

import numpy as np
import vtkdgg
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from .. import arguments, writing
from ..surface import configured, coordinates_of


def triangles_of(contents, path):
    """Returns the triangles; polygons and strips are triangulated, lines and vertices removed."""
    triangulate = configured(vtkTriangleFilter(), InputData=contents, PassLines=False)
    mesh = vtkdgg.check(configured(triangulate, PassVerts=False))
    if mesh.GetNumberOfPolys() == 0:
        raise ValueError(f"{path}: contains no surface")
    return mesh


def kind_of(contents):
    """Returns the kind of contents: a surface if there is any polygon."""
    if contents.GetNumberOfPolys() + contents.GetNumberOfStrips() > 0:
        return "surface"
    return "curves" if contents.GetNumberOfLines() > 0 else "point cloud"


def is_cloud(contents):
    """Returns true if there are points without cells other than vertices. Curves are an error."""
    kind = kind_of(contents)
    if kind == "curves":
        raise ValueError("the file contains curves and no surface; --cloud uses the points only")
    return kind == "point cloud"


def refuse_on_clouds(options, *names):
    """Raises an error for options that only meshes have."""
    for name in names:
        if getattr(options, name, None) not in (None, False):
            raise ValueError(f"--{name} applies to meshes, not to point clouds")


def points_of(contents):
    """Returns the points alone, with their normals if there are any."""
    cloud = configured(vtkPolyData(), Points=contents.GetPoints())
    cloud.GetPointData().SetNormals(contents.GetPointData().GetNormals())
    return cloud


def make_graph(contents):
    """Returns the filter that builds the graph of these points."""
    if not hasattr(vtkdgg, "vtkPointCloudDGG"):
        raise ValueError("this vtkDGG has no graphs of point clouds: build it with DGG_WITH_PCL")
    return configured(vtkdgg.vtkPointCloudDGG(), InputData=contents)


def finite_points(contents, path):
    """Returns the contents, or only the finite points if some are not finite."""
    finite = are_finite(contents, path)
    return contents if finite.all() else arguments.polydata(coordinates_of(contents)[finite])


def are_finite(contents, path):
    """Returns true for each finite point. A cloud without one is an error."""
    finite = np.isfinite(coordinates_of(contents)).all(axis=1)
    if not finite.any():
        raise ValueError(f"{path}: none of its points is finite")
    return finite


def check_format(path, kind):
    """Raises an error if the format of the file does not hold this kind of writing.FORMATS."""
    extension = writing.extension_of(path)
    if extension not in writing.FORMATS[kind]:
        known = " ".join(writing.FORMATS[kind])
        name = repr(extension) if extension else "a file without extension"
        raise ValueError(f"{path}: {name} cannot store {kind}; expected {known}")


def writable(path, kind):
    """Returns the path of an output file of a kind of writing.FORMATS, after a check of both."""
    try:
        check_format(path, kind)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    folder = os.path.dirname(path)
    if folder and not os.path.isdir(folder):
        raise argparse.ArgumentTypeError(f"{path}: the folder {folder} does not exist")
    writing.check_writable(path)
    return path
