# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that `vtkdgg compare` compares, and timed updates of their filters."""

import statistics
import time

import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy

from .. import filters
from ..vtk_data import configured

NUMBER_OF_QUERIES = 9


def update(algorithm):
    """Updates a filter, and returns its output and the elapsed time in seconds."""
    start = time.perf_counter()
    output = vtkdgg.check(algorithm)
    return output, time.perf_counter() - start


class Graph:
    """A filter that builds a graph of a mesh or a cloud, after its timed update."""

    def __init__(self, algorithm):
        self.filter = algorithm
        self.output, self.build_time = update(algorithm)


class Direct:
    """Distances from a source by the filter that the function `make` returns, with the time of the
    update. The mesh is its input unless it has one."""

    def __init__(self, make, mesh, source, merge=False, tolerance=0.01):
        self.filter = make()
        if self.filter.GetNumberOfInputConnections(0) == 0:
            self.filter.SetInputData(mesh)
        configured(self.filter, MergeCoincidentPoints=merge, ProjectionTolerance=tolerance)
        points = filters.surface_point(source, "--source", mesh)
        filters.set_points(self.filter, "Source", points)
        self.output, self.time = update(self.filter)

    @property
    def distances(self):
        """Distances of all points."""
        return self._array(self.filter.GetDistanceArrayName())

    def _array(self, name):
        return vtk_to_numpy(self.output.GetPointData().GetArray(name))


class Query(Direct):
    """Distances from a source in a graph. The first query includes the preparation of the search;
    `time` is the median of later ones."""

    def __init__(self, graph, mesh, source, merge, tolerance):
        super().__init__(on_graph(graph.filter, True, True), mesh, source, merge, tolerance)
        self.first_time = self.time
        times = []
        for _ in range(NUMBER_OF_QUERIES):
            self.filter.Modified()
            self.output, seconds = update(self.filter)
            times.append(seconds)
        self.time = statistics.median(times)

    @property
    def upper_bound(self):
        """Lengths of paths in the graph."""
        return self._array(self.filter.GetUpperBoundArrayName())


class Path:
    """The smoothed shortest path in the graph of a cloud from the source to a point."""

    def __init__(self, graph, source, point, tolerance):
        port = graph.filter.GetOutputPort()
        self.filter = configured(vtkdgg.vtkDGGPath(), InputConnection=port)
        self.filter.SetProjectionTolerance(tolerance)
        ends = (
            filters.surface_point(end, "--source", graph.output, is_cloud=True)
            for end in (source, point)
        )
        filters.set_pair(self.filter, *ends)
        self.output, self.time = update(self.filter)
        self.length = self.output.GetCellData().GetArray("Length").GetValue(0)


def graph(accuracy, correction=True):
    """Returns a function that makes a vtkDGGDistance, which builds its own graph."""
    return lambda: configured(vtkdgg.vtkDGGDistance(), Accuracy=accuracy, Correction=correction)


def propagation(quality):
    """Returns a function that makes a vtkVirtualSourceGeodesicDistance of this quality."""
    return lambda: configured(vtkdgg.vtkVirtualSourceGeodesicDistance(), Quality=quality)


def heat():
    """Returns the heat method on the triangles of the mesh, without intrinsic Delaunay flips."""
    return configured(vtkdgg.vtkHeatGeodesicDistance(), IntrinsicDelaunay=False)


def on_graph(graph_filter, correction=False, has_upper_bound=False):
    """Returns a function that makes a vtkDGGDistance on the graph of a filter."""
    return lambda: configured(
        vtkdgg.vtkDGGDistance(),
        InputConnection=graph_filter.GetOutputPort(),
        Correction=correction,
        GenerateUpperBound=has_upper_bound,
    )


def builder(mesh, construction, accuracy=0.01, neighbors=30, merge=False):
    """Returns a vtkDiscreteGeodesicGraph of this construction before its update."""
    return configured(
        vtkdgg.vtkDiscreteGeodesicGraph(),
        InputData=mesh,
        Construction=getattr(vtkdgg.vtkDiscreteGeodesicGraph, construction),
        Accuracy=accuracy,
        NumberOfNeighbors=neighbors,
        MergeCoincidentPoints=merge,
    )


def cloud_builder(cloud):
    """Returns the vtkPointCloudDGG of a cloud before its update."""
    if not hasattr(vtkdgg._kernel, "cloud_graph"):
        raise ValueError("this vtkDGG has no graphs of point clouds: build it with DGG_WITH_PCL")
    return configured(vtkdgg.vtkPointCloudDGG(), InputData=cloud)


def methods(mesh, accuracy, merge=False, neighbors=30):
    """Returns functions that make the filters, by the title of the method."""
    one_relay = builder(mesh, "OneRelay", accuracy, merge=merge)
    svg = builder(mesh, "SaddleVertexGraph", neighbors=neighbors, merge=merge)
    return {
        "graph": graph(accuracy, False),
        "graph, corrected": graph(accuracy),
        "graph, published rule": on_graph(one_relay),
        f"SVG, K = {neighbors}": on_graph(svg),
        "virtual sources": propagation(1),
        "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
        "heat": heat,
        "heat, intrinsic Delaunay": vtkdgg.vtkHeatGeodesicDistance,
    }


def field(make, mesh, source, merge=False, tolerance=0.01):
    """Returns the distances that a filter computes from a surface point."""
    return Direct(make, mesh, source, merge, tolerance).distances.copy()
