# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands that answer one question: each takes its options, writes the file of --out if there
is one, and returns the answer as a dict."""

import contextlib
import time
import types
import warnings

import numpy as np
import vtkdgg

from .. import _kernel, arguments, meshes, paths, writing
from ..cloud_graph import require_clouds
from ..distances import METHODS as FUNCTIONS
from ..errors import Error, call, in_arguments
from ..graph import MAXIMUM_VALUES, even_values, find_isolines
from ..graph_info import arrays_of, choose_method, find_info
from ..results import voronoi_of
from ..surface import Surface
from . import files, places

# Methods of distances on a mesh.
METHODS = tuple(FUNCTIONS)
# Width of gaps that separate the components of a cloud, in spacings.
GAP = 5.0


class Negative(Exception):
    """The question has no answer; the text states the reason."""


def read(options):
    """Returns the contents of the file, and true for a cloud or the graph of a cloud."""
    contents = vtkdgg.read(options.file)
    graph = find_info(contents.field_data)
    is_cloud = options.cloud or (graph is not None and graph.is_cloud)
    return contents, is_cloud or files.is_cloud(contents)


def surface_of(options):
    """Returns the mesh of the file, for commands that need one."""
    contents, is_cloud = read(options)
    if is_cloud:
        raise ValueError(f"{options.file}: contains no surface, which {options.command} needs")
    return contents


def refuse_on_clouds(options):
    """Raises an error for options and methods that only meshes have."""
    files.refuse_on_clouds(options, "accuracy", "merge")
    method = getattr(options, "method", None)
    if method in ("exact", "fast"):
        raise ValueError(
            f"--method {method} applies to meshes, not to point clouds; expected graph or marching"
        )


def graph_of(options, contents, is_cloud=False):
    """Returns the graph of the file, or else builds one."""
    if is_cloud:
        refuse_on_clouds(options)
        return vtkdgg.CloudGraph(contents)
    if options.command == "graph":
        return vtkdgg.Graph(
            contents, accuracy=options.accuracy, merge_coincident_points=options.merge
        )
    return vtkdgg.Graph._of(contents, options.accuracy, options.merge)


def method_of(options, contents, is_cloud):
    """Returns the method of distances and paths: by default that of the graph of the file."""
    method = getattr(options, "method", None)
    if is_cloud:
        refuse_on_clouds(options)
        return method or "graph"
    return choose_method(method, options.accuracy, meshes.take(contents)[0], METHODS)[0]


def named(graph):
    """Returns the entries of an answer that name its graph."""
    return {
        "method": "graph",
        "pruned by" if graph.is_cloud else "accuracy": graph.accuracy,
        "construction": f"scheme {graph.construction}" if graph.is_cloud else graph.construction,
        "graph": "of the file" if graph.used_input_graph else "built",
    }


def several(texts, contents, name, only_ids=False):
    """Returns surface points as functions take them."""
    return [places.choose(text, contents, name, only_ids) for text in texts]


def sources_of(options, contents):
    """Returns the sources of all options that name them."""
    sources = several(options.source or [], contents, "--source")
    if options.sources is not None:
        sources += several(options.sources.split(","), contents, "--sources", True)
    if options.source_file is not None:
        sources += from_file(options.source_file, contents)
    if not sources:
        raise ValueError("there are no sources; give --source, --sources or --source-file")
    return sources


def from_file(path, contents):
    """Returns the sources of a text file."""
    sources = []
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.readlines()
    except UnicodeDecodeError:
        raise ValueError(f"{path}: expected a text file") from None
    for number, line in enumerate(lines, 1):
        words = line.partition("#")[0].replace(",", " ").split()
        if words:
            name = f"--source-file {path}, line {number}:"
            sources.append(places.choose(",".join(words), contents, name))
    return sources


def written(options, surface, result=None, graph=None, answer=None):
    """Writes the file if there is --out, and returns its entry of the answer.

    The surface, result and graph are as for Surface.polydata(). `answer` names the array that must
    not be lost; a .npy file holds it alone.
    """
    if options.out is None:
        return {}
    extension = writing.extension_of(options.out)
    if extension in writing.VTK:
        vtkdgg.write(options.out, surface.polydata(result, graph))
        return {"written": options.out}
    mesh = surface.mesh(result)
    if answer in writing.left_out(options.out, mesh):
        raise ValueError(f"{options.out}: {extension} cannot store {answer}; .vtk and .vtp can")
    if answer and extension == ".npy":
        writing.write_numbers(options.out, mesh.point_data[answer])
    else:
        vtkdgg.write(options.out, mesh)
    return {"written": options.out}


def graph_to_write(made, contents):
    """Returns the arrays of a graph if the file had one; otherwise None, because they are far
    larger than other results."""
    return made._arrays if "DGG.Info" in contents.field_data else None


def at_points(**arrays):
    """Returns arrays at the points of a surface as a result of the kernel; the first is active."""
    return types.SimpleNamespace(
        points=np.empty((0, 3)),
        point_data=arrays,
        cell_data={},
        field_data={},
        active={"points": next(iter(arrays)), "cells": None},
    )


def spread(values):
    """Returns the number and the range of the finite values."""
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (None, None)
    return {"reached": int(finite.size), "smallest": low, "largest": high}


def info(options):
    """Contents, size and defects of a file."""
    contents = vtkdgg.read(options.file)
    kind = "point cloud" if options.cloud else files.kind_of(contents)
    points = contents.points[np.isfinite(contents.points).all(axis=1)]
    ends = points.min(axis=0, initial=np.inf), points.max(axis=0, initial=-np.inf)
    found = {
        "kind": kind,
        "points": len(contents.points),
        "polygons": len(contents.polygons[0]) - 1,
        "bounds": np.transpose(ends).ravel().tolist(),
        "diagonal": float(np.linalg.norm(ends[1] - ends[0])),
        "point arrays": list(contents.point_data),
    }
    if arrays_of(contents.field_data):
        found["graph"] = state_of_graph(contents)
    if kind == "curves":
        found["lines"] = len(contents.lines[0]) - 1
        warnings.warn("there is no surface; --cloud uses the points only", stacklevel=2)
    if kind == "surface":
        prepared = Surface.of(contents).prepared()
        found["area"] = prepared.report()["area"]
        for key, text in prepared.describe().items():
            found.setdefault(key, number_of(text))
    if kind == "point cloud":
        cloud = files.finite_points(contents, options.file).points
        found["spacing"], found["components"] = call(_kernel.cloud_size, cloud, gap=GAP)
    return found


def state_of_graph(contents):
    """Returns the accuracy of the graph of the contents, and whether it is current."""
    arrays = arrays_of(contents.field_data)
    try:
        graph = _kernel.graph_info(arrays)
    except _kernel.Error as error:
        return in_arguments(error.problem)
    accuracy = "" if graph.accuracy is None else f", accuracy {graph.accuracy:g}"
    state = ", current"
    try:
        how = graph.merge_coincident_points, graph.merge_tolerance, graph.is_cloud
        call(_kernel.Graph.from_arrays, Surface.of(contents).prepared(*how), arrays)
    except Error as error:
        state = f". {error}"
    return f"{'scheme ' * graph.is_cloud}{graph.construction}{accuracy}{state}"


def number_of(text):
    """Returns the number that a text stands for, else the text."""
    for kind in (int, float):
        with contextlib.suppress(ValueError):
            return kind(text)
    return text


def graph(options):
    """Build a graph, and write it to a file."""
    start = time.perf_counter()
    made = graph_of(options, *read(options))
    return {
        "points": made.number_of_points,
        "edges": len(made.targets),
        "degree": made.degree,
        "bytes": made.nbytes,
        **named(made),
        "seconds": time.perf_counter() - start,
        **written(options, made._surface, None, made._arrays),
    }


def find_distances(options, contents, is_cloud=False, maximum=None):
    """Returns surface, result and graph for written(), and entries that name the method."""
    sources = sources_of(options, contents)
    method = method_of(options, contents, is_cloud)
    if method == "graph":
        made = graph_of(options, contents, is_cloud)
        result = made._distance(
            sources, maximum, None, options.tolerance, generate_nearest_source=True
        )
        return made._surface, result, graph_to_write(made, contents), named(made)
    if is_cloud:
        contents = files.points_of(contents)
    values = vtkdgg.distance(
        contents,
        sources,
        method=method,
        maximum_distance=maximum,
        merge_coincident_points=options.merge,
        projection_tolerance=options.tolerance,
    )
    surface = Surface.of(contents)
    if "DGG.Info" not in contents.field_data:
        surface = surface.copy()  # without other arrays of a graph, which is damaged
    return surface, at_points(GeodesicDistance=values), None, {"method": method}


def distance(options):
    """Distances of all points from the nearest source."""
    *output, used = find_distances(options, *read(options), options.maximum)
    values = output[1].point_data["GeodesicDistance"]
    found = {**used, "points": len(values), **spread(values)}
    return {**found, **written(options, *output, "GeodesicDistance")}


def matrix(options):
    """Distances between all pairs of points of two sets, or of one."""
    contents, is_cloud = read(options)
    rows = sources_of(options, contents)
    columns = None
    if options.targets is not None:
        columns = several(options.targets.split(","), contents, "--targets", True)
    made = graph_of(options, contents, is_cloud)
    with writing.replacing(options.out) as part:
        values = None
        if writing.extension_of(part) == ".npy":  # block by block: need not fit into memory
            shape = len(rows), len(rows if columns is None else columns)
            values = np.lib.format.open_memmap(part, "w+", np.float64, shape=shape)
        found = made.matrix(rows, columns, out=values, projection_tolerance=options.tolerance)
        if values is None:
            writing.write_numbers(part, found)
    return {
        "rows": found.shape[0],
        "columns": found.shape[1],
        "largest": float(np.fmax.reduce(found, axis=None)),
        **named(made),
        "written": options.out,
    }


def path(options):
    """Shortest path between two points."""
    contents, is_cloud = read(options)
    ends = [places.choose(getattr(options, name), contents, name) for name in ("start", "end")]
    used = {"method": method_of(options, contents, is_cloud)}
    try:
        if used["method"] == "graph":
            made = graph_of(options, contents, is_cloud)
            surface, used = made._surface, named(made)
            result = made._path(*ends, projection_tolerance=options.tolerance)
        else:
            surface, prepared, tolerance = exact_input(options, contents)
            ends = [
                arguments.surface_point(end, name, surface)
                for end, name in zip(ends, ("start", "end"))
            ]
            result = paths.find(prepared, *ends, method="Exact", **tolerance)
    except paths.NotConnectedError as error:
        raise Negative(str(error)) from None
    length = float(result.cell_data["Length"][0])
    points = result.points
    found = {"length": length, "points": points.tolist() if options.json else len(points)}
    return {**used, **found, **written(options, surface, result)}


def exact_input(options, contents):
    """Returns a surface, that of the kernel, and the tolerance of points as an option."""
    surface, _ = meshes.take(contents)
    return surface, surface.prepared(options.merge), {"projection_tolerance": options.tolerance}


def loop(options):
    """Closed geodesics."""
    contents = surface_of(options)
    if options.rope and not options.through:
        raise ValueError("--through: expected points for a rope, got none")
    points = several(options.through, contents, "--through") if options.through else None
    made = graph_of(options, contents)
    result = made._loops(points, options.rope, options.taut, options.tolerance)
    lengths = result.cell_data.get("Length", np.empty(0))
    if len(lengths) == 0:
        raise Negative("every loop contracts to a point")
    return {
        **named(made),
        "loops": len(lengths),
        "lengths": lengths.tolist(),
        **written(options, made._surface, result),
    }


def isolines(options):
    """Curves of equal distance."""
    contents = surface_of(options)
    sources = sources_of(options, contents)
    method = options.method or "graph"
    choose_method(method, options.accuracy, meshes.take(contents)[0], METHODS[:2])
    if method == "exact":
        used = {"method": method}
        surface, prepared, tolerance = exact_input(options, contents)
        sources = arguments.surface_points(sources, "sources", surface).in_kernel()
        field = call(
            _kernel.exact_distance, prepared, sources, generate_windows=True, **tolerance
        )
    else:
        made = graph_of(options, contents)
        used, surface, prepared = named(made), made._surface, made._prepared
        field = made._field(sources, None, options.tolerance)
    values = values_of(options, field.point_data["GeodesicDistance"])
    lines, _, _ = find_isolines(prepared, field, values)
    return {
        **used,
        "lines": len(lines.cells["lines"][0]) - 1,
        "values": np.unique(lines.cell_data["IsoValue"]).tolist(),
        **written(options, surface, lines),
    }


def values_of(options, distances):
    """Returns the distances of isolines that the options ask for."""
    if options.values:
        return options.values
    if options.every is None:
        count = 10 if options.count is None else options.count
        if not 1 <= count <= MAXIMUM_VALUES:
            raise ValueError(f"--count: expected 1 to {MAXIMUM_VALUES}, got {count}")
        return even_values(distances, count)
    if not options.every > 0.0:
        raise ValueError(f"--every: expected a positive number, got {options.every:g}")
    largest = np.fmax.reduce(distances)
    if largest / options.every > MAXIMUM_VALUES:
        raise ValueError(
            f"--every {options.every:g} makes more than {MAXIMUM_VALUES} isolines; expected at "
            f"least {largest / MAXIMUM_VALUES:g}"
        )
    values = options.every * np.arange(1, int(largest / options.every) + 1)
    if len(values) == 0:
        raise Negative(f"--every {options.every:g} is above the largest distance, {largest:g}")
    return values


def voronoi(options):
    """Voronoi cells of sites."""
    contents, is_cloud = read(options)
    if options.out and not is_cloud:
        files.check_format(options.out, "cells of a mesh")
    made = graph_of(options, contents, is_cloud)
    if options.site:
        sites = several(options.site, contents, "--site")
    else:
        number = 20 if options.number is None else options.number
        samples = made.sample(number, in_faces=options.in_faces)
        sites = samples.points if options.in_faces else samples.point_ids
    surface, _, polygons, moved = made._divide(sites, options.iterations, options.tolerance)
    cells = voronoi_of(surface, moved)
    radius = spread(cells.distances)["largest"]
    found = {**named(made), "sites": len(cells.sites), "covering radius": radius}
    if cells.areas is not None:
        found["areas"] = cells.areas.tolist()
    if options.out:
        output = polygons, None, "SiteId"
        if made.is_cloud or writing.extension_of(options.out) in writing.TABLES:
            result = at_points(GeodesicSource=cells.nearest, GeodesicDistance=cells.distances)
            output = result, graph_to_write(made, contents), "GeodesicSource"
        found.update(written(options, made._surface, *output))
    return found


def sample(options):
    """Evenly spread points."""
    made = graph_of(options, *read(options))
    result = made._samples(options.number, options.first, in_faces=options.in_faces)
    return {
        **named(made),
        "samples": len(result.points),
        "ids": result.point_data["vtkOriginalPointIds"].tolist(),
        "covering radius": float(result.point_data["CoveringRadius"][-1]),
        **written(options, made._surface, result),
    }


def greens(options):
    """Green's functions of the Laplacian."""
    contents = surface_of(options)
    values = vtkdgg.greens_function(
        contents,
        sources_of(options, contents),
        method=options.method,
        boundary=options.boundary,
        merge_coincident_points=options.merge,
        projection_tolerance=options.tolerance,
    )
    columns = values.reshape(len(values), -1)
    result = at_points(GreensFunction=values)
    return {
        "points": columns.shape[0],
        "sources": columns.shape[1],
        "smallest": columns.min(axis=0).tolist(),
        "largest": columns.max(axis=0).tolist(),
        **written(options, Surface.of(contents), result, None, "GreensFunction"),
    }


def render(options):
    """Picture of a surface with distances and isolines, or with another array."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    from .. import pictures  # rendering takes long to import
    from ..vtk_data import named_arrays, triangulated

    mesh = surface_of(options)
    source = None
    if options.source or options.sources or options.source_file:
        surface, result, _, _ = find_distances(options, mesh)
        contents = surface.polydata(result)
        source, _ = places.locate(contents, sources_of(options, mesh)[0])
    else:
        contents = mesh.as_polydata()
    array = contents.GetPointData().GetArray(options.array)
    if array is None or array.GetNumberOfComponents() > 1:
        known = ", ".join(named_arrays(contents.GetPointData())) or "none"
        remedy = "give another --array"
        if source is None:
            remedy = "give a --source, or a file that 'vtkdgg distance' has written"
        raise ValueError(
            f"{options.file}: there is no point array {options.array!r} with one component (found: "
            f"{known}); {remedy}"
        )
    mesh = triangulated(contents, options.file)
    values = vtk_to_numpy(mesh.GetPointData().GetArray(options.array))
    found = {**spread(values), "written": options.out}
    view = pictures.view_of(mesh, options.view) if options.view else None
    is_distance = options.array.endswith("Distance")
    if is_distance and source is None:
        source = np.array(mesh.GetPoint(int(np.nanargmin(values))))
    step = pictures.save_array(options.out, mesh, options.array, source, view, is_distance)
    return {**found, "isolines every": step} if is_distance else found


def explore(options):
    """Window on a surface or a cloud, for clicks and drags."""
    from .. import explorer

    contents, is_cloud = read(options)
    if is_cloud:
        refuse_on_clouds(options)
        require_clouds()
        contents = files.finite_points(contents, options.file)
    place = places.choose(options.source, contents)
    contents = contents.as_polydata()
    if is_cloud and place is not None and not isinstance(place, int):
        place = contents.FindPoint(place)
    elif isinstance(place, tuple):
        place, _ = places.locate(contents, place)
    scene = explorer.Scene(contents, is_cloud, options.accuracy, options.merge)
    window = explorer.explore(scene, place, options.out or "explore.png")
    return {"shown": scene.status(), "written": window.written}
