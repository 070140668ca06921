# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances on difficult point clouds: with noise, uneven density, holes, and two close layers.

Usage: cloud_guards.py PICTURE.png
"""

import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkdgg.pictures import DISTANCE_COLORS, INK, disc_radii, discs, marker, spacings_of, write_png
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkLightKit, vtkRenderer, vtkRenderWindow, vtkTextActor

SIZE = (1600, 1200)
UNREACHED = (0.62, 0.62, 0.62)
# Factor by which every other band is darker.
SHADE = 0.8
BANDS = 24
# Scale of the discs, which covers the gaps between random points.
LARGER = 1.7
# Scale of the discs where single points are visible.
SEPARATE = 0.6


def sphere(count, random, noise=0.0, density=1.0):
    """Points of the unit sphere, denser on one side, with normally distributed noise."""
    points = random.normal(size=(4 * count, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    chance = (1.0 + (density - 1.0) * 0.5 * (1.0 - points[:, 0])) / density
    points = points[random.uniform(size=len(points)) < chance][:count]
    return points + noise * random.normal(size=points.shape)


def perforated(count, random):
    """Points of a torus outside of round holes."""
    u = 2.0 * np.pi * random.uniform(size=4 * count)
    v = 2.0 * np.pi * random.uniform(size=4 * count)
    r = 1.0 + 0.45 * np.cos(v)
    even = 1.45 * random.uniform(size=len(r)) < r  # uniform density per area
    points = np.column_stack([r * np.cos(u), r * np.sin(u), 0.45 * np.sin(v)])[even]
    angle = np.arange(10) * 2.0 * np.pi / 10.0
    tube = np.where(np.arange(10) % 2 == 0, 0.6, 1.9)
    r = 1.0 + 0.45 * np.cos(tube)
    centres = np.column_stack([r * np.cos(angle), r * np.sin(angle), 0.45 * np.sin(tube)])
    gaps = np.linalg.norm(points[:, None] - centres, axis=2) < 0.17
    return points[~gaps.any(axis=1)][:count]


def sheets(count, random):
    """Points of two wavy layers, three radii of balls of 1.5 spacings apart."""
    x, y = random.uniform(size=(2, count))
    gap = 3.0 * 1.5 * np.sqrt(2.0 / count)
    z = 0.06 * np.sin(7.0 * x + 0.5) * np.cos(5.0 * y) + gap * (np.arange(count) % 2)
    # The upper layer is cut off, so that the lower one is visible.
    return np.column_stack([x, y, z])[(np.arange(count) % 2 == 0) | (x + 0.4 * y > 0.62)]


def distances_on(points, source):
    """Returns the graph of the points, and distances from one of them."""
    graph = vtkdgg.vtkPointCloudDGG()
    graph.SetInputData(vtkdgg.Mesh(points).as_polydata())
    distance = vtkdgg.vtkDGGDistance()
    distance.SetInputConnection(graph.GetOutputPort())
    distance.AddSourceId(source)
    output = vtkdgg.check(distance)
    return graph, vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))


def band_table(high):
    """Returns a table of one color per band of distance, alternately lighter and darker."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(BANDS)
    place = np.linspace(0.0, 1.0, len(DISTANCE_COLORS))
    channels = np.array(DISTANCE_COLORS).T
    for i in range(BANDS):
        colour = np.array([np.interp(i / (BANDS - 1.0), place, c) for c in channels])
        table.SetTableValue(i, *(colour * (SHADE if i % 2 else 1.0)), 1.0)
    table.SetRange(0.0, high)
    table.SetNanColor(*UNREACHED, 1.0)
    return table


def panel(title, points, start, towards, zoom, outwards=None, larger=LARGER):
    """Returns a renderer with the points, colored by the distance from the extreme point in the
    direction `start`, seen from the direction `towards`. Points that face away are hidden if the
    orientation is known."""
    direction = np.array(towards, dtype=float)
    direction /= np.linalg.norm(direction)
    source = int(np.argmax(points @ np.array(start)))
    graph, distances = distances_on(points, source)
    shown = np.ones(len(points), bool) if outwards is None else outwards @ direction > -0.1
    cloud = vtkdgg.Mesh(points[shown]).as_polydata()
    size = vtkdgg.Mesh(points).as_polydata().GetLength()
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    table = band_table(np.nanmax(distances))
    radii = larger * disc_radii(spacings_of(graph))
    renderer.AddActor(discs(cloud, radii[shown], distances[shown], table))
    renderer.AddActor(marker(points[source], size))
    renderer.AddViewProp(caption(title))
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.95)
    kit.SetKeyToFillRatio(2.0)
    kit.AddLightsToRenderer(renderer)

    camera = renderer.GetActiveCamera()
    centre = np.array(cloud.GetCenter())
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 3.0 * size * direction))
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    camera.SetWindowCenter(0.0, 0.05)  # room for the caption
    renderer.ResetCameraClippingRange()
    return renderer


def caption(title):
    """Returns an actor of a text at the top."""
    text = vtkTextActor()
    text.SetInput(title)
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(0.5, 0.935)
    style = text.GetTextProperty()
    style.SetJustificationToCentered()
    style.SetColor(*INK)
    style.SetFontSize(28)
    style.SetFontFamilyToArial()
    return text


def panels(share):
    """Yields the four panels row by row from the top left, with a fraction of the points."""
    random = np.random.default_rng(20190525)
    noisy = sphere(int(20000 * share), random, noise=0.02)
    yield panel("noise of 1 % of the box", noisy, (-0.3, -1, 0.8), (0.3, -1, 0.4), 1.4, noisy)
    uneven = sphere(int(8000 * share), random, density=10.0)
    title = "ten times as dense on the left as on the right"
    yield panel(title, uneven, (-0.3, -1, 0.8), (0.3, -1, 0.4), 1.4, uneven, SEPARATE)
    torus = perforated(int(14000 * share), random)
    middle = torus * (1.0, 1.0, 0.0)
    middle /= np.linalg.norm(middle, axis=1)[:, None]
    yield panel("holes", torus, (-0.7, -1, 0.4), (0.1, -1, 1.1), 1.6, torus - middle)
    pair = sheets(int(16000 * share), random)
    title = "two sheets, three radii of balls apart: grey is not reached"
    yield panel(title, pair, (-1, 0.2, 0), (-0.8, -1, 0.7), 1.35)


def main(picture, share=1.0):
    """Render all panels into one picture."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    for i, renderer in enumerate(panels(share)):
        left, bottom = 0.5 * (i % 2), 0.5 - 0.5 * (i // 2)
        renderer.SetViewport(left, bottom, left + 0.5, bottom + 0.5)
        window.AddRenderer(renderer)
    window.Render()
    write_png(picture, window)


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
