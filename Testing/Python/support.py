# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fixtures: folders, small meshes and clouds, strict comparison of images, examples, commands."""

import contextlib
import importlib.util
import io
import os
import subprocess
import sys
import types

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

TESTING = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOT = os.path.dirname(TESTING)
DATA = os.path.join(TESTING, "Data")
BASELINE = os.path.join(TESTING, "Baseline")
EXAMPLES = os.path.join(ROOT, "Examples")
OUTPUT = os.environ["DGG_TEST_OUTPUT"]
BUMPY = os.path.join(DATA, "bumpy.ply")
TETRAHEDRON = os.path.join(DATA, "tetrahedron.off")
HAS_CLOUDS = hasattr(vtkdgg, "vtkPointCloudDGG")


def output_folder(name):
    """A folder for the results of one test."""
    folder = os.path.join(OUTPUT, name)
    os.makedirs(folder, exist_ok=True)
    return folder


def grid(columns, rows):
    """Points and triangles of a rectangle of unit squares; point (i, j) has id j (columns+1)+i."""
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    corner = (np.arange(columns) + (columns + 1) * np.arange(rows)[:, None]).ravel()
    up = corner + columns + 1
    triangles = np.vstack(
        [np.column_stack([corner, corner + 1, up + 1]), np.column_stack([corner, up + 1, up])]
    )
    return points, triangles


def folded(scale=1.0):
    """Two squares along a common side, at a right angle."""
    points = scale * np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1]], dtype=float
    )
    return points, np.array([[0, 1, 3], [0, 3, 2], [0, 4, 5], [0, 5, 1]])


def two_squares(offset):
    """Points and triangles of a unit square and of a copy of it that is moved by an offset. Offset
    (1, 0, 0) gives a seam: points 1 and 3 coincide with points 4 and 6."""
    points, triangles = grid(1, 1)
    return np.vstack([points, points + offset]), np.vstack([triangles, triangles + 4])


def plane(columns, rows):
    """Points of a grid over a rectangle whose longer side has the length 2."""
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]) * 2.0 / (max(columns, rows) - 1)


def sphere_points(count):
    """Points on the unit sphere, evenly spread; the first is near a pole."""
    i = np.arange(count)
    z = 1.0 - (2.0 * i + 1.0) / count
    angle = np.pi * (3.0 - np.sqrt(5.0)) * i
    radius = np.sqrt(1.0 - z * z)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])


def prism(sides, rows):
    """Points and triangles of the side of a prism, whose base has sides of length 1; point i of
    row j has id j sides + i."""
    angle = 2.0 * np.pi * np.arange(sides) / sides
    radius = 0.5 / np.sin(np.pi / sides)
    ring = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    points = np.column_stack(
        [np.tile(ring, (rows + 1, 1)), np.repeat(np.arange(rows + 1.0), sides)]
    )
    corner = np.arange(sides * rows)
    right = corner // sides * sides + (corner + 1) % sides
    triangles = np.vstack(
        [
            np.column_stack([corner, right, right + sides]),
            np.column_stack([corner, right + sides, corner + sides]),
        ]
    )
    return points, triangles


def polydata(points, triangles):
    """The same as vtkPolyData."""
    mesh = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.asarray(points, dtype=float), deep=True))
    mesh.SetPoints(vtk_points)
    triangles = np.asarray(triangles, dtype=np.int64)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True),
    )
    mesh.SetPolys(cells)
    return mesh


def triangles_of(mesh):
    """A copy of the triangles of vtkPolyData, three ids each."""
    ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    return np.array(ids, dtype=np.int64).reshape(-1, 3)


def bumpy():
    """Points and triangles of a bumpy sphere, from its file."""
    mesh = vtkdgg.read(BUMPY)
    return mesh.points, mesh.triangles


def point_array(mesh, name):
    """A copy of a point array as numpy array."""
    return np.array(vtk_to_numpy(mesh.GetPointData().GetArray(name)))


def pixels(image):
    """Image to array, rows from the bottom."""
    width, height, _ = image.GetDimensions()
    scalars = image.GetPointData().GetScalars()
    return np.array(vtk_to_numpy(scalars)).reshape(height, width, -1)


def image_of(array):
    """Array to image."""
    height, width, channels = array.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(array.reshape(-1, channels), dtype=np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def image_error(image, reference):
    """How much two images differ: 0 for equal ones, about one per pixel that is quite different.

    VTK's own comparison with all its leniency switched off: by default it forgives shifts of two
    pixels.
    """
    if image.GetDimensions() != reference.GetDimensions():
        raise AssertionError(f"sizes differ: {image.GetDimensions()}, {reference.GetDimensions()}")
    difference = vtkImageDifference()
    difference.SetInputData(image)
    difference.SetImageData(reference)
    difference.AllowShiftOff()
    difference.AveragingOff()
    # Rounding on another processor may move a colour by a few levels.
    difference.SetThreshold(12)
    difference.Update()
    return difference.GetThresholdedError()


def read_image(path):
    """Read a PNG file."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def write_image(path, image):
    """Write a PNG file."""
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def run(script, *arguments, cwd=None):
    """Run an example as a user does."""
    return subprocess.run(
        [sys.executable, os.path.join(EXAMPLES, "Python", script), *map(str, arguments)],
        cwd=cwd or OUTPUT,
        capture_output=True,
        text=True,
        check=False,
    )


def call(*arguments):
    """Run the command in this process, which saves time."""
    from vtkdgg.command_line import main  # not needed by tests in ParaView

    with contextlib.redirect_stdout(io.StringIO()) as printed:
        with contextlib.redirect_stderr(io.StringIO()) as complained:
            try:
                code = main(arguments)
            except SystemExit as leaving:  # after --help
                code = leaving.code
    return types.SimpleNamespace(
        returncode=code, stdout=printed.getvalue(), stderr=complained.getvalue()
    )


def command(*arguments):
    """Run the command as a user does."""
    return subprocess.run(
        [sys.executable, "-m", "vtkdgg", *map(str, arguments)],
        cwd=OUTPUT,
        capture_output=True,
        text=True,
        check=False,
    )


def example(name):
    """A module of the examples."""
    folder = os.path.join(EXAMPLES, "Python")
    if folder not in sys.path:
        sys.path.append(folder)  # what it imports is beside it
    path = os.path.join(folder, f"{name}.py")
    specification = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def table(result):
    """The table that a command prints."""
    return dict(line.split(None, 1) for line in result.stdout.splitlines() if " " in line)


def number_of_colours(path):
    """How many colours a picture has."""
    red, green, blue = np.moveaxis(pixels(read_image(path))[:, :, :3].astype(int), -1, 0)
    return len(np.unique((red * 256 + green) * 256 + blue))


def polyline(points):
    """One line through some points."""
    curve = polydata(points, np.empty((0, 3)))
    lines = vtkCellArray()
    lines.InsertNextCell(len(points))
    for i in range(len(points)):
        lines.InsertCellPoint(i)
    curve.SetLines(lines)
    return curve
