# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a point cloud: a disc at each point, in bands of distance, and a path."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .. import arguments
from .discs import RADIUS, disc_radii, discs
from .pictures import (
    DISTANCE_COLOURS,
    INK,
    SIZE,
    directions,
    labels,
    lookup_table,
    marker,
    nice_step,
    note,
    save,
    scalar_bar,
    size_of,
    unreached,
    up_of,
)

# A disc has no fewer pixels than this across.
PIXELS = 3.0
# Every other band is darker by this factor.
SHADE = 0.82
# Radius of the path, of the diagonal.
WIDTH = 0.0035
# Where the source does not reach; darker than the background, also in full light.
UNREACHED = (0.58, 0.58, 0.58)


def save_distances(path, points, distances, spacings, way, lines):
    """Render the cloud with its distances and the way from the source, and write the PNG.

    `spacings` tell how far points are from each other around each of them, `lines` what is said
    below the scalar bar.
    """
    cloud = arguments.polydata(np.asarray(points, dtype=float))
    size = size_of(cloud)
    high = float(np.nanmax(distances)) or 1.0
    table = lookup_table(DISTANCE_COLOURS, 0.0, high, UNREACHED)
    make_bands(table, nice_step(high) / high)
    bar = scalar_bar(table, "Geodesic distance\n(model units)", labels(0.0, high), "%-.6g", 0.3)
    spacing = float(np.median(spacings))
    radii = np.maximum(disc_radii(spacings), 0.5 * PIXELS * size / SIZE[1])
    props = [
        discs(cloud, radii, distances, table),
        tube(way, max(WIDTH * size, 0.5 * RADIUS * spacing)),
        marker(way[-1], size, INK),
        bar,
        *unreached(bar, distances),
        *note(lines, 0.24),
    ]
    save(path, cloud, way[0], props, best_direction(points, way, up_of(cloud), spacing))


def make_bands(table, width):
    """One colour for each band, the lighter and the darker ones in turn; of the whole range."""
    colours = [np.array(table.GetTableValue(i)) for i in range(table.GetNumberOfTableValues())]
    count = 2048
    table.SetNumberOfTableValues(count)
    for i in range(count):
        band = int((i + 0.5) / count / width)
        middle = min((band + 0.5) * width, 1.0)
        colour = colours[round(middle * (len(colours) - 1))].copy()
        colour[:3] *= SHADE if band % 2 else 1.0
        table.SetTableValue(i, *colour)


def tube(way, radius, colour=(0.86, 0.12, 0.16)):
    """A curve through these points, drawn with this radius."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(way), deep=True))
    lines = vtkCellArray()
    lines.InsertNextCell(len(way), range(len(way)))
    line = vtkPolyData()
    line.SetPoints(points)
    line.SetLines(lines)
    thick = vtkTubeFilter()
    thick.SetInputData(line)
    thick.SetRadius(radius)
    thick.SetNumberOfSides(12)
    thick.CappingOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(thick.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetSpecular(0.3)
    return actor


def best_direction(points, way, up, spacing):
    """Where the cloud covers much of the view, and most of the way is in front of it."""
    if not spacing > 0.0:
        return next(directions(up))
    extent = float(np.ptp(points, axis=0).max())
    cell = max(2.0 * spacing, extent / 400.0)

    def score(direction):
        right = np.cross(up, direction)
        right /= np.linalg.norm(right)
        axes = np.column_stack([right, np.cross(direction, right)])
        start = (points @ axes).min(axis=0) - 2.0 * cell
        stop = (points @ axes).max(axis=0) + 2.0 * cell
        count = [math.ceil(side) + 1 for side in (stop - start) / cell]
        front = np.full(count[0] * count[1], -np.inf)

        def cells(places):
            place = np.clip(((places @ axes - start) / cell).astype(int), 0, np.array(count) - 1)
            return place[:, 0] * count[1] + place[:, 1]

        np.maximum.at(front, cells(points), points @ direction)
        hidden = way @ direction < front[cells(way)] - 2.0 * cell
        return np.isfinite(front).sum() * (0.1 + np.mean(~hidden)) * (0.5 if hidden[0] else 1.0)

    return max(directions(up), key=score)
