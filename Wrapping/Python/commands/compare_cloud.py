# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""`vtkdgg compare` on a point cloud: distances, and the path to the farthest point."""

import os

import numpy as np
import vtkdgg

from ..checks import counted
from ..pictures import scaled_spacings
from ..vtk_data import with_arrays
from . import bounds, cloud_pictures, places
from .files import are_finite, points_of
from .methods import Query, timed
from .output import defects, distance_rows, graph_rows, position

# Relative rounding error of edge lengths.
ROUNDING = 1e-6


def far_point(points, component):
    """Returns the id of the point of the largest component that is farthest from its center."""
    ids = np.flatnonzero(component == 0)
    offset = points[ids] - 0.5 * (points[ids].min(axis=0) + points[ids].max(axis=0))
    return int(ids[np.argmax((offset * offset).sum(axis=1))])


def on_cloud(options, contents, read_time):
    """Returns the rows of the table of a cloud, notes and violations."""
    points = contents.points
    finite = are_finite(contents, options.mesh)
    cloud = points_of(contents).as_polydata()
    source = places.choose(options.source, cloud)
    if isinstance(source, int) and not finite[source]:
        raise ValueError(f"--source {source}: this point is not finite")
    graph, build_time = timed(vtkdgg.CloudGraph, cloud)
    component, figures = graph.components, graph._statistics
    if source is None:
        source = far_point(points, component)
    query = Query(graph, source, options.tolerance)
    farthest = int(np.nanargmax(query.distances))
    path, path_time = timed(graph._path, source, farthest, projection_tolerance=options.tolerance)
    length = path.cell_data["Length"][0]
    location = points[source] if isinstance(source, int) else np.array(source)

    os.makedirs(options.out, exist_ok=True)
    names = ("distance.vtp", "path.vtp", "distance.png")
    paths = [os.path.join(options.out, name) for name in names]
    arrays = {"GeodesicDistance": query.distances, "Component": component}
    vtkdgg.write(paths[0], with_arrays(cloud, arrays))
    vtkdgg.write(paths[1], graph._polydata(path))
    cloud_pictures.save_distances(
        paths[2],
        points[finite],
        query.distances[finite],
        scaled_spacings(graph._arrays["DGG.Radii"], figures["spacing"])[finite],
        path.points,
        note(graph, build_time, query, length),
    )

    noise = figures["noise"]
    shorter = 0 if noise > 0.0 else number_too_short(query.distances, cloud, location)
    rows = (
        ("cloud", options.mesh),
        ("points", len(points)),
        ("defects", defects_of(figures)),
        ("reading", f"{read_time:.3f} s"),
        ("source", position(location, source)),
        (
            "sampling",
            f"spacing {figures['spacing']:.4g}, noise {noise:.2g}, "
            f"edges reach {figures['reach']:.4g} model units",
        ),
        *graph_rows(graph, build_time, query),
        ("components", component_text(component)),
        *distance_rows(query.distances, "points"),
        (
            "lower bound",
            "not compared: lengths refer to points without noise"
            if noise > 0.0
            else f"{counted(shorter, 'violation')} at "
            + counted(np.isfinite(query.distances).sum(), "point"),
        ),
        ("farthest", position(points[farthest], farthest)),
        ("path", f"{length:.6g} model units long, found in {1e3 * path_time:.1f} ms"),
        ("written", ", ".join(paths)),
    )
    violations = [f"{shorter} distances are shorter than straight lines"] if shorter else []
    return rows, [], violations


def number_too_short(distances, cloud, location):
    """Returns the number of distances below the Euclidean distance, up to rounding errors."""
    straight = bounds.lower_bound(cloud, location)
    slack = ROUNDING * np.nanmax(distances)
    with np.errstate(invalid="ignore"):
        return int((distances < straight * (1.0 - ROUNDING) - slack).sum())


def defects_of(figures):
    """Returns a line that counts the defects of a cloud with these statistics."""
    units = (
        ("unused_points", "point that is not finite", "points that are not finite"),
        ("outliers", "stray point"),
        ("coincident_points", "coincident point"),
    )
    return defects([], *((figures[f"number_of_{key}"], *unit) for key, *unit in units))


def component_text(component):
    """Returns the number of components and the sizes of the largest ones as text."""
    count = int(component.max()) + 1
    sizes = list(map(str, np.bincount(component[component >= 0])[:4]))
    more = ", ..." if count > len(sizes) else ""
    return f"{count}, with {', '.join(sizes)}{more} {'point' if sizes == ['1'] else 'points'}"


def note(graph, build_time, query, length):
    """Returns the lines of text of the picture."""
    return (
        counted(graph.number_of_points, "point"),
        counted(len(graph.targets), "edge"),
        counted(int(graph.components.max()) + 1, "component"),
        f"build  {build_time:.2f} s",
        f"query  {1e3 * query.time:.1f} ms",
        f"path  {length:.4g}",
    )
