# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A vase painted by vtkPoissonVectorGraphics: misty mountains from a few dozen curves.

Each ridge is a diffusion curve, with mist above and the colour of the mountain below it; spurs and
clouds are Poisson curves, light on one side and dark on the other; banks of mist are Poisson
regions. Shows the curves beside what they become.
"""

import argparse
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

DIFFUSION, POISSON, REGION = 0, 1, 2
# Height and radius of the vase, whose height is 1.
PROFILE = np.array(
    [
        (0.00, 0.200),
        (0.03, 0.215),
        (0.12, 0.285),
        (0.25, 0.362),
        (0.40, 0.400),
        (0.55, 0.385),
        (0.68, 0.318),
        (0.79, 0.225),
        (0.86, 0.178),
        (0.91, 0.170),
        (0.96, 0.192),
        (1.00, 0.235),
    ]
)
# Ridges from the top: height of the valleys, height of peaks above them, number of peaks, color
# above and below.
RIDGES = (
    (0.525, 0.085, 7, "ffdcae", "b3b4d8"),
    (0.430, 0.105, 6, "f6dfd2", "8596c8"),
    (0.315, 0.115, 7, "d3d9ec", "4f70ab"),
    (0.190, 0.110, 6, "a9c3da", "28497c"),
    (0.095, 0.040, 5, "86aac4", "0d1f3f"),
)
SUN = (-0.30, 0.665, 0.043)  # angle from the front, height, radius
TREES = 150  # on the last ridge


def color(text):
    """Returns RGB from 0 to 1."""
    return np.array([int(text[i : i + 2], 16) / 255.0 for i in (0, 2, 4)])


def radius_at(height):
    """Returns the radius of the vase, a Catmull-Rom spline through the profile."""
    z, r = PROFILE.T
    slope = np.gradient(r, z)
    i = np.clip(np.searchsorted(z, height, side="right") - 1, 0, len(z) - 2)
    step = z[i + 1] - z[i]
    t = (height - z[i]) / step
    return (
        (2 * t**3 - 3 * t**2 + 1) * r[i]
        + (t**3 - 2 * t**2 + t) * step * slope[i]
        + (3 * t**2 - 2 * t**3) * r[i + 1]
        + (t**3 - t**2) * step * slope[i + 1]
    )


def place(angle, height):
    """Returns points on the vase; angle 0 is in front."""
    radius = radius_at(height)
    return np.stack([radius * np.sin(angle), -radius * np.cos(angle), height], axis=-1)


def make_points(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(coordinates, dtype=float), deep=True))
    return points


def make_vase(columns):
    """Returns the triangles of the vase with normals, open at the top and at the bottom."""
    rows = int(round(0.55 * columns))
    heights = np.linspace(0.0, 1.0, rows + 1)
    j, i = np.meshgrid(np.arange(rows + 1), np.arange(columns), indexing="ij")
    angles = 2.0 * np.pi * (i + 0.5 * (j % 2)) / columns
    heights = heights[j]
    step = 1e-5
    slope = (radius_at(heights + step) - radius_at(heights - step)) / (2.0 * step)
    normals = np.stack([np.sin(angles), -np.cos(angles), -slope], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1)[..., None]
    a = (j * columns + i)[:-1]
    b = (j * columns + (i + 1) % columns)[:-1]
    is_odd = (j % 2 == 1)[:-1]
    c, d = a + columns, b + columns
    first = np.where(is_odd[..., None], np.stack([a, b, d], -1), np.stack([a, b, c], -1))
    second = np.where(is_odd[..., None], np.stack([a, d, c], -1), np.stack([b, d, c], -1))
    triangles = np.concatenate([first.reshape(-1, 3), second.reshape(-1, 3)])
    cells = vtkCellArray()
    offsets = numpy_to_vtk(3 * np.arange(len(triangles) + 1), deep=True)
    cells.SetData(offsets, numpy_to_vtk(triangles.ravel().copy(), deep=True))
    vase = vtkPolyData()
    vase.SetPoints(make_points(place(angles, heights).reshape(-1, 3)))
    vase.SetPolys(cells)
    array = numpy_to_vtk(normals.reshape(-1, 3).copy(), deep=True)
    array.SetName("Normals")
    vase.GetPointData().SetNormals(array)
    return vase


class Drawing:
    """Curves with the arrays that vtkPoissonVectorGraphics reads."""

    def __init__(self):
        self.points, self.cells, self.types, self.widths = [], [], [], []
        self.numbers = {"LeftColor": [], "RightColor": [], "Strength": [], "RightStrength": []}

    def add(self, kind, points, is_closed=False, width=1.0, **numbers):
        """Add a curve; arguments are one color, or one per point."""
        first = sum(map(len, self.points))
        ids = list(range(first, first + len(points)))
        self.cells.append(ids + ids[:1] if is_closed else ids)
        self.points.append(points)
        self.types.append(kind)
        self.widths.append(width)
        for name, array in self.numbers.items():
            value = np.asarray(numbers.get(name, np.zeros(3)), dtype=float)
            array.append(np.broadcast_to(value, (len(points), 3)))

    def make(self):
        curves = vtkPolyData()
        curves.SetPoints(make_points(np.concatenate(self.points)))
        lines = vtkCellArray()
        for ids in self.cells:
            lines.InsertNextCell(len(ids))
            for point in ids:
                lines.InsertCellPoint(point)
        curves.SetLines(lines)
        kinds = vtkIntArray()
        kinds.SetName("CurveType")
        for kind in self.types:
            kinds.InsertNextValue(kind)
        curves.GetCellData().AddArray(kinds)
        widths = numpy_to_vtk(np.array(self.widths), deep=True)
        widths.SetName("Width")
        curves.GetCellData().AddArray(widths)
        for name, array in self.numbers.items():
            values = numpy_to_vtk(np.concatenate(array), deep=True)
            values.SetName(name)
            curves.GetPointData().AddArray(values)
        return curves


class Ridge:
    """The skyline of mountains around the vase, with steep peaks."""

    def __init__(self, height, rise, count, random):
        step = 2.0 * np.pi / count
        self.height = height
        self.peaks = step * (np.arange(count) + random.uniform(-0.28, 0.28, count))
        self.rises = rise * random.uniform(0.55, 1.0, count)
        self.widths = step * random.uniform(0.55, 0.8, count)
        self.waves = [
            (k, 0.09 * rise * (9.0 / k) ** 0.8, random.uniform(0.0, 2.0 * np.pi))
            for k in (9, 17, 31, 57)
        ]

    def __call__(self, angle):
        height = np.zeros_like(angle)
        for peak, rise, width in zip(self.peaks, self.rises, self.widths):
            away = np.abs((angle - peak + np.pi) % (2.0 * np.pi) - np.pi) / width
            height = np.maximum(height, rise * np.clip(1.0 - away, 0.0, 1.0) ** 1.25)
        # |sin| has sharp extrema, like rocks.
        rocks = sum(a * (0.5 - np.abs(np.sin(0.5 * k * angle + p))) for k, a, p in self.waves)
        return self.height + height + rocks


def add_spurs(drawing, ridge, lower, random):
    """Add spurs that run down from peaks, light on the sunny side and dark on the other."""
    for peak, rise in zip(ridge.peaks, ridge.rises):
        for start, lean in ((0.0, 0.5), (-0.11, -1.0), (0.12, 1.1)):
            foot = peak + start
            top = ridge(np.array([foot]))[0] - 0.002
            drop = (0.95 if start == 0.0 else 0.6) * rise
            drop = min(drop, top - 0.012 - lower(np.array([foot + 0.08 * lean]))[0])
            if drop < 0.02:
                continue
            t = np.linspace(0.0, 1.0, 13)
            bend = 0.022 * np.sin(8.0 * t + random.uniform(0.0, 6.0)) * t
            spur = place(foot + 1.1 * drop * lean * t + bend, top - drop * t)
            fade = (np.sqrt(np.clip(4.0 * t, 0.0, 1.0)) * (1.0 - t) ** 0.7)[:, None]
            strength = 0.17 if start == 0.0 else 0.11
            # Walking down, the right hand is on the left of the picture, as is the sun.
            drawing.add(
                POISSON,
                spur,
                width=0.30 * drop + 0.012,
                Strength=-strength * fade * np.array([0.9, 0.9, 0.8]),
                RightStrength=strength * fade * np.array([1.15, 1.0, 0.85]),
            )


def make_skyline(ridge):
    """Returns a skyline of fir trees on a ridge."""
    random = np.random.RandomState(5)
    step = 2.0 * np.pi / TREES
    middle = step * (np.arange(TREES) + random.uniform(-0.07, 0.07, TREES))
    height = random.uniform(0.016, 0.040, TREES) * (0.75 + 0.25 * np.sin(5.0 * middle))
    angles = np.stack([middle - 0.42 * step, middle, middle + 0.42 * step], axis=1).ravel()
    rises = np.stack([0.0 * height, height, 0.0 * height], axis=1).ravel()
    return place(angles, ridge(angles) + rises)


def make_ellipse(angle, height, width, tall):
    """Returns a curve around a point of the vase that is an ellipse in the front view."""
    turn = np.linspace(0.0, 2.0 * np.pi, 73)[:-1]
    heights = height + tall * np.sin(turn)
    x = radius_at(height) * np.sin(angle) + width * np.cos(turn)
    return place(np.arcsin(x / radius_at(heights)), heights)


def draw():
    """Draw mountains, the sky, the sun and a few clouds."""
    random = np.random.RandomState(4)
    drawing = Drawing()
    angles = np.linspace(0.0, 2.0 * np.pi, 721)[:-1]
    night, dusk, gold = color("1d2b57"), color("5d5f9f"), color("e8c987")

    # Around the neck: glaze, a line of gold, and the sky, which is lighter at the bottom; its curve
    # has the same color on both sides.
    for height, above, below in ((0.905, night, gold), (0.890, gold, night), (0.785, dusk, dusk)):
        ring = place(angles[::8], np.full(90, height))
        drawing.add(DIFFUSION, ring, True, LeftColor=above, RightColor=below)
    ridges = [Ridge(height, rise, count, random) for height, rise, count, _, _ in RIDGES]
    for k, (ridge, (_, _, _, above, below)) in enumerate(zip(ridges, RIDGES)):
        is_last = k + 1 == len(ridges)
        line = make_skyline(ridge) if is_last else place(angles, ridge(angles))
        drawing.add(DIFFUSION, line, True, LeftColor=color(above), RightColor=color(below))
        if not is_last:
            add_spurs(drawing, ridge, ridges[k + 1], random)

    # The sun.
    angle, height, radius = SUN
    around = make_ellipse(angle, height, radius, 0.9 * radius)
    drawing.add(DIFFUSION, around, True, LeftColor=color("fffbe8"), RightColor=color("ffd08a"))
    # Banks of mist.
    for angle, height, width in ((0.45, 0.300, 0.10), (-0.55, 0.185, 0.09), (0.10, 0.440, 0.07)):
        bank = make_ellipse(angle, height, width, 0.016)
        drawing.add(REGION, bank, True, Strength=np.array([0.22, 0.22, 0.20]))
    # Clouds, lit from below with a sharp border.
    for middle, height, length in (
        (0.10, 0.755, 0.60),
        (0.55, 0.705, 0.66),
        (-0.92, 0.725, 0.55),
        (1.05, 0.750, 0.45),
        (2.20, 0.700, 0.70),
        (3.40, 0.730, 0.60),
    ):
        t = np.linspace(-1.0, 1.0, 49)
        wave = 0.009 * np.abs(np.sin(4.4 * t + 9.0 * height)) + 0.004 * np.sin(2.0 * t + 1.0)
        fade = (1.0 - t**2)[:, None]
        drawing.add(
            POISSON,
            place(middle + 0.5 * length * t, height + wave),
            width=0.035,
            Strength=-0.05 * fade * np.ones(3),
            RightStrength=0.27 * fade * np.array([1.0, 0.62, 0.45]),
        )
    return drawing.make()


def make_actor(data):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def make_shaded(data):
    actor = make_actor(data)
    surface = actor.GetProperty()
    surface.SetAmbient(0.42)
    surface.SetDiffuse(0.66)
    surface.SetSpecular(0.10)
    surface.SetSpecularPower(18.0)
    return actor


def make_clay(data):
    """Returns an actor of the unpainted surface."""
    actor = make_shaded(data)
    actor.GetProperty().SetColor(0.95, 0.94, 0.92)
    return actor


def make_curves(curves, name, radius=0.0021):
    """Returns an actor of tubes in the colors of one side."""
    tubes = vtkTubeFilter()
    tubes.SetInputData(curves)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(10)
    actor = make_actor(vtkdgg.check(tubes))
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetColorModeToDirectScalars()
    actor.GetProperty().LightingOff()
    return actor


def make_scene(actors, viewport):
    """Returns a renderer of one panel."""
    renderer = vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.80, 0.79, 0.77)
    renderer.SetBackground2(0.96, 0.955, 0.945)
    for actor in actors:
        renderer.AddActor(actor)
    return renderer


def look_at_vase(renderer):
    """Set the camera and the lights in front of the vase."""
    for position, strength in (((-2.5, -3.0, 3.0), 0.80), ((3.0, -2.5, 0.5), 0.35)):
        light = vtkLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0.0, 0.0, 0.5)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.0, 0.0, 0.505)
    camera.SetPosition(0.0, -4.0, 1.35)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(17.5)


def write_picture(left, right, look, path):
    """Write two panels of actors side by side; `look` sets cameras and lights."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1280, 760)
    for actors, viewport in ((left, (0.0, 0.0, 0.5, 1.0)), (right, (0.5, 0.0, 1.0, 1.0))):
        renderer = make_scene(actors, viewport)
        look(renderer)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetScale(2)
    image.ReadFrontBufferOff()
    smooth = vtkImageShrink3D()
    smooth.SetShrinkFactors(2, 2, 1)
    smooth.SetInputConnection(image.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(smooth.GetOutputPort())
    vtkdgg.check(writer)


def add_shown(curves):
    """Add the curves with display colors: their own, or light and dark for Poisson curves."""
    data = curves.GetPointData()
    read = lambda name: vtk_to_numpy(data.GetArray(name))  # noqa: E731
    is_color = (read("LeftColor").sum(axis=1) > 0.0)[:, None]
    for name, color_name, added in (
        ("Above", "LeftColor", (0.45, 0.20, 0.10)),
        ("Below", "RightColor", (1.0, 0.70, 0.35)),
    ):
        shown = np.where(is_color, read(color_name), np.array(added))
        array = numpy_to_vtk(np.rint(255.0 * shown).astype(np.uint8), deep=True)
        array.SetName(name)
        data.AddArray(array)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", help="PNG file to write")
    parser.add_argument(
        "--columns", type=integer(24, 1000), default=200, help="triangles around (default 200)"
    )
    parser.add_argument(
        "--level", type=integer(0, 4), default=2, help="refinement around curves (default 2)"
    )
    arguments = parser.parse_args()
    vase = make_vase(arguments.columns)
    curves = draw()
    graphics = vtkdgg.vtkPoissonVectorGraphics()
    graphics.SetInputData(vase)
    graphics.SetCurveData(curves)
    graphics.SetRefinementLevel(arguments.level)
    graphics.SetRefinementRegionToNearCurves()
    painted = vtkdgg.check(graphics)
    print(
        f"{curves.GetNumberOfLines()} curves on {vase.GetNumberOfPoints()} points, "
        f"colours at {painted.GetNumberOfPoints()}"
    )
    if arguments.picture:
        add_shown(curves)
        above, below = make_curves(curves, "Above"), make_curves(curves, "Below")
        above.SetPosition(0.0, 0.0, 0.002)
        below.SetPosition(0.0, 0.0, -0.002)
        clay = [make_clay(vase), above, below]
        write_picture(clay, [make_shaded(painted)], look_at_vase, arguments.picture)


if __name__ == "__main__":
    try:
        main()
    except vtkdgg.VTKError as error:
        sys.exit(str(error))
