# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timed updates of the filters that a comparison needs: graphs, queries and the exact solver."""

import statistics
import time

import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy

from .. import arguments
from ..paths import set_pairs
from .files import make_graph
from .places import add_source

NUMBER_OF_QUERIES = 9


def update(algorithm):
    """Updates a filter, and returns its output and the elapsed time in seconds."""
    start = time.perf_counter()
    output = vtkdgg.check(algorithm)
    return output, time.perf_counter() - start


class Graph:
    """The graph of a mesh."""

    def __init__(self, mesh, accuracy, merge):
        self.filter = vtkdgg.vtkDiscreteGeodesicGraph()
        self.filter.SetInputData(mesh)
        self.filter.SetAccuracy(accuracy)
        self.filter.SetMergeCoincidentPoints(merge)
        _, self.build_time = update(self.filter)


class CloudGraph:
    """The graph of a point cloud, with automatic parameters."""

    def __init__(self, cloud):
        self.filter = make_graph(cloud)
        self.output, self.build_time = update(self.filter)


class Query:
    """Distances from a source in a graph. The first query includes the preparation of the search;
    `time` is the median of later ones."""

    def __init__(self, graph, source, merge, tolerance):
        self.filter = vtkdgg.vtkDGGDistance()
        self.filter.SetInputConnection(graph.filter.GetOutputPort())
        self.filter.SetMergeCoincidentPoints(merge)
        self.filter.SetProjectionTolerance(tolerance)
        add_source(self.filter, graph.filter.GetInput(), source)
        self.filter.GenerateUpperBoundOn()
        self.output, self.first_time = update(self.filter)
        times = []
        for _ in range(NUMBER_OF_QUERIES):
            self.filter.Modified()
            self.output, seconds = update(self.filter)
            times.append(seconds)
        self.time = statistics.median(times)
        arrays = self.output.GetPointData()
        self.name = self.filter.GetDistanceArrayName()
        self.distances = vtk_to_numpy(arrays.GetArray(self.name))
        self.upper_bound = vtk_to_numpy(arrays.GetArray(self.filter.GetUpperBoundArrayName()))


class Direct:
    """Distances from a source by a filter without a graph."""

    def __init__(self, kind, mesh, source, merge, tolerance):
        self.filter = kind()
        self.filter.SetInputData(mesh)
        self.filter.SetMergeCoincidentPoints(merge)
        self.filter.SetProjectionTolerance(tolerance)
        add_source(self.filter, mesh, source)
        output, self.time = update(self.filter)
        name = self.filter.GetDistanceArrayName()
        self.distances = vtk_to_numpy(output.GetPointData().GetArray(name))


class Path:
    """The smoothed shortest path in the graph of a cloud from the source to a point."""

    def __init__(self, graph, source, point, tolerance):
        self.filter = vtkdgg.vtkDGGPath()
        self.filter.SetInputConnection(graph.filter.GetOutputPort())
        self.filter.SetProjectionTolerance(tolerance)
        ends = (
            arguments.surface_point(end, "--source", graph.output, is_cloud=True)
            for end in (source, point)
        )
        set_pairs(self.filter, *ends)
        self.output, self.time = update(self.filter)
        self.length = self.output.GetCellData().GetArray("Length").GetValue(0)
