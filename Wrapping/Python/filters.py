# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters with the arguments of functions, for the explorer and the comparison of methods. This
module imports VTK."""

import numpy as np

from vtkdgg import (
    vtkDGGDistance,
    vtkDGGFastMarchingDistance,
    vtkExactGeodesicDistance,
    vtkVirtualSourceGeodesicDistance,
)

from . import arguments, meshes
from .vtk_data import cells_of

#: Filters by the names of methods.
FILTERS = {
    "exact": vtkExactGeodesicDistance,
    "graph": vtkDGGDistance,
    "fast": vtkVirtualSourceGeodesicDistance,
    "marching": vtkDGGFastMarchingDistance,
}


def surface_point(value, name, polydata, is_cloud=False):
    """Returns one point of the surface of a vtkPolyData, as `SurfacePoints` of length 1."""
    surface, _ = meshes.take(polydata)
    return arguments.surface_point(value, name, surface, is_cloud)


def set_points(algorithm, name, points):
    """Sets `SurfacePoints` as ids or data of a filter. `name` is the prefix of its properties, such
    as "Source"."""
    are_ids = points.are_ids
    getattr(algorithm, f"Set{name}Ids")(points.point_ids.tolist() if are_ids else [])
    getattr(algorithm, f"Set{name}Data")(None if are_ids else points.polydata())


def set_pair(finder, start, end):
    """Sets the two points between which a filter finds a path."""
    pairs = start.interleaved(end).polydata()
    pairs.SetLines(cells_of(np.array([0, 2]), np.array([0, 1])))
    finder.SetPairData(pairs)


def set_merging(algorithm, is_merged, tolerance):
    """Sets how a filter merges points."""
    algorithm.SetMergeCoincidentPoints(is_merged)
    algorithm.SetMergeTolerance(tolerance)
