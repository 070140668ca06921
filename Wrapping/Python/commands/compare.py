# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computes distances on a mesh within an accuracy by a graph, and measures their errors against
exact distances. Prints a table, and writes distance.vtp, distance.png and error.png. For a point
cloud, computes distances and the path to the farthest point."""

import os
import sys
import time
import warnings

import numpy as np
import vtkdgg
from vtkmodules.vtkCommonCore import vtkSMPTools

from .. import reading
from . import bounds, files, places
from .files import triangles_of
from .measured import Errors
from .output import print_table, with_arrays
from .sizes import floor_of, notes
from .solve import Direct, Graph, Query
from .words import counted

DEFAULT_MESH = "/usr/share/glmark2/models/bunny.obj"
DEFAULT_ACCURACY = 0.01
ERROR_COLUMNS = "{:<10} {:<10} {}".format
# Names of methods in `vtkdgg distance --method`.
METHODS = {"virtual sources": "fast", "fast marching": "marching"}


class UsageError(Exception):
    """An argument is wrong; the text states which."""


def add_arguments(parser):
    """Adds the arguments of the command to a parser."""
    parser.add_argument(
        "mesh",
        nargs="?",
        default=DEFAULT_MESH,
        help=f"{' '.join(reading.EXTENSIONS)} (default: %(default)s)",
    )
    parser.add_argument(
        "--source",
        metavar=places.POINT,
        help="where distances start: a point id, coordinates on the surface, or a face with "
        "barycentric coordinates (default: the point farthest from the center of the mesh)",
    )
    parser.add_argument(
        "--tolerance",
        type=float,
        default=0.01,
        metavar="T",
        help="largest distance of X,Y,Z from the surface, as a fraction of the diagonal "
        "(default: %(default)s)",
    )
    parser.add_argument(
        "--accuracy",
        type=float,
        metavar="E",
        help="largest relative error of a distance on a mesh, 1e-6 to 0.5 "
        f"(default: {DEFAULT_ACCURACY})",
    )
    parser.add_argument(
        "--merge",
        action="store_true",
        help="treat points of a mesh with equal coordinates as one (texture seams)",
    )
    parser.add_argument(
        "--cloud",
        action="store_true",
        help="use the points only, also of a mesh",
    )
    parser.add_argument(
        "--methods",
        action="store_true",
        help="compare the errors of all methods: a table, and methods.png with maps and histograms",
    )
    parser.add_argument(
        "--out", metavar="DIR", default="out", help="folder of the results (default: ./%(default)s)"
    )


def defects(distance):
    """Returns a line that counts the defects of the mesh."""
    counts = (
        (distance.GetNumberOfNonManifoldEdges(), "non-manifold edge"),
        (distance.GetNumberOfNonManifoldVertices(), "non-manifold vertex", "non-manifold vertices"),
        (
            distance.GetNumberOfDroppedFaces(),
            "face with repeated points",
            "faces with repeated points",
        ),
        (distance.GetNumberOfDegenerateFaces(), "triangle without area", "triangles without area"),
        (distance.GetNumberOfDuplicateFaces(), "duplicate triangle"),
        (distance.GetNumberOfCoincidentPoints(), "coincident point"),
        (distance.GetNumberOfIsolatedPoints(), "isolated point"),
    )
    found = [counted(*what) for what in counts if what[0]]
    if not distance.GetOrientable():
        found.append("no consistent orientation")
    return ", ".join(found) or "none"


def topology(distance):
    """Returns a line on components, boundary and genus."""
    genus = distance.GetGenus()
    return (
        f"components {distance.GetNumberOfComponents()}, "
        f"boundary loops {distance.GetNumberOfBoundaryLoops()}, "
        + (f"genus {genus}" if genus >= 0 else "no genus")
    )


def bound_line(bound, name):
    """Returns a line on the violations of a bound."""
    return (
        f"{counted(bound['violations'], 'violation')} at {counted(bound['points'], 'point')}, "
        f"mean distance / {name} = {bound['ratio']:.4f}"
    )


def percent(value):
    """Returns a relative error as text."""
    return f"{100.0 * value:.2g} %"


def error_rows(raw, corrected, accuracy):
    """Returns rows of the table: the errors, and the promised accuracy."""
    return (
        ("error", ERROR_COLUMNS("mean", "99.9 %", "largest")),
        ("raw", sizes_of(raw)),
        ("corrected", sizes_of(corrected)),
        ("promised", ERROR_COLUMNS("", "", percent(accuracy))),
    )


def sizes_of(errors):
    """Returns the mean, the 99.9th percentile and the maximum of errors as text."""
    return ERROR_COLUMNS(*map(percent, (errors.mean, errors.percentile, errors.largest)))


def method_rows(measured):
    """Returns rows of the table: the errors of all methods."""
    names = {title: f"{title} ({name})" for title, name in METHODS.items()}
    lines = [
        f"{names.get(title, title):<26} {sizes_of(errors)}" for title, errors in measured.items()
    ]
    return tuple(("" if i else "methods", line) for i, line in enumerate(lines))


def near_rows(errors, floor):
    """Returns a row of the table: the number of points too near the source for a relative error."""
    if not errors.number_near:
        return ()
    points = counted(errors.number_near, "point")
    return (("too near", f"{points} within {floor:.2g} of the source: no relative errors there"),)


def graph_rows(graph, query, exact):
    """Returns rows of the table: size and times of the graph."""
    size = graph.filter.GetMemorySize() / 1e6
    search = query.filter.GetMemorySize() / 1e6 - size
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    return (
        ("build", f"{graph.build_time:.3f} s on {counted(threads, 'thread')}"),
        (
            "graph",
            f"degree {graph.filter.GetMeanDegree():.1f}, {graph.filter.GetNumberOfGraphEdges()} "
            f"edges, {size:.1f} MB ({search:.1f} MB more for searches)",
        ),
        (
            "query",
            f"{1e3 * query.time:.1f} ms for all distances "
            f"(the first: {1e3 * query.first_time:.1f} ms)",
        ),
        ("exact", f"{1e3 * exact.time:.1f} ms for exact distances"),
    )


def write(folder, mesh, source, query, exact, errors, accuracy):
    """Writes the data and both pictures. Returns their paths and the distance between isolines."""
    from .. import pictures  # rendering takes long to import

    os.makedirs(folder, exist_ok=True)
    paths = [os.path.join(folder, name) for name in ("distance.vtp", "distance.png", "error.png")]
    result = with_arrays(
        mesh,
        {
            "GeodesicDistance": query.distances,
            "GeodesicUpperBound": query.upper_bound,
            "ExactDistance": exact.distances,
            "RelativeError": errors.signed,
        },
    )
    vtkdgg.write(paths[0], result)
    step = pictures.save_distances(paths[1], result, "GeodesicDistance", source)
    note = (
        f"promised  {percent(accuracy)}",
        f"largest  {percent(errors.largest)}",
        f"mean  {percent(errors.mean)}",
    )
    isolines = ("GeodesicDistance", step)
    pictures.save_errors(paths[2], result, "RelativeError", accuracy, isolines, source, note)
    return paths, step


def run(options):
    """Runs the command, and returns its exit code."""
    start = time.perf_counter()
    contents = vtkdgg.read(options.mesh).as_polydata()
    read_time = time.perf_counter() - start
    if not options.cloud and not files.is_cloud(contents):
        return on_mesh(options, contents, read_time)
    for option, given in (
        ("--accuracy", options.accuracy is not None),
        ("--merge", options.merge),
        ("--methods", options.methods),
    ):
        if given:
            raise UsageError(f"{option} applies to meshes, not to point clouds")
    from . import compare_cloud  # rendering takes long to import

    return compare_cloud.run(options, contents, read_time)


def on_mesh(options, contents, read_time):
    """Runs the command on a mesh, and returns its exit code."""
    start = time.perf_counter()
    mesh = triangles_of(contents, options.mesh)
    read_time += time.perf_counter() - start
    source = places.choose(options.source, contents)
    if source is None:
        source = places.far_point(mesh)
    elif isinstance(source, tuple):
        source = places.in_triangles(source, contents)
    accuracy = DEFAULT_ACCURACY if options.accuracy is None else options.accuracy
    location, corners = places.locate(mesh, source)

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        given = mesh, source, options.merge, options.tolerance
        measured = {}
        if options.methods:
            from . import compare_methods

            _, measured = compare_methods.measure(mesh, source, accuracy, *given[2:])
        first = Direct(vtkdgg.vtkVirtualSourceGeodesicDistance, *given)
        graph = Graph(mesh, accuracy, options.merge)
        query = Query(graph, source, options.merge, options.tolerance)
        exact = Direct(vtkdgg.vtkExactGeodesicDistance, *given)
    floor = floor_of(mesh)
    sooner = Errors(first.distances, exact.distances, floor)
    raw = Errors(query.upper_bound, exact.distances, floor)
    corrected = Errors(query.distances, exact.distances, floor)
    agreement = bounds.compare(
        exact.distances,
        bounds.upper_bound(mesh, location, corners),
        bounds.lower_bound(mesh, location),
    )
    paths, step = write(options.out, mesh, location, query, exact, corrected, accuracy)
    if measured:
        paths.append(os.path.join(options.out, "methods.png"))
        compare_methods.save(paths[-1], mesh, location, measured)

    position = ", ".join(f"{x:.6g}" for x in location)
    which = f"point {source} at " if isinstance(source, int) else ""
    reached = np.isfinite(query.distances)
    rows = (
        (
            "first answer",
            f"after {1e3 * first.time:.1f} ms, by virtual sources: mean error "
            f"{percent(sooner.mean)}, largest {percent(sooner.largest)}",
        ),
        ("mesh", options.mesh),
        ("vertices", mesh.GetNumberOfPoints()),
        ("triangles", mesh.GetNumberOfPolys()),
        ("topology", topology(query.filter)),
        ("defects", defects(query.filter)),
        ("reading", f"{read_time:.3f} s"),
        ("source", f"{which}({position})"),
        *graph_rows(graph, query, exact),
        *error_rows(raw, corrected, accuracy),
        *near_rows(corrected, floor),
        *method_rows(measured),
        ("reached", f"{reached.sum()} of {reached.size} vertices"),
        ("range", f"0 to {np.nanmax(np.append(query.distances, 0.0)):.6g} model units"),
        ("upper bound", bound_line(agreement["upper"], "edge graph")),
        ("lower bound", bound_line(agreement["lower"], "Euclid")),
        ("isolines", f"every {step:g} model units"),
        ("written", ", ".join(paths)),
    )
    print_table(rows, notes(mesh), caught)
    return verdict(raw, corrected, accuracy, agreement)


def verdict(raw, corrected, accuracy, agreement):
    """Returns the exit code: 1, with a message, if a bound or the accuracy is violated."""
    broken = agreement["upper"]["violations"] + agreement["lower"]["violations"]
    if broken:
        print(f"error: {broken} exact distances violate a bound", file=sys.stderr)
    kept = raw.keeps(accuracy) and corrected.keeps(accuracy) and raw.is_upper_bound
    if not kept:
        print("error: an error exceeds the promised accuracy", file=sys.stderr)
    return 0 if kept and not broken else 1
