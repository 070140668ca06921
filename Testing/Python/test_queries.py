# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Answers of graphs of meshes and clouds: paths, matrices, samples, cells, isolines, loops; and of
functions that use the Laplacian."""

import pickle
import tempfile
import unittest
from unittest import mock

import numpy as np
import support
import vtkdgg
from support import warnings_as
from vtkmodules.vtkCommonDataModel import vtkPolyData

try:
    import scipy.sparse as sparse
except ImportError:
    sparse = None


class OnABumpySphere(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.mesh = cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(*cls.mesh, accuracy=0.02)
        cls.size = np.ptp(cls.points, axis=0).max()
        cls.near = cls.points[[7, 90, 200]] + 1e-3 * cls.size

    def test_distance_as_polydata(self):
        surface = self.graph.distance([5, 40], as_polydata=True)
        distances, nearest = self.graph.distance([5, 40], return_source=True)
        self.graph.distance([7], as_polydata=True)
        found = support.point_array(surface, "GeodesicDistance")
        np.testing.assert_array_equal(found, distances)
        np.testing.assert_array_equal(support.point_array(surface, "GeodesicSource"), nearest)

    def test_path(self):
        exact = vtkdgg.distance(*self.mesh, 5)
        for find in (
            lambda end: vtkdgg.path(*self.mesh, 5, end),
            lambda end: self.graph.path(5, end),
            lambda end: self.graph.path(np.int16(5), end, straighten=False),
        ):
            for end in (0, 318, 641):
                path = find(end)
                self.assertEqual((path.points.dtype, path.points.shape[1]), (np.float64, 3))
                pieces = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
                sums = np.append(0, np.cumsum(pieces))
                np.testing.assert_allclose(path.arc_lengths, sums, atol=1e-9)
                self.assertAlmostEqual(path.length, sums[-1], delta=1e-9)
                self.assertTrue(exact[end] * (1 - 1e-9) <= path.length <= 1.021 * exact[end])
                self.assertEqual((path.point_ids[0], path.point_ids[-1]), (5, end))
                at_points = path.point_ids >= 0
                corners = self.points[path.point_ids[at_points]]
                np.testing.assert_array_equal(path.points[at_points], corners)
                corners = self.points[self.triangles[path.faces]]
                positions = np.einsum("ij,ijk->ik", path.barycentric, corners)
                np.testing.assert_allclose(positions, path.points, atol=1e-9)
        path, once = self.graph.path(5, 318), vtkdgg.path(*self.mesh, 5, 318, accuracy=0.02)
        np.testing.assert_array_equal(once.points, path.points)
        self.assertEqual(once.graph_length, path.graph_length)
        length = self.graph.matrix(5, 318)[0, 0]
        self.assertAlmostEqual(path.graph_length, length, delta=1e-9 * self.size)
        self.assertTrue(np.isnan(vtkdgg.path(*self.mesh, 5, 318).graph_length))
        lengths = [self.graph.path(5, 318, detour=detour).length for detour in (0, 1e-3, 0.1)]
        self.assertTrue((np.diff(lengths) <= 1e-9).all())
        wrong = (({"detour": detour}, "detour") for detour in (-0.1, 0.2, np.nan, "far"))
        self.refuse(lambda **given: self.graph.path(5, 318, **given), *wrong)
        for place in (5, self.near[0]):
            path = self.graph.path(place, place)
            self.assertEqual((path.length, len(path.points)), (0.0, 1))

    def test_results_are_copies(self):
        for ask in (
            lambda: self.graph.distance(17, return_source=True),
            lambda: (self.graph.matrix([1, 2], [3, 4]),),
            lambda: (self.graph.path(5, 318).points, self.graph.path(5, 318).faces),
        ):
            first = ask()
            kept = [array.copy() for array in first]
            for array in first:
                array[:] = 9
            for found, expected in zip(ask(), kept):
                np.testing.assert_array_equal(found, expected)

    def test_paths(self):
        starts, ends = [5, 17, 318, 5], [318, 5, 17, 5]
        found = self.graph.paths(starts, ends)
        for start, end, path in zip(starts, ends, found):
            np.testing.assert_array_equal(path.points, self.graph.path(start, end).points)
        lines = self.graph.paths(starts[:3], ends[:3], as_polydata=True)
        self.assertEqual(lines.GetNumberOfLines(), 3)
        fan, back = self.graph.paths(5, ends[:3]), self.graph.paths(ends[:3], [5])
        np.testing.assert_allclose([p.length for p in fan], [p.length for p in back], rtol=0.02)
        self.refuse(self.graph.paths, (([1, 2, 3], [1, 2]), "expected equal numbers"))

    def test_matrix(self):
        rows, columns = [0, 5, 33], [1, 2, 5, 79, 57]
        matrix = self.graph.matrix(rows, columns)
        self.assertEqual((matrix.dtype, matrix.shape), (np.float64, (3, 5)))
        for row, found in zip(rows, matrix):
            field = self.graph.distance(row, correction=False)
            np.testing.assert_allclose(found, field[columns], rtol=1e-12)
        for first, second, expected in (
            (columns, rows, matrix.T),
            (0, 57, matrix[:1, 4:]),
            (rows, 57, matrix[:, 4:]),
            (0, columns, matrix[:1]),
            (7, None, [[0.0]]),
            (self.points[rows], columns, matrix),
            (0, self.points[columns], matrix[:1]),
        ):
            found = self.graph.matrix(first, second)
            np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-9)
        self.refuse(
            self.graph.matrix,
            ((642,), "rows: point id 642"),
            ((0, []), "columns: expected at least one"),
        )
        far = (0, [[0.0, 0.0, 5.0]]), "Column 0"
        self.refuse(self.graph.matrix, far, error=vtkdgg.Error)
        graph = vtkdgg.Graph(*support.grid(9, 7), accuracy=0.5, memory_limit=2**20)
        many = np.zeros(1000, dtype=int)
        self.refuse(graph.matrix, ((many, many), "memory_limit"), error=vtkdgg.Error)
        self.assertEqual(graph.matrix(0, 1).shape, (1, 1))

    def test_matrix_in_blocks(self):
        rows, columns = np.arange(0, 600, 15), [3, 500, 77]
        places = self.points[rows[:20]] + 1e-3 * self.size
        cases = [(rows, None), (rows, columns), (places, None), (rows, places)]
        with tempfile.TemporaryDirectory() as folder, mock.patch("vtkdgg.matrices._BLOCK", 100):
            for number, (first, second) in enumerate(cases):
                expected = self.graph.matrix(first, second)
                out = np.memmap(f"{folder}/{number}", np.float64, "w+", shape=expected.shape)
                self.assertIs(self.graph.matrix(first, second, out=out), out)
                np.testing.assert_allclose(out, expected, rtol=1e-12)
                if second is None:
                    np.testing.assert_array_equal(out, out.T)
                single = self.graph.matrix(first, second, dtype=np.float32)
                self.assertEqual(single.dtype, np.float32)
                np.testing.assert_array_equal(single, out.astype(np.float32))
                del out
            wrong = np.concatenate([self.points[rows], [[0.0, 0.0, 5.0]]])
            self.refuse(
                lambda columns: self.graph.matrix(wrong, columns, dtype=np.float32),
                ((None,), "Row 40"),
                ((columns,), "Row 40"),
                error=vtkdgg.Error,
            )
        read_only = np.zeros((40, 3))
        read_only.flags.writeable = False
        double = np.zeros((40, 3))
        self.refuse(
            lambda **given: self.graph.matrix(rows, columns, **given),
            ({"out": np.empty((3, 40))}, r"out: expected the shape \(40, 3\), got \(3, 40\)"),
            ({"out": double.astype(int)}, "out: expected a floating-point type, got int"),
            ({"out": double.tolist()}, "out: expected an array, got list"),
            ({"out": "x.npy"}, "out: expected an array, got str"),
            ({"out": read_only}, "out: the array is read-only"),
            ({"out": double, "dtype": "f4"}, "dtype: expected float64, .* got float32"),
            ({"dtype": np.int32}, "dtype: expected a floating-point type, got int32"),
            ({"dtype": "x"}, "dtype: expected a floating-point type, got 'x'"),
        )

    @unittest.skipUnless(sparse, "no SciPy")
    def test_sparse_matrix(self):
        radius = 0.3 * self.size
        found = self.graph.sparse_matrix(radius)
        self.assertIsInstance(found, sparse.csr_matrix)
        dense = self.graph.matrix(np.arange(len(self.points)))
        np.fill_diagonal(dense, np.inf)
        dense[dense > radius] = 0.0
        self.assertEqual(found.nnz, np.count_nonzero(dense))
        np.testing.assert_allclose(found.toarray(), dense, rtol=1e-9)
        rows = self.graph.sparse_matrix(radius, [7, 3, 500])
        self.assertEqual((rows - found[[7, 3, 500]]).nnz, 0)
        self.assertEqual(self.graph.sparse_matrix(0.0).nnz, 0)
        self.refuse(self.graph.sparse_matrix, ((-1.0,), "maximum_distance"))

    def test_neighborhood(self):
        radius = 0.2 * self.size
        for source in (7, self.near[0], (40, (0.2, 0.3, 0.5))):
            for correction in (True, False):
                ids, distances = self.graph.neighborhood(source, radius, correction=correction)
                field = self.graph.distance(
                    [source], correction=correction, maximum_distance=radius
                )
                np.testing.assert_array_equal(np.sort(ids), np.flatnonzero(np.isfinite(field)))
                np.testing.assert_array_equal(distances, field[ids])
                self.assertTrue((np.diff(distances) >= 0.0).all())
        for source, expected in ((7, [7]), (self.near[0], [])):
            self.assertEqual(self.graph.neighborhood(source, 0.0)[0].tolist(), expected)
        wrong = ((7, None), "radius"), ((7, -1.0), "radius"), (([7, 8], 1.0), "source")
        self.refuse(self.graph.neighborhood, *wrong)

    def test_preparations_are_kept(self):
        """Queries do not prepare the mesh or the graph again, and searches reuse their data. Ids
        between coordinates do not release what links the coordinates."""
        graph = vtkdgg.Graph(*self.mesh, accuracy=0.02)
        for name, ask in {
            "distance": graph.distance,
            "isolines": lambda points: graph.isolines(points, 2),
            "loop": graph.loop,
            "matrix": graph.matrix,
            "paths": lambda points: graph.paths(points, 300),
            "sample": lambda points: graph.sample(5, start=points),
            "voronoi": graph.voronoi,
        }.items():
            with self.subTest(name), mock.patch.multiple(vtkdgg._kernel, Surface=None, Graph=None):
                ask(self.near)
                size = graph._graph.search_memory_size
                self.assertGreater(size, 0)
                for points in ([7, 90, 200], self.near):
                    ask(points)
                    self.assertEqual(graph._graph.search_memory_size, size)

    def test_sample(self):
        samples = self.graph.sample(30, first=5)
        self.assertEqual((samples.point_ids[0], len(samples.points)), (5, 30))
        np.testing.assert_array_equal(samples.points, self.points[samples.point_ids])
        self.assertTrue((np.diff(samples.covering_radii) <= 0).all())
        again = self.graph.sample(40, start=[5, 17], in_faces=True)
        np.testing.assert_allclose(again.points[:2], self.points[[5, 17]], atol=1e-12)
        coarse = self.graph.sample(600, covering_radius=0.2 * self.size)
        self.assertLessEqual(coarse.covering_radii[-1], 0.2 * self.size)
        self.assertLess(len(coarse.points), 600)
        self.assertEqual(self.graph.sample(9, as_polydata=True).GetNumberOfPoints(), 9)
        few = "`number_of_samples` is 0. Use a number of at least 1"
        self.refuse(self.graph.sample, ((None,), "expected an integer"), ((0,), few))

    def test_voronoi(self):
        sites = [5, 17, 318]
        cells = self.graph.voronoi(sites)
        distances, nearest = self.graph.distance(sites, return_source=True)
        self.assertGreater(np.mean(cells.nearest == nearest), 0.99)
        np.testing.assert_allclose(cells.distances, distances, rtol=0.02, atol=1e-9)
        np.testing.assert_allclose(cells.sites, self.points[sites])
        cut = self.graph.voronoi(sites, as_polydata=True)
        self.assertTrue(cut.GetCellData().HasArray("SiteId"))
        moved = self.graph.voronoi(sites, iterations=5)
        self.assertLess(np.ptp(moved.areas), np.ptp(cells.areas))
        wrong = {"sites": sites, "iterations": -1}
        self.refuse(self.graph.voronoi, (wrong, "iterations"))

    def test_isolines(self):
        distances = self.graph.distance(5)
        values = [0.5 * distances.max(), 0.25 * distances.max()]
        lines = self.graph.isolines(5, values)
        self.assertEqual({line.value for line in lines}, set(values))
        for line in lines:
            np.testing.assert_array_equal(line.points[0], line.points[-1])  # closed
            self.assertAlmostEqual(line.arc_lengths[-1], support.length_of(line.points))
        some = self.graph.isolines(5, 4)
        self.assertEqual(len({line.value for line in some}), 4)
        self.assertTrue(0.0 < some[0].value < some[-1].value < 1.02 * distances.max())
        with self.assertWarnsRegex(RuntimeWarning, "no isolines"):
            self.assertEqual(self.graph.isolines(5, 100.0 * distances.max()), [])
        drawn = self.graph.isolines(5, values, as_polydata=True)
        self.assertEqual(drawn.GetNumberOfLines(), len(lines))
        np.testing.assert_array_equal(self.graph.distance(5), distances)
        self.refuse(
            self.graph.isolines,
            ((5, "x"), "values"),
            ((5, [np.nan]), "values"),
            ((5, None), "values"),
            ((5, -3), "values: expected a non-negative number of isolines, got -3"),
            ((5, []), "values: expected at least one, got none"),
            ((5, 10**9), "values: expected at most 10000, got 1000000000"),
        )

    def test_loop(self):
        graph = vtkdgg.Graph(*support.prism(9, 6), accuracy=0.02)
        for loops in (graph.loop(), graph.loop(30, taut=True), graph.loop([28, 31, 34], rope=True)):
            self.assertEqual(len(loops), 1)
            self.assertAlmostEqual(loops[0].length, 9.0, delta=1e-6)
            np.testing.assert_array_equal(loops[0].points[0], loops[0].points[-1])
        self.assertEqual(len(graph.loop([28, 40])), 2)
        self.assertEqual(graph.loop(as_polydata=True).GetNumberOfLines(), 1)
        self.refuse(graph.loop, ({"rope": True}, "expected points for a rope"))
        self.refuse(graph.loop, ({"points": [1, 2], "rope": True}, ""), error=vtkdgg.Error)

    def test_texts(self):
        graph = self.graph
        for thing, pattern in (
            (graph.sample(3), "Samples: 3, covering radius"),
            (graph.voronoi([1, 2]), "Voronoi: 2 sites, 642 points"),
            (graph.isolines(5, 1)[0], "Isoline: value .*, .* points"),
            (graph.path(1, 2), "Path: length .* points"),
            (graph.path(1, 1), "Path: length 0, 1 point>"),
            (graph, "Graph: 642 points"),
        ):
            self.assertRegex(repr(thing), pattern)


class Ends(support.Test):
    """Ends of paths that are wrong, not connected, or on a seam."""

    def test_not_connected(self):
        points, triangles = support.two_squares([5, 0, 0])
        mesh = np.vstack([points, [[1.0, 1.0, 0.0]]]), triangles
        graph = vtkdgg.Graph(*mesh, accuracy=0.1)
        ends = (0, 4), (0, 8), ([0.5, 0.5, 0.0], [5.5, 0.2, 0.0]), (4, [0.5, 0.0, 0.0])
        ends += (([0.5, 0.5, 0.0], 8),)  # a position on the surface, but not connected with it
        for find in (lambda *ends: vtkdgg.path(*mesh, *ends), graph.path):
            self.refuse(find, *((pair, "not connected by the surface") for pair in ends))
        with self.assertWarnsRegex(RuntimeWarning, "No path on the surface"):
            found = graph.paths([0, 0, 4], [3, 5, 7])
        self.assertIsNone(found[1])
        np.testing.assert_allclose([found[0].length, found[2].length], np.sqrt(2.0))
        matrix = graph.matrix([0, 4], [1, 5])
        np.testing.assert_array_equal(np.isnan(matrix), [[False, True], [True, False]])
        self.assertEqual(graph.matrix(0, 5, unreached=-1.0)[0, 0], -1.0)

    def test_seams(self):
        mesh = support.two_squares([1.0, 0.0, 0.0])
        path = vtkdgg.path(*mesh, 0, 7, merge_coincident_points=True)
        self.assertAlmostEqual(path.length, np.sqrt(5.0), delta=1e-12)
        path = vtkdgg.path(*mesh, 4, [0.0, 0.0, 0.0], merge_coincident_points=True)
        self.assertEqual(path.point_ids[0], 1)  # the first of both
        pattern = "not connected .*merge_coincident_points"
        self.refuse(vtkdgg.path, ((*mesh, 0, 7), pattern))

    def test_mistakes(self):
        mesh = [[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]
        graph = vtkdgg.Graph(*mesh)
        for find in (lambda *ends: vtkdgg.path(*mesh, *ends), graph.path):
            self.refuse(
                find,
                ((0, 3), r"end: point id 3 .*does not exist"),
                ((-1, 0), r"start: point id -1 .*does not exist"),
                ((0, 1.5), "end: expected a point id"),
                (([0, 1], 0), "start: expected a point id"),
                (([0, 0, 1], 0), "start: expected a point id"),  # three ids, or coordinates?
                (([[0, 1, 2]], 0), "start: expected a point id"),
                (([(0, (0.2, 0.3, 0.5))], 1), "start: expected .* got a list"),
                ((True, 0), "start: expected numbers"),
                (("a", 0), "start: expected numbers"),
                ((None, 0), "start: "),
                ((0, [0, 0, np.nan]), "end: row 0 is not finite"),
            )
        far = [1.0, 1.0, 1.0]
        wrong = ([[0.0, 0.0, 0.0], far], 0), "Start of pair 1, at .*projection_tolerance"
        self.refuse(graph.paths, wrong, error=vtkdgg.Error)
        wrong = (0, far), "End of pair 0, at .*projection_tolerance"
        self.refuse(graph.path, wrong, error=vtkdgg.Error)
        self.assertEqual(graph.path(0, far, projection_tolerance=1).points[-1, 2], 0.0)
        given = {"start": 0, "end": 1}
        self.refuse(graph.path, ({**given, "projection_tolerance": -1}, "projection_tolerance"))
        self.refuse(
            lambda **given: vtkdgg.path(*mesh, **given),
            ({**given, "accuracy": 0.7}, "`accuracy` is 0.7. Use a number"),
        )


@support.needs_clouds
class OfACloud(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points = support.plane(41, 21)
        cls.cloud = vtkdgg.CloudGraph(cls.points)

    def test_queries(self):
        cloud, straight = self.cloud, np.linalg.norm(self.points - self.points[0], axis=1)
        np.testing.assert_allclose(cloud.distance(0), straight, rtol=0.01, atol=1e-9)
        np.testing.assert_allclose(cloud.matrix(0, [9, 100])[0], straight[[9, 100]], rtol=0.01)
        self.assertAlmostEqual(cloud.path(0, 860).length, straight[860], delta=0.02)
        self.assertAlmostEqual(cloud.paths(0, [860, 40])[1].length, straight[40], delta=0.02)
        self.assertAlmostEqual(cloud.distance([0.501, 0.5, 0.0])[0], 0.708, delta=0.03)
        self.assertEqual(len(cloud.sample(20).points), 20)
        cells = cloud.voronoi([0, 40])
        self.assertIsNone(cells.areas)
        self.assertEqual(cells.nearest[[0, 40]].tolist(), [0, 1])
        coloured = cloud.voronoi([0, 40], as_polydata=True)
        self.assertTrue(coloured.GetPointData().HasArray("GeodesicSource"))
        self.assertTrue((cloud.components == 0).all())
        self.assertTrue(cloud.is_cloud)
        self.assertRegex(repr(cloud), "CloudGraph: 861 points, .* scheme C, [^,]* MiB")
        if sparse:
            matrix = cloud.sparse_matrix(0.1)
            ids, distances = cloud.neighborhood(5, 0.1)
            self.assertEqual(len(ids), matrix[5].nnz + 1)
            np.testing.assert_array_equal(distances, cloud.distance(5)[ids])
            self.assertEqual(cloud.csr.shape, (861, 861))

    def test_constructors(self):
        for graph in (
            vtkdgg.Graph.from_points(self.points),
            vtkdgg.CloudGraph(support.polydata(self.points)),
            vtkdgg.CloudGraph.from_polydata(self.cloud.polydata),
            pickle.loads(pickle.dumps(self.cloud)),  # noqa: S301
        ):
            np.testing.assert_allclose(graph.distance(7), self.cloud.distance(7), atol=1e-6)
        flat = vtkdgg.CloudGraph(self.points, normals=np.tile([0.0, 0, 1], (861, 1)), scheme="B")
        self.assertEqual(flat.construction, "B")
        self.refuse(
            vtkdgg.CloudGraph,
            (([],), "points: expected at least one"),
            (([[0, 0]],), "points: expected the shape"),
            ({"points": self.points, "normals": [[0, 0, 1]]}, "normals: expected one per point, 861"),
            ({"points": self.points, "scheme": "D"}, "scheme"),
        )
        with mock.patch.object(vtkdgg._kernel, "cloud_graph"):
            del vtkdgg._kernel.cloud_graph
            self.refuse(vtkdgg.CloudGraph, ((self.points,), "build it with DGG_WITH_PCL"))
        self.refuse(vtkdgg.Graph.from_polydata, ((self.cloud.polydata,), "CloudGraph"))
        given = {"points": self.cloud.polydata, "sources": 0, "accuracy": 0.001}
        pattern = "accuracy: applies to meshes, not to point clouds"
        self.refuse(vtkdgg.distance, (given, pattern))
        mesh = vtkdgg.Graph(*support.grid(2, 2)).polydata
        self.refuse(
            vtkdgg.CloudGraph.from_polydata,
            ((vtkPolyData(),), "no graph"),
            ((mesh,), "see vtkdgg.Graph"),
        )


class Spectral(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.mesh = support.polydata(cls.points, cls.triangles)

    def test_greens_function(self):
        found = vtkdgg.greens_function(self.mesh, [0, 10])
        self.assertEqual(vtkdgg.greens_function(self.mesh, [0]).shape, (642,))
        self.assertEqual(vtkdgg.greens_function(self.mesh, 0, at=[self.points[3]]).shape, (1,))
        at = vtkdgg.greens_function(self.mesh, [0, 10], at=self.points[[3, 4]])
        np.testing.assert_allclose(at, found[[3, 4]], atol=1e-6)
        vertex = vtkdgg.greens_function(self.mesh, 0, method="Vertex")
        self.assertGreater(np.abs(vertex - found[:, 0]).max(), 1e-3)
        held = vtkdgg.greens_function(*support.grid(6, 6), 24, boundary="Dirichlet")
        self.assertAlmostEqual(held[0], 0.0)
        squares = vtkdgg.greens_function(self.mesh, [0, 10], order=2)
        self.assertAlmostEqual(squares[0, 1], squares[10, 0], 3)
        self.refuse(
            lambda **given: vtkdgg.greens_function(self.mesh, 0, **given),
            ({"order": 3}, "order: expected 1 or 2"),
            ({"method": "Best"}, "one of"),
            ({"boundary": "Robin"}, "one of"),
        )

    def test_biharmonic(self):
        found = vtkdgg.biharmonic(self.mesh, [0, 10])
        self.assertEqual(found.shape, (642, 2))
        self.assertAlmostEqual(found[0, 1], found[10, 0], delta=1e-9)
        exact = vtkdgg.biharmonic(self.mesh, [0, 10], method="Exact")
        np.testing.assert_allclose(found, exact, atol=0.05 * exact.max())
        options = {"kind": "Diffusion", "diffusion_time": 0.1, "number_of_eigenvalues": 30}
        diffused = vtkdgg.biharmonic(self.mesh, 0, **options)
        self.assertEqual(diffused.shape, (642,))
        surface = vtkdgg.biharmonic(self.mesh, 0, as_polydata=True)
        self.assertTrue(surface.GetPointData().HasArray("BiharmonicDistance"))

    def test_interpolate(self):
        sites = list(range(0, 642, 13))
        truth = np.sin(2.0 * self.points[:, 0]) + self.points[:, 1]
        for order in (1, 2):
            found = vtkdgg.interpolate(self.mesh, sites, truth[sites], order=order)
            self.assertEqual(found.shape, (642,))
            np.testing.assert_allclose(found[sites], truth[sites], atol=1e-9)
        # Coordinates, several values at a site, and chosen positions.
        both = np.column_stack([truth, np.full(642, 3.0)])
        middle = self.points[self.triangles[[3, 500]]].mean(axis=1)
        there = vtkdgg.interpolate(self.mesh, middle, both[:2], at=middle)
        np.testing.assert_allclose(there, both[:2], atol=1e-9)
        one = vtkdgg.interpolate(self.mesh, sites, truth[sites].reshape(-1, 1))
        np.testing.assert_array_equal(one, found)
        np.testing.assert_array_equal(vtkdgg.interpolate(self.mesh, 7, 2.5), 2.5)
        data = vtkdgg.interpolate(self.mesh, sites, truth[sites], as_polydata=True).GetPointData()
        self.assertEqual(data.GetArrayName(0), "Interpolation")
        self.assertEqual(data.GetNumberOfArrays(), 1)
        call = vtkdgg.interpolate
        self.refuse(
            call,
            ((self.mesh, 0), "values: missing"),
            ((self.mesh, [0, 1], [1.0]), "values: expected one row for each of 2 sites"),
            ((self.mesh, [0], [[[1.0]]]), "values: expected one row"),
            ((self.mesh, [0, 642], [1.0, 2.0]), "sites: "),
            ((self.mesh, [0], "x"), "values: expected numbers"),
        )
        self.refuse(
            call,
            ((self.mesh, [3, 3], [1.0, 2.0]), "same as site 0"),
            ((self.mesh, [3, 4], [1.0, np.nan]), "point 1, which is a site"),
            error=vtkdgg.Error,
        )

    def test_earth_movers(self):
        moved = vtkdgg.earth_movers(self.mesh, 0, 20)
        self.assertLessEqual(moved.lower_bound, moved.distance)
        self.assertEqual((moved.potential.shape, moved.flow.shape), ((642,), (1280, 3)))
        start, end = np.zeros(642), np.zeros(642)
        start[0] = end[20] = 1.0
        masses = vtkdgg.earth_movers(self.mesh, start, end, density=False)
        self.assertAlmostEqual(masses.distance, moved.distance, delta=0.01 * moved.distance)
        output = vtkdgg.earth_movers(self.mesh, 0, 20, as_polydata=True)
        self.assertTrue(output.GetPointData().HasArray("EarthMoversPotential"))
        wrong = (self.mesh, np.full(642, np.nan), end), "start: entry 0 is not finite"
        self.refuse(vtkdgg.earth_movers, wrong)
        triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
        wrong = (triangle, [1.0, 0.0, 0.0], 1), "three numbers may be masses"
        self.refuse(vtkdgg.earth_movers, wrong)
        with warnings_as("ignore"):
            self.refuse(vtkdgg.earth_movers, ((self.mesh, -start, end), ""), error=vtkdgg.Error)


if __name__ == "__main__":
    unittest.main()
