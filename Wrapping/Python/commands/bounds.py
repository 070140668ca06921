# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bounds of geodesic distances, from methods that share no code with the filters."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

from ..vtk_data import configured, coordinates_of

# Relative rounding error of sums of many lengths.
TOLERANCE = 1e-9


def upper_bound(mesh, location, corners):
    """Returns the lengths of shortest paths along mesh edges (VTK's Dijkstra); infinity if
    unreached.

    From a source inside a triangle, paths start with a straight segment to a corner.
    """
    bound = np.full(mesh.GetNumberOfPoints(), np.inf)
    for corner in corners:
        dijkstra = configured(vtkDijkstraGraphGeodesicPath(), InputData=mesh)
        configured(dijkstra, StartVertex=corner, EndVertex=corner, StopWhenEndReached=False)
        dijkstra.Update()
        weights = vtkDoubleArray()
        dijkstra.GetCumulativeWeights(weights)
        along_edges = vtk_to_numpy(weights)
        to_corner = np.linalg.norm(np.array(mesh.GetPoint(corner)) - location)
        bound = np.minimum(bound, np.where(along_edges < 0, np.inf, to_corner + along_edges))
    return bound


def lower_bound(mesh, location):
    """Returns Euclidean distances."""
    return np.linalg.norm(coordinates_of(mesh) - location, axis=1)


def compare(distances, upper, lower):
    """Returns the number of compared points, the number of violations and the mean ratio for both
    bounds, over the reached points."""
    slack = TOLERANCE * np.nanmax(np.append(distances, 0.0))
    reached = np.isfinite(distances)
    result = {}
    for name, bound, broken in (
        ("upper", upper, distances > upper * (1 + TOLERANCE) + slack),
        ("lower", lower, distances < lower * (1 - TOLERANCE) - slack),
    ):
        known = reached & np.isfinite(bound)
        counted = known & (bound > 0)
        ratio = distances[counted] / bound[counted]
        result[name] = {
            "points": int(known.sum()),
            "violations": int((known & broken).sum()),
            "ratio": float(ratio.mean()) if ratio.size else 1.0,
        }
    # A point that edges reach must have a distance.
    result["upper"]["violations"] += int((~reached & np.isfinite(upper)).sum())
    return result
