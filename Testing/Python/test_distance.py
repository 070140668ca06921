# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.distance on NumPy arrays: arguments, results and errors."""

import unittest

import numpy as np
import support
import vtkdgg


class Distance(support.Test):
    """On a plane rectangle, in which distances are straight."""

    POINTS, TRIANGLES = support.grid(6, 4)

    def distance(self, sources, **options):
        return vtkdgg.distance(self.POINTS, self.TRIANGLES, sources, **options)

    def straight(self, *places):
        return np.min([np.linalg.norm(self.POINTS - p, axis=1) for p in places], axis=0)

    def check_equal(self, distances, expected):
        self.assertEqual((distances.dtype, distances.shape), (np.float64, expected.shape))
        np.testing.assert_allclose(distances, expected, rtol=1e-12, atol=1e-14)

    def test_sources(self):
        one, two = self.straight(self.POINTS[17]), self.straight(*self.POINTS[[3, 20]])
        for source in (17, np.int32(17), np.array(17)):
            self.check_equal(self.distance(source), one)
        for sources in ([3, 20], (3, 20), np.array([3, 20], dtype=np.uint8), np.ma.array([3, 20])):
            self.check_equal(self.distance(sources), two)
        # At a point, on an edge, in a triangle.
        for place in ([2.0, 1.0, 0.0], [2.5, 1.0, 0.0], [2.3, 1.1, 0.0]):
            for sources in (place, [place]):
                self.check_equal(self.distance(sources), self.straight(place))
        places = np.array([[0.25, 0.5, 0.0], [5.5, 3.125, 0.0]])
        self.check_equal(self.distance(places), self.straight(*places))

    def test_initial_distances_and_nearest_sources(self):
        ids, offsets = [0, 34], np.array([1.5, 0.25])
        each = [self.straight(self.POINTS[i]) + offset for i, offset in zip(ids, offsets)]
        for method in (None, "graph", "fast", "marching"):
            for sources in (ids, self.POINTS[ids]):
                with self.subTest(method=method, sources=np.shape(sources)):
                    distances, nearest = self.distance(
                        sources, return_source=True, initial_distances=offsets, method=method
                    )
                    tolerance = 1e-9 if method is None else 0.05
                    np.testing.assert_allclose(distances, np.min(each, axis=0), atol=tolerance)
                    clear = np.abs(each[0] - each[1]) > 2 * tolerance
                    np.testing.assert_array_equal(nearest[clear], np.argmin(each, axis=0)[clear])
        found = self.distance(ids, return_source=True, as_polydata=True)
        self.assertTrue(found.GetPointData().HasArray("GeodesicSource"))

    def test_types_of_arrays(self):
        points, triangles = self.POINTS.copy(), self.TRIANGLES.copy()
        expected = self.straight(points[5])
        for first in (points, points.tolist(), points.astype(np.float32), points.T.copy().T):
            for second in (triangles.tolist(), *map(triangles.astype, (np.uint32, object))):
                self.check_equal(vtkdgg.distance(first, second, 5), expected)
        np.testing.assert_array_equal(points, self.POINTS)
        np.testing.assert_array_equal(triangles, self.TRIANGLES)

    def test_limits(self):
        expected = self.straight(self.POINTS[0])
        found = self.distance(0, maximum_distance=2.5, unreached=-1.0)
        self.check_equal(found, np.where(expected <= 2.5, expected, -1.0))
        self.assertTrue(np.isnan(self.distance(0, maximum_distance=2.5)[-1]))
        self.check_equal(self.distance(0, maximum_distance=np.inf), expected)
        above = [[2.0, 1.0, 0.5]]
        pattern = "`projection_tolerance` 0.01 .* or raise `projection_tolerance`"
        for accuracy in (None, 0.01):
            options = {"accuracy": accuracy}
            self.refuse(
                lambda: self.distance(above, **options), ((), pattern), error=vtkdgg.Error
            )
            distances = self.distance(above, projection_tolerance=0.1, **options)
            np.testing.assert_allclose(
                distances, self.straight([2, 1, 0]), rtol=0.01, atol=1e-6
            )

    def test_methods(self):
        straight = self.straight(self.POINTS[3])
        for method, tolerance in (("exact", 1e-12), ("fast", 1e-5), ("graph", 1e-2)):
            found = self.distance(3, method=method)
            np.testing.assert_allclose(found, straight, rtol=tolerance)
        rough = self.distance(3, accuracy=0.3)
        self.assertGreater(np.abs(rough - straight).max(), 1e-9)
        np.testing.assert_array_less(np.abs(rough - straight), 0.3 * straight + 1e-6)
        wrong = {"method": "fast", "accuracy": 0.1}
        wrong = [{"method": "quick"}, {"method": ["fast"]}, {"method": 1}, wrong]
        self.refuse(lambda **given: self.distance(3, **given), *((w, "method") for w in wrong))
        points = np.random.default_rng(1).random((3000, 3)) * [1.0, 1.0, 0.0]
        found = vtkdgg.distance(points, [], 7, method="marching")
        expected = np.linalg.norm(points - points[7], axis=1)
        np.testing.assert_allclose(found, expected, rtol=0.1, atol=0.01)

    def test_seams_and_gaps(self):
        points, triangles = support.two_squares([1.0, 0.0, 0.0])
        with self.assertWarnsRegex(RuntimeWarning, "Turn on `merge_coincident_points`"):
            self.assertTrue(np.isnan(vtkdgg.distance(points, triangles, 0)[7]))
        merged = {"merge_coincident_points": True}
        for accuracy in (None, 0.01):
            distances = vtkdgg.distance(points, triangles, 0, accuracy=accuracy, **merged)
            self.assertAlmostEqual(distances[7], np.sqrt(5.0), delta=1e-5)
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [1.0 + 1e-7, 0.0, 0.0], points + [2.0, 1e-7, 0.0]])
        triangles = np.vstack([triangles, triangles + 4, triangles + 8])
        pattern = "4 of 12 points .* Turn on `merge_coincident_points` with a `merge_tolerance` of 1e-06"
        with self.assertWarnsRegex(RuntimeWarning, pattern):
            self.assertTrue(np.isnan(vtkdgg.distance(points, triangles, 0)[4]))
        merged["merge_tolerance"] = 1e-6
        distances = vtkdgg.distance(points, triangles, 0, **merged)
        path = vtkdgg.path(points, triangles, 0, 11, **merged)
        np.testing.assert_allclose([distances[11], path.length], np.sqrt(10.0), atol=1e-6)

    def test_empty_mesh(self):
        for points, triangles in (([], []), (np.empty((0, 3)), np.empty((0, 3), dtype=int))):
            for mesh in ((points, triangles), ((points, triangles),)):
                self.check_equal(vtkdgg.distance(*mesh, sources=0), np.empty(0))
        self.assertEqual(len(vtkdgg.distance([], [], 0, return_source=True)), 2)


class WrongInput(support.Test):
    """vtkdgg.distance and vtkdgg.Graph refuse the same."""

    POINTS, TRIANGLES = support.grid(2, 2)

    def refuse_all(self, name, *cases, **others):
        """Expects errors that name an argument."""

        def of_function(value):
            given = {"points": self.POINTS, "triangles": self.TRIANGLES, "sources": 0, **others}
            return vtkdgg.distance(**{**given, name: value})

        def of_graph(value):
            given = {"points": self.POINTS, "triangles": self.TRIANGLES}
            if name in (*given, "accuracy"):
                return vtkdgg.Graph(**{**given, name: value})
            return vtkdgg.Graph(**given).distance(**{"sources": 0, **others, name: value})

        for call in (of_function, of_graph):
            self.refuse(call, *(((value,), f"{name}.*{pattern}") for value, pattern in cases))

    def test_points(self):
        bad = self.POINTS.copy()
        bad[4, 1] = np.inf
        self.refuse_all(
            "points",
            (self.POINTS[:, :2], r"expected the shape \(n, 3\), got \(9, 2\)"),
            (self.POINTS.ravel(), "expected the shape"),
            ([[0, 0, 0], [1, 0]], "expected an array of numbers, got elements of unequal"),
            ([["a", "b", "c"]], "expected numbers"),
            (self.POINTS.astype(complex), "expected numbers"),
            (self.POINTS + np.nan, "row 0 is not finite"),
            (bad, "row 4 is not finite"),
            (np.ma.masked_equal(self.POINTS, 2.0), "has masked entries"),
        )

    def test_triangles(self):
        self.refuse_all(
            "triangles",
            ([[0, 1]], r"expected the shape \(m, 3\)"),
            ([[0.0, 1.0, 2.0]], "expected integers, got float64"),
            ([[True, False, True]], "expected integers, got bool"),
            ([[0, 1, 2], [3, 4, 9]], r"point id 9 \(entry 1, 2\)"),
            ([[-1, 1, 2]], r"point id -1 \(entry 0, 0\)"),
            ([[0, 1, 2**64]], "does not fit"),
            (np.ma.masked_equal(self.TRIANGLES, 1), "has masked entries"),
        )
        for call in (lambda *mesh: vtkdgg.distance(*mesh, 0), vtkdgg.Graph):
            self.refuse(call, ((self.POINTS, []), "no polygons"), error=vtkdgg.Error)

    def test_sources(self):
        self.refuse_all(
            "sources",
            (9, r"point id 9 \(entry 0\)"),
            ([0, -1], r"point id -1 \(entry 1\)"),
            ([], "expected at least one"),
            (1.0, "expected point ids"),
            ([0.5, 0.5], "expected point ids"),
            ([[0, 1, 2]], "expected point ids"),  # ids or coordinates?
            ([True, False], "expected numbers, got bool"),
            (True, "expected numbers, got bool"),
            ("first", "expected numbers"),
            ({0}, "expected numbers, got set"),
            ([0, None], "expected numbers, got NoneType"),
            (None, "missing"),
            ([[0.0, 1.0]], r"expected the shape \(n, 3\)"),
            ([[np.nan, 0.0, 0.0]], "row 0 is not finite"),
            (2**70, "1180591620717411303424 does not fit into 64 bits"),
            ([1, -(2**70)], "-1180591620717411303424 does not fit"),
            (np.ma.masked_equal(np.arange(3), 1), "has masked entries"),
        )
        pattern = r"sources\[0\]: expected a face id .* got True"
        sources = (True, (1.0, 0.0, 0.0))
        self.refuse(vtkdgg.distance, ((self.POINTS, self.TRIANGLES, sources), pattern))
        one = [[0, 0, 0]]
        self.refuse(vtkdgg.distance, ((one, one, 1), "there is 1 point$"))

    def test_numbers(self):
        names = "unreached", "projection_tolerance", "accuracy", "maximum_distance"
        for name in names:
            for value in ("x", "1", [1, 2], 10**400):
                self.refuse_all(name, (value, "expected a number"))
            if name != "unreached":
                self.refuse_all(name, *((x, f"is {x:g}. Use a number") for x in (-0.1, np.nan)))
        self.refuse_all(
            "accuracy", *((x, "Use a number from 1e-06 to 0.5") for x in (0.0, 1e-7, 0.51, np.inf))
        )

    def test_initial_distances(self):
        self.refuse_all(
            "initial_distances",
            ([1.0], "expected one number or 2"),
            ([[1.0, 2.0]], "expected one number or 2"),
            ([], "expected one number or 2"),
            ([0.0, np.nan], "entry 1"),
            ("ab", "expected numbers"),
            sources=[0, 1],
        )
        self.refuse_all("initial_distances", ([1.0, 2.0], "expected one number"))


if __name__ == "__main__":
    unittest.main()
