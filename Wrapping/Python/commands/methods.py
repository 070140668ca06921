# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that `vtkdgg compare --methods` compares."""

import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy

from .places import add_source


def graph(accuracy, correction=True):
    """Returns a function that makes a vtkDGGDistance, which builds its own graph."""

    def make():
        distance = vtkdgg.vtkDGGDistance()
        distance.SetAccuracy(accuracy)
        distance.SetCorrection(correction)
        return distance

    return make


def propagation(quality):
    """Returns a function that makes a vtkVirtualSourceGeodesicDistance of this quality."""

    def make():
        distance = vtkdgg.vtkVirtualSourceGeodesicDistance()
        distance.SetQuality(quality)
        return distance

    return make


def heat():
    """Returns the heat method on the triangles of the mesh, without intrinsic Delaunay flips."""
    distance = vtkdgg.vtkHeatGeodesicDistance()
    distance.IntrinsicDelaunayOff()
    return distance


def on_graph(graph_filter, correction=False):
    """Returns a function that makes a vtkDGGDistance on the graph of a filter."""

    def make():
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputConnection(graph_filter.GetOutputPort())
        distance.SetCorrection(correction)
        return distance

    return make


def build(mesh, construction, accuracy=0.01, neighbors=30, merge=False):
    """Returns a vtkDiscreteGeodesicGraph of this construction after its update."""
    graph_filter = vtkdgg.vtkDiscreteGeodesicGraph()
    graph_filter.SetInputData(mesh)
    graph_filter.SetConstruction(getattr(graph_filter, construction))
    graph_filter.SetAccuracy(accuracy)
    graph_filter.SetNumberOfNeighbors(neighbors)
    graph_filter.SetMergeCoincidentPoints(merge)
    vtkdgg.check(graph_filter)
    return graph_filter


def methods(mesh, accuracy, merge=False, neighbors=30):
    """Returns functions that make the filters, by the title of the method."""
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
    """Returns the distances that a filter computes from a surface point."""
    distance = make()
    if distance.GetNumberOfInputConnections(0) == 0:
        distance.SetInputData(mesh)
    distance.SetMergeCoincidentPoints(merge)
    distance.SetProjectionTolerance(tolerance)
    add_source(distance, mesh, source)
    output = vtkdgg.check(distance)
    return vtk_to_numpy(output.GetPointData().GetArray(distance.GetDistanceArrayName())).copy()
