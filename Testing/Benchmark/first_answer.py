# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""How soon each distance filter answers on a new mesh, and again; and how far off it is.

Usage: first_answer.py OUT.json OUT.md MESH...

Times are those of Update(), one thread and CPU time unless a column says otherwise: `new` for a
filter and a mesh that have not been seen, with the mesh prepared as all filters do; `again` for
another source on the same mesh. Errors are relative to the exact distances, over all points from
all sources.
"""

import json
import os
import statistics
import sys
import time

import numpy as np
import vtkdgg
from benchmark_results import tabulate, time_text
from vtkdgg.commands.methods import graph, propagation
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData

SOURCES = 10
NEW_MESHES = 5
SLOW = 2.0  # seconds: what takes longer is measured once


METHODS = {
    "virtual sources": propagation(1),
    "virtual sources, High": propagation(2),
    "graph, ε = 0.1": graph(0.1),
    "graph, ε = 0.01": graph(0.01),
    "heat": vtkdgg.vtkHeatGeodesicDistance,
    "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
    "exact": vtkdgg.vtkExactGeodesicDistance,
}


def read(path):
    """The surface in a file, with nothing but points and polygons."""
    from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOPLY import vtkPLYReader

    readers = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader}
    reader = readers[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    mesh = vtkPolyData()
    mesh.CopyStructure(vtkdgg.check(reader))
    return mesh


def seconds(clock, algorithm):
    """What an update takes."""
    start = clock()
    algorithm.Update()
    return clock() - start


def first_updates(make, mesh, source, clock):
    """Times of updates on new meshes, and the filter of the last one."""
    times = []
    while len(times) < NEW_MESHES:
        copy = vtkPolyData()
        copy.DeepCopy(mesh)
        distance = make()
        distance.SetInputData(copy)
        distance.SetSourceIds([source])
        times.append(seconds(clock, distance))
        if times[-1] > SLOW:
            break
    return statistics.median(times), distance


def measure(name, make, mesh, sources, exact):
    """Times and errors of one method on one mesh."""
    new, distance = first_updates(make, mesh, sources[0], time.process_time)
    again = []
    fields = []
    for source in sources:
        distance.SetSourceIds([source])
        distance.Modified()
        again.append(seconds(time.process_time, distance))
        array = vtkdgg.check(distance).GetPointData().GetArray("GeodesicDistance")
        fields.append(vtk_to_numpy(array).copy())
    vtkSMPTools.Initialize(2)
    pairs = []
    for source in sources:
        distance.SetSourceIds([source])
        distance.Modified()
        pairs.append(seconds(time.perf_counter, distance))
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


def table(name, points, results):
    """A Markdown table of one mesh."""
    heat = next((r["new"] for r in results if r["method"] == "heat"), float("nan"))
    columns = [
        ("method", lambda r: r["method"]),
        ("new mesh", lambda r: time_text(r["new"])),
        ("of heat's", lambda r: f"{r['new'] / heat:.2f}"),
        ("again", lambda r: time_text(r["again"])),
        ("points a second", lambda r: f"{points / r['again'] / 1e6:.2f} M"),
        ("two threads, wall clock", lambda r: time_text(r["again_on_two_threads"])),
        ("error, %: mean / 99.9 %", lambda r: f"{100 * r['mean']:.2g} / {100 * r['p999']:.2g}"),
        ("least / most", lambda r: f"{100 * r['least']:+.2g} / {100 * r['most']:+.2g}"),
    ]
    return f"**{name}**, {points} points\n\n" + tabulate(columns, [(r,) for r in results])


def main(json_path, table_path, meshes):
    """Measure all methods on all meshes."""
    vtkSMPTools.Initialize(1)
    everything = {}
    tables = []
    for path in meshes:
        name = os.path.splitext(os.path.basename(path))[0]
        mesh = read(path)
        points = mesh.GetNumberOfPoints()
        sources = [points * (2 * k + 1) // (2 * SOURCES) for k in range(SOURCES)]
        exact, fields = measure("exact", METHODS["exact"], mesh, sources, None)
        results = [
            measure(method, make, mesh, sources, fields)[0]
            for method, make in METHODS.items()
            if method != "exact"
        ] + [exact]
        everything[name] = {"points": points, "results": results}
        tables.append(table(name, points, results))
        print(tables[-1], flush=True)
    with open(json_path, "w", encoding="utf-8") as out:
        json.dump(everything, out, indent=1)
    with open(table_path, "w", encoding="utf-8") as out:
        out.write("\n".join(tables))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
