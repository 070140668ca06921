# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph in the field data of a surface, as vtkDiscreteGeodesicGraph documents it."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import arguments

ARRAYS = ("Offsets", "Targets", "Lengths", "Angles", "ArrivalAngles", "Info")
# By the numbers in DGG.Info: those of vtkDiscreteGeodesicGraph, then those of vtkPointCloudDGG.
MESH_CONSTRUCTIONS = ("Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph")
SCHEMES = ("A", "B", "C")
CONSTRUCTIONS = (*MESH_CONSTRUCTIONS, *SCHEMES)
_FIRST_SCHEME = len(MESH_CONSTRUCTIONS)
_VERSION = 1
_SIZE = 12


def damaged(what):
    """Returns the error for a graph that has been altered."""
    return ValueError(
        f"the graph on the mesh is damaged: {what}; give an `accuracy` to build another one"
    )


def has_graph(polydata):
    """Returns true if there are arrays of a graph, which may be damaged."""
    return any(polydata.GetFieldData().HasArray(f"DGG.{name}") for name in ARRAYS)


class GraphInfo:
    """Parameters that a graph was built with.

    Attributes
    ----------
    construction : int
        Index into CONSTRUCTIONS.
    is_cloud : bool
        True for the graph of a point cloud.
    accuracy : float or None
        None for a SaddleVertexGraph; of a cloud, the accuracy of pruning, 0 without.
    number_of_neighbors : int
        Number of nearest points of a SaddleVertexGraph, otherwise 0.
    is_merged : bool
        True if coincident points were merged.
    merge_tolerance : float
        Largest distance of merged points, as a fraction of the diagonal.
    """

    def __init__(self, polydata):
        array = polydata.GetFieldData().GetArray("DGG.Info")
        if array is None:
            raise ValueError(
                "polydata: there is no graph in its field data; take the output of "
                "vtkDiscreteGeodesicGraph"
            )
        values = vtk_to_numpy(array)
        if values.dtype != np.int64 or values.shape != (_SIZE,) or values[0] != _VERSION:
            raise ValueError(
                "polydata: its graph has a DGG.Info of another version, or is damaged; rebuild it "
                "with vtkDiscreteGeodesicGraph"
            )
        if values[1] not in (0, 1):
            raise damaged(f"its kind is {values[1]}; expected that of a mesh or a cloud")
        self.is_cloud = bool(values[1])
        known = range(_FIRST_SCHEME, len(CONSTRUCTIONS)) if self.is_cloud else range(_FIRST_SCHEME)
        if values[2] not in known:
            raise damaged(f"its construction is {values[2]}")
        self.construction = int(values[2])
        has_accuracy = CONSTRUCTIONS[self.construction] != "SaddleVertexGraph"
        self.accuracy = float(values[3:4].view(np.float64)[0]) if has_accuracy else None
        self.number_of_neighbors = int(values[4])
        if has_accuracy and not self.is_cloud and not 1e-6 <= self.accuracy <= 0.5:
            raise damaged(f"its accuracy is {self.accuracy}")
        if not (has_accuracy or 1 <= self.number_of_neighbors < 2**31):
            raise damaged(f"its number of neighbors is {self.number_of_neighbors}")
        self.is_merged = bool(values[5])
        self.merge_tolerance = float(values[9:10].view(np.float64)[0])
        if not self.merge_tolerance >= 0.0:
            raise damaged(f"its merge tolerance is {self.merge_tolerance}")

    @classmethod
    def find(cls, polydata):
        """Returns the parameters of the graph on a surface, None without a readable one."""
        try:
            return cls(polydata)
        except ValueError:
            return None

    @property
    def is_guaranteed(self):
        """True if `accuracy` bounds all distances in the graph."""
        return CONSTRUCTIONS[self.construction] == "Guaranteed"

    def keeps(self, accuracy):
        """Returns true if the graph promises this accuracy."""
        return self.is_guaranteed and self.accuracy <= accuracy


def choose_method(method, accuracy, surface, methods):
    """Returns the method, and the parameters of the graph on the surface if the method uses it.

    By default a graph is used if the surface has one or an accuracy is given.
    """
    info = GraphInfo.find(surface)
    if method is None:
        # Filters warn of a graph that they cannot use.
        method = "graph" if accuracy is not None or has_graph(surface) else "exact"
    if not isinstance(method, str) or method not in methods:
        raise ValueError(f"method: expected one of {', '.join(map(repr, methods))}, got {method!r}")
    if accuracy is not None and method != "graph":
        raise ValueError(f"accuracy: applies to `method` 'graph' only, got {method!r}")
    if accuracy is not None and info is not None and info.is_cloud:
        raise ValueError(
            "accuracy: applies to meshes, not to point clouds; vtkdgg.CloudGraph(points, "
            "accuracy=...) builds a graph with less pruning"
        )
    return method, info if method == "graph" else None


def set_up(algorithm, surface, is_merged, merge_tolerance, projection_tolerance, info=None):
    """Sets the input of a filter, and the arguments that functions of surfaces have in common."""
    algorithm.SetInputData(surface)
    set_merging(algorithm, is_merged, merge_tolerance, info)
    algorithm.SetProjectionTolerance(arguments.projection_tolerance(projection_tolerance))


def set_merging(algorithm, coincident_points, tolerance, info=None):
    """Sets how a filter merges points; by default as the graph of its input, if there is one."""
    tolerance = arguments.limit(tolerance, "merge_tolerance")
    if info is not None and info.is_merged and not coincident_points:
        coincident_points, tolerance = True, info.merge_tolerance
    algorithm.SetMergeCoincidentPoints(bool(coincident_points))
    algorithm.SetMergeTolerance(tolerance)
