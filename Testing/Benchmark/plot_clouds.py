#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of errors against the parameters of graphs of point clouds, from the JSON of measure_clouds.py.

Usage: plot_clouds.py RESULT.json PLOT.png

One column per scheme; above the mean error against alpha, below against the radius of the balls in
voxels. Full lines are lengths of arcs, dashed ones of chords.
"""

import json

from plot_tools import (
    STYLES,
    PlotError,
    add_legend,
    draw_curve,
    load_matplotlib,
    run_as_script,
    style_axes,
)

LINES = {"arcs": "-", "chords": "--"}
ALPHAS = {
    "A": "alpha: mean length of direct pairs / reach",
    "B": "alpha: reach in voxels, beyond the radius h",
    "C": "alpha: reach / spacing",
}
OFFSET = "h: radius of the balls in voxels"


def plot_curves(curves, picture):
    """Draws curves as measure_clouds.measure_curves() returns them."""
    if not curves:
        raise PlotError("no curves in the result")
    subplots, handle = load_matplotlib()
    figure, grid = subplots(2, 3, figsize=(13, 8.4), sharey="row")
    for row, parameter in zip(grid, ("Alpha", "Offset")):
        for axes, (scheme, label) in zip(row, ALPHAS.items()):
            ticks = set()
            for graphs, style in zip(curves.values(), STYLES):
                for weights, line in LINES.items():
                    points = graphs.get(f"{scheme}, {weights}", {}).get(parameter, [])
                    draw_curve(axes, points, style, line, weights == "arcs")
                    ticks.update(value for value, _ in points)
            style_axes(axes, f"scheme {scheme}", label if parameter == "Alpha" else OFFSET)
            axes.set_xticks(sorted(ticks))
        row[0].set_ylabel("mean relative error (%)", fontsize=11)
    add_legend(figure, handle, zip(curves, STYLES), LINES.items())
    figure.tight_layout(rect=(0.0, 0.04, 1.0, 1.0))
    figure.savefig(picture, dpi=110)


def plot(path, picture):
    with open(path, encoding="utf-8") as file:
        plot_curves(json.load(file)["curves"], picture)


if __name__ == "__main__":
    run_as_script(plot, __doc__)
