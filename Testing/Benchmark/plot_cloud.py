#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of errors against the parameters of graphs of point clouds, from the JSON of BenchmarkCloud.

Usage: plot_cloud.py RESULT.json PLOT.png

One column per scheme; above the mean error against alpha, below against the radius of the balls in
voxels. Full lines are lengths of arcs, dashed ones of chords. Where more than one point in a hundred
is not reached, nothing is drawn.
"""

from benchmark_results import count_text, largest, mean, median
from plot_tools import (
    STYLES,
    PlotError,
    add_legend,
    draw_curve,
    load_matplotlib,
    run_as_script,
    style_axes,
)
from summarize_cloud import Run

WEIGHTS = (("arc", "-", "arcs"), ("chord", "--", "chords"))
SCHEMES = ("A", "B", "C")
ALPHAS = {
    "A": "alpha: mean length of direct pairs / reach",
    "B": "alpha: reach in voxels, beyond the radius h",
    "C": "alpha: reach / spacing",
}
OFFSET = "h: radius of the balls in voxels"


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
    for (_, graphs), style in zip(curves, STYLES):
        for weights, line, _ in WEIGHTS:
            points = curve(graphs, f"{scheme}/{weights}", parameter)
            draw_curve(axes, points, style, line, weights == "arc")


def values_of(curves, scheme, parameter):
    """Where the curves of a scheme have points."""
    return sorted(
        {
            value
            for _, graphs in curves
            for weights, _, _ in WEIGHTS
            for value, _ in curve(graphs, f"{scheme}/{weights}", parameter)
        }
    )


def plot(path, picture):
    subplots, handle = load_matplotlib()
    curves = list(Run(path).curves.items())
    if not curves:
        raise PlotError("no curves in the result")
    figure, grid = subplots(2, 3, figsize=(13, 8.4), sharey="row")
    for row, parameter in zip(grid, ("Alpha", "Offset")):
        for axes, scheme in zip(row, SCHEMES):
            draw(axes, curves, scheme, parameter)
            label = ALPHAS[scheme] if parameter == "Alpha" else OFFSET
            style_axes(axes, f"scheme {scheme}", label)
            axes.set_xticks(values_of(curves, scheme, parameter))
        row[0].set_ylabel("mean relative error (%)", fontsize=11)
    clouds = [(name_of(*cloud), style) for cloud, style in zip(curves, STYLES)]
    add_legend(figure, handle, clouds, [(label, line) for _, line, label in WEIGHTS])
    figure.tight_layout(rect=(0.0, 0.04, 1.0, 1.0))
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    run_as_script(plot, __doc__)
