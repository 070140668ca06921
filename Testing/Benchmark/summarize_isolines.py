#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkIsolines.

Usage: summarize_isolines.py RESULT.json [TABLE.md]

The error of a segment of an isoline is |d - c| / c, with the exact distance d at its midpoint and
its level c; means are over segments, as has been published, and ratios say how many times as large
the error of vtkContourFilter is.
"""

import re

from benchmark_results import (
    DASH,
    collect,
    count_text,
    digits,
    environment,
    load,
    median,
    percent,
    ratio_text,
    run_as_script,
    table,
    text,
    time_text,
    titled,
)

LINES = re.compile(
    r"^Isolines/(?P<mesh>[^/]+)/(?P<input>[A-Za-z]+)/(?P<case>[A-Za-z]+[0-9]*)(?:/|$)"
)
FIELDS = re.compile(
    r"^(?P<group>Approximate|Peer)/(?P<mesh>[^/]+)/(?P<method>[A-Za-z]+)/(?P<case>[A-Za-z]+)(?:/|$)"
)
METHODS = {
    "Contour": "vtkContourFilter",
    "Apollonius0": "Apollonius, k = 0",
    "Apollonius2": "Apollonius, k = 2",
    "Fitted": "fitted sources",
    "Sources": "virtual sources",
    "Windows": "windows",
}
INPUTS = {"Exact": "exact", "Graph": "DGG", "Heat": "heat", "Marching": "fast marching"}
STEINER = re.compile(r"^Apollonius(?P<count>[0-9]+)$")


class Run:
    """lines[mesh][input][case] and fields[mesh][method][case]: {figure: [values]}."""

    def __init__(self, path):
        self.context, results = load(path)
        self.lines = {}
        self.fields = {}
        for entry in results:
            lines, field = LINES.match(entry["name"]), FIELDS.match(entry["name"])
            if lines:
                inputs = self.lines.setdefault(lines["mesh"], {})
                cases = inputs.setdefault(lines["input"], {})
                collect(entry, cases.setdefault(lines["case"], {}))
            elif field:
                method = field["method"] + (" (CGAL)" if field["group"] == "Peer" else "")
                methods = self.fields.setdefault(field["mesh"], {})
                cases = methods.setdefault(method, {})
                collect(entry, cases.setdefault(field["case"], {}))

    def exact(self):
        """Mesh and cases of isolines of exact distances, small meshes first."""
        found = [
            (mesh, inputs["Exact"])
            for mesh, inputs in self.lines.items()
            if "Contour" in inputs.get("Exact", {})
        ]
        return sorted(found, key=lambda pair: size_of(pair[1]))


def size_of(cases):
    return median(cases["Contour"], "vertices")


def measured(run, methods):
    """Those of the methods that some mesh was measured with."""
    return [name for name in methods if any(name in cases for _, cases in run.exact())]


def geometric_mean(values):
    product = 1.0
    for value in values:
        product *= value ** (1.0 / len(values))
    return product


def error_table(run, key="error_mean"):
    methods = measured(run, METHODS)
    if not methods:
        return None
    rows, gains = [], {name: [] for name in methods}
    for mesh, cases in run.exact():
        linear = median(cases["Contour"], key)
        row = [mesh, count_text(size_of(cases))]
        for name in methods:
            error = median(cases.get(name), key)
            cell = percent(error)
            if name != "Contour" and error:
                gains[name].append(linear / error)
                cell += f" ({ratio_text(linear, error)})"
            row.append(cell)
        rows.append(row)
    total = ["geometric mean", ""]
    total += [f"{digits(geometric_mean(gains[name]))}x" if gains[name] else "" for name in methods]
    rows.append(total)
    header = ["mesh", "vertices"] + [METHODS[name] + ", %" for name in methods]
    return table(header, rows)


def length_table(run):
    """That of a mean which does not depend on how lines are cut into segments."""
    return error_table(run, "error_by_length")


def tail_table(run):
    methods = measured(run, METHODS)
    rows = []
    for mesh, cases in run.exact():
        row = [mesh]
        for name in methods:
            figures = [percent(median(cases.get(name), f"error_{key}")) for key in ("p999", "max")]
            row.append(DASH if DASH in figures else " / ".join(figures))
        row.append(
            " / ".join(
                text(median(cases.get(name), "fallbacks"), "{:.0f}")
                for name in ("Sources", "Windows")
            )
        )
        rows.append(row)
    header = ["mesh"] + [METHODS[name] + ", %" for name in methods]
    return table(header + ["fallbacks: virtual / windows"], rows)


def chord_table(run):
    """That the tolerance of chords does not matter, or how much."""
    names = ["", "Halved", "Drawn"]
    rows = []
    for mesh, cases in run.exact():
        if "Windows" not in cases:
            continue
        row = [mesh]
        for method in ("Windows", "Sources"):
            figures = [cases.get(method + name) for name in names]
            row += [percent(median(part, "error_mean")) for part in figures]
        rows.append(row)
    chords = {}
    for name in names:
        found = [median(cases.get("Windows" + name), "chord") for _, cases in run.exact()]
        chords[name] = next((text(value, "{:g}") for value in found if value), DASH)
    header = ["mesh"]
    header += [f"{kind}, {chords[name]} h, %" for kind in ("windows", "virtual") for name in names]
    return table(header, rows)


def input_table(run):
    rows = []
    for mesh, _ in run.exact():
        for kind, title in INPUTS.items():
            cases = run.lines[mesh].get(kind, {})
            linear = median(cases.get("Contour"), "error_mean")
            if kind == "Exact" or linear is None:
                continue
            sources = median(cases.get("Sources"), "error_mean")
            rows.append(
                [
                    mesh,
                    title,
                    percent(median(cases.get("Input"), "error_mean")),
                    percent(median(cases.get("Input"), "error_max")),
                    percent(linear),
                    percent(sources),
                    ratio_text(linear, sources),
                ]
            )
    header = [
        "mesh",
        "distances",
        "at vertices: mean, %",
        "max, %",
        "vtkContourFilter, %",
        "virtual sources, %",
        "gain",
    ]
    return table(header, rows)


def steiner_table(run):
    rows = []
    for mesh, cases in run.exact():
        counts = sorted(int(STEINER.match(case)["count"]) for case in cases if STEINER.match(case))
        if len(counts) < 3:  # only where more than the usual ones were measured
            continue
        linear = median(cases["Contour"], "error_mean")
        names = [(f"k = {count}", f"Apollonius{count}") for count in counts]
        names += [("virtual sources", "SourcesDrawn"), ("windows", "WindowsDrawn")]
        for title, name in names:
            figures = cases.get(name)
            if figures:
                error = median(figures, "error_mean")
                memory = median(figures, "heap_bytes_per_vertex") * size_of(cases)
                rows.append(
                    [
                        mesh,
                        title,
                        percent(error),
                        ratio_text(linear, error),
                        time_text(median(figures, "seconds")),
                        f"{memory / 1e6:.3g}",
                    ]
                )
    header = ["mesh", "method", "error, %", "gain", "time", "peak memory, MB"]
    return table(header, rows)


def time_table(run):
    names = {
        "Contour": "vtkContourFilter",
        "Apollonius2": "Apollonius, k = 2",
        "SourcesDrawn": "virtual sources",
        "WindowsDrawn": "windows",
    }
    names = {name: names[name] for name in measured(run, names)}
    rows = []
    for mesh, cases in run.exact():
        faces = median(cases["Contour"], "faces")
        row = [mesh, count_text(faces)]
        row += [time_text(median(cases.get(name), "seconds")) for name in names]
        for name in ("SourcesDrawn", "WindowsDrawn"):
            seconds = median(cases.get(name), "seconds")
            row.append(DASH if seconds is None else digits(1e6 * seconds / faces))
        segments = [median(cases.get(name), "segments") for name in ("Contour", "WindowsDrawn")]
        row.append(" / ".join(DASH if value is None else count_text(value) for value in segments))
        rows.append(row)
    header = ["mesh", "faces"] + list(names.values())
    header += ["virtual, µs per face", "windows, µs per face", "segments: linear / windows"]
    return table(header, rows)


def field_table(run):
    titles = {
        "Heat": ("heat", "Factors"),
        "Heat (CGAL)": ("heat (CGAL)", "Factors"),
        "Marching": ("fast marching", "Tables"),
    }
    rows = []
    for mesh, methods in run.fields.items():
        for method, (title, before) in titles.items():
            cases = methods.get(method)
            if not cases or "Query" not in cases:
                continue
            first, query = cases.get(before), cases.get("Query")
            memory = median(first, "heap_bytes_per_vertex")
            rows.append(
                [
                    mesh,
                    count_text(median(query, "vertices")),
                    title,
                    time_text(median(first, "seconds")),
                    text(memory, "{:.0f}"),
                    time_text(median(query, "seconds")),
                    percent(median(query, "error_mean")),
                    percent(median(query, "error_p999")),
                    percent(median(query, "error_max")),
                ]
            )
    header = ["mesh", "vertices", "method", "before queries", "peak bytes per vertex", "query"]
    header += ["error: mean, %", "99.9 %", "max, %"]
    return table(header, rows)


def summarize(path):
    run = Run(path)
    levels = [median(cases["Contour"], "levels") for _, cases in run.exact()]
    spread = f"; {levels[0]:.0f} levels evenly over the distances from one vertex" if levels else ""
    parts = [f"CPU seconds on one thread ({environment(run.context)}){spread}.\n"]
    titles = {
        "Isolines of exact distances: mean error (gain over linear)": error_table,
        "The same, weighted by the length of segments": length_table,
        "Largest errors: 99.9 % / all": tail_table,
        "Tolerance of chords, in mean edges h: mean error": chord_table,
        "Isolines of approximate distances": input_table,
        "Steiner points per edge": steiner_table,
        "Times": time_table,
        "Approximate distances": field_table,
    }
    return "\n".join(parts + titled(run, titles))


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
