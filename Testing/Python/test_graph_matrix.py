# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.Graph.matrix: distances between all points of two sets."""

import unittest

import numpy as np
import support
import vtkdgg

ROUNDING = 1e-6  # of lengths, relative


class Matrix(unittest.TestCase):
    ACCURACY = 0.1

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.grid(9, 7)
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=cls.ACCURACY)

    def check(self, matrix, rows, columns):
        straight = np.linalg.norm(np.array(rows)[:, None] - np.array(columns), axis=2)
        self.assertEqual(matrix.shape, straight.shape)
        self.assertEqual(matrix.dtype, np.float64)
        self.assertTrue((matrix >= straight - 1e-9).all())
        self.assertTrue((matrix <= straight * (1 + self.ACCURACY) * (1 + ROUNDING) + 1e-9).all())

    def test_ids(self):
        rows, columns = [0, 5, 33], [1, 2, 5, 79, 57]
        matrix = self.graph.matrix(rows, columns)
        self.check(matrix, self.points[rows], self.points[columns])
        for i, row in enumerate(rows):
            field = self.graph.distance(row, correction=False)
            np.testing.assert_allclose(matrix[i], field[columns], rtol=1e-12)
        np.testing.assert_allclose(self.graph.matrix(columns, rows), matrix.T, rtol=1e-12)
        # Not exact distances.
        self.assertGreater(matrix[0, 4], 1.0001 * np.linalg.norm(self.points[57]))

    def test_one_set(self):
        rows = np.arange(0, 80, 7)
        matrix = self.graph.matrix(rows)
        self.check(matrix, self.points[rows], self.points[rows])
        np.testing.assert_array_equal(matrix, matrix.T)
        np.testing.assert_array_equal(np.diag(matrix), 0.0)
        detours = (matrix[:, :, None] + matrix[None]).min(axis=1)
        np.testing.assert_array_less(matrix, detours * (1 + 1e-12) + 1e-12)

    def test_single_points(self):
        self.check(self.graph.matrix(3, 60), self.points[[3]], self.points[[60]])
        self.check(self.graph.matrix([3, 4], 60), self.points[[3, 4]], self.points[[60]])
        self.check(self.graph.matrix(3, [60, 4]), self.points[[3]], self.points[[60, 4]])
        np.testing.assert_array_equal(self.graph.matrix(7), [[0.0]])

    def test_coordinates(self):
        places = np.array([[2.3, 1.1, 0.0], [2.4, 1.15, 0.0], [7.5, 6.0, 0.0]])
        self.check(self.graph.matrix(places), places, places)
        self.check(self.graph.matrix(places, [8, 9]), places, self.points[[8, 9]])
        self.check(self.graph.matrix(50, places), self.points[[50]], places)
        # Not those of the query before.
        self.check(self.graph.matrix([1, 2], [8, 9]), self.points[[1, 2]], self.points[[8, 9]])

    def test_results_are_copies(self):
        kept = self.graph.matrix([1, 2], [3, 4]).copy()
        self.graph.matrix([1, 2], [3, 4])[:] = 0.0
        np.testing.assert_array_equal(self.graph.matrix([1, 2], [3, 4]), kept)

    def test_unconnected(self):
        points = np.vstack([self.points, self.points + [20.0, 0.0, 0.0]])
        graph = vtkdgg.Graph(points, np.vstack([self.triangles, self.triangles + 80]))
        matrix = graph.matrix([0, 80], [1, 81])
        np.testing.assert_array_equal(np.isnan(matrix), [[False, True], [True, False]])
        self.assertEqual(graph.matrix([0, 80], [1, 81], unreached=-1.0)[0, 1], -1.0)

    def test_mistakes(self):
        for arguments, pattern in (
            ((80,), "rows: point id 80"),
            ((0, []), "columns: expected at least one"),
        ):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(ValueError, pattern):
                self.graph.matrix(*arguments)
        with self.assertRaisesRegex(vtkdgg.VTKError, "column point 0"):
            self.graph.matrix(0, [[0.0, 0.0, 5.0]])
        self.check(self.graph.matrix(0, 1), self.points[[0]], self.points[[1]])

    def test_memory_limit(self):
        limit = 2**20
        graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.5, memory_limit=limit)
        with self.assertRaisesRegex(vtkdgg.VTKError, "memory_limit"):
            graph.matrix(np.zeros(1000, dtype=int), np.zeros(1000, dtype=int))
        self.assertEqual(graph.matrix(0, 1).shape, (1, 1))


if __name__ == "__main__":
    unittest.main()
