# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands that answer one question: each takes its options, writes the file of --out if there
is one, and returns the answer as a dict."""

import contextlib
import time
import warnings

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy

from .. import arguments, writing
from ..distances import FILTERS, set_sources
from ..errors import run
from ..graph import MOST_VALUES, even_values, find_isolines
from ..graph_info import CONSTRUCTIONS, GraphInfo, choose_method, has_graph, set_up
from ..paths import NotConnectedError
from ..results import voronoi_of
from ..surface import configured, named_arrays, with_arrays
from . import files, places, sizes

# Methods of distances on a mesh.
METHODS = tuple(FILTERS)


class Negative(Exception):
    """The question has no answer; the text states the reason."""


def read(options):
    """Returns the contents of the file, and true for a cloud or the graph of a cloud."""
    contents = vtkdgg.read(options.file).as_polydata()
    graph = GraphInfo.find(contents)
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
    accuracy, merging = options.accuracy, {"merge_coincident_points": options.merge}
    if accuracy is None or options.command == "graph" or not GraphInfo.find(contents):
        return vtkdgg.Graph(contents, accuracy=accuracy, **merging)
    try:
        made = vtkdgg.Graph(contents, **merging)
    except ValueError:  # it is damaged
        made = None
    if made is None or not made.used_input_graph:
        return vtkdgg.Graph(contents, accuracy=accuracy, **merging)
    if not GraphInfo(made.polydata).keeps(accuracy):
        warnings.warn(
            f"--accuracy {accuracy:g} is finer than the graph of {options.file}, which is used; "
            "'vtkdgg graph' builds a finer one",
            stacklevel=2,
        )
    return made


def method_of(options, contents, is_cloud):
    """Returns the method of distances and paths: by default that of the graph of the file."""
    method = getattr(options, "method", None)
    if is_cloud:
        refuse_on_clouds(options)
        return method or "graph"
    return choose_method(method, options.accuracy, contents, METHODS)[0]


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


def written(options, data, answer=None):
    """Writes the file if there is --out, and returns its entry of the answer. `answer` names the
    array that must not be lost; a .npy file holds it alone."""
    if options.out is None:
        return {}
    if answer in writing.left_out(options.out, data):
        extension = writing.extension_of(options.out)
        raise ValueError(f"{options.out}: {extension} cannot store {answer}; .vtk and .vtp can")
    if answer and writing.extension_of(options.out) == ".npy":
        values = vtk_to_numpy(data.GetPointData().GetArray(answer))
        writing.write_numbers(options.out, values)
    else:
        vtkdgg.write(options.out, data)
    return {"written": options.out}


def without_graph(data, contents):
    """Removes the graph, which is far larger than the data, unless the file had one."""
    fields = data.GetFieldData()
    if not contents.GetFieldData().HasArray("DGG.Info"):
        for name in named_arrays(fields):
            if name.startswith("DGG."):
                fields.RemoveArray(name)
    return data


def spread(values):
    """Returns the number and the range of the finite values."""
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (None, None)
    return {"reached": int(finite.size), "smallest": low, "largest": high}


def info(options):
    """Contents, size and defects of a file."""
    contents = vtkdgg.read(options.file).as_polydata()
    kind = "point cloud" if options.cloud else files.kind_of(contents)
    found = {
        "kind": kind,
        "points": contents.GetNumberOfPoints(),
        "polygons": contents.GetNumberOfPolys() + contents.GetNumberOfStrips(),
        "bounds": list(contents.GetBounds()),
        "diagonal": contents.GetLength(),
    }
    found["point arrays"] = list(named_arrays(contents.GetPointData()))
    if has_graph(contents):
        found["graph"] = state_of_graph(contents)
    if kind == "curves":
        found["lines"] = contents.GetNumberOfLines()
        warnings.warn("there is no surface; --cloud uses the points only", stacklevel=2)
    if kind == "surface":
        look = configured(vtkdgg.vtkExactGeodesicDistance(), InputData=contents)
        look.SetSourceIds([0])
        vtkdgg.check(configured(look, MaximumDistance=0.0))
        found["area"] = sizes.area(files.triangles_of(contents, options.file))
        for line in look.GetMeshReport().splitlines():
            key, _, value = line.partition(": ")
            found.setdefault(key, number_of(value))
    if kind == "point cloud":
        cloud = files.finite_points(files.points_of(contents), options.file)
        spacing = sizes.spacing_of(cloud)
        found.update({"spacing": spacing, "components": sizes.components_of(cloud, spacing)})
    return found


def state_of_graph(contents):
    """Returns what the graph of the contents promises, and if it belongs to them."""
    graph = GraphInfo.find(contents)
    if graph is None:
        return "damaged: DGG.Info is missing or of another version"
    kind = vtkdgg.CloudGraph if graph.is_cloud else vtkdgg.Graph
    state = "current"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            kind(contents, memory_limit=1)  # too little to build another one
        except vtkdgg.VTKError:
            state = "stale: it belongs to other points or cells"
        except (ImportError, ValueError) as error:
            state = str(error)
    name = CONSTRUCTIONS[graph.construction]
    accuracy = "" if graph.accuracy is None else f", accuracy {graph.accuracy:g}"
    return f"{'scheme ' * graph.is_cloud}{name}{accuracy}, {state}"


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
        **written(options, made.polydata),
    }


def find_distances(options, contents, is_cloud=False, **choices):
    """Returns the contents with distances from the sources, and entries that name the method."""
    sources = sources_of(options, contents)
    choices.update(projection_tolerance=options.tolerance, as_polydata=True)
    method = method_of(options, contents, is_cloud)
    if method == "graph":
        made = graph_of(options, contents, is_cloud)
        return made.distance(sources, **choices), named(made)
    output = vtkdgg.distance(
        files.points_of(contents) if is_cloud else contents,
        sources,
        method=method,
        merge_coincident_points=options.merge,
        **choices,
    )
    return output, {"method": method}


def distance(options):
    """Distances of all points from the nearest source."""
    contents, is_cloud = read(options)
    output, used = find_distances(options, contents, is_cloud, maximum_distance=options.maximum)
    output = without_graph(output, contents)
    values = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
    output.GetPointData().SetActiveScalars("GeodesicDistance")
    found = {**used, "points": len(values), **spread(values)}
    return {**found, **written(options, output, "GeodesicDistance")}


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
    tolerance = options.tolerance
    used = {"method": method_of(options, contents, is_cloud)}
    try:
        if used["method"] == "graph":
            made = graph_of(options, contents, is_cloud)
            used = named(made)
            output = made.path(*ends, projection_tolerance=tolerance, as_polydata=True)
        else:
            output = vtkdgg.path(
                contents,
                *ends,
                method="exact",
                merge_coincident_points=options.merge,
                projection_tolerance=tolerance,
                as_polydata=True,
            )
    except NotConnectedError as error:
        raise Negative(str(error)) from None
    length = output.GetCellData().GetArray("Length").GetValue(0)
    points = vtk_to_numpy(output.GetPoints().GetData())
    found = {"length": length, "points": points.tolist() if options.json else len(points)}
    return {**used, **found, **written(options, output)}


def loop(options):
    """Closed geodesics."""
    contents = surface_of(options)
    if options.rope and not options.through:
        raise ValueError("--through: expected points for a rope, got none")
    points = several(options.through, contents, "--through") if options.through else None
    made = graph_of(options, contents)
    output = made.loop(
        points,
        rope=options.rope,
        taut=options.taut,
        projection_tolerance=options.tolerance,
        as_polydata=True,
    )
    if output.GetNumberOfLines() == 0:
        raise Negative("every loop contracts to a point")
    lengths = vtk_to_numpy(output.GetCellData().GetArray("Length"))
    return {
        **named(made),
        "loops": len(lengths),
        "lengths": lengths.tolist(),
        **written(options, output),
    }


def isolines(options):
    """Curves of equal distance."""
    contents = surface_of(options)
    sources = sources_of(options, contents)
    method = options.method or "graph"
    choose_method(method, options.accuracy, contents, METHODS[:2])
    if method == "exact":
        used, graph_info = {"method": method}, None
        field = exact_windows(options, contents, sources)
    else:
        made = graph_of(options, contents)
        used, graph_info = named(made), GraphInfo(made.polydata)
        field = made._field(sources, None, options.tolerance)
    distances = vtk_to_numpy(field.GetPointData().GetArray("GeodesicDistance"))
    output = find_isolines(field, values_of(options, distances), options.merge, graph_info)
    found = vtk_to_numpy(output.GetCellData().GetArray("IsoValue"))
    return {
        **used,
        "lines": output.GetNumberOfLines(),
        "values": np.unique(found).tolist(),
        **written(options, output),
    }


def exact_windows(options, contents, sources):
    """Returns the contents with exact distances, at points and inside triangles."""
    solve = vtkdgg.vtkExactGeodesicDistance()
    solve.GenerateWindowsOn()
    set_up(solve, contents, options.merge, 0.0, options.tolerance)
    set_sources(solve, arguments.surface_points(sources, "sources", contents), None)
    return run(solve)


def values_of(options, distances):
    """Returns the distances of isolines that the options ask for."""
    if options.values:
        return options.values
    if options.every is None:
        count = 10 if options.count is None else options.count
        if not 1 <= count <= MOST_VALUES:
            raise ValueError(f"--count: expected 1 to {MOST_VALUES}, got {count}")
        return even_values(distances, count)
    if not options.every > 0.0:
        raise ValueError(f"--every: expected a positive number, got {options.every:g}")
    largest = np.fmax.reduce(distances)
    if largest / options.every > MOST_VALUES:
        raise ValueError(
            f"--every {options.every:g} makes more than {MOST_VALUES} isolines; expected at least "
            f"{largest / MOST_VALUES:g}"
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
        sites = made.sample(20 if options.number is None else options.number).point_ids
    divide = made._divide(sites, options.iterations, options.tolerance)
    cells = voronoi_of(divide)
    radius = spread(cells.distances)["largest"]
    found = {**named(made), "sites": len(cells.sites), "covering radius": radius}
    if cells.areas is not None:
        found["areas"] = cells.areas.tolist()
    if options.out:
        if made.is_cloud or writing.extension_of(options.out) in writing.TABLES:
            answer = "GeodesicSource"
            fields = {answer: cells.nearest, "GeodesicDistance": cells.distances}
            output = with_arrays(made.polydata, fields)
        else:
            answer = "SiteId"
            output = divide.GetCells()
        found.update(written(options, without_graph(output, contents), answer))
    return found


def sample(options):
    """Evenly spread points."""
    made = graph_of(options, *read(options))
    output = made.sample(
        options.number, first=options.first, in_faces=options.in_faces, as_polydata=True
    )
    radii = vtk_to_numpy(output.GetPointData().GetArray("CoveringRadius"))
    return {
        **named(made),
        "samples": output.GetNumberOfPoints(),
        "ids": vtk_to_numpy(output.GetPointData().GetArray("vtkOriginalPointIds")).tolist(),
        "covering radius": float(radii[-1]),
        **written(options, output),
    }


def greens(options):
    """Green's functions of the Laplacian."""
    contents = surface_of(options)
    output = vtkdgg.greens_function(
        contents,
        sources_of(options, contents),
        method=options.method,
        boundary=options.boundary,
        merge_coincident_points=options.merge,
        projection_tolerance=options.tolerance,
        as_polydata=True,
    )
    values = vtk_to_numpy(output.GetPointData().GetArray("GreensFunction")).reshape(
        output.GetNumberOfPoints(), -1
    )
    return {
        "points": values.shape[0],
        "sources": values.shape[1],
        "smallest": values.min(axis=0).tolist(),
        "largest": values.max(axis=0).tolist(),
        **written(options, output, "GreensFunction"),
    }


def render(options):
    """Picture of a surface with distances and isolines, or with another array."""
    from .. import pictures  # rendering takes long to import

    contents = surface_of(options)
    source = None
    if options.source or options.sources or options.source_file:
        contents, _ = find_distances(options, contents)
        source, _ = places.locate(contents, sources_of(options, contents)[0])
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
    mesh = files.triangles_of(contents, options.file)
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
        files.make_graph(contents)  # an error where there are none of clouds
        contents = files.finite_points(contents, options.file)
    place = places.choose(options.source, contents)
    if is_cloud and place is not None and not isinstance(place, int):
        place = contents.FindPoint(place)
    elif isinstance(place, tuple):
        place, _ = places.locate(contents, place)
    scene = explorer.Scene(contents, is_cloud, options.accuracy, options.merge)
    window = explorer.explore(scene, place, options.out or "explore.png")
    return {"shown": scene.status(), "written": window.written}
