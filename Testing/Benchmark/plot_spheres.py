#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plot of the errors of Green's functions on spheres, from the JSON of measure_spheres.py.

Usage: plot_spheres.py RESULT.json PLOT.png

Over the mean edge: left within 0.2 of the pole, in the middle everywhere, right the largest. Grey
lines fall with the first and the second power of it. The legend has the orders of the left one.
"""

import json

from measure_spheres import WAYS, order
from plot_tools import (
    STYLES,
    PlotError,
    add_legend,
    draw_curve,
    load_matplotlib,
    run_as_script,
    style_axes,
)

COLUMNS = (
    ("error_local", "within 0.2 of the pole", "relative L2 error"),
    ("error_global", "on the whole sphere", "relative L2 error"),
    ("error_largest", "largest of all", "absolute error"),
)
# Power, line style, and the curve above the line.
POWERS = ((1, ":", "Interpolated"), (2, "--", "SingularitySubtraction"))
MOST_TICKS = 5
BELOW = 0.6  # start of the lines of powers, relative to the error of the curve


def draw_power(axes, power, line, edges, error):
    """A grey line from below the error at the coarsest mesh."""
    fine, coarse = min(edges), max(edges)
    values = (error * (fine / coarse) ** power, error)
    axes.plot((fine, coarse), values, color="#999999", linestyle=line, linewidth=1.2, zorder=1)


def plot_curves(curves, picture):
    """Draws curves as measure_spheres.measure_ways() returns them."""
    subplots, handle = load_matplotlib()
    ways = [way for way in WAYS if len(curves[way]["error_local"]) > 1]
    if not ways:
        raise PlotError("no errors on two spheres or more in the result")
    styles = dict(zip(WAYS, STYLES))
    figure, row = subplots(1, len(COLUMNS), figsize=(14, 5.4))
    for axes, (error, title, label) in zip(row, COLUMNS):
        for way in ways:
            points = [(edge, value) for _, edge, value in curves[way][error]]
            draw_curve(axes, points, styles[way])
        edges = [edge for edge, _ in points]
        for power, line, way in POWERS:
            if way in ways:
                draw_power(axes, power, line, edges, BELOW * curves[way][error][0][2])
        style_axes(axes, title, "mean edge, on a sphere of radius 1", label, y_format=None)
        axes.set_xticks(edges[-MOST_TICKS:])
        axes.set_xticklabels([f"{edge:.2g}" for edge in edges[-MOST_TICKS:]])
    legend = [
        (f"{WAYS[way]}: order {order(curves[way]['error_local']):.2f}", styles[way])
        for way in ways
    ]
    lines = [(f"order {power}", line) for power, line, _ in POWERS]
    add_legend(figure, handle, legend, lines, columns=4)
    figure.tight_layout(rect=(0.0, 0.12, 1.0, 1.0))
    figure.savefig(picture, dpi=110)


def plot(path, picture):
    with open(path, encoding="utf-8") as file:
        plot_curves(json.load(file)["curves"], picture)


if __name__ == "__main__":
    run_as_script(plot, __doc__)
