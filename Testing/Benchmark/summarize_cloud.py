#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkCloud.

Usage: summarize_cloud.py RESULT.json [TABLE.md]

Published are the mean errors of Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
University, 2019, chapter 5, at a resolution of 512 voxels, for models of the same kind and size.
"""

from benchmark_results import (
    DASH,
    Results,
    bytes_text,
    environment,
    errors_of,
    errors_text,
    figure,
    first_median,
    first_of,
    folded,
    in_form,
    largest,
    mean,
    median,
    number,
    peak_text,
    percent,
    quotient_text,
    ratio_text,
    run_as_script,
    size_text,
    tabulate,
    time_text,
    titled,
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


CASE = r"/([^/]+)/([ABC]/(?:chord|arc|fine)|Band/march|Mesh)/%s(Build|Estimate|Query)(?:/|$)"


class Run(Results):
    """groups[group][cloud][graph][case] and curves[cloud][graph][parameter][value][case]."""

    patterns = {
        "groups": "(Cloud|Guard|Speed)" + CASE % "",
        "curves": "Curve" + CASE % "(Alpha|Offset)/([0-9.]+)/",
    }

    def key(self, group, match):
        cloud, graph, parameter, *rest = match.groups()
        if group == "groups":
            return match.groups()
        return (cloud, graph, parameter, float(rest[0]), rest[1])

    def graphs(self, group, names):
        """Cloud, graph and cases of a group, in the order of the names."""
        for cloud, graphs in self.groups.get(group, {}).items():
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
    """The number of points of a cloud; marching does not show it."""
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
    def published(cloud, graphs):
        return published_of(cloud, "C/arc", points_of(graphs))

    def both(scheme):
        return lambda _, graphs: " / ".join(
            mean_text(graphs, f"{scheme}/{weights}") for weights in ("chord", "arc")
        )

    def beside(graph):
        return lambda cloud, graphs: mean_text(graphs, graph, published(cloud, graphs))

    columns = [
        ("cloud", first_of),
        ("points", lambda _, graphs: size_text(points_of(graphs))),
        ("published", lambda *row: range_text(published(*row))),
        ("A: chords / arcs", both("A")),
        ("B: chords / arcs", both("B")),
        ("C: chords", lambda _, graphs: mean_text(graphs, "C/chord")),
        ("C: arcs (default)", beside("C/arc")),
        ("C: arcs, finer", beside("C/fine")),
        ("fast marching", lambda _, graphs: mean_text(graphs, "Band/march")),
    ]
    return tabulate(columns, run.groups.get("Cloud", {}).items())


def error_table(run):
    def points(cloud):
        return points_of(run.groups["Cloud"][cloud])

    def published(cloud, graph):
        return published_of(cloud, graph, points(cloud))

    def reach(_, __, cases):
        return quotient_text(*(median(cases.get("Build"), key) for key in ("reach", "spacing")))

    def published_text(cloud, graph, _):
        return range_text(published(cloud, graph)) + (" %" if published(cloud, graph) else "")

    def better(cloud, graph, cases):
        known = published(cloud, graph)
        return ratio_text(known[0], mean(cases.get("Query"), "error_mean")) if known else DASH

    columns = [
        ("cloud", first_of),
        ("points", lambda cloud, *_: size_text(points(cloud))),
        ("method", lambda _, graph, cases: method_of(graph, cases)),
        ("degree", figure("Build", "degree")),
        ("reach, spacings", reach),
        ("error: mean / 99.9 % / max", errors_of("Query")),
        ("unreached", lambda *row: unreached_text(row[-1].get("Query"))),
        ("published mean", published_text),
        ("published / ours", better),
        ("query", figure("Query")),
    ]
    return tabulate(columns, run.graphs("Cloud", METHODS))


def guard_table(run):
    def error(cloud, _, cases):
        return DASH if cloud in FORCED else errors_text(cases.get("Query"))

    columns = [
        ("cloud", lambda cloud, *_: GUARDS.get(cloud, cloud)),
        ("method", lambda _, graph, cases: method_of(graph, cases)),
        ("noise found", figure("Build", "noise", in_form("{:.2g}"))),
        ("error: mean / 99.9 % / max", error),
        ("unreached", lambda *row: unreached_text(row[-1].get("Query"))),
        ("edges between sheets", figure("Build", "false_edges")),
        ("components", figure("Build", "components")),
    ]
    return tabulate(columns, run.graphs("Guard", METHODS))


def speed_table(run):
    def of_mesh(cell):
        return lambda cloud, *_: cell(run.groups["Speed"][cloud].get("Mesh", {}))

    def peak(*row):
        return peak_text(
            median(row[-1].get("Estimate"), "estimated_peak_bytes"),
            median(row[-1].get("Build"), "resident_bytes"),
        )

    columns = [
        ("cloud", first_of),
        ("points", figure("Build", "points", size_text)),
        ("graph (wall)", figure("Build")),
        ("CPU", figure("Build", "cpu_seconds", time_text)),
        ("threads", figure("Build", "threads")),
        ("degree", figure("Build", "degree")),
        ("its size", figure("Build", "graph_bytes", bytes_text)),
        ("peak: predicted / measured", peak),
        ("query", figure("Query")),
        ("error: mean / 99.9 % / max", errors_of("Query")),
        ("graph of the mesh (CPU)", of_mesh(figure("Build"))),
        ("query there", of_mesh(figure("Query"))),
        ("error there", of_mesh(errors_of("Query"))),
    ]
    return tabulate(columns, run.graphs("Speed", ["C/arc"]))


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
