# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other packages, other cells, and options that are keywords."""

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

POINTS, TRIANGLES = support.grid(4, 3)
QUADS = np.array(
    [[5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5] for j in range(3) for i in range(4)]
)
REST = TRIANGLES[np.r_[6:12, 18:24]]  # the triangles that six of the quads do not cover
STRAIGHT = np.linalg.norm(POINTS - POINTS[0], axis=1)


def padded(cells):
    """Returns cells as in PyVista: one row with the number of corners before the corners."""
    return np.column_stack([np.full(len(cells), np.shape(cells)[1]), cells]).ravel()


def strips():
    """Returns a vtkPolyData without polygons."""
    mesh = support.polydata(POINTS, TRIANGLES)
    return vtkdgg.check(support.make(vtkStripper, mesh, PassThroughPointIds=False))


def block(kind, data):
    """Returns a block of cells of meshio."""
    return Mesh(type=kind, data=np.asarray(data))


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
            block("vertex", [[0]]), block("line", [[0, 1]]),
            block("triangle", REST), block("quad", QUADS[:6]),
        ],  # fmt: skip
    ),
    "meshio, polygons": Mesh(points=POINTS, cells=[block("polygon4", QUADS)]),
}


class Meshes(support.Test):
    def test_all_kinds(self):
        for name, mesh in MESHES.items():
            with self.subTest(name):
                np.testing.assert_allclose(vtkdgg.distance(mesh, 0), STRAIGHT, rtol=1e-6)
                np.testing.assert_allclose(vtkdgg.distance(mesh, sources=[0]), STRAIGHT, rtol=1e-6)
                self.assertAlmostEqual(vtkdgg.path(mesh, 0, end=18).length, STRAIGHT[18], 5)
                graph = vtkdgg.Graph(mesh, accuracy=0.1)
                self.assertAlmostEqual(graph.path(start=0, end=18).length, STRAIGHT[18], 5)

    def test_cells(self):
        rows = QUADS[:6].tolist() + REST.tolist()
        for cells in (QUADS, QUADS.tolist(), padded(QUADS), padded(TRIANGLES), rows):
            distances = vtkdgg.distance(POINTS, cells, 0)
            np.testing.assert_allclose(distances, STRAIGHT, rtol=1e-12)
        self.refuse(
            lambda cells: vtkdgg.distance(POINTS, cells, 0),
            (([[0, 1]],), "triangles: expected the shape"),
            (([[0, 1, 2], [0, 1]],), "triangles: a polygon has 2 corners"),
            (([3, 0, 1],), "triangles: expected the shape .* number of corners"),
            (([3, 0, 1, 2, 4, 0, 1],), "number of corners"),
            (([-1, 0, 1, 2],), "triangles: "),
            (([2, 0, 1],), "triangles: a polygon has 2 corners"),
            (([3, 0, 1, 99],), "triangles: point id 99"),
            (([[0, 1, 2], [0, 1, 2, 99]],), "triangles: point id 99"),
            ((7,), "triangles: expected the shape"),
            (("abc",), "triangles: expected integers"),
        )

    def test_wrong_meshes(self):
        known = "without .*vertices and faces; .*points and cells"
        cloud = "triangles: .* use vtkdgg.CloudGraph"
        self.refuse(
            vtkdgg.distance,
            ((vtkImageData(), 0), "got a vtkImageData; vtkDataSetSurfaceFilter extracts one"),
            ((vtkMultiBlockDataSet(), 0), "one block, or .* vtkCompositeDataGeometryFilter"),
            ((None, 0), f"type NoneType {known}"),
            ((object(), 0), f"type object {known}"),
            (((POINTS, TRIANGLES, 0), 0), "points: .* got elements of unequal lengths"),
            ({"points": POINTS, "sources": 0}, "triangles: missing"),
            *((given, cloud) for given in ((POINTS, 0), (POINTS, [0, 1]), (POINTS,))),
            ((POINTS, None, 0), cloud),
            ((POINTS, TRIANGLES), "sources: missing"),
            ((MESHES["trimesh"], TRIANGLES, 0), "triangles: given, but the mesh has cells"),
        )
        self.refuse(
            lambda *cells: vtkdgg.Graph(Mesh(points=POINTS, cells=[block(*cells)])),
            (("polyhedron4", [[0, 1, 5, 6]]), "expected cells of triangle, .* 'polyhedron4'"),
            (("tetra", [[0, 1, 5, 99]]), "point id 99"),
        )
        for call in (lambda file: vtkdgg.distance(file, 0), vtkdgg.Graph):
            for file in ("file.ply", pathlib.Path("file.ply")):
                wrong = (file,), "file.ply: no such file"
                self.refuse(call, wrong, error=FileNotFoundError)
        self.refuse(vtkdgg.path, ((MESHES["trimesh"], 0), "end: missing"))
        wrong = (Mesh(points=POINTS), 0), r"vtkdgg.CloudGraph"
        self.refuse(vtkdgg.distance, wrong, error=vtkdgg.Error)

    def test_scenes(self):
        scenes = other_packages.make(other_packages.SCENES, POINTS, TRIANGLES)
        for name, scene in scenes.items():
            with self.subTest(name):
                distances = vtkdgg.distance(scene, 0, merge_coincident_points=True)
                np.testing.assert_allclose(distances[: len(POINTS)], STRAIGHT, rtol=1e-6)

    def test_volumes(self):
        """The surface of a grid of cubes is used; its point ids are those of the grid."""
        solid = vtkStructuredGrid()
        solid.SetDimensions(4, 4, 4)
        corner = np.arange(4.0)
        points = np.array([[x, y, z] for z in corner for y in corner for x in corner])
        solid.SetPoints(support.polydata(points).GetPoints())
        append = vtkAppendFilter()
        append.AddInputData(solid)
        first = np.array([1, 4, 16]) @ np.indices((3, 3, 3)).reshape(3, 27)
        cubes = block("hexahedron", first[:, None] + [0, 1, 5, 4, 16, 17, 21, 20])
        meshio = Mesh(points=points, cells=[block("line", [[0, 1]]), cubes])
        for mesh in (solid, vtkdgg.check(append), meshio):
            with self.assertWarnsRegex(RuntimeWarning, "volume cells: .* surface of 54 faces"):
                distances = vtkdgg.distance(mesh, 0)
            inside = ((points > 0.5) & (points < 2.5)).all(axis=1)
            np.testing.assert_array_equal(np.isnan(distances), inside)
            self.assertAlmostEqual(distances[-1], 3.0 * np.sqrt(5.0))
        cell = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]]
        cell += [[1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]]
        grid = vtkUnstructuredGrid()
        grid.SetPoints(support.polydata(cell).GetPoints())
        grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
        for mesh in (grid, Mesh(points=np.array(cell), cells=[block("tetra10", [range(10)])])):
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
        self.refuse(vtkdgg.distance, ((points, np.vstack([TRIANGLES, [[0, 1, 20]]]), 0), pattern))

    @support.needs_clouds
    def test_clouds(self):
        points = support.grid(30, 20)[0]
        missing = np.vstack([points, np.full((1, 3), np.nan)])
        expected = vtkdgg.CloudGraph(points).distance(0)
        clouds = other_packages.make(other_packages.CLOUDS, points)
        clouds.update({"Mesh": vtkdgg.Mesh(points), "polydata": support.polydata(points)})
        for name, cloud in clouds.items():
            with self.subTest(name):
                np.testing.assert_array_equal(vtkdgg.CloudGraph(cloud).distance(0), expected)
        for cloud in (missing, vtkdgg.Mesh(missing), support.polydata(missing)):
            distances = vtkdgg.CloudGraph(cloud).distance(0)
            np.testing.assert_array_equal(distances, [*expected, np.nan])

    def test_the_input_and_its_arrays(self):
        """The input is unchanged, and its arrays are passed."""
        mesh = support.polydata(POINTS, TRIANGLES)
        before = mesh.GetMTime()
        vtkdgg.earth_movers(mesh, STRAIGHT, STRAIGHT[::-1].copy())
        vtkdgg.distance(mesh, 0)
        self.assertEqual((mesh.GetMTime(), mesh.GetPointData().GetNumberOfArrays()), (before, 0))
        support.add_array(mesh.GetPointData(), "height", POINTS[:, 1])
        for output in (
            vtkdgg.distance(mesh, 0, as_polydata=True),
            vtkdgg.Graph(mesh, accuracy=0.1).distance(0, as_polydata=True),
            vtkdgg.greens_function(mesh, 0, as_polydata=True),
        ):
            np.testing.assert_array_equal(support.point_array(output, "height"), POINTS[:, 1])

    def test_options_are_keywords(self):
        graph = vtkdgg.Graph(POINTS, TRIANGLES, accuracy=0.1)
        for call, given in (
            (vtkdgg.distance, (POINTS, TRIANGLES, 0, 5.0)),
            (vtkdgg.path, (POINTS, TRIANGLES, 0, 1, 0.1)),
            (vtkdgg.Graph, (POINTS, TRIANGLES, 0.1)),
            (graph.distance, (0, False)),
            (graph.path, (0, 1, True)),
        ):
            self.refuse(call, (given, "positional argument"), error=TypeError)


if __name__ == "__main__":
    unittest.main()
