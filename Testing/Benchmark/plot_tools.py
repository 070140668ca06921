# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all plots of benchmark results share."""

import sys

# Colors that also differ in lightness, for color-blind readers, and their markers.
STYLES = (
    ("#0b5fa5", "o"),
    ("#e08214", "s"),
    ("#2d9a5f", "^"),
    ("#8c2d6b", "D"),
    ("#555555", "v"),
)


class PlotError(Exception):
    """There is nothing to plot with, or nothing to plot."""


def load_matplotlib():
    """Its subplots() and Line2D, without a display."""
    try:
        import matplotlib
    except ImportError:
        raise PlotError("needs matplotlib (Debian: python3-matplotlib)") from None
    matplotlib.use("Agg")
    from matplotlib.lines import Line2D
    from matplotlib.pyplot import subplots

    return subplots, Line2D


def _plain(value, _):
    return f"{value:g}"


def draw_curve(axes, points, style, line="-", is_filled=True):
    """Points (x, y) with markers; nothing when there are none."""
    colour, marker = style
    if points:
        axes.plot(
            *zip(*points),
            color=colour,
            marker=marker,
            markersize=6.5,
            markerfacecolor=colour if is_filled else "white",
            linestyle=line,
            linewidth=1.8,
        )


def few_minor(value, _):
    """Label 20 and 50 and the like, not each tick."""
    digit = f"{value:e}"[0]
    return f"{value:g}" if digit in "25" else ""


def style_axes(axes, title, x_label, y_label="", y_format=_plain, minor=None, y_minor=None):
    """Logarithmic both ways, with plain numbers and a grid; `minor` names minor ticks of x, `y_minor`
    those of y."""
    from matplotlib.ticker import FuncFormatter, NullFormatter

    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(title, fontsize=12)
    axes.set_xlabel(x_label, fontsize=11)
    axes.set_ylabel(y_label, fontsize=11)
    axes.xaxis.set_major_formatter(FuncFormatter(_plain))
    axes.xaxis.set_minor_formatter(FuncFormatter(minor) if minor else NullFormatter())
    if y_minor:
        axes.yaxis.set_minor_formatter(FuncFormatter(y_minor))
    if y_format:
        axes.yaxis.set_major_formatter(FuncFormatter(y_format))
    axes.tick_params(which="both", labelsize=10, pad=5)
    axes.grid(True, which="major", color="#cccccc", linewidth=0.8)
    axes.grid(True, which="minor", color="#eeeeee", linewidth=0.6)


def add_legend(figure, handle, curves, lines=(), columns=6):
    """Curves (label, style) by colour and marker, kinds (label, line) by line; one for all."""
    handles = [
        handle([], [], color=colour, marker=marker, markersize=6.5, linewidth=1.8, label=label)
        for label, (colour, marker) in curves
    ]
    for label, line in lines:
        handles.append(handle([], [], color="#444444", linestyle=line, linewidth=1.8, label=label))
    figure.legend(handles=handles, loc="lower center", ncol=columns, frameon=False, fontsize=11)


def run_as_script(plot, usage):
    """RESULT.json PLOT.png on the command line."""
    if len(sys.argv) != 3:
        sys.exit(usage)
    try:
        plot(sys.argv[1], sys.argv[2])
    except PlotError as error:
        sys.exit(f"error: {error}")
