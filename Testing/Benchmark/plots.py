# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of benchmark results.

Usage: plots.py graph|cloud|passrate|spheres RESULT.json PLOT.png
"""

import json
import math
import sys
from dataclasses import dataclass
from typing import Any

from summarize import PATTERNS, WAYS, with_case
from tables import count_text, figure, load, rows_of, slope

# Colors that also differ in lightness, for color-blind readers, and their markers.
STYLES = (
    ("#0b5fa5", "o"),
    ("#e08214", "s"),
    ("#2d9a5f", "^"),
    ("#8c2d6b", "D"),
    ("#555555", "v"),
    ("#c0392b", "P"),
)
GRAY = "#999999"
RULES = dict(zip(("Guaranteed", "OneRelay", "Indirect", "SVG"), STYLES))
LEGEND_INCHES = 0.5  # height below the plots


class PlotError(Exception):
    """No matplotlib, or no data."""


@dataclass(frozen=True)
class Panel:
    """One set of axes with logarithmic scales. Curves are (points, style, line). `draw` adds other
    content; `ticks` are (x, label)."""

    title: str
    x: str
    y: str = ""
    curves: Any = ()
    draw: Any = None
    ticks: Any = ()
    is_logarithmic: bool = True


def draw_curve(axes, points, style, line):
    """Draws points with markers, empty ones for dashed lines."""
    color, marker = style
    if points:
        axes.plot(
            *zip(*points),
            color=color,
            marker=marker,
            markersize=6.5,
            markerfacecolor="white" if line == "--" else color,
            linestyle=line,
            linewidth=1.8,
        )


def draw_panel(axes, panel):
    from matplotlib.ticker import FuncFormatter

    for curve in panel.curves:
        draw_curve(axes, *curve)
    if panel.draw:
        panel.draw(axes)
    axes.set_title(panel.title, fontsize=12)
    axes.set_xlabel(panel.x, fontsize=11)
    axes.set_ylabel(panel.y, fontsize=11)
    axes.tick_params(which="both", labelsize=10, pad=5)
    if not panel.is_logarithmic:
        return
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        # Minor ticks such as 20 and 50 are labeled; all of them where there may be no major tick.
        digits = "25" if high > 10.0 * low else "23456789"
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(
            FuncFormatter(
                lambda value, _, digits=digits: f"{value:g}" if f"{value:e}"[0] in digits else ""
            )
        )
    if panel.ticks:
        values, labels = zip(*panel.ticks)
        axes.set_xticks(values, labels)
        axes.set_xticks([], minor=True)
    axes.grid(True, which="major", color="#cccccc", linewidth=0.8)
    axes.grid(True, which="minor", color="#eeeeee", linewidth=0.6)


def plot(path, rows, legend, lines=(), size=(8.0, 5.2)):
    """Draws rows of panels with one legend: curves (label, style) by color and marker, kinds (label,
    line) by line. `size` is that of the picture in inches. Returns true."""
    try:
        import matplotlib
    except ImportError:
        raise PlotError("needs matplotlib (Debian: python3-matplotlib)") from None
    matplotlib.use("Agg")
    from matplotlib.lines import Line2D
    from matplotlib.pyplot import close, subplots

    figure_, grid = subplots(len(rows), len(rows[0]), figsize=size, squeeze=False)
    for axes_row, panels in zip(grid, rows):
        for axes, panel in zip(axes_row, panels):
            draw_panel(axes, panel)
    handles = [
        Line2D([], [], color=color, marker=marker, markersize=6.5, linewidth=1.8, label=label)
        for label, (color, marker) in legend
    ]
    handles += [
        Line2D([], [], color="#444444", linestyle=line, linewidth=1.8, label=label)
        for label, line in lines
    ]
    columns = max(1, int(size[0] / 2.0))
    figure_.legend(handles=handles, loc="lower center", ncol=columns, frameon=False, fontsize=11)
    below = LEGEND_INCHES + 0.25 * ((len(handles) - 1) // columns)
    figure_.tight_layout(rect=(0.0, below / size[1], 1.0, 1.0))
    figure_.savefig(path, dpi=110 if size[0] > 10.0 else 80)
    close(figure_)
    return True


def degree_curve(rows, rule, case, error):
    """Returns degrees and errors in percent of the graphs of one rule."""
    points = [
        (figure(row, "Build", "degree_mean"), figure(row, case, "error", error))
        for row in rows
        if row["rule"] == rule
    ]
    # A logarithmic axis cannot show an error of zero.
    return sorted((degree, 100.0 * value) for degree, value in points if degree and value)


def plot_graphs(path, picture):
    """Draws mean and largest error against degree: one row per mesh, one curve per rule."""
    rows = rows_of(load(path)[1], PATTERNS["graph"])
    kinds = {"Certified": ("distance in the graph", "-"), "Corrected": ("corrected distance", "--")}
    grid = []
    for mesh in dict.fromkeys(row["mesh"] for row in with_case(rows, "Build")):
        graphs = [row for row in rows if row["mesh"] == mesh]
        size = count_text(figure(with_case(graphs, "Build")[0], "Build", "vertices"))
        grid.append(
            [
                Panel(
                    f"{mesh}, {size} vertices: {title}",
                    "edges per vertex",
                    "relative error (%)",
                    [
                        (degree_curve(graphs, rule, case, error), style, line)
                        for rule, style in RULES.items()
                        for case, (_, line) in kinds.items()
                    ],
                )
                for error, title in {"mean": "mean error", "max": "largest error"}.items()
            ]
        )
    if not grid:
        raise PlotError("no graphs in the result")
    plot(picture, grid, RULES.items(), kinds.values(), (12.0, 4.4 * len(grid) + 0.6))


def draw_cloud_curves(curves, picture):
    """Draws errors of cloud graphs against parameters: one column per scheme, above against alpha,
    below against the radius of balls; curves as measure_clouds.measure_curves() returns them."""
    if not curves:
        raise PlotError("no curves in the result")
    lines = {"arcs": "-", "chords": "--"}
    alphas = {
        "A": "alpha: mean length of direct pairs / reach",
        "B": "alpha: reach in voxels, beyond the radius h",
        "C": "alpha: reach / spacing",
    }
    radii = dict.fromkeys(alphas, "h: radius of the balls in voxels")
    grid = []
    for parameter, labels in (("Alpha", alphas), ("Offset", radii)):
        grid.append([])
        for scheme, label in labels.items():
            found = [
                (graphs.get(f"{scheme}, {weights}", {}).get(parameter, []), style, line)
                for graphs, style in zip(curves.values(), STYLES)
                for weights, line in lines.items()
            ]
            ticks = sorted({value for points, *_ in found for value, _ in points})
            y = "mean relative error (%)" if scheme == "A" else ""
            panel = Panel(f"scheme {scheme}", label, y, found, ticks=[(t, f"{t:g}") for t in ticks])
            grid[-1].append(panel)
    return plot(picture, grid, zip(curves, STYLES), lines.items(), (13.0, 8.4))


def draw_sphere_curves(curves, picture):
    """Draws errors of Green's functions against the mean edge, with lines of first and second order;
    curves as measure_spheres.measure_ways() returns them."""
    ways = [way for way in WAYS if len(curves[way]["error_local"]) > 1]
    if not ways:
        raise PlotError("no errors on two spheres or more in the result")
    styles = dict(zip(WAYS, STYLES))
    powers = ((1, ":", "Interpolated"), (2, "--", "SingularitySubtraction"))

    def points_of(way, error):
        return [(edge, value) for _, edge, value in curves[way][error]]

    def panel(error, title, label):
        points = {way: points_of(way, error) for way in ways}
        edges = [edge for edge, _ in points[ways[0]]]

        def draw_powers(axes):
            for power, line, way in powers:
                if way in points:
                    coarse, value = points[way][0]
                    ends = [(edge, 0.6 * value * (edge / coarse) ** power) for edge in edges[::-1]]
                    axes.plot(*zip(*ends), color=GRAY, linestyle=line, linewidth=1.2, zorder=1)

        return Panel(
            title,
            "mean edge, on a sphere of radius 1",
            label,
            [(points[way], styles[way], "-") for way in ways],
            draw_powers,
            [(edge, f"{edge:.2g}") for edge in edges[-5:]],
        )

    panels = [
        panel("error_local", "within 0.2 of the pole", "relative L2 error"),
        panel("error_global", "on the whole sphere", "relative L2 error"),
        panel("error_largest", "largest of all", "absolute error"),
    ]
    legend = [
        (f"{WAYS[way]}: order {slope(points_of(way, 'error_local')):.2f}", styles[way])
        for way in ways
    ]
    lines = [(f"order {power}", line) for power, line, _ in powers]
    return plot(picture, [panels], legend, lines, (14.0, 5.4))


def plot_rates(results, picture):
    """Draws mean and largest error over ε against anisotropy; returns false if there is no data."""
    rows = [row for row in results["rows"] if 0.0 < row["mean"] and row["max"] < math.inf]
    styles = dict(zip(sorted({row["accuracy"] for row in rows}, reverse=True), STYLES))

    def draw(axes):
        for accuracy, (color, marker) in styles.items():
            chosen = [row for row in rows if row["accuracy"] == accuracy]
            for key, face in (("mean", color), ("max", "white")):
                points = [(row["tau"], row[key] / accuracy) for row in chosen]
                axes.plot(*zip(*points), marker, color=color, markerfacecolor=face, markersize=6.5)
        axes.axhline(1.0, color="#444444", linewidth=1.2, linestyle="--")

    title = "error over ε: mean (full), largest (empty)"
    panel = Panel(title, "anisotropy of the triangles", draw=draw)
    legend = [(f"ε = {accuracy:g}", style) for accuracy, style in styles.items()]
    return bool(rows) and plot(picture, [[panel]], legend, size=(7.0, 5.2))


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


PLOTS = {
    "graph": plot_graphs,
    "cloud": lambda path, picture: draw_cloud_curves(read(path)["curves"], picture),
    "passrate": lambda path, picture: plot_rates(read(path), picture),
    "spheres": lambda path, picture: draw_sphere_curves(read(path)["curves"], picture),
}


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in PLOTS:
        sys.exit(__doc__)
    try:
        PLOTS[sys.argv[1]](*sys.argv[2:])
    except PlotError as error:
        sys.exit(f"error: {error}")
