#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkCloud.

Usage: summarize_cloud.py RESULT.json [TABLE.md]

Published are the mean errors of Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
University, 2019, chapter 5, at a resolution of 512 voxels, for models of the same kind and size.
"""

import re

from benchmark_results import (
    DASH,
    bytes_text,
    collect,
    environment,
    errors_text,
    first_median,
    folded,
    largest,
    load,
    mean,
    median,
    number,
    peak_text,
    percent,
    quotient_text,
    ratio_text,
    run_as_script,
    size_text,
    table,
    text,
    time_text,
    titled,
)

NAME = re.compile(
    r"^(?P<group>Cloud|Guard|Speed|Curve)/(?P<cloud>[^/]+)/"
    r"(?P<graph>[ABC]/(?:chord|arc|fine)|Band/march|Mesh)/"
    r"(?:(?P<parameter>Alpha|Offset)/(?P<value>[0-9.]+)/)?"
    r"(?P<case>Build|Estimate|Query)(?:/|$)"
)
METHODS = {
    "A/chord": "A, chords",
    "A/arc": "A, arcs",
    "B/chord": "B, chords",
    "B/arc": "B, arcs",
    "C/chord": "C, chords",
    "C/arc": "C, arcs (default)",
    "C/fine": "C, arcs",
    "Band/march": "fast marching",
}
# What was published for models of the same kind: beginning of the name of a cloud, number of
# points, and the least and largest mean error of graphs.
PUBLISHED = (
    ("sphere", 655000, (7e-5, 7e-5)),
    ("torus", 57000, (1.2e-3, 1.7e-3)),
    ("terrain", 66000, (3.1e-3, 3.8e-3)),
    ("bunny", 30000, (1.7e-3, 2.3e-3)),
)
# How many times as many points, or as few, still make a model of the same size.
SAME_SIZE = 1.25
# Above this share of points that are not reached there is no mean error.
MOST_UNREACHED = 0.01
PUBLISHED_MARCHING = (1.8e-2, 3.7e-2)
GUARDS = {
    "noise_0.5": "noise, 0.5 % of the box",
    "noise_1": "noise, 1 % of the box",
    "density_10": "density 10 : 1",
    "holes": "holes",
    "sheets": "two sheets, 3 h apart",
}
# Clouds that are measured with balls of a given radius, only to see whether parts stay apart.
FORCED = {"sheets"}


class Run:
    """groups[group][cloud][graph][case]: {figure: [values]}, and those of curves by parameter and
    value: curves[cloud][graph][parameter][value][case]."""

    def __init__(self, path):
        self.context, results = load(path)
        self.groups = {"Cloud": {}, "Guard": {}, "Speed": {}}
        self.curves = {}
        for entry in results:
            match = NAME.match(entry["name"])
            if not match:
                continue
            if match["group"] == "Curve":
                cases = self.curves.setdefault(match["cloud"], {}).setdefault(match["graph"], {})
                cases = cases.setdefault(match["parameter"], {})
                cases = cases.setdefault(float(match["value"]), {})
            else:
                clouds = self.groups[match["group"]]
                cases = clouds.setdefault(match["cloud"], {}).setdefault(match["graph"], {})
            collect(entry, cases.setdefault(match["case"], {}))

    def graphs(self, group, names):
        """Cloud, graph and cases of a group, in the order of the names."""
        for cloud, graphs in self.groups[group].items():
            for name in names:
                if name in graphs:
                    yield cloud, name, graphs[name]


def method_of(graph, cases):
    """The method, and the accuracy of those that are not built with the default."""
    accuracy = median(cases.get("Build"), "accuracy") if graph == "C/fine" else None
    return METHODS[graph] + ("" if accuracy is None else f", accuracy {accuracy:g}")


def published_of(cloud, graph, points):
    """None when there is no such model, or it is of another size."""
    found = next(
        (
            errors
            for name, size, errors in PUBLISHED
            if cloud.startswith(name) and points and 1 / SAME_SIZE < points / size < SAME_SIZE
        ),
        None,
    )
    return PUBLISHED_MARCHING if found and graph == "Band/march" else found


def unreached_text(query):
    """Points that are not reached, and those that are reached without a way on the surface."""
    beyond = largest(query, "reached_beyond")
    wrong = f", {beyond:.0f} wrongly reached" if beyond else ""
    return number(largest(query, "unreached")) + wrong


def range_text(values):
    if values is None:
        return DASH
    return " to ".join(percent(value) for value in sorted(set(values)))


def points_of(graphs):
    """The number of points of a cloud; marching does not tell it."""
    return first_median((cases.get("Build") for cases in graphs.values()), "points")


def mean_text(graphs, graph, published=None):
    """Mean error in percent, and how many times smaller it is than the published one."""
    query = graphs.get(graph, {}).get("Query")
    error, unreached = mean(query, "error_mean"), largest(query, "unreached")
    points = points_of(graphs)
    # Of a part only, it says nothing of the method.
    if error is None or (unreached and points and unreached > MOST_UNREACHED * points):
        return DASH
    better = f" ({ratio_text(published[0], error)})" if published else ""
    return percent(error) + better


def mean_table(run):
    rows = []
    for cloud, graphs in run.groups["Cloud"].items():
        points = points_of(graphs)
        published = published_of(cloud, "C/arc", points)
        schemes = [
            f"{mean_text(graphs, scheme + '/chord')} / {mean_text(graphs, scheme + '/arc')}"
            for scheme in "AB"
        ]
        rows.append(
            [
                cloud,
                size_text(points),
                range_text(published),
                *schemes,
                mean_text(graphs, "C/chord"),
                mean_text(graphs, "C/arc", published),
                mean_text(graphs, "C/fine", published),
                mean_text(graphs, "Band/march"),
            ]
        )
    header = [
        "cloud",
        "points",
        "published",
        "A: chords / arcs",
        "B: chords / arcs",
        "C: chords",
        "C: arcs (default)",
        "C: arcs, finer",
        "fast marching",
    ]
    return table(header, rows)


def error_table(run):
    rows = []
    for cloud, graph, cases in run.graphs("Cloud", METHODS):
        build, query = cases.get("Build"), cases.get("Query")
        points = points_of(run.groups["Cloud"][cloud])
        spacing, reach = median(build, "spacing"), median(build, "reach")
        published = published_of(cloud, graph, points)
        rows.append(
            [
                cloud,
                size_text(points),
                method_of(graph, cases),
                text(median(build, "degree"), "{:.0f}"),
                quotient_text(reach, spacing),
                errors_text(query),
                unreached_text(query),
                range_text(published) + ("" if published is None else " %"),
                ratio_text(published[0], mean(query, "error_mean")) if published else DASH,
                time_text(median(query, "seconds")),
            ]
        )
    header = [
        "cloud",
        "points",
        "method",
        "degree",
        "reach, spacings",
        "error: mean / 99.9 % / max",
        "unreached",
        "published mean",
        "published / ours",
        "query",
    ]
    return table(header, rows)


def guard_table(run):
    rows = []
    for cloud, graph, cases in run.graphs("Guard", METHODS):
        build, query = cases.get("Build"), cases.get("Query")
        components = median(build, "components")
        rows.append(
            [
                GUARDS.get(cloud, cloud),
                method_of(graph, cases),
                text(median(build, "noise"), "{:.2g}"),
                DASH if cloud in FORCED else errors_text(query),
                unreached_text(query),
                number(median(build, "false_edges")),
                number(components),
            ]
        )
    header = [
        "cloud",
        "method",
        "noise found",
        "error: mean / 99.9 % / max",
        "unreached",
        "edges between sheets",
        "components",
    ]
    return table(header, rows)


def speed_table(run):
    rows = []
    for cloud, _, cases in run.graphs("Speed", ["C/arc"]):
        build, estimate, query = (cases.get(case) for case in ("Build", "Estimate", "Query"))
        mesh = run.groups["Speed"][cloud].get("Mesh", {})
        predicted = median(estimate, "estimated_peak_bytes")
        measured = median(build, "resident_bytes")
        points = median(build, "points")
        rows.append(
            [
                cloud,
                size_text(points),
                time_text(median(build, "seconds")),
                time_text(median(build, "cpu_seconds")),
                number(median(build, "threads")),
                text(median(build, "degree"), "{:.0f}"),
                bytes_text(median(build, "graph_bytes")),
                peak_text(predicted, measured),
                time_text(median(query, "seconds")),
                errors_text(query),
                time_text(median(mesh.get("Build"), "seconds")),
                time_text(median(mesh.get("Query"), "seconds")),
                errors_text(mesh.get("Query")),
            ]
        )
    header = [
        "cloud",
        "points",
        "graph (wall)",
        "CPU",
        "threads",
        "degree",
        "its size",
        "peak: predicted / measured",
        "query",
        "error: mean / 99.9 % / max",
        "graph of the mesh (CPU)",
        "query there",
        "error there",
    ]
    return table(header, rows)


def summarize(path):
    run = Run(path)
    parts = [
        f"Graphs are built on threads, timed on the wall; all other times are CPU seconds on one "
        f"thread ({environment(run.context)}). Predicted peaks are bytes that the allocator is asked "
        f"for, measured ones the growth of the process, with what the allocator keeps besides.\n"
    ]
    titles = {
        "Mean errors, % (times better than published)": mean_table,
        "Clouds that are not easy": guard_table,
        "What large clouds take, and meshes with the same points": speed_table,
    }
    parts += titled(run, titles)
    parts += folded("Errors in detail", error_table(run))
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
