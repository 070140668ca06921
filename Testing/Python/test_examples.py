# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo and the examples on meshes."""

import importlib.util
import os
import re
import shutil
import unittest

import numpy as np
import support
import vtkdgg
from support import BUMPY, TETRAHEDRON, number_of_colours, run, table
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


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
        errors = support.example("demo_errors").Errors
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
        errors = support.example("demo_errors").Errors
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
        module = support.example("terrain_path")
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


class GreensFunction(unittest.TestCase):
    def test_errors_and_bands(self):
        picture = os.path.join(support.output_folder("pipeline"), "greens_function.png")
        errors = {}
        for level in (4, 3):
            result = run("greens_function.py", picture, "--level", str(level))
            self.assertEqual(result.returncode, 0, result.stderr)
            said = re.findall(r"(.*): error (\S+) %\n", result.stdout)
            self.assertEqual(len(said), 4, result.stdout)
            errors[level] = {name: float(error) for name, error in said}
            self.assertGreater(errors[level]["vertex"], errors[level]["interpolated"])
            self.assertLess(
                20.0 * errors[level]["singularity subtraction"], errors[level]["localized"]
            )
        for name in ("vertex", "singularity subtraction"):
            self.assertLess(errors[4][name], 0.7 * errors[3][name])
        # Above the captions, the last panel is nearly the first one; the others are not.
        array = support.pixels(support.read_image(picture)).astype(int)
        self.assertEqual(array.shape[:2], (364, 1500))
        panels = [array[:, 300 * k + 1 : 300 * k + 299, :3] for k in range(5)]
        differences = [np.abs(panel[64:] - panels[0][64:]).mean() for panel in panels]
        self.assertLess(5.0 * differences[4], min(differences[1:4]))

    def test_mistakes(self):
        for level in ("0", "7", "many"):
            with self.subTest(level=level):
                result = run("greens_function.py", "--level", level)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(level, result.stderr)
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


if __name__ == "__main__":
    unittest.main()
