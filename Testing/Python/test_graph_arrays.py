# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays of vtkdgg.Graph, as NumPy and SciPy see them."""

import unittest
import unittest.mock

import numpy as np
import support
import vtkdgg

try:
    import scipy.sparse
    import scipy.sparse.csgraph
except ImportError:
    scipy = None


class Arrays(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.grid(5, 5)
        self.points = np.vstack([self.points, [[9.0, 9.0, 9.0]]])
        self.graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.1)

    def test_rows(self):
        offsets, targets, lengths = self.graph.offsets, self.graph.targets, self.graph.lengths
        types = (offsets.dtype, targets.dtype, lengths.dtype)
        self.assertEqual(types, (np.int64, np.int32, np.float32))
        self.assertEqual(offsets.shape, (38,))
        self.assertEqual((offsets[0], offsets[-1]), (0, len(targets)))
        self.assertEqual(offsets[-2], len(targets))  # the last point is in no triangle
        tails = np.repeat(np.arange(37), np.diff(offsets))
        straight = np.linalg.norm(self.points[tails] - self.points[targets], axis=1)
        np.testing.assert_allclose(lengths, straight, rtol=2e-7)
        self.assertTrue((lengths >= straight * (1 - 1e-15)).all())
        edges = set(zip(tails, targets, lengths))
        self.assertEqual(edges, {(b, a, length) for a, b, length in edges})
        self.assertAlmostEqual(self.graph.degree, len(targets) / 37.0)

    def test_wide_lengths(self):
        graph = vtkdgg.Graph(*support.folded(), accuracy=5e-6)
        self.assertEqual(graph.lengths.dtype, np.float64)
        self.assertAlmostEqual(graph.lengths.max(), np.sqrt(5.0), delta=1e-12)

    def test_views_cannot_be_written_to(self):
        for name in ("points", "offsets", "targets", "lengths"):
            with self.subTest(name), self.assertRaises(ValueError):
                getattr(self.graph, name)[0] = 1
        self.assertTrue(np.shares_memory(self.graph.lengths, self.graph.lengths))

    def test_views_outlive_the_graph(self):
        lengths = self.graph.lengths
        kept = lengths.copy()
        del self.graph
        np.testing.assert_array_equal(lengths, kept)

    def test_description(self):
        graph = self.graph
        self.assertEqual(graph.number_of_points, 37)
        self.assertEqual(graph.accuracy, 0.1)
        self.assertEqual(graph.construction, "Guaranteed")
        edges = len(graph.targets)
        self.assertEqual(graph.nbytes, 38 * 8 + edges * 16 + 12 * 8)
        text = repr(graph)
        for word in ("vtkdgg.Graph", "37 points", f"{edges} edges", "accuracy 0.1", "MiB"):
            self.assertIn(word, text)
        self.assertNotIn("\n", text)

    def test_constructions(self):
        edges = set()
        for name in ("Guaranteed", "OneRelay", "Indirect"):
            graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.1, construction=name)
            self.assertEqual(graph.construction, name)
            self.assertEqual(graph.accuracy, 0.1)
            self.assertIn(name, repr(graph))
            edges.add(len(graph.targets))
        for neighbors in (5, 10):
            graph = vtkdgg.Graph(
                *support.bumpy(), construction="SaddleVertexGraph", number_of_neighbors=neighbors
            )
            self.assertEqual(graph.construction, "SaddleVertexGraph")
            self.assertIsNone(graph.accuracy)
            self.assertNotIn("accuracy", repr(graph))
            self.assertGreaterEqual(graph.degree, neighbors)
            edges.add(len(graph.targets))
        self.assertEqual(len(edges), 5)

    def test_without_scipy(self):
        hidden = {"scipy": None, "scipy.sparse": None}
        with unittest.mock.patch.dict("sys.modules", hidden):
            with self.assertRaisesRegex(ImportError, "Graph.csr needs SciPy"):
                _ = self.graph.csr
        self.assertEqual(self.graph.distance(0)[0], 0.0)


@unittest.skipIf(scipy is None, "SciPy is not installed")
class Csr(unittest.TestCase):
    def setUp(self):
        self.graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.05)

    def test_dijkstra(self):
        matrix = self.graph.csr
        self.assertIsInstance(matrix, scipy.sparse.csr_matrix)
        self.assertEqual(matrix.shape, (642, 642))
        self.assertEqual(matrix.nnz, len(self.graph.targets))
        self.assertEqual(abs(matrix - matrix.T).max(), 0.0)
        for source in (0, 77):
            expected = scipy.sparse.csgraph.dijkstra(matrix, indices=source)
            raw = self.graph.distance(source, correction=False)
            np.testing.assert_allclose(raw, expected, rtol=1e-12)

    def test_it_may_be_changed(self):
        targets, lengths = self.graph.targets.copy(), self.graph.lengths.copy()
        expected = self.graph.distance(3)
        matrix = self.graph.csr
        matrix.sort_indices()
        matrix.data[:] = 0.0
        matrix.eliminate_zeros()
        np.testing.assert_array_equal(self.graph.targets, targets)
        np.testing.assert_array_equal(self.graph.lengths, lengths)
        self.assertEqual(self.graph.csr.nnz, len(targets))
        self.graph.distance(4)
        np.testing.assert_array_equal(self.graph.distance(3), expected)


if __name__ == "__main__":
    unittest.main()
