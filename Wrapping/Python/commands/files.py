# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of contents of files: surfaces, curves and clouds."""

import argparse
import importlib.util
import os

import numpy as np

from .. import writing
from ..errors import missing_vtk
from ..mesh import Mesh
from ..surface import Surface


def kind_of(contents):
    """Returns the kind of a Mesh: a surface if there is any polygon."""
    if len(contents.polygons[0]) > 1:
        return "surface"
    return "curves" if len(contents.lines[0]) > 1 else "point cloud"


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
    """Returns the points of a Mesh alone, with their normals if there are any."""
    normals = Surface.of(contents).normals
    cloud = Mesh(contents.points, point_data={} if normals is None else {"Normals": normals})
    cloud._is_single = contents._is_single
    return cloud


def finite_points(contents, path):
    """Returns the Mesh, or only the finite points if some are not finite."""
    finite = are_finite(contents, path)
    return contents if finite.all() else Mesh(contents.points[finite])


def are_finite(contents, path):
    """Returns true for each finite point. A cloud without one is an error."""
    finite = np.isfinite(contents.points).all(axis=1)
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
    if writing.extension_of(path) in writing.VTK and importlib.util.find_spec("vtkmodules") is None:
        raise missing_vtk(f"{path}: writing this format")
    return path
