# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that `vtkdgg compare` compares, and timed calls."""

import statistics
import time

from .. import _kernel, arguments, meshes
from ..errors import call

NUMBER_OF_QUERIES = 9


def timed(function, *given, **options):
    """Returns the result of a function, and the elapsed time in seconds."""
    start = time.perf_counter()
    result = function(*given, **options)
    return result, time.perf_counter() - start


class Query:
    """Distances from a source in a graph, and lengths of paths in the graph as `upper_bound`. The
    first query includes the preparation of the search; `time` is the median of later ones."""

    def __init__(self, graph, source, tolerance):
        times = []
        for _ in range(1 + NUMBER_OF_QUERIES):
            found, seconds = timed(
                graph._distance, source, None, None, tolerance, generate_upper_bound=True
            )
            times.append(seconds)
        self.distances = found.point_data["GeodesicDistance"]
        self.upper_bound = found.point_data["GeodesicUpperBound"]
        self.first_time, self.time = times[0], statistics.median(times[1:])


def methods(mesh, accuracy, merge=False, tolerance=0.01, neighbors=30):
    """Returns functions from a surface point to the distances of all points of a mesh without a
    graph, by the title of the method."""
    surface, _ = meshes.take(mesh)
    prepared = surface.prepared(merge)

    def by(function, target=prepared, **options):
        def distances(source):
            point = arguments.surface_point(source, "--source", surface).in_kernel()
            found = call(function, target, point, projection_tolerance=tolerance, **options)
            return found.point_data["GeodesicDistance"]

        return distances

    def by_graph(graph, correction=False):
        return by(_kernel.Graph.distance, graph, correction=correction)

    def graph(construction, **options):
        return call(_kernel.Graph, prepared, construction=construction, **options)

    guaranteed = graph("Guaranteed", accuracy=accuracy)
    return {
        "graph": by_graph(guaranteed),
        "graph, corrected": by_graph(guaranteed, correction=True),
        "graph, published rule": by_graph(graph("OneRelay", accuracy=accuracy)),
        f"SVG, K = {neighbors}": by_graph(
            graph("SaddleVertexGraph", number_of_neighbors=neighbors)
        ),
        "virtual sources": by(_kernel.virtual_source_distance, quality="Fast"),
        "fast marching": by(_kernel.fast_marching_distance),
        "heat": by(_kernel.heat_distance, intrinsic_delaunay=False),
        "heat, intrinsic Delaunay": by(_kernel.heat_distance, intrinsic_delaunay=True),
    }
