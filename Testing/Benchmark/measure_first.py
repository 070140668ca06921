# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time of each distance filter for its first and for further answers on a mesh, and its errors.

Usage: measure_first.py OUT.json OUT.md MESH...

Times are CPU times of Update() on one thread unless a table says otherwise: `new` for a new filter
and a new mesh, including the preparation of the mesh, `again` for another source on the same mesh.
Errors are relative to the exact distances, over all points from all sources.
"""

import statistics
import time

import modes
import numpy as np
import vtkdgg
from tables import column, count_text, folded, joined, listing, time_text, titled
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData

SOURCES = 10
NEW_MESHES = 5
SLOW = 2.0  # seconds above which a method is measured once

METHODS = {
    "virtual sources": modes.maker(vtkdgg.vtkVirtualSourceGeodesicDistance, Quality=1),
    "virtual sources, High": modes.maker(vtkdgg.vtkVirtualSourceGeodesicDistance, Quality=2),
    "graph, ε = 0.1": modes.maker(vtkdgg.vtkDGGDistance, Accuracy=0.1),
    "graph, ε = 0.01": modes.maker(vtkdgg.vtkDGGDistance, Accuracy=0.01),
    "heat": vtkdgg.vtkHeatGeodesicDistance,
    "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
    "exact": vtkdgg.vtkExactGeodesicDistance,
}


def first_updates(make, mesh, source, clock):
    """Returns the median time of updates on new meshes, and the filter of the last one."""
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


def further_updates(distance, sources, clock):
    """Returns the median time of updates from these sources, and the distances."""
    times, fields = [], []
    for source in sources:
        distance.SetSourceIds([source])
        distance.Modified()
        times.append(modes.timed(distance.Update, clock)[0])
        array = vtkdgg.check(distance).GetPointData().GetArray("GeodesicDistance")
        fields.append(vtk_to_numpy(array).copy())
    return statistics.median(times), fields


def measure_method(name, make, mesh, sources, exact):
    """Returns times and errors of one method on one mesh, and its distances."""
    new, distance = first_updates(make, mesh, sources[0], time.process_time)
    again, fields = further_updates(distance, sources, time.process_time)
    vtkSMPTools.Initialize(2)
    on_two_threads, _ = further_updates(distance, sources, time.perf_counter)
    vtkSMPTools.Initialize(1)
    errors = np.concatenate(
        [f[e > 0] / e[e > 0] - 1.0 for f, e in zip(fields, exact or fields) if np.any(e > 0)]
    )
    return {
        "method": name,
        "new": new,
        "again": again,
        "again_on_two_threads": on_two_threads,
        "mean": float(np.abs(errors).mean()),
        "p999": float(np.quantile(np.abs(errors), 0.999)),
        "least": float(errors.min()),
        "most": float(errors.max()),
    }, fields


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


def tables(results):
    """Returns a table of each quantity: a row per mesh, a column per method."""
    rows = [
        {"mesh": name, "points": found["points"], **{r["method"]: r for r in found["results"]}}
        for name, found in results.items()
    ]

    def by_method(form, *keys):
        first = [column("mesh", str, "mesh"), column("points", count_text, "points")]
        return listing(first + [column(method, form, method, *keys) for method in METHODS], rows)

    extremes = {
        "Another source, two threads, wall clock": by_method(time_text, "again_on_two_threads"),
        "Most negative / most positive error, %": by_method(
            joined(lambda value: f"{100 * value:+.2g}", "least", "most")
        ),
    }
    return titled(
        {
            "First answer on a new mesh": by_method(time_text, "new"),
            "Answer from another source": by_method(time_text, "again"),
            "Error, %: mean / 99.9 %": by_method(
                joined(lambda value: f"{100 * value:.2g}", "mean", "p999")
            ),
            "": folded("Two threads, extreme errors", titled(extremes)),
        }
    )


if __name__ == "__main__":
    modes.run(measure, tables, modes.parse(__doc__))
