# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of Examples/README.md that no other example draws, one per filter.

Usage: gallery.py MESH FOLDER [NAME...]

MESH is a surface of some hundred to some ten thousand points. Without names, all pictures.
"""

import os
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkdgg.pictures import (
    DISTANCE_COLORS,
    ERROR_COLORS,
    INK,
    actor_of,
    lookup_table,
    marker,
    tubes,
    write_png,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkContourFilter,
    vtkGlyph3D,
    vtkMaskPoints,
    vtkPolyDataNormals,
    vtkQuadricDecimation,
)
from vtkmodules.vtkFiltersModeling import vtkBandedPolyDataContourFilter, vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkTextActor

PANEL = (480, 480)
PLAIN = (0.90, 0.88, 0.83)
RED = (0.86, 0.12, 0.16)
BANDS = 24


def array_of(mesh, name, component=0):
    """Returns a point array, or one of its components, as a NumPy array."""
    array = vtk_to_numpy(mesh.GetPointData().GetArray(name))
    return array[:, component] if array.ndim > 1 else array


def with_values(mesh, values):
    """Returns the surface with the values as the point array `Value`."""
    result = vtkPolyData()
    result.CopyStructure(mesh)
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName("Value")
    result.GetPointData().SetScalars(array)
    return result


def shaded(data, colour=None):
    """Returns a smoothly shaded actor of a polydata. Without a color, the mapper uses scalars."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    actor = actor_of(vtkdgg.check(normals), colour)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def coloured(mesh, values, low, high, colours=DISTANCE_COLORS, is_log=False):
    """Returns an actor of the surface colored by values."""
    actor = shaded(with_values(mesh, values))
    table = lookup_table(colours, low, high, PLAIN)
    if is_log:
        table.SetScaleToLog10()
    mapper = actor.GetMapper()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    return actor


def banded(mesh, values):
    """Returns an actor of the surface in bands of equal width, with lines between them."""
    return bands_between(mesh, values, float(np.nanmin(values)), float(np.nanmax(values)))


def bands_between(mesh, values, low, high):
    """As `banded`, for values from low to high."""
    surface = with_values(mesh, values)
    bands = vtkBandedPolyDataContourFilter()
    bands.SetInputData(surface)
    bands.GenerateValues(BANDS + 1, low, high)
    bands.SetScalarModeToValue()
    bands.ClippingOn()
    actor = shaded(vtkdgg.check(bands))
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUseCellData()
    mapper.SetLookupTable(lookup_table(DISTANCE_COLORS, low, high, PLAIN))
    mapper.UseLookupTableScalarRangeOn()
    contour = vtkContourFilter()
    contour.SetInputData(surface)
    contour.GenerateValues(BANDS + 1, low, high)
    return [actor, tubes(vtkdgg.check(contour), 0.0009 * mesh.GetLength(), INK)]


def draw(path, panels):
    """Write a PNG file of panels side by side, each with a title and actors."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(PANEL[0] * len(panels), PANEL[1])
    for i, (title, actors) in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.SetViewport(i / len(panels), 0.0, (i + 1) / len(panels), 1.0)
        for actor in actors:
            renderer.AddActor(actor)
        text = vtkTextActor()
        text.SetInput(title)
        text.SetPosition(14, PANEL[1] - 30)
        text.GetTextProperty().SetFontSize(17)
        text.GetTextProperty().SetColor(*INK)
        renderer.AddActor(text)
        window.AddRenderer(renderer)
        renderer.ResetCamera()
        bounds = renderer.ComputeVisiblePropBounds()
        is_flat = bounds[5] - bounds[4] < 0.1 * (bounds[1] - bounds[0])
        renderer.GetActiveCamera().Zoom(1.0 if is_flat else 1.35)
        renderer.ResetCameraClippingRange()
    window.Render()
    write_png(path, window)


def distances(kind, mesh, source, **properties):
    """Returns the distances of a filter from one point."""
    distance = kind()
    distance.SetInputData(mesh)
    distance.SetSourceIds([source])
    for name, value in properties.items():
        getattr(distance, f"Set{name}")(value)
    return vtkdgg.check(distance)


def graph_edges(mesh, source):
    """vtkDiscreteGeodesicGraph: the edges at one point for three accuracies."""
    panels = []
    mesh, source = coarse(mesh, 4000, source)
    place = mesh.GetPoint(source)
    for accuracy in (0.1, 0.01, 0.001):
        graph = vtkdgg.vtkDiscreteGeodesicGraph()
        graph.SetInputData(mesh)
        graph.SetAccuracy(accuracy)
        field = vtkdgg.check(graph).GetFieldData()
        offsets, targets = (
            vtk_to_numpy(field.GetArray(f"DGG.{x}")) for x in ("Offsets", "Targets")
        )
        path = vtkdgg.vtkDGGPath()
        path.SetInputConnection(graph.GetOutputPort())
        for target in targets[offsets[source] : offsets[source + 1]]:
            path.AddPair(source, int(target))
        lines = tubes(vtkdgg.check(path), 0.0013 * mesh.GetLength(), (0.1, 0.3, 0.6))
        title = f"accuracy {accuracy:g}: {offsets[source + 1] - offsets[source]} edges"
        ball = marker(place, 0.6 * mesh.GetLength(), RED)
        panels.append((title, [shaded(mesh, PLAIN), lines, ball]))
    return panels


def approximate(mesh, source):
    """Errors of the approximate distances and of a graph."""
    exact = array_of(distances(vtkdgg.vtkExactGeodesicDistance, mesh, source), "GeodesicDistance")
    panels = []
    for title, kind in (
        ("heat method", vtkdgg.vtkHeatGeodesicDistance),
        ("fast marching", vtkdgg.vtkDGGFastMarchingDistance),
        ("virtual sources", vtkdgg.vtkVirtualSourceGeodesicDistance),
        ("graph, accuracy 0.01", vtkdgg.vtkDGGDistance),
    ):
        found = array_of(distances(kind, mesh, source), "GeodesicDistance")
        error = 100.0 * np.abs(found - exact) / np.where(exact > 0.0, exact, 1.0)
        actor = coloured(mesh, np.maximum(error, 1e-3), 1e-3, 10.0, ERROR_COLORS, True)
        panels.append((f"{title}: mean error {np.nanmean(error):.2g} %", [actor]))
    return panels


def matrix(mesh, source):
    """vtkGeodesicDistanceMatrix: samples, and their layout in the plane by their distances."""
    sampler = vtkdgg.vtkGeodesicSampler()
    sampler.SetInputData(mesh)
    sampler.SetNumberOfSamples(400)
    samples = vtkdgg.check(sampler)
    distance = vtkdgg.vtkGeodesicDistanceMatrix()
    distance.SetInputData(mesh)
    ids = vtk_to_numpy(samples.GetPointData().GetArray("vtkOriginalPointIds"))
    distance.SetRowIds([int(i) for i in ids])
    vtkdgg.check(distance)
    squares = vtk_to_numpy(distance.GetMatrix()) ** 2
    centred = squares - squares.mean(axis=0) - squares.mean(axis=1)[:, None] + squares.mean()
    values, vectors = np.linalg.eigh(-0.5 * centred)
    layout = np.zeros((len(ids), 3))
    layout[:, :2] = vectors[:, :-3:-1] * np.sqrt(values[:-3:-1])
    to_source = array_of(distances(vtkdgg.vtkDGGDistance, mesh, source), "GeodesicDistance")[ids]

    def balls(places):
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        data = vtkPolyData()
        data.SetPoints(points)
        ball = vtkSphereSource()
        ball.SetRadius(0.011 * float(np.linalg.norm(np.ptp(places, axis=0))))
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(16)
        glyphs = vtkGlyph3D()
        glyphs.SetInputData(with_values(data, to_source))
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.ScalingOff()
        actor = actor_of(vtkdgg.check(glyphs))
        table = lookup_table(DISTANCE_COLORS, 0.0, float(to_source.max()), PLAIN)
        actor.GetMapper().SetLookupTable(table)
        actor.GetMapper().UseLookupTableScalarRangeOn()
        return actor

    places = vtk_to_numpy(samples.GetPoints().GetData())
    return [
        ("400 samples", [shaded(mesh, PLAIN), balls(places)]),
        ("their distances in the plane", [balls(layout)]),
    ]


def coarse(mesh, count, source):
    """Returns the surface with about `count` points, and the point closest to the source."""
    decimate = vtkQuadricDecimation()
    decimate.SetInputData(mesh)
    decimate.SetTargetReduction(max(0.0, 1.0 - count / mesh.GetNumberOfPoints()))
    result = vtkdgg.check(decimate)
    return result, result.FindPoint(mesh.GetPoint(source))


def probe(mesh, source):
    """vtkGeodesicProbe: distances on a coarse mesh, interpolated linearly and probed."""
    simple, start = coarse(mesh, 250, source)
    known = distances(vtkdgg.vtkExactGeodesicDistance, simple, start, GenerateWindows=True)
    finer = vtkLinearSubdivisionFilter()
    finer.SetNumberOfSubdivisions(3)
    finer.SetInputData(known)
    fine = vtkdgg.check(finer)
    probed = vtkdgg.vtkGeodesicProbe()
    probed.SetInputData(known)
    probed.SetProbeData(fine)
    return [
        ("linear in triangles", banded(fine, array_of(fine, "GeodesicDistance"))),
        ("probed", banded(fine, array_of(vtkdgg.check(probed), "GeodesicDistance"))),
    ]


def biharmonic(mesh, source):
    """vtkBiharmonicDistance: three kinds of distances."""
    panels = []
    for title, kind in (
        ("biharmonic", vtkdgg.vtkBiharmonicDistance.Biharmonic),
        ("commute time", vtkdgg.vtkBiharmonicDistance.CommuteTime),
        ("diffusion", vtkdgg.vtkBiharmonicDistance.Diffusion),
    ):
        distance = vtkdgg.vtkBiharmonicDistance()
        distance.SetInputData(mesh)
        distance.SetSourceIds([source])
        distance.SetKind(kind)
        distance.SetNumberOfEigenvalues(60)
        found = array_of(vtkdgg.check(distance), "BiharmonicDistance")
        ball = marker(mesh.GetPoint(source), mesh.GetLength())
        panels.append((title, [*banded(mesh, found), ball]))
    return panels


def earth_movers(mesh, source):
    """vtkSurfaceEarthMoversDistance: the potential, and the flow from two points to another."""
    x = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0]
    nose, far = int(np.argmin(x)), int(np.argmax(x))
    places = {}
    for name, ids in (("from", [source, nose]), ("to", [far])):
        places[name] = vtkPolyData()
        points = vtkPoints()
        for i in ids:
            points.InsertNextPoint(mesh.GetPoint(i))
        places[name].SetPoints(points)
    movers = vtkdgg.vtkSurfaceEarthMoversDistance()
    movers.SetInputData(mesh)
    movers.SetFromData(places["from"])
    movers.SetToData(places["to"])
    moved = vtkdgg.check(movers)
    flow = vtk_to_numpy(moved.GetCellData().GetArray("EarthMoversFlow"))
    size = np.linalg.norm(flow, axis=1)
    triangles = vtk_to_numpy(moved.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = vtk_to_numpy(moved.GetPoints().GetData())[triangles].mean(axis=1)
    strong = size > np.quantile(size, 0.9)
    arrows = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(centres[strong], deep=True))
    arrows.SetPoints(points)
    arrows.GetPointData().SetVectors(numpy_to_vtk(flow[strong] / size[strong][:, None], deep=True))
    few = vtkMaskPoints()
    few.SetInputData(arrows)
    few.SetOnRatio(max(1, int(strong.sum() / 500)))
    arrow = vtkArrowSource()
    glyphs = vtkGlyph3D()
    glyphs.SetInputConnection(few.GetOutputPort())
    glyphs.SetSourceConnection(arrow.GetOutputPort())
    glyphs.SetScaleFactor(0.045 * mesh.GetLength())
    glyphs.SetVectorModeToUseVector()
    glyphs.SetScaleModeToDataScalingOff()
    flowing = shaded(vtkdgg.check(glyphs), INK)
    balls = [marker(mesh.GetPoint(i), mesh.GetLength(), RED) for i in (source, nose)]
    balls.append(marker(mesh.GetPoint(far), mesh.GetLength(), (0.1, 0.3, 0.6)))
    potential = array_of(moved, "EarthMoversPotential")
    title = f"earth mover's distance {movers.GetDistance():.3g}"
    return [
        ("potential", [*banded(mesh, potential), *balls]),
        (title, [shaded(mesh, PLAIN), flowing, *balls]),
    ]


def b_spline(mesh, source):
    """vtkHarmonicBSpline: three basis functions."""
    spline = vtkdgg.vtkHarmonicBSpline()
    spline.SetInputData(mesh)
    spline.SetNumberOfSites(40)
    basis = vtk_to_numpy(vtkdgg.check(spline).GetPointData().GetArray("HarmonicBSpline"))
    first = int(np.argmax(basis[source]))
    order = np.argsort(-basis[:, first] @ basis)
    panels = []
    for site in [first, *[int(i) for i in order if i != first][:2]]:
        actor = coloured(mesh, basis[:, site], 0.0, 0.8, ERROR_COLORS)
        panels.append((f"function of site {site}", [actor]))
    return panels


def interpolation(mesh, source):
    """vtkHarmonicBSpline: interpolated values of a function at some points, and the function."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    x, y, z = (points - mesh.GetCenter()).T * 6.0 / mesh.GetLength()
    truth = np.sin(x + 0.6 * y) * np.cos(0.8 * y - z)
    low, high = float(truth.min()), float(truth.max())
    spline = vtkdgg.vtkHarmonicBSpline()
    spline.SetInputData(with_values(mesh, truth))
    spline.SetNumberOfSites(80)
    spline.SetSiteValuesArrayName("Value")
    spline.SetOrderToBiharmonic()
    spline.GenerateBasisOff()
    found = array_of(vtkdgg.check(spline), "Interpolation")
    off = np.sqrt(np.mean((found - truth) ** 2)) / (high - low)
    table = lookup_table(DISTANCE_COLORS, low, high, PLAIN)
    balls = []
    for i in range(spline.GetNumberOfUsedSites()):
        site, colour = spline.GetUsedSite(i), [0.0] * 3
        table.GetColor(truth[site], colour)
        balls.append(marker(mesh.GetPoint(site), 1.6 * mesh.GetLength(), colour))
    title = f"through them, off by {100.0 * off:.2g} % of the range"
    return [
        (f"{len(balls)} values", [shaded(mesh, PLAIN), *balls]),
        (title, bands_between(mesh, np.clip(found, low, high), low, high)),
        ("what they are values of", bands_between(mesh, truth, low, high)),
    ]


PICTURES = {
    "approximate": approximate,
    "b_spline": b_spline,
    "biharmonic": biharmonic,
    "earth_movers": earth_movers,
    "graph_edges": graph_edges,
    "interpolation": interpolation,
    "matrix": matrix,
    "probe": probe,
}


def main(mesh_path, folder, names):
    """Draw the pictures."""
    mesh = vtkdgg.read(mesh_path).as_polydata()
    z = vtk_to_numpy(mesh.GetPoints().GetData())[:, 2]
    source = int(np.argmax(z))  # closest to the viewer
    for name in names or PICTURES:
        if name not in PICTURES:
            raise ValueError(f"'{name}' is none of the pictures {', '.join(PICTURES)}")
        path = os.path.join(folder, f"{name}.png")
        draw(path, PICTURES[name](mesh, source))
        print("Written:", path)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], sys.argv[2], sys.argv[3:])
    except (OSError, ValueError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
