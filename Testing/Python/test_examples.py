# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples on meshes."""

import importlib.util
import os
import re
import unittest

import numpy as np
import support
import vtkdgg
from support import BUMPY, HAS_CLOUDS, TETRAHEDRON, number_of_colours, run


class Pipeline(unittest.TestCase):
    def test_picture(self):
        picture = os.path.join(support.output_folder("pipeline"), "bumpy.png")
        result = run("exact_distance_pipeline.py", BUMPY, 3, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("642 points", result.stdout)
        self.assertGreater(number_of_colours(picture), 500)


class DrawsPictures:
    """A script that draws pictures of a mesh into a folder; those of some names, if there are any."""

    def draw(self, script, count):
        result = run(script, BUMPY, support.output_folder(script[:-3]))
        self.assertEqual(result.returncode, 0, result.stderr)
        written = re.findall(r"Written: (.*)", result.stdout)
        self.assertEqual(len(written), count)
        for path in written:
            with self.subTest(path):
                self.assertGreater(number_of_colours(path), 500)
        return result.stdout


class Gallery(DrawsPictures, unittest.TestCase):
    def test_pictures(self):
        self.draw("gallery.py", 8)


class Tutorial(unittest.TestCase):
    @support.needs_clouds
    def test_pictures(self):
        folder = support.output_folder("tutorial")
        result = run("tutorial.py", folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        length, top, across = re.fullmatch(
            r"(\S+) km, (\S+) km high, .*\nthe neck is \S+ around, (\S+) across\n", result.stdout
        ).groups()
        self.assertGreater(float(length), np.hypot(9.39, 5.27))  # the straight line
        self.assertLess(float(top), 1.0)
        self.assertAlmostEqual(float(across), 0.77, delta=0.03)
        for name in ("terrain", "vessel", "part", "scan"):
            with self.subTest(name):
                picture = os.path.join(folder, f"tutorial_{name}.png")
                self.assertGreater(number_of_colours(picture), 200)


class ExplorerPictures(DrawsPictures, unittest.TestCase):
    def test_pictures(self):
        said = self.draw("explorer_pictures.py", 6)
        self.assertRegex(said, r"642 points, distances by fast: nothing is promised")
        self.assertRegex(said, r"promised 1 %, measured \S+ % on average")


class Patches(unittest.TestCase):
    def test_two_surfaces(self):
        picture = os.path.join(support.output_folder("patches"), "patches.png")
        stretched = os.path.join(support.output_folder("patches"), "stretched.vtp")
        points, triangles = support.bumpy()
        vtkdgg.write(stretched, support.polydata(points * [1.0, 2.0, 0.7], triangles))
        result = run("patch_boundaries.py", BUMPY, stretched, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [line.split() for line in result.stdout.splitlines()[1:]]
        self.assertEqual(len(rows), 12)
        for row in rows:
            self.assertLess(0.7 * float(row[3]), float(row[4]))
            self.assertLess(float(row[4]), 2.1 * float(row[3]))
        self.assertEqual(support.read_image(picture).GetDimensions(), (1200, 600, 1))
        # Curves in many colours on both halves: what is neither white nor grey.
        for half in np.hsplit(support.pixels(picture), 2):
            colourful = np.ptp(half[:, :, :3], axis=2) > 100
            self.assertGreater(colourful.sum(), 1000)


class Graph(unittest.TestCase):
    def test_two_queries(self):
        picture = os.path.join(support.output_folder("pipeline"), "graph.png")
        result = run("graph_pipeline.py", BUMPY, 3, 600, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\d+ edges, \d+\.\d per point\nfrom point 3: up to \d")
        self.assertEqual(support.read_image(picture).GetDimensions(), (1200, 600, 1))
        halves = np.hsplit(support.pixels(picture), 2)
        # The same surface twice, in other colours.
        background = [np.all(half == 255, axis=2) for half in halves]
        self.assertLess(np.mean(background[0] != background[1]), 1e-4)
        differ = np.any(halves[0] != halves[1], axis=2)
        self.assertGreater(differ[~background[0]].mean(), 0.5)

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
        array = support.pixels(picture)
        self.assertGreater(number_of_colours(picture), 1000)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(np.sum((red > 130) & (green < 60) & (blue < 70)), 1000)
        self.assertGreater(np.sum((blue > 80) & (red < 50) & (green < 60)), 1000)
        self.assertGreater(np.mean((green > red + 10) & (green > blue + 10)), 0.2)


class Voronoi(unittest.TestCase):
    def test_cells(self):
        picture = os.path.join(support.output_folder("pipeline"), "cells.png")
        result = run("voronoi_cells.py", BUMPY, 30, picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\A30 cells, areas from \d")
        energy = re.search(r"energy (\S+), after \d+ iterations (\S+)", result.stdout)
        self.assertLess(float(energy[2]), float(energy[1]))
        self.assertGreater(number_of_colours(picture), 500)


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
        array = support.pixels(picture)
        red, green, blue = (array[:, :, i] for i in range(3))
        self.assertGreater(np.sum((blue > 60) & (red < 60)), 5000)
        self.assertGreater(np.sum((red > 120) & (green < 60) & (blue < 60)), 1500)

    def test_mesh(self):
        picture = os.path.join(support.output_folder("pipeline"), "isolines_mesh.png")
        result = run("isolines.py", picture, "--mesh", BUMPY, "--sources", "3", "40")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(result.stdout.splitlines()), 4)


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
        array = support.pixels(picture)
        self.assertEqual(array.shape[:2], (364, 1500))
        panels = [array[:, 300 * k + 1 : 300 * k + 299, :3] for k in range(5)]
        differences = [np.abs(panel[64:] - panels[0][64:]).mean() for panel in panels]
        self.assertLess(5.0 * differences[4], min(differences[1:4]))


class VectorGraphics(unittest.TestCase):
    def test_painted_vase(self):
        picture = os.path.join(support.output_folder("pipeline"), "vector_graphics.png")
        result = run("vector_graphics.py", picture, "--columns", "60", "--level", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        said = re.fullmatch(r"(\d+) curves on (\d+) points, colours at (\d+)\n", result.stdout)
        self.assertTrue(said, result.stdout)
        curves, before, after = map(int, said.groups())
        self.assertEqual((curves, before), (96, 60 * 34))
        self.assertGreater(after, 10 * before)
        array = support.pixels(picture)
        self.assertEqual(array.shape[:2], (760, 1280))
        # Rows from the bottom, as support.pixels() has them: the sun, the glaze and the last forest
        # of the painted vase, where plain clay is light in the left half.
        sun = array[400:480, 860:930, :3].reshape(-1, 3)
        self.assertGreater((sun.min(axis=1) > 220).sum(), 1500)
        for low, high in ((645, 655), (80, 90)):
            dark = array[low:high, 940:980, :3].mean(axis=(0, 1))
            self.assertGreater(dark[2], 1.2 * dark[0])
            self.assertLess(dark.max(), 110)
            self.assertGreater(array[low:high, 300:340, :3].mean(), 1.5 * dark.max())


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
        array = support.pixels(picture)
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


# By script: wrong arguments, and a part of the message.
VIEW = ("x.png", "--view")
MISTAKES = {
    "exact_distance_pipeline.py": (
        ((), "Usage"),
        (("missing.ply", 0, "x.png"), "missing.ply"),
        ((BUMPY, 642, "x.png"), "642"),
        ((BUMPY, -1, "x.png"), "-1"),
        ((BUMPY, "1.5", "x.png"), "1.5"),
        ((BUMPY, 10**30, "x.png"), "out of range"),
    ),
    "explorer_pictures.py": (
        ((BUMPY,), "Usage"),
        (("missing.ply", "."), "missing.ply"),
        ((BUMPY, ".", "other"), ""),
    ),
    "gallery.py": (
        ((BUMPY,), "Usage"),
        (("missing.ply", "."), "missing.ply"),
        ((BUMPY, ".", "other"), "'other' is none of the pictures"),
    ),
    "graph_csr.py": (((BUMPY, 642), "source id 642"),),
    "graph_pipeline.py": (
        ((), "Usage"),
        (("missing.ply", 0, 1, "x.png"), "missing.ply"),
        ((BUMPY, 0, 642, "x.png"), "642"),
        ((BUMPY, 0, 10**30, "x.png"), "out of range"),
    ),
    "greens_function.py": tuple((("--level", level), level) for level in ("0", "7", "many")),
    "isolines.py": (
        ((), "picture"),
        (("x.png", "--mesh", "missing.ply"), "missing.ply"),
        (("x.png", "--mesh", BUMPY, "--sources", "-1"), "-1"),
        (("x.png", "--mesh", BUMPY, "--sources", "642"), "642"),
        (("x.png", "--mesh", BUMPY, "--sources", "9" * 30), "out of range"),
        (("x.png", "--count", "-1"), "from 1 to 10000"),
        (("x.png", "--count", "0"), "from 1 to 10000"),
        (("x.png", "--count", "many"), "'many' is not an integer"),
        ((*VIEW, "1,2"), "X,Y,Z"),
        ((*VIEW, "1,2,nan"), "not finite"),
    ),
    "loops.py": (
        ((), "picture"),
        (("x.png", "--mesh", "missing.ply"), "missing.ply"),
        (("x.png", "--rope", "1,2"), "--rope"),
        ((*VIEW, "0,inf,1"), "not finite"),
        (("x.png", "--rope", "1,0,0 1,0.3,0"), "three points"),
        (("x.png", "--width", "-1"), "TapeWidth"),
    ),
    "patch_boundaries.py": (
        ((), "Usage"),
        ((BUMPY, "missing.ply", "x.png"), "missing.ply"),
        ((BUMPY, TETRAHEDRON, "x.png"), ""),
    ),
    "terrain_path.py": (((), "Usage: terrain_path.py"),),
    "tutorial.py": (((), "Usage"),),
    "vector_graphics.py": ((("--columns", "3"), "3"), (("--level", "many"), "many")),
    "vector_graphics_bunny.py": (
        (("x.png", BUMPY), "this is no bunny"),
        (("x.png", "missing.obj"), "no such file"),
        (("--level", "many"), "'many' is not an integer"),
    ),
    "voronoi_cells.py": (
        ((), "Usage"),
        (("missing.ply", 5, "x.png"), "missing.ply"),
        ((BUMPY, 0, "x.png"), "at least 1"),
        ((BUMPY, "a", "b"), "not an integer"),
    ),
    "cloud_cells.py": (
        ((), "Usage"),
        (("missing.pcd", 5, "x.png"), "missing.pcd: no such file"),
        ((BUMPY, 0, "x.png"), "at least 1"),
        ((BUMPY, "a", "x.png"), "not an integer"),
    ),
}


class Mistakes(unittest.TestCase):
    def test_all(self):
        for script, cases in MISTAKES.items():
            if script == "cloud_cells.py" and not HAS_CLOUDS:
                continue
            for arguments, message in cases:
                with self.subTest(script=script, arguments=arguments):
                    result = run(script, *arguments)
                    self.assertNotEqual(result.returncode, 0)
                    self.assertIn(message, result.stderr)
                    self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
