# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""How soon each distance filter answers on a new mesh, and again; and how far off it is.

Usage: measure_first.py OUT.json OUT.md MESH...

Times are those of Update(), one thread and CPU time unless a column says otherwise: `new` for a
filter and a mesh that have not been seen, with the mesh prepared as all filters do; `again` for
another source on the same mesh. Errors are relative to the exact distances, over all points from
all sources.
"""

import statistics
import time

import modes
import numpy as np
import vtkdgg
from benchmark_results import time_text
from exhibits.tables import column, hundredths, joined, listing
from vtkdgg.commands.methods import graph, propagation
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData

SOURCES = 10
NEW_MESHES = 5
SLOW = 2.0  # seconds above which a method is measured once

METHODS = {
    "virtual sources": propagation(1),
    "virtual sources, High": propagation(2),
    "graph, ε = 0.1": graph(0.1),
    "graph, ε = 0.01": graph(0.01),
    "heat": vtkdgg.vtkHeatGeodesicDistance,
    "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
    "exact": vtkdgg.vtkExactGeodesicDistance,
}


def first_updates(make, mesh, source, clock):
    """Times of updates on new meshes, and the filter of the last one."""
    times = []
    while len(times) < NEW_MESHES:
        copy = vtkPolyData()
        copy.DeepCopy(mesh)
        distance = make()
        distance.SetInputData(copy)
        distance.SetSourceIds([source])
        times.append(modes.timed(distance.Update, clock)[0])
        if times[-1] > SLOW:
            break
    return statistics.median(times), distance


def measure_method(name, make, mesh, sources, exact):
    """Times and errors of one method on one mesh."""
    new, distance = first_updates(make, mesh, sources[0], time.process_time)
    again = []
    fields = []
    for source in sources:
        distance.SetSourceIds([source])
        distance.Modified()
        again.append(modes.timed(distance.Update)[0])
        array = vtkdgg.check(distance).GetPointData().GetArray("GeodesicDistance")
        fields.append(vtk_to_numpy(array).copy())
    vtkSMPTools.Initialize(2)
    pairs = []
    for source in sources:
        distance.SetSourceIds([source])
        distance.Modified()
        pairs.append(modes.timed(distance.Update, time.perf_counter)[0])
    vtkSMPTools.Initialize(1)
    result = {
        "method": name,
        "new": new,
        "again": statistics.median(again),
        "again_on_two_threads": statistics.median(pairs),
    }
    reference = exact or fields
    errors = np.concatenate(
        [f[e > 0] / e[e > 0] - 1.0 for f, e in zip(fields, reference) if np.any(e > 0)]
    )
    sizes = np.abs(errors)
    result["mean"] = float(sizes.mean())
    result["p999"] = float(np.quantile(sizes, 0.999))
    result["least"] = float(errors.min())
    result["most"] = float(errors.max())
    return result, fields


def measure(options):
    """Returns the figures of all methods on all meshes."""
    found = {}
    for path in options.meshes:
        name, mesh = modes.open_mesh(path)
        points = mesh.GetNumberOfPoints()
        sources = [points * (2 * k + 1) // (2 * SOURCES) for k in range(SOURCES)]
        exact, fields = measure_method("exact", METHODS["exact"], mesh, sources, None)
        results = [
            measure_method(method, make, mesh, sources, fields)[0]
            for method, make in METHODS.items()
            if method != "exact"
        ]
        found[name] = {"points": points, "results": [*results, exact]}
    return found


def table(name, points, results):
    """A Markdown table of one mesh."""
    heat = next(r["new"] for r in results if r["method"] == "heat")

    def two_digits(value):
        return f"{100 * value:.2g}"

    columns = (
        column("method", str, "method"),
        column("new mesh", time_text, "new"),
        column("of heat's", lambda new: hundredths(new / heat), "new"),
        column("again", time_text, "again"),
        column("points a second", lambda again: f"{points / again / 1e6:.2f} M", "again"),
        column("two threads, wall clock", time_text, "again_on_two_threads"),
        ("error, %: mean / 99.9 %", joined(two_digits, "mean", "p999")),
        ("least / most", joined(lambda value: f"{100 * value:+.2g}", "least", "most")),
    )
    return listing(columns, results, f"**{name}**, {points} points")


def tables(results):
    return "\n".join(table(name, **found) for name, found in results.items())


if __name__ == "__main__":
    modes.run(measure, tables, modes.parse(__doc__))
