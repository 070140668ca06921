# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths: vtkdgg.path and vtkdgg.Graph.path."""

import pickle
import unittest

import numpy as np
import support
import vtkdgg

ACCURACY = 0.02


class Bumpy(unittest.TestCase):
    """On a bumpy sphere."""

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=ACCURACY)
        cls.size = np.ptp(cls.points, axis=0).max()

    def check_on_surface(self, path):
        """Every piece lies in its triangle, and the length is that of the pieces."""
        self.assertEqual(path.points.shape, (len(path.faces), 3))
        self.assertEqual(path.points.dtype, np.float64)
        corners = self.points[self.triangles[path.faces]]
        for ends in (path.points[:-1], path.points[1:]):
            edges = corners[:-1, 1:] - corners[:-1, :1]
            # Least squares, and what is left.
            normal = np.linalg.pinv(edges.transpose(0, 2, 1))
            weights = np.einsum("kij,kj->ki", normal, ends - corners[:-1, 0])
            self.assertTrue((weights >= -1e-9).all() and (weights.sum(axis=1) <= 1 + 1e-9).all())
            rest = ends - corners[:-1, 0] - np.einsum("ki,kij->kj", weights, edges)
            self.assertLess(np.abs(rest).max(), 1e-9 * self.size)
        pieces = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
        np.testing.assert_allclose(path.arc_lengths, np.append(0, np.cumsum(pieces)), atol=1e-9)
        self.assertAlmostEqual(path.length, pieces.sum(), delta=1e-9)
        at_points = path.point_ids >= 0
        np.testing.assert_array_equal(
            path.points[at_points], self.points[path.point_ids[at_points]]
        )

    def test_exact(self):
        exact = vtkdgg.distance(self.points, self.triangles, 5)
        for end in (0, 17, 318, 641):
            path = vtkdgg.path(self.points, self.triangles, 5, end)
            self.check_on_surface(path)
            self.assertAlmostEqual(path.length, exact[end], delta=1e-9)
            self.assertEqual((path.point_ids[0], path.point_ids[-1]), (5, end))
            self.assertTrue(np.isnan(path.graph_length))

    def test_graph(self):
        exact = vtkdgg.distance(self.points, self.triangles, 5)
        bent = 0
        for end in (0, 17, 318, 500, 641):
            path = self.graph.path(5, end)
            rough = self.graph.path(5, end, straighten=False)
            for p in (path, rough):
                self.check_on_surface(p)
                self.assertEqual((p.point_ids[0], p.point_ids[-1]), (5, end))
                self.assertGreaterEqual(p.length, exact[end] * (1 - 1e-9))
            self.assertLessEqual(path.length, rough.length * (1 + 1e-9))
            self.assertLessEqual(rough.length, path.graph_length * (1 + 1e-9))
            self.assertLessEqual(path.graph_length, exact[end] * (1 + ACCURACY) * (1 + 1e-6))
            self.assertAlmostEqual(
                path.graph_length, self.graph.matrix(5, end)[0, 0], delta=1e-9 * self.size
            )
            bent += rough.length > path.length * (1 + 1e-9)
        self.assertGreater(bent, 0)
        finder = self.graph._filters[vtkdgg.vtkDGGPath]
        self.assertTrue(finder.GetUsedInputGraph())
        self.assertEqual(finder.GetNumberOfFallbacks(), 0)

    def test_one_call_with_a_graph(self):
        path = vtkdgg.path(self.points, self.triangles, 5, 318, accuracy=ACCURACY)
        expected = self.graph.path(5, 318)
        np.testing.assert_array_equal(path.points, expected.points)
        self.assertEqual(path.graph_length, expected.graph_length)

    def test_places(self):
        weights = np.array([[0.2, 0.3, 0.5], [0.0, 0.4, 0.6], [0.98, 0.01, 0.01]])
        places = np.einsum("ij,ijk->ik", weights, self.points[self.triangles[[7, 400, 900]]])
        for start, end in ((places[0], places[1]), (17, places[2]), (places[1], 318)):
            exact = vtkdgg.path(self.points, self.triangles, start, end)
            path = self.graph.path(list(start) if np.ndim(start) else np.int16(start), end)
            for p in (exact, path):
                self.check_on_surface(p)
                for given, found in ((start, p.points[0]), (end, p.points[-1])):
                    where = given if np.ndim(given) else self.points[given]
                    np.testing.assert_allclose(found, where, atol=1e-9)
            self.assertLessEqual(exact.length, path.length * (1 + 1e-9))
            self.assertLessEqual(path.length, exact.length * (1 + ACCURACY) * (1 + 1e-6))
        # Calls do not remember places or ids of earlier ones.
        self.assertEqual(self.graph.path(5, 5).length, 0.0)

    def test_the_other_way(self):
        there = vtkdgg.path(self.points, self.triangles, 5, 318)
        back = vtkdgg.path(self.points, self.triangles, 318, 5)
        self.assertAlmostEqual(there.length, back.length, delta=1e-9)

    def test_detour(self):
        lengths = [self.graph.path(5, 318, detour=detour).length for detour in (0, 1e-3, 0.1)]
        self.assertTrue((np.diff(lengths) <= 1e-9).all())
        for detour in (-0.1, 0.2, np.nan, "far"):
            with self.assertRaisesRegex(ValueError, "detour"):
                self.graph.path(5, 318, detour=detour)

    def test_results_are_copies(self):
        path = self.graph.path(5, 318)
        kept = path.points.copy()
        path.points[:] = 7.0
        path.faces[:] = -9
        again = self.graph.path(5, 318)
        np.testing.assert_array_equal(again.points, kept)
        self.assertTrue((again.faces >= 0).all())

    def test_after_pickle(self):
        copy = pickle.loads(pickle.dumps(self.graph))
        self.assertEqual(copy.path(5, 318).length, self.graph.path(5, 318).length)

    def test_all_queries_in_turn(self):
        # Filters of one Graph do not disturb each other.
        graph = vtkdgg.Graph(self.points, self.triangles, accuracy=ACCURACY)
        expected = graph.distance(5)
        length = graph.path(5, 318).length
        np.testing.assert_array_equal(graph.distance(5), expected)
        graph.matrix([5], [318])
        self.assertEqual(graph.path(5, 318).length, length)


class Small(unittest.TestCase):
    POINTS = [[0, 0, 0], [3, 0, 0], [0, 4, 0]]

    def test_one_triangle(self):
        graph = vtkdgg.Graph(self.POINTS, [[0, 1, 2]])
        for path in (vtkdgg.path(self.POINTS, [[0, 1, 2]], 1, 2), graph.path(1, 2)):
            self.assertAlmostEqual(path.length, 5.0, delta=1e-12)
            np.testing.assert_array_equal(path.points, [[3, 0, 0], [0, 4, 0]])
            np.testing.assert_array_equal(path.faces, [0, 0])
            np.testing.assert_array_equal(path.point_ids, [1, 2])
            self.assertEqual(repr(path), "<vtkdgg.Path: length 5, 2 points>")

    def test_coincident_ends(self):
        for place in (1, [1.0, 1.0, 0.0]):
            path = vtkdgg.path(self.POINTS, [[0, 1, 2]], place, place)
            self.assertEqual((path.length, len(path.points)), (0.0, 1))
            self.assertEqual(repr(path), "<vtkdgg.Path: length 0, 1 point>")

    def test_not_connected(self):
        points = self.POINTS + [[9, 0, 0], [9, 1, 0], [8, 0, 0], [1, 1, 0]]
        triangles = [[0, 1, 2], [3, 4, 5]]
        graph = vtkdgg.Graph(points, triangles)
        for start, end in (
            (0, 3),
            (0, 6),
            ([1.0, 0.5, 0.0], [8.5, 0.2, 0.0]),
            (4, [1.0, 0.0, 0.0]),
            ([1.0, 0.5, 0.0], 6),  # on the surface, but not connected with it
        ):
            with self.subTest(start=start, end=end):
                for find in (lambda *ends: vtkdgg.path(points, triangles, *ends), graph.path):
                    with self.assertRaisesRegex(ValueError, "not connected by the surface"):
                        find(start, end)
        self.assertAlmostEqual(graph.path(3, 5).length, 1.0, delta=1e-9)

    def test_seams(self):
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]]
        triangles = [[0, 1, 2], [3, 4, 5]]
        path = vtkdgg.path(points, triangles, 0, 5, merge_coincident_points=True)
        self.assertAlmostEqual(path.length, np.sqrt(2.0), delta=1e-12)
        path = vtkdgg.path(points, triangles, 4, [0.0, 0.0, 0.0], merge_coincident_points=True)
        self.assertEqual(path.point_ids[0], 1)  # the first of both
        with self.assertRaisesRegex(ValueError, "not connected .* merge_coincident_points"):
            vtkdgg.path(points, triangles, 0, 5)
        path = vtkdgg.path(points, triangles, 4, [0.9, 0.9, 0.0])
        self.assertAlmostEqual(path.length, np.hypot(0.1, 0.9), delta=1e-12)

    def test_mistakes(self):
        graph = vtkdgg.Graph(self.POINTS, [[0, 1, 2]])
        for start, end, pattern in (
            (0, 3, r"end: point id 3 .*does not exist"),
            (-1, 0, r"start: point id -1 .*does not exist"),
            (0, 1.5, "end: expected a point id"),
            ([0, 1], 0, "start: expected a point id"),
            ([0, 0, 1], 0, "start: expected a point id"),  # three ids, or coordinates?
            ([[0, 1, 2]], 0, "start: expected a point id"),
            (True, 0, "start: expected numbers"),
            ("a", 0, "start: expected numbers"),
            (0, [0, 0, np.nan], "end: row 0 is not finite"),
        ):
            with self.subTest(start=start, end=end):
                with self.assertRaisesRegex(ValueError, pattern):
                    graph.path(start, end)
                with self.assertRaisesRegex(ValueError, pattern):
                    vtkdgg.path(self.POINTS, [[0, 1, 2]], start, end)
        with self.assertRaisesRegex(vtkdgg.VTKError, "end, at .*projection_tolerance"):
            graph.path(0, [1.0, 1.0, 1.0])
        with self.assertRaisesRegex(vtkdgg.VTKError, "start 1, at .*projection_tolerance"):
            graph.paths([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]], 0)
        self.assertEqual(graph.path(0, [1.0, 1.0, 1.0], projection_tolerance=1).points[-1, 2], 0.0)
        with self.assertRaisesRegex(ValueError, "projection_tolerance"):
            graph.path(0, 1, projection_tolerance=-1)
        with self.assertRaisesRegex(ValueError, "start: expected .* got a list"):
            vtkdgg.path(self.POINTS, [[0, 1, 2]], [(0, (0.2, 0.3, 0.5))], 1)
        with self.assertRaisesRegex(ValueError, "accuracy: expected a number"):
            vtkdgg.path(self.POINTS, [[0, 1, 2]], 0, 1, accuracy=0.7)


if __name__ == "__main__":
    unittest.main()
