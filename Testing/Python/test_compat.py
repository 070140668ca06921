# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.compat: code for other packages runs with only the import changed. The peers are used as
well, where they are installed."""

import importlib
import os
import unittest

import numpy as np
import support
import vtkdgg
import vtkdgg.compat as gdist
import vtkdgg.compat as geodesic
import vtkdgg.compat as pp3d

try:
    import scipy.sparse as sparse
except ImportError:
    sparse = None


def peer(name):
    """Another package, or None."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


class Potpourri3d(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.V, cls.F = support.bumpy()
        cls.exact = vtkdgg.distance(cls.V, cls.F, 7)

    def test_heat(self):
        solver = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F)
        dist = solver.compute_distance(7)
        self.assertLess(np.abs(dist - self.exact).mean(), 0.03 * self.exact.max())
        np.testing.assert_array_equal(dist, pp3d.compute_distance(self.V, self.F, 7))
        several = solver.compute_distance_multisource([1, 2, 3])
        np.testing.assert_array_equal(
            several, pp3d.compute_distance_multisource(self.V, self.F, [1, 2, 3])
        )
        exact = vtkdgg.distance(self.V, self.F, [1, 2, 3])
        self.assertLess(np.abs(several - exact).mean(), 0.03 * exact.max())
        smooth = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F, t_coef=10.0, use_robust=False)
        self.assertGreater(np.abs(smooth.compute_distance(7) - dist).max(), 1e-3 * dist.max())
        for wrong in (-1, 642, 0.5, [0.1, 0.2, 0.3]):
            with self.assertRaises(ValueError):
                solver.compute_distance(wrong)

    def test_paths(self):
        path_solver = pp3d.EdgeFlipGeodesicSolver(self.V, self.F)
        path_pts = path_solver.find_geodesic_path(v_start=14, v_end=22)
        exact = vtkdgg.path(self.V, self.F, 14, 22)
        length = np.linalg.norm(np.diff(path_pts, axis=0), axis=1).sum()
        self.assertAlmostEqual(length, exact.length, delta=1e-6)
        np.testing.assert_array_equal(path_pts[[0, -1]], self.V[[14, 22]])
        same = path_solver.find_geodesic_path_poly([14, 22])
        np.testing.assert_array_equal(same, path_pts)
        with self.assertRaises(NotImplementedError):
            path_solver.find_geodesic_path_poly([14, 22, 40])
        with self.assertRaises(NotImplementedError):
            path_solver.find_geodesic_path(14, 22, max_iterations=3)

    def test_loops(self):
        path_solver = pp3d.EdgeFlipGeodesicSolver(*support.prism(9, 6))
        loop = path_solver.find_geodesic_loop([28, 31, 34])
        self.assertAlmostEqual(np.linalg.norm(np.diff(loop, axis=0), axis=1).sum(), 9.0, 6)
        np.testing.assert_array_equal(loop[0], loop[-1])

    @unittest.skipUnless(peer("potpourri3d"), "no potpourri3d")
    def test_beside_it(self):
        other = peer("potpourri3d")
        theirs = other.MeshHeatMethodDistanceSolver(self.V, self.F).compute_distance(7)
        ours = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F).compute_distance(7)
        self.assertLessEqual(
            np.abs(ours - self.exact).mean(), 1.05 * np.abs(theirs - self.exact).mean()
        )
        for v in (0, 99, 500):
            lengths = [
                np.linalg.norm(np.diff(p.find_geodesic_path(7, v), axis=0), axis=1).sum()
                for p in (m.EdgeFlipGeodesicSolver(self.V, self.F) for m in (pp3d, other))
            ]
            self.assertLessEqual(lengths[0], lengths[1] * (1 + 1e-9))


class Pygeodesic(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.faces = support.bumpy()
        cls.geoalg = geodesic.PyGeodesicAlgorithmExact(cls.points, cls.faces)

    def test_distance(self):
        distance, path = self.geoalg.geodesicDistance(25, 97)
        self.assertAlmostEqual(distance, vtkdgg.distance(self.points, self.faces, 25)[97])
        np.testing.assert_array_equal(path[[0, -1]], self.points[[97, 25]])  # as it does
        self.assertAlmostEqual(np.linalg.norm(np.diff(path, axis=0), axis=1).sum(), distance)
        with self.assertRaises(ValueError):
            self.geoalg.geodesicDistance(25, 9999)

    def test_distances(self):
        exact = vtkdgg.distance(self.points, self.faces, [25, 100])
        distances, best_source = self.geoalg.geodesicDistances(np.array([25, 100]))
        np.testing.assert_array_equal(distances, exact)
        self.assertEqual(set(best_source), {0, 1})
        np.testing.assert_array_equal(best_source[[25, 100]], [0, 1])
        some, _ = self.geoalg.geodesicDistances([25, 100], [3, 4])
        np.testing.assert_array_equal(some, exact[[3, 4]])
        default, _ = self.geoalg.geodesicDistances()
        self.assertEqual(default[0], 0.0)
        limit = np.median(exact)
        near, _ = self.geoalg.geodesicDistances([25, 100], max_distance=limit)
        np.testing.assert_array_equal(np.isinf(near), exact > limit)

    def test_files(self):
        path = os.path.join(support.output_folder("compat"), "mesh.txt")
        points, faces = support.grid(2, 1)
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"{len(points)} {len(faces)}\n")
            np.savetxt(file, points, delimiter="\t")
            np.savetxt(file, faces, fmt="%d")
        result = geodesic.read_mesh_from_file(path)
        np.testing.assert_allclose(result[0], points)
        np.testing.assert_array_equal(result[1], faces)
        with open(path, "w", encoding="utf-8") as file:
            file.write("9 9\n0 0 0\n")
        with self.assertRaisesRegex(ValueError, "18 lines"):
            geodesic.read_mesh_from_file(path)

    @unittest.skipUnless(peer("pygeodesic"), "no pygeodesic")
    def test_beside_it(self):
        other = peer("pygeodesic.geodesic").PyGeodesicAlgorithmExact(self.points, self.faces)
        for ours, theirs in zip(
            self.geoalg.geodesicDistances([25, 100]), other.geodesicDistances([25, 100])
        ):
            np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-12)
        ours, theirs = (g.geodesicDistance(25, 97) for g in (self.geoalg, other))
        self.assertAlmostEqual(ours[0], theirs[0])
        np.testing.assert_allclose(ours[1][[0, -1]], theirs[1][[0, -1]])


class Gdist(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.triangles = support.grid(10, 10)
        cls.vertices *= 0.1

    def test_distances(self):
        src = np.array([1], dtype=np.int32)
        trg = np.array([3], dtype=np.int32)
        found = gdist.compute_gdist(
            self.vertices, self.triangles, source_indices=src, target_indices=trg
        )
        np.testing.assert_allclose(found, [0.2])
        straight = np.linalg.norm(self.vertices - self.vertices[0], axis=1)
        found = gdist.compute_gdist(self.vertices, self.triangles + 1, is_one_indexed=True)
        np.testing.assert_allclose(found, straight, atol=1e-12)
        near = gdist.compute_gdist(self.vertices, self.triangles, max_distance=0.55)
        np.testing.assert_array_equal(np.isinf(near), straight > 0.55)

    @unittest.skipUnless(sparse, "no SciPy")
    def test_matrices(self):
        found = gdist.local_gdist_matrix(self.vertices, self.triangles, max_distance=0.25)
        offset = self.vertices[:, None] - self.vertices[None]
        straight = np.linalg.norm(offset, axis=2)
        straight[straight > 0.25] = 0.0
        self.assertIsInstance(found, sparse.csc_matrix)
        np.testing.assert_allclose(found.toarray(), straight, atol=1e-12)
        points = np.array([2, 5, 10], dtype=np.int32)
        some = gdist.distance_matrix_of_selected_points(self.vertices, self.triangles, points)
        self.assertEqual((some.nnz, some.shape), (6, (121, 121)))
        self.assertAlmostEqual(some[2, 5], 0.3)

    @unittest.skipUnless(peer("gdist"), "no gdist")
    def test_beside_it(self):
        triangles = self.triangles.astype(np.int32)
        for limit in (np.inf, 0.55):
            np.testing.assert_allclose(
                gdist.compute_gdist(self.vertices, triangles, max_distance=limit),
                peer("gdist").compute_gdist(self.vertices, triangles, max_distance=limit),
                atol=1e-12,
            )


if __name__ == "__main__":
    unittest.main()
