# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""`vtkdgg compare` on a mesh: errors of distances in a graph against exact distances."""

import os
import time

import vtkdgg

from .. import arguments
from ..checks import counted
from ..vtk_data import triangulated, with_arrays
from . import bounds, places
from .compare import DEFAULT_ACCURACY
from .measured import Errors
from .methods import Direct, Graph, Query, builder
from .output import defects, distance_rows, graph_rows, position
from .sizes import floor_of, notes

ERROR_COLUMNS = "{:<10} {:<10} {}".format
# Names of methods in `vtkdgg distance --method`.
METHODS = {"virtual sources": "fast", "fast marching": "marching"}


def counts_of(distance):
    """Returns a function that returns an integer of the mesh report by its name."""
    report = distance.GetMeshReportTable()
    return lambda name: int(report.GetColumnByName(name).GetValue(0))


def defects_of(distance):
    """Returns a line that counts the defects of the mesh."""
    count = counts_of(distance)
    others = [] if count("Orientable") else ["no consistent orientation"]
    return defects(
        others,
        (count("NumberOfNonManifoldEdges"), "non-manifold edge"),
        (count("NumberOfNonManifoldVertices"), "non-manifold vertex", "non-manifold vertices"),
        (
            count("NumberOfDroppedFaces"),
            "face with repeated points",
            "faces with repeated points",
        ),
        (count("NumberOfDegenerateFaces"), "triangle without area", "triangles without area"),
        (count("NumberOfDuplicateFaces"), "duplicate triangle"),
        (count("NumberOfCoincidentPoints"), "coincident point"),
        (count("NumberOfIsolatedPoints"), "isolated point"),
    )


def topology(distance):
    """Returns a line on components, boundary and genus."""
    count = counts_of(distance)
    genus = count("Genus")
    return (
        f"components {count('NumberOfComponents')}, "
        f"boundary loops {count('NumberOfBoundaryLoops')}, "
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
    arguments.accuracy(accuracy)
    location, corners = places.locate(mesh, source)

    given = mesh, source, options.merge, options.tolerance
    measured = {}
    if options.methods:
        from . import compare_methods

        _, measured = compare_methods.measure(mesh, source, accuracy, *given[2:])
    first = Direct(vtkdgg.vtkVirtualSourceGeodesicDistance, *given)
    graph = Graph(builder(mesh, "Guaranteed", accuracy, merge=options.merge))
    query = Query(graph, *given)
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

    searching = (query.filter.GetMemorySize() - graph.filter.GetMemorySize()) / 1e6
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
        ("defects", defects_of(query.filter)),
        ("reading", f"{read_time:.3f} s"),
        ("source", position(location, source)),
        *graph_rows(graph, query, f" ({searching:.1f} MB more for searches)"),
        ("exact", f"{1e3 * exact.time:.1f} ms for exact distances"),
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
