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

FOLDER = support.output_folder("pipeline")


class Examples(unittest.TestCase):
    def output(self, script, *arguments):
        """Runs a script, and returns the texts that it prints."""
        result = run(script, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout, result.stderr

    def draw(self, script, *arguments):
        """Runs a script that draws a picture, the argument "PICTURE". Returns the text that it
        prints and the colors of the picture."""
        picture = os.path.join(FOLDER, f"{script}.png")
        words = [picture if word == "PICTURE" else word for word in arguments]
        said, _ = self.output(script, *words)
        return said, support.pixels(picture)

    def find(self, pattern, text):
        """Returns the numbers in the groups of a pattern that the whole text matches."""
        self.assertRegex(text, rf"\A(?:{pattern})\Z")
        return [float(number) for number in re.fullmatch(pattern, text).groups()]

    def check_folder(self, said, count):
        """Checks the pictures that a script lists."""
        written = re.findall(r"Written: (.*)", said)
        self.assertEqual(len(written), count)
        for path in written:
            with self.subTest(path):
                self.assertGreater(number_of_colours(path), 500)

    def test_galleries(self):
        folder = support.output_folder("gallery")
        self.check_folder(self.output("gallery.py", BUMPY, folder)[0], 8)
        said = self.output("explorer_pictures.py", BUMPY, folder)[0]
        self.check_folder(said, 6)
        self.assertRegex(said, r"642 points, distances by fast: nothing is promised")
        self.assertRegex(said, r"promised 1 %, measured \S+ % on average")

    @support.needs_clouds
    def test_tutorial(self):
        folder = support.output_folder("tutorial")
        pattern = r"(\S+) km, (\S+) km high, .*\nthe neck is \S+ around, (\S+) across\n"
        length, top, across = self.find(pattern, self.output("tutorial.py", folder)[0])
        self.assertGreater(length, np.hypot(9.39, 5.27))  # the straight line
        self.assertLess(top, 1.0)
        self.assertAlmostEqual(across, 0.77, delta=0.03)
        for name in ("terrain", "vessel", "part", "scan"):
            with self.subTest(name):
                picture = os.path.join(folder, f"tutorial_{name}.png")
                self.assertGreater(number_of_colours(picture), 200)

    def test_exact_distance(self):
        said, colors = self.draw("exact_distance_pipeline.py", BUMPY, 3, "PICTURE")
        self.assertIn("642 points", said)
        self.assertGreater(len(np.unique(colors.reshape(-1, 3), axis=0)), 500)

    def test_patches(self):
        stretched = os.path.join(FOLDER, "stretched.vtp")
        points, triangles = support.bumpy()
        vtkdgg.write(stretched, support.polydata(points * [1.0, 2.0, 0.7], triangles))
        said, colors = self.draw("patch_boundaries.py", BUMPY, stretched, "PICTURE")
        rows = [line.split() for line in said.splitlines()[1:]]
        self.assertEqual(len(rows), 12)
        for row in rows:
            self.assertTrue(0.7 * float(row[3]) < float(row[4]) < 2.1 * float(row[3]))
        self.assertEqual(colors.shape, (600, 1200, 3))
        # Curves in many colors on both halves: neither white nor gray.
        for half in np.hsplit(colors, 2):
            self.assertGreater((np.ptp(half, axis=2) > 100).sum(), 1000)

    def test_graph(self):
        said, colors = self.draw("graph_pipeline.py", BUMPY, 3, 600, "PICTURE")
        self.assertRegex(said, r"\d+ edges, \d+\.\d per point\nfrom point 3: up to \d")
        self.assertEqual(colors.shape, (600, 1200, 3))
        # The same surface twice, in other colors.
        halves = np.hsplit(colors, 2)
        background = [np.all(half == 255, axis=2) for half in halves]
        self.assertLess(np.mean(background[0] != background[1]), 1e-4)
        differ = np.any(halves[0] != halves[1], axis=2)
        self.assertGreater(differ[~background[0]].mean(), 0.5)

    @unittest.skipUnless(importlib.util.find_spec("scipy"), "SciPy is not installed")
    def test_scipy(self):
        said = self.output("graph_csr.py", BUMPY, 5)[0]
        edges, difference, correction = (
            float(re.search(pattern, said)[1])
            for pattern in (
                r"642 points, (\d+) edges",
                r"difference to SciPy: (\S+)",
                r"largest correction: (\S+)",
            )
        )
        self.assertGreater(edges, 642 * 20)
        self.assertLess(difference, 1e-12)
        self.assertGreater(correction, 1e-4)

    def test_terrain(self):
        said, colors = self.draw("terrain_path.py", "PICTURE")
        pattern = r"on the surface: (\S+) km\nalong mesh edges: (\S+) km, (\S+) % longer\n"
        length, edges, excess = self.find(pattern, said)
        self.assertAlmostEqual(100.0 * (edges / length - 1.0), excess, delta=0.06)
        self.assertGreater(excess, 4.0)
        module = support.example("terrain_path")
        terrain = module.make_terrain()
        ends = [module.closest_point(terrain, place) for place in (module.START, module.END)]
        self.assertAlmostEqual(length, vtkdgg.path(terrain, *ends).length, delta=6e-4)
        # Both paths and the ground are visible.
        red, green, blue = np.moveaxis(colors, -1, 0)
        self.assertGreater(np.sum((red > 130) & (green < 60) & (blue < 70)), 1000)
        self.assertGreater(np.sum((blue > 80) & (red < 50) & (green < 60)), 1000)
        self.assertGreater(np.mean((green > red + 10) & (green > blue + 10)), 0.2)

    def test_voronoi(self):
        said, colors = self.draw("voronoi_cells.py", BUMPY, 30, "PICTURE")
        self.assertRegex(said, r"\A30 cells, areas from \d")
        energy = re.search(r"energy (\S+), after \d+ iterations (\S+)", said)
        self.assertLess(float(energy[2]), float(energy[1]))
        self.assertGreater(len(np.unique(colors.reshape(-1, 3), axis=0)), 500)

    def test_isolines(self):
        said, colors = self.draw("isolines.py", "PICTURE")
        rows = re.findall(r"([\w ]+): (\d+) lines of (\d+) points, (\d+) ridges\n", said)
        names = {"linear", "Apollonius", "local sources", "exact"}
        self.assertEqual({row[0] for row in rows}, names)
        self.assertEqual(len(rows), 8, said)
        # One source on a smooth surface: one line each.
        self.assertEqual([row[1] for row in rows[:4]], ["14"] * 4)
        self.assertEqual(rows[0][3], "0")
        self.assertGreater(int(rows[3][3]), 1)
        # Arcs take more points than straight lines in triangles.
        self.assertGreater(int(rows[3][2]), 2 * int(rows[0][2]))
        red, green, blue = np.moveaxis(colors, -1, 0)
        self.assertGreater(np.sum((blue > 60) & (red < 60)), 5000)
        self.assertGreater(np.sum((red > 120) & (green < 60) & (blue < 60)), 1500)
        said, _ = self.draw("isolines.py", "PICTURE", "--mesh", BUMPY, "--sources", "3", "40")
        self.assertEqual(len(said.splitlines()), 4)

    def test_greens_function(self):
        errors = {}
        for level in (4, 3):
            said, colors = self.draw("greens_function.py", "PICTURE", "--level", level)
            found = re.findall(r"(.*): error (\S+) %\n", said)
            self.assertEqual(len(found), 4, said)
            errors[level] = own = {name: float(error) for name, error in found}
            self.assertGreater(own["vertex"], own["interpolated"])
            self.assertLess(20.0 * own["singularity subtraction"], own["localized"])
        for name in ("vertex", "singularity subtraction"):
            self.assertLess(errors[4][name], 0.7 * errors[3][name])
        # Above the captions, the last panel is nearly the first one; the others are not.
        self.assertEqual(colors.shape, (364, 1500, 3))
        panels = [colors[:, 300 * k + 1 : 300 * k + 299] for k in range(5)]
        differences = [np.abs(panel[64:] - panels[0][64:]).mean() for panel in panels]
        self.assertLess(5.0 * differences[4], min(differences[1:4]))

    def test_vector_graphics(self):
        said, colors = self.draw("vector_graphics.py", "PICTURE", "--columns", "60", "--level", "1")
        pattern = r"(\d+) curves on (\d+) points, colours at (\d+)\n"
        curves, before, after = self.find(pattern, said)
        self.assertEqual((curves, before), (96, 60 * 34))
        self.assertGreater(after, 10 * before)
        self.assertEqual(colors.shape, (760, 1280, 3))
        # The sun, the glaze and the last forest of the painted vase; the clay on the left is light.
        sun = colors[400:480, 860:930].reshape(-1, 3)
        self.assertGreater((sun.min(axis=1) > 220).sum(), 1500)
        for low, high in ((645, 655), (80, 90)):
            dark = colors[low:high, 940:980].mean(axis=(0, 1))
            self.assertGreater(dark[2], 1.2 * dark[0])
            self.assertLess(dark.max(), 110)
            self.assertGreater(colors[low:high, 300:340].mean(), 1.5 * dark.max())

    def test_loops(self):
        said, colors = self.draw("loops.py", "PICTURE")
        pattern = r"4 loops around handles: lengths (\S+) (\S+) (\S+) (\S+)\n"
        pattern += r"1 ropes: lengths (\S+)\n"
        lengths = self.find(pattern, said)
        # The two rings are alike, up to the position of the grid.
        self.assertAlmostEqual(lengths[0], lengths[1], delta=2e-3)
        self.assertAlmostEqual(lengths[2], lengths[3], delta=2e-3)
        # Around the waist, a little more than twice across.
        self.assertAlmostEqual(lengths[4], 4.0 * 0.015**0.25 + 0.2, delta=0.08)
        # Loops, rope and tape are visible.
        red, green, blue = np.moveaxis(colors, -1, 0)
        self.assertGreater(np.sum((blue > 80) & (red < 40)), 1500)
        self.assertGreater(np.sum((red > 120) & (green < 50) & (blue < 60)), 800)
        self.assertGreater(np.sum((red > 160) & (green > 90) & (blue < 60)), 300)
        # Nothing holds a rope on this mesh, which has no handles: a message, and no error.
        picture = os.path.join(FOLDER, "rope.png")
        rope = "--rope", "-1,0,0 0,1,0 0,0,1"
        said, complained = self.output("loops.py", picture, "--mesh", BUMPY, *rope)
        self.assertIn("0 loops around handles", said)
        self.assertIn("contracts to a point", complained)


# Wrong arguments and a part of the message, by script.
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
    "graph_csr.py": (((BUMPY, 642), "Source id 642"),),
    "graph_pipeline.py": (
        ((), "Usage"),
        (("missing.ply", 0, 1, "x.png"), "missing.ply"),
        ((BUMPY, 0, 642, "x.png"), "642"),
    ),
    "greens_function.py": tuple((("--level", level), level) for level in ("0", "7", "many")),
    "isolines.py": (
        ((), "picture"),
        (("x.png", "--mesh", "missing.ply"), "missing.ply"),
        (("x.png", "--mesh", BUMPY, "--sources", "-1"), "-1"),
        (("x.png", "--mesh", BUMPY, "--sources", "642"), "642"),
        (("x.png", "--count", "-1"), "from 1 to 10000"),
        (("x.png", "--count", "0"), "from 1 to 10000"),
        ((*VIEW, "1,2"), "X,Y,Z"),
        ((*VIEW, "1,2,nan"), "not finite"),
    ),
    "loops.py": (
        ((), "picture"),
        (("x.png", "--mesh", "missing.ply"), "missing.ply"),
        (("x.png", "--rope", "1,2"), "--rope"),
        (("x.png", "--rope", "1,0,0 1,0.3,0"), "three different points"),
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
    ),
    "voronoi_cells.py": (
        ((), "Usage"),
        (("missing.ply", 5, "x.png"), "missing.ply"),
        ((BUMPY, 0, "x.png"), "at least 1"),
    ),
    "cloud_cells.py": (
        ((), "Usage"),
        (("missing.pcd", 5, "x.png"), "missing.pcd: no such file"),
        ((BUMPY, 0, "x.png"), "at least 1"),
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
