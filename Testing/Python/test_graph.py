# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.Graph: a graph that is built once and asked often."""

import copy
import os
import pickle
import subprocess
import sys
import unittest
import unittest.mock
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

try:
    import scipy.sparse
    import scipy.sparse.csgraph
except ImportError:
    scipy = None

ROUNDING = 1e-6  # of lengths, relative


def corner(scale=1.0):
    """Two squares along a common side, at a right angle."""
    points = scale * np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1]], dtype=float
    )
    return points, np.array([[0, 1, 3], [0, 3, 2], [0, 4, 5], [0, 5, 1]])


class Distance(unittest.TestCase):
    """On a bumpy sphere, against exact distances."""

    ACCURACY = 0.05

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=cls.ACCURACY)

    def exact(self, sources):
        return vtkdgg.distance(self.points, self.triangles, sources)

    def check_close(self, distances, exact, offset=0.0):
        """The promise."""
        self.assertEqual(distances.dtype, np.float64)
        self.assertEqual(distances.shape, exact.shape)
        allowed = self.ACCURACY * (exact - offset) + ROUNDING * np.maximum(np.abs(exact), 1.0)
        np.testing.assert_array_less(np.abs(distances - exact), allowed)

    def test_promise(self):
        raw_errors, errors = [], []
        for source in (0, 5, 318, 641):
            exact = self.exact(source)
            distances = self.graph.distance(source)
            self.check_close(distances, exact)
            self.assertEqual(distances[source], 0.0)
            raw = self.graph.distance(source, correction=False)
            self.check_close(raw, exact)
            self.assertTrue((raw >= exact * (1 - 1e-9)).all())
            errors.append(np.mean(np.abs(distances - exact)))
            raw_errors.append(np.mean(raw - exact))
        self.assertLess(3.0 * np.mean(errors), np.mean(raw_errors))

    def test_finer_graphs_are_larger_and_better(self):
        exact = self.exact(9)
        degree, error = 0.0, np.inf
        for accuracy in (0.3, 0.03, 0.003):
            graph = vtkdgg.Graph(self.points, self.triangles, accuracy)
            raw_error = np.mean(graph.distance(9, correction=False) - exact)
            self.assertGreater(graph.degree, degree)
            self.assertLess(raw_error, 0.5 * error)
            degree, error = graph.degree, raw_error

    def test_ways_to_give_sources(self):
        expected = self.graph.distance([3, 200])
        for sources in ((3, 200), np.array([3, 200], dtype=np.uint16), np.array([200, 3])):
            np.testing.assert_array_equal(self.graph.distance(sources), expected)
        self.check_close(expected, self.exact([3, 200]))
        places = self.graph.distance(self.points[[3, 200]])
        np.testing.assert_allclose(places, expected, rtol=1e-12, atol=1e-14)
        for source in (np.int8(3), np.array(3), [3]):
            np.testing.assert_array_equal(self.graph.distance(source), self.graph.distance(3))

    def test_sources_in_faces(self):
        weights = np.array([[0.2, 0.3, 0.5], [0.0, 0.4, 0.6], [0.98, 0.01, 0.01]])
        places = np.einsum("ij,ijk->ik", weights, self.points[self.triangles[[7, 400, 900]]])
        for place in places:
            self.check_close(self.graph.distance([place]), self.exact([place]))
        distances, nearest = self.graph.distance(places, return_source=True)
        self.check_close(distances, self.exact(places))
        for i, triangle in enumerate(self.triangles[[7, 400, 900]]):
            self.assertTrue((nearest[triangle] == i).all())

    def test_nearest_source(self):
        sources = [641, 0, 318]
        distances, nearest = self.graph.distance(sources, return_source=True)
        fields = np.array([self.graph.distance(source) for source in sources])
        self.assertEqual(nearest.dtype.kind, "i")
        np.testing.assert_array_equal(nearest[sources], [0, 1, 2])
        self.assertEqual(set(nearest), {0, 1, 2})
        # Near a boundary of two regions either may be named.
        named = fields[nearest, np.arange(len(nearest))]
        self.assertTrue((named <= fields.min(axis=0) * (1 + 2 * self.ACCURACY)).all())
        clear = np.sort(fields, axis=0)[1] > (1 + 3 * self.ACCURACY) * fields.min(axis=0)
        self.assertGreater(clear.sum(), 300)
        np.testing.assert_array_equal(nearest[clear], fields.argmin(axis=0)[clear])
        np.testing.assert_allclose(distances[clear], named[clear], rtol=1e-12)

    def test_initial_distances(self):
        ids, offsets = [5, 400, 90], np.array([1.5, 1.0, 1.0])
        exact = np.min([self.exact(i) + o for i, o in zip(ids, offsets)], axis=0)
        for sources in (ids, self.points[ids]):
            with self.subTest(sources=np.shape(sources)):
                distances, nearest = self.graph.distance(
                    sources, initial_distances=offsets, return_source=True
                )
                self.check_close(distances, exact, offset=1.0)
                self.assertEqual([nearest[400], nearest[90]], [1, 2])
                self.assertEqual(distances[400], 1.0)
                self.assertEqual(set(nearest), {0, 1, 2})
                all_the_same = self.graph.distance(sources, initial_distances=-2.0)
                np.testing.assert_allclose(
                    all_the_same, self.graph.distance(sources) - 2.0, rtol=1e-12, atol=1e-12
                )
        # The next query has none.
        self.assertEqual(self.graph.distance(self.points[ids])[400], 0.0)

    def test_initial_distances_and_a_limit(self):
        ids, offsets = [5, 400, 90], [0.5, 0.25, 0.75]
        everywhere = self.graph.distance(ids, initial_distances=offsets)
        for sources in (ids, self.points[ids]):
            distances, nearest = self.graph.distance(
                sources, initial_distances=offsets, maximum_distance=0.6, return_source=True
            )
            reached = ~np.isnan(distances)
            self.assertEqual([nearest[5], nearest[400], nearest[90]], [0, 1, -1])
            self.assertTrue((distances[reached] <= 0.6).all())
            np.testing.assert_array_equal(nearest == -1, ~reached)
            clear = np.abs(everywhere - 0.6) > 0.6 * self.ACCURACY
            np.testing.assert_array_equal(reached[clear], (everywhere < 0.6)[clear])
        distances = self.graph.distance(ids, initial_distances=2.0, maximum_distance=1.0)
        self.assertTrue(np.isnan(distances).all())

    def test_maximum_distance(self):
        everywhere = self.graph.distance(17)
        for limit in (1.0, np.float32(0.25), 0.0):
            distances = self.graph.distance(17, maximum_distance=limit)
            near = everywhere <= limit
            np.testing.assert_array_equal(np.isnan(distances), ~near)
            np.testing.assert_allclose(distances[near], everywhere[near], rtol=1e-12)
        np.testing.assert_array_equal(self.graph.distance(17), everywhere)

    def test_results_are_copies(self):
        expected = self.graph.distance(17)
        kept = expected.copy()
        again, nearest = self.graph.distance(17, return_source=True)
        again[:], nearest[:] = -5.0, 9
        np.testing.assert_array_equal(self.graph.distance(17), kept)
        np.testing.assert_array_equal(self.graph.distance(17, return_source=True)[1], 0)

    def test_queries_do_not_build(self):
        for source in (1, 2, [self.points[3]]):
            self.graph.distance(source)
            search = self.graph._filters[vtkdgg.vtkDGGDistance]
            self.assertTrue(search.GetUsedInputGraph())
            self.assertEqual(search.GetGraphBuildTime(), 0)


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
            (([],), "rows: at least one"),
            ((80,), "rows: point id 80"),
            ((0, [1, -1]), "columns: point id -1"),
            ((0, []), "columns: at least one"),
            ((0, [True]), "columns: numbers are wanted, not bool"),
            (([[0.0, 0.0]],), "rows: the shape"),
        ):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(ValueError, pattern):
                self.graph.matrix(*arguments)
        with self.assertRaisesRegex(vtkdgg.VTKError, "column point 0"):
            self.graph.matrix(0, [[0.0, 0.0, 5.0]])
        self.check(self.graph.matrix(0, 1), self.points[[0]], self.points[[1]])

    def test_memory_limit(self):
        limit = 2**20
        graph = vtkdgg.Graph(self.points, self.triangles, 0.5, memory_limit=limit)
        with self.assertRaisesRegex(vtkdgg.VTKError, "MemoryLimit"):
            graph.matrix(np.zeros(1000, dtype=int), np.zeros(1000, dtype=int))
        self.assertEqual(graph.matrix(0, 1).shape, (1, 1))


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
        graph = vtkdgg.Graph(*corner(), accuracy=5e-6)
        self.assertEqual(graph.lengths.dtype, np.float64)
        self.assertAlmostEqual(graph.lengths.max(), np.sqrt(5.0), delta=1e-12)

    def test_views_cannot_be_written_to(self):
        for view in (self.graph.offsets, self.graph.targets, self.graph.lengths):
            with self.assertRaises(ValueError):
                view[0] = 1
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


class Mesh(unittest.TestCase):
    def test_arrays_are_copied(self):
        points, triangles = corner()
        kept = points.copy(), triangles.copy()
        graph = vtkdgg.Graph(points, triangles)
        np.testing.assert_array_equal(points, kept[0])
        np.testing.assert_array_equal(triangles, kept[1])
        expected = graph.distance(4)
        points[:], triangles[:] = 7.0, 0
        np.testing.assert_array_equal(graph.distance(4), expected)
        self.assertAlmostEqual(graph.distance([[0.0, 0.0, 1.0]])[3], np.sqrt(5.0), delta=1e-6)

    def test_any_scale(self):
        for scale in (1e-9, 1e9):
            graph = vtkdgg.Graph(*corner(scale))
            self.assertAlmostEqual(graph.distance(4)[3] / scale, np.sqrt(5.0), delta=1e-6)

    def test_components_and_points_without_triangles(self):
        points, triangles = corner()
        points = np.vstack([points, points + [0.0, 5.0, 0.0], [[3.0, 3.0, 3.0]]])
        graph = vtkdgg.Graph(points, np.vstack([triangles, triangles + 6]))
        distances, nearest = graph.distance(0, return_source=True)
        np.testing.assert_array_equal(np.isnan(distances), np.arange(13) >= 6)
        np.testing.assert_array_equal(nearest, np.where(np.arange(13) < 6, 0, -1))
        distances = graph.distance([0, 6], unreached=-1.0)
        np.testing.assert_array_equal(distances == -1.0, np.arange(13) == 12)
        with self.assertWarnsRegex(RuntimeWarning, "no polygon uses") as caught:
            distances = graph.distance(12)
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(distances[12], 0.0)
        self.assertEqual(np.isnan(distances).sum(), 12)

    def test_warnings_are_told_once(self):
        # Three triangles on one edge.
        points = np.vstack([np.zeros(3), np.eye(3), [[0.0, -1.0, 0.0]]])
        with self.assertWarnsRegex(RuntimeWarning, "more than two triangles") as caught:
            graph = vtkdgg.Graph(points, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            np.testing.assert_allclose(graph.distance(2)[3:], [2.0, 2.0], rtol=1e-6)
            np.testing.assert_allclose(graph.matrix(2, [3, 4]), [[2.0, 2.0]], rtol=1e-6)

    def test_seams(self):
        # Two squares along a common side whose points exist twice.
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [1.0, 0.0, 0.0]])
        triangles = np.vstack([triangles, triangles + 4])
        with self.assertWarnsRegex(RuntimeWarning, "MergeCoincidentPoints"):
            graph = vtkdgg.Graph(points, triangles)
        self.assertTrue(np.isnan(graph.distance(0)[7]))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            graph = vtkdgg.Graph(points, triangles, merge_coincident_points=True)
            self.assertAlmostEqual(graph.distance(0)[7], np.sqrt(5.0), delta=1e-5)
            self.assertAlmostEqual(graph.matrix(0, 7)[0, 0], np.sqrt(5.0), delta=1e-5)
            again = vtkdgg.Graph.from_polydata(graph.polydata)
        np.testing.assert_array_equal(again.distance(0), graph.distance(0))

    def test_two_graphs(self):
        one, two = vtkdgg.Graph(*corner()), vtkdgg.Graph(*corner(2.0))
        for _ in range(2):
            self.assertAlmostEqual(one.distance(4)[2], 2.0, delta=1e-6)
            self.assertAlmostEqual(two.distance(4)[2], 4.0, delta=1e-6)


class Copies(unittest.TestCase):
    def setUp(self):
        self.graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.03, memory_limit=2**28)

    def check_equal(self, graph):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for source in (11, [[0.7, 0.1, 0.2]]):
                expected = self.graph.distance(source, projection_tolerance=1.0)
                distances = graph.distance(source, projection_tolerance=1.0)
                np.testing.assert_array_equal(distances, expected)
            np.testing.assert_array_equal(graph.matrix([1, 2]), self.graph.matrix([1, 2]))
        search = graph._filters[vtkdgg.vtkDGGDistance]
        self.assertTrue(search.GetUsedInputGraph())
        self.assertEqual(search.GetMemoryLimit(), 2**28)
        self.assertEqual(repr(graph), repr(self.graph))

    def test_ways_to_copy(self):
        for asked in (False, True):
            if asked:
                self.graph.distance(5)
            self.check_equal(copy.copy(self.graph))
            self.check_equal(copy.deepcopy(self.graph))
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                text = pickle.dumps(self.graph, protocol)
                self.check_equal(pickle.loads(text))  # noqa: S301

    def test_another_process(self):
        code = (
            "import pickle, sys, vtkdgg\n"
            "graph = pickle.load(sys.stdin.buffer)\n"
            "pickle.dump((graph, graph.distance(11)), sys.stdout.buffer)\n"
        )
        self.graph.distance(11)
        result = subprocess.run(
            [sys.executable, "-c", code],
            input=pickle.dumps(self.graph),
            capture_output=True,
            check=True,
        )
        graph, distances = pickle.loads(result.stdout)  # noqa: S301
        np.testing.assert_array_equal(distances, self.graph.distance(11))
        self.check_equal(graph)

    def test_other_data(self):
        mesh = self.graph.polydata
        colours = numpy_to_vtk(np.arange(1926, dtype=np.uint8).reshape(-1, 3), deep=True)
        colours.SetName("Colours")
        mesh.GetPointData().AddArray(colours)
        graph = vtkdgg.Graph.from_polydata(mesh, memory_limit=2**28)
        graph = pickle.loads(pickle.dumps(graph))  # noqa: S301
        kept = graph.polydata.GetPointData().GetArray("Colours")
        self.assertEqual(kept.GetDataType(), colours.GetDataType())
        np.testing.assert_array_equal(vtk_to_numpy(kept), vtk_to_numpy(colours))
        self.check_equal(graph)


class FromPolydata(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.bumpy()
        self.graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.03)
        self.expected = self.graph.distance(11)

    def editable(self):
        """The surface with its graph, none of it shared."""
        mesh = vtkPolyData()
        mesh.DeepCopy(self.graph.polydata)
        return mesh

    def check_equal(self, graph):
        self.assertEqual(graph.accuracy, 0.03)
        self.assertEqual(graph.construction, "Guaranteed")
        np.testing.assert_array_equal(graph.targets, self.graph.targets)
        np.testing.assert_array_equal(graph.distance(11), self.expected)

    def test_shares_the_graph(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            graph = vtkdgg.Graph.from_polydata(self.graph.polydata)
        self.assertTrue(np.shares_memory(graph.lengths, self.graph.lengths))
        self.check_equal(graph)

    def test_through_a_file(self):
        path = os.path.join(support.output_folder("graph"), "graph.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(self.graph.polydata)
        writer.SetFileName(path)
        vtkdgg.check(writer)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(path)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.check_equal(vtkdgg.Graph.from_polydata(vtkdgg.check(reader)))

    def test_from_a_pipeline(self):
        builder = vtkdgg.vtkDiscreteGeodesicGraph()
        builder.SetInputData(support.polydata(self.points, self.triangles))
        builder.SetAccuracy(0.03)
        self.check_equal(vtkdgg.Graph.from_polydata(vtkdgg.check(builder)))
        builder.SetConstructionToSaddleVertexGraph()
        builder.SetNumberOfNeighbors(7)
        graph = vtkdgg.Graph.from_polydata(vtkdgg.check(builder))
        self.assertIsNone(graph.accuracy)
        self.assertEqual(len(graph.targets), builder.GetNumberOfGraphEdges())

    def test_the_surface_may_change_later(self):
        mesh = self.editable()
        graph = vtkdgg.Graph.from_polydata(mesh)
        vtk_to_numpy(mesh.GetPoints().GetData())[:] = 0.0
        mesh.GetPoints().Modified()
        mesh.GetPolys().Reset()
        self.check_equal(graph)
        self.assertEqual(graph.polydata.GetNumberOfPolys(), len(self.triangles))

    def test_out_of_date(self):
        mesh = self.editable()
        vtk_to_numpy(mesh.GetPoints().GetData())[:] *= 2.0
        with self.assertWarnsRegex(RuntimeWarning, "out of date") as caught:
            graph = vtkdgg.Graph.from_polydata(mesh)
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(graph.accuracy, 0.03)
        np.testing.assert_allclose(graph.distance(11), 2.0 * self.expected, rtol=1e-6)

    def refuses(self, mesh, pattern):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(ValueError, f"polydata: its graph is damaged: .*{pattern}"):
                vtkdgg.Graph.from_polydata(mesh)

    def test_damaged(self):
        mesh = self.editable()
        vtk_to_numpy(mesh.GetFieldData().GetArray("DGG.Lengths"))[100] *= 0.5
        self.refuses(mesh, "checksum is wrong.*a text file that rounds.*build it anew")
        mesh = self.editable()
        mesh.GetFieldData().GetArray("DGG.Targets").SetNumberOfTuples(100)
        self.refuses(mesh, "DGG.Targets has 100")
        mesh = self.editable()
        vtk_to_numpy(mesh.GetFieldData().GetArray("DGG.Targets"))[100] = -1
        self.refuses(mesh, "leads to vertex -1")
        mesh = self.editable()
        mesh.GetFieldData().RemoveArray("DGG.Angles")
        self.refuses(mesh, "DGG.Angles is missing")

    def test_damaged_parameters(self):
        # They are not taken over, although each could be that of a graph.
        half = int(np.array([0.5]).view(np.int64)[0])
        for slot, value in ((2, 1), (3, half), (4, 7), (5, 1), (8, 1), (11, 0)):
            mesh = self.editable()
            mesh.GetFieldData().GetArray("DGG.Info").SetValue(slot, value)
            with self.subTest(slot=slot):
                self.refuses(mesh, "checksum")
        for slot, value in ((1, 2), (2, 4), (3, 0), (3, -1)):
            mesh = self.editable()
            mesh.GetFieldData().GetArray("DGG.Info").SetValue(slot, value)
            with self.subTest(slot=slot, value=value):
                self.refuses(mesh, "its (kind|construction|accuracy) is")

    def test_legacy_files(self):
        path = os.path.join(support.output_folder("graph"), "graph.vtk")
        for binary in (True, False):
            writer = vtkPolyDataWriter()
            writer.SetInputData(self.graph.polydata)
            writer.SetFileName(path)
            if binary:
                writer.SetFileTypeToBinary()
            vtkdgg.check(writer)
            reader = vtkPolyDataReader()
            reader.SetFileName(path)
            mesh = vtkdgg.check(reader)
            if binary:
                self.check_equal(vtkdgg.Graph.from_polydata(mesh))
            else:
                self.refuses(mesh, "a text file that rounds")

    def test_other_data(self):
        mesh = self.editable()
        for kind, cells in ((mesh.SetVerts, [[3]]), (mesh.SetLines, [[4, 5], [5, 6]])):
            array = vtkCellArray()
            for cell in cells:
                array.InsertNextCell(len(cell), cell)
            kind(array)
        names = vtkStringArray()
        names.SetName("Names")
        names.SetNumberOfValues(3)
        mesh.GetFieldData().AddArray(names)
        for data, size in ((mesh.GetPointData(), 642), (mesh.GetCellData(), 1283)):
            array = numpy_to_vtk(np.arange(size), deep=True)
            array.SetName("Numbers")
            data.SetScalars(array)
        kept = vtkdgg.Graph.from_polydata(mesh)
        self.check_equal(kept)
        kept = kept.polydata
        for get in ("GetPointData", "GetCellData"):
            array = getattr(mesh, get)().GetScalars()
            self.assertIs(getattr(kept, get)().GetScalars(), array)
            self.assertEqual(getattr(kept, get)().GetNumberOfArrays(), 1)
        self.assertIs(kept.GetFieldData().GetAbstractArray("Names"), names)
        counts = (kept.GetNumberOfVerts(), kept.GetNumberOfLines(), kept.GetNumberOfCells())
        self.assertEqual(counts, (1, 2, 1283))

    def test_merged_points(self):
        # Two squares along a common side whose points exist twice.
        points, triangles = support.grid(1, 1)
        points = np.vstack([points, points + [1.0, 0.0, 0.0]])
        builder = vtkdgg.vtkDiscreteGeodesicGraph()
        builder.SetInputData(support.polydata(points, np.vstack([triangles, triangles + 4])))
        builder.MergeCoincidentPointsOn()
        graph = vtkdgg.Graph.from_polydata(vtkdgg.check(builder))
        self.assertAlmostEqual(graph.distance(0)[7], np.sqrt(5.0), delta=1e-6)
        self.assertAlmostEqual(graph.matrix(0, 7)[0, 0], np.sqrt(5.0), delta=1e-6)
        self.assertTrue(graph._filters[vtkdgg.vtkDGGDistance].GetUsedInputGraph())

    def test_no_graph(self):
        with self.assertRaisesRegex(ValueError, "no graph.*vtkDiscreteGeodesicGraph"):
            vtkdgg.Graph.from_polydata(support.polydata(self.points, self.triangles))
        for thing in (None, 3, self.points):
            with self.assertRaisesRegex(TypeError, "a vtkPolyData is wanted"):
                vtkdgg.Graph.from_polydata(thing)

    def test_no_points(self):
        empty = vtkPolyData()
        with_graph = vtkPolyData()
        with_graph.SetFieldData(self.graph.polydata.GetFieldData())
        for mesh in (empty, with_graph):
            with self.assertRaisesRegex(ValueError, "polydata: at least one point"):
                vtkdgg.Graph.from_polydata(mesh)

    def test_unreadable_parameters(self):
        for slot, value in ((0, 2), (2, 4), (2, -1)):
            mesh = self.editable()
            mesh.GetFieldData().GetArray("DGG.Info").SetValue(slot, value)
            with self.subTest(slot=slot, value=value), self.assertRaises(ValueError):
                vtkdgg.Graph.from_polydata(mesh)
        mesh = self.editable()
        mesh.GetFieldData().GetArray("DGG.Info").SetNumberOfTuples(3)
        with self.assertRaisesRegex(ValueError, "DGG.Info"):
            vtkdgg.Graph.from_polydata(mesh)


class WrongInput(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = corner()
        self.graph = vtkdgg.Graph(self.points, self.triangles)

    def test_arrays(self):
        for points, triangles, pattern in (
            ([], [], "points: at least one"),
            (self.points[:, :2], self.triangles, "points: the shape"),
            (self.points + np.nan, self.triangles, "points: row 0 is not finite"),
            (np.ma.masked_less(self.points, 0.5), self.triangles, "points: has masked entries"),
            (self.points, self.triangles + 3, r"triangles: point id 6 \(entry 0, 2\)"),
            (self.points, self.triangles + 0.0, "triangles: integers are wanted"),
            (self.points, self.triangles > 0, "triangles: integers are wanted, not bool"),
        ):
            with self.subTest(pattern=pattern), self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.Graph(points, triangles)
        with self.assertRaisesRegex(vtkdgg.VTKError, "no polygons"):
            vtkdgg.Graph(self.points, [])

    def test_accuracy(self):
        for accuracy in (0.0, 1e-7, 0.51, -1.0, np.nan, np.inf):
            with self.subTest(accuracy=accuracy):
                with self.assertRaisesRegex(vtkdgg.VTKError, "accuracy.*1e-06, 0.5"):
                    vtkdgg.Graph(self.points, self.triangles, accuracy)
        for accuracy in ("fine", None, [0.1, 0.2]):
            with self.assertRaisesRegex(ValueError, "accuracy: a number is wanted"):
                vtkdgg.Graph(self.points, self.triangles, accuracy)

    def test_construction(self):
        for construction in ("guaranteed", 0, None):
            with self.assertRaisesRegex(ValueError, "construction: one of Guaranteed, OneRelay"):
                vtkdgg.Graph(self.points, self.triangles, construction=construction)
        with self.assertRaisesRegex(vtkdgg.VTKError, "neighbours"):
            vtkdgg.Graph(
                self.points,
                self.triangles,
                construction="SaddleVertexGraph",
                number_of_neighbors=0,
            )
        for number in (30.5, 30.0, 2**40, None, "many"):
            with self.assertRaisesRegex(ValueError, "number_of_neighbors"):
                vtkdgg.Graph(self.points, self.triangles, number_of_neighbors=number)

    def test_memory_limit(self):
        for limit in (0, -5, np.nan, np.inf, "much"):
            with self.subTest(limit=limit), self.assertRaisesRegex(ValueError, "memory_limit"):
                vtkdgg.Graph(self.points, self.triangles, memory_limit=limit)
        with self.assertRaisesRegex(vtkdgg.VTKError, "MemoryLimit"):
            vtkdgg.Graph(*support.bumpy(), memory_limit=1000)
        graph = vtkdgg.Graph(*support.bumpy(), memory_limit=1e9)
        self.assertEqual(graph.number_of_points, 642)

    def test_numbers(self):
        for value in ("x", None, [1.0, 2.0]):
            for ask in (self.graph.distance, self.graph.matrix):
                with self.assertRaisesRegex(ValueError, "unreached: a number is wanted"):
                    ask(0, unreached=value)
        for ask in (self.graph.distance, self.graph.matrix):
            for value in (-1.0, np.nan, "x"):
                with self.assertRaisesRegex(ValueError, "projection_tolerance: "):
                    ask(0, projection_tolerance=value)

    def test_queries(self):
        for sources, options, pattern in (
            ([], {}, "sources: at least one"),
            (6, {}, "sources: point id 6"),
            ([0, -1], {}, r"sources: point id -1 \(entry 1\)"),
            (2**70, {}, "sources: 1180591620717411303424 does not fit into 64 bits"),
            (True, {}, "sources: numbers are wanted, not bool"),
            (np.array([True, False]), {}, "sources: numbers are wanted, not bool"),
            (np.ma.masked_equal([0, 1], 1), {}, "sources: has masked entries"),
            (0.5, {}, "sources: point ids"),
            ([[0.0, 0.0, np.inf]], {}, "sources: row 0 is not finite"),
            (0, {"maximum_distance": -1.0}, "maximum_distance"),
            (0, {"maximum_distance": np.nan}, "maximum_distance"),
            ([0, 1], {"initial_distances": [1.0]}, "initial_distances: one number, or 2"),
            ([0, 1], {"initial_distances": [[1.0, 2.0]]}, "initial_distances: one number, or 2"),
            ([0, 1], {"initial_distances": []}, "initial_distances: one number, or 2"),
            ([0, 1], {"initial_distances": [0.0, np.nan]}, "initial_distances: entry 1"),
            ([0, 1], {"initial_distances": "ab"}, "initial_distances: numbers"),
            (0, {"initial_distances": [1.0, 2.0]}, "initial_distances: one number is wanted"),
        ):
            with self.subTest(sources=sources, options=options):
                with self.assertRaisesRegex(ValueError, pattern):
                    self.graph.distance(sources, **options)
        # It still works.
        self.assertAlmostEqual(self.graph.distance(4)[3], np.sqrt(5.0), delta=1e-6)

    def test_far_from_the_surface(self):
        for _ in range(2):
            with self.assertRaisesRegex(vtkdgg.VTKError, "source point 1.*ProjectionTolerance"):
                self.graph.distance([[0.0, 0.0, 0.0], [0.0, 5.0, 5.0]])
            with self.assertRaisesRegex(vtkdgg.VTKError, "row point 0.*ProjectionTolerance"):
                self.graph.matrix([[0.0, 5.0, 5.0]])
            far = [[0.0, 0.0, 0.0], [0.0, 3.0, 0.0]]  # above point 2
            np.testing.assert_allclose(
                self.graph.distance(far, projection_tolerance=2.0), self.graph.distance([0, 2])
            )
            matrix = self.graph.matrix(far, [1], projection_tolerance=2.0)
            np.testing.assert_allclose(matrix, self.graph.matrix([0, 2], [1]))
            tolerance = vtkdgg.vtkDGGDistance().GetProjectionTolerance()
            self.assertEqual(vtkdgg.arguments.projection_tolerance(None), tolerance)
        self.assertAlmostEqual(self.graph.distance(4)[3], np.sqrt(5.0), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
