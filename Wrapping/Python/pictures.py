# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of distances and errors: actors of surfaces, clouds, isolines and sources, a scalar bar,
and a camera that shows them."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Sequence

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkContourFilter,
    vtkPolyDataNormals,
    vtkStripper,
    vtkTubeFilter,
)
from vtkmodules.vtkFiltersPoints import vtkPCANormalEstimation
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

from . import writing
from .vtk_data import (
    area_vectors,
    cells_of,
    configured,
    coordinates_of,
    locator_of,
    triangles_of,
    with_arrays,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .vtkDGGFiltersPointCloud import vtkPointCloudDGG

__all__ = [
    "DISTANCE_COLORS",
    "ERROR_COLORS",
    "INK",
    "actor_of",
    "disc_radii",
    "discs",
    "lookup_table",
    "marker",
    "spacings_of",
    "tubes",
    "write_png",
]

SIZE = (1600, 1200)
#: RGB from 0 to 1, from near to far. Dark lines are visible on all of them.
DISTANCE_COLORS = (
    (0.993, 0.906, 0.144),
    (0.565, 0.843, 0.263),
    (0.208, 0.718, 0.473),
    (0.128, 0.567, 0.600),
    (0.250, 0.450, 0.700),
    (0.370, 0.330, 0.680),
    (0.480, 0.220, 0.600),
)
#: RGB from 0 to 1, from negligible errors to the promised error.
ERROR_COLORS = (
    (0.955, 0.955, 0.935),
    (0.985, 0.870, 0.600),
    (0.960, 0.620, 0.360),
    (0.840, 0.300, 0.310),
    (0.580, 0.100, 0.400),
    (0.270, 0.030, 0.330),
)
# Colors of points that no source reaches; they differ from those of distances and of errors.
UNREACHED_DISTANCE = (0.72, 0.72, 0.72)
UNREACHED_ERROR = (0.42, 0.62, 0.80)
#: Color of lines and text.
INK = (0.12, 0.12, 0.14)

# Radius of discs, as a fraction of the local spacing. Neighboring discs overlap, without gaps.
DISC_RADIUS = 0.85
# Largest ratio between the spacing of a disc and the median, in either direction.
LARGEST_RATIO = 2.5


# Properties of vtkProperty for surfaces without and with highlights.
MATTE = {"Ambient": 0.10, "Diffuse": 0.74, "Specular": 0.0, "SpecularPower": 25.0}
GLOSSY = {**MATTE, "Diffuse": 0.90, "Specular": 0.12}


def nice_step(span, wanted=20):
    """Returns 1, 2, 2.5 or 5 times a power of ten, which divides a span into about `wanted`
    intervals."""
    if not span > 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(span / wanted))
    steps = [factor * power for factor in (1.0, 2.0, 2.5, 5.0, 10.0)]
    return min(steps, key=lambda step: abs(math.log(span / step / wanted)))


def save_array(path, mesh, array_name, source=None, view=None, is_distance=False):
    """Writes a PNG of the mesh colored by a point array, with a marker at the source, if any.
    Distances begin at 0 and have isolines, whose distance from each other is returned."""
    values = vtk_to_numpy(mesh.GetPointData().GetArray(array_name))
    finite = np.append(values[np.isfinite(values)], [0.0] if is_distance else [])
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    low = 0.0 if is_distance else low
    high = high if high > low else low + 1.0
    step = nice_step(high)
    table = lookup_table(DISTANCE_COLORS, low, high, UNREACHED_DISTANCE)
    # A long name continues on the next line.
    title = re.sub(r"(?<=[a-z])(?=[A-Z])", "\n", array_name) if len(array_name) > 17 else array_name
    if is_distance:
        title = "Geodesic distance" if array_name == "GeodesicDistance" else array_name
        title += "\n(model units)"
    bar = scalar_bar(table, title, labels(low, high), "%-.6g")
    props = [surface(mesh, array_name, table), bar, *unreached(bar, values)]
    if is_distance:
        props.insert(1, _isolines(mesh, array_name, step, 0.0011))
    save(path, mesh, source, props, view)
    return step


def save_errors(path, mesh, array_name, promised, isolines, source, lines):
    """Writes a PNG of the mesh colored by the absolute value of its relative errors.

    The colors span three powers of ten up to the promised error. `isolines` is the name of the
    array of distances and the distance between isolines; `lines` is the text below the scalar bar.
    """
    name = "Size of " + array_name
    sizes = 100.0 * np.abs(vtk_to_numpy(mesh.GetPointData().GetArray(array_name)))
    sized = with_arrays(mesh, {name: sizes})
    powers = [100.0 * promised * 10.0**power for power in range(-3, 1)]
    table = lookup_table(ERROR_COLORS, powers[0], powers[-1], UNREACHED_ERROR)
    table.SetScaleToLog10()
    bar = scalar_bar(table, "Relative error\n(%)", powers, "%-.4g")
    props = [
        surface(sized, name, table, MATTE),
        _isolines(mesh, *isolines, 0.0006),
        bar,
        *unreached(bar, sizes),
        *note(lines),
    ]
    save(path, mesh, source, props)


def save(path, mesh, source, props, direction=None):
    """Writes a PNG of the props and of a marker at the source, if any, seen from `direction` or
    from the best direction."""
    renderer = stage(props)
    if source is not None:
        renderer.AddActor(marker(source, size_of(mesh)))
    aim(renderer, mesh, source, direction)
    write(path, [renderer])


def stage(props):
    """Returns a lit renderer of the props in front of a gradient."""
    renderer = configured(vtkRenderer(), Background=[1.0, 1.0, 1.0], Background2=[0.86, 0.89, 0.93])
    renderer.GradientBackgroundOn()
    for prop in props:
        renderer.AddViewProp(prop)
    light(renderer)
    return renderer


def write(path, renderers, size=SIZE):
    """Draws the renderers in one window and writes a PNG of it."""
    window = configured(vtkRenderWindow(), OffScreenRendering=True, MultiSamples=8, Size=[*size])
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    write_png(path, window)


def write_png(path: str, window: vtkRenderWindow) -> None:
    """Writes a PNG of a rendered window."""
    grabber = configured(vtkWindowToImageFilter(), Input=window, ReadFrontBuffer=False)
    writing.write_by(vtkPNGWriter(), path, vtkdgg.check(grabber))


def lookup_table(
    colors: Sequence[ArrayLike], low: float, high: float, unreached: ArrayLike
) -> vtkLookupTable:
    """Returns a lookup table that interpolates colors, in equal intervals, from `low` to `high`.
    NaN has the color `unreached`."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    positions = np.linspace(0.0, 1.0, len(colors))
    channels = np.array(colors).T
    for i in range(256):
        table.SetTableValue(i, *(float(np.interp(i / 255.0, positions, c)) for c in channels), 1.0)
    table.SetRange(low, high)
    table.SetNanColor(*unreached, 1.0)
    return table


def shaded(mesh):
    """Returns the mesh with normals for shading, split at sharp edges."""
    normals = configured(vtkPolyDataNormals(), InputData=mesh, FeatureAngle=50.0, Consistency=False)
    normals.Update()
    return normals.GetOutput()


def actor_of(data: vtkPolyData, color: ArrayLike | None = None) -> vtkActor:
    """Returns an actor of the data in one color; without a color, the mapper takes scalars."""
    mapper = configured(vtkPolyDataMapper(), InputData=data)
    actor = configured(vtkActor(), Mapper=mapper)
    if color is not None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*color)
    return actor


def tubes(
    lines: vtkPolyData,
    radius: float,
    color: ArrayLike | None = INK,
    sides: int = 8,
    is_capped: bool = False,
) -> vtkActor:
    """Returns an actor of tubes around polylines, whose radius is in model units."""
    tube = configured(vtkTubeFilter(), InputData=lines, Radius=radius)
    configured(tube, NumberOfSides=sides, Capping=is_capped).Update()
    return actor_of(tube.GetOutput(), color)


def surface(mesh, array_name, table, look=GLOSSY):
    """Returns an actor of the mesh colored by a point array."""
    actor = actor_of(shaded(mesh))
    _color_by(actor.GetMapper(), array_name, table)
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    configured(actor.GetProperty(), **look).SetInterpolationToPhong()
    return actor


def _color_by(mapper, array_name, table):
    """Sets the point array that a mapper colors by, and the colors."""
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array_name)
    configured(mapper, LookupTable=table, ScalarRange=[*table.GetRange()])


def _isolines(mesh, array_name, step, radius):
    """Returns an actor of isolines at multiples of `step`, as tubes. `radius` is a fraction of the
    diagonal of the mesh."""
    reached = _reached_part(mesh, array_name)
    high = np.nanmax(np.append(vtk_to_numpy(mesh.GetPointData().GetArray(array_name)), 0.0))
    contour = configured(vtkContourFilter(), InputData=reached)
    contour.SetInputArrayToProcess(0, 0, 0, 0, array_name)
    for i in range(1, int(high / step) + 1):
        contour.SetValue(i - 1, i * step)
    stripper = configured(vtkStripper(), InputConnection=contour.GetOutputPort())
    stripper.Update()
    return tubes(stripper.GetOutput(), radius * mesh.GetLength())


def _reached_part(mesh, array_name):
    """Returns the triangles of which all corners have a finite distance."""
    distances = vtk_to_numpy(mesh.GetPointData().GetArray(array_name))
    triangles = triangles_of(mesh)
    triangles = triangles[np.isfinite(distances[triangles]).all(axis=1)]
    part = vtkPolyData()
    part.SetPoints(mesh.GetPoints())
    part.SetPolys(cells_of(3 * np.arange(len(triangles) + 1), triangles.ravel()))
    part.GetPointData().AddArray(mesh.GetPointData().GetArray(array_name))
    return part


def marker(source: ArrayLike, size: float, color: ArrayLike = (0.86, 0.12, 0.16)) -> vtkActor:
    """Returns an actor of a ball at a point. Its radius is a fraction of `size`, the diagonal of the
    scene."""
    ball = configured(vtkSphereSource(), Center=[*source], Radius=0.011 * size)
    configured(ball, ThetaResolution=48, PhiResolution=48).Update()
    actor = actor_of(ball.GetOutput(), color)
    configured(actor.GetProperty(), Specular=0.5, SpecularPower=40.0)
    return actor


def spacings_of(graph: vtkPointCloudDGG) -> NDArray[np.float64]:
    """Returns the spacing of the cloud around each point, which a vtkPointCloudDGG has computed."""
    radii = vtk_to_numpy(graph.GetOutput().GetFieldData().GetArray("DGG.Radii"))
    return scaled_spacings(radii, graph.GetSpacing())


def scaled_spacings(radii, spacing):
    """Returns the radii of a graph of a cloud as multiples of their median times the spacing."""
    median = float(np.median(radii[radii > 0.0])) if (radii > 0.0).any() else 1.0
    return radii * (spacing / median)


def disc_radii(spacings: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns radii with which neighboring discs overlap."""
    spacing = float(np.median(spacings))
    return DISC_RADIUS * np.clip(spacings, spacing / LARGEST_RATIO, spacing * LARGEST_RATIO)


def discs(
    cloud: vtkPolyData, radii: ArrayLike, values: ArrayLike, table: vtkLookupTable
) -> vtkActor:
    """Returns an actor of a cloud: a disc at each point, in the tangent plane, colored by its
    value."""
    # The sign of the normals has no effect, since discs are lit on both sides.
    estimate = configured(vtkPCANormalEstimation(), InputData=cloud)
    estimate.SetSampleSize(min(16, cloud.GetNumberOfPoints()))
    estimate.SetNormalOrientationToPoint()
    estimate.Update()
    oriented = with_arrays(estimate.GetOutput(), {"Value": values, "Radius": radii})

    disc = configured(vtkRegularPolygonSource(), NumberOfSides=10, Radius=1.0)
    disc.SetNormal(1.0, 0.0, 0.0)  # glyphs rotate the x axis to the normal
    disc.GeneratePolylineOff()
    mapper = configured(
        vtkGlyph3DMapper(),
        InputData=oriented,
        SourceConnection=disc.GetOutputPort(),
        OrientationArray=oriented.GetPointData().GetNormals().GetName(),
        ScaleArray="Radius",
    )
    mapper.SetOrientationModeToDirection()
    mapper.SetScaleModeToScaleByMagnitude()
    _color_by(mapper, "Value", table)
    actor = configured(vtkActor(), Mapper=mapper)
    look = configured(actor.GetProperty(), Ambient=0.18, Diffuse=0.85, Specular=0.1)
    look.SetSpecularPower(25.0)
    look.SetInterpolationToFlat()
    return actor


def labels(low, high):
    """Returns round numbers between `low` and `high` for a scalar bar."""
    step = nice_step(high - low, wanted=6)
    slack = 1e-9 * (high - low) / step
    first, last = math.ceil(low / step - slack), math.floor(high / step + slack)
    return [i * step for i in range(first, last + 1)]


def scalar_bar(table, title, values, form, bottom=0.18):
    """Returns a scalar bar on the right. `bottom` is the height of its lower end as a fraction of
    the height of the viewport."""
    bar = configured(
        vtkScalarBarActor(),
        LookupTable=table,
        Title=title,
        CustomLabels=numpy_to_vtk(np.array(values, dtype=float), deep=True),
        UseCustomLabels=True,
        LabelFormat=form,
        UnconstrainedFontSize=True,
        TextPad=6,
        VerticalTitleSeparation=24,
        BarRatio=0.22,
        Width=0.14,
        Height=0.84 - bottom,
    )
    bar.GetPositionCoordinate().SetValue(0.84, bottom)
    _style(bar.GetTitleTextProperty(), 28)
    _style(bar.GetLabelTextProperty(), 26)
    return bar


def unreached(bar, values):
    """Adds the color of NaN to a scalar bar if any value is NaN, and yields the text beside it."""
    if np.isnan(values).any():
        bar.DrawNanAnnotationOn()
        bar.SetNanAnnotation("")  # VTK draws it on the left, over the mesh
        bottom = bar.GetPositionCoordinate().GetValue()[1]
        yield text("unreached", 0.879, bottom + 0.005)


def note(lines, top=0.12):
    """Yields actors of lines of text below the scalar bar, downwards from the height `top`."""
    for i, line in enumerate(lines):
        yield text(line, 0.815, top - 0.032 * i)


def text(line, x, y, size=24):
    """Returns an actor of a line of text that starts at (x, y) in normalized viewport
    coordinates."""
    actor = vtkTextActor()
    actor.SetInput(line)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    _style(actor.GetTextProperty(), size)
    return actor


def _style(text, size):
    configured(text, Color=[*INK], FontSize=size, Italic=False, Shadow=False, Bold=False)
    text.SetFontFamilyToArial()


def light(renderer):
    """Adds a light kit to a renderer, with a key light from above."""
    kit = configured(
        vtkLightKit(),
        KeyLightIntensity=0.95,
        KeyLightWarmth=0.55,
        KeyLightAngle=[40.0, 20.0],
        KeyToFillRatio=2.0,
        KeyToHeadRatio=2.2,
    )
    kit.AddLightsToRenderer(renderer)


def aim(renderer, mesh, source, direction=None, aspect=SIZE[0] / SIZE[1], room=0.18):
    """Points the camera at the mesh from `direction`, or from the best direction. `room` is the
    fraction of the width that stays free on the right."""
    center = np.array(mesh.GetCenter())
    up = up_of(mesh)
    if direction is None:
        direction = best_direction(mesh, source, up)
    away = 2.0 * size_of(mesh)
    if abs(up @ direction) > 0.999:  # view from the top or the bottom: the front is below or above
        up = -(up @ direction) * front_of(up)
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    top = np.cross(direction, right)

    # Positions of the points and of the marker in the view, as tangents of angles.
    points = coordinates_of(mesh)
    if source is not None:
        points = np.vstack([points, np.array(source) + 0.02 * size_of(mesh) * direction])
    points -= center
    depth = away - points @ direction
    x, y = points @ right / depth, points @ top / depth
    # The minimum shows the marker where all points have the same position.
    tangent = 0.5 * max(np.ptp(y) / 0.92, np.ptp(x) / ((0.95 - room) * aspect), 0.05)

    middle = 0.5 * (x.min() + x.max()), 0.5 * (y.min() + y.max())
    configured(
        renderer.GetActiveCamera(),
        FocalPoint=[*center],
        Position=[*(center + direction * away)],
        ViewUp=[*up],
        ViewAngle=2.0 * math.degrees(math.atan(tangent)),
        WindowCenter=[middle[0] / (tangent * aspect) + room, middle[1] / tangent],
    )
    renderer.ResetCameraClippingRange()


def size_of(mesh):
    """Returns the diagonal of the bounding box; 1 if all points have the same position."""
    return mesh.GetLength() or 1.0


def up_of(mesh):
    """Returns the direction that points up: the y axis, and the z axis for flat surfaces such as
    terrain."""
    bounds = np.array(mesh.GetBounds()).reshape(3, 2)
    x, y, z = bounds[:, 1] - bounds[:, 0]
    return np.array((0.0, 0.0, 1.0) if z < 0.4 * min(x, y) else (0.0, 1.0, 0.0))


def front_of(up):
    """Returns the viewing direction in which the x axis points to the right."""
    return np.cross((1.0, 0.0, 0.0), up)


def view_of(mesh, text):
    """Returns the viewing direction of a name such as "front" or of coordinates "X,Y,Z"."""
    up = up_of(mesh)
    front, right = front_of(up), np.array((1.0, 0.0, 0.0))
    names = {"front": front, "right": right, "top": up}
    names.update({"back": -front, "left": -right, "bottom": -up})
    if text in names:
        return names[text]
    try:
        direction = np.array([float(word) for word in text.split(",")])
        if len(direction) != 3 or not 0.0 < np.linalg.norm(direction) < np.inf:
            raise ValueError
    except ValueError:
        known = ", ".join(names)
        raise ValueError(f"--view: expected {known} or X,Y,Z, got {text}") from None
    return direction / np.linalg.norm(direction)


def best_direction(mesh, source, up):
    """Returns the viewing direction with the largest projected area; directions in which the source
    is hidden count less."""
    areas = area_vectors(mesh)
    locator = locator_of(mesh)
    size = mesh.GetLength()

    def score(direction):
        seen = source is None or _is_seen(locator, np.array(source), direction, size)
        return np.abs(areas @ direction).sum() * (1.0 if seen else 0.3)

    return max(directions(up), key=score)


def directions(up):
    """Yields viewing directions all around, at three elevations."""
    side = np.cross(up, (1.0, 0.0, 0.0) if abs(up[0]) < 0.5 else (0.0, 1.0, 0.0))
    front = np.cross(side, up)
    for elevation in (12.0, 25.0, 40.0):
        for azimuth in range(0, 360, 15):
            e, t = math.radians(elevation), math.radians(azimuth)
            yield math.sin(e) * up + math.cos(e) * (math.cos(t) * side + math.sin(t) * front)


def _is_seen(locator, source, direction, size):
    """Returns true if nothing is between the source, slightly lifted, and the camera."""
    start = source + 0.012 * size * direction
    hit = [0.0, 0.0, 0.0]
    t, sub = reference(0.0), reference(0)
    return not locator.IntersectWithLine(
        start, source + 2.0 * size * direction, 0.0, t, hit, [0.0, 0.0, 0.0], sub
    )
