# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed geodesics on a surface, drawn in a picture: loops around its handles, and a rope through
points that is pulled tight, with a tape along it.

Without a mesh, the surface is made of two rings, with a rope around the waist between them.
"""

import argparse
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import triple
from vtkdgg.pictures import actor_of, tubes, write_png
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFlyingEdges3D
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

# Around the waist between the two rings.
WAIST = ((0.9, 0.33, 0.0), (1.1, 0.0, 0.12), (0.9, -0.33, 0.0), (1.1, 0.0, -0.12))
SURFACE = (0.80, 0.80, 0.76)
HANDLES = (0.05, 0.30, 0.62)
ROPE = (0.80, 0.05, 0.12)
RIMS = (0.95, 0.62, 0.10)


def make_two_rings():
    """Returns a surface with two handles: two rings side by side with a waist between them."""
    shape = (150, 90, 40)
    low = np.array([-0.25, -0.7, -0.25])
    high = np.array([2.25, 0.7, 0.25])
    x, y, z = np.meshgrid(*(np.linspace(*span) for span in zip(low, high, shape)), indexing="ij")
    value = (x * (x - 1.0) ** 2 * (x - 2.0) + y**2) ** 2 + z**2
    grid = vtkImageData()
    grid.SetDimensions(shape)
    grid.SetOrigin(low)
    grid.SetSpacing((high - low) / (np.array(shape) - 1.0))
    grid.GetPointData().SetScalars(numpy_to_vtk(value.ravel(order="F"), deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(grid)
    contour.SetValue(0, 0.015)
    contour.ComputeScalarsOff()
    clean = vtkCleanPolyData()
    clean.SetInputConnection(contour.GetOutputPort())
    return clean


def find_handles(port):
    """Returns loops around the handles of the surface."""
    handles = vtkdgg.vtkDGGLoop()
    handles.SetInputConnection(port)
    handles.SetModeToAroundHandles()
    return handles


def find_rope(port, through, width):
    """Returns a rope through points near the surface, pulled tight, with a tape along it."""
    points = vtkPoints()
    for place in through:
        points.InsertNextPoint(place)
    data = vtkPolyData()
    data.SetPoints(points)
    rope = vtkdgg.vtkDGGLoop()
    rope.SetInputConnection(port)
    rope.SetModeToRope()
    rope.SetPointData(data)
    rope.SetProjectionTolerance(0.1)
    rope.TautOn()
    rope.SetTapeWidth(width)
    return rope


def describe(name, loop):
    """Print the lengths of loops."""
    lengths = vtk_to_numpy(vtkdgg.check(loop).GetCellData().GetArray("Length"))
    print(f"{len(lengths)} {name}: lengths {' '.join(f'{length:g}' for length in lengths)}")


def lap(curves):
    """Returns closed lines with their second point repeated, so that tubes have no gap."""
    lines = vtkCellArray()
    ids = vtkIdList()
    for i in range(curves.GetNumberOfLines()):
        curves.GetLines().GetCellAtId(i, ids)
        if ids.GetId(0) == ids.GetId(ids.GetNumberOfIds() - 1):
            ids.InsertNextId(ids.GetId(1))
        lines.InsertNextCell(ids)
    lapped = vtkPolyData()
    lapped.SetPoints(curves.GetPoints())
    lapped.SetLines(lines)
    return lapped


def make_tubes(port, radius, colour):
    """Returns an actor of tubes around polylines."""
    # Coincident points, as next to a corner of the mesh, define no direction of the tube.
    clean = vtkCleanPolyData()
    clean.SetInputConnection(port)
    clean.ConvertLinesToPointsOff()
    clean.SetToleranceIsAbsolute(True)
    clean.SetAbsoluteTolerance(0.1 * radius)
    return tubes(lap(vtkdgg.check(clean)), radius, colour, sides=16)


def render(actors, view, up, picture_path):
    """Render off-screen, and save the picture."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(view)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(up)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    camera.Zoom(1.3)
    window.Render()
    write_png(picture_path, window)


def main(options):
    """Run the pipeline."""
    if options.mesh:
        surface = vtkdgg.read(options.mesh).as_polydata()
    else:
        surface = vtkdgg.check(make_two_rings())
    source = vtkTrivialProducer()
    source.SetOutput(surface)
    through = options.rope or (() if options.mesh else WAIST)
    size = surface.GetLength()
    port = source.GetOutputPort()
    actors = [actor_of(surface, SURFACE)]

    handles = find_handles(port)
    if options.handles:
        describe("loops around handles", handles)
        actors.append(make_tubes(handles.GetOutputPort(), 0.005 * size, HANDLES))
    if through:
        rope = find_rope(port, through, options.width * size)
        describe("ropes", rope)
        actors.append(make_tubes(rope.GetOutputPort(), 0.005 * size, ROPE))
        actors.append(make_tubes(rope.GetTapePort(), 0.0025 * size, RIMS))
    render(actors, options.view, options.up, options.picture)


def places(text):
    """Returns the positions in a text, separated by spaces."""
    return [triple(place) for place in text.split()]


def parse(arguments):
    """Options from the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", help="the picture to write, a .png")
    parser.add_argument("--mesh", help="a surface (.ply .obj .stl .vtp .vtk .off)")
    parser.add_argument(
        "--rope",
        type=places,
        metavar='"X,Y,Z ..."',
        help="three or more places near the surface that a rope goes through",
    )
    parser.add_argument(
        "--width", type=float, default=0.04, help="of the tape, per size of the mesh (%(default)s)"
    )
    parser.add_argument(
        "--no-handles", dest="handles", action="store_false", help="leave out loops around handles"
    )
    parser.add_argument(
        "--view", type=triple, metavar="X,Y,Z", default=(0.3, -0.6, 1.0), help="where to look from"
    )
    parser.add_argument(
        "--up", type=triple, metavar="X,Y,Z", default=(0.0, 1.0, 0.0), help="what is up"
    )
    return parser.parse_args(arguments)


if __name__ == "__main__":
    options = parse(sys.argv[1:])
    try:
        main(options)
    except (OSError, ValueError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
