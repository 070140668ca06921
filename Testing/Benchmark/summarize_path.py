#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkPath.

Usage: summarize_path.py RESULT.json [TABLE.md]

The excess of a path is how much longer it is than the shortest one, relative to that.
"""

import re

from benchmark_results import (
    DASH,
    bytes_text,
    collect,
    count_text,
    digits,
    environment,
    load,
    median,
    number,
    ratio_text,
    run_as_script,
    table,
    text,
    time_text,
    titled,
)

NAME = re.compile(r"^(?P<group>Path|Cells|Matrix|Loop)/(?P<mesh>[^/]+)/(?P<case>[A-Za-z]+)(?:/|$)")
KINDS = {"Raw": "as in the graph", "Straight": "straightened", "Default": "default"}


class Run:
    """groups[group][mesh][case]: {figure: [values]}."""

    def __init__(self, path):
        self.context, results = load(path)
        self.groups = {}
        for entry in results:
            match = NAME.match(entry["name"])
            if match:
                meshes = self.groups.setdefault(match["group"], {})
                cases = meshes.setdefault(match["mesh"], {})
                collect(entry, cases.setdefault(match["case"], {}))

    def meshes(self, group, *cases):
        """Mesh and cases of a group, where one of these cases was measured."""
        for mesh, found in self.groups.get(group, {}).items():
            if any(case in found for case in cases):
                yield mesh, found


def small(value):
    """Figures around rounding, which may be negative, are zero."""
    return "0" if abs(value) < 1e-12 else f"{value:.1e}"


def joined(figures, keys, form):
    values = [median(figures, key) for key in keys]
    return DASH if None in values else " / ".join(form(value) for value in values)


def share_text(value):
    """A percentage that is 100 for all only."""
    if value in (0.0, 1.0):
        return f"{100.0 * value:.0f}"
    return f"{min(100.0 * value, 99.99):.2f}".rstrip("0").rstrip(".")


def milliseconds(figures):
    return joined(figures, ("ms_median", "ms_p90", "ms_p99"), digits)


def outside_text(figures):
    count = median(figures, "outside")
    if not count:
        return number(count)
    return f"{count:.0f}: " + joined(figures, ("outside_median", "outside_max"), small)


def path_table(run):
    rows = []
    for mesh, cases in run.meshes("Path", *KINDS):
        for kind, title in KINDS.items():
            figures = cases.get(kind)
            if figures:
                rows.append(
                    [
                        mesh,
                        count_text(median(figures, "vertices")),
                        title,
                        milliseconds(figures),
                        milliseconds(cases.get("Marked" + kind)),
                        joined(figures, ("within_1e6", "within_1e5", "within_1e4"), share_text),
                        joined(
                            figures,
                            ("excess_median", "excess_mean", "excess_p99", "excess_max"),
                            small,
                        ),
                        outside_text(figures),
                    ]
                )
    header = [
        "mesh",
        "vertices",
        "path",
        "ms: median / 90 % / 99 %",
        "with landmarks",
        "% within 1e-6 / 1e-5 / 1e-4",
        "excess: median / mean / 99 % / max",
        "beyond 1e-6: median / max",
    ]
    return table(header, rows)


def check_table(run):
    columns = {
        "pairs": "pairs",
        "unconnected": "not connected",
        "mismatches": "connected for one of the two only",
        "too_short": "shorter than exact",
        "longer": "longer than before straightening",
        "invalid": "not on the surface",
        "unstraightened": "not straightened",
        "fallbacks": "edges found anew",
    }
    rows = []
    for mesh, cases in run.meshes("Path", *KINDS):
        for kind, title in KINDS.items():
            if kind in cases:
                figures = [number(median(cases[kind], key)) for key in columns]
                if kind == "Raw":
                    figures[list(columns).index("unstraightened")] = DASH
                rows.append([mesh, title] + figures)
    return table(["mesh", "path"] + list(columns.values()), rows)


def before_table(run):
    rows = []
    for mesh, cases in run.meshes("Path", "Graph", "FirstPath", "Landmarks", "Exact"):
        graph, landmarks = cases.get("Graph"), cases.get("Landmarks")
        size = median(graph, "graph_bytes")
        marks = median(landmarks, "landmark_bytes")
        rows.append(
            [
                mesh,
                time_text(median(graph, "seconds")),
                number(median(graph, "threads")),
                bytes_text(size),
                time_text(median(cases.get("FirstPath"), "seconds")),
                time_text(median(landmarks, "seconds")),
                bytes_text(marks),
                time_text(median(cases.get("Exact"), "seconds")),
                time_text(median(cases.get("ShortKept"), "seconds")),
                time_text(median(cases.get("ShortAnew"), "seconds")),
            ]
        )
    header = [
        "mesh",
        "graph (wall)",
        "threads",
        "its size",
        "preparation + first path",
        "landmarks (wall)",
        "held after them",
        "exact propagation",
        "exact path of 3 edges",
        "by a new finder",
    ]
    return table(header, rows)


def peer_table(run):
    rows = []
    for mesh, cases in run.meshes("Path", "VertexVTK"):
        theirs, ours = cases["VertexVTK"], cases.get("VertexDefault")
        rows.append(
            [
                mesh,
                number(median(theirs, "pairs")),
                text(median(theirs, "ms_mean"), "{:.3g} ms"),
                text(median(ours, "ms_mean"), "{:.3g} ms"),
                ratio_text(median(theirs, "ms_mean"), median(ours, "ms_mean")),
                excess_percent(theirs),
                joined(ours, ("excess_mean", "excess_max"), small),
            ]
        )
    header = [
        "mesh",
        "pairs of vertices",
        "vtkDijkstraGraphGeodesicPath",
        "default path",
        "time",
        "excess of VTK's: mean / max",
        "of the default: mean / max",
    ]
    return table(header, rows)


def excess_percent(figures):
    both = joined(figures, ("excess_mean", "excess_max"), lambda value: digits(100.0 * value))
    return both if both == DASH else both + " %"


def cell_table(run):
    rows = []
    for mesh, cases in run.meshes("Cells", "FarthestPoints", "Voronoi"):
        points, cells = cases.get("FarthestPoints"), cases.get("Voronoi")
        either = points or cells
        rows.append(
            [
                mesh,
                count_text(median(either, "vertices")),
                number(median(either, "samples")),
                time_text(median(points, "seconds")),
                text(median(points, "per_ten_queries"), "{:.2f}x"),
                time_text(median(cells, "query_seconds")),
                text(median(cells, "nearest_per_query"), "{:.2f}x"),
                text(median(cells, "labels_per_query"), "{:.2f}x"),
                text(median(cells, "labels_per_corrected"), "{:.2f}x"),
                text(median(cells, "diagram_per_query"), "{:.2f}x"),
                text(median(cells, "refined_per_query"), "{:.2f}x"),
            ]
        )
    header = [
        "mesh",
        "vertices",
        "samples",
        "farthest points",
        "in 10 queries",
        "one query",
        "search from all samples, in queries",
        "labels of Voronoi cells, in queries",
        "in corrected queries",
        "whole diagram, in queries",
        "with refined borders",
    ]
    return table(header, rows)


def matrix_table(run):
    rows = []
    for mesh, cases in run.meshes("Matrix", "Update"):
        figures = cases["Update"]
        size = number(median(figures, "size"))
        rows.append(
            [
                mesh,
                f"{size} x {size}",
                number(median(figures, "threads")),
                time_text(median(figures, "seconds")),
                joined(figures, ("error_mean", "error_max"), lambda x: digits(100.0 * x)) + " %",
            ]
        )
    header = ["mesh", "matrix", "threads", "update (wall)", "error of a row: mean / max"]
    return table(header, rows)


def loop_table(run):
    rows = []
    for mesh, cases in run.meshes("Loop", "AroundHandles", "ThroughPoint"):
        handles = cases.get("AroundHandles")
        row = [mesh, time_text(median(handles, "seconds"))]
        loops, runs = median(handles, "loops"), median(handles, "runs")
        fixed = median(handles, "empty")
        row.append(
            (DASH if loops is None else digits(loops / runs))
            + (f" and {digits(fixed / runs)} fixed" if fixed else "")
        )
        for case in ("ThroughPoint", "ThroughPointTaut"):
            figures = cases.get(case)
            found = f" ({joined(figures, ('loops', 'runs'), number)})" if figures else ""
            row.append(time_text(median(figures, "seconds")) + found)
        invalid = [median(figures, "invalid") for figures in cases.values()]
        row.append(number(sum(value for value in invalid if value is not None)))
        rows.append(row)
    header = [
        "mesh",
        "around handles",
        "loops",
        "through a point (found / asked)",
        "let go there",
        "invalid",
    ]
    return table(header, rows)


def summarize(path):
    run = Run(path)
    parts = [
        f"CPU seconds on one thread, but for what is marked to be on the wall "
        f"({environment(run.context)}).\n"
    ]
    titles = {
        "Paths between random points": path_table,
        "What comes before paths": before_table,
        "Paths along edges": peer_table,
        "Checks of all paths": check_table,
        "Farthest points and their cells": cell_table,
        "Matrices": matrix_table,
        "Loops (median times)": loop_table,
    }
    return "\n".join(parts + titled(run, titles))


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
