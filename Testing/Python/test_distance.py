# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.distance(): the one-liner on numpy arrays."""

import unittest

import numpy as np
import support
import vtkdgg


class Distance(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.grid(6, 4)

    def straight(self, *places):
        """In a plane rectangle the distance is the straight one."""
        return np.min([np.linalg.norm(self.points - p, axis=1) for p in places], axis=0)

    def check_equal(self, distances, expected):
        self.assertEqual(distances.dtype, np.float64)
        self.assertEqual(distances.shape, expected.shape)
        np.testing.assert_allclose(distances, expected, rtol=1e-12, atol=1e-14)

    def test_one_id(self):
        for source in (0, np.int32(17), np.array(34)):
            with self.subTest(source=source):
                distances = vtkdgg.distance(self.points, self.triangles, source)
                self.check_equal(distances, self.straight(self.points[int(source)]))

    def test_several_ids(self):
        expected = self.straight(self.points[3], self.points[20])
        for sources in ([3, 20], (3, 20), np.array([3, 20]), np.array([3, 20], dtype=np.uint8)):
            with self.subTest(sources=type(sources)):
                self.check_equal(vtkdgg.distance(self.points, self.triangles, sources), expected)

    def test_coordinates(self):
        # At a point, on an edge, in a triangle.
        for place in ([2.0, 1.0, 0.0], [2.5, 1.0, 0.0], [2.3, 1.1, 0.0]):
            with self.subTest(place=place):
                distances = vtkdgg.distance(self.points, self.triangles, [place])
                self.check_equal(distances, self.straight(place))
        places = np.array([[0.25, 0.5, 0.0], [5.5, 3.125, 0.0]])
        distances = vtkdgg.distance(self.points, self.triangles, places)
        self.check_equal(distances, self.straight(*places))

    def test_one_place(self):
        for place in ([2.0, 1.0, 0.0], [[2.0, 1.0, 0.0]]):
            distances = vtkdgg.distance(self.points, self.triangles, place)
            self.check_equal(distances, self.straight([2, 1, 0]))

    def test_initial_distances_and_nearest_sources(self):
        ids, offsets = [0, 34], np.array([1.5, 0.25])
        each = [self.straight(self.points[i]) + offset for i, offset in zip(ids, offsets)]
        for method in (None, "graph", "fast", "marching"):
            options = {"initial_distances": offsets, "method": method}
            for sources in (ids, self.points[ids]):
                with self.subTest(method=method, sources=np.shape(sources)):
                    distances, nearest = vtkdgg.distance(
                        self.points, self.triangles, sources, return_source=True, **options
                    )
                    tolerance = 1e-9 if method is None else 0.05
                    np.testing.assert_allclose(distances, np.min(each, axis=0), atol=tolerance)
                    clear = np.abs(each[0] - each[1]) > 2 * tolerance
                    np.testing.assert_array_equal(nearest[clear], np.argmin(each, axis=0)[clear])
        found = vtkdgg.distance(
            self.points, self.triangles, ids, return_source=True, as_polydata=True
        )
        self.assertTrue(found.GetPointData().HasArray("GeodesicSource"))
        self.assertEqual(len(vtkdgg.distance([], [], 0, return_source=True)), 2)

    def test_around_a_corner(self):
        # The unit cube: from a corner to the opposite one along two faces.
        corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
        quads = [
            [0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]
        ]  # fmt: skip
        triangles = [t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])]
        distances = vtkdgg.distance(corners, triangles, 0)
        self.assertAlmostEqual(distances[7], np.sqrt(5.0), delta=1e-12)
        self.assertAlmostEqual(distances[3], np.sqrt(2.0), delta=1e-12)

    def test_types_of_arrays(self):
        expected = vtkdgg.distance(self.points, self.triangles, 5)
        for points in (
            self.points.tolist(),
            self.points.astype(np.float32),
            self.points.T.copy().T,
        ):
            for triangles in (
                self.triangles.tolist(),
                self.triangles.astype(np.uint32),
                self.triangles.astype(object),
            ):
                distances = vtkdgg.distance(points, triangles, 5)
                self.check_equal(distances, expected)

    def test_arrays_are_not_changed(self):
        points, triangles = self.points.copy(), self.triangles.copy()
        vtkdgg.distance(points, triangles, 5)
        np.testing.assert_array_equal(points, self.points)
        np.testing.assert_array_equal(triangles, self.triangles)

    def test_maximum_distance(self):
        expected = self.straight(self.points[0])
        distances = vtkdgg.distance(self.points, self.triangles, 0, maximum_distance=2.5)
        near = expected <= 2.5
        np.testing.assert_allclose(distances[near], expected[near], rtol=1e-12)
        self.assertTrue(np.isnan(distances[~near]).all())
        self.assertTrue(near.any() and not near.all())
        unlimited = vtkdgg.distance(self.points, self.triangles, 0, maximum_distance=np.inf)
        self.check_equal(unlimited, expected)

    def test_accuracy(self):
        expected = self.straight(self.points[3], self.points[30])
        sources = self.points[[3, 30]]
        errors = []
        for accuracy in (0.3, 0.001):
            distances = vtkdgg.distance(self.points, self.triangles, sources, accuracy=accuracy)
            self.assertEqual(distances.dtype, np.float64)
            np.testing.assert_array_less(np.abs(distances - expected), accuracy * expected + 1e-6)
            errors.append(np.abs(distances - expected).max())
        # Had they been computed exactly, there would be none.
        self.assertGreater(max(errors), 1e-9)

    def test_methods(self):
        straight = self.straight(self.points[3])
        for method, tolerance in (("exact", 1e-12), ("fast", 1e-5), ("graph", 1e-2)):
            found = vtkdgg.distance(self.points, self.triangles, 3, method=method)
            np.testing.assert_allclose(found, straight, rtol=tolerance)
        for wrong in (
            {"method": "quick"},
            {"method": ["fast"]},
            {"method": 1},
            {"method": "fast", "accuracy": 0.1},
        ):
            with self.assertRaisesRegex(ValueError, "method"):
                vtkdgg.distance(self.points, self.triangles, 3, **wrong)

    def test_marching_on_a_cloud(self):
        points = np.random.default_rng(1).random((3000, 3)) * [1.0, 1.0, 0.0]
        found = vtkdgg.distance(points, [], 7, method="marching")
        self.assertEqual(found[7], 0.0)
        straight = np.linalg.norm(points - points[7], axis=1)
        np.testing.assert_allclose(found, straight, rtol=0.1, atol=0.01)

    def test_unreached(self):
        points = np.vstack([self.points, [[9.0, 9.0, 9.0]]])
        distances = vtkdgg.distance(points, self.triangles, 0, unreached=-1.0)
        self.assertEqual(distances[-1], -1.0)
        self.check_equal(distances[:-1], self.straight(self.points[0]))
        self.assertTrue(np.isnan(vtkdgg.distance(points, self.triangles, 0)[-1]))

    def test_seams(self):
        # Two squares along a common side whose points exist twice.
        points, triangles = support.two_squares([1.0, 0.0, 0.0])
        with self.assertWarnsRegex(RuntimeWarning, "set merge_coincident_points=True"):
            self.assertTrue(np.isnan(vtkdgg.distance(points, triangles, 0)[7]))
        for accuracy, delta in ((None, 1e-12), (0.01, 1e-5)):
            distances = vtkdgg.distance(
                points, triangles, 0, accuracy=accuracy, merge_coincident_points=True
            )
            self.assertAlmostEqual(distances[7], np.sqrt(5.0), delta=delta)

    def test_gaps(self):
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [1.0 + 1e-7, 0.0, 0.0], points + [2.0, 1e-7, 0.0]])
        triangles = np.vstack([triangles, triangles + 4, triangles + 8])
        pattern = "only 4 of 12 points .* set merge_coincident_points=True, and a merge_tolerance of 1e-06"
        with self.assertWarnsRegex(RuntimeWarning, pattern):
            self.assertTrue(np.isnan(vtkdgg.distance(points, triangles, 0)[4]))
        merged = {"merge_coincident_points": True, "merge_tolerance": 1e-6}
        distances = vtkdgg.distance(points, triangles, 0, **merged)
        self.assertAlmostEqual(distances[11], np.sqrt(10.0), delta=1e-6)
        self.assertAlmostEqual(
            vtkdgg.path(points, triangles, 0, 11, **merged).length, np.sqrt(10.0), delta=1e-6
        )

    def test_projection_tolerance(self):
        above = [[2.0, 1.0, 0.5]]
        for accuracy in (None, 0.01):
            with self.assertRaisesRegex(
                vtkdgg.VTKError, "projection_tolerance 0.01 .* or raise projection_tolerance"
            ):
                vtkdgg.distance(self.points, self.triangles, above, accuracy=accuracy)
            distances = vtkdgg.distance(
                self.points, self.triangles, above, accuracy=accuracy, projection_tolerance=0.1
            )
            expected = self.straight([2.0, 1.0, 0.0])
            np.testing.assert_allclose(distances, expected, rtol=0.01, atol=1e-6)

    def test_warnings_name_the_caller(self):
        # Three triangles on one edge.
        points = np.vstack([np.zeros(3), np.eye(3), [[0.0, -1.0, 0.0]]])
        with self.assertWarnsRegex(RuntimeWarning, "more than two triangles") as caught:
            distances = vtkdgg.distance(points, [[0, 1, 2], [0, 1, 3], [0, 1, 4]], 2)
        self.assertEqual(caught.filename, __file__)
        np.testing.assert_allclose(distances[3:], [2.0, 2.0], rtol=1e-12)

    def test_empty_mesh(self):
        for points, triangles in (([], []), (np.empty((0, 3)), np.empty((0, 3), dtype=int))):
            for mesh in ((points, triangles), ((points, triangles),)):
                distances = vtkdgg.distance(*mesh, sources=0)
                self.assertEqual(distances.shape, (0,))
                self.assertEqual(distances.dtype, np.float64)


class WrongInput(unittest.TestCase):
    """vtkdgg.distance and vtkdgg.Graph refuse the same."""

    POINTS, TRIANGLES = support.grid(2, 2)

    def refuses(self, pattern, points=POINTS, triangles=TRIANGLES, sources=0, **options):
        of_graphs = {name: options[name] for name in options if name == "accuracy"}
        of_queries = {name: options[name] for name in options if name != "accuracy"}
        for call in (
            lambda: vtkdgg.distance(points, triangles, sources, **options),
            lambda: vtkdgg.Graph(points, triangles, **of_graphs).distance(sources, **of_queries),
        ):
            with self.subTest(pattern), self.assertRaisesRegex(ValueError, pattern):
                call()

    def test_points(self):
        bad = self.POINTS.copy()
        bad[4, 1] = np.inf
        for points, pattern in (
            (self.POINTS[:, :2], r"expected the shape \(n, 3\), got \(9, 2\)"),
            (self.POINTS.ravel(), "expected the shape"),
            ([[0, 0, 0], [1, 0]], "expected an array of numbers, got elements of unequal"),
            ([["a", "b", "c"]], "expected numbers"),
            (self.POINTS.astype(complex), "expected numbers"),
            (self.POINTS + np.nan, "row 0 is not finite"),
            (bad, "row 4 is not finite"),
            (np.ma.masked_equal(self.POINTS, 2.0), "has masked entries"),
        ):
            self.refuses(f"points: {pattern}", points)

    def test_triangles(self):
        for triangles, pattern in (
            ([[0, 1]], r"expected the shape \(m, 3\)"),
            ([[0.0, 1.0, 2.0]], "expected integers, got float64"),
            ([[True, False, True]], "expected integers, got bool"),
            ([[0, 1, 2], [3, 4, 9]], r"point id 9 \(entry 1, 2\)"),
            ([[-1, 1, 2]], r"point id -1 \(entry 0, 0\)"),
            ([[0, 1, 2**64]], "does not fit"),
            (np.ma.masked_equal(self.TRIANGLES, 1), "has masked entries"),
        ):
            self.refuses(f"triangles: .*{pattern}", triangles=triangles)

    def test_sources(self):
        for sources, pattern in (
            (9, r"point id 9 \(entry 0\)"),
            ([0, -1], r"point id -1 \(entry 1\)"),
            ([], "expected at least one"),
            (1.0, "expected point ids"),
            ([0.5, 0.5], "expected point ids"),
            ([[0, 1, 2]], "expected point ids"),  # ids or coordinates?
            ([True, False], "expected numbers, got bool"),
            (True, "expected numbers, got bool"),
            ("first", "expected numbers"),
            (None, "missing"),
            ([[0.0, 1.0]], r"expected the shape \(n, 3\)"),
            ([[np.nan, 0.0, 0.0]], "row 0 is not finite"),
            (2**70, "1180591620717411303424 does not fit into 64 bits"),
            ([1, -(2**70)], "-1180591620717411303424 does not fit"),
            (np.ma.masked_equal(np.arange(3), 1), "has masked entries"),
        ):
            self.refuses(f"sources: {pattern}", sources=sources)
        pattern = r"sources\[0\]: expected a face id .* got True"
        self.refuses(pattern, sources=(True, (1.0, 0.0, 0.0)))
        # Nothing is hidden here.
        distances = vtkdgg.distance(self.POINTS, self.TRIANGLES, np.ma.array([0, 1]))
        self.assertEqual(distances[1], 0.0)

    def test_numbers(self):
        names = "unreached", "projection_tolerance", "accuracy", "maximum_distance"
        for name in names:
            for value in ("x", "1", [1, 2], 10**400):
                self.refuses(f"{name}: expected a number", **{name: value})
        self.refuses("unreached: expected a number, got None", unreached=None)
        for name in names[1:]:
            for value in (-0.1, np.nan):
                self.refuses(f"{name}: expected a number ", **{name: value})
        for accuracy in (0.0, 1e-7, 0.51, np.inf):
            pattern = rf"accuracy: expected a number in \[1e-6, 0.5\], got {accuracy:g}"
            self.refuses(pattern, accuracy=accuracy)

    def test_initial_distances(self):
        for given, pattern in (
            ([1.0], "expected one number or 2"),
            ([[1.0, 2.0]], "expected one number or 2"),
            ([], "expected one number or 2"),
            ([0.0, np.nan], "entry 1"),
            ("ab", "expected numbers"),
        ):
            self.refuses(f"initial_distances: {pattern}", sources=[0, 1], initial_distances=given)
        self.refuses("initial_distances: expected one number", initial_distances=[1.0, 2.0])

    def test_one_point(self):
        with self.assertRaisesRegex(ValueError, "there is 1 point$"):
            vtkdgg.distance([[0, 0, 0]], [[0, 0, 0]], 1)

    def test_points_without_triangles(self):
        for call in (lambda *mesh: vtkdgg.distance(*mesh, 0), vtkdgg.Graph):
            with self.assertRaisesRegex(vtkdgg.VTKError, "no polygons"):
                call(self.POINTS, [])


if __name__ == "__main__":
    unittest.main()
