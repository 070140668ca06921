# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo, the examples, and the code in the README."""

import contextlib
import importlib.util
import io
import os
import re
import shutil
import subprocess
import sys
import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

PYTHON_EXAMPLES = os.path.join(support.EXAMPLES, "Python")
BUMPY = os.path.join(support.DATA, "bumpy.ply")
TETRAHEDRON = os.path.join(support.DATA, "tetrahedron.off")


def run(script, *arguments, cwd=None):
    """Run an example as a user does."""
    return subprocess.run(
        [sys.executable, os.path.join(PYTHON_EXAMPLES, script), *map(str, arguments)],
        cwd=cwd or support.OUTPUT,
        capture_output=True,
        text=True,
        check=False,
    )


def example(name):
    """A module of the examples."""
    path = os.path.join(PYTHON_EXAMPLES, f"{name}.py")
    specification = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def table(result):
    """The table that the demo prints."""
    return dict(line.split(None, 1) for line in result.stdout.splitlines() if " " in line)


def number_of_colours(path):
    """How many colours a picture has."""
    array = support.pixels(support.read_image(path))[:, :, :3]
    return len(np.unique(array.reshape(-1, 3), axis=0))


class Demo(unittest.TestCase):
    def demo(self, name, *arguments):
        """The finished program and the arrays that it wrote."""
        folder = support.output_folder(os.path.join("demo", name))
        shutil.rmtree(folder)
        result = run("demo.py", *arguments, "--out", folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        for file, colours in (("distance.png", 1000), ("error.png", 500)):
            picture = os.path.join(folder, file)
            self.assertEqual(support.read_image(picture).GetDimensions(), (1600, 1200, 1))
            self.assertGreater(number_of_colours(picture), colours)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(folder, "distance.vtp"))
        output = vtkdgg.check(reader)
        names = ("GeodesicDistance", "GeodesicUpperBound", "ExactDistance", "RelativeError")
        return result, {name: support.point_array(output, name) for name in names}

    def check_errors(self, result, arrays, accuracy):
        """The errors in the table are those of the arrays, and within what is promised."""
        rows = table(result)
        exact = arrays["ExactDistance"]
        compared = exact > 0.0
        for row, name in (("raw", "GeodesicUpperBound"), ("corrected", "GeodesicDistance")):
            error = np.abs(arrays[name] - exact)[compared] / exact[compared]
            self.assertLessEqual(error.max(), accuracy * (1.0 + 1e-6))
            printed = [float(text) for text in rows[row].split()[0::2]]
            measured = (error.mean(), np.percentile(error, 99.9), error.max())
            np.testing.assert_allclose(printed, 100.0 * np.array(measured), rtol=0.06, atol=1e-12)
        self.assertTrue((arrays["GeodesicUpperBound"] >= exact * (1.0 - 1e-9))[compared].all())
        self.assertIn(f"{100.0 * accuracy:.2g} %", rows["promised"])

    def test_results(self):
        result, arrays = self.demo("bumpy", BUMPY, "--source", 5)
        rows = table(result)
        distances = arrays["GeodesicDistance"]
        self.assertEqual(rows["vertices"], "642")
        self.assertEqual(rows["triangles"], "1280")
        self.assertEqual(rows["defects"], "none")
        self.assertIn("0 violations at 642 points", result.stdout)
        self.assertEqual(result.stdout.count(" 0 violations"), 2)
        self.assertEqual(distances.shape, (642,))
        self.assertEqual(distances[5], 0.0)
        self.assertIn(f"0 to {distances.max():.6g} model units", rows["range"])
        self.check_errors(result, arrays, 0.01)
        self.assertGreater(np.abs(arrays["RelativeError"]).max(), 1e-6)
        for row, pattern in (
            ("build", r"\A\d+\.\d+ s on \d+ threads?\Z"),
            ("graph", r"\Adegree \d+\.\d, \d+ edges, \d+\.\d MB"),
            ("query", r"\A\d+\.\d ms "),
        ):
            self.assertRegex(rows[row], pattern)

    def test_accuracy(self):
        degrees = []
        for accuracy in (0.1, 0.001):
            result, arrays = self.demo(f"accuracy{accuracy}", BUMPY, "--accuracy", accuracy)
            self.check_errors(result, arrays, accuracy)
            degrees.append(float(table(result)["graph"].split()[1].rstrip(",")))
        self.assertGreater(degrees[1], 2.0 * degrees[0])

    def test_source_by_coordinates(self):
        # On an edge of the tetrahedron, with a minus sign first.
        result, arrays = self.demo("coordinates", TETRAHEDRON, "--source", "-1,0,0")
        expected = np.sqrt([2.0, 2.0, 6.0, 6.0])
        np.testing.assert_allclose(np.sort(arrays["ExactDistance"]), expected, rtol=1e-12)
        np.testing.assert_allclose(np.sort(arrays["GeodesicDistance"]), expected, rtol=0.01)
        self.assertIn("(-1, 0, 0)", table(result)["source"])
        self.assertEqual(result.stdout.count(" 0 violations"), 2)

    def test_broken_promise(self):
        # What the table's last line of defence says of distances that are off.
        errors = example("demo_errors").Errors
        exact = np.array([0.0, 1.0, 2.0, np.nan])
        self.assertTrue(errors(exact * 1.01, exact).keeps(0.01))
        self.assertFalse(errors(exact * 1.02, exact).keeps(0.01))
        self.assertFalse(errors(exact * 0.98, exact).keeps(0.01))
        self.assertFalse(errors(exact * 0.999, exact).is_upper_bound)
        self.assertTrue(errors(exact * 1.001, exact).is_upper_bound)
        self.assertFalse(errors(np.array([0.0, 1.0, np.nan, np.nan]), exact).keeps(0.5))
        self.assertFalse(errors(np.array([0.1, 1.0, 2.0, np.nan]), exact).keeps(0.5))

    def test_no_relative_errors_near_the_source(self):
        # Such distances consist of the length added to triangles without area.
        errors = example("demo_errors").Errors
        exact = np.array([0.0, 1e-14, 3e-14, 1.0, np.nan])
        distances = np.array([0.0, 2e-14, 1e-14, 1.01, np.nan])
        self.assertFalse(errors(distances, exact).keeps(0.01))
        result = errors(distances, exact, 1e-7)
        self.assertTrue(result.keeps(0.01) and result.is_upper_bound)
        self.assertEqual(result.number_near, 2)
        np.testing.assert_array_equal(result.signed[:3], 0.0)
        self.assertAlmostEqual(result.mean, 0.01, delta=1e-12)
        distances[1] = 2e-7
        self.assertFalse(errors(distances, exact, 1e-7).keeps(0.01))
        self.assertFalse(errors(exact + 2e-7, exact, 1e-7).keeps(0.01))

    def test_points_that_coincide(self):
        # A square with a side of no width, as if two points had not been merged.
        points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0]]
        triangles = [[4, 1, 2], [4, 2, 5], [0, 4, 5], [0, 5, 3]]
        path = os.path.join(support.output_folder("formats"), "coincide.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(support.polydata(points, triangles))
        writer.Write()
        result, arrays = self.demo("coincide", path, "--source", 0)
        self.assertGreater(arrays["ExactDistance"][4], 0.0)
        self.assertRegex(table(result)["too"], r"near +1 point within \S+e-07 of the source")
        self.assertIn("2 triangles without area, 2 coincident points", table(result)["defects"])
        self.assertIn("turn MergeCoincidentPoints on (--merge)", result.stdout)

    def test_large_triangles(self):
        result, _ = self.demo("large", TETRAHEDRON)
        self.assertRegex(result.stdout, r"note +triangles are large \(.* 82 % of the diagonal\)")
        result, _ = self.demo("small", BUMPY)
        self.assertNotIn("triangles are large", result.stdout)

    def test_tolerance(self):
        arguments = (TETRAHEDRON, "--source", "2,1,1", "--tolerance", "1")
        result, _ = self.demo("tolerance", *arguments)
        self.assertIn("(1, 1, 1)", table(result)["source"])

    def test_every_format(self):
        folder = support.output_folder("formats")
        reader = vtkPLYReader()
        reader.SetFileName(BUMPY)
        triangulate = vtkTriangleFilter()
        triangulate.SetInputConnection(reader.GetOutputPort())
        for extension, writer in (
            ("vtp", vtkXMLPolyDataWriter()),
            ("vtk", vtkPolyDataWriter()),
            ("stl", vtkSTLWriter()),
            ("obj", vtkOBJWriter()),
        ):
            with self.subTest(extension=extension):
                path = os.path.join(folder, f"bumpy.{extension}")
                writer.SetFileName(path)
                writer.SetInputConnection(triangulate.GetOutputPort())
                writer.Write()
                _, arrays = self.demo(extension, path)
                self.assertEqual(arrays["GeodesicDistance"].shape, (642,))

    def test_unreached_points(self):
        # Two triangles without a common point.
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [3.0, 0.0, 0.0]])
        mesh = support.polydata(points, np.vstack([triangles, triangles + 4]))
        path = os.path.join(support.output_folder("formats"), "two.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(mesh)
        writer.Write()
        result, arrays = self.demo("two", path, "--source", 0)
        self.assertEqual(table(result)["reached"], "4 of 8 vertices")
        for values in arrays.values():
            self.assertEqual(np.isnan(values).sum(), 4)
        # What is not reached has a colour of its own: in the error picture, a blue one.
        folder = support.output_folder(os.path.join("demo", "two"))
        picture = support.pixels(support.read_image(os.path.join(folder, "error.png"))).astype(int)
        bluish = picture[:, :, 2] - picture[:, :, 0] > 40
        self.assertGreater(bluish.mean(), 0.02)

    def test_seams(self):
        # Two squares along a common side whose points exist twice.
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [1.0, 0.0, 0.0]])
        mesh = support.polydata(points, np.vstack([triangles, triangles + 4]))
        path = os.path.join(support.output_folder("formats"), "seam.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(mesh)
        writer.Write()
        result, arrays = self.demo("seam", path, "--source", 0)
        self.assertEqual(np.isnan(arrays["GeodesicDistance"]).sum(), 4)
        self.assertEqual(result.stdout.count("MergeCoincidentPoints"), 1)
        result, arrays = self.demo("merged", path, "--source", 0, "--merge")
        np.testing.assert_allclose(arrays["GeodesicDistance"][7], np.sqrt(5.0), rtol=0.01)
        np.testing.assert_allclose(arrays["ExactDistance"][7], np.sqrt(5.0), rtol=1e-12)

    def test_mistakes(self):
        text = os.path.join(support.output_folder("formats"), "empty.off")
        with open(text, "w", encoding="ascii") as file:
            file.write("OFF\n0 0 0\n")
        garbage = os.path.join(support.output_folder("formats"), "garbage.off")
        with open(garbage, "w", encoding="ascii") as file:
            file.write("OFF\n3 1 0\n0 0 0\nx y z\n")
        for arguments, pattern in (
            (("missing.ply",), "missing.ply: no such file"),
            (("mesh.abc",), "unknown extension '.abc'"),
            ((text,), "holds no points|empty"),
            ((garbage,), "line"),
            ((TETRAHEDRON, "--source", "4"), "points 0 to 3"),
            ((TETRAHEDRON, "--source", "-1"), "points 0 to 3"),
            ((TETRAHEDRON, "--source", "ear"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "1,2"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "nan,0,0"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "9,9,9"), r"raise ProjectionTolerance \(--tolerance\)"),
            ((TETRAHEDRON, "--source", "1,1,1", "--tolerance", "-1"), "ProjectionTolerance is -1"),
            ((TETRAHEDRON, "--colour", "red"), "unrecognized arguments"),
            ((TETRAHEDRON, "--accuracy", "fine"), "--accuracy: invalid float value"),
            ((TETRAHEDRON, "--accuracy", "0"), "1e-0?6"),
            ((TETRAHEDRON, "--accuracy", "0.6"), "0.5"),
            ((TETRAHEDRON, "--accuracy", "nan"), "0.5"),
        ):
            with self.subTest(arguments=arguments):
                result = run("demo.py", *arguments)
                self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                self.assertRegex(result.stderr, r"\Aerror: [^\n]+\n\Z")
                self.assertRegex(result.stderr, pattern)
                self.assertEqual(result.stdout, "")

    def test_help(self):
        result = run("demo.py", "--help")
        self.assertEqual(result.returncode, 0)
        for word in ("--source", "--accuracy", "--tolerance", "--out", "--merge", "--cloud", ".off", ".pcd", ".xyz"):
            self.assertIn(word, result.stdout)


def plane(n):
    """n x n points of the unit square, in double precision."""
    x, y = np.meshgrid(np.linspace(0.0, 1.0, n), np.linspace(0.0, 1.0, n))
    return np.column_stack([x.ravel(), y.ravel(), np.zeros(n * n)])


def is_red(picture):
    """Where a picture shows the source and the path."""
    red, green, blue = (picture[:, :, i].astype(int) for i in range(3))
    return (red > 120) & (green < 70) & (blue < 80)


def is_grey(picture):
    """Where a picture shows points that are not reached; its background is lighter."""
    array = picture[:, :, :3].astype(int)
    return (np.ptp(array, axis=2) <= 8) & (array[:, :, 0] > 100) & (array[:, :, 0] < 210)


class DemoOnClouds(unittest.TestCase):
    def demo(self, name, *arguments):
        """The table, the distances, the length of the path, and the picture."""
        folder = support.output_folder(os.path.join("demo_cloud", name))
        shutil.rmtree(folder)
        result = run("demo.py", *arguments, "--out", folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertFalse(os.path.exists(os.path.join(folder, "error.png")))
        arrays = []
        for file in ("distance.vtp", "path.vtp"):
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(os.path.join(folder, file))
            arrays.append(vtkdgg.check(reader))
        distances = support.point_array(arrays[0], "GeodesicDistance")
        length = arrays[1].GetCellData().GetArray("Length").GetValue(0)
        picture = support.pixels(support.read_image(os.path.join(folder, "distance.png")))
        self.assertEqual(picture.shape[:2], (1200, 1600))
        return table(result), distances, length, picture

    def text(self, name, points, header="", ending=""):
        """Write an .xyz file, and return its path."""
        path = os.path.join(support.output_folder("formats"), name)
        with open(path, "w", encoding="ascii") as file:
            file.write(header)
            for point in points:
                file.write(" ".join(repr(float(x)) for x in point) + ending + "\n")
        return path

    def check_plane(self, distances, source):
        expected = np.linalg.norm(plane(30) - source, axis=1)
        np.testing.assert_allclose(distances, expected, rtol=0.01, atol=1e-9)

    def test_results(self):
        # With a count, a comment, and colours behind the points.
        path = self.text("plane.xyz", plane(30), "900\n# x y z r g b\n", " 10 20 30")
        rows, distances, length, picture = self.demo("plane", path, "--source", 0)
        self.assertEqual(rows["points"], "900")
        self.assertEqual(rows["defects"], "none")
        self.assertEqual(rows["components"], "1, with 900 points")
        self.assertEqual(rows["reached"], "900 of 900 points")
        self.assertRegex(rows["lower"], r"\Abound +0 violations at 900 points\Z")
        self.assertEqual(rows["farthest"], "point 899 at (1, 1, 0)")
        self.check_plane(distances, [0.0, 0.0, 0.0])
        self.assertAlmostEqual(length, np.sqrt(2.0), delta=0.01)
        for row, pattern in (
            ("build", r"\A\d+\.\d+ s on \d+ threads?\Z"),
            ("graph", r"\Adegree \d+\.\d, \d+ edges, \d+\.\d MB\Z"),
            ("query", r"\A\d+\.\d ms for all distances "),
            ("path", r"\A1\.4\d* model units long"),
        ):
            self.assertRegex(rows[row], pattern)
        # The path and both ends of the range of colours are seen, and nothing that is not reached.
        array = picture.astype(int)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(is_red(picture).sum(), 3000)
        self.assertGreater(np.sum((red > 150) & (green > 150) & (blue < 100)), 3000)
        self.assertGreater(np.sum((blue > red + 30) & (blue > green + 30)), 3000)
        self.assertLess(is_grey(picture).mean(), 0.01)

    def test_source_by_coordinates(self):
        path = self.text("plane.xyz", plane(30))
        place = "0.51,0.49,0"
        rows, distances, _, _ = self.demo("place", path, "--source", place)
        self.assertEqual(rows["source"], "(0.51, 0.49, 0)")
        near = np.linalg.norm(plane(30) - [0.51, 0.49, 0.0], axis=1)
        np.testing.assert_allclose(distances, near, rtol=0.02, atol=0.004)

    def test_every_format(self):
        folder = support.output_folder("formats")
        cloud = support.polydata(plane(30), np.empty((0, 3), dtype=int))
        for extension, writer in (
            ("vtp", vtkXMLPolyDataWriter()),
            ("vtk", vtkPolyDataWriter()),
            ("ply", vtkPLYWriter()),
            ("pcd", vtkdgg.vtkPCDWriter()),
        ):
            with self.subTest(extension=extension):
                path = os.path.join(folder, f"plane.{extension}")
                writer.SetFileName(path)
                writer.SetInputData(cloud)
                writer.Write()
                _, distances, _, _ = self.demo(extension, path, "--source", 0)
                self.check_plane(distances, [0.0, 0.0, 0.0])

    def test_points_of_a_mesh(self):
        rows, distances, _, _ = self.demo("bumpy", BUMPY, "--cloud", "--source", 5)
        self.assertEqual(rows["points"], "642")
        self.assertNotIn("triangles", rows)
        exact = vtkdgg.distance(*support.bumpy(), 5)
        error = np.abs(distances - exact)[exact > 0.0] / exact[exact > 0.0]
        self.assertLess(error.mean(), 0.03)
        # It is not the distance on the mesh.
        self.assertGreater(error.max(), 1e-4)

    def test_points_that_are_not_reached(self):
        # Two squares, and two points that are not finite.
        points = np.vstack([plane(20), plane(10) / 2.0 + [2.0, 0.0, 0.0]])
        points = np.vstack([[np.nan, 0.0, 0.0], points, [0.0, np.inf, 0.0]])
        rows, distances, _, picture = self.demo("two", self.text("two.xyz", points))
        self.assertEqual(rows["points"], "502")
        self.assertEqual(rows["defects"], "2 points that are not finite")
        self.assertEqual(rows["components"], "2, with 400, 100 points")
        self.assertEqual(rows["reached"], "400 of 502 points")
        self.assertTrue(np.isfinite(distances[1:401]).all())
        self.assertTrue(np.isnan(distances[[0, *range(401, 502)]]).all())
        # The source is chosen in the larger square, the other one is grey.
        self.assertLess(int(rows["source"].split()[1]), 401)
        self.assertGreater(is_grey(picture).mean(), 0.01)

    def test_few_points(self):
        for name, points, longest in (
            ("one", [[1.0, 2.0, 3.0]], 0.0),
            ("same", [[1.0, 1.0, 1.0]] * 3, 0.0),
            ("pair", [[1.0, 2.0, 3.0], [1.0, 2.0, 4.0]], 1.0),
            ("row", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 2.0),
        ):
            with self.subTest(name):
                rows, distances, length, picture = self.demo(name, self.text(name + ".xyz", points))
                self.assertEqual(rows["points"], str(len(points)))
                self.assertAlmostEqual(np.max(distances), longest, delta=1e-6)
                self.assertAlmostEqual(length, longest, delta=1e-6)
                # The farthest point is dark, and may be all that is seen where it is the source.
                dark = (picture[:, :, :3].max(axis=2) < 60).sum()
                self.assertGreater(is_red(picture).sum() + dark, 500)

    def test_mistakes(self):
        good = self.text("plane.xyz", plane(30))
        bad = self.text("bad.xyz", [[0.0, 0.0, 0.0]], ending="\n1 x 0")
        short = self.text("short.xyz", [[0.0, 0.0, 0.0]], ending="\n\n1 2")
        unfinite = self.text("unfinite.xyz", [[np.nan, 0.0, 0.0], [0.0, 0.0, np.inf]])
        empty = self.text("empty.xyz", [], "# nothing\n")
        garbage = os.path.join(support.output_folder("formats"), "garbage.pcd")
        with open(garbage, "w", encoding="ascii") as file:
            file.write("x y z\n")
        unseen = self.text("unseen.xyz", [[0.0, 0.0, 0.0], [np.nan, 0.0, 0.0]])
        for arguments, pattern in (
            (("missing.pcd",), "missing.pcd: no such file"),
            (("missing.xyz",), "missing.xyz: no such file"),
            ((empty,), "holds no points"),
            ((unfinite,), "none of its points is finite"),
            ((bad,), "line 2: '1 x 0' does not start with X Y Z"),
            ((short,), "line 3: '1 2' does not start with X Y Z"),
            ((garbage,), "garbage.pcd: cannot be read"),
            ((good, "--source", "900"), "points 0 to 899"),
            ((good, "--source", "9,9,9"), r"raise ProjectionTolerance \(--tolerance\)"),
            ((good, "--accuracy", "0.01"), "--accuracy: not on a point cloud"),
            ((good, "--merge"), "--merge: not on a point cloud"),
            ((BUMPY, "--cloud", "--merge"), "--merge: not on a point cloud"),
            ((unseen, "--source", "1"), "--source 1: this point is not finite"),
        ):
            with self.subTest(arguments=arguments):
                result = run("demo.py", *arguments)
                self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                self.assertRegex(result.stderr, r"\Aerror: [^\n]+\n\Z")
                self.assertRegex(result.stderr, pattern)
                self.assertEqual(result.stdout, "")


class Pipeline(unittest.TestCase):
    def test_picture(self):
        picture = os.path.join(support.output_folder("pipeline"), "bumpy.png")
        result = run("exact_distance_pipeline.py", BUMPY, 3, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("642 points", result.stdout)
        self.assertGreater(number_of_colours(picture), 500)

    def test_mistakes(self):
        for arguments in (
            (),
            ("missing.ply", 0, "x.png"),
            (BUMPY, 642, "x.png"),
            (BUMPY, -1, "x.png"),
            (BUMPY, "1.5", "x.png"),
            (BUMPY, 10**30, "x.png"),
        ):
            with self.subTest(arguments=arguments):
                result = run("exact_distance_pipeline.py", *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertNotIn("Traceback", result.stderr)


class Patches(unittest.TestCase):
    def test_two_surfaces(self):
        picture = os.path.join(support.output_folder("patches"), "patches.png")
        stretched = os.path.join(support.output_folder("patches"), "stretched.vtp")
        points, triangles = support.bumpy()
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(support.polydata(points * [1.0, 2.0, 0.7], triangles))
        writer.SetFileName(stretched)
        vtkdgg.check(writer)
        result = run("patch_boundaries.py", BUMPY, stretched, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [line.split() for line in result.stdout.splitlines()[1:]]
        self.assertEqual(len(rows), 12)
        for row in rows:
            self.assertLess(0.7 * float(row[3]), float(row[4]))
            self.assertLess(float(row[4]), 2.1 * float(row[3]))
        self.assertEqual(support.read_image(picture).GetDimensions(), (1200, 600, 1))
        # Curves in many colours on both halves: what is neither white nor grey.
        for half in np.hsplit(support.pixels(support.read_image(picture)).astype(int), 2):
            colourful = np.ptp(half[:, :, :3], axis=2) > 100
            self.assertGreater(colourful.sum(), 1000)

    def test_mistakes(self):
        for arguments in ((), (BUMPY, "missing.ply", "x.png"), (BUMPY, TETRAHEDRON, "x.png")):
            with self.subTest(arguments=arguments):
                result = run("patch_boundaries.py", *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertNotIn("Traceback", result.stderr)


class Graph(unittest.TestCase):
    def test_two_queries(self):
        picture = os.path.join(support.output_folder("pipeline"), "graph.png")
        result = run("graph_pipeline.py", BUMPY, 3, 600, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\d+ edges, \d+\.\d per point\nfrom point 3: up to \d")
        self.assertEqual(support.read_image(picture).GetDimensions(), (1200, 600, 1))
        halves = np.hsplit(support.pixels(support.read_image(picture)).astype(int), 2)
        # The same surface twice, in other colours.
        background = [np.all(half == 255, axis=2) for half in halves]
        self.assertLess(np.mean(background[0] != background[1]), 1e-4)
        differ = np.any(halves[0] != halves[1], axis=2)
        self.assertGreater(differ[~background[0]].mean(), 0.5)

    def test_mistakes_of_two_queries(self):
        for arguments in (
            (),
            ("missing.ply", 0, 1, "x.png"),
            (BUMPY, 0, 642, "x.png"),
            (BUMPY, 0, 10**30, "x.png"),
        ):
            with self.subTest(arguments=arguments):
                result = run("graph_pipeline.py", *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertNotIn("Traceback", result.stderr)

    @unittest.skipUnless(importlib.util.find_spec("scipy"), "SciPy is not installed")
    def test_scipy(self):
        result = run("graph_csr.py", BUMPY, 5)
        self.assertEqual(result.returncode, 0, result.stderr)
        edges = re.search(r"642 points, (\d+) edges", result.stdout)
        self.assertGreater(int(edges[1]), 642 * 20)
        difference = re.search(r"difference to SciPy: (\S+)", result.stdout)
        self.assertLess(float(difference[1]), 1e-12)
        correction = re.search(r"largest correction: (\S+)", result.stdout)
        self.assertGreater(float(correction[1]), 1e-4)
        result = run("graph_csr.py", BUMPY, 642)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Aerror: .*source id 642")


class Terrain(unittest.TestCase):
    def test_paths(self):
        picture = os.path.join(support.output_folder("pipeline"), "terrain.png")
        result = run("terrain_path.py", picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        lengths = re.fullmatch(
            r"on the surface: (\S+) km\nalong mesh edges: (\S+) km, (\S+) % longer\n",
            result.stdout,
        )
        self.assertTrue(lengths, result.stdout)
        length, edges, excess = map(float, lengths.groups())
        self.assertAlmostEqual(100.0 * (edges / length - 1.0), excess, delta=0.06)
        self.assertGreater(excess, 4.0)
        module = example("terrain_path")
        terrain = module.make_terrain()
        path = vtkdgg.vtkDGGPath()
        path.SetInputData(terrain)
        path.SetMethodToExact()
        path.AddPair(
            module.closest_point(terrain, module.START), module.closest_point(terrain, module.END)
        )
        exact = vtkdgg.check(path).GetCellData().GetArray("Length").GetValue(0)
        self.assertAlmostEqual(length, exact, delta=6e-4)
        # Both paths and the ground are seen.
        array = support.pixels(support.read_image(picture)).astype(int)
        self.assertGreater(number_of_colours(picture), 1000)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(np.sum((red > 130) & (green < 60) & (blue < 70)), 1000)
        self.assertGreater(np.sum((blue > 80) & (red < 50) & (green < 60)), 1000)
        self.assertGreater(np.mean((green > red + 10) & (green > blue + 10)), 0.2)

    def test_mistakes(self):
        result = run("terrain_path.py")
        self.assertEqual(result.returncode, 1)
        self.assertIn("Usage: terrain_path.py", result.stderr)


class Voronoi(unittest.TestCase):
    def test_cells(self):
        picture = os.path.join(support.output_folder("pipeline"), "cells.png")
        result = run("voronoi_cells.py", BUMPY, 30, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\A30 cells, areas from \d")
        energy = re.search(r"energy (\S+), after \d+ iterations (\S+)", result.stdout)
        self.assertLess(float(energy[2]), float(energy[1]))
        self.assertGreater(number_of_colours(picture), 500)

    def test_mistakes(self):
        for arguments in ((), ("missing.ply", 5, "x.png"), (BUMPY, 0, "x.png"), (BUMPY, "a", "b")):
            with self.subTest(arguments=arguments):
                result = run("voronoi_cells.py", *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertNotIn("Traceback", result.stderr)


class Isolines(unittest.TestCase):
    def test_four_methods(self):
        picture = os.path.join(support.output_folder("pipeline"), "isolines.png")
        result = run("isolines.py", picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        said = re.findall(
            r"(linear|Apollonius|local sources|exact): (\d+) lines of (\d+) points, (\d+) ridges\n",
            result.stdout,
        )
        self.assertEqual(len(said), 8, result.stdout)
        # One source on a smooth surface: one line each.
        self.assertEqual([row[1] for row in said[:4]], ["14"] * 4)
        self.assertEqual(said[0][3], "0")
        self.assertGreater(int(said[3][3]), 1)
        # Arcs take more points than straight lines in triangles.
        self.assertGreater(int(said[3][2]), 2 * int(said[0][2]))
        array = support.pixels(support.read_image(picture)).astype(int)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(np.sum((blue > 60) & (red < 60)), 5000)
        self.assertGreater(np.sum((red > 120) & (green < 60) & (blue < 60)), 1500)

    def test_mesh(self):
        picture = os.path.join(support.output_folder("pipeline"), "isolines_mesh.png")
        result = run("isolines.py", picture, "--mesh", BUMPY, "--sources", "3", "40")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(result.stdout.splitlines()), 4)

    def test_mistakes(self):
        for arguments, message in (
            ((), "picture"),
            (("x.png", "--mesh", "missing.ply"), "missing.ply"),
            (("x.png", "--mesh", BUMPY, "--sources", "-1"), "-1"),
            (("x.png", "--mesh", BUMPY, "--sources", "642"), "642"),
            (("x.png", "--mesh", BUMPY, "--sources", "9" * 30), "out of range"),
            (("x.png", "--count", "-1"), "from 1 to 10000"),
            (("x.png", "--count", "0"), "from 1 to 10000"),
            (("x.png", "--count", "many"), "'many' is not an integer"),
            (("x.png", "--view", "1,2"), "X,Y,Z"),
            (("x.png", "--view", "1,2,nan"), "not finite"),
        ):
            with self.subTest(arguments=arguments):
                result = run("isolines.py", *arguments)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(message, result.stderr)
                self.assertNotIn("Traceback", result.stderr)


class Loops(unittest.TestCase):
    def test_two_rings(self):
        picture = os.path.join(support.output_folder("pipeline"), "loops.png")
        result = run("loops.py", picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        said = re.fullmatch(
            r"4 loops around handles: lengths (\S+) (\S+) (\S+) (\S+)\n1 ropes: lengths (\S+)\n",
            result.stdout,
        )
        self.assertTrue(said, result.stdout)
        lengths = [float(length) for length in said.groups()]
        # The two rings are alike, up to how the grid meets them.
        self.assertAlmostEqual(lengths[0], lengths[1], delta=2e-3)
        self.assertAlmostEqual(lengths[2], lengths[3], delta=2e-3)
        # Around the waist, a little more than twice across.
        self.assertAlmostEqual(lengths[4], 4.0 * 0.015**0.25 + 0.2, delta=0.08)
        # Loops, rope and tape are seen.
        array = support.pixels(support.read_image(picture)).astype(int)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(np.sum((blue > 80) & (red < 40)), 1500)
        self.assertGreater(np.sum((red > 120) & (green < 50) & (blue < 60)), 800)
        self.assertGreater(np.sum((red > 160) & (green > 90) & (blue < 60)), 300)

    def test_mesh(self):
        picture = os.path.join(support.output_folder("pipeline"), "rope.png")
        # Nothing holds a rope on this mesh, and it has no handles: that is said, and no error.
        result = run("loops.py", picture, "--mesh", BUMPY, "--rope", "-1,0,0 0,1,0 0,0,1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("0 loops around handles", result.stdout)
        self.assertIn("contracts to a point", result.stderr)

    def test_mistakes(self):
        for arguments, message in (
            ((), "picture"),
            (("x.png", "--mesh", "missing.ply"), "missing.ply"),
            (("x.png", "--rope", "1,2"), "--rope"),
            (("x.png", "--view", "0,inf,1"), "not finite"),
            (("x.png", "--rope", "1,0,0 1,0.3,0"), "three points"),
            (("x.png", "--width", "-1"), "TapeWidth"),
        ):
            with self.subTest(arguments=arguments):
                result = run("loops.py", *arguments)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(message, result.stderr)
                self.assertNotIn("Traceback", result.stderr)


class Readme(unittest.TestCase):
    """What the README shows is what is tested."""

    @classmethod
    def setUpClass(cls):
        with open(os.path.join(support.ROOT, "README.md"), encoding="utf-8") as file:
            cls.readme = file.read()

    def blocks(self, language):
        return re.findall(rf"^```{language}\n(.*?)^```$", self.readme, re.M | re.S)

    def code(self, *path):
        """A source file without its licence lines."""
        with open(os.path.join(support.EXAMPLES, *path), encoding="utf-8") as file:
            return "".join(line for line in file if "SPDX-" not in line)

    def test_ten_lines_of_python(self):
        self.assertIn(self.code("Python", "ten_lines.py"), self.blocks("python"))
        folder = support.output_folder("readme")
        shutil.copy(BUMPY, os.path.join(folder, "mesh.ply"))
        result = run("ten_lines.py", cwd=folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"farthest point: \d\.\d+ model units away")

    def test_ten_lines_of_cxx(self):
        # Built and run by the tests of the install tree.
        self.assertIn(self.code("Cxx", "TenLines.cxx"), self.blocks("cpp"))

    def test_one_liner(self):
        blocks = [block for block in self.blocks("python") if "vtkdgg.distance(" in block]
        self.assertEqual(len(blocks), 1)
        names = {}
        exec(blocks[0], names)  # noqa: S102
        np.testing.assert_allclose(names["d"], [0.0, 3.0, 4.0], rtol=1e-12)

    def test_many_queries(self):
        blocks = [block for block in self.blocks("python") if "vtkdgg.Graph(" in block]
        self.assertEqual(len(blocks), 1)
        points, triangles = support.bumpy()
        names = {"points": points, "triangles": triangles}
        exec(blocks[0], names)  # noqa: S102
        exact = vtkdgg.distance(points, triangles, [0, 10, 20])
        self.assertTrue((np.abs(names["d"] - exact) <= 0.01 * exact * (1 + 1e-6)).all())
        self.assertEqual(names["m"].shape, (2, 3))
        exact = vtkdgg.path(points, triangles, 0, 10)
        self.assertLessEqual(names["p"].length, exact.length * 1.01)
        self.assertGreaterEqual(names["p"].length, exact.length * (1 - 1e-9))

    def test_ten_lines_of_paths(self):
        blocks = [block for block in self.blocks("python") if "vtkDGGPath()" in block]
        self.assertEqual(len(blocks), 1)
        self.assertLessEqual(len([line for line in blocks[0].splitlines() if line]), 10)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), names)  # noqa: S102
        exact = vtkdgg.distance(*support.bumpy(), 0)[20]
        said = re.fullmatch(r"from 0 to 20: (\S+) model units\n", printed.getvalue())
        self.assertAlmostEqual(float(said[1]), exact, delta=1e-6)

    def test_ten_lines_of_loops(self):
        blocks = [block for block in self.blocks("python") if "vtkDGGLoop()" in block]
        self.assertEqual(len(blocks), 1)
        path = os.path.join(support.output_folder("pipeline"), "prism.ply")
        writer = vtkPLYWriter()
        writer.SetInputData(support.polydata(*support.prism(9, 6)))
        writer.SetFileName(path)
        vtkdgg.check(writer)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", path), names)  # noqa: S102
        self.assertEqual(printed.getvalue(), "1 loops, the shortest one 9 model units long\n")

    def test_other_blocks_run(self):
        for name, said in (
            ("vtkGeodesicSampler()", r"no point of the mesh is farther than 0\.\d+ model units .*"),
            ("vtkGeodesicVoronoi()", r"the cells have areas of \d\S* \d\S* \d\S*"),
            ("vtkGeodesicPatchBoundaries()", r"6 curves on each surface; .*"),
            ("vtkGeodesicProbe()", r"farthest triangle: \d\.\d+ model units away"),
            ("GeodesicDistance\")()", r"(\w+: farthest point \d\.\d+ model units away\n?){3}"),
        ):
            with self.subTest(name):
                blocks = [block for block in self.blocks("python") if name in block]
                self.assertEqual(len(blocks), 1)
                with contextlib.redirect_stdout(io.StringIO()) as printed:
                    exec(blocks[0].replace("mesh.ply", BUMPY), {})  # noqa: S102
                self.assertRegex(printed.getvalue().strip(), rf"\A{said}\Z")

    def test_examples_are_listed(self):
        for folder, ending in (("Python", ".py"), ("Cxx", ".cxx")):
            for file in os.listdir(os.path.join(support.EXAMPLES, folder)):
                name, extension = os.path.splitext(file)
                is_part = name.startswith("demo_") or name in (
                    "cloud_file",
                    "example_arguments",
                    "mesh_file",
                )
                if extension == ending and not is_part:
                    self.assertIn(f"`{name}`", self.readme)

    def test_isolines(self):
        blocks = [block for block in self.blocks("python") if "vtkApolloniusIsolines()" in block]
        self.assertEqual(len(blocks), 1)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), {})  # noqa: S102
        self.assertEqual(printed.getvalue(), "True True\n")

    def test_matrix_in_one_line(self):
        line = self.blocks("py")[0].strip()
        self.assertIn(line, self.code("Python", "graph_csr.py"))

    def test_links(self):
        for target in re.findall(r"\]\((?!https?:|#)([^)]+)\)", self.readme):
            self.assertTrue(os.path.exists(os.path.join(support.ROOT, target)), target)


if __name__ == "__main__":
    unittest.main()
