# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surface points of a command line, and one to start with where none is given."""

import math

import numpy as np

from .. import arguments, meshes

#: Syntax of a surface point.
POINT = "ID|X,Y,Z|face:ID:B0,B1,B2"


def choose(text, contents, name="--source", only_ids=False):
    """Returns a point id (int), coordinates (list of 3 floats) or a pair (face, barycentric
    coordinates) for a text, and None for None.

    With `only_ids` other texts than point ids are an error.
    """
    if text is None:
        return None
    try:
        if only_ids:
            source = int(text)
        elif text.startswith("face:"):
            _, face, weights = text.split(":")
            source = int(face), [float(word) for word in weights.split(",")]
            if len(source[1]) != 3:
                raise ValueError
        elif "," not in text:
            source = int(text)
        else:
            source = [float(word) for word in text.split(",")]
            if len(source) != 3 or not all(math.isfinite(x) for x in source):
                raise ValueError
    except ValueError:
        known = "" if only_ids else ", X,Y,Z or face:ID:B0,B1,B2"
        raise ValueError(f"{name} {text or repr(text)}: expected a point id{known}") from None
    arguments.surface_point(source, f"{name} {text}", meshes.take(contents)[0])
    return source


def in_triangles(source, contents):
    """Returns the pair (face, barycentric coordinates) with the id in triangles_of()."""
    surface, _ = meshes.take(contents)
    offsets = surface.polygons[0][: source[0] - surface.first_polygon + 1]
    return int((np.diff(offsets) - 2).sum()), source[1]


def far_point(mesh):
    """Returns the id of the point of the largest component of a vtkPolyData that is farthest from
    the center."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter

    from ..pipeline import check
    from ..vtk_data import configured, coordinates_of, with_arrays

    numbered = with_arrays(mesh, {"Id": np.arange(mesh.GetNumberOfPoints())})
    largest = configured(vtkPolyDataConnectivityFilter(), InputData=numbered)
    largest.SetExtractionModeToLargestRegion()
    piece = check(largest)
    used = np.unique(vtk_to_numpy(piece.GetPolys().GetConnectivityArray()))
    used = vtk_to_numpy(piece.GetPointData().GetArray("Id"))[used]
    offset = coordinates_of(mesh)[used] - np.array(mesh.GetCenter())
    return int(used[np.argmax((offset * offset).sum(axis=1))])


def locate(mesh, source):
    """Returns the coordinates of a source on a vtkPolyData, and the corners of its triangle."""
    from ..vtk_data import closest_cell, locator_of

    if isinstance(source, int):
        return np.array(mesh.GetPoint(source)), [source]
    if isinstance(source, tuple):
        points = arguments.surface_point(source, "--source", meshes.take(mesh)[0])
        return points.positions()[0], points.corners()[0].tolist()
    return closest_cell(locator_of(mesh), source)
