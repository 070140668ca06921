# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of all methods on a mesh, in one picture: a map and a histogram of each, with a common
scale."""

import math

import numpy as np
import vtkdgg
from vtkmodules.vtkRenderingCore import vtkRenderer

from .. import pictures
from ..vtk_data import configured, with_arrays
from .measured import Errors
from .methods import methods
from .sizes import floor_of

COLUMNS = 4  # largest number
CELL = (460, 620)  # size of the panel of a method, pixels
FOOT = 46  # height of the last line, pixels
# Heights of the histogram and of the map as fractions of a panel, from below. The rest is text.
BARS, MAP = 0.31, 0.55
# Heights of the numbers and of the color scale as fractions of the histogram, from below.
NUMBERS, COLORS = 0.2, 0.1
SIDE = 0.07  # margin on both sides of the histogram, as a fraction of its width
DECADES = 4
BINS = 40


def measure(mesh, source, accuracy, merge=False, tolerance=0.01):
    """Returns the exact distances, and the Errors of each method by its title."""
    how = {"merge_coincident_points": merge, "projection_tolerance": tolerance}
    exact = vtkdgg.distance(mesh, source, **how)
    floor = floor_of(mesh)
    return exact, {
        title: Errors(distances(source), exact, floor)
        for title, distances in methods(mesh, accuracy, merge, tolerance).items()
    }


def scale(measured):
    """Returns the range of the colors in percent: two powers of ten."""
    largest = max(errors.percentile for errors in measured.values())
    high = math.ceil(math.log10(100.0 * largest)) if largest > 0.0 else 0
    return 10.0 ** (high - DECADES), 10.0**high


def histogram(errors, low, high):
    """Returns fractions of the vertices by the decimal logarithm of errors in percent. Errors
    outside the range are counted in the first and last bin."""
    sizes = np.abs(errors.signed[np.isfinite(errors.signed)])
    logarithms = np.log10(np.clip(100.0 * sizes, low, high))
    counts, _ = np.histogram(logarithms, BINS, (math.log10(low), math.log10(high)))
    return counts / max(1, len(sizes))


def save(path, mesh, source, measured, part=1.0):
    """Writes the picture. `source` is a position; `part` scales the picture."""
    low, high = scale(measured)
    table = pictures.lookup_table(pictures.ERROR_COLORS, low, high, pictures.UNREACHED_ERROR)
    table.SetScaleToLog10()
    rows = math.ceil(len(measured) / COLUMNS)
    columns = math.ceil(len(measured) / rows)
    size = [columns * CELL[0], rows * CELL[1] + FOOT]
    width, height = CELL[0] / size[0], CELL[1] / size[1]
    bars = {title: histogram(errors, low, high) for title, errors in measured.items()}
    # Without the first and last bin, which include all errors outside the range.
    tallest = max(shares[1:-1].max() for shares in bars.values()) or 1.0
    renderers = [_viewport((0.0, 0.0, 1.0, 1.0))]  # background
    for i, (title, errors) in enumerate(measured.items()):
        left, bottom = i % columns * width, 1.0 - (i // columns + 1) * height
        levels = [bottom + height * share for share in (0.0, BARS, BARS + MAP, 1.0)]
        below, middle, above = (
            (left, low_end, left + width, high_end) for low_end, high_end in zip(levels, levels[1:])
        )
        renderers += [
            _bars(below, np.minimum(bars[title] / tallest, 1.0), table, part),
            _map(middle, mesh, source, errors, table),
            _title(above, title, errors, part),
        ]
    legend = _viewport((0.0, 0.0, 1.0, FOOT / size[1]))
    line = (
        "Above: mean / 99.9 % / largest relative error. Below: fraction of points by error in "
        "percent; the first and last bin include all errors outside the range."
    )
    legend.AddActor(pictures.text(line, 0.04 / columns, 0.3, round(24 * part)))
    pictures.write(path, [*renderers, legend], [round(part * pixels) for pixels in size])


def _viewport(bounds):
    return configured(vtkRenderer(), Viewport=[*bounds], Background=[1.0, 1.0, 1.0])


def _title(bounds, title, errors, part):
    """Returns a renderer of the name of a method and its errors."""
    renderer = _viewport(bounds)
    renderer.AddActor(pictures.text(title, 0.04, 0.48, round(28 * part)))
    figures = (errors.mean, errors.percentile, errors.largest)
    line = " / ".join(f"{100.0 * error:.2g}" for error in figures)
    renderer.AddActor(pictures.text(f"{line} %", 0.04, 0.08, round(24 * part)))
    return renderer


def _map(bounds, mesh, source, errors, table):
    """Returns a renderer of the mesh, colored by errors."""
    colored = with_arrays(mesh, {"Error": 100.0 * np.abs(errors.signed)})
    renderer = _viewport(bounds)
    renderer.AddActor(pictures.surface(colored, "Error", table, pictures.MATTE))
    renderer.AddActor(pictures.marker(source, pictures.size_of(mesh)))
    pictures.light(renderer)
    pictures.aim(renderer, mesh, source, aspect=CELL[0] / (MAP * CELL[1]), room=0.0)
    return renderer


def _bars(bounds, heights, table, part):
    """Returns a renderer of a histogram with bars in the colors of their errors, above a scale."""
    low, high = map(math.log10, table.GetRange())
    count = len(heights)
    top = NUMBERS + COLORS
    points, errors = [], []
    for bottom, tops in ((NUMBERS, np.full(count, top)), (top, top + (0.98 - top) * heights)):
        for i, end in enumerate(tops):
            for x, y in ((i, bottom), (i + 1, bottom), (i + 1, end), (i, end)):
                points.append((SIDE + (1.0 - 2.0 * SIDE) * x / count, y, 0.0))
            errors.append(10.0 ** (low + (high - low) * (i + 0.5) / count))
    corners = np.arange(len(points)).reshape(-1, 4)
    quads = vtkdgg.Mesh(points, corners, cell_data={"Error": errors}).as_polydata()
    quads.GetCellData().SetActiveScalars("Error")
    actor = pictures.actor_of(quads)
    configured(actor.GetMapper(), LookupTable=table, UseLookupTableScalarRange=True)
    look = configured(actor.GetProperty(), Lighting=False, EdgeVisibility=True)
    look.SetEdgeColor(*pictures.INK)
    actor.SetScale(CELL[0] / (BARS * CELL[1]), 1.0, 1.0)  # fills the width of the viewport
    renderer = _viewport(bounds)
    renderer.AddActor(actor)
    middle = 0.5 * actor.GetScale()[0]
    camera = configured(renderer.GetActiveCamera(), ParallelProjection=True, ParallelScale=0.5)
    configured(camera, Position=[middle, 0.5, 1.0], FocalPoint=[middle, 0.5, 0.0])
    for decade in range(DECADES + 1):
        number = pictures.text(f"{10.0 ** (low + decade):g}", 0.0, 0.0, round(22 * part))
        number.GetTextProperty().SetJustificationToCentered()
        number.SetPosition(SIDE + (1.0 - 2.0 * SIDE) * decade / DECADES, 0.03)
        renderer.AddActor(number)
    return renderer
