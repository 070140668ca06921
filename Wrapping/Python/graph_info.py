# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph in the field data of a surface, as vtkDiscreteGeodesicGraph documents it."""

import numpy as np

from . import _kernel, arguments
from .errors import Error, call, warn

PREFIX = "DGG."
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


def arrays_of(field_data):
    """Returns the arrays of a graph, which may be damaged, as read-only views by name."""
    found = {}
    for name, values in field_data.items():
        if name.startswith(PREFIX):
            found[name] = values.view()
            found[name].flags.writeable = False
    return found


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

    def __init__(self, field_data):
        values = field_data.get("DGG.Info")
        if values is None:
            raise ValueError(
                "polydata: there is no graph in its field data; take the output of "
                "vtkDiscreteGeodesicGraph"
            )
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
    def find(cls, field_data):
        """Returns the parameters of a graph, None without a readable one."""
        try:
            return cls(field_data)
        except ValueError:
            return None

    @property
    def is_guaranteed(self):
        """True if `accuracy` bounds all distances in the graph."""
        return CONSTRUCTIONS[self.construction] == "Guaranteed"

    @property
    def options(self):
        """Options of the kernel to build such a graph of a mesh."""
        options = {"construction": CONSTRUCTIONS[self.construction]}
        if self.accuracy is not None:
            options["accuracy"] = self.accuracy
        if self.number_of_neighbors:
            options["number_of_neighbors"] = self.number_of_neighbors
        return options

    def is_asked_for(self, options):
        """Returns true if the graph is one that these options ask for; any graph without options."""
        defaults = {"construction": "Guaranteed", "accuracy": 0.01, "number_of_neighbors": 30}
        wanted = {**defaults, **options}
        return not options or all(wanted[key] == value for key, value in self.options.items())

    def keeps(self, accuracy):
        """Returns true if the graph promises this accuracy."""
        return self.is_guaranteed and self.accuracy <= accuracy


def choose_method(method, accuracy, surface, methods):
    """Returns the method, and the parameters of the graph on the surface if the method uses it.

    By default a graph is used if the surface has one or an accuracy is given.
    """
    info = GraphInfo.find(surface.field_data)
    if method is None:
        # A graph that cannot be used causes a warning.
        has_graph = bool(arrays_of(surface.field_data))
        method = "graph" if accuracy is not None or has_graph else "exact"
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


def merging(is_merged, tolerance, info=None):
    """Returns how points are merged: as given, or else as in the graph with these parameters."""
    tolerance = arguments.limit(tolerance, "merge_tolerance")
    if info is not None and info.is_merged and not is_merged:
        return True, info.merge_tolerance
    return bool(is_merged), tolerance


def find_or_build(surface, prepared, accuracy=None, issued=None):
    """Returns the graph of the kernel for the arrays on a surface, or else builds one.

    A graph that cannot be used, or is coarser than the accuracy, causes a warning. The graph of a
    cloud cannot be built here: an error states why it cannot be used.
    """
    wanted = 0.01 if accuracy is None else accuracy
    arrays = arrays_of(surface.field_data)
    if arrays or prepared.is_cloud:
        try:
            graph = call(_kernel.Graph.from_arrays, prepared, arrays)
        except Error as error:
            if prepared.is_cloud or error.reason == "OutOfMemory":
                raise
            warn([f"{error} A graph with `accuracy` {wanted:g} replaces it."], issued)
        else:
            is_enough = prepared.is_cloud or GraphInfo(arrays).keeps(wanted)
            if accuracy is not None and not is_enough:
                has = f"has the accuracy {graph.accuracy:g}"
                reason = has if graph.is_guaranteed else "guarantees no accuracy"
                texts = [
                    f"The graph on the mesh {reason}, but `accuracy` is {wanted:g}. Build a graph "
                    "with this `accuracy`, or remove the graph."
                ]
                warn(texts, issued)
            return graph
    return call(_kernel.Graph, prepared, accuracy=wanted, issued=issued)
