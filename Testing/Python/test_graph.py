# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.Graph: a graph that is built once and asked often, and the meshes that it takes."""

import os
import sys
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

ROUNDING = 1e-6  # of lengths, relative


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

    def test_ways_to_give_sources(self):
        expected = self.graph.distance([3, 200])
        for sources in ((3, 200), np.array([3, 200], dtype=np.uint16), np.array([200, 3])):
            np.testing.assert_array_equal(self.graph.distance(sources), expected)
        self.check_close(expected, self.exact([3, 200]))
        places = self.graph.distance(self.points[[3, 200]])
        np.testing.assert_allclose(places, expected, rtol=1e-12, atol=1e-14)
        for source in (np.int8(3), np.array(3), [3]):
            np.testing.assert_array_equal(self.graph.distance(source), self.graph.distance(3))

    def test_options(self):
        """Sources and options reach the filter."""
        weights = np.array([[0.2, 0.3, 0.5], [0.0, 0.4, 0.6], [0.98, 0.01, 0.01]])
        places = np.einsum("ij,ijk->ik", weights, self.points[self.triangles[[7, 400, 900]]])
        offsets = numpy_to_vtk(np.array([0.5, 0.25, 0.75]), deep=True)
        offsets.SetName("InitialDistance")
        for sources in ([5, 400, 90], places):
            search = vtkdgg.vtkDGGDistance()
            search.SetInputData(self.graph.polydata)
            search.GenerateNearestSourceOn()
            search.SetMaximumDistance(0.6)
            search.SetUnreachedValue(-1.0)
            if sources is places:
                search.SetInputData(1, support.polydata(places, []))
                search.GetInputDataObject(1, 0).GetPointData().AddArray(offsets)
            else:
                search.SetSourceIds(sources, vtk_to_numpy(offsets))
            output = vtkdgg.check(search)
            found = self.graph.distance(
                sources,
                initial_distances=vtk_to_numpy(offsets),
                maximum_distance=0.6,
                unreached=-1.0,
                return_source=True,
            )
            for values, name in zip(found, ("GeodesicDistance", "GeodesicSource")):
                np.testing.assert_array_equal(values, support.point_array(output, name))
            self.assertEqual(set(found[1]), {-1, 0, 1})
            moved = self.graph.distance(sources, initial_distances=-2.0)
            expected = self.graph.distance(sources)  # without those of the query before
            np.testing.assert_allclose(moved, expected - 2.0, rtol=1e-12, atol=1e-12)

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

    def test_threads(self):
        expected = [self.graph.distance(source) for source in range(20)]
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1e-6)
        try:
            with ThreadPoolExecutor(4) as pool:
                found = list(pool.map(self.graph.distance, list(range(20)) * 10))
        finally:
            sys.setswitchinterval(interval)
        for k, distances in enumerate(found):
            np.testing.assert_array_equal(distances, expected[k % 20])

    def test_queries_do_not_build(self):
        for source in (1, 2, [self.points[3]]):
            self.graph.distance(source)
            search = self.graph._filters[vtkdgg.vtkDGGDistance]
            self.assertTrue(search.GetUsedInputGraph())
            self.assertEqual(search.GetGraphBuildTime(), 0)


class Mesh(unittest.TestCase):
    def test_arrays_are_copied(self):
        points, triangles = support.folded()
        kept = points.copy(), triangles.copy()
        graph = vtkdgg.Graph(points, triangles)
        np.testing.assert_array_equal(points, kept[0])
        np.testing.assert_array_equal(triangles, kept[1])
        expected = graph.distance(4)
        points[:], triangles[:] = 7.0, 0
        np.testing.assert_array_equal(graph.distance(4), expected)
        self.assertAlmostEqual(graph.distance([[0.0, 0.0, 1.0]])[3], np.sqrt(5.0), delta=1e-6)

    def test_components_and_points_without_triangles(self):
        points, triangles = support.folded()
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

    def test_warnings_are_reported_once(self):
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
        points, triangles = support.two_squares([1.0, 0.0, 0.0])
        with self.assertWarnsRegex(RuntimeWarning, "set merge_coincident_points=True"):
            graph = vtkdgg.Graph(points, triangles)
        self.assertTrue(np.isnan(graph.distance(0)[7]))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            graph = vtkdgg.Graph(points, triangles, merge_coincident_points=True)
            self.assertAlmostEqual(graph.distance(0)[7], np.sqrt(5.0), delta=1e-5)
            self.assertAlmostEqual(graph.matrix(0, 7)[0, 0], np.sqrt(5.0), delta=1e-5)
            again = vtkdgg.Graph.from_polydata(graph.polydata)
        np.testing.assert_array_equal(again.distance(0), graph.distance(0))


class GraphOnTheMesh(unittest.TestCase):
    """A graph in the field data of a mesh or cloud is used by default, and named."""

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=0.05)
        cls.mesh = cls.graph.polydata
        cls.exact = vtkdgg.distance(cls.points, cls.triangles, 5)

    def setUp(self):
        catcher = warnings.catch_warnings()
        catcher.__enter__()
        self.addCleanup(catcher.__exit__, None, None, None)
        warnings.simplefilter("error")

    def test_functions(self):
        expected = self.graph.distance(5)
        np.testing.assert_array_equal(vtkdgg.distance(self.mesh, 5), expected)
        np.testing.assert_array_equal(vtkdgg.distance(self.mesh, 5, method="exact"), self.exact)
        self.assertFalse(np.isnan(vtkdgg.path(self.mesh, 5, 100).graph_length))
        exact = vtkdgg.path(self.mesh, 5, 100, method="exact")
        self.assertTrue(np.isnan(exact.graph_length))
        self.assertAlmostEqual(exact.length, self.exact[100])
        for method, pattern in (("fast", "'graph', got 'fast'"), ("exact", "'graph' only")):
            with self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.path(self.mesh, 5, 100, method=method, accuracy=0.1)

    def test_files_and_meshes(self):
        path = os.path.join(support.output_folder("graph"), "used.vtp")
        vtkdgg.write(path, self.mesh)
        expected = self.graph.distance(5)
        for mesh in (path, vtkdgg.read(path)):
            np.testing.assert_array_equal(vtkdgg.distance(mesh, 5), expected)
            graph = vtkdgg.Graph(mesh)
            self.assertEqual((graph.accuracy, graph.used_input_graph), (0.05, True))

    def test_graphs(self):
        for options, accuracy, is_found in (
            ({}, 0.05, True),
            ({"accuracy": 0.05}, 0.05, True),
            ({"accuracy": 0.01}, 0.01, False),
            ({"accuracy": 0.1}, 0.1, False),
            ({"construction": "OneRelay"}, 0.01, False),
        ):
            with self.subTest(**options):
                graph = vtkdgg.Graph(self.mesh, **options)
                found = graph.accuracy, graph.used_input_graph
                self.assertEqual(found, (accuracy, is_found))
        self.assertFalse(self.graph.used_input_graph)

    def test_finer_accuracy(self):
        for ask in (
            lambda **options: vtkdgg.distance(self.mesh, 5, **options),
            lambda **options: vtkdgg.path(self.mesh, 5, 100, **options).points,
        ):
            expected = ask()
            np.testing.assert_array_equal(ask(accuracy=0.1), expected)
            with self.assertWarnsRegex(RuntimeWarning, r"0\.05 and .*Graph\(mesh, accuracy"):
                np.testing.assert_array_equal(ask(accuracy=0.01), expected)

    def test_out_of_date(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(self.mesh)
        mesh.GetPoints().SetPoint(0, 0.0, 0.0, 1.5)
        for ask in (vtkdgg.Graph, lambda mesh: vtkdgg.distance(mesh, 5)):
            with self.assertWarnsRegex(RuntimeWarning, "out of date"):
                ask(mesh)

    @unittest.skipUnless(support.HAS_CLOUDS, "built without PCL")
    def test_clouds(self):
        built = vtkdgg.CloudGraph(self.points, scheme="B", accuracy=0.1)
        cloud = built.polydata
        expected = built.distance(5)
        graph = vtkdgg.CloudGraph(cloud)
        self.assertEqual((graph.used_input_graph, built.used_input_graph), (True, False))
        np.testing.assert_array_equal(graph.targets, built.targets)
        np.testing.assert_array_equal(graph.distance(5), expected)
        np.testing.assert_array_equal(vtkdgg.distance(cloud, 5), expected)
        self.assertFalse(vtkdgg.CloudGraph(cloud, scheme="B").used_input_graph)
        path = os.path.join(support.output_folder("graph"), "cloud.vtp")
        vtkdgg.write(path, cloud)
        for mesh in (path, vtkdgg.read(path)):
            self.assertTrue(vtkdgg.CloudGraph(mesh).used_input_graph)
        moved = vtkPolyData()
        moved.DeepCopy(cloud)
        moved.GetPoints().SetPoint(0, 0.0, 0.0, 1.5)
        with self.assertWarnsRegex(RuntimeWarning, "belongs to other points") as caught:
            graph = vtkdgg.CloudGraph.from_polydata(moved)
        self.assertEqual(caught.filename, __file__)
        found = graph.construction, graph.accuracy, graph.used_input_graph
        self.assertEqual(found, ("B", 0.1, False))


class WrongInput(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.folded()
        self.graph = vtkdgg.Graph(self.points, self.triangles)

    def test_arguments(self):
        with self.assertRaisesRegex(ValueError, "points: expected at least one"):
            vtkdgg.Graph([], [])
        with self.assertRaisesRegex(ValueError, "accuracy is a keyword argument: accuracy=0.01"):
            vtkdgg.Graph(support.polydata(self.points, self.triangles), 0.01)

    def test_construction(self):
        for construction in ("guaranteed", 0, "A"):
            with self.assertRaisesRegex(ValueError, "construction: expected one of Guaran"):
                vtkdgg.Graph(self.points, self.triangles, construction=construction)
        with self.assertRaisesRegex(vtkdgg.VTKError, "neighbours"):
            vtkdgg.Graph(
                self.points,
                self.triangles,
                construction="SaddleVertexGraph",
                number_of_neighbors=0,
            )
        for number in (30.5, 30.0, 2**40, "many"):
            with self.assertRaisesRegex(ValueError, "number_of_neighbors"):
                vtkdgg.Graph(self.points, self.triangles, number_of_neighbors=number)

    def test_memory_limit(self):
        for limit in (0, -5, np.nan, np.inf, "much"):
            with self.subTest(limit=limit), self.assertRaisesRegex(ValueError, "memory_limit"):
                vtkdgg.Graph(self.points, self.triangles, memory_limit=limit)
        with self.assertRaisesRegex(vtkdgg.VTKError, "memory_limit"):
            vtkdgg.Graph(*support.bumpy(), memory_limit=1000)
        graph = vtkdgg.Graph(*support.bumpy(), memory_limit=1e9)
        self.assertEqual(graph.number_of_points, 642)

    def test_numbers(self):
        for name, value in (
            ("unreached", "x"),
            ("projection_tolerance", -1.0),
            ("projection_tolerance", np.nan),
        ):
            with self.assertRaisesRegex(ValueError, f"{name}: expected a number"):
                self.graph.matrix(0, **{name: value})

    def test_far_from_the_surface(self):
        for _ in range(2):
            with self.assertRaisesRegex(vtkdgg.VTKError, "source point 1.*projection_tolerance"):
                self.graph.distance([[0.0, 0.0, 0.0], [0.0, 5.0, 5.0]])
            with self.assertRaisesRegex(vtkdgg.VTKError, "row point 0.*projection_tolerance"):
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
