# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of exhibits."""

from plot_tools import add_legend, draw_curve, few_minor, load_matplotlib, style_axes


def plot_curves(path, title, x_label, curves, legend, lines=(), more=None):
    """One set of axes with curves (points, style, line); `legend` and `lines` as for add_legend(),
    `more` draws into the axes. Says that there is a picture."""
    subplots, handle = load_matplotlib()
    figure, axes = subplots(1, 1, figsize=(8.0, 5.2))
    for points, style, line in curves:
        draw_curve(axes, points, style, line, line == "-")
    if more:
        more(axes)
    style_axes(axes, title, x_label, minor=few_minor, y_minor=few_minor)
    add_legend(figure, handle, legend, lines, columns=3)
    figure.tight_layout(rect=(0.0, 0.14 if lines or len(legend) > 3 else 0.09, 1.0, 1.0))
    figure.savefig(path, dpi=80)
    return True
