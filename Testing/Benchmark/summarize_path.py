#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkPath.

Usage: summarize_path.py RESULT.json [TABLE.md]

The excess of a path is how much longer it is than the shortest one, relative to that.
"""

from benchmark_results import (
    DASH,
    Results,
    bytes_text,
    count_text,
    digits,
    environment,
    figure,
    first_of,
    in_form,
    median,
    number,
    ratio_text,
    run_as_script,
    tabulate,
    time_text,
    titled,
)

KINDS = {"Straight": "straightened", "Default": "default"}


class Run(Results):
    """groups[group][mesh][case]."""

    patterns = {"groups": r"(Path|Cells|Matrix)/([^/]+)/([A-Za-z]+)(?:/|$)"}

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


def kinds(run):
    """Mesh, kind of path and cases, of those that were measured."""
    meshes = run.meshes("Path", *KINDS)
    return [(mesh, kind, cases) for mesh, cases in meshes for kind in KINDS if cases.get(kind)]


def of_kind(form):
    """A column's function of what was measured of paths of a kind."""
    return lambda _, kind, cases: form(cases[kind])


def joined_of(form, *keys):
    return of_kind(lambda figures: joined(figures, keys, form))


def path_table(run):
    columns = [
        ("mesh", first_of),
        ("vertices", of_kind(lambda figures: count_text(median(figures, "vertices")))),
        ("path", lambda _, kind, cases: KINDS[kind]),
        ("ms: median / 90 % / 99 %", of_kind(milliseconds)),
        ("with landmarks", lambda _, kind, cases: milliseconds(cases.get("Marked" + kind))),
        (
            "% within 1e-6 / 1e-5 / 1e-4",
            joined_of(share_text, "within_1e6", "within_1e5", "within_1e4"),
        ),
        (
            "excess: median / mean / 99 % / max",
            joined_of(small, "excess_median", "excess_mean", "excess_p99", "excess_max"),
        ),
        ("beyond 1e-6: median / max", of_kind(outside_text)),
    ]
    return tabulate(columns, kinds(run))


def landmark_table(run):
    columns = [
        ("mesh", first_of),
        ("landmarks (wall)", figure("Landmarks")),
        ("threads", figure("Landmarks", "threads")),
        ("held after them", figure("Landmarks", "landmark_bytes", bytes_text)),
    ]
    return tabulate(columns, run.meshes("Path", "Landmarks"))


def peer_table(run):
    def excess(case, form):
        return lambda _, cases: joined(cases.get(case), ("excess_mean", "excess_max"), form)

    def in_percent(_, cases):
        both = excess("VertexVTK", lambda value: digits(100.0 * value))(_, cases)
        return both if both == DASH else both + " %"

    def ratio(_, cases):
        both = (cases.get(case) for case in ("VertexVTK", "VertexDefault"))
        return ratio_text(*(median(figures, "ms_mean") for figures in both))

    in_ms = in_form("{:.3g} ms")
    columns = [
        ("mesh", first_of),
        ("pairs of vertices", figure("VertexVTK", "pairs")),
        ("vtkDijkstraGraphGeodesicPath", figure("VertexVTK", "ms_mean", in_ms)),
        ("default path", figure("VertexDefault", "ms_mean", in_ms)),
        ("time", ratio),
        ("excess of VTK's: mean / max", in_percent),
        ("of the default: mean / max", excess("VertexDefault", small)),
    ]
    return tabulate(columns, run.meshes("Path", "VertexVTK"))


def cell_table(run):
    def of_either(key, form):
        return lambda _, cases: form(
            median(cases.get("FarthestPoints") or cases.get("Voronoi"), key)
        )

    times = in_form("{:.2f}x")
    columns = [
        ("mesh", first_of),
        ("vertices", of_either("vertices", count_text)),
        ("samples", of_either("samples", number)),
        ("farthest points", figure("FarthestPoints")),
        ("in 10 queries", figure("FarthestPoints", "per_ten_queries", times)),
        ("one query", figure("Voronoi", "query_seconds", time_text)),
        ("search from all samples, in queries", figure("Voronoi", "nearest_per_query", times)),
        ("labels of Voronoi cells, in queries", figure("Voronoi", "labels_per_query", times)),
        ("in corrected queries", figure("Voronoi", "labels_per_corrected", times)),
        ("whole diagram, in queries", figure("Voronoi", "diagram_per_query", times)),
        ("with refined borders", figure("Voronoi", "refined_per_query", times)),
    ]
    return tabulate(columns, run.meshes("Cells", "FarthestPoints", "Voronoi"))


def matrix_table(run):
    def error(_, cases):
        keys = ("error_mean", "error_max")
        return joined(cases["Update"], keys, lambda x: digits(100.0 * x)) + " %"

    columns = [
        ("mesh", first_of),
        ("matrix", figure("Update", "size", in_form("{0:.0f} x {0:.0f}"))),
        ("threads", figure("Update", "threads")),
        ("update (wall)", figure("Update")),
        ("error of a row: mean / max", error),
    ]
    return tabulate(columns, run.meshes("Matrix", "Update"))


def summarize(path):
    run = Run(path)
    parts = [
        f"CPU seconds on one thread, except for columns marked as wall-clock time "
        f"({environment(run.context)}).\n"
    ]
    titles = {
        "Paths between random points": path_table,
        "Landmarks": landmark_table,
        "Paths along edges": peer_table,
        "Farthest points and their cells": cell_table,
        "Matrices": matrix_table,
    }
    return "\n".join(parts + titled(run, titles))


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
