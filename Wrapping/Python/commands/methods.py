# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""All ways to a distance field, ours and others, to be measured beside each other."""

import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy

from .places import add_source


def graph(accuracy, correction=True):
    """A filter that builds a graph of its own."""

    def make():
        distance = vtkdgg.vtkDGGDistance()
        distance.SetAccuracy(accuracy)
        distance.SetCorrection(correction)
        return distance

    return make


def propagation(quality):
    """Virtual sources of one quality."""

    def make():
        distance = vtkdgg.vtkVirtualSourceGeodesicDistance()
        distance.SetQuality(quality)
        return distance

    return make


def heat():
    """On the triangles as they are; by default it is on an intrinsic Delaunay triangulation."""
    distance = vtkdgg.vtkHeatGeodesicDistance()
    distance.IntrinsicDelaunayOff()
    return distance


def on_graph(graph_filter, correction=False):
    """Distances in a graph of another construction."""

    def make():
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputConnection(graph_filter.GetOutputPort())
        distance.SetCorrection(correction)
        return distance

    return make


def build(mesh, construction, accuracy=0.01, neighbors=30, merge=False):
    """The filter of a graph, updated."""
    graph_filter = vtkdgg.vtkDiscreteGeodesicGraph()
    graph_filter.SetInputData(mesh)
    graph_filter.SetConstruction(getattr(graph_filter, construction))
    graph_filter.SetAccuracy(accuracy)
    graph_filter.SetNumberOfNeighbors(neighbors)
    graph_filter.SetMergeCoincidentPoints(merge)
    vtkdgg.check(graph_filter)
    return graph_filter


def methods(mesh, accuracy, merge=False, neighbors=30):
    """Title and maker of the filter, for each of them."""
    one_relay = build(mesh, "OneRelay", accuracy, merge=merge)
    svg = build(mesh, "SaddleVertexGraph", neighbors=neighbors, merge=merge)
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
    """Distances from a surface point."""
    distance = make()
    if distance.GetNumberOfInputConnections(0) == 0:
        distance.SetInputData(mesh)
    distance.SetMergeCoincidentPoints(merge)
    distance.SetProjectionTolerance(tolerance)
    add_source(distance, mesh, source)
    output = vtkdgg.check(distance)
    return vtk_to_numpy(output.GetPointData().GetArray(distance.GetDistanceArrayName())).copy()
