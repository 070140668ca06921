# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the demo: a surface coloured by distance, with isolines, source and scalar bar."""

import math

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkDoubleArray, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import (
    vtkContourFilter,
    vtkPolyDataNormals,
    vtkStripper,
    vtkTubeFilter,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

SIZE = (1600, 1200)
# From near to far; light enough at the far end for dark lines to be seen.
COLOURS = (
    (0.993, 0.906, 0.144),
    (0.565, 0.843, 0.263),
    (0.208, 0.718, 0.473),
    (0.128, 0.567, 0.600),
    (0.250, 0.450, 0.700),
    (0.370, 0.330, 0.680),
    (0.480, 0.220, 0.600),
)
GREY = (0.72, 0.72, 0.72)
INK = (0.12, 0.12, 0.14)


def nice_step(span, wanted=20):
    """The step 1, 2, 2.5 or 5 times a power of ten that gives about `wanted` intervals."""
    if not span > 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(span / wanted))
    steps = [factor * power for factor in (1.0, 2.0, 2.5, 5.0, 10.0)]
    return min(steps, key=lambda step: abs(math.log(span / step / wanted)))


def save(path, mesh, array_name, source, unit="model units"):
    """Render the mesh with its distances and write the PNG; returns the step of the isolines."""
    distances = vtk_to_numpy(mesh.GetPointData().GetArray(array_name))
    finite = distances[np.isfinite(distances)]
    high = float(finite.max()) if finite.size and finite.max() > 0 else 1.0
    step = nice_step(high)
    table = _lookup_table(high)
    size = mesh.GetLength()

    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetBackground2(0.86, 0.89, 0.93)
    renderer.GradientBackgroundOn()
    renderer.AddActor(_surface(mesh, array_name, table, high))
    renderer.AddActor(_isolines(mesh, array_name, step, high, size))
    renderer.AddActor(_marker(source, size))
    renderer.AddViewProp(_scalar_bar(table, high, unit))
    _light(renderer)
    _aim(renderer, mesh, source)

    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grabber.GetOutputPort())
    vtkdgg.check(writer)
    return step


def _lookup_table(high):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    place = np.linspace(0.0, 1.0, len(COLOURS))
    channels = np.array(COLOURS).T
    for i in range(256):
        table.SetTableValue(i, *(float(np.interp(i / 255.0, place, c)) for c in channels), 1.0)
    table.SetRange(0.0, high)
    table.SetNanColor(*GREY, 1.0)
    return table


def _surface(mesh, array_name, table, high):
    # Normals are for shading only; sharp edges stay sharp.
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SetFeatureAngle(50.0)
    normals.ConsistencyOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array_name)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(0.0, high)
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    shine = actor.GetProperty()
    shine.SetInterpolationToPhong()
    shine.SetAmbient(0.10)
    shine.SetDiffuse(0.90)
    shine.SetSpecular(0.12)
    shine.SetSpecularPower(25.0)
    return actor


def _isolines(mesh, array_name, step, high, size):
    reached = _reached_part(mesh, array_name)
    contour = vtkContourFilter()
    contour.SetInputData(reached)
    contour.SetInputArrayToProcess(0, 0, 0, 0, array_name)
    for i in range(1, int(high / step) + 1):
        contour.SetValue(i - 1, i * step)
    stripper = vtkStripper()
    stripper.SetInputConnection(contour.GetOutputPort())
    tube = vtkTubeFilter()
    tube.SetInputConnection(stripper.GetOutputPort())
    tube.SetRadius(0.0011 * size)
    tube.SetNumberOfSides(8)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*INK)
    return actor


def _reached_part(mesh, array_name):
    """The triangles all of whose corners have a distance."""
    distances = vtk_to_numpy(mesh.GetPointData().GetArray(array_name))
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    triangles = triangles[np.isfinite(distances[triangles]).all(axis=1)].astype(np.int64)
    cells = vtkCellArray()
    offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True),
    )
    part = vtkPolyData()
    part.SetPoints(mesh.GetPoints())
    part.SetPolys(cells)
    part.GetPointData().AddArray(mesh.GetPointData().GetArray(array_name))
    return part


def _marker(source, size):
    ball = vtkSphereSource()
    ball.SetCenter(*source)
    ball.SetRadius(0.011 * size)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(ball.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.86, 0.12, 0.16)
    actor.GetProperty().SetSpecular(0.5)
    actor.GetProperty().SetSpecularPower(40.0)
    return actor


def _scalar_bar(table, high, unit):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(f"Geodesic distance\n({unit})")
    labels = vtkDoubleArray()
    label_step = nice_step(high, wanted=6)
    for i in range(int(high / label_step * (1 + 1e-9)) + 1):
        labels.InsertNextValue(i * label_step)
    bar.SetCustomLabels(labels)
    bar.UseCustomLabelsOn()
    bar.SetLabelFormat("%-.6g")
    bar.UnconstrainedFontSizeOn()
    bar.SetTextPad(6)
    bar.SetVerticalTitleSeparation(24)
    bar.SetBarRatio(0.22)
    bar.GetPositionCoordinate().SetValue(0.84, 0.18)
    bar.SetWidth(0.14)
    bar.SetHeight(0.66)
    for text, size in ((bar.GetTitleTextProperty(), 28), (bar.GetLabelTextProperty(), 26)):
        text.SetColor(*INK)
        text.SetFontSize(size)
        text.ItalicOff()
        text.ShadowOff()
        text.BoldOff()
        text.SetFontFamilyToArial()
    return bar


def _light(renderer):
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.95)
    kit.SetKeyLightWarmth(0.55)
    kit.SetKeyLightAngle(40.0, 20.0)
    kit.SetKeyToFillRatio(2.0)
    kit.SetKeyToHeadRatio(2.2)
    kit.AddLightsToRenderer(renderer)


def _aim(renderer, mesh, source):
    """Look from where much of the surface is seen, and the source with it."""
    centre = np.array(mesh.GetCenter())
    up = _up(mesh)
    direction = _best_direction(mesh, np.array(source), up)
    away = 2.0 * mesh.GetLength()
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    top = np.cross(direction, right)

    # Where the points are in the view, as tangents of angles; the source's ball comes along.
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    points = np.vstack([points, np.array(source) + 0.02 * mesh.GetLength() * direction]) - centre
    depth = away - points @ direction
    x, y = points @ right / depth, points @ top / depth
    # The picture leaves a margin, and room for the scalar bar on the right.
    aspect = SIZE[0] / SIZE[1]
    tangent = 0.5 * max(np.ptp(y) / 0.92, np.ptp(x) / (0.77 * aspect))

    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + direction * away))
    camera.SetViewUp(*up)
    camera.SetViewAngle(2.0 * math.degrees(math.atan(tangent)))
    camera.SetWindowCenter(
        0.5 * (x.min() + x.max()) / (tangent * aspect) + 0.18, 0.5 * (y.min() + y.max()) / tangent
    )
    renderer.ResetCameraClippingRange()


def _up(mesh):
    """The y axis, as most models have it; the z axis for flat ones, such as terrain."""
    bounds = np.array(mesh.GetBounds()).reshape(3, 2)
    x, y, z = bounds[:, 1] - bounds[:, 0]
    return np.array((0.0, 0.0, 1.0) if z < 0.4 * min(x, y) else (0.0, 1.0, 0.0))


def _best_direction(mesh, source, up):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = 0.5 * np.cross(b - a, c - a)

    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    side = np.cross(up, (1.0, 0.0, 0.0) if abs(up[0]) < 0.5 else (0.0, 1.0, 0.0))
    front = np.cross(side, up)
    size = mesh.GetLength()
    best, best_score = None, -1.0
    for elevation in (12.0, 25.0, 40.0):
        for azimuth in range(0, 360, 15):
            e, t = math.radians(elevation), math.radians(azimuth)
            direction = math.sin(e) * up + math.cos(e) * (math.cos(t) * side + math.sin(t) * front)
            score = np.abs(areas @ direction).sum() * (
                1.0 if _is_seen(locator, source, direction, size) else 0.3
            )
            if score > best_score:
                best, best_score = direction, score
    return best


def _is_seen(locator, source, direction, size):
    """Whether nothing is between the source, lifted a little, and the viewer."""
    start = source + 0.012 * size * direction
    hit = [0.0, 0.0, 0.0]
    t, sub = reference(0.0), reference(0)
    return not locator.IntersectWithLine(
        start, source + 2.0 * size * direction, 0.0, t, hit, [0.0, 0.0, 0.0], sub
    )
