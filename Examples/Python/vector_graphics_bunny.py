# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Stanford bunny as painted porcelain, by vtkPoissonVectorGraphics.

First comes the glaze: the rims of a ribbon, which are the tape along a closed geodesic around the
neck; a ring around the tail, isolines of the exact distance from its tip; and a few curves more.
Face and blossoms are drawn in the picture plane and projected to the surface; outside they have the
colour that the glaze has there. Shows the curves beside what they become.
"""

import argparse
import sys

import numpy as np
import vtkdgg
from example_arguments import integer
from surface_canvas import Canvas, Field, Polar, ellipse, ids_of, lines_of, smooth, tangents
from vector_graphics import (
    DIFFUSION,
    POISSON,
    REGION,
    Drawing,
    add_shown,
    color,
    make_clay,
    make_curves,
    make_points,
    make_shaded,
    write_picture,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkRenderingCore import vtkLight

DEFAULT_MESH = "/usr/share/glmark2/models/bunny.obj"
VIEW = (30.0, 12.0)  # degrees around the vertical axis, and above the horizon
TOWARDS_HEAD = np.array([-0.5, 1.0, 0.2])

CREAM, PALE, SKY, DUSK, NIGHT = "fdf6ea", "e3edf5", "8dbae4", "2b4c9c", "14235c"
CORAL, GOLD, BLACK, WHITE = "dc453d", "ecc25a", "1a0d0c", "ffffff"
COOL, WARM = np.array([1.0, 0.9, 0.8]), np.array([0.65, 0.95, 1.0])  # color that shade subtracts

# Coordinates in the picture plane, right and up; the bunny is 2 long.
TAIL = (0.68, -0.76)
EYE = (-0.665, 0.415)
BELL = (-0.700, -0.140, 0.068)
NECK = ((-0.86, -0.06), (-0.62, 0.02), (-0.42, 0.24))
NECK_BEHIND = ((-0.45, 0.16), (-0.75, 0.03))
BACK = ((-0.14, 0.14), (0.02, 0.165), (0.20, 0.155), (0.36, 0.07), (0.50, -0.07), (0.58, -0.25),
        (0.61, -0.42))  # fmt: skip
CHEST = ((-0.92, -0.20), (-0.88, -0.38), (-0.77, -0.52), (-0.62, -0.60))
FAR_EAR = ((-0.40, 0.95), (-0.35, 1.03), (-0.25, 1.06), (-0.16, 1.02), (-0.14, 0.96))
NEAR_EAR = ((-0.22, 0.62), (-0.08, 0.66), (0.07, 0.71), (0.17, 0.785), (0.20, 0.87), (0.15, 0.925),
            (0.06, 0.91), (-0.05, 0.845), (-0.20, 0.735), (-0.36, 0.615))  # fmt: skip
FEET = (
    ((-0.62, -0.815), (-0.585, -0.87), (-0.565, -0.92), (-0.565, -0.975)),
    ((-0.36, -0.82), (-0.26, -0.925), (-0.10, -0.98), (0.06, -0.985), (0.22, -0.955),
     (0.33, -0.945)),
)  # fmt: skip
THIGH = ((-0.10, -0.245), (-0.25, -0.240), (-0.375, -0.29), (-0.425, -0.42), (-0.405, -0.54),
         (-0.355, -0.68))  # fmt: skip
# Blossoms, buds and petals in the wind: position, radius, rotation.
BLOSSOMS = (
    (-0.135, -0.455, 0.135, 0.3),
    (0.150, -0.270, 0.125, 1.0),
    (0.365, -0.455, 0.085, 0.1),
    (0.345, -0.035, 0.085, 0.7),
    (-0.190, 0.055, 0.090, 0.2),
    (-0.235, -0.735, 0.085, 0.9),
    (0.090, -0.780, 0.105, 0.5),
)
BUDS = (
    (0.475, -0.285, 0.036, -0.9),
    (0.110, 0.055, 0.036, 1.1),
    (-0.310, -0.315, 0.036, -2.4),
)
PETALS = (
    (-0.550, -0.130, 0.048, 2.2),
    (-0.735, -0.300, 0.050, 0.6),
    (-0.530, -0.420, 0.042, 1.3),
    (-0.650, -0.460, 0.036, 2.9),
    (-0.395, -0.075, 0.040, 0.2),
)
# Twigs: points, and thickness at both ends.
TWIGS = (
    (((0.375, -0.915), (0.30, -0.73), (0.17, -0.57), (0.04, -0.50), (-0.13, -0.45)), 0.027, 0.011),
    (((0.18, -0.58), (0.22, -0.42), (0.15, -0.27), (0.05, -0.14), (-0.07, -0.03), (-0.19, 0.06)),
     0.016, 0.008),
    (((0.21, -0.40), (0.29, -0.26), (0.31, -0.15), (0.35, -0.03)), 0.012, 0.007),
    (((0.27, -0.68), (0.31, -0.57), (0.37, -0.45)), 0.013, 0.007),
    (((0.29, -0.74), (0.21, -0.74), (0.09, -0.78)), 0.014, 0.008),
    (((0.02, -0.50), (-0.07, -0.62), (-0.24, -0.74)), 0.012, 0.007),
    (((0.30, -0.20), (0.40, -0.21), (0.475, -0.285)), 0.009, 0.006),
    (((0.06, -0.15), (0.06, -0.04), (0.11, 0.055)), 0.009, 0.006),
    (((-0.10, -0.42), (-0.17, -0.29), (-0.25, -0.275), (-0.31, -0.315)), 0.009, 0.006),
)  # fmt: skip


def mix(first, second, t):
    """Returns colors between two, at numbers from 0 to 1."""
    t = np.clip(t, 0.0, 1.0)[:, None]
    return (1.0 - t) * color(first) + t * color(second)


def make_bunny(path):
    """Returns the mesh, centered, smoothed and of length 2, with smooth normals."""
    surface = vtkWindowedSincPolyDataFilter()
    surface.SetInputData(vtkdgg.read(path).as_polydata())
    surface.SetNumberOfIterations(30)
    surface.SetPassBand(0.025)
    surface.NormalizeCoordinatesOn()
    surface.BoundarySmoothingOff()
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SplittingOff()
    computed = vtkdgg.check(normals)
    points = np.array(vtk_to_numpy(computed.GetPoints().GetData()), dtype=float)
    low, high = points.min(axis=0), points.max(axis=0)
    mesh = vtkPolyData()
    mesh.SetPoints(make_points((points - 0.5 * (low + high)) * (2.0 / (high - low)[0])))
    mesh.SetPolys(computed.GetPolys())
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    normal = np.array(vtk_to_numpy(computed.GetPointData().GetNormals()), dtype=float)
    for _ in range(20):
        sums = normal[triangles].sum(axis=1)
        for k in range(3):
            normal[:, k] = np.bincount(triangles.ravel(), np.repeat(sums[:, k], 3), len(points))
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-30)[:, None]
    array = numpy_to_vtk(normal, deep=True)
    array.SetName("Normals")
    mesh.GetPointData().SetNormals(array)
    return mesh


def paint(mesh, curves, level):
    """Returns the mesh with colors."""
    graphics = vtkdgg.vtkPoissonVectorGraphics()
    graphics.SetInputData(mesh)
    graphics.SetCurveData(curves)
    graphics.SetRefinementLevel(level)
    graphics.SetRefinementRegionToNearCurves()
    return vtkdgg.check(graphics)


class Painter:
    """Adds curves on a canvas to a drawing."""

    def __init__(self, canvas):
        self.canvas, self.drawing = canvas, Drawing()
        self.glaze, self.locator = None, vtkStaticPointLocator()

    def fire(self):
        """Make a glaze from the curves drawn so far."""
        self.glaze = paint(self.canvas.mesh, self.drawing.make(), 0)
        self.locator.SetDataSet(self.glaze)
        self.locator.BuildLocator()

    def colors_at(self, points):
        """Returns colors of the glaze."""
        ids = [self.locator.FindClosestPoint(point) for point in points]
        return vtk_to_numpy(self.glaze.GetPointData().GetArray("Colors"))[ids]

    def add_line(self, points, left, right, is_closed=False):
        """Add a curve with colors on both sides."""
        self.drawing.add(DIFFUSION, points, is_closed, LeftColor=left, RightColor=right)

    def add_ring(self, outline, inside, outside=None):
        """Add a closed curve with colors on both sides; outside, the glaze by default."""
        points = self.canvas.place(outline)
        self.add_line(points, inside, self.colors_at(points) if outside is None else outside, True)

    def add_shade(self, points, width, left, right, tint=COOL, fade=0.6):
        """Add a Poisson curve whose strength is largest in its middle."""
        line = smooth(points)
        t = np.linspace(-1.0, 1.0, len(line))[:, None]
        strength = tint * np.maximum(1.0 - t**2, 0.0) ** fade
        self.drawing.add(
            POISSON,
            self.canvas.place(line),
            width=width,
            Strength=left * strength,
            RightStrength=right * strength,
        )


def add_ribbon(painter):
    """Add a ribbon around the neck: the borders of two tapes along a taut rope."""
    canvas = painter.canvas
    stakes = vtkPolyData()
    stakes.SetPoints(
        make_points(np.concatenate([canvas.place(NECK), canvas.place(NECK_BEHIND, -1.0)]))
    )
    rope = vtkdgg.vtkDGGLoop()
    rope.SetInputData(canvas.mesh)
    rope.SetPointData(stakes)
    rope.SetModeToRope()
    rope.TautOn()
    for width, above, below, inside in ((0.150, CREAM, SKY, GOLD), (0.112, GOLD, GOLD, CORAL)):
        rope.SetTapeWidth(width)
        if vtkdgg.check(rope).GetNumberOfLines() != 1:
            raise ValueError("a ribbon slips off: this is no bunny")
        (middle,) = lines_of(rope.GetOutput())
        for rim in lines_of(rope.GetTape()):
            is_upper = (rim.mean(axis=0) - middle.mean(axis=0)) @ TOWARDS_HEAD > 0.0
            left, right = (above, inside) if is_upper else (inside, below)
            rim = canvas.with_left(rim[:-1], TOWARDS_HEAD)
            painter.add_line(rim, color(left), color(right), True)
    fold = canvas.with_left(middle[:-1], TOWARDS_HEAD)
    painter.drawing.add(
        POISSON, fold, True, width=0.056, Strength=0.16 * COOL, RightStrength=-0.10 * COOL
    )


def add_tail(painter):
    """Add a ring between two geodesic distances from the tip of the tail."""
    canvas = painter.canvas
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(canvas.mesh)
    distance.SetSourceIds(canvas.nearest(canvas.place([TAIL])))
    distance.GenerateWindowsOn()
    rings = vtkdgg.vtkApolloniusIsolines()
    rings.SetInputConnection(distance.GetOutputPort())
    rings.GenerateValues(2, 0.300, 0.325)
    # The closer side is on the left.
    for ring, left, right in zip(lines_of(vtkdgg.check(rings)), (CREAM, GOLD), (GOLD, SKY)):
        painter.add_line(ring[:-1], color(left), color(right), True)


def add_glaze(painter):
    """Add the curves that color the whole surface: night on the back, cream on the face."""
    add_ribbon(painter)
    add_tail(painter)
    place = painter.canvas.place
    for points, middle, ends, signs in (
        (BACK, NIGHT, "4f7cc0", (1.0, -1.0)),
        (CHEST, PALE, PALE, (1.0,)),
        (FAR_EAR, NIGHT, DUSK, (1.0,)),
    ):
        for sign in signs:
            line = place(smooth(points), sign)
            shade = mix(ends, middle, np.sin(np.linspace(0.0, np.pi, len(line))) ** 0.7)
            painter.add_line(line, shade, shade)
    # Both sides have the same color at both ends.
    for points in FEET:
        line = place(smooth(points))
        t = np.sin(np.linspace(0.0, np.pi, len(line))) ** 0.5
        painter.add_line(line, mix(PALE, "6c9fd6", t), mix(PALE, CREAM, t))
    ear = smooth(NEAR_EAR, True)
    t = np.clip((ear @ [0.9, 0.45] + 0.05) / 0.50, 0.0, 1.0)  # to the tip
    painter.add_ring(ear, mix("ee8b90", "fde3d8", t), mix(CREAM, DUSK, t**1.5))


def add_face(painter):
    """Add an eye, nose, mouth and a rosy cheek."""
    u, v = EYE
    painter.add_ring(ellipse(u, v, 0.074, 0.066, -0.25), color(BLACK))
    painter.add_ring(ellipse(u - 0.003, v, 0.060, 0.055, -0.25), color("9a531e"), color(BLACK))
    painter.add_ring(ellipse(u - 0.005, v + 0.002, 0.037, 0.037), color(BLACK), color("5a2712"))
    painter.add_ring(ellipse(u - 0.016, v + 0.014, 0.016, 0.014), color(WHITE), color(BLACK))
    angle = np.array([-2.2, -1.5, -0.7, 0.1])
    glow = np.stack([u - 0.003 + 0.048 * np.cos(angle), v + 0.046 * np.sin(angle)], axis=1)
    painter.add_shade(glow, 0.016, 0.45, 0.45)
    upper_lid = ((u - 0.108, v - 0.030), (u - 0.072, v + 0.060), (u + 0.005, v + 0.098),
                 (u + 0.078, v + 0.060), (u + 0.115, v - 0.010))  # fmt: skip
    painter.add_shade(upper_lid, 0.06, 0.02, -0.24, WARM)
    lower_lid = ((u - 0.080, v - 0.066), (u, v - 0.093), (u + 0.082, v - 0.064))
    painter.add_shade(lower_lid, 0.045, -0.12, 0.0, WARM)
    cheek = painter.canvas.place(ellipse(-0.765, 0.205, 0.120, 0.090, 0.2))
    painter.drawing.add(REGION, cheek, True, Strength=np.array([0.02, -0.26, -0.20]))
    nose = smooth(((-1.072, 0.135), (-1.040, 0.165), (-1.030, 0.195), (-1.060, 0.210),
                   (-1.092, 0.200), (-1.095, 0.170)), True)  # fmt: skip
    painter.add_ring(nose, mix("d0687b", "f8b9b4", 13.0 * (nose[:, 1] - 0.13)))
    mouth = ((-1.060, 0.115), (-1.048, 0.060), (-1.005, 0.035), (-0.950, 0.042), (-0.895, 0.080))
    painter.add_shade(mouth, 0.030, -0.05, -0.40, WARM)


def add_bell(painter):
    """Add a bell whose colors look round, with Poisson curves for the seam and the slot."""
    middle, radius = np.array(BELL[:2]), BELL[2]
    rim = ellipse(*middle, radius, radius)
    lit = 0.5 + (rim - middle) @ [-0.35, 0.45] / radius
    painter.add_ring(rim, mix("8a5518", "f4cf6b", lit))
    glint = middle + radius * ellipse(-0.35, 0.42, 0.22, 0.16, 0.7)[::4]
    painter.add_ring(glint, color("fffbe6"), color("f8dc84"))
    x = np.linspace(-0.85, 0.85, 5)
    seam = middle + radius * np.stack([x, -0.26 + 0.16 * x**2], axis=1)
    painter.add_shade(seam, 0.3 * radius, 0.25, -0.35, fade=0.2)
    slot = middle + radius * np.array([(0.30, -0.48), (0.27, -0.65), (0.18, -0.85)])
    painter.add_shade(slot, 0.2 * radius, -0.5, -0.5, fade=0.3)


def petals(angle):
    """Returns the radius of a blossom with five notched petals."""
    wave = np.abs(np.sin(2.5 * angle))
    return 0.50 + 0.50 * wave**0.75 - 0.09 * np.exp(-(((1.0 - wave) / 0.03) ** 2))


def add_branch(painter):
    """Add the outline of all twigs, except where blossoms and buds hide them."""
    field = Field((-0.45, -1.0), (0.62, 0.25), 0.004)
    for points, first, last in TWIGS:
        line = smooth(points)
        along = np.arange(len(line))
        field.add_stroke(
            line,
            np.linspace(first, last, len(line))
            * (1.0 + 0.10 * np.sin(0.9 * along))
            * np.minimum(1.0, 0.3 + 0.18 * along),
        )
    gap = 0.007
    for place in BLOSSOMS:
        r, angle = Polar(painter.canvas, *place).coordinates(field.places)
        field.values = np.maximum(field.values, place[2] * (petals(angle) - r) + gap)
    for u, v, radius, _ in BUDS:
        away = np.hypot(*np.moveaxis(field.places - [u, v], -1, 0))
        field.values = np.maximum(field.values, 0.6 * radius - away + gap)
    for line in field.outlines():
        if len(line) > 10:
            x, y = tangents(line, True).T
            lit = 0.5 + 0.6 * (0.8 * -x - 0.6 * y) / np.hypot(x, y)  # from the upper left
            painter.add_ring(line, mix("2b1422", "a06a52", lit))


def add_flowers(painter):
    """Add a branch with blossoms and buds on the flank, and petals in the wind."""
    add_branch(painter)
    angle = np.linspace(0.0, 2.0 * np.pi, 121)[:-1]
    for place in BLOSSOMS:
        flower, radius = Polar(painter.canvas, *place), place[2]
        painter.add_ring(flower.at(petals(angle), angle), color("fff6f2"))
        painter.add_ring(flower.at(0.15, angle[::5]), color("f9d65c"), color("e0587f"))
        for k in range(5):
            between = painter.canvas.place(flower.at(np.linspace(0.46, 0.24, 9), 0.4 * np.pi * k))
            painter.drawing.add(
                POISSON,
                between,
                width=0.30 * radius,
                Strength=np.array([-0.18, -0.38, -0.30]),
                RightStrength=0.05 * np.ones(3),
            )
    angle = angle[::4]
    to_tip = np.cos(0.5 * angle) ** 2
    for place in BUDS:
        bud = Polar(painter.canvas, *place).at(1.0 - 0.42 * np.sin(0.5 * angle) ** 1.5, angle)
        painter.add_ring(bud, mix("c8325f", "fbd3d6", to_tip))
    notch = np.exp(-((np.minimum(angle, 2.0 * np.pi - angle) / 0.35) ** 2))
    x = np.cos(angle) - 0.28 * notch
    y = 0.62 * np.sin(angle) * (1.0 + 0.35 * np.cos(angle))
    for place in PETALS:
        petal = Polar(painter.canvas, *place).at(np.hypot(x, y), np.arctan2(y, x))
        painter.add_ring(petal, mix("ee7f9b", "fff6f2", to_tip))


def make_sides(curves, canvas):
    """Returns actors of tubes for both sides of curves, side by side."""
    sides = []
    for name, sign in (("Above", 1.0), ("Below", -1.0)):
        moved = vtkPolyData()
        moved.DeepCopy(curves)
        points = vtk_to_numpy(moved.GetPoints().GetData())
        for ids in ids_of(curves.GetLines()):
            is_closed = ids[0] == ids[-1]
            ids = ids[:-1] if is_closed else ids
            left = canvas.left(points[ids], is_closed)
            points[ids] += 0.004 * sign * left + 0.002 * canvas.sight
        sides.append(make_curves(moved, name, 0.0042))
    return sides


def make_look(canvas):
    """Returns a function that sets the camera in front of the picture plane, and the lights."""
    right, up = canvas.axes

    def look(renderer):
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(1.24)
        camera.SetFocalPoint(*(-0.16 * right))
        camera.SetPosition(*(-0.16 * right + 6.0 * canvas.sight))
        camera.SetViewUp(*up)
        for (x, y, z), strength in (((-2.5, 3.0, 4.5), 0.82), ((4.0, 0.0, 3.0), 0.32)):
            light = vtkLight()
            light.SetPosition(*(x * right + y * up + z * canvas.sight))
            light.SetFocalPoint(0.0, 0.0, 0.0)
            light.SetIntensity(strength)
            renderer.AddLight(light)

    return look


def make_porcelain(data):
    """Returns a shiny actor."""
    actor = make_shaded(data)
    actor.GetProperty().SetAmbient(0.47)
    actor.GetProperty().SetSpecular(0.22)
    actor.GetProperty().SetSpecularPower(40.0)
    return actor


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", help="PNG file to write")
    parser.add_argument(
        "mesh", nargs="?", default=DEFAULT_MESH, help="the bunny (default: %(default)s)"
    )
    parser.add_argument(
        "--level", type=integer(0, 4), default=2, help="refinement around curves (default 2)"
    )
    arguments = parser.parse_args()
    bunny = make_bunny(arguments.mesh)
    canvas = Canvas(bunny, *VIEW)
    painter = Painter(canvas)
    add_glaze(painter)
    painter.fire()
    add_face(painter)
    add_bell(painter)
    painter.add_shade(THIGH, 0.10, 0.08, -0.16)
    add_flowers(painter)
    curves = painter.drawing.make()
    painted = paint(bunny, curves, arguments.level)
    print(
        f"{curves.GetNumberOfLines()} curves on {bunny.GetNumberOfPoints()} points, "
        f"colours at {painted.GetNumberOfPoints()}"
    )
    if arguments.picture:
        add_shown(curves)
        clay = [make_clay(bunny), *make_sides(curves, canvas)]
        write_picture(clay, [make_porcelain(painted)], make_look(canvas), arguments.picture)


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError, vtkdgg.VTKError) as error:
        sys.exit(str(error))
