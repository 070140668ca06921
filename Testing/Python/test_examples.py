# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo, the examples, and the code in the README."""

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
from vtkmodules.vtkIOPLY import vtkPLYReader
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


def table(result):
    """The table that the demo prints."""
    return dict(line.split(None, 1) for line in result.stdout.splitlines() if " " in line)


def number_of_colours(path):
    """How many colours a picture has."""
    array = support.pixels(support.read_image(path))[:, :, :3]
    return len(np.unique(array.reshape(-1, 3), axis=0))


class Demo(unittest.TestCase):
    def demo(self, name, *arguments):
        folder = support.output_folder(os.path.join("demo", name))
        shutil.rmtree(folder)
        result = run("demo.py", *arguments, "--out", folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        picture = os.path.join(folder, "distance.png")
        self.assertEqual(support.read_image(picture).GetDimensions(), (1600, 1200, 1))
        self.assertGreater(number_of_colours(picture), 1000)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(folder, "distance.vtp"))
        distances = support.point_array(vtkdgg.check(reader), "GeodesicDistance")
        return result, distances

    def test_results(self):
        result, distances = self.demo("bumpy", BUMPY, "--source", 5)
        rows = table(result)
        self.assertEqual(rows["vertices"], "642")
        self.assertEqual(rows["triangles"], "1280")
        self.assertEqual(rows["defects"], "none")
        self.assertIn("0 violations at 642 points", result.stdout)
        self.assertEqual(result.stdout.count(" 0 violations"), 2)
        self.assertEqual(distances.shape, (642,))
        self.assertEqual(distances[5], 0.0)
        self.assertIn(f"0 to {distances.max():.6g} model units", rows["range"])

    def test_source_by_coordinates(self):
        # On an edge of the tetrahedron, with a minus sign first.
        result, distances = self.demo("coordinates", TETRAHEDRON, "--source", "-1,0,0")
        np.testing.assert_allclose(
            np.sort(distances), np.sqrt([2.0, 2.0, 6.0, 6.0]), rtol=1e-12
        )
        self.assertIn("(-1, 0, 0)", table(result)["source"])
        self.assertEqual(result.stdout.count(" 0 violations"), 2)

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
                _, distances = self.demo(extension, path)
                self.assertEqual(distances.shape, (642,))

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
        result, distances = self.demo("two", path, "--source", 0)
        self.assertEqual(table(result)["reached"], "4 of 8 vertices")
        self.assertEqual(np.isnan(distances).sum(), 4)

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
        result, distances = self.demo("seam", path, "--source", 0)
        self.assertEqual(np.isnan(distances).sum(), 4)
        self.assertIn("MergeCoincidentPoints", result.stdout)
        result, distances = self.demo("merged", path, "--source", 0, "--merge")
        np.testing.assert_allclose(distances[7], np.sqrt(5.0), rtol=1e-12)

    def test_mistakes(self):
        text = os.path.join(support.output_folder("formats"), "empty.off")
        with open(text, "w", encoding="ascii") as file:
            file.write("OFF\n0 0 0\n")
        garbage = os.path.join(support.output_folder("formats"), "garbage.off")
        with open(garbage, "w", encoding="ascii") as file:
            file.write("OFF\n3 1 0\n0 0 0\nx y z\n")
        for arguments, pattern in (
            (("missing.ply",), "missing.ply: no such file"),
            (("mesh.xyz",), "unknown extension '.xyz'"),
            ((text,), "holds no surface|empty"),
            ((garbage,), "line"),
            ((TETRAHEDRON, "--source", "4"), "points 0 to 3"),
            ((TETRAHEDRON, "--source", "-1"), "points 0 to 3"),
            ((TETRAHEDRON, "--source", "ear"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "1,2"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "nan,0,0"), "neither a point id nor X,Y,Z"),
            ((TETRAHEDRON, "--source", "9,9,9"), "ProjectionTolerance"),
            ((TETRAHEDRON, "--colour", "red"), "unrecognized arguments"),
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
        for word in ("--source", "--out", "--merge", ".off"):
            self.assertIn(word, result.stdout)


class Pipeline(unittest.TestCase):
    def test_picture(self):
        picture = os.path.join(support.output_folder("pipeline"), "bumpy.png")
        result = run("exact_distance_pipeline.py", BUMPY, 3, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("642 points", result.stdout)
        self.assertGreater(number_of_colours(picture), 500)

    def test_mistakes(self):
        for arguments in ((), ("missing.ply", 0, "x.png"), (BUMPY, 642, "x.png")):
            with self.subTest(arguments=arguments):
                result = run("exact_distance_pipeline.py", *arguments)
                self.assertEqual(result.returncode, 1)
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

    def test_links(self):
        for target in re.findall(r"\]\((?!https?:|#)([^)]+)\)", self.readme):
            self.assertTrue(os.path.exists(os.path.join(support.ROOT, target)), target)


if __name__ == "__main__":
    unittest.main()
