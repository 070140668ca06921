#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of errors against the parameters of graphs of point clouds, from the JSON of BenchmarkCloud.

Usage: plot_cloud.py RESULT.json PLOT.png

One column per scheme; above the mean error against alpha, below against the radius of the balls in
voxels. Full lines are lengths of arcs, dashed ones of chords. Where more than one point in a hundred
is not reached, nothing is drawn.
"""

import sys

from benchmark_results import count_text, largest, mean, median
from summarize_cloud import Run

# Colours that differ in lightness too, for those who do not see hues.
STYLES = (("#0b5fa5", "o"), ("#e08214", "s"), ("#2d9a5f", "^"))
WEIGHTS = (("arc", "-", "arcs"), ("chord", "--", "chords"))
SCHEMES = ("A", "B", "C")
ALPHAS = {
    "A": "alpha: mean length of direct pairs / reach",
    "B": "alpha: reach in voxels, beyond the radius h",
    "C": "alpha: reach / spacing",
}
OFFSET = "h: radius of the balls in voxels"


class PlotError(Exception):
    """There is nothing to plot with, or nothing to plot."""


def curve(graphs, graph, parameter):
    """Values of a parameter and mean errors in percent."""
    points = []
    for value, cases in graphs.get(graph, {}).get(parameter, {}).items():
        error = mean(cases.get("Query"), "error_mean")
        unreached = largest(cases.get("Query"), "unreached") or 0
        reaches_all = unreached <= 0.01 * (median(cases.get("Build"), "points") or 0)
        # An error of zero has no place on a logarithmic axis.
        if error and reaches_all:
            points.append((value, 100.0 * error))
    return sorted(points)


def name_of(cloud, graphs):
    """The shape and the number of points."""
    for parameters in graphs.values():
        for values in parameters.values():
            for cases in values.values():
                points = median(cases.get("Build"), "points")
                if points is not None:
                    return f"{cloud.split('-')[0]}, {count_text(points)} points"
    return cloud


def draw(axes, curves, scheme, parameter):
    for (_, graphs), (colour, marker) in zip(curves, STYLES):
        for weights, line, _ in WEIGHTS:
            points = curve(graphs, f"{scheme}/{weights}", parameter)
            if points:
                axes.plot(
                    *zip(*points),
                    color=colour,
                    marker=marker,
                    markersize=6,
                    markerfacecolor=colour if weights == "arc" else "white",
                    linestyle=line,
                    linewidth=1.8,
                )


def legend(figure, handle, curves):
    """Clouds by colour and marker, lengths by line; one legend for all."""
    lines = [
        handle([], [], color=colour, marker=marker, linewidth=1.8, label=name_of(cloud, graphs))
        for (cloud, graphs), (colour, marker) in zip(curves, STYLES)
    ]
    for _, line, label in WEIGHTS:
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
    from matplotlib.ticker import FuncFormatter, NullFormatter

    curves = list(run.curves.items())
    if not curves:
        raise PlotError("no curves in the result")
    figure, grid = subplots(2, 3, figsize=(13, 8.4), sharey="row")
    for row, parameter in zip(grid, ("Alpha", "Offset")):
        for axes, scheme in zip(row, SCHEMES):
            draw(axes, curves, scheme, parameter)
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_title(f"scheme {scheme}", fontsize=12)
            axes.set_xlabel(ALPHAS[scheme] if parameter == "Alpha" else OFFSET, fontsize=11)
            values = {
                value
                for _, graphs in curves
                for weights, _, _ in WEIGHTS
                for value, _ in curve(graphs, f"{scheme}/{weights}", parameter)
            }
            axes.set_xticks(sorted(values))
            axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{y:g}"))
            axes.tick_params(which="both", labelsize=10, pad=5)
            axes.grid(True, which="major", color="#cccccc", linewidth=0.8)
            axes.grid(True, which="minor", color="#eeeeee", linewidth=0.6)
        row[0].set_ylabel("mean relative error (%)", fontsize=11)
    legend(figure, Line2D, curves)
    figure.tight_layout(rect=(0.0, 0.04, 1.0, 1.0))
    figure.savefig(path, dpi=110)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        plot(Run(sys.argv[1]), sys.argv[2])
    except PlotError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
