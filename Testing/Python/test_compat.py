# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.compat: code for other packages runs with only the import changed. Packages that are
installed are compared with."""

import importlib
import inspect
import os
import unittest

import numpy as np
import support
import vtkdgg
from vtkdgg import compat
from vtkdgg.compat import gdist
from vtkdgg.compat import potpourri3d as pp3d
from vtkdgg.compat.pygeodesic import geodesic

try:
    import scipy.sparse as sparse
except ImportError:
    sparse = None


def peer(name):
    """Returns another package, or None if it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


# The public names of each original and of its classes. Names marked with ! are not available.
NAMES = {
    pp3d: """
        EdgeFlipGeodesicSolver.find_geodesic_loop EdgeFlipGeodesicSolver.find_geodesic_path
        EdgeFlipGeodesicSolver.find_geodesic_path_poly
        MeshFastMarchingDistanceSolver.compute_distance
        MeshHeatMethodDistanceSolver.compute_distance
        MeshHeatMethodDistanceSolver.compute_distance_multisource
        PointCloudHeatSolver.compute_distance PointCloudHeatSolver.compute_distance_multisource
        PointCloudHeatSolver.compute_log_map! PointCloudHeatSolver.compute_signed_distance!
        PointCloudHeatSolver.extend_scalar! PointCloudHeatSolver.get_tangent_frames!
        PointCloudHeatSolver.transport_tangent_vector!
        PointCloudHeatSolver.transport_tangent_vectors!
        PolygonMeshHeatSolver.compute_distance PolygonMeshHeatSolver.compute_signed_distance!
        PolygonMeshHeatSolver.extend_scalar! PolygonMeshHeatSolver.get_tangent_frames!
        PolygonMeshHeatSolver.transport_tangent_vectors!
        GeodesicTracer! MeshMarchingTrianglesSolver! MeshSignedHeatSolver! MeshVectorHeatSolver!
        PointCloudLocalTriangulation! marching_triangles!
        compute_distance compute_distance_multisource cotan_laplacian edges face_areas read_mesh
        read_point_cloud read_polygon_mesh validate_mesh validate_points vertex_areas write_mesh
        write_point_cloud""",
    geodesic: """
        PyGeodesicAlgorithmExact.geodesicDistance PyGeodesicAlgorithmExact.geodesicDistances
        read_mesh_from_file""",
    gdist: "compute_gdist distance_matrix_of_selected_points local_gdist_matrix",
}


def resolve(module, name):
    """Returns a function, class or method of a module."""
    for part in name.split("."):
        module = getattr(module, part)
    return module


class Names(support.Test):
    def test_all_are_there(self):
        for module, names in NAMES.items():
            names = names.split()
            known = {name.split(".")[0].strip("!") for name in names}
            self.assertEqual(known, set(module.__all__))
            for name in names:
                ours = resolve(module, name.strip("!"))
                with self.subTest(name=name):
                    self.assertTrue(callable(ours) and ours.__doc__)
                if name.endswith("!"):
                    wrong = {"two": 3}, r"is not available\. \w+"
                    self.refuse(ours, wrong, error=NotImplementedError)

    def test_names_match_originals(self):
        for module in NAMES:
            original = peer(module.__name__.replace("vtkdgg.compat.", ""))
            if original is None:
                continue
            ours = {word.strip("!") for word in NAMES[module].split()}
            for key, value in vars(original).items():
                if key.startswith("_") or inspect.ismodule(value):
                    continue
                methods = [k for k in vars(value) if k[0] != "_"] if inspect.isclass(value) else []
                is_missing = f"{key}!" in NAMES[module].split()
                for part in [f"{key}.{m}" for m in methods if not is_missing] or [key]:
                    with self.subTest(name=part):
                        self.assertIn(part, ours)
                        if f"{part}!" not in NAMES[module].split():
                            theirs = inspect.signature(resolve(original, part)).parameters
                            self.assertEqual(
                                list(inspect.signature(resolve(module, part)).parameters),
                                list(theirs),
                            )

    def test_names_of_the_first_version(self):
        for module in (pp3d, geodesic, gdist):
            for name in set(compat.__all__) & set(module.__all__):
                self.assertIs(getattr(compat, name), getattr(module, name))
        self.assertEqual(len(compat.__all__), 9)


class Potpourri3d(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.V, cls.F = support.bumpy()
        cls.exact = vtkdgg.distance(cls.V, cls.F, 7)

    def test_heat(self):
        solver = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F)
        dist, several = solver.compute_distance(7), solver.compute_distance_multisource([1, 2, 3])
        exact = vtkdgg.distance(self.V, self.F, [1, 2, 3])
        for found, expected in ((dist, self.exact), (several, exact)):
            self.assertLess(np.abs(found - expected).mean(), 0.03 * expected.max())
        np.testing.assert_array_equal(dist, pp3d.compute_distance(self.V, self.F, 7))
        again = pp3d.compute_distance_multisource(self.V, self.F, [1, 2, 3])
        np.testing.assert_array_equal(several, again)
        smooth = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F, t_coef=10.0, use_robust=False)
        self.assertGreater(np.abs(smooth.compute_distance(7) - dist).max(), 1e-3 * dist.max())
        wrong = -1, 642, 0.5, [0.1, 0.2, 0.3]
        self.refuse(solver.compute_distance, *(((source,), "") for source in wrong))

    def test_paths(self):
        path_solver = pp3d.EdgeFlipGeodesicSolver(self.V, self.F)
        path_pts = path_solver.find_geodesic_path(v_start=14, v_end=22)
        exact = vtkdgg.path(self.V, self.F, 14, 22)
        self.assertAlmostEqual(support.length_of(path_pts), exact.length, delta=1e-6)
        np.testing.assert_array_equal(path_pts[[0, -1]], self.V[[14, 22]])
        same = path_solver.find_geodesic_path_poly([14, 22])
        np.testing.assert_array_equal(same, path_pts)
        wrong = ([14, 22, 40],), ""
        self.refuse(path_solver.find_geodesic_path_poly, wrong, error=NotImplementedError)
        wrong = {"v_start": 14, "v_end": 22, "max_iterations": 3}, ""
        self.refuse(path_solver.find_geodesic_path, wrong, error=NotImplementedError)
        path_solver = pp3d.EdgeFlipGeodesicSolver(*support.prism(9, 6))
        loop = path_solver.find_geodesic_loop([28, 31, 34])
        self.assertAlmostEqual(support.length_of(loop), 9.0, 6)
        np.testing.assert_array_equal(loop[0], loop[-1])

    def test_marching(self):
        solver = pp3d.MeshFastMarchingDistanceSolver(self.V, self.F)
        face = 100, [0.2, 0.3]
        for curves, sources, initial in (
            ([[(7, [])]], [7], []),
            ([[face]], [(100, (0.2, 0.3, 0.5))], []),
            ([[(7, [])], [(100, [0.2, 0.3, 0.5])]], [7, (100, (0.2, 0.3, 0.5))], [[0.5], [1.0]]),
        ):
            options = {"initial_distances": np.ravel(initial)} if initial else {}
            expected = vtkdgg.distance(self.V, self.F, sources, method="marching", **options)
            np.testing.assert_array_equal(solver.compute_distance(curves, initial), expected)
        curve = [[(7, [])]]
        found = solver.compute_distance(curve, [[]])
        np.testing.assert_array_equal(found, solver.compute_distance(curve))
        wrong = [[(0.9, [])]], [[(0.9, [0.2, 0.3])]]
        self.refuse(solver.compute_distance, *(((curves,), "") for curves in wrong))
        self.refuse(
            solver.compute_distance,
            (([[(7, []), (8, [])]],), "vtkdgg.distance"),
            (([[(7, [0.5])]],), "vtkdgg.distance"),
            ({"curves": curve, "sign": True}, "vtkdgg.distance"),
            error=NotImplementedError,
        )

    def test_polygons(self):
        points, _ = support.grid(3, 3)
        quads = [[i, i + 1, i + 5, i + 4] for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)]
        found = pp3d.PolygonMeshHeatSolver(points, quads).compute_distance([0])
        np.testing.assert_allclose(found, np.linalg.norm(points, axis=1), atol=0.4)
        self.assertEqual(pp3d.edges(points, quads)[:4].tolist(), [[0, 1], [1, 5], [5, 4], [4, 0]])
        pp3d.validate_mesh(points, quads)
        self.refuse(
            lambda *mesh: pp3d.validate_mesh(*mesh, force_triangular=True, test_indices=True),
            *((mesh, "") for mesh in ((points, quads), (points[:, :2], self.F), (points, self.F))),
        )

    def test_files(self):
        folder = support.output_folder("compat")
        points, triangles = support.grid(2, 1)
        path = os.path.join(folder, "grid.off")
        pp3d.write_mesh(points + 1 / 3, triangles, path)
        for found in (pp3d.read_mesh(path), pp3d.read_polygon_mesh(path)):
            np.testing.assert_array_equal(found[0], points + 1 / 3)
            np.testing.assert_array_equal(found[1], triangles)
        pp3d.write_mesh(points, [[0, 1, 4, 3], [1, 2, 5]], path)
        self.assertEqual(pp3d.read_polygon_mesh(path)[1], [[0, 1, 4, 3], [1, 2, 5]])
        self.refuse(pp3d.read_mesh, ((path,), "polygon 0 has 4 corners, expected 3"))
        given = points, triangles, path, points[:, :2]
        wrong = (given, ""), ((*given, "per-vertex"), "")
        self.refuse(pp3d.write_mesh, *wrong, error=NotImplementedError)
        path = os.path.join(folder, "points.xyz")
        pp3d.write_point_cloud(points + 1 / 3, path)
        np.testing.assert_array_equal(pp3d.read_point_cloud(path), points + 1 / 3)

    @support.needs_clouds
    def test_clouds(self):
        points, _ = support.grid(20, 20)
        solver = pp3d.PointCloudHeatSolver(points)
        straight = np.linalg.norm(points - points[0], axis=1)
        np.testing.assert_allclose(solver.compute_distance(0), straight, atol=0.3)
        self.assertEqual(solver.compute_distance_multisource([0, 5])[5], 0.0)
        self.refuse(solver.compute_distance, ((999,), "sources: point id 999"))

    def test_areas(self):
        points, triangles = support.folded()
        np.testing.assert_array_equal(pp3d.face_areas(points, triangles), 0.5)
        np.testing.assert_allclose(pp3d.vertex_areas(points, triangles).sum(), 2.0)
        self.assertEqual(pp3d.face_areas(points, []).shape, (0,))
        self.assertEqual(pp3d.edges(points, []).shape, (0, 2))
        functions = [pp3d.face_areas, pp3d.vertex_areas, pp3d.edges]
        for function in functions + [pp3d.cotan_laplacian] * (sparse is not None):
            wrong = [[0, 1, -1]], [[0, 1, 99]], [[0.0, 1.0, 2.5]]
            self.refuse(function, *(((points, faces), "") for faces in wrong))
            if function is not pp3d.edges:
                self.refuse(function, ((points, [[0, 1, 2, 3]]), "more than three corners"))

    @unittest.skipUnless(sparse, "no SciPy")
    def test_laplacian(self):
        laplacian = pp3d.cotan_laplacian(self.V, self.F)
        np.testing.assert_allclose(laplacian @ np.ones(642), 0.0, atol=1e-12)
        x = self.V[:, 0]
        self.assertGreater(x @ laplacian @ x, 0.0)

    @unittest.skipUnless(peer("potpourri3d"), "no potpourri3d")
    def test_beside_it(self):
        other = peer("potpourri3d")
        theirs = other.MeshHeatMethodDistanceSolver(self.V, self.F).compute_distance(7)
        ours = pp3d.MeshHeatMethodDistanceSolver(self.V, self.F).compute_distance(7)
        self.assertLessEqual(
            np.abs(ours - self.exact).mean(), 1.05 * np.abs(theirs - self.exact).mean()
        )
        for name in ("face_areas", "vertex_areas", "edges", "cotan_laplacian"):
            ours, theirs = (getattr(module, name)(self.V, self.F) for module in (pp3d, other))
            if name == "cotan_laplacian":
                ours, theirs = ours.toarray(), theirs.toarray()
            np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-12)
        curves = [[(7, [])], [(100, [0.2, 0.3, 0.5])]]
        ours, theirs = (
            module.MeshFastMarchingDistanceSolver(self.V, self.F).compute_distance(curves)
            for module in (pp3d, other)
        )
        self.assertLess(np.abs(ours - theirs).max(), 0.2 * theirs.max())
        ours, theirs = (
            module.PointCloudHeatSolver(self.V).compute_distance(7) for module in (pp3d, other)
        )
        self.assertLess(np.abs(ours - self.exact).mean(), np.abs(theirs - self.exact).mean())
        for v in (0, 99, 500):
            lengths = [
                support.length_of(p.find_geodesic_path(7, v))
                for p in (m.EdgeFlipGeodesicSolver(self.V, self.F) for m in (pp3d, other))
            ]
            self.assertLessEqual(lengths[0], lengths[1] * (1 + 1e-9))


class Pygeodesic(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.faces = support.bumpy()
        cls.geoalg = geodesic.PyGeodesicAlgorithmExact(cls.points, cls.faces)

    def test_distance(self):
        distance, path = self.geoalg.geodesicDistance(25, 97)
        self.assertAlmostEqual(distance, vtkdgg.distance(self.points, self.faces, 25)[97])
        # from target to source, as in pygeodesic
        np.testing.assert_array_equal(path[[0, -1]], self.points[[97, 25]])
        self.assertAlmostEqual(support.length_of(path), distance)
        self.refuse(self.geoalg.geodesicDistance, ((25, 9999), ""))

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
        self.refuse(geodesic.read_mesh_from_file, ((path,), "18 lines"))

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
        some = gdist.distance_matrix_of_selected_points(self.vertices, self.triangles, [])
        self.assertEqual((some.nnz, some.shape), (0, (121, 121)))

    @unittest.skipUnless(peer("gdist"), "no gdist")
    def test_beside_it(self):
        triangles = self.triangles.astype(np.int32)
        for limit in (np.inf, 0.55):
            ours, theirs = (
                module.compute_gdist(self.vertices, triangles, max_distance=limit)
                for module in (gdist, peer("gdist"))
            )
            near = ours < np.inf
            np.testing.assert_allclose(ours[near], theirs[near], atol=1e-12)
            self.assertTrue((theirs[~near] > limit).all())
        ours, theirs = (
            module.local_gdist_matrix(self.vertices, triangles, 0.25).toarray()
            for module in (gdist, peer("gdist"))
        )
        np.testing.assert_allclose(ours, np.where(theirs > 0.25, 0.0, theirs), atol=1e-12)


if __name__ == "__main__":
    unittest.main()
