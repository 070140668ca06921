# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""`vtkdgg compare` on a point cloud: distances, and the path to the farthest point."""

import os
import sys
import warnings

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools

from ..pictures import spacings_of
from . import cloud_pictures, places
from .files import MeshFileError, points_of
from .output import print_table, with_arrays
from .solve import CloudGraph, Path, Query
from .words import counted

# Relative rounding error of edge lengths.
ROUNDING = 1e-6


def far_point(points, component):
    """Returns the id of the point of the largest component that is farthest from its center."""
    ids = np.flatnonzero(component == 0)
    offset = points[ids] - 0.5 * (points[ids].min(axis=0) + points[ids].max(axis=0))
    return int(ids[np.argmax((offset * offset).sum(axis=1))])


def coordinates(location):
    """Returns coordinates as text."""
    return "(" + ", ".join(f"{x:.6g}" for x in location) + ")"


def run(options, contents, read_time):
    """Runs the command on a cloud, and returns its exit code."""
    cloud = points_of(contents)
    points = vtk_to_numpy(cloud.GetPoints().GetData()).astype(float)
    finite = np.isfinite(points).all(axis=1)
    if not finite.any():
        raise MeshFileError(f"{options.mesh}: none of its points is finite")
    source = places.choose(options.source, cloud)
    if isinstance(source, int) and not finite[source]:
        raise places.SourceError(f"--source {source}: this point is not finite")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        graph = CloudGraph(cloud)
        component = vtk_to_numpy(
            graph.output.GetPointData().GetArray(graph.filter.GetComponentArrayName())
        )
        if source is None:
            source = far_point(points, component)
        query = Query(graph, source, False, options.tolerance)
        farthest = int(np.nanargmax(query.distances))
        path = Path(graph, source, farthest, options.tolerance)
    location = points[source] if isinstance(source, int) else np.array(source)

    os.makedirs(options.out, exist_ok=True)
    names = ("distance.vtp", "path.vtp", "distance.png")
    paths = [os.path.join(options.out, name) for name in names]
    arrays = {"GeodesicDistance": query.distances, "Component": component}
    vtkdgg.write(paths[0], with_arrays(cloud, arrays))
    vtkdgg.write(paths[1], path.output)
    cloud_pictures.save_distances(
        paths[2],
        points[finite],
        query.distances[finite],
        spacings_of(graph.filter)[finite],
        vtk_to_numpy(path.output.GetPoints().GetData()).astype(float),
        note(graph, query, path),
    )

    reached = np.isfinite(query.distances)
    noise = graph.filter.GetNoise()
    shorter = 0 if noise > 0.0 else number_too_short(query.distances, points, location)
    which = f"point {source} at " if isinstance(source, int) else ""
    rows = (
        ("cloud", options.mesh),
        ("points", len(points)),
        ("defects", defects(graph.filter)),
        ("reading", f"{read_time:.3f} s"),
        ("source", which + coordinates(location)),
        *graph_rows(graph, query),
        ("components", component_text(graph.filter)),
        ("reached", f"{reached.sum()} of {reached.size} points"),
        ("range", f"0 to {query.distances[farthest]:.6g} model units"),
        (
            "lower bound",
            "not compared: lengths refer to points without noise"
            if noise > 0.0
            else f"{counted(shorter, 'violation')} at {counted(reached.sum(), 'point')}",
        ),
        ("farthest", f"point {farthest} at {coordinates(points[farthest])}"),
        ("path", f"{path.length:.6g} model units long, found in {1e3 * path.time:.1f} ms"),
        ("written", ", ".join(paths)),
    )
    print_table(rows, [], caught)
    if shorter:
        print(f"error: {shorter} distances are shorter than straight lines", file=sys.stderr)
    return 1 if shorter else 0


def number_too_short(distances, points, location):
    """Returns the number of distances below the Euclidean distance, up to rounding errors."""
    straight = np.linalg.norm(points - location, axis=1)
    slack = ROUNDING * np.nanmax(distances)
    with np.errstate(invalid="ignore"):
        return int((distances < straight * (1.0 - ROUNDING) - slack).sum())


def defects(graph):
    """Returns a line that counts the defects of the cloud."""
    counts = (
        (graph.GetNumberOfUnusedPoints(), "point that is not finite", "points that are not finite"),
        (graph.GetNumberOfOutliers(), "stray point"),
        (graph.GetNumberOfCoincidentPoints(), "coincident point"),
    )
    return ", ".join(counted(*what) for what in counts if what[0]) or "none"


def component_text(graph):
    """Returns the number of components and the sizes of the largest ones as text."""
    count = graph.GetNumberOfComponents()
    sizes = [str(graph.GetComponentSize(i)) for i in range(min(count, 4))]
    more = ", ..." if count > len(sizes) else ""
    return f"{count}, with {', '.join(sizes)}{more} {'point' if sizes == ['1'] else 'points'}"


def graph_rows(graph, query):
    """Returns rows of the table: sampling of the cloud, size and times of the graph."""
    size = graph.filter.GetMemorySize() / 1e6
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    return (
        (
            "sampling",
            f"spacing {graph.filter.GetSpacing():.4g}, noise {graph.filter.GetNoise():.2g}, "
            f"edges reach {graph.filter.GetReach():.4g} model units",
        ),
        ("build", f"{graph.build_time:.3f} s on {counted(threads, 'thread')}"),
        (
            "graph",
            f"degree {graph.filter.GetMeanDegree():.1f}, "
            f"{graph.filter.GetNumberOfGraphEdges()} edges, {size:.1f} MB",
        ),
        (
            "query",
            f"{1e3 * query.time:.1f} ms for all distances "
            f"(the first: {1e3 * query.first_time:.1f} ms)",
        ),
    )


def note(graph, query, path):
    """Returns the lines of text of the picture."""
    return (
        counted(graph.output.GetNumberOfPoints(), "point"),
        counted(graph.filter.GetNumberOfGraphEdges(), "edge"),
        counted(graph.filter.GetNumberOfComponents(), "component"),
        f"build  {graph.build_time:.2f} s",
        f"query  {1e3 * query.time:.1f} ms",
        f"path  {path.length:.4g}",
    )
