# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command compare on meshes."""

import os
import shutil
import unittest

import numpy as np
import support
import vtkdgg
from support import BUMPY, TETRAHEDRON, command, number_of_colours, table
from vtkdgg.commands.measured import Errors


def check_mistakes(test, *cases):
    """Expects one line of error from the command for each case: arguments and a pattern."""
    for arguments, pattern in cases:
        with test.subTest(arguments=arguments):
            result = support.call("compare", *arguments)
            test.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
            test.assertRegex(result.stderr, r"\Aerror: [^\n]+\n\Z")
            test.assertRegex(result.stderr, pattern)


class Demo(unittest.TestCase):
    def demo(self, name, *arguments):
        """Returns the finished program and the arrays that it wrote."""
        folder = support.output_folder(os.path.join("demo", name))
        shutil.rmtree(folder)
        result = command("compare", *arguments, "--out", folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        for file, colours in (("distance.png", 1000), ("error.png", 500)):
            picture = os.path.join(folder, file)
            self.assertEqual(support.read_image(picture).GetDimensions(), (1600, 1200, 1))
            self.assertGreater(number_of_colours(picture), colours)
        arrays = vtkdgg.read(os.path.join(folder, "distance.vtp")).point_data
        names = ("GeodesicDistance", "GeodesicUpperBound", "ExactDistance", "RelativeError")
        return result, {name: arrays[name] for name in names}

    def check_errors(self, result, arrays, accuracy):
        """Checks that the table has the errors of the arrays, and that they keep the promise."""
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
        self.assertNotIn("triangles are large", result.stdout)
        self.assertEqual(result.stdout.count(" 0 violations"), 2)
        self.assertEqual(distances.shape, (642,))
        self.assertEqual(distances[5], 0.0)
        self.assertIn(f"0 to {distances.max():.6g} model units", rows["range"])
        self.check_errors(result, arrays, 0.01)
        self.assertGreater(np.abs(arrays["RelativeError"]).max(), 1e-6)
        for row, pattern in (
            ("first", r"\Aanswer +after \d+\.\d ms, by virtual sources: mean error \S+ %, "),
            ("build", r"\A\d+\.\d+ s on \d+ threads?\Z"),
            ("graph", r"\Adegree \d+\.\d, \d+ edges, \d+\.\d MB"),
            ("query", r"\A\d+\.\d ms "),
        ):
            self.assertRegex(rows[row], pattern)

    def test_accuracy(self):
        result, arrays = self.demo("accuracy", BUMPY, "--accuracy", 0.1)
        self.check_errors(result, arrays, 0.1)

    def test_methods(self):
        result, _ = self.demo("methods", BUMPY, "--source", 5, "--methods")
        lines = [line[13:] for line in result.stdout.splitlines()]
        first = next(i for i, line in enumerate(lines) if line.startswith("graph  "))
        means = {
            line[:26].strip(): float(line[27:].split()[0]) for line in lines[first : first + 8]
        }
        self.assertEqual(len(means), 8)
        self.assertTrue({"virtual sources (fast)", "fast marching (marching)"} < set(means))
        self.assertLess(means["graph, corrected"], 0.3 * means["graph"])
        self.assertLess(means["graph"], means["graph, published rule"])
        self.assertLess(means["graph, published rule"], means["heat"])
        picture = os.path.join(support.output_folder("demo"), "methods", "methods.png")
        self.assertEqual(support.read_image(picture).GetDimensions(), (1840, 1286, 1))
        self.assertGreater(number_of_colours(picture), 1000)

    def test_source_by_coordinates(self):
        # On an edge of the tetrahedron, with a minus sign first.
        result, arrays = self.demo("coordinates", TETRAHEDRON, "--source", "-1,0,0")
        expected = np.sqrt([2.0, 2.0, 6.0, 6.0])
        np.testing.assert_allclose(np.sort(arrays["ExactDistance"]), expected, rtol=1e-12)
        np.testing.assert_allclose(np.sort(arrays["GeodesicDistance"]), expected, rtol=0.01)
        self.assertIn("(-1, 0, 0)", table(result)["source"])
        self.assertRegex(result.stdout, r"note +triangles are large \(.* 82 % of the diagonal\)")
        self.assertEqual(result.stdout.count(" 0 violations"), 2)

    def test_broken_promise(self):
        # Errors of distances that are wrong.
        exact = np.array([0.0, 1.0, 2.0, np.nan])
        self.assertTrue(Errors(exact * 1.01, exact).keeps(0.01))
        self.assertFalse(Errors(exact * 1.02, exact).keeps(0.01))
        self.assertFalse(Errors(exact * 0.98, exact).keeps(0.01))
        self.assertFalse(Errors(exact * 0.999, exact).is_upper_bound)
        self.assertTrue(Errors(exact * 1.001, exact).is_upper_bound)
        self.assertFalse(Errors(np.array([0.0, 1.0, np.nan, np.nan]), exact).keeps(0.5))
        self.assertFalse(Errors(np.array([0.1, 1.0, 2.0, np.nan]), exact).keeps(0.5))

    def test_no_relative_errors_near_the_source(self):
        # Such distances consist of the length added to triangles without area.
        exact = np.array([0.0, 1e-14, 3e-14, 1.0, np.nan])
        distances = np.array([0.0, 2e-14, 1e-14, 1.01, np.nan])
        self.assertFalse(Errors(distances, exact).keeps(0.01))
        result = Errors(distances, exact, 1e-7)
        self.assertTrue(result.keeps(0.01) and result.is_upper_bound)
        self.assertEqual(result.number_near, 2)
        np.testing.assert_array_equal(result.signed[:3], 0.0)
        self.assertAlmostEqual(result.mean, 0.01, delta=1e-12)
        distances[1] = 2e-7
        self.assertFalse(Errors(distances, exact, 1e-7).keeps(0.01))
        self.assertFalse(Errors(exact + 2e-7, exact, 1e-7).keeps(0.01))

    def test_points_that_coincide(self):
        # A square with a side of no width, as if two points had not been merged.
        points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0]]
        triangles = [[4, 1, 2], [4, 2, 5], [0, 4, 5], [0, 5, 3]]
        path = os.path.join(support.output_folder("formats"), "coincide.vtp")
        vtkdgg.write(path, support.polydata(points, triangles))
        result, arrays = self.demo("coincide", path, "--source", 0)
        self.assertGreater(arrays["ExactDistance"][4], 0.0)
        self.assertRegex(table(result)["too"], r"near +1 point within \S+e-07 of the source")
        self.assertIn("2 triangles without area, 2 coincident points", table(result)["defects"])
        self.assertIn("Turn on --merge", result.stdout)

    def test_unreached_points(self):
        # Two triangles without a common point.
        path = os.path.join(support.output_folder("formats"), "two.vtp")
        vtkdgg.write(path, support.polydata(*support.two_squares([3.0, 0.0, 0.0])))
        result, arrays = self.demo("two", path, "--source", 0)
        self.assertEqual(table(result)["reached"], "4 of 8 vertices")
        for values in arrays.values():
            self.assertEqual(np.isnan(values).sum(), 4)
        # Unreached points have a separate colour: blue in the error picture.
        folder = support.output_folder(os.path.join("demo", "two"))
        picture = support.pixels(os.path.join(folder, "error.png"))
        bluish = picture[:, :, 2] - picture[:, :, 0] > 40
        self.assertGreater(bluish.mean(), 0.02)

    def test_seams(self):
        # Two squares along a common side whose points exist twice.
        path = os.path.join(support.output_folder("formats"), "seam.vtp")
        vtkdgg.write(path, support.polydata(*support.two_squares([1.0, 0.0, 0.0])))
        result, arrays = self.demo("seam", path, "--source", 0)
        self.assertEqual(np.isnan(arrays["GeodesicDistance"]).sum(), 4)
        self.assertEqual(result.stdout.count("Turn on --merge"), 1)
        result, arrays = self.demo("merged", path, "--source", 0, "--merge")
        np.testing.assert_allclose(arrays["GeodesicDistance"][7], np.sqrt(5.0), rtol=0.01)
        np.testing.assert_allclose(arrays["ExactDistance"][7], np.sqrt(5.0), rtol=1e-12)

    def test_mistakes(self):
        check_mistakes(
            self,
            (("missing.off",), "missing.off: no such file"),
            ((TETRAHEDRON, "--source", "4"), "point id 4 .* does not exist"),
            ((TETRAHEDRON, "--source", "1,1,1", "--tolerance", "-1"), "--tolerance is -1"),
            ((TETRAHEDRON, "--accuracy", "0.6"), "--accuracy is 0.6"),
        )


if __name__ == "__main__":
    unittest.main()
