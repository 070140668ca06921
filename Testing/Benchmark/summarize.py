#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkExact.

Usage: summarize.py RESULT.json [TABLE.md]

Every figure is the median over the sources of a mesh, measured in one run. Ratios are against our
engine T. The exponents of growth are least-squares lines through log(figure) over log(vertices).
"""

import math
import re
import statistics

from benchmark_results import (
    collect,
    count_text,
    load,
    median,
    run_as_script,
    seconds_text,
    table,
)

NAME = re.compile(
    r"^(?P<group>Exact|Growth)/(?P<mesh>[^/]+)/(?P<case>SetUp|T|R|VTK|CGAL)(?:/(?P<source>\d+))?(?:/|$)"
)
TITLES = {"R": "engine R", "CGAL": "CGAL exact", "VTK": "vtkDijkstraGraphGeodesicPath"}


def read(path):
    """{group: {mesh: {case: {figure: [one value per source]}}}}, in the order of the file."""
    context, results = load(path)
    groups = {"Exact": {}, "Growth": {}}
    for entry in results:
        match = NAME.match(entry["name"])
        if match:
            cases = groups[match["group"]].setdefault(match["mesh"], {})
            collect(entry, cases.setdefault(match["case"], {}))
    return context, groups


def time_table(meshes, peers):
    rows = []
    for mesh, cases in meshes.items():
        ours = median(cases.get("T"), "seconds")
        if ours is None:
            continue
        windows = median(cases["T"], "windows")
        row = [
            mesh,
            count_text(median(cases["T"], "vertices")),
            seconds_text(ours),
            f"{count_text(windows)} x {1e9 * ours / windows:.0f} ns",
        ]
        for peer in peers:
            theirs = median(cases.get(peer), "seconds")
            row.append("–" if theirs is None else f"{theirs / ours:.3g}x ({seconds_text(theirs)})")
        rows.append(row)
    header = ["mesh", "vertices", "engine T", "windows"] + [TITLES[peer] for peer in peers]
    return table(header, rows)


def memory_table(meshes, peers):
    rows = []
    for mesh, cases in meshes.items():
        own_mesh = median(cases.get("SetUp"), "mesh_bytes_per_vertex")
        row = [mesh, "–" if own_mesh is None else f"{own_mesh:.0f}"]
        for case in ["T"] + peers:
            peak = median(cases.get(case), "heap_bytes_per_vertex")
            row.append("–" if peak is None else f"{peak:.0f}")
        rows.append(row)
    return table(["mesh", "our mesh", "engine T"] + [TITLES[peer] for peer in peers], rows)


def error_table(meshes, peers):
    rows = []
    for mesh, cases in meshes.items():
        for peer in peers:
            figures = cases.get(peer)
            if median(figures, "error_max") is not None:
                rows.append(
                    [mesh, TITLES[peer]]
                    + [
                        f"{median(figures, key):.2g}"
                        for key in ("error_mean", "error_p999", "error_max")
                    ]
                )
    return table(["mesh", "against engine T", "mean", "99.9 %", "max"], rows)


def exponent(points):
    """Slope of the least-squares line through (log x, log y)."""
    xs = [math.log(x) for x, _ in points]
    ys = [math.log(y) for _, y in points]
    x_mean = statistics.fmean(xs)
    y_mean = statistics.fmean(ys)
    return sum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys)) / sum(
        (x - x_mean) ** 2 for x in xs
    )


def growth_table(meshes):
    rows = []
    seconds = []
    windows = []
    for mesh, cases in meshes.items():
        figures = cases.get("T")
        if not figures:
            continue
        vertices = median(figures, "vertices")
        seconds.append((vertices, median(figures, "seconds")))
        windows.append((vertices, median(figures, "windows")))
        peak = median(figures, "heap_bytes_per_vertex")
        rows.append(
            [
                mesh,
                f"{vertices:.0f}",
                seconds_text(seconds[-1][1]),
                f"{windows[-1][1] / vertices:.0f}",
                f"{1e9 * seconds[-1][1] / windows[-1][1]:.0f}",
                "–" if peak is None else f"{peak:.0f}",
            ]
        )
    header = ["mesh", "vertices", "engine T", "windows per vertex", "ns per window", "peak B/vertex"]
    text = table(header, rows)
    if len(seconds) > 1:
        text += (
            f"\nLeast squares over {len(seconds)} sizes: time grows as n^{exponent(seconds):.2f}, "
            f"windows as n^{exponent(windows):.2f}.\n"
        )
    return text


def summarize(path):
    context, groups = read(path)
    exact = groups["Exact"]
    measured = {case for cases in exact.values() for case in cases}
    parts = []
    about = ", ".join(
        f"{key} {context[key]}"
        for key in ("compiler", "vtk_version", "cgal_version")
        if key in context
    )
    parts.append(f"CPU seconds on one thread, median over the sources of a mesh ({about}).\n")
    if exact:
        timed = [peer for peer in ("R", "CGAL", "VTK") if peer in measured]
        weighed = [peer for peer in ("R", "CGAL") if peer in measured]
        parts.append("**Exact distance from one vertex to all** (peers: times engine T)\n")
        parts.append(time_table(exact, timed))
        parts.append("**Peak memory, bytes per vertex above the loaded mesh**\n")
        parts.append(memory_table(exact, weighed))
        parts.append("**Relative error**\n")
        parts.append(error_table(exact, timed))
    if groups["Growth"]:
        parts.append("**Growth**\n")
        parts.append(growth_table(groups["Growth"]))
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
