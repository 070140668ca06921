# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""`vtkdgg compare` on a mesh: errors of distances in a graph against exact distances."""

import os
import time

import vtkdgg

from ..checks import counted
from ..vtk_data import structure_of, triangulated, with_arrays
from . import bounds, places
from .compare import DEFAULT_ACCURACY
from .measured import Errors
from .methods import Query, timed
from .output import defects, distance_rows, graph_rows, position
from .sizes import floor_of, notes

ERROR_COLUMNS = "{:<10} {:<10} {}".format
# Names of methods in `vtkdgg distance --method`.
METHODS = {"virtual sources": "fast", "fast marching": "marching"}


def defects_of(report):
    """Returns a line that counts the defects in the report of a mesh."""
    others = [] if report["orientable"] else ["no consistent orientation"]
    units = (
        ("non_manifold_edges", "non-manifold edge"),
        ("non_manifold_vertices", "non-manifold vertex", "non-manifold vertices"),
        ("dropped_faces", "face with repeated points", "faces with repeated points"),
        ("degenerate_faces", "triangle without area", "triangles without area"),
        ("duplicate_faces", "duplicate triangle"),
        ("coincident_points", "coincident point"),
        ("isolated_points", "isolated point"),
    )
    return defects(others, *((int(report[f"number_of_{key}"]), *unit) for key, *unit in units))


def topology(report):
    """Returns a line on components, boundary and genus."""
    genus = report["genus"]
    return (
        f"components {report['number_of_components']:.0f}, "
        f"boundary loops {report['number_of_boundary_loops']:.0f}, "
        + (f"genus {genus:.0f}" if genus >= 0 else "no genus")
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
            "ExactDistance": exact,
            "RelativeError": errors.signed,
        },
    )
    vtkdgg.write(paths[0], result)
    step = pictures.save_array(paths[1], result, "GeodesicDistance", source, is_distance=True)
    note = (
        f"promised  {percent(accuracy)}",
        f"largest  {percent(errors.largest)}",
        f"mean  {percent(errors.mean)}",
    )
    isolines = ("GeodesicDistance", step)
    pictures.save_errors(paths[2], result, "RelativeError", accuracy, isolines, source, note)
    return paths, step


def on_mesh(options, contents, read_time):
    """Returns the rows of the table of a mesh, notes and violations."""
    start = time.perf_counter()
    mesh = triangulated(contents.as_polydata(), options.mesh)
    read_time += time.perf_counter() - start
    source = places.choose(options.source, contents)
    if source is None:
        source = places.far_point(mesh)
    elif isinstance(source, tuple):
        source = places.in_triangles(source, contents)
    accuracy = DEFAULT_ACCURACY if options.accuracy is None else options.accuracy
    location, corners = places.locate(mesh, source)

    plain = structure_of(mesh)  # without any graph
    merging = {"merge_coincident_points": options.merge}
    given = {**merging, "projection_tolerance": options.tolerance}
    measured = {}
    if options.methods:
        from . import compare_methods

        how = options.merge, options.tolerance
        _, measured = compare_methods.measure(plain, source, accuracy, *how)
    first, first_time = timed(vtkdgg.distance, plain, source, method="fast", **given)
    graph, build_time = timed(vtkdgg.Graph, plain, accuracy=accuracy, **merging)
    query = Query(graph, source, options.tolerance)
    exact, exact_time = timed(vtkdgg.distance, plain, source, **given)
    floor = floor_of(mesh)
    sooner = Errors(first, exact, floor)
    raw = Errors(query.upper_bound, exact, floor)
    corrected = Errors(query.distances, exact, floor)
    agreement = bounds.compare(
        exact,
        bounds.upper_bound(mesh, location, corners),
        bounds.lower_bound(mesh, location),
    )
    paths, step = write(options.out, mesh, location, query, exact, corrected, accuracy)
    if measured:
        paths.append(os.path.join(options.out, "methods.png"))
        compare_methods.save(paths[-1], mesh, location, measured)

    searching = graph._graph.search_memory_size / 1e6
    report = graph._prepared.report()
    rows = (
        (
            "first answer",
            f"after {1e3 * first_time:.1f} ms, by virtual sources: mean error "
            f"{percent(sooner.mean)}, largest {percent(sooner.largest)}",
        ),
        ("mesh", options.mesh),
        ("vertices", mesh.GetNumberOfPoints()),
        ("triangles", mesh.GetNumberOfPolys()),
        ("topology", topology(report)),
        ("defects", defects_of(report)),
        ("reading", f"{read_time:.3f} s"),
        ("source", position(location, source)),
        *graph_rows(graph, build_time, query, f" ({searching:.1f} MB more for searches)"),
        ("exact", f"{1e3 * exact_time:.1f} ms for exact distances"),
        *error_rows(raw, corrected, accuracy),
        *near_rows(corrected, floor),
        *method_rows(measured),
        *distance_rows(query.distances, "vertices"),
        ("upper bound", bound_line(agreement["upper"], "edge graph")),
        ("lower bound", bound_line(agreement["lower"], "Euclid")),
        ("isolines", f"every {step:g} model units"),
        ("written", ", ".join(paths)),
    )
    return rows, notes(mesh), list(violations(raw, corrected, accuracy, agreement))


def violations(raw, corrected, accuracy, agreement):
    """Yields messages if a bound or the accuracy is violated."""
    broken = agreement["upper"]["violations"] + agreement["lower"]["violations"]
    if broken:
        yield f"{broken} exact distances violate a bound"
    if not (raw.keeps(accuracy) and corrected.keeps(accuracy) and raw.is_upper_bound):
        yield "an error exceeds the promised accuracy"
