# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and rendering of Examples/Tutorial.md; as a program, run its snippets.

Usage: tutorial.py FOLDER    (FOLDER receives the pictures)
"""

import os
import re
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImplicitBoolean,
    vtkPolyData,
    vtkSphere,
)
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkContourFilter,
    vtkDelaunay2D,
    vtkGlyph3D,
    vtkPolyDataNormals,
    vtkTriangleFilter,
    vtkTubeFilter,
)
from vtkmodules.vtkFiltersModeling import vtkBandedPolyDataContourFilter, vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)


def terrain():
    """Points and triangles of hills over a grid of 10 x 6 km, heights in km."""
    x, y = np.meshgrid(np.linspace(0.0, 10.0, 121), np.linspace(0.0, 6.0, 73))
    height = np.zeros_like(x)
    hills = ((2, 1.5, 1.9, 0.9), (4.6, 3.9, 2.6, 1.1), (7.2, 3, 2.4, 0.8), (8, 5, 1, 1))
    for a, b, top, width in hills:
        height += top * np.exp(-((x - a) ** 2 + (y - b) ** 2) / width**2)
    points = np.column_stack([x.ravel(), y.ravel(), height.ravel()])
    ids = np.arange(points.shape[0]).reshape(x.shape)
    corners = (ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1])
    a, b, c, d = (corner.ravel() for corner in corners)
    return points, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def vessel():
    """Isosurface of three joined tubes with a bulge, as a vtkPolyData."""
    balls = vtkImplicitBoolean()
    balls.SetOperationTypeToUnion()

    def add(center, radius):
        ball = vtkSphere()
        ball.SetCenter(center)
        ball.SetRadius(radius)
        balls.AddFunction(ball)

    for t in np.linspace(0.0, 1.0, 40):
        add((-2.2 * t, 0.2 * np.sin(3.0 * t), 0.0), 0.42)
        add((2.0 * t, 1.1 * t * t, 0.1 * t), 0.32)
        add((2.0 * t, -1.2 * t * t, 0.0), 0.30)
    add((0.25, 0.0, 0.85), 0.62)
    sampled = vtkSampleFunction()
    sampled.SetImplicitFunction(balls)
    sampled.SetModelBounds(-2.4, 2.1, -1.6, 1.6, -0.7, 1.6)
    sampled.SetSampleDimensions(84, 60, 44)
    sampled.ComputeNormalsOff()
    contour = vtkContourFilter()
    contour.SetInputConnection(sampled.GetOutputPort())
    contour.SetValue(0, 0.0)
    return vtkdgg.check(contour)


def angle_plate():
    """An L-shaped plate with a hole, of few long triangles, as a vtkPolyData."""
    outline = [(0, 0), (6, 0), (6, 1.5), (2, 1.5), (2, 4), (0, 4)]
    around = np.linspace(0.0, 2.0 * np.pi, 25)[:-1]
    hole = np.column_stack([1.0 + 0.5 * np.cos(-around), 3.0 + 0.5 * np.sin(-around)])
    points, rings = vtkPoints(), vtkCellArray()
    for ring in (outline, hole):
        ids = [points.InsertNextPoint(u, v, 0.0) for u, v in ring]
        rings.InsertNextCell(len(ids), ids)
    flat, limits = vtkPolyData(), vtkPolyData()
    flat.SetPoints(points)
    limits.SetPoints(points)
    limits.SetPolys(rings)
    fill = vtkDelaunay2D()
    fill.SetInputData(flat)
    fill.SetSourceData(limits)
    thick = vtkLinearExtrusionFilter()
    thick.SetInputConnection(fill.GetOutputPort())
    thick.SetVector(0.0, 0.0, 1.0)
    solid = vtkCleanPolyData()
    solid.SetInputConnection(thick.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(solid.GetOutputPort())
    return vtkdgg.check(triangles)


def actor(mesh, color=None):
    """Actor of a vtkPolyData in one color, or in the colors of its active scalars."""
    colors = vtkLookupTable()
    colors.SetHueRange(0.13, 0.76)
    colors.SetSaturationRange(0.5, 0.6)
    colors.SetValueRange(1.0, 0.75)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarVisibility(color is None)
    mapper.SetLookupTable(colors)
    result = vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(color or (1.0, 1.0, 1.0))
    result.GetProperty().SetAmbient(0.3)
    result.GetProperty().SetDiffuse(0.7)
    return result


def tubes(lines, radius, color):
    """Actor of polylines, drawn as tubes."""
    around = vtkTubeFilter()
    around.SetInputData(lines)
    around.SetRadius(radius)
    around.SetNumberOfSides(12)
    return actor(vtkdgg.check(around), color)


def bands(surface, array, count):
    """Actor of a surface, colored in bands of equal width of a point array."""
    surface.GetPointData().SetActiveScalars(array)
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    divided = vtkBandedPolyDataContourFilter()
    divided.SetInputConnection(normals.GetOutputPort())
    low, high = surface.GetPointData().GetArray(array).GetRange()
    divided.GenerateValues(count + 1, low, high)
    divided.SetScalarModeToValue()
    result = actor(vtkdgg.check(divided))
    result.GetMapper().SetScalarModeToUseCellData()
    result.GetMapper().SetScalarRange(low, high)
    return result


def dots(cloud, array, radius):
    """Actor of a ball at each point, in the colors of an integer point array."""
    cloud.GetPointData().SetActiveScalars(array)
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    balls = vtkGlyph3D()
    balls.SetInputData(cloud)
    balls.SetSourceConnection(ball.GetOutputPort())
    balls.ScalingOff()
    result = actor(vtkdgg.check(balls))
    result.GetMapper().SetScalarRange(cloud.GetPointData().GetArray(array).GetRange())
    return result


def save(file, actors, position, up=(0.0, 0.0, 1.0)):
    """Render actors from a position, without a visible window, and write a PNG file."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for one in actors:
        renderer.AddActor(one)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(1.1)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(800, 460)
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def main(folder):
    """Run the snippets of the page in a folder, which receives the pictures."""
    page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tutorial.md")
    with open(page, encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```$", file.read(), re.M | re.S)
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    names = {}
    for block in blocks:
        exec(compile(block, "Tutorial.md", "exec"), names)  # noqa: S102


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
