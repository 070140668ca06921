# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command compare and the examples on point clouds."""

import os
import re
import shutil
import unittest

import numpy as np
import support
import vtkdgg
from support import BUMPY, command, run, table
from test_demo import check_mistakes


def plane(n):
    """Returns n x n points of the unit square."""
    return 0.5 * support.plane(n, n)


def is_red(picture):
    """Returns true for pixels of the source and the path."""
    red, green, blue = np.moveaxis(picture, -1, 0)
    return (red > 120) & (green < 70) & (blue < 80)


def is_grey(picture):
    """Returns true for pixels of points that are not reached; the background is lighter."""
    red = picture[:, :, 0]
    return (np.ptp(picture, axis=2) <= 8) & (red > 100) & (red < 210)


class DemoOnClouds(unittest.TestCase):
    def demo(self, name, *arguments):
        """Returns the table, the distances, the length of the path, and the picture."""
        folder = support.output_folder(os.path.join("demo_cloud", name))
        shutil.rmtree(folder)
        result = command("compare", *arguments, "--out", folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertFalse(os.path.exists(os.path.join(folder, "error.png")))
        cloud, path = (vtkdgg.read(os.path.join(folder, f"{n}.vtp")) for n in ("distance", "path"))
        distances, length = cloud.point_data["GeodesicDistance"], path.cell_data["Length"][0]
        picture = support.pixels(os.path.join(folder, "distance.png"))
        self.assertEqual(picture.shape[:2], (1200, 1600))
        return table(result), distances, length, picture

    def text(self, name, points, header="", ending=""):
        """Writes an .xyz file, and returns its path."""
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
        # The picture shows the path and both ends of the range of colors, and no unreached points.
        red, green, blue = np.moveaxis(picture, -1, 0)
        self.assertGreater(is_red(picture).sum(), 3000)
        self.assertGreater(np.sum((red > 150) & (green > 150) & (blue < 100)), 3000)
        self.assertGreater(np.sum((blue > red + 30) & (blue > green + 30)), 3000)
        self.assertLess(is_grey(picture).mean(), 0.01)

    def test_points_of_a_mesh(self):
        rows, distances, _, _ = self.demo("bumpy", BUMPY, "--cloud", "--source", 5)
        self.assertEqual(rows["points"], "642")
        self.assertNotIn("triangles", rows)
        exact = vtkdgg.distance(*support.bumpy(), 5)
        error = np.abs(distances - exact)[exact > 0.0] / exact[exact > 0.0]
        self.assertLess(error.mean(), 0.03)
        # The distances are not those on the mesh.
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
            ("row", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 2.0),
        ):
            with self.subTest(name):
                rows, distances, length, picture = self.demo(name, self.text(name + ".xyz", points))
                self.assertEqual(rows["points"], str(len(points)))
                self.assertAlmostEqual(np.max(distances), longest, delta=1e-6)
                self.assertAlmostEqual(length, longest, delta=1e-6)
                # The farthest point is dark. If it is the source, nothing else may be visible.
                dark = (picture.max(axis=2) < 60).sum()
                self.assertGreater(is_red(picture).sum() + dark, 500)

    def test_mistakes(self):
        good = self.text("plane.xyz", plane(30))
        unfinite = self.text("unfinite.xyz", [[np.nan, 0.0, 0.0], [0.0, 0.0, np.inf]])
        unseen = self.text("unseen.xyz", [[0.0, 0.0, 0.0], [np.nan, 0.0, 0.0]])
        check_mistakes(
            self,
            ((unfinite,), "none of its points is finite"),
            ((good, "--source", "9,9,9"), "or raise --tolerance"),
            ((good, "--accuracy", "0.01"), "--accuracy applies to meshes"),
            ((good, "--merge"), "--merge applies to meshes"),
            ((BUMPY, "--cloud", "--merge"), "--merge applies to meshes"),
            ((BUMPY, "--cloud", "--methods"), "--methods applies to meshes"),
            ((unseen, "--source", "1"), "--source 1: this point is not finite"),
        )


class Cells(unittest.TestCase):
    def cells(self, name, points, count):
        """Returns the text of the example, and the colors of its picture."""
        folder = support.output_folder("cloud_cells")
        cloud = os.path.join(folder, f"{name}.vtp")
        vtkdgg.write(cloud, vtkdgg.Mesh(points))
        picture = os.path.join(folder, f"{name}.png")
        result = run("cloud_cells.py", cloud, count, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout, support.pixels(picture)

    def test_even_cells(self):
        said, picture = self.cells("sphere", support.sphere_points(4000), 20)
        sizes = re.match(r"20 cells, with (\d+) to (\d+) of 4000 points\n", said)
        self.assertTrue(sizes, said)
        self.assertGreater(int(sizes[1]), 0.7 * 200)
        self.assertLess(int(sizes[2]), 1.3 * 200)
        energy = re.search(r"energy (\S+), after \d+ iterations (\S+)", said)
        self.assertLess(float(energy[2]), 0.97 * float(energy[1]))
        # Sites are dark; cells have no gaps, and at least four colours, as any map may need.
        self.assertGreater((picture.max(axis=2) < 70).sum(), 300)
        middle = picture[350:450, 350:450]
        self.assertLess((middle.min(axis=2) > 240).sum(), 10)
        shown = picture[(picture.min(axis=2) < 240) & (picture.max(axis=2) > 70)] / 255.0
        hues = np.round(shown / shown.max(axis=1, keepdims=True), 1)
        _, counts = np.unique(hues, axis=0, return_counts=True)
        self.assertGreaterEqual((counts > 0.04 * len(hues)).sum(), 4)

    def test_neighbors_differ(self):
        # A tube divided into 24 cells along its axis. The ids of adjacent cells often end in the
        # same digit.
        count = 24
        x, t = np.meshgrid(np.arange(20 * count) / 10.0, np.arange(12) * np.pi / 6.0)
        tube = np.column_stack([x.ravel(), 0.2 * np.cos(t).ravel(), 0.2 * np.sin(t).ravel()])
        graph = vtkdgg.vtkPointCloudDGG()
        graph.SetInputData(support.polydata(tube))
        cloud = vtkdgg.check(graph)
        order = np.array(sorted(range(count), key=lambda cell: cell % 10))
        labels = order[(tube[:, 0] / 2.0).astype(int)]
        module = support.example("cloud_cells")
        colours = module.choose_colours(cloud, labels, count)
        self.assertTrue((colours[order[1:]] != colours[order[:-1]]).all())
        self.assertTrue((0 <= colours).all() and (colours < len(module.COLOURS)).all())
        # All colors are used, and about equally often.
        self.assertLessEqual(np.ptp(np.bincount(colours, minlength=len(module.COLOURS))), 1)
        # Points that no site reaches do not count.
        labels[labels == 5] = -1
        np.testing.assert_array_equal(
            np.sort(module.choose_colours(cloud, labels, count)) >= 0, True
        )

    def test_points_and_components_without_a_site(self):
        points = np.vstack([plane(20), plane(10) / 2.0 + [2.0, 0.0, 0.0], [[np.nan, 0.0, 0.0]]])
        folder = support.output_folder("cloud_cells")
        path = os.path.join(folder, "parts.xyz")
        np.savetxt(path, points)
        picture = os.path.join(folder, "parts.png")
        result = run("cloud_cells.py", path, 1, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\A1 cells, with [1-4]00 to [1-4]00 of 501 points\n")
        self.assertIn("components", result.stderr)
        self.assertGreater(is_grey(support.pixels(picture)).mean(), 0.005)


class Guards(unittest.TestCase):
    def test_picture(self):
        module = support.example("cloud_guards")
        picture = os.path.join(support.OUTPUT, "cloud_guards.png")
        module.main(picture, 0.1)
        image = support.pixels(picture)
        self.assertEqual(image.shape[:2], module.SIZE[::-1])
        rows, columns = image.shape[0] // 2, image.shape[1] // 2
        for i in range(4):
            row, column = i // 2 * rows, i % 2 * columns
            panel = image[row : row + rows, column : column + columns].reshape(-1, 3)
            self.assertTrue(0.1 < (panel < 250).any(axis=1).mean() < 0.9, i)
            red = (panel[:, 0] > 120) & (panel[:, 1:] < 60).all(axis=1)
            self.assertGreater(red.sum(), 50, i)


if __name__ == "__main__":
    unittest.main()
