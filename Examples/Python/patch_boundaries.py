# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Divide two closed surfaces into the same eight patches, and show the curves on both.

The landmarks are the points farthest along the axes, the layout is an octahedron: a first step of
a map from one surface to the other. Curves of the same colour correspond.

Usage: patch_boundaries.py FIRST SECOND PICTURE.png
"""

import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkdgg.pictures import write_png
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

AXES = np.vstack([np.eye(3), -np.eye(3)])  # landmarks: +x +y +z -x -y -z
PATCHES = [
    (0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)
]  # fmt: skip


def find_landmarks(mesh):
    """Returns the extreme points of the mesh along the axes."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    return [int(i) for i in np.argmax((points - middle) @ AXES.T, axis=0)]


def make_layout():
    """Returns polygons on the indices of the landmarks, without points."""
    polygons = vtkCellArray()
    for patch in PATCHES:
        polygons.InsertNextCell(len(patch))
        for landmark in patch:
            polygons.InsertCellPoint(landmark)
    layout = vtkPolyData()
    layout.SetPolys(polygons)
    return layout


def make_actor(filter_, colour=None):
    """Returns an actor of an output in one color, or colored by the array "Number"."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(filter_.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    if colour:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*colour)
        return actor
    table = vtkLookupTable()
    table.SetNumberOfTableValues(12)
    table.SetHueRange(0.0, 0.92)
    table.SetSaturationRange(0.9, 0.9)
    table.SetValueRange(0.9, 0.9)
    table.Build()
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(-0.5, 11.5)
    return actor


def make_renderer(mesh, curves, landmarks, viewport):
    """Returns a renderer of a surface with its curves and landmarks."""
    size = mesh.GetLength()
    numbers = numpy_to_vtk(np.arange(curves.GetNumberOfCells(), dtype=float), deep=True)
    numbers.SetName("Number")
    curves.GetCellData().SetScalars(numbers)
    surface = vtkPolyDataNormals()
    surface.SetInputData(mesh)
    tubes = vtkTubeFilter()
    tubes.SetInputData(curves)
    tubes.SetRadius(0.005 * size)
    tubes.SetNumberOfSides(12)
    spots = vtkPolyData()
    spots.SetPoints(pick_points(mesh, landmarks))
    ball = vtkSphereSource()
    ball.SetRadius(0.014 * size)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(24)
    balls = vtkGlyph3D()
    balls.SetInputData(spots)
    balls.SetSourceConnection(ball.GetOutputPort())
    balls.ScalingOff()

    renderer = vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(make_actor(surface, (0.85, 0.85, 0.82)))
    renderer.AddActor(make_actor(tubes))
    renderer.AddActor(make_actor(balls, (0.1, 0.1, 0.1)))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.5, 0.45, 1.0)
    renderer.ResetCamera()
    camera.Zoom(1.32)
    return renderer


def pick_points(mesh, ids):
    """Returns points of a mesh."""
    points = mesh.GetPoints().NewInstance()
    for i in ids:
        points.InsertNextPoint(mesh.GetPoint(i))
    return points


def main(first_path, second_path, picture_path):
    """Compute the curves, render them and print their lengths."""
    meshes = []
    for path in (first_path, second_path):
        meshes.append(vtkdgg.read(path).as_polydata())
    landmarks = [find_landmarks(mesh) for mesh in meshes]

    boundaries = vtkdgg.vtkGeodesicPatchBoundaries()
    boundaries.SetInputData(meshes[0])
    boundaries.SetSecondSurfaceData(meshes[1])
    boundaries.SetFirstLandmarkIds(landmarks[0])
    boundaries.SetSecondLandmarkIds(landmarks[1])
    boundaries.SetLayoutData(make_layout())
    vtkdgg.check(boundaries)
    curves = [boundaries.GetOutput(side) for side in (0, 1)]

    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(1200, 600)
    for side in (0, 1):
        viewport = (0.5 * side, 0.0, 0.5 * (side + 1), 1.0)
        window.AddRenderer(make_renderer(meshes[side], curves[side], landmarks[side], viewport))
    window.Render()
    write_png(picture_path, window)

    print("landmarks   first surface  second surface")
    edges = vtk_to_numpy(curves[0].GetCellData().GetArray("LayoutEdge"))
    lengths = [vtk_to_numpy(curve.GetCellData().GetArray("Length")) for curve in curves]
    for edge, one, other in zip(edges, *lengths):
        print(f"{edge[0]} to {edge[1]} {one:18g} {other:15g}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except (OSError, ValueError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
