# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines of distances by all methods, compared with vtkContourFilter: errors and times.

Usage: measure_isolines.py OUT.json OUT.md [--name=value ...] [MESH ...]

  --sizes=600,1000,5000,10000,50000  numbers of vertices. Larger meshes are decimated, and those with
                  at least a quarter of the number are decimated to that and subdivided (Loop)
  --levels=20     isolines, evenly over the range of the exact distances
  --chord=1e-5    tolerance of lines in mean edges; half of it, and the default, are measured as well
  --steiner=0,2   points per edge of the published method
  --more_steiner=1,5,10,20,50  the same in addition, for the first mesh at its smallest and largest size
  --accuracy=0.01  of the graph

The error of a segment of an isoline is |d - c| / c, with the exact distance d at its midpoint and its
level c. Means are over segments, as published. The gain is the error of vtkContourFilter divided by
that of a method. Times are CPU times of Update() on one thread, the shortest of several.
"""

import statistics

import modes
import numpy as np
import vtkdgg
from tables import column, count_text, digits, gain_text, hundredths, joined, listing, percent, titled
from vtkdgg.commands.measured import Errors
from vtkdgg.commands.sizes import floor_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter

DRAWN = 1e-3  # the default tolerance of lines
METHODS = {
    "Contour": "vtkContourFilter",
    "Apollonius0": "Apollonius, k = 0",
    "Apollonius2": "Apollonius, k = 2",
    "Fitted": "fitted sources",
    "Sources": "virtual sources",
    "Windows": "windows",
}
INPUTS = {
    "DGG": lambda accuracy: modes.maker(vtkdgg.vtkDGGDistance, Accuracy=accuracy),
    "heat": lambda _: vtkdgg.vtkHeatGeodesicDistance,
    "fast marching": lambda _: vtkdgg.vtkDGGFastMarchingDistance,
}


def solved(make, mesh, sources, windows=False):
    """Returns the surface with distances by a filter, and what lines inside faces need: windows, or
    virtual sources."""
    distance = make()
    distance.SetInputData(mesh)
    distance.SetSourceIds(sources)
    if windows:
        distance.GenerateWindowsOn()
    else:
        distance.GenerateVirtualSourceOn()
    return vtkdgg.check(distance)


def exact_with(mesh, sources, windows):
    """Returns the surface with exact distances, and windows or virtual sources."""
    return solved(vtkdgg.vtkExactGeodesicDistance, mesh, sources, windows)


def distances_of(surface):
    """Returns the distances of the points."""
    return vtk_to_numpy(surface.GetPointData().GetArray("GeodesicDistance"))


def distances_only(surface):
    """Returns the surface with its distances, without what lines inside faces need."""
    plain = vtkPolyData()
    plain.CopyStructure(surface)
    plain.GetPointData().AddArray(surface.GetPointData().GetArray("GeodesicDistance"))
    return plain


def levels_of(surface, count=20):
    """Returns levels evenly over the range of the distances."""
    return np.nanmax(distances_of(surface)) * np.arange(1, count + 1) / (count + 1)


def linear(surface, levels):
    """Returns the filter of isolines that are linear in triangles."""
    lines = vtkContourFilter()
    lines.SetInputArrayToProcess(0, 0, 0, 0, "GeodesicDistance")
    lines.SetOutputPointsPrecision(lines.DOUBLE_PRECISION)
    return _with_levels(lines, surface, levels)


def traced(surface, levels, steiner=None, chord=DRAWN):
    """Returns the filter of curved isolines, by the published method with a number of points per
    edge."""
    lines = vtkdgg.vtkApolloniusIsolines()
    lines.SetChordTolerance(chord)
    if steiner is not None:
        lines.SetMethodToApollonius()
        lines.SetSteinerPoints(steiner)
    return _with_levels(lines, surface, levels)


def _with_levels(lines, surface, levels):
    lines.SetInputData(surface)
    for i, level in enumerate(levels):
        lines.SetValue(i, level)
    return lines


def segments_of(lines):
    """Returns midpoints, lengths and levels of the segments of polylines."""
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    inside = np.ones(max(0, len(ids) - 1), bool)
    inside[offsets[1:-1] - 1] = False
    levels = lines.GetCellData().GetArray("IsoValue")
    if levels:
        levels = np.repeat(vtk_to_numpy(levels), np.diff(offsets))[:-1]
    else:
        levels = vtk_to_numpy(lines.GetPointData().GetScalars())[ids[:-1]]
    begin, end = points[ids[:-1]][inside], points[ids[1:]][inside]
    lengths = np.linalg.norm(end - begin, axis=1)
    used = lengths > 0.0
    return 0.5 * (begin + end)[used], lengths[used], levels[inside][used]


def line_errors(exact, lines):
    """Returns the errors of isolines against the exact distances of a surface with windows."""
    places, lengths, levels = segments_of(lines)
    probe = vtkdgg.vtkGeodesicProbe()
    probe.SetInputData(exact)
    probe.SetProbeData(vtkdgg.Mesh(places).as_polydata())
    sizes = np.abs(distances_of(vtkdgg.check(probe)) / levels - 1.0)
    used = np.isfinite(sizes)
    sizes, lengths = sizes[used], lengths[used]
    return {
        "mean": float(sizes.mean()),
        "by length": float(sizes @ lengths / lengths.sum()),
        "p999": float(np.quantile(sizes, 0.999)),
        "max": float(sizes.max()),
        "segments": len(sizes),
    }


def measured(exact, lines):
    """Returns time and errors of the lines of a filter."""

    def update():
        lines.Modified()
        return vtkdgg.check(lines)

    seconds, output = modes.fastest(update)
    found = {**line_errors(exact, output), "seconds": seconds}
    if hasattr(lines, "GetNumberOfFallbacks"):
        found["fallbacks"] = lines.GetNumberOfFallbacks()
    return found


def measure_exact(mesh, exact, levels, chord, steiner):
    """Returns the figures of isolines of exact distances, by method."""
    sources = exact_with(mesh, [0], False)
    lines = {"Contour": linear(sources, levels)}
    for count in sorted(steiner):
        lines[f"Apollonius{count}"] = traced(sources, levels, count)
    lines["Fitted"] = traced(distances_only(sources), levels, chord=chord)
    for name, surface in (("Sources", sources), ("Windows", exact)):
        for suffix, tolerance in (("", chord), ("Halved", 0.5 * chord), ("Drawn", DRAWN)):
            lines[name + suffix] = traced(surface, levels, chord=tolerance)
    return {name: measured(exact, line) for name, line in lines.items()}


def measure_mesh(mesh, options, steiner):
    """Returns all figures of one mesh."""
    exact = exact_with(mesh, [0], True)
    levels = levels_of(exact, options.levels)
    found = {
        "vertices": mesh.GetNumberOfPoints(),
        "faces": mesh.GetNumberOfPolys(),
        "chord": options.chord,
        "exact": measure_exact(mesh, exact, levels, options.chord, steiner),
        "inputs": {},
    }
    for title, make in INPUTS.items() if options.accuracy else ():
        field = solved(make(options.accuracy), mesh, [0])
        errors = Errors(distances_of(field), distances_of(exact), floor_of(mesh))
        found["inputs"][title] = {
            "vertices": {"mean": errors.mean, "max": errors.largest},
            "Contour": measured(exact, linear(field, levels)),
            "Sources": measured(exact, traced(field, levels, chord=options.chord)),
        }
    return found


def at_sizes(mesh, sizes):
    """Yields the mesh at the numbers of vertices that it can be brought to."""
    for size in sizes:
        if size <= mesh.GetNumberOfPoints():
            yield size, modes.decimated(mesh, size)
        elif size // 4 <= mesh.GetNumberOfPoints():
            yield size, modes.subdivided(modes.decimated(mesh, size // 4))


def measure(options):
    """Returns the figures of all meshes, by name and size."""
    found = {}
    for i, name in enumerate(options.meshes or modes.default_meshes("bumpy-6", "torus-100")):
        title, whole = modes.open_mesh(name)
        meshes = list(at_sizes(whole, options.sizes))
        for k, (size, mesh) in enumerate(meshes):
            is_end = i == 0 and k in (0, len(meshes) - 1)
            steiner = {*options.steiner, *(options.more_steiner if is_end else ())}
            found[f"{title}-{count_text(size)}"] = measure_mesh(mesh, options, steiner)
    return dict(sorted(found.items(), key=lambda item: item[1]["vertices"]))


def steiner_counts(cases):
    """Returns the numbers of Steiner points that were measured."""
    prefix = "Apollonius"
    return [int(name[len(prefix) :]) for name in cases if name.startswith(prefix)]


def named(results):
    """Returns a row per mesh: its name, its sizes and the figures by method."""
    return [{"mesh": mesh, **found, **found["exact"]} for mesh, found in results.items()]


def gain(row, case, key="mean"):
    """Returns how many times as large the error of linear isolines is."""
    return row["Contour"][key] / row[case][key]


MESH = column("mesh", str, "mesh")
VERTICES = column("vertices", count_text, "vertices")


def error_table(results):
    rows = named(results)
    methods = [name for name in METHODS if all(name in row for row in rows)]

    def cell(row, name):
        ratio = "" if name == "Contour" else f" ({gain_text(gain(row, name))})"
        return percent(row[name]["mean"]) + ratio

    columns = [MESH, VERTICES]
    columns += [
        (f"{METHODS[name]}, %", lambda row, name=name: cell(row, name)) for name in methods
    ]
    made = listing(columns, rows)
    # The mean weighted by length does not depend on the number of segments.
    for key, title in {"mean": "geometric mean", "by length": "weighted by length"}.items():
        gains = [
            gain_text(statistics.geometric_mean(gain(row, name, key) for row in rows))
            for name in methods[1:]
        ]
        made += f"| {' | '.join([title, '', '', *gains])} |\n"
    return made


def tail_table(results):
    columns = [MESH]
    columns += [
        column(f"{title}, %", joined(percent, "p999", "max"), name)
        for name, title in METHODS.items()
    ]
    columns += [
        column(f"fallbacks: {METHODS[name]}", str, name, "fallbacks")
        for name in ("Sources", "Windows")
    ]
    return listing(columns, named(results))


def chord_table(results):
    chord = next(iter(results.values()))["chord"]
    columns = [MESH]
    for method in ("Windows", "Sources"):
        for suffix, size in (("", chord), ("Halved", 0.5 * chord), ("Drawn", DRAWN)):
            title = f"{METHODS[method]}, {size:g} h, %"
            columns.append(column(title, percent, method + suffix, "mean"))
    return listing(columns, named(results))


def input_table(results):
    columns = (
        MESH,
        column("distances", str, "input"),
        column("at vertices: mean, %", percent, "vertices", "mean"),
        column("max, %", percent, "vertices", "max"),
        column("vtkContourFilter, %", percent, "Contour", "mean"),
        column("virtual sources, %", percent, "Sources", "mean"),
        ("gain", lambda row: gain_text(gain(row, "Sources"))),
    )
    rows = [
        {"mesh": mesh, "input": title, **cases}
        for mesh, found in results.items()
        for title, cases in found["inputs"].items()
    ]
    return listing(columns, rows)


def steiner_table(results):
    titles = {"SourcesDrawn": "virtual sources", "WindowsDrawn": "windows"}
    rows = []
    for row in named(results):
        counts = steiner_counts(row)
        if len(counts) > 2:  # only if additional counts were measured
            cases = {f"Apollonius{count}": f"k = {count}" for count in counts}
            rows += [
                {"mesh": row["mesh"], "method": title, "gain": gain(row, name), **row[name]}
                for name, title in {**cases, **titles}.items()
            ]
    columns = (
        MESH,
        column("method", str, "method"),
        column("error, %", percent, "mean"),
        column("gain", gain_text, "gain"),
        column("seconds", hundredths, "seconds"),
    )
    return listing(columns, rows)


def time_table(results):
    titles = {
        "Contour": METHODS["Contour"],
        "Apollonius2": METHODS["Apollonius2"],
        "SourcesDrawn": METHODS["Sources"],
        "WindowsDrawn": METHODS["Windows"],
    }
    columns = [MESH, column("faces", count_text, "faces")]
    columns += [
        column(f"{title}, ms", lambda value: digits(1e3 * value), name, "seconds")
        for name, title in titles.items()
    ]
    columns += [
        column(f"segments: {titles[name]}", count_text, name, "segments")
        for name in ("Contour", "WindowsDrawn")
    ]
    return listing(columns, named(results))


def tables(results):
    """Returns all tables."""
    makers = {
        "Isolines of exact distances: mean error (gain over linear)": error_table,
        "Largest errors: 99.9 % / all": tail_table,
        "Tolerance of chords, in mean edges h: mean error": chord_table,
        "Isolines of approximate distances": input_table,
        "Steiner points per edge": steiner_table,
        "CPU time of one thread": time_table,
    }
    return titled({title: make(results) for title, make in makers.items()})


def parse(arguments=None):
    """Returns the options of a command line."""
    return modes.parse(
        __doc__,
        arguments,
        sizes=(600, 1000, 5000, 10000, 50000),
        levels=20,
        chord=1e-5,
        steiner=(0, 2),
        more_steiner=(1, 5, 10, 20, 50),
        accuracy=0.01,
    )


if __name__ == "__main__":
    modes.run(measure, tables, parse())
