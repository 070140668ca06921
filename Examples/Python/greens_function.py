# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Green's function of a point inside a triangle of a coarse sphere, by the four methods of
vtkDiscreteGreensFunction, beside the closed form. A picture of bands around the point, and errors.
"""

import argparse
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkdgg.pictures import DISTANCE_COLORS
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkImageActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

METHODS = (
    ("vertex", vtkdgg.vtkDiscreteGreensFunction.Vertex),
    ("interpolated", vtkdgg.vtkDiscreteGreensFunction.Interpolated),
    ("localized", vtkdgg.vtkDiscreteGreensFunction.Localized),
    ("singularity subtraction", vtkdgg.vtkDiscreteGreensFunction.SingularitySubtraction),
)
BARYCENTRIC = (0.45, 0.35, 0.20)
WIDTH, CAPTION = 300, 64  # size of a panel and height of the text below it, pixels
REACH = 0.3  # extent of a panel around the source, on the unit sphere
BANDS = 14.0  # bands per unit of the function
LOW, HIGH = 0.12, 0.6  # range of the colors


def make_sphere(level):
    """Returns a subdivided icosahedron on the unit sphere."""
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    divide = vtkLinearSubdivisionFilter()
    divide.SetNumberOfSubdivisions(level)
    divide.SetInputConnection(solid.GetOutputPort())
    sphere = vtkdgg.check(divide)
    points = vtk_to_numpy(sphere.GetPoints().GetData()).astype(float)
    sphere.SetPoints(make_points(points / np.linalg.norm(points, axis=1)[:, None]))
    return sphere


def make_points(coordinates):
    """Returns a vtkPolyData of points."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(coordinates, deep=True))
    return points


def make_places(coordinates):
    """Returns a producer of points, for sources and evaluation points."""
    places = vtkPolyData()
    places.SetPoints(make_points(coordinates))
    return places


def find_source(sphere):
    """Returns a point inside the triangle that intersects the z axis."""
    points = vtk_to_numpy(sphere.GetPoints().GetData())
    corners = vtk_to_numpy(sphere.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    triangle = points[corners]
    top = triangle[triangle.mean(axis=1)[:, 2].argmax()]
    source = np.array(BARYCENTRIC) @ top
    return source / np.linalg.norm(source)


def find_pixels(source):
    """Returns points on the sphere for the pixels of a panel that faces the source."""
    right = np.cross([0.0, 1.0, 0.0], source)
    right /= np.linalg.norm(right)
    up = np.cross(source, right)
    steps = REACH * ((np.arange(WIDTH) + 0.5) / WIDTH * 2.0 - 1.0)
    x, y = (values.ravel() for values in np.meshgrid(steps, steps))
    depth = np.sqrt(1.0 - x**2 - y**2)
    return np.outer(x, right) + np.outer(y, up) + np.outer(depth, source)


def exact(cosine):
    """Returns the Green's function of the unit sphere with mean 0."""
    return -(np.log(1.0 - cosine) + 1.0 - np.log(2.0)) / (4.0 * np.pi)


def make_panel(values):
    """Returns an actor of an image of bands."""
    dark = (np.floor(BANDS * values).astype(int) % 2)[:, None]
    stops = np.linspace(HIGH, LOW, len(DISTANCE_COLORS))[::-1]
    table = np.array(DISTANCE_COLORS)[::-1]
    colours = np.stack([np.interp(values, stops, channel) for channel in table.T], axis=1)
    colours = colours * (1.0 - 0.15 * dark)
    image = vtkImageData()
    image.SetDimensions(WIDTH, WIDTH, 1)
    array = numpy_to_vtk((255.0 * colours).astype(np.uint8), deep=True)
    image.GetPointData().SetScalars(array)
    actor = vtkImageActor()
    actor.SetInputData(image)
    actor.InterpolateOff()
    return actor


def make_caption(text):
    """Returns an actor of centered lines of text below a panel."""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(WIDTH / 2, CAPTION / 2)
    properties = actor.GetTextProperty()
    properties.SetFontSize(17)
    properties.SetColor(0.0, 0.0, 0.0)
    properties.SetJustificationToCentered()
    properties.SetVerticalJustificationToCentered()
    return actor


def write_picture(panels, path):
    """Write all panels side by side, one pixel per evaluation point."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(len(panels) * WIDTH, WIDTH + CAPTION)
    for k, (caption, values) in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.SetViewport(k / len(panels), 0.0, (k + 1) / len(panels), 1.0)
        renderer.AddActor(make_panel(values))
        renderer.AddActor(make_caption(caption))
        middle, height = 0.5 * (WIDTH - 1), 0.5 * (WIDTH - CAPTION - 1)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5 * (WIDTH + CAPTION))
        camera.SetFocalPoint(middle, height, 0.0)
        camera.SetPosition(middle, height, 100.0)
        window.AddRenderer(renderer)
    window.Render()
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(path)
    vtkdgg.check(writer)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", help="PNG file to write")
    parser.add_argument(
        "--level", type=integer(1, 6), default=3, help="how often triangles are divided (default 3)"
    )
    arguments = parser.parse_args()
    sphere = make_sphere(arguments.level)
    source = find_source(sphere)
    pixels = find_pixels(source)
    truth = exact(pixels @ source)
    greens = vtkdgg.vtkDiscreteGreensFunction()
    greens.SetInputData(sphere)
    greens.SetSourceData(make_places(source[None, :]))
    greens.SetEvaluationData(make_places(pixels))
    greens.SetProjectionTolerance(0.1)
    panels = [("closed form", truth)]
    for name, method in METHODS:
        greens.SetMethod(method)
        vtkdgg.check(greens)
        array = greens.GetEvaluation().GetPointData().GetArray("GreensFunction")
        values = vtk_to_numpy(array).astype(float)
        error = np.sqrt(np.mean((values - truth) ** 2) / np.mean(truth**2))
        print(f"{name}: error {100.0 * error:.3g} %")
        panels.append((f"{name}\nerror {100.0 * error:.2g} %", values))
    if arguments.picture:
        write_picture(panels, arguments.picture)


if __name__ == "__main__":
    try:
        main()
    except vtkdgg.VTKError as error:
        sys.exit(str(error))
