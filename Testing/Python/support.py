# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fixtures that the tests share: folders, small meshes and clouds, filters, refusals, pictures,
processes, commands."""

import contextlib
import importlib.util
import io
import os
import subprocess
import sys
import types
import unittest
import warnings

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkIOImage import vtkPNGReader

TESTING = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOT = os.path.dirname(TESTING)
DATA = os.path.join(TESTING, "Data")
EXAMPLES = os.path.join(ROOT, "Examples")
OUTPUT = os.environ["DGG_TEST_OUTPUT"]
BUMPY = os.path.join(DATA, "bumpy.ply")
TETRAHEDRON = os.path.join(DATA, "tetrahedron.off")
HAS_CLOUDS = hasattr(vtkdgg._kernel, "cloud_graph")
needs_clouds = unittest.skipUnless(HAS_CLOUDS, "built without PCL")


class Test(unittest.TestCase):
    """A test with tables of wrong calls."""

    def refuse(self, call, *cases, error=ValueError):
        """Expects an error of each call: arguments, as a tuple or dict, and the pattern of the
        message."""
        for given, pattern in cases:
            with self.subTest(given=given), self.assertRaisesRegex(error, pattern):
                call(**given) if isinstance(given, dict) else call(*given)


@contextlib.contextmanager
def warnings_as(action):
    """Ignores warnings, or turns warnings into errors."""
    with warnings.catch_warnings():
        warnings.simplefilter(action)
        yield


def output_folder(name):
    """Returns a folder for the results of one test."""
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


def folded():
    """Points and triangles of two squares with a common side, at a right angle."""
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1]]
    return np.array(points, dtype=float), np.array([[0, 1, 3], [0, 3, 2], [0, 4, 5], [0, 5, 1]])


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


def polydata(points, triangles=(), **cells):
    """Returns vtkPolyData of triangles, and of rows of ids that replace cells of a kind: Verts,
    Lines, Polys or Strips."""
    mesh = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.asarray(points, dtype=float), deep=True))
    mesh.SetPoints(vtk_points)
    triangles = np.asarray(triangles, dtype=np.int64)
    polygons = vtkCellArray()
    polygons.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True),
    )
    mesh.SetPolys(polygons)
    for kind, rows in cells.items():
        array = vtkCellArray()
        for row in rows:
            array.InsertNextCell(len(row), list(map(int, row)))
        getattr(mesh, f"Set{kind}")(array)
    return mesh


def polyline(points):
    """Returns vtkPolyData with one line through the points."""
    return polydata(points, Lines=[range(len(points))])


def copy_of(data):
    """Returns a deep copy of vtkPolyData."""
    result = vtkPolyData()
    result.DeepCopy(data)
    return result


def add_array(data, name, values):
    """Adds a copy of an array to point, cell or field data."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)
    return array


def make(kind, data, **properties):
    """Returns an algorithm, by class or name, with data or an algorithm as input, and with
    properties."""
    algorithm = (getattr(vtkdgg, kind) if isinstance(kind, str) else kind)()
    if isinstance(data, vtkAlgorithm):
        algorithm.SetInputConnection(data.GetOutputPort())
    else:
        algorithm.SetInputData(data)
    for name, value in properties.items():
        getattr(algorithm, f"Set{name}")(value)
    return algorithm


def distances_of(algorithm):
    """Updates a distance filter and returns a copy of its distances."""
    return point_array(vtkdgg.check(algorithm), "GeodesicDistance")


def triangles_of(mesh):
    """Returns a copy of the triangles of vtkPolyData, shape (n, 3)."""
    ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    return np.array(ids, dtype=np.int64).reshape(-1, 3)


def bumpy():
    """Returns points and triangles of a bumpy sphere of 642 points, from its file."""
    mesh = vtkdgg.read(BUMPY)
    return mesh.points, mesh.triangles


def point_array(mesh, name):
    """Returns a copy of a point array."""
    return np.array(vtk_to_numpy(mesh.GetPointData().GetArray(name)))


def length_of(points):
    """Returns the length of a polyline."""
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def pixels(path):
    """Returns the colors of a PNG file: integers of shape (height, width, 3), from the bottom."""
    image = read_image(path)
    width, height, _ = image.GetDimensions()
    colors = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return colors[:, :, :3].astype(int)


def image_of(array):
    """Returns colors of shape (height, width, channels) as vtkImageData."""
    height, width, channels = array.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(array.reshape(-1, channels), dtype=np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def read_image(path):
    """Returns a PNG file as vtkImageData."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def number_of_colours(path):
    """Returns the number of colors of a picture."""
    return len(np.unique(pixels(path) @ [256 * 256, 256, 1]))


def python(code, *arguments, **options):
    """Runs code in another Python process, in the folder of the tests."""
    return subprocess.run(
        [sys.executable, "-c", code, *map(str, arguments)],
        cwd=os.path.dirname(os.path.abspath(__file__)),
        capture_output=True,
        check=False,
        **{"text": True, "timeout": 120, **options},
    )


def run(script, *arguments, cwd=None):
    """Runs an example as a user does."""
    return subprocess.run(
        [sys.executable, os.path.join(EXAMPLES, "Python", script), *map(str, arguments)],
        cwd=cwd or OUTPUT,
        capture_output=True,
        text=True,
        check=False,
    )


def call(*arguments):
    """Runs the command in this process, which saves time."""
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
    """Runs the command as a user does."""
    return subprocess.run(
        [sys.executable, "-m", "vtkdgg", *map(str, arguments)],
        cwd=OUTPUT,
        capture_output=True,
        text=True,
        check=False,
    )


def example(name):
    """Returns a module of the examples."""
    folder = os.path.join(EXAMPLES, "Python")
    if folder not in sys.path:
        sys.path.append(folder)  # contains the modules that it imports
    path = os.path.join(folder, f"{name}.py")
    specification = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def table(result):
    """Returns the table that a command prints."""
    return dict(line.split(None, 1) for line in result.stdout.splitlines() if " " in line)
