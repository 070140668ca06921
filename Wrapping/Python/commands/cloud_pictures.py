# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a point cloud: a disc at each point, colored in bands of distance, and a path."""

import math

import numpy as np

from .. import pictures, vtk_data

# Smallest diameter of a disc in pixels.
PIXELS = 3.0
# Factor by which every other band is darker.
SHADE = 0.82
# Radius of the path, as a fraction of the diagonal.
WIDTH = 0.0035
# Color of unreached points, which is darker than the background in full light.
UNREACHED = (0.58, 0.58, 0.58)


def save_distances(path, points, distances, spacings, curve, lines):
    """Writes a PNG of the cloud with its distances and a path from the source.

    `spacings` is the spacing around each point, `curve` the points of the path, and `lines` the
    text below the scalar bar.
    """
    cloud = vtk_data.points_polydata(np.asarray(points, dtype=float))
    size = pictures.size_of(cloud)
    high = float(np.nanmax(distances)) or 1.0
    table = pictures.lookup_table(pictures.DISTANCE_COLORS, 0.0, high, UNREACHED)
    make_bands(table, pictures.nice_step(high) / high)
    bar = pictures.scalar_bar(
        table, "Geodesic distance\n(model units)", pictures.labels(0.0, high), "%-.6g", 0.3
    )
    spacing = float(np.median(spacings))
    radii = np.maximum(pictures.disc_radii(spacings), 0.5 * PIXELS * size / pictures.SIZE[1])
    props = [
        pictures.discs(cloud, radii, distances, table),
        tube(curve, max(WIDTH * size, 0.5 * pictures.DISC_RADIUS * spacing)),
        pictures.marker(curve[-1], size, pictures.INK),
        bar,
        *pictures.unreached(bar, distances),
        *pictures.note(lines, 0.24),
    ]
    pictures.save(
        path, cloud, curve[0], props, best_direction(points, curve, pictures.up_of(cloud), spacing)
    )


def make_bands(table, width):
    """Divides the colors of a table into bands, alternately lighter and darker. `width` is the
    fraction of the range in a band."""
    colors = [np.array(table.GetTableValue(i)) for i in range(table.GetNumberOfTableValues())]
    count = 2048
    table.SetNumberOfTableValues(count)
    for i in range(count):
        band = int((i + 0.5) / count / width)
        middle = min((band + 0.5) * width, 1.0)
        color = colors[round(middle * (len(colors) - 1))].copy()
        color[:3] *= SHADE if band % 2 else 1.0
        table.SetTableValue(i, *color)


def tube(curve, radius, color=(0.86, 0.12, 0.16)):
    """Returns an actor of a tube along a polyline."""
    actor = pictures.tubes(
        vtk_data.polyline(np.ascontiguousarray(curve)), radius, color, sides=12, is_capped=True
    )
    actor.GetProperty().SetSpecular(0.3)
    return actor


def best_direction(points, curve, up, spacing):
    """Returns the viewing direction in which the cloud covers much of the view and hides little of
    the path."""
    if not spacing > 0.0:
        return next(pictures.directions(up))
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

        def cells(positions):
            cell_2d = ((positions @ axes - start) / cell).astype(int)
            i, j = np.clip(cell_2d, 0, np.array(count) - 1).T
            return i * count[1] + j

        np.maximum.at(front, cells(points), points @ direction)
        hidden = curve @ direction < front[cells(curve)] - 2.0 * cell
        return np.isfinite(front).sum() * (0.1 + np.mean(~hidden)) * (0.5 if hidden[0] else 1.0)

    return max(pictures.directions(up), key=score)
