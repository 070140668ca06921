#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of error against degree for every rule, from the JSON of BenchmarkGraph.

Usage: plot_graph.py RESULT.json PLOT.png

One row per mesh; left the mean error, right the largest. Full lines are distances in the graph,
dashed ones corrected distances.
"""

import sys

from benchmark_results import count_text, errors, median
from summarize_graph import Run

# Colours that differ in lightness too, for those who do not see hues.
STYLES = {
    "Guaranteed": ("#0b5fa5", "o"),
    "OneRelay": ("#e08214", "s"),
    "Indirect": ("#2d9a5f", "^"),
    "SVG": ("#8c2d6b", "D"),
}
KINDS = (("Certified", "-"), ("Corrected", "--"))
COLUMNS = ((0, "mean error"), (2, "largest error"))


class PlotError(Exception):
    """There is nothing to plot with, or nothing to plot."""


def curve(graphs, rule, case, figure):
    """Degrees and errors in percent of the graphs of one rule."""
    points = []
    for (name, _), cases in graphs.items():
        degree = median(cases.get("Build"), "degree_mean")
        error = errors(cases.get(case))[figure]
        # An error of zero has no place on a logarithmic axis.
        if name == rule and degree and error:
            points.append((degree, 100.0 * error))
    return sorted(points)


def draw(axes, graphs, figure):
    for rule, (colour, marker) in STYLES.items():
        for case, line in KINDS:
            points = curve(graphs, rule, case, figure)
            if points:
                axes.plot(
                    *zip(*points),
                    color=colour,
                    marker=marker,
                    markersize=7,
                    markerfacecolor=colour if case == "Certified" else "white",
                    linestyle=line,
                    linewidth=1.8,
                )


def legend(figure, handle):
    """Rules by colour and marker, kinds of distance by line; one legend for all."""
    lines = [
        handle([], [], color=colour, marker=marker, markersize=7, linewidth=1.8, label=rule)
        for rule, (colour, marker) in STYLES.items()
    ]
    for (_, line), label in zip(KINDS, ("distance in the graph", "corrected distance")):
        lines.append(handle([], [], color="#444444", linestyle=line, linewidth=1.8, label=label))
    figure.legend(handles=lines, loc="lower center", ncol=6, frameon=False, fontsize=11)


def plot(run, path):
    try:
        import matplotlib
    except ImportError:
        raise PlotError("needs matplotlib (Debian: python3-matplotlib)") from None
    matplotlib.use("Agg")
    from matplotlib.lines import Line2D
    from matplotlib.pyplot import subplots
    from matplotlib.ticker import FuncFormatter

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
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_title(f"{mesh}{size}: {title}", fontsize=12)
            axes.set_xlabel("edges per vertex", fontsize=11)
            axes.set_ylabel("relative error (%)", fontsize=11)
            axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
            axes.xaxis.set_minor_formatter(FuncFormatter(_minor))
            axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{y:g}"))
            axes.tick_params(which="both", labelsize=10, pad=5)
            axes.grid(True, which="major", color="#cccccc", linewidth=0.8)
            axes.grid(True, which="minor", color="#eeeeee", linewidth=0.6)
    legend(figure, Line2D)
    figure.tight_layout(rect=(0.0, 0.45 / height, 1.0, 1.0))
    figure.savefig(path, dpi=110)


def _minor(value, _):
    """Label 20 and 50 and the like, not each tick."""
    digit = f"{value:e}"[0]
    return f"{value:g}" if digit in "25" else ""


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        plot(Run(sys.argv[1]), sys.argv[2])
    except PlotError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
