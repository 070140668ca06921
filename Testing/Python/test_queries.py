# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What else graphs answer: batches of paths, sparse matrices, samples, cells, isolines, loops; the
same of clouds; functions that stand on the Laplacian."""

import pickle
import tempfile
import unittest
import warnings
from unittest import mock

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkCommonDataModel import vtkPolyData

try:
    import scipy.sparse as sparse
except ImportError:
    sparse = None


class OfAMesh(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, cls.triangles, accuracy=0.02)
        cls.size = np.ptp(cls.points, axis=0).max()

    def test_distance_as_polydata(self):
        surface = self.graph.distance([5, 40], as_polydata=True)
        distances, nearest = self.graph.distance([5, 40], return_source=True)
        kept = support.point_array(surface, "GeodesicDistance")
        np.testing.assert_array_equal(kept, distances)
        np.testing.assert_array_equal(support.point_array(surface, "GeodesicSource"), nearest)
        self.graph.distance([7])
        self.graph.distance([7], as_polydata=True)
        np.testing.assert_array_equal(support.point_array(surface, "GeodesicDistance"), kept)

    def test_paths(self):
        starts, ends = [5, 17, 318, 5], [318, 5, 17, 5]
        found = self.graph.paths(starts, ends)
        for start, end, path in zip(starts, ends, found):
            alone = self.graph.path(start, end)
            np.testing.assert_array_equal(path.points, alone.points)
            self.assertEqual(path.length, alone.length)
        self.assertEqual(len(found[3].points), 1)
        lines = self.graph.paths(starts[:3], ends[:3], as_polydata=True)
        self.assertEqual(lines.GetNumberOfLines(), 3)
        fan = self.graph.paths(5, ends[:3])
        back = self.graph.paths(ends[:3], [5])
        self.assertEqual([len(fan), len(back)], [3, 3])
        np.testing.assert_allclose([p.length for p in fan], [p.length for p in back], rtol=0.02)
        mixed = self.graph.paths(self.points[[5, 17]] + 1e-9, [318, 5])
        self.assertAlmostEqual(mixed[0].length, found[0].length, delta=1e-4 * self.size)
        with self.assertRaisesRegex(ValueError, "expected equal numbers"):
            self.graph.paths([1, 2, 3], [1, 2])

    def test_paths_that_are_not_there(self):
        graph = vtkdgg.Graph(*support.two_squares([5, 0, 0]), accuracy=0.1)
        with self.assertWarnsRegex(RuntimeWarning, "not connected"):
            found = graph.paths([0, 0, 4], [3, 5, 7])
        self.assertIsNone(found[1])
        self.assertAlmostEqual(found[0].length, np.sqrt(2.0))
        self.assertAlmostEqual(found[2].length, np.sqrt(2.0))

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
        place = self.graph.sparse_matrix(radius, self.points[[7]] + 1e-9)
        self.assertEqual(place.nnz, rows[0].nnz + 1)
        # The filter is the same that fills dense matrices.
        self.assertEqual(np.isfinite(self.graph.matrix([0, 5])).all(), True)
        self.assertEqual(self.graph.sparse_matrix(0.0).nnz, 0)
        with self.assertRaisesRegex(ValueError, "maximum_distance"):
            self.graph.sparse_matrix(-1.0)

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
        with self.assertRaisesRegex(
            ValueError, r"out: expected the shape \(40, 3\), got \(3, 40\)"
        ):
            self.graph.matrix(rows, columns, out=np.empty((3, 40)))
        read_only = np.zeros((40, 3))
        read_only.flags.writeable = False
        for given, pattern in (
            ({"out": np.zeros((40, 3), dtype=int)}, "out: expected a floating-point type, got int"),
            ({"out": [[0.0] * 3] * 40}, "out: expected an array, got list"),
            ({"out": "x.npy"}, "out: expected an array, got str"),
            ({"out": read_only}, "out: the array is read-only"),
            ({"out": np.zeros((40, 3)), "dtype": "f4"}, "dtype: expected float64, .* got float32"),
            ({"dtype": np.int32}, "dtype: expected a floating-point type, got int32"),
            ({"dtype": "x"}, "dtype: expected a floating-point type, got 'x'"),
        ):
            with self.subTest(given=given), self.assertRaisesRegex(ValueError, pattern):
                self.graph.matrix(rows, columns, **given)

    def test_neighborhood(self):
        radius = 0.2 * self.size
        for source in (7, self.points[7] + 1e-3 * self.size, (40, (0.2, 0.3, 0.5))):
            for correction in (True, False):
                ids, distances = self.graph.neighborhood(source, radius, correction=correction)
                field = self.graph.distance(
                    [source], correction=correction, maximum_distance=radius
                )
                np.testing.assert_array_equal(np.sort(ids), np.flatnonzero(np.isfinite(field)))
                np.testing.assert_array_equal(distances, field[ids])
                self.assertTrue((np.diff(distances) >= 0.0).all())
        ids, distances = self.graph.neighborhood(7, 0.0)
        self.assertEqual((ids.tolist(), distances.tolist()), ([7], [0.0]))
        self.assertEqual(len(self.graph.neighborhood(self.points[7] + 1e-3 * self.size, 0.0)[0]), 0)
        with self.assertRaisesRegex(ValueError, "radius"):
            self.graph.neighborhood(7, -1.0)
        with self.assertRaisesRegex(ValueError, "source"):
            self.graph.neighborhood([7, 8], 1.0)

    def test_preparations_are_kept(self):
        """Ids between coordinates do not release what links the coordinates."""
        near = self.points[[7, 90, 200]] + 1e-3 * self.size
        for kind, ask in (
            (vtkdgg.vtkDGGDistance, self.graph.distance),
            (vtkdgg.vtkDGGLoop, self.graph.loop),
            (vtkdgg.vtkDGGPath, lambda points: self.graph.paths(points, 300)),
            (vtkdgg.vtkGeodesicDistanceMatrix, self.graph.matrix),
            (vtkdgg.vtkGeodesicSampler, lambda points: self.graph.sample(5, start=points)),
            (vtkdgg.vtkGeodesicVoronoi, self.graph.voronoi),
        ):
            with self.subTest(kind=kind.__name__):
                ask(near)
                size = self.graph._filters[kind].GetMemorySize()
                ask([7, 90, 200])
                self.assertEqual(self.graph._filters[kind].GetMemorySize(), size)

    def test_sample(self):
        samples = self.graph.sample(30, first=5)
        self.assertEqual((samples.point_ids[0], len(samples.points)), (5, 30))
        np.testing.assert_array_equal(samples.points, self.points[samples.point_ids])
        self.assertTrue((np.diff(samples.covering_radii) <= 0).all())
        distances = self.graph.distance(samples.point_ids, correction=False)
        self.assertAlmostEqual(distances.max(), samples.covering_radii[-1], delta=0.03 * self.size)
        again = self.graph.sample(40, start=[5, 17], in_faces=True)
        np.testing.assert_allclose(again.points[:2], self.points[[5, 17]], atol=1e-12)
        coarse = self.graph.sample(600, covering_radius=0.2 * self.size)
        self.assertLessEqual(coarse.covering_radii[-1], 0.2 * self.size)
        self.assertLess(len(coarse.points), 600)
        self.assertEqual(self.graph.sample(9, as_polydata=True).GetNumberOfPoints(), 9)
        with self.assertRaisesRegex(ValueError, "number_of_samples: expected at least 1, got 0"):
            self.graph.sample(0)

    def test_voronoi(self):
        sites = [5, 17, 318]
        cells = self.graph.voronoi(sites)
        distances, nearest = self.graph.distance(sites, return_source=True)
        self.assertGreater(np.mean(cells.nearest == nearest), 0.99)
        np.testing.assert_allclose(cells.distances, distances, rtol=0.02, atol=1e-9)
        np.testing.assert_allclose(cells.sites, self.points[sites])
        surface = support.triangles_of(support.polydata(self.points, self.triangles))
        a, b, c = np.moveaxis(self.points[surface], 1, 0)
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
        self.assertAlmostEqual(cells.areas.sum(), area, delta=1e-6 * area)
        cut = self.graph.voronoi(sites, as_polydata=True)
        self.assertTrue(cut.GetCellData().HasArray("SiteId"))
        moved = self.graph.voronoi(sites, iterations=5)
        self.assertLess(np.ptp(moved.areas), np.ptp(cells.areas))
        with self.assertRaisesRegex(ValueError, "iterations"):
            self.graph.voronoi(sites, iterations=-1)

    def test_isolines(self):
        exact = vtkdgg.distance(self.points, self.triangles, 5)
        values = [0.5 * exact.max(), 0.25 * exact.max()]
        lines = self.graph.isolines(5, values)
        self.assertEqual({line.value for line in lines}, set(values))
        for line in lines:
            np.testing.assert_array_equal(line.points[0], line.points[-1])  # closed
            for point in line.points[:: max(1, len(line.points) // 5)]:
                length = vtkdgg.path(self.points, self.triangles, 5, point).length
                self.assertAlmostEqual(length, line.value, delta=0.02 * line.value)
        some = self.graph.isolines(5, 4)
        self.assertEqual(len({line.value for line in some}), 4)
        self.assertTrue(0.0 < some[0].value < some[-1].value < 1.02 * exact.max())
        with self.assertWarnsRegex(RuntimeWarning, "no isolines"):
            self.assertEqual(self.graph.isolines(5, 100.0 * exact.max()), [])
        drawn = self.graph.isolines(5, values, as_polydata=True)
        self.assertEqual(drawn.GetNumberOfLines(), len(lines))
        # A query afterwards is what it was before.
        self.assertLess(np.abs(self.graph.distance(5) - exact).max(), 0.02 * exact.max())
        for wrong, pattern in (
            ("x", "values"),
            ([np.nan], "values"),
            (None, "values"),
            (-3, "values: expected a number of isolines, got -3"),
            ([], "values: expected at least one, got none"),
            (10**9, "values: expected at most 10000, got 1000000000"),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(ValueError, pattern):
                self.graph.isolines(5, wrong)

    def test_loop(self):
        graph = vtkdgg.Graph(*support.prism(9, 6), accuracy=0.02)
        for loops in (graph.loop(), graph.loop(30, taut=True), graph.loop([28, 31, 34], rope=True)):
            self.assertEqual(len(loops), 1)
            self.assertAlmostEqual(loops[0].length, 9.0, delta=1e-6)
            np.testing.assert_array_equal(loops[0].points[0], loops[0].points[-1])
        self.assertEqual(len(graph.loop([28, 40])), 2)
        self.assertEqual(graph.loop(as_polydata=True).GetNumberOfLines(), 1)
        with self.assertRaisesRegex(ValueError, "expected points for a rope"):
            graph.loop(rope=True)
        with self.assertRaises(vtkdgg.VTKError):
            graph.loop([1, 2], rope=True)

    def test_texts(self):
        graph = self.graph
        for thing, pattern in (
            (graph.sample(3), "Samples: 3, covering radius"),
            (graph.voronoi([1, 2]), "Voronoi: 2 sites, 642 points"),
            (graph.isolines(5, 1)[0], "Isoline: value .*, .* points"),
            (graph.path(1, 2), "Path: length"),
            (graph, "Graph: 642 points"),
        ):
            self.assertRegex(repr(thing), pattern)


@unittest.skipUnless(support.HAS_CLOUDS, "built without PCL")
class OfACloud(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = support.plane(41, 21)
        cls.cloud = vtkdgg.CloudGraph(cls.points)

    def test_distances(self):
        straight = np.linalg.norm(self.points - self.points[0], axis=1)
        np.testing.assert_allclose(self.cloud.distance(0), straight, rtol=0.01, atol=1e-9)
        np.testing.assert_allclose(
            self.cloud.matrix([0, 5], [9, 100]), np.linalg.norm(
                self.points[[0, 5], None] - self.points[None, [9, 100]], axis=2
            ), rtol=0.01,
        )  # fmt: skip
        self.assertAlmostEqual(self.cloud.path(0, 860).length, straight[860], delta=0.02)
        found = self.cloud.paths(0, [860, 40])
        self.assertAlmostEqual(found[1].length, straight[40], delta=0.02)
        self.assertAlmostEqual(self.cloud.distance([0.501, 0.5, 0.0])[0], 0.708, delta=0.03)

    def test_what_follows(self):
        samples = self.cloud.sample(20)
        self.assertEqual(len(samples.points), 20)
        cells = self.cloud.voronoi([0, 40])
        self.assertIsNone(cells.areas)
        self.assertEqual(cells.nearest[0], 0)
        self.assertEqual(cells.nearest[40], 1)
        coloured = self.cloud.voronoi([0, 40], as_polydata=True)
        self.assertTrue(coloured.GetPointData().HasArray("GeodesicSource"))
        self.assertTrue((self.cloud.components == 0).all())
        self.assertTrue(self.cloud.is_cloud)
        self.assertRegex(repr(self.cloud), "CloudGraph: 861 points, .* scheme C, [^,]* MiB")
        if sparse:
            matrix = self.cloud.sparse_matrix(0.1)
            self.assertGreater(matrix.nnz, 861)
            ids, distances = self.cloud.neighborhood(5, 0.1)
            self.assertEqual(len(ids), matrix[5].nnz + 1)
            np.testing.assert_array_equal(distances, self.cloud.distance(5)[ids])
            self.assertEqual(self.cloud.csr.shape, (861, 861))

    def test_ways_to_have_one(self):
        mesh = support.polydata(self.points, np.empty((0, 3)))
        graphs = [
            vtkdgg.Graph.from_points(self.points),
            vtkdgg.CloudGraph(mesh),
            vtkdgg.CloudGraph.from_polydata(self.cloud.polydata),
            pickle.loads(pickle.dumps(self.cloud)),  # noqa: S301
        ]
        for graph in graphs:
            np.testing.assert_allclose(graph.distance(7), self.cloud.distance(7), atol=1e-6)
        flat = vtkdgg.CloudGraph(self.points, normals=np.tile([0.0, 0, 1], (861, 1)), scheme="B")
        self.assertEqual(flat.construction, "B")

    def test_mistakes(self):
        for call, pattern in (
            (lambda: vtkdgg.CloudGraph([]), "points: expected at least one"),
            (lambda: vtkdgg.CloudGraph([[0, 0]]), "points: expected the shape"),
            (lambda: vtkdgg.CloudGraph(self.points, normals=[[0, 0, 1]]), "normals: expected 861"),
            (lambda: vtkdgg.CloudGraph(self.points, scheme="D"), "scheme"),
            (lambda: vtkdgg.Graph.from_polydata(self.cloud.polydata), "CloudGraph"),
            (
                lambda: vtkdgg.distance(self.cloud.polydata, 0, accuracy=0.001),
                "accuracy: applies to meshes, not to point clouds",
            ),
            (lambda: vtkdgg.CloudGraph.from_polydata(vtkPolyData()), "no graph"),
        ):
            with self.assertRaisesRegex(ValueError, pattern):
                call()
        mesh = vtkdgg.Graph(*support.grid(2, 2)).polydata
        with self.assertRaisesRegex(ValueError, "see vtkdgg.Graph"):
            vtkdgg.CloudGraph.from_polydata(mesh)


class Spectral(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = support.polydata(*support.bumpy())

    def test_greens_function(self):
        points = support.bumpy()[0]
        found = vtkdgg.greens_function(self.mesh, [0, 10])
        solve = vtkdgg.vtkDiscreteGreensFunction()
        solve.SetInputData(self.mesh)
        solve.SetSourceIds([0, 10])
        expected = support.point_array(vtkdgg.check(solve), "GreensFunction")
        np.testing.assert_array_equal(found, expected)
        self.assertEqual(vtkdgg.greens_function(self.mesh, [0]).shape, (642,))
        self.assertEqual(vtkdgg.greens_function(self.mesh, 0, at=[points[3]]).shape, (1,))
        at = vtkdgg.greens_function(self.mesh, [0, 10], at=points[[3, 4]])
        np.testing.assert_allclose(at, found[[3, 4]], atol=1e-6)
        vertex = vtkdgg.greens_function(self.mesh, 0, method="Vertex")
        self.assertGreater(np.abs(vertex - found[:, 0]).max(), 1e-3)
        disc = support.grid(6, 6)
        held = vtkdgg.greens_function(*disc, 24, boundary="Dirichlet")
        self.assertAlmostEqual(held[0], 0.0)
        squares = vtkdgg.greens_function(self.mesh, [0, 10], order=2)
        self.assertAlmostEqual(squares[0, 1], squares[10, 0], 3)
        self.assertEqual(np.argmax(squares[:, 1]), 10)
        with self.assertRaisesRegex(ValueError, "order: expected 1 or 2"):
            vtkdgg.greens_function(self.mesh, 0, order=3)
        for options in ({"method": "Best"}, {"boundary": "Robin"}):
            with self.assertRaisesRegex(ValueError, "one of"):
                vtkdgg.greens_function(self.mesh, 0, **options)

    def test_biharmonic(self):
        found = vtkdgg.biharmonic(self.mesh, [0, 10])
        self.assertEqual(found.shape, (642, 2))
        self.assertAlmostEqual(found[0, 1], found[10, 0], delta=1e-9)
        exact = vtkdgg.biharmonic(self.mesh, [0, 10], method="Exact")
        np.testing.assert_allclose(found, exact, atol=0.05 * exact.max())
        diffused = vtkdgg.biharmonic(
            self.mesh, 0, kind="Diffusion", diffusion_time=0.1, number_of_eigenvalues=30
        )
        self.assertEqual(diffused.shape, (642,))
        self.assertTrue(np.isfinite(diffused).all())
        surface = vtkdgg.biharmonic(self.mesh, 0, as_polydata=True)
        self.assertTrue(surface.GetPointData().HasArray("BiharmonicDistance"))

    def test_interpolate(self):
        points = support.bumpy()[0]
        sites = list(range(0, 642, 13))
        truth = np.sin(2.0 * points[:, 0]) + points[:, 1]
        found = vtkdgg.interpolate(self.mesh, sites, truth[sites])
        self.assertEqual(found.shape, (642,))
        np.testing.assert_allclose(found[sites], truth[sites], atol=1e-9)
        self.assertLess(np.abs(found - truth).max(), 0.3)
        self.assertLess(np.abs(found - truth).mean(), 0.05)
        # Places and several numbers, and where they are wanted.
        both = np.column_stack([truth, np.full(642, 3.0)])
        middle = points[support.bumpy()[1][[3, 500]]].mean(axis=1)
        there = vtkdgg.interpolate(self.mesh, middle, both[:2], at=middle)
        np.testing.assert_allclose(there, both[:2], atol=1e-9)
        one = vtkdgg.interpolate(self.mesh, sites, truth[sites].reshape(-1, 1))
        np.testing.assert_array_equal(one, found)
        rough = vtkdgg.interpolate(self.mesh, sites, truth[sites], order=1)
        np.testing.assert_allclose(rough[sites], truth[sites], atol=1e-9)
        np.testing.assert_array_equal(vtkdgg.interpolate(self.mesh, 7, 2.5), 2.5)
        surface = vtkdgg.interpolate(self.mesh, sites, truth[sites], as_polydata=True)
        names = [surface.GetPointData().GetArrayName(i) for i in range(1)]
        self.assertEqual(names, ["Interpolation"])
        self.assertEqual(surface.GetPointData().GetNumberOfArrays(), 1)
        for sites, values, pattern in (
            ([0, 1], [1.0], "values: expected one row for each of 2 sites"),
            ([0], [[[1.0]]], "values: expected one row"),
            ([0, 642], [1.0, 2.0], "sites: "),
            ([0], "x", "values: expected numbers"),
        ):
            with self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.interpolate(self.mesh, sites, values)
        with self.assertRaisesRegex(ValueError, "values: missing"):
            vtkdgg.interpolate(self.mesh, 0)
        for sites, values, pattern in (
            ([3, 3], [1.0, 2.0], "same as site 0"),
            ([3, 4], [1.0, np.nan], "point 1, which is a site"),
        ):
            with self.assertRaisesRegex(vtkdgg.VTKError, pattern):
                vtkdgg.interpolate(self.mesh, sites, values)

    def test_earth_movers(self):
        moved = vtkdgg.earth_movers(self.mesh, 0, 20)
        self.assertLessEqual(moved.lower_bound, moved.distance)
        self.assertLessEqual(moved.lower_bound, vtkdgg.path(self.mesh, 0, 20).length)
        self.assertEqual(moved.potential.shape, (642,))
        self.assertEqual(moved.flow.shape, (1280, 3))
        start, end = np.zeros(642), np.zeros(642)
        start[0] = end[20] = 1.0
        masses = vtkdgg.earth_movers(self.mesh, start, end, density=False)
        self.assertAlmostEqual(masses.distance, moved.distance, delta=0.01 * moved.distance)
        output = vtkdgg.earth_movers(self.mesh, 0, 20, as_polydata=True)
        self.assertTrue(output.GetPointData().HasArray("EarthMoversPotential"))
        with self.assertRaisesRegex(ValueError, "start: entry 0 is not finite"):
            vtkdgg.earth_movers(self.mesh, np.full(642, np.nan), end)
        with self.assertRaises(vtkdgg.VTKError), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            vtkdgg.earth_movers(self.mesh, -start, end)


if __name__ == "__main__":
    unittest.main()
