# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other packages, and places on them."""

import os
import pathlib
import types
import unittest

import numpy as np
import other_packages
import support
import vtkdgg
from vtkmodules.vtkCommonDataModel import (
    VTK_QUADRATIC_TETRA,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkStripper
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

POINTS, TRIANGLES = support.grid(4, 3)
QUADS = np.array(
    [[5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5] for j in range(3) for i in range(4)]
)
REST = TRIANGLES[np.r_[6:12, 18:24]]  # what is left beside six of the quads
STRAIGHT = np.linalg.norm(POINTS - POINTS[0], axis=1)


def padded(cells):
    """As PyVista has them: the number of corners before the corners, all in one row."""
    return np.column_stack([np.full(len(cells), np.shape(cells)[1]), cells]).ravel()


def strips():
    """A vtkPolyData without polygons."""
    stripper = vtkStripper()
    stripper.SetInputData(support.polydata(POINTS, TRIANGLES))
    stripper.PassThroughPointIdsOff()
    return vtkdgg.check(stripper)


class Block:
    """A block of cells of meshio."""

    def __init__(self, kind, data):
        self.type = kind
        self.data = np.asarray(data)


Mesh = types.SimpleNamespace
MESHES = {
    "vtkPolyData": support.polydata(POINTS, TRIANGLES),
    "strips": strips(),
    "pyvista": Mesh(points=POINTS.astype(np.float32), faces=padded(TRIANGLES)),
    "pyvista, quads": Mesh(points=POINTS, faces=padded(QUADS)),
    "pyvista, mixed": Mesh(points=POINTS, faces=np.append(padded(QUADS[:6]), padded(REST))),
    "Mesh": vtkdgg.Mesh(POINTS, TRIANGLES),
    "Mesh, quads": vtkdgg.Mesh(POINTS, QUADS),
    "pair": (POINTS, TRIANGLES),
    "pair of lists": [POINTS.tolist(), QUADS.tolist()],
    **other_packages.make(other_packages.MESHES, POINTS, TRIANGLES),
    "lists": Mesh(vertices=POINTS.tolist(), faces=TRIANGLES.tolist()),
    "meshio, mixed": Mesh(
        points=POINTS,
        cells=[
            Block("vertex", [[0]]),
            Block("line", [[0, 1]]),
            Block("triangle", REST),
            Block("quad", QUADS[:6]),
        ],
    ),
    "meshio, polygons": Mesh(points=POINTS, cells=[Block("polygon4", QUADS)]),
}


class Meshes(unittest.TestCase):
    def test_all_kinds(self):
        for name, mesh in MESHES.items():
            with self.subTest(name):
                np.testing.assert_allclose(vtkdgg.distance(mesh, 0), STRAIGHT, rtol=1e-6)
                np.testing.assert_allclose(vtkdgg.distance(mesh, sources=[0]), STRAIGHT, rtol=1e-6)
                self.assertAlmostEqual(vtkdgg.path(mesh, 0, end=18).length, STRAIGHT[18], 5)
                graph = vtkdgg.Graph(mesh, accuracy=0.1)
                self.assertAlmostEqual(graph.path(start=0, end=18).length, STRAIGHT[18], 5)
                self.assertEqual(vtkdgg.greens_function(mesh, [0, 3]).shape, (20, 2))
                self.assertEqual(vtkdgg.interpolate(mesh, [0, 3], [1.0, 2.0]).shape, (20,))
                self.assertAlmostEqual(vtkdgg.earth_movers(mesh, 0, 4).lower_bound, 4.0, delta=0.5)

    def test_cells(self):
        rows = QUADS[:6].tolist() + REST.tolist()
        for cells in (QUADS, QUADS.tolist(), padded(QUADS), padded(TRIANGLES), rows):
            distances = vtkdgg.distance(POINTS, cells, 0)
            np.testing.assert_allclose(distances, STRAIGHT, rtol=1e-12)

    def test_wrong_cells(self):
        for cells, pattern in (
            ([[0, 1]], "triangles: expected the shape"),
            ([[0, 1, 2], [0, 1]], "triangles: a polygon has 2 corners"),
            ([3, 0, 1], "triangles: expected the shape .* number of corners"),
            ([3, 0, 1, 2, 4, 0, 1], "number of corners"),
            ([-1, 0, 1, 2], "triangles: "),
            ([2, 0, 1], "triangles: a polygon has 2 corners"),
            ([3, 0, 1, 99], "triangles: point id 99"),
            ([[0, 1, 2], [0, 1, 2, 99]], "triangles: point id 99"),
            ([[0.0, 1, 2]], "triangles: expected integers"),
            (7, "triangles: expected the shape"),
            ("abc", "triangles: expected integers"),
        ):
            with self.subTest(cells=cells), self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.distance(POINTS, cells, 0)

    def test_wrong_meshes(self):
        for data, remedy in (
            (vtkImageData(), "got a vtkImageData; vtkDataSetSurfaceFilter extracts one"),
            (vtkMultiBlockDataSet(), "pass one block, or .* vtkCompositeDataGeometryFilter"),
        ):
            with self.assertRaisesRegex(ValueError, remedy):
                vtkdgg.distance(data, 0)
        for mesh in (None, object()):
            pattern = f"type {type(mesh).__name__} without .*vertices and faces; .*points and cells"
            with self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.distance(mesh, 0)
        with self.assertRaisesRegex(ValueError, "points: .* got elements of unequal lengths"):
            vtkdgg.distance((POINTS, TRIANGLES, 0), 0)
        for block, pattern in (
            (Block("polyhedron4", [[0, 1, 5, 6]]), "expected cells of triangle, .* 'polyhedron4'"),
            (Block("tetra", [[0, 1, 5, 99]]), "point id 99"),
        ):
            with self.assertRaisesRegex(ValueError, pattern):
                vtkdgg.Graph(Mesh(points=POINTS, cells=[block]))
        with self.assertRaisesRegex(ValueError, "triangles: missing"):
            vtkdgg.distance(POINTS, sources=0)
        for given in ((POINTS, 0), (POINTS, [0, 1]), (POINTS,), (POINTS, None, 0)):
            with self.assertRaisesRegex(ValueError, "triangles: .* see vtkdgg.CloudGraph"):
                vtkdgg.distance(*given)
        with self.assertRaisesRegex(ValueError, "sources: missing"):
            vtkdgg.distance(POINTS, TRIANGLES)
        for call in (lambda file: vtkdgg.distance(file, 0), vtkdgg.Graph):
            for file in ("file.ply", pathlib.Path("file.ply")):
                with self.assertRaisesRegex(FileNotFoundError, "file.ply: no such file"):
                    call(file)
        with self.assertRaisesRegex(ValueError, "triangles: given, but the mesh has cells"):
            vtkdgg.distance(MESHES["trimesh"], TRIANGLES, 0)
        with self.assertRaisesRegex(ValueError, "end: missing"):
            vtkdgg.path(MESHES["trimesh"], 0)
        with self.assertRaisesRegex(vtkdgg.VTKError, r"vtkPointCloudDGG makes \(vtkdgg.CloudGraph"):
            vtkdgg.distance(Mesh(points=POINTS), 0)

    def test_scenes(self):
        scenes = other_packages.make(other_packages.SCENES, POINTS, TRIANGLES)
        for name, scene in scenes.items():
            with self.subTest(name):
                distances = vtkdgg.distance(scene, 0, merge_coincident_points=True)
                np.testing.assert_allclose(distances[: len(POINTS)], STRAIGHT, rtol=1e-6)

    def test_volumes(self):
        """Of a grid of cubes the surface is used, whose point ids are those of the grid."""
        solid = vtkStructuredGrid()
        solid.SetDimensions(4, 4, 4)
        corner = np.arange(4.0)
        points = np.array([[x, y, z] for z in corner for y in corner for x in corner])
        solid.SetPoints(support.polydata(points, TRIANGLES).GetPoints())
        append = vtkAppendFilter()
        append.AddInputData(solid)
        path = os.path.join(support.output_folder("meshes"), "solid.vtu")
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(path)
        writer.SetInputData(vtkdgg.check(append))
        vtkdgg.check(writer)
        first = np.array([1, 4, 16]) @ np.indices((3, 3, 3)).reshape(3, 27)
        cubes = Block("hexahedron", first[:, None] + [0, 1, 5, 4, 16, 17, 21, 20])
        meshio = Mesh(points=points, cells=[Block("line", [[0, 1]]), cubes])
        for mesh in (solid, vtkdgg.check(append), path, meshio):
            with self.assertWarnsRegex(RuntimeWarning, "volume cells: .* surface of 54 faces"):
                distances = vtkdgg.distance(mesh, 0)
            inside = ((points > 0.5) & (points < 2.5)).all(axis=1)
            np.testing.assert_array_equal(np.isnan(distances), inside)
            self.assertAlmostEqual(distances[-1], 3.0 * np.sqrt(5.0))
            self.assertAlmostEqual(distances[3], 3.0)

    def test_quadratic_cells(self):
        cell = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]]
        cell += [[1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]]
        grid = vtkUnstructuredGrid()
        grid.SetPoints(support.polydata(cell, TRIANGLES).GetPoints())
        grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
        for mesh in (grid, Mesh(points=np.array(cell), cells=[Block("tetra10", [range(10)])])):
            with self.assertWarnsRegex(RuntimeWarning, "volume cells"):
                distances = vtkdgg.distance(mesh, 0)
            np.testing.assert_allclose(distances[[3, 4, 5, 6]], [2.0, 1.0, np.sqrt(2.0), 1.0])

    def test_missing_points(self):
        """Points with NaN that no triangle uses get the value of unreached points."""
        points = np.vstack([POINTS, np.full((2, 3), np.nan)])
        for mesh in ((points, TRIANGLES), support.polydata(points, TRIANGLES)):
            np.testing.assert_allclose(vtkdgg.distance(mesh, 0), [*STRAIGHT, np.nan, np.nan])
            self.assertEqual(vtkdgg.Graph(mesh, accuracy=0.1).number_of_points, len(points))
            self.assertAlmostEqual(vtkdgg.path(mesh, 0, 18).length, STRAIGHT[18])
        pattern = r"points: row 20 is not finite: \[nan nan nan\]; polygon 24 uses it"
        with self.assertRaisesRegex(ValueError, pattern):
            vtkdgg.distance(points, np.vstack([TRIANGLES, [[0, 1, 20]]]), 0)

    @unittest.skipUnless(support.HAS_CLOUDS, "built without PCL")
    def test_clouds(self):
        points = support.grid(30, 20)[0]
        missing = np.vstack([points, np.full((1, 3), np.nan)])
        expected = vtkdgg.CloudGraph(points).distance(0)
        clouds = other_packages.make(other_packages.CLOUDS, points)
        clouds.update({"Mesh": vtkdgg.Mesh(points), "polydata": support.polydata(points, [])})
        for name, cloud in clouds.items():
            with self.subTest(name):
                np.testing.assert_array_equal(vtkdgg.CloudGraph(cloud).distance(0), expected)
        for cloud in (missing, vtkdgg.Mesh(missing), support.polydata(missing, [])):
            distances = vtkdgg.CloudGraph(cloud).distance(0)
            np.testing.assert_array_equal(distances, [*expected, np.nan])

    def test_input_is_left_alone(self):
        mesh = support.polydata(POINTS, TRIANGLES)
        before = mesh.GetMTime()
        vtkdgg.earth_movers(mesh, STRAIGHT, STRAIGHT[::-1].copy())
        vtkdgg.distance(mesh, 0)
        self.assertEqual(mesh.GetMTime(), before)
        self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), 0)

    def test_own_data_comes_along(self):
        mesh = support.polydata(POINTS, TRIANGLES)
        height = support.numpy_to_vtk(POINTS[:, 1].copy(), deep=True)
        height.SetName("height")
        mesh.GetPointData().AddArray(height)
        graph = vtkdgg.Graph(mesh, accuracy=0.1)
        for output in (
            vtkdgg.distance(mesh, 0, as_polydata=True),
            graph.distance(0, as_polydata=True),
            vtkdgg.greens_function(mesh, 0, as_polydata=True),
        ):
            np.testing.assert_array_equal(support.point_array(output, "height"), POINTS[:, 1])


class Places(unittest.TestCase):
    """Integers are ids, floats are coordinates, in every function."""

    @classmethod
    def setUpClass(cls):
        cls.graph = vtkdgg.Graph(POINTS, TRIANGLES, accuracy=0.1)

    def several(self):
        """What takes several places."""
        mesh, graph = MESHES["trimesh"], self.graph
        return {
            "distance": lambda places: vtkdgg.distance(mesh, places),
            "Graph.distance": graph.distance,
            "Graph.matrix": graph.matrix,
            "Graph.paths": lambda places: graph.paths(places, 19),
            "Graph.voronoi": graph.voronoi,
            "Graph.isolines": lambda places: graph.isolines(places, 3),
            "Graph.sample": lambda places: graph.sample(5, start=places),
            "greens_function": lambda places: vtkdgg.greens_function(mesh, places),
            "biharmonic": lambda places: vtkdgg.biharmonic(mesh, places, number_of_eigenvalues=5),
            "earth_movers": lambda places: vtkdgg.earth_movers(mesh, places, 7),
        }

    def test_several(self):
        for name, ask in self.several().items():
            for places in (
                2, [2, 7], np.array([2, 7], dtype=np.uint8), [1.5, 1.0, 0.0], [[1.5, 1.0, 0.0]],
                np.float32([[1.5, 1.0, 0.0], [0.0, 0.5, 0.0]]), [0, 0, 1],
                (3, (0.5, 0.25, 0.25)), [2, (1.5, 1.0, 0.0)], [(3, (0.5, 0.25, 0.25)), 2],
            ):  # fmt: skip
                with self.subTest(name, places=places):
                    ask(places)
            for places in ([[0, 0, 1]], [[0, 0]], [0.5, 1.0], 1.5, [], "x", [True], [0, 99], None,
                           (2, (1.5, 1.0, 0.0)), [2, [3, (0.5, 0.25, 0.25)]]):  # fmt: skip
                with self.subTest(name, places=places), self.assertRaises(ValueError):
                    if name == "Graph.sample" and places is None:
                        raise ValueError("its default")
                    ask(places)

    def test_one(self):
        mesh, graph = MESHES["trimesh"], self.graph
        for ask in (lambda place: vtkdgg.path(mesh, place, 7), lambda p: graph.path(7, p)):
            for place in (2, np.int8(2), [1.5, 1.0, 0.0]):
                ask(place)
            for place in (
                [0, 0, 1], [2], [[1.5, 1.0, 0.0]], 1.5, None, True, "x", 99, [2, (1.5, 1.0, 0.0)],
            ):  # fmt: skip
                with self.subTest(place=place), self.assertRaises(ValueError):
                    ask(place)

    def test_masses_or_a_place(self):
        triangle = Mesh(vertices=[[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces=[[0, 1, 2]])
        with self.assertRaisesRegex(ValueError, "three numbers may be masses"):
            vtkdgg.earth_movers(triangle, [1.0, 0.0, 0.0], 1)

    def test_options_are_keywords(self):
        for call in (
            lambda: vtkdgg.distance(POINTS, TRIANGLES, 0, 5.0),
            lambda: vtkdgg.path(POINTS, TRIANGLES, 0, 1, 0.1),
            lambda: vtkdgg.Graph(POINTS, TRIANGLES, 0.1),
            lambda: self.graph.distance(0, False),
            lambda: self.graph.path(0, 1, True),
        ):
            with self.assertRaises(TypeError):
                call()


if __name__ == "__main__":
    unittest.main()
