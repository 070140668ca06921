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
    Results,
    count_text,
    digits,
    environment,
    figure,
    first_of,
    median,
    percent,
    ratio_text,
    run_as_script,
    size_text,
    table,
    tabulate,
    text,
    titled,
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


class Run(Results):
    """lines[mesh][input][case] and fields[mesh][method][case]."""

    patterns = {
        "lines": r"Isolines/([^/]+)/([A-Za-z]+)/([A-Za-z]+[0-9]*)(?:/|$)",
        "fields": r"(Approximate|Peer)/([^/]+)/([A-Za-z]+)/([A-Za-z]+)(?:/|$)",
    }

    def key(self, group, match):
        *origin, mesh, method, case = match.groups()
        return mesh, method + (" (CGAL)" if origin == ["Peer"] else ""), case

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


def in_percent(case, key="error_mean"):
    return figure(case, key, percent)


def gain(case):
    """How many times as large the error of linear isolines is."""

    def make(*row):
        linear, error = (median(row[-1].get(name), "error_mean") for name in ("Contour", case))
        return ratio_text(linear, error)

    return make


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
    def largest(name):
        def make(_, cases):
            figures = [percent(median(cases.get(name), f"error_{key}")) for key in ("p999", "max")]
            return DASH if DASH in figures else " / ".join(figures)

        return make

    def fallbacks(_, cases):
        return " / ".join(figure(name, "fallbacks")(cases) for name in ("Sources", "Windows"))

    columns = [("mesh", first_of)]
    columns += [(METHODS[name] + ", %", largest(name)) for name in measured(run, METHODS)]
    return tabulate(columns + [("fallbacks: virtual / windows", fallbacks)], run.exact())


def chord_table(run):
    """That the tolerance of chords does not matter, or how much."""
    columns = [("mesh", first_of)]
    for title, method in (("windows", "Windows"), ("virtual", "Sources")):
        for name in ("", "Halved", "Drawn"):
            found = [median(cases.get("Windows" + name), "chord") for _, cases in run.exact()]
            chord = next((text(value, "{:g}") for value in found if value), DASH)
            columns.append((f"{title}, {chord} h, %", in_percent(method + name)))
    return tabulate(columns, [row for row in run.exact() if "Windows" in row[1]])


def input_table(run):
    columns = [
        ("mesh", first_of),
        ("distances", lambda _, title, cases: title),
        ("at vertices: mean, %", in_percent("Input")),
        ("max, %", in_percent("Input", "error_max")),
        ("vtkContourFilter, %", in_percent("Contour")),
        ("virtual sources, %", in_percent("Sources")),
        ("gain", gain("Sources")),
    ]
    rows = [
        (mesh, title, run.lines[mesh].get(kind, {}))
        for mesh, _ in run.exact()
        for kind, title in INPUTS.items()
        if kind != "Exact"
    ]
    rows = [row for row in rows if median(row[2].get("Contour"), "error_mean") is not None]
    return tabulate(columns, rows)


def steiner_table(run):
    def memory(_, __, name, cases):
        taken = median(cases[name], "heap_bytes_per_vertex") * size_of(cases)
        return f"{taken / 1e6:.3g}"

    columns = [
        ("mesh", first_of),
        ("method", lambda _, title, name, cases: title),
        ("error, %", lambda _, title, name, cases: in_percent(name)(cases)),
        ("gain", lambda _, title, name, cases: gain(name)(cases)),
        ("time", lambda _, title, name, cases: figure(name)(cases)),
        ("peak memory, MB", memory),
    ]
    rows = []
    for mesh, cases in run.exact():
        counts = sorted(int(STEINER.match(case)["count"]) for case in cases if STEINER.match(case))
        names = [(f"k = {count}", f"Apollonius{count}") for count in counts]
        names += [("virtual sources", "SourcesDrawn"), ("windows", "WindowsDrawn")]
        if len(counts) > 2:  # only where more than the usual ones were measured
            rows += [(mesh, title, name, cases) for title, name in names if cases.get(name)]
    return tabulate(columns, rows)


def time_table(run):
    def per_face(name):
        def make(_, cases):
            seconds = median(cases.get(name), "seconds")
            faces = median(cases["Contour"], "faces")
            return DASH if seconds is None else digits(1e6 * seconds / faces)

        return make

    def segments(_, cases):
        counts = [median(cases.get(name), "segments") for name in ("Contour", "WindowsDrawn")]
        return " / ".join(size_text(count) for count in counts)

    titles = {
        "Contour": "vtkContourFilter",
        "Apollonius2": "Apollonius, k = 2",
        "SourcesDrawn": "virtual sources",
        "WindowsDrawn": "windows",
    }
    columns = [("mesh", first_of), ("faces", figure("Contour", "faces", count_text))]
    columns += [(titles[name], figure(name)) for name in measured(run, titles)]
    columns += [
        ("virtual, µs per face", per_face("SourcesDrawn")),
        ("windows, µs per face", per_face("WindowsDrawn")),
        ("segments: linear / windows", segments),
    ]
    return tabulate(columns, run.exact())


def field_table(run):
    titles = {
        "Heat": ("heat", "Factors"),
        "Heat (CGAL)": ("heat (CGAL)", "Factors"),
        "Marching": ("fast marching", "Tables"),
    }

    def before(key):
        return lambda _, method, cases: figure(titles[method][1], key)(cases)

    columns = [
        ("mesh", first_of),
        ("vertices", figure("Query", "vertices", count_text)),
        ("method", lambda _, method, cases: titles[method][0]),
        ("before queries", before("seconds")),
        ("peak bytes per vertex", before("heap_bytes_per_vertex")),
        ("query", figure("Query")),
        ("error: mean, %", in_percent("Query")),
        ("99.9 %", in_percent("Query", "error_p999")),
        ("max, %", in_percent("Query", "error_max")),
    ]
    rows = [
        (mesh, method, methods[method])
        for mesh, methods in run.fields.items()
        for method in titles
        if "Query" in methods.get(method, {})
    ]
    return tabulate(columns, rows)


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
