#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of error against degree for every rule, from the JSON of BenchmarkGraph.

Usage: plot_graph.py RESULT.json PLOT.png

One row per mesh; left the mean error, right the largest. Full lines are distances in the graph,
dashed ones corrected distances.
"""

from benchmark_results import count_text, errors, median
from plot_tools import (
    STYLES,
    PlotError,
    add_legend,
    draw_curve,
    few_minor,
    load_matplotlib,
    run_as_script,
    style_axes,
)
from summarize_graph import Run

RULES = dict(zip(("Guaranteed", "OneRelay", "Indirect", "SVG"), STYLES))
KINDS = (
    ("Certified", "-", "distance in the graph"),
    ("Corrected", "--", "corrected distance"),
)
COLUMNS = ((0, "mean error"), (2, "largest error"))


def curve(graphs, rule, case, figure):
    """Degrees and errors in percent of the graphs of one rule."""
    points = []
    for (name, _), cases in graphs.items():
        degree = median(cases.get("Build"), "degree_mean")
        error = errors(cases.get(case))[figure]
        # A logarithmic axis cannot show an error of zero.
        if name == rule and degree and error:
            points.append((degree, 100.0 * error))
    return sorted(points)


def draw(axes, graphs, figure):
    for rule, style in RULES.items():
        for case, line, _ in KINDS:
            draw_curve(axes, curve(graphs, rule, case, figure), style, line, case == "Certified")


def plot(path, picture):
    run = Run(path)
    subplots, handle = load_matplotlib()
    meshes = [mesh for mesh, graphs in run.graphs.items() if graphs]
    if not meshes:
        raise PlotError("no graphs in the result")
    height = 4.4 * len(meshes) + 0.6
    figure, grid = subplots(len(meshes), 2, figsize=(12, height), squeeze=False)
    for row, mesh in zip(grid, meshes):
        graphs = run.graphs[mesh]
        vertices = median(next(iter(graphs.values())).get("Build"), "vertices")
        size = "" if vertices is None else f", {count_text(vertices)} vertices"
        for axes, (index, title) in zip(row, COLUMNS):
            draw(axes, graphs, index)
            style_axes(
                axes,
                f"{mesh}{size}: {title}",
                "edges per vertex",
                "relative error (%)",
                minor=few_minor,
            )
    add_legend(figure, handle, RULES.items(), [(label, line) for _, line, label in KINDS])
    figure.tight_layout(rect=(0.0, 0.45 / height, 1.0, 1.0))
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    run_as_script(plot, __doc__)
