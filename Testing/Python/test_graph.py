# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.Graph: construction, distances, arrays as NumPy and SciPy see them, and graphs that a mesh
contains already."""

import os
import unittest

import numpy as np
import support
import vtkdgg
from support import warnings_as

try:
    import scipy.sparse
    import scipy.sparse.csgraph
except ImportError:
    scipy = None


class Distance(unittest.TestCase):
    """On a bumpy sphere."""

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=0.05)

    def test_promise(self):
        exact = vtkdgg.distance(self.points, self.triangles, 318)
        for correction in (True, False):
            found = self.graph.distance(318, correction=correction)
            self.assertEqual((found.dtype, found.shape), (np.float64, exact.shape))
            np.testing.assert_array_less(np.abs(found - exact), 0.05 * exact + 1e-6)
        self.assertTrue((found >= exact * (1 - 1e-9)).all())

    def test_options(self):
        """Sources and options are those of the function, which has a graph for one call."""
        weights = np.array([[0.2, 0.3, 0.5], [0.0, 0.4, 0.6], [0.98, 0.01, 0.01]])
        places = np.einsum("ij,ijk->ik", weights, self.points[self.triangles[[7, 400, 900]]])
        offsets = [0.5, 0.25, 0.75]
        for sources in ([5, 400, 90], places):
            options = {"initial_distances": offsets, "maximum_distance": 0.6, "unreached": -1.0}
            options["return_source"] = True
            found = self.graph.distance(sources, **options)
            expected = vtkdgg.distance(self.graph.polydata, sources, **options)
            for values, others in zip(found, expected):
                np.testing.assert_array_equal(values, others)
            self.assertEqual(set(found[1]), {-1, 0, 1})
            moved = self.graph.distance(sources, initial_distances=-2.0)
            expected = self.graph.distance(sources)  # without the options of the query before
            np.testing.assert_allclose(moved, expected - 2.0, rtol=1e-12, atol=1e-12)

    def test_arrays_are_copied(self):
        points, triangles = support.folded()
        mesh = vtkdgg.Mesh(points, triangles)
        for given, arrays in (
            ((points, triangles), (points, triangles)),
            ((mesh,), (mesh.points, *mesh.polygons)),
        ):
            graph = vtkdgg.Graph(*given)
            expected = graph.distance((2, (0.5, 0.25, 0.25)))
            for array in arrays:
                array[:] = 0
            np.testing.assert_array_equal(graph.distance((2, (0.5, 0.25, 0.25))), expected)

    def test_warnings_are_reported_once(self):
        # Three triangles on one edge.
        points = np.vstack([np.zeros(3), np.eye(3), [[0.0, -1.0, 0.0]]])
        with self.assertWarnsRegex(RuntimeWarning, "more than two triangles") as caught:
            graph = vtkdgg.Graph(points, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        self.assertEqual(caught.filename, __file__)
        with warnings_as("error"):
            graph.distance(2)
            graph.matrix(2, [3, 4])


class Arrays(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.grid(5, 5)
        self.points = np.vstack([self.points, [[9.0, 9.0, 9.0]]])
        self.graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.1)

    def test_rows(self):
        graph = self.graph
        offsets, targets, lengths = graph.offsets, graph.targets, graph.lengths
        types = (offsets.dtype, targets.dtype, lengths.dtype)
        self.assertEqual(types, (np.int64, np.int32, np.float32))
        self.assertEqual(offsets.shape, (38,))
        self.assertEqual(offsets[[0, -2, -1]].tolist(), [0, len(targets), len(targets)])
        tails = np.repeat(np.arange(37), np.diff(offsets))
        straight = np.linalg.norm(self.points[tails] - self.points[targets], axis=1)
        np.testing.assert_allclose(lengths, straight, rtol=2e-7)
        wide = vtkdgg.Graph(*support.folded(), accuracy=5e-6)
        self.assertEqual(wide.lengths.dtype, np.float64)
        self.assertEqual((graph.number_of_points, graph.accuracy), (37, 0.1))
        self.assertAlmostEqual(graph.degree, len(targets) / 37.0)
        self.assertEqual(graph.nbytes, 38 * 8 + len(targets) * 16 + 12 * 8)
        pattern = rf"vtkdgg.Graph: 37 points, {len(targets)} edges.* accuracy 0\.1.* MiB"
        self.assertRegex(repr(graph), pattern)

    def test_views(self):
        for name in ("points", "offsets", "targets", "lengths"):
            with self.subTest(name), self.assertRaises(ValueError):
                getattr(self.graph, name)[0] = 1
        lengths = self.graph.lengths
        self.assertTrue(np.shares_memory(self.graph.lengths, lengths))
        kept = lengths.copy()
        del self.graph
        np.testing.assert_array_equal(lengths, kept)

    def test_constructions(self):
        edges = set()
        for name, options in (
            ("Guaranteed", {}),
            ("OneRelay", {}),
            ("Indirect", {}),
            ("SaddleVertexGraph", {"number_of_neighbors": 5}),
            ("SaddleVertexGraph", {"number_of_neighbors": 10}),
        ):
            graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.1, construction=name, **options)
            self.assertEqual((graph.construction, graph.accuracy), (name, None if options else 0.1))
            self.assertEqual("accuracy" in repr(graph), not options)
            edges.add(len(graph.targets))
        self.assertEqual(len(edges), 5)

    @unittest.skipIf(scipy is None, "SciPy is not installed")
    def test_csr(self):
        graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.05)
        matrix = graph.csr
        self.assertIsInstance(matrix, scipy.sparse.csr_matrix)
        self.assertEqual((matrix.shape, matrix.nnz), ((642, 642), len(graph.targets)))
        expected = scipy.sparse.csgraph.dijkstra(matrix, indices=77)
        raw = graph.distance(77, correction=False)
        np.testing.assert_allclose(raw, expected, rtol=1e-12)
        # Changes of the matrix do not affect the graph.
        targets, lengths = graph.targets.copy(), graph.lengths.copy()
        matrix.sort_indices()
        matrix.data[:] = 0.0
        matrix.eliminate_zeros()
        np.testing.assert_array_equal(graph.targets, targets)
        np.testing.assert_array_equal(graph.lengths, lengths)


class GraphOnTheMesh(support.Test):
    """A graph in the field data of a mesh or cloud is used by default."""

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=0.05)
        cls.mesh = cls.graph.polydata

    def setUp(self):
        catcher = warnings_as("error")
        catcher.__enter__()
        self.addCleanup(catcher.__exit__, None, None, None)

    def test_functions(self):
        expected, exact = self.graph.distance(5), vtkdgg.distance(self.points, self.triangles, 5)
        np.testing.assert_array_equal(vtkdgg.distance(self.mesh, 5), expected)
        np.testing.assert_array_equal(vtkdgg.distance(self.mesh, 5, method="exact"), exact)
        self.assertFalse(np.isnan(vtkdgg.path(self.mesh, 5, 100).graph_length))
        path = vtkdgg.path(self.mesh, 5, 100, method="exact")
        self.assertTrue(np.isnan(path.graph_length))
        self.assertAlmostEqual(path.length, exact[100])
        self.refuse(
            lambda method: vtkdgg.path(self.mesh, 5, 100, method=method, accuracy=0.1),
            (("fast",), "'graph', got 'fast'"),
            (("exact",), "'graph' only"),
        )

    def test_graphs(self):
        file = os.path.join(support.output_folder("graph"), "used.vtp")
        vtkdgg.write(file, self.mesh)
        for mesh, options, accuracy, is_found in (
            (self.mesh, {}, 0.05, True),
            (file, {}, 0.05, True),
            (vtkdgg.read(file), {}, 0.05, True),
            (self.mesh, {"accuracy": 0.05}, 0.05, True),
            (self.mesh, {"accuracy": 0.01}, 0.01, False),
            (self.mesh, {"accuracy": 0.1}, 0.1, False),
            (self.mesh, {"construction": "OneRelay"}, 0.01, False),
        ):
            with self.subTest(**options):
                graph = vtkdgg.Graph(mesh, **options)
                self.assertEqual((graph.accuracy, graph.used_input_graph), (accuracy, is_found))
        np.testing.assert_array_equal(vtkdgg.distance(file, 5), self.graph.distance(5))
        self.assertFalse(self.graph.used_input_graph)

    def test_finer_accuracy(self):
        for ask in (
            lambda **options: vtkdgg.distance(self.mesh, 5, **options),
            lambda **options: vtkdgg.path(self.mesh, 5, 100, **options).points,
        ):
            expected = ask()
            np.testing.assert_array_equal(ask(accuracy=0.1), expected)
            with self.assertWarnsRegex(RuntimeWarning, "Build a graph with this `accuracy`"):
                np.testing.assert_array_equal(ask(accuracy=0.01), expected)

    def test_out_of_date(self):
        mesh = support.copy_of(self.mesh)
        mesh.GetPoints().SetPoint(0, 0.0, 0.0, 1.5)
        for ask in (vtkdgg.Graph, lambda mesh: vtkdgg.distance(mesh, 5)):
            with self.assertWarnsRegex(RuntimeWarning, "out of date"):
                ask(mesh)

    @support.needs_clouds
    def test_clouds(self):
        built = vtkdgg.CloudGraph(self.points, scheme="B", accuracy=0.1)
        expected = built.distance(5)
        file = os.path.join(support.output_folder("graph"), "cloud.vtp")
        vtkdgg.write(file, built.polydata)
        for cloud in (built.polydata, file, vtkdgg.read(file)):
            graph = vtkdgg.CloudGraph(cloud)
            self.assertTrue(graph.used_input_graph)
            np.testing.assert_array_equal(graph.distance(5), expected)
            np.testing.assert_array_equal(vtkdgg.distance(cloud, 5), expected)
        self.assertFalse(vtkdgg.CloudGraph(cloud, scheme="B").used_input_graph)
        moved = support.copy_of(built.polydata)
        moved.GetPoints().SetPoint(0, 0.0, 0.0, 1.5)
        with self.assertWarnsRegex(RuntimeWarning, "points have changed") as caught:
            graph = vtkdgg.CloudGraph.from_polydata(moved)
        self.assertEqual(caught.filename, __file__)
        found = graph.construction, graph.accuracy, graph.used_input_graph
        self.assertEqual(found, ("B", 0.1, False))


class WrongInput(support.Test):
    MESH = support.folded()

    def test_construction(self):
        self.refuse(
            lambda **given: vtkdgg.Graph(*self.MESH, **given),
            *(
                ({name: value}, pattern)
                for name, pattern, values in (
                    ("construction", "construction: expected .*, got", ("guaranteed", 0, "A")),
                    ("number_of_neighbors", "number_of_neighbors", (30.5, 30.0, 2**40, "many")),
                    ("memory_limit", "memory_limit", (0, -5, np.nan, np.inf, "much")),
                )
                for value in values
            ),
        )
        self.refuse(
            vtkdgg.Graph,
            (([], []), "points: expected at least one"),
            ((support.polydata(*self.MESH), 0.01), "accuracy is a keyword argument: accuracy=0.01"),
        )
        options = {"construction": "SaddleVertexGraph", "number_of_neighbors": 0}
        self.refuse(
            lambda mesh, **given: vtkdgg.Graph(*mesh, **given),
            ({"mesh": self.MESH, **options}, "number_of_neighbors"),
            ({"mesh": support.bumpy(), "memory_limit": 1000}, "memory_limit"),
            error=vtkdgg.Error,
        )
        graph = vtkdgg.Graph(*support.bumpy(), memory_limit=1e9)
        self.assertEqual(graph.number_of_points, 642)

    def test_far_from_the_surface(self):
        graph = vtkdgg.Graph(*self.MESH)
        for _ in range(2):
            self.refuse(
                lambda ask, points: ask(points),
                ((graph.distance, [[0, 0, 0.0], [0, 5, 5]]), "Source 1.*projection_tol"),
                ((graph.matrix, [[0, 5, 5.0]]), "Row 0.*projection_tolerance"),
                error=vtkdgg.Error,
            )
            far = [[0.0, 0.0, 0.0], [0.0, 3.0, 0.0]]  # above point 2
            found = graph.distance(far, projection_tolerance=2.0)
            np.testing.assert_allclose(found, graph.distance([0, 2]))
            matrix = graph.matrix(far, [1], projection_tolerance=2.0)
            np.testing.assert_allclose(matrix, graph.matrix([0, 2], [1]))


if __name__ == "__main__":
    unittest.main()
