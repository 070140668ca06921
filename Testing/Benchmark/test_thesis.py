# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the page of exhibits and of functions of exhibits; no exhibit is measured."""

import importlib.util
import json
import os
import shutil
import unittest
import unittest.mock

import measure_clouds
import measure_spheres
import numpy as np
import passrate
import plots
import thesis
import vtkdgg
from exhibits import surfaces
from exhibits.every import ALL, place
from exhibits.exhibit import (
    BETTER,
    FAILED,
    NOT_REGENERATED,
    REPRODUCED,
    WORSE,
    Exhibit,
    Verdict,
    judged,
)
from exhibits.fields import summary
from exhibits.laws import fit
from exhibits.local_triangles import local_triangles
from exhibits.run import Run, TooLong, limited_time
from Published import bidirectional, green_sums
from Published.delaunay_mesh import DelaunayMesh
from tables import slope
from test_tables import OUTPUT, PNG, cells_of

NAMES = (
    "T3.1 T3.2 T3.4 T5.1 T5.2 T5.3 T5.4 F1.1 F3.6 F3.7 F3.8 F3.9 F3.10 F3.11 F3.12 F3.13 F3.14 F3.15 "
    "F3.16 F3.18 F4.4 F4.5 F4.6 F4.7 F5.1 F5.2 F5.3 F5.9 F5.10 F5.11 F5.14 F5.15 F5.16 F5.17 F5.18 D1.1 D1.2 D1.3 D1.4 "
    "R1.1 R1.2 L1.1"
)


class Counting(Exhibit):
    """Counts its measurements."""


class Counted(Counting):
    name = "F9.1"
    title = "a count"
    published = "3 %."

    def __init__(self, problem=None):
        self.count = 0
        self.problem = problem

    def measure(self, run):
        if self.problem:
            raise self.problem
        self.count += 1
        run.mesh("sphere-0")
        run.uses("a point")
        return {"count": self.count, 2: (1, 2)}

    def table(self, figures):
        return f"| count |\n|---|\n| {figures['count']} |\n"

    def pictures(self, figures):
        def draw(path):
            with open(path, "w", encoding="utf-8") as file:
                return file.write("drawn")

        return {self.name: draw}

    def verdict(self, figures):
        return Verdict(judged(0.02, 0.03), "Less is better.")


def folder(name):
    path = os.path.join(OUTPUT, "thesis", name)
    shutil.rmtree(path, ignore_errors=True)
    return path


class Page(unittest.TestCase):
    def setUp(self):
        self.run = Run(folder("page"), "nowhere", reuse=True)

    def result(self, exhibit):
        found, verdict = thesis.measured(exhibit, self.run, lambda line: None)
        pictures = thesis.pictures_of(exhibit, found.figures, self.run.folder) if found else {}
        return exhibit, found, verdict, pictures

    def test_page(self):
        broken = Counted(ValueError("too small"))
        broken.name, broken.title = "T9.2", "what is not made"
        results = [self.result(Counted()), self.result(broken)]
        text = thesis.page(results, "A note.", "Images")
        self.assertIn("2 exhibits: 1 failed, 1 better.", text)
        self.assertIn("## Figure 9.1: a count\n\nCounts its measurements.", text)
        self.assertIn("*Published:* 3 %.", text)
        self.assertIn("| 1 |", text)
        self.assertIn("![a count](Images/thesis_f9_1.png)", text)
        self.assertIn("\nLess is better.\n", text)
        self.assertIn("\nValueError: too small\n", text)
        cells = cells_of(text.splitlines(), "[F9.1](#figure-91-a-count)", "exhibit")
        self.assertEqual(
            (cells["content"], cells["models"], cells["verdict"]),
            ("a count", "sphere-0, a point", BETTER),
        )

    def test_not_wanted(self):
        exhibit = Counted()

        def word():
            return thesis.measured(exhibit, self.run, self.fail, False)[1].word

        self.assertEqual((word(), exhibit.count), (NOT_REGENERATED, 0))
        self.result(exhibit)
        self.assertEqual((word(), exhibit.count), (BETTER, 1))

    def test_failures(self):
        for problem in (ValueError("too small"), TooLong("not done"), OSError("no such file")):
            _, found, verdict, pictures = self.result(Counted(problem))
            self.assertIsNone(found)
            self.assertEqual(pictures, {})
            self.assertEqual(verdict.word, FAILED)
            self.assertIn(str(problem), verdict.reason)

    def test_every_exhibit(self):
        names = [name for exhibit in ALL for name in exhibit.titles]
        self.assertEqual(sorted(names, key=place), NAMES.split())
        for exhibit in ALL:
            self.assertTrue(all(exhibit.titles.values()) and exhibit.published, exhibit.name)

    def test_chosen(self):
        self.assertEqual([e.name for e in thesis.chosen(["F3.10", "T3.2"])], ["T3.2", "F3.9"])
        with self.assertRaisesRegex(SystemExit, "unknown exhibit T1.9. Choose from D1.1, "):
            thesis.chosen(["F3.9", "T1.9"])


class Clouds(unittest.TestCase):
    def test_local_triangles(self):
        grid = np.indices((18, 18)).reshape(2, -1).T
        jitter = np.random.default_rng(3).uniform(-0.3, 0.3, grid.shape)
        points = np.pad((grid + jitter) / 17.0, ((0, 0), (0, 1)))
        tilted = points @ np.linalg.qr(np.random.default_rng(4).random((3, 3)))[0]
        triangles = local_triangles(vtkdgg.Mesh(tilted).as_polydata(), tilted)
        self.assertTrue((np.diff(triangles, axis=1) > 0).all())
        # In the interior the triangles are Delaunay: no point is inside a circumcircle.
        corners = points[triangles][:, :, :2]
        inner = (np.abs(corners - 0.5).max(axis=(1, 2)) < 0.3).nonzero()[0]
        self.assertGreater(len(inner), 100)
        for a, b, c in corners[inner]:
            middle = np.linalg.solve(2.0 * np.array([b - a, c - a]), [b @ b - a @ a, c @ c - a @ a])
            radius = np.linalg.norm(a - middle)
            self.assertGreater(
                np.linalg.norm(points[:, :2] - middle, axis=1).min(), radius * (1.0 - 1e-9)
            )
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [0, 2]]].reshape(-1, 2), axis=1)
        edges, counts = np.unique(sides, axis=0, return_counts=True)
        within = np.abs(points[edges][:, :, :2] - 0.5).max(axis=(1, 2)) < 0.3
        self.assertTrue((counts[within] == 2).all())

    def test_published(self):
        published = measure_clouds.published_of
        self.assertEqual(published("torus-57K", "C, arcs", 57000), (1.2e-3, 1.7e-3))
        self.assertEqual(published("torus-57K", "fast marching", 57000), (1.8e-2, 3.7e-2))
        self.assertIsNone(published("torus-9K", "C, arcs", 9000))
        self.assertIsNone(published("igea", "C, arcs", 134000))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_plots(self):
        errors = [(642, 1.0, 1.0), (2562, 0.5, 0.5), (10242, 0.25, 0.0625)]
        self.assertAlmostEqual(measure_spheres.order(errors), 2.0)
        self.assertIsNone(slope([(1.0, 1.0)]))
        spheres = {w: dict.fromkeys(measure_spheres.ERRORS, errors) for w in measure_spheres.WAYS}
        clouds = {"sphere": {"A, chords": {"Alpha": [(1.0, 0.5), (2.0, 0.1)], "Offset": []}}}
        os.makedirs(OUTPUT, exist_ok=True)
        draws = ((plots.draw_sphere_curves, spheres), (plots.draw_cloud_curves, clouds))
        for draw, curves in draws:
            path = os.path.join(OUTPUT, "plot.png")
            draw(curves, path)
            with open(path, "rb") as file:
                self.assertEqual(file.read(8), PNG)

    def test_fit(self):
        x = np.geomspace(0.01, 0.3, 20)
        found = fit(list(zip(x, 30.0 * x**2.4 + 0.02)))
        np.testing.assert_allclose([found.c, found.p, found.floor], [30.0, 2.4, 0.02], rtol=0.05)
        self.assertLess(found.off, 1.01)
        np.testing.assert_allclose(found.at(x), 30.0 * x**2.4 + 0.02, rtol=0.03)
        plain = fit(list(zip(x, 5.0 * x)))
        np.testing.assert_allclose([plain.c, plain.p], [5.0, 1.0], rtol=1e-9)
        self.assertEqual(plain.floor, 0.0)


class Results(unittest.TestCase):
    def test_kept(self):
        exhibit = Counted()
        path = folder("kept")

        def measured(**options):
            run = Run(path, "nowhere", **options)
            return run.kept(exhibit.name, lambda: exhibit.measure(run))

        found = measured(reuse=True)
        self.assertEqual(found.figures, {"count": 1, "2": [1, 2]})
        self.assertEqual(found.models, ["sphere-0", "a point"])
        self.assertEqual(measured(reuse=True), found)
        with open(os.path.join(path, "F9.1.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["figures"]["count"], 1)
        # Repeated measurements and other options do not use the kept result.
        for count, options in enumerate(
            ({}, {"full": True, "reuse": True}, {"data": "data", "reuse": True}), 2
        ):
            self.assertEqual(measured(**options).figures["count"], count)

    def test_shared(self):
        path = folder("shared")
        make = unittest.mock.Mock(side_effect=[{"a": 1}, {"a": 2}])
        runs = [Run(path, "nowhere", reuse=reuse) for reuse in (True, True, False)]
        self.assertEqual([run.shared("sum", make)["a"] for run in runs], [1, 1, 2])
        self.assertEqual(runs[0].shared("sum", make)["a"], 1)

    def test_models_of_shared_figures(self):
        path = folder("models")
        for _ in range(2):
            run = Run(path, "nowhere", reuse=True)
            for _ in range(2):
                found = run.measured(
                    lambda run=run: run.shared("sum", lambda: run.mesh("sphere-0") and 1)
                )
                self.assertEqual((found.figures, found.models), (1, ["sphere-0"]))
            self.assertEqual(run.measured(lambda: 2).models, [])

    def test_limited_time(self):
        with self.assertRaisesRegex(TooLong, "not done after 1 seconds"):
            with limited_time(1):
                while True:
                    pass

    def test_judged(self):
        self.assertEqual(judged(0.5, 1.0), BETTER)
        self.assertEqual(judged(0.9, 1.0), REPRODUCED)
        self.assertEqual(judged(2.2, 1.0, 2.0), REPRODUCED)
        self.assertEqual(judged(2.6, 1.0, 2.0), WORSE)

    def test_summary(self):
        exact = [np.array([0.0, 1.0, 2.0, np.inf]), np.array([1.0, 0.0, 2.0, 4.0])]
        found = [np.array([0.0, 1.1, 2.0, np.inf]), np.array([1.0, 0.0, 2.4, np.inf])]
        errors = summary(found, exact)
        self.assertAlmostEqual(errors["mean"], (0.1 + 0.2) / 4.0)
        self.assertAlmostEqual(errors["max"], 0.2)
        self.assertEqual(errors["missed"], 1)


class Surfaces(unittest.TestCase):
    def test_known(self):
        points, triangles = surfaces.icosphere(0)
        self.assertEqual((len(points), len(triangles)), (12, 20))
        self.assertAlmostEqual(surfaces.anisotropy(points, triangles), 1.0)
        total, is_rim = surfaces.total_angles(points, triangles)
        np.testing.assert_allclose(total, 5.0 * np.pi / 3.0)
        self.assertFalse(is_rim.any())

    def test_names(self):
        self.assertIsNone(surfaces.make("bunny"))
        plain, noisy, stretched = (
            surfaces.arrays_of(surfaces.make(f"bumpy-2{more}"))[0]
            for more in ("", "-noise-0.1", "-stretched-4")
        )
        self.assertEqual(plain.shape, (162, 3))
        self.assertFalse(np.allclose(plain, noisy))
        np.testing.assert_allclose(stretched, plain * [4.0, 1.0, 1.0], rtol=1e-6)
        points, triangles = surfaces.arrays_of(surfaces.make("terrain-5"))
        self.assertEqual(surfaces.total_angles(points, triangles)[1].sum(), 16)

    def test_parts_are_manifolds(self):
        defects = ("non_manifold_edges", "non_manifold_vertices", "degenerate_faces")
        for name in surfaces.parts.PARTS:
            with self.subTest(name=name):
                points, triangles = surfaces.make_arrays(name)
                report = vtkdgg._kernel.Surface(points, triangles).report()
                found = {key: report[f"number_of_{key}"] for key in defects}
                self.assertEqual(found, dict.fromkeys(defects, 0.0))
                self.assertEqual((report["number_of_components"], report["orientable"]), (1, 1))
                edges = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
                self.assertEqual(len(np.unique(edges, axis=0)), len(edges))  # one orientation
                self.assertTrue(200 <= len(points) <= 20000)

    def test_distances_are_those_of_a_sphere(self):
        mesh = surfaces.make("sphere-3")
        points, _ = surfaces.arrays_of(mesh)
        arcs = np.arccos(np.clip(points @ points[0], -1.0, 1.0))
        self.assertLess(np.abs(vtkdgg.distance(mesh, 0) - arcs).max(), 0.02)


class BothEnds(unittest.TestCase):
    def test_lengths(self):
        mesh = surfaces.make("bumpy-2")
        graph = vtkdgg.Graph(mesh, accuracy=0.05)
        read = bidirectional.arrays(graph)
        points, _ = surfaces.arrays_of(mesh)
        straight = np.linalg.norm(points - points[150], axis=1) * (1.0 - 1e-6)
        expected = graph.distance(3, correction=False)[150]
        settled = {}
        for name, (length, count) in {
            "one": bidirectional.one_sided(read, 3, 150),
            "star": bidirectional.one_sided(read, 3, 150, straight),
            "two": bidirectional.two_sided(read, 3, 150, False),
        }.items():
            self.assertAlmostEqual(length, expected, delta=1e-6 * expected)
            settled[name] = count
        self.assertLess(settled["star"], settled["one"])
        length, _ = bidirectional.two_sided(read, 3, 150, True)
        self.assertGreaterEqual(length, expected * (1.0 - 1e-6))


class AddedVertices(unittest.TestCase):
    def test_surface_and_angles(self):
        for name in ("bumpy-2-stretched-4", "terrain-8-stretched-0.2"):
            mesh = surfaces.make(name)
            points, triangles = surfaces.arrays_of(mesh)
            more, split = DelaunayMesh(points, triangles).arrays()
            self.assertGreater(len(more), len(points))
            np.testing.assert_array_equal(more[: len(points)], points)
            opposite = {}
            for corners, angles in zip(split, surfaces.corner_angles(more, split)):
                for i in range(3):
                    edge = tuple(sorted((corners[(i + 1) % 3], corners[(i + 2) % 3])))
                    opposite.setdefault(edge, []).append(angles[i])
            inner = [sum(angles) for angles in opposite.values() if len(angles) == 2]
            self.assertLess(max(inner), np.pi + 1e-6)
            # The refined mesh is the same surface.
            found = vtkdgg.distance(surfaces.from_arrays(more, split), 5)[: len(points)]
            np.testing.assert_allclose(found, vtkdgg.distance(mesh, 5), rtol=1e-5)


class GreenSums(unittest.TestCase):
    def test_colors(self):
        mesh = surfaces.make("sphere-3")
        points, triangles = surfaces.arrays_of(mesh)
        is_north = points[:, 2] > 0.3
        vertices = green_sums.beside(triangles, is_north)
        edge = surfaces.mean_edge(points, triangles)
        self.assertLess(np.abs(points[vertices, 2] - 0.3).max(), 1.3 * edge)
        colors = np.where(is_north[vertices], 1.0, 0.0)
        strengths, constant = green_sums.sources(mesh, vertices, colors)
        self.assertAlmostEqual(strengths.sum(), 0.0, 9)

        def found(places, method):
            return green_sums.colors_of(mesh, vertices, strengths, constant, places, method)

        np.testing.assert_allclose(found(points[vertices], "Interpolated"), colors, atol=1e-6)
        poles = points[[np.argmax(points[:, 2]), np.argmin(points[:, 2])]] * 0.999
        np.testing.assert_allclose(found(poles, "Localized"), [1.0, 0.0], atol=0.01)


class PassRate(unittest.TestCase):
    def test_folder(self):
        path = folder("passrate")
        run = Run(path, "nowhere")
        run.file("bumpy-2")
        with open(os.path.join(path, "broken.ply"), "w", encoding="utf-8") as file:
            file.write("no mesh")
        with open(os.path.join(path, "notes.txt"), "w", encoding="utf-8") as file:
            file.write("no mesh either")
        results = passrate.measure(path, (0.1, 0.01), say=lambda _: None)
        self.assertEqual([row["accuracy"] for row in results["rows"]], [0.1, 0.01])
        self.assertTrue(all(map(passrate.passes, results["rows"])))
        self.assertEqual([entry["mesh"] for entry in results["refused"]], ["broken.ply"])
        lines = passrate.tables(results).splitlines()
        self.assertEqual(lines[0], "2 of 2 graphs are within the bound.")
        row = cells_of(lines, "bumpy-2.ply", "mesh")
        self.assertEqual((row["vertices"], row["kept"]), ("162", "yes"))
        self.assertIn("line 1: the file does not begin", cells_of(lines, "broken.ply", "refused")["why"])

    def test_broken_promise(self):
        row = {"mesh": "ball", "vertices": 9, "tau": 1.0, "degree": 4.0, "accuracy": 0.01}
        results = {"rows": [{**row, "mean": 0.001, "max": 0.02}], "refused": []}
        self.assertEqual(
            cells_of(passrate.tables(results).splitlines(), "ball", "mesh")["kept"], "NO"
        )

    def test_nothing_there(self):
        with self.assertRaisesRegex(SystemExit, "nowhere is not a folder"):
            passrate.parse(("-", "-", "nowhere"))
        with self.assertRaisesRegex(SystemExit, "contains no mesh"):
            os.makedirs(folder("empty"))
            passrate.parse(("-", "-", os.path.join(OUTPUT, "thesis", "empty")))


if __name__ == "__main__":
    unittest.main()
