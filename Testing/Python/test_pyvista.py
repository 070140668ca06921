# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""``mesh.dgg`` and the reader for PyVista, with a stand-in for the documented interface of PyVista,
and the metadata of the package by which PyVista finds both."""

import importlib.metadata
import os
import sys
import types
import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkPointSet,
    vtkPolyData,
    vtkUnstructuredGrid,
)

REGISTERED = {"accessors": {}, "readers": {}}


class PolyData(vtkPolyData):
    """Stand-in for the class of PyVista."""

    def __init__(self, data=None):
        if data is not None:
            self.ShallowCopy(data)

    def copy_from(self, other):
        """Copies other data."""
        self.DeepCopy(other)

    @property
    def lines(self):
        """Lines: the number of points before the points of each."""
        array = support.numpy_to_vtkIdTypeArray(np.empty(0, dtype=np.int64), deep=True)
        self.GetLines().ExportLegacyFormat(array)
        return np.array(vtk_to_numpy(array))

    @lines.setter
    def lines(self, values):
        cells = vtkCellArray()
        values = np.asarray(values, dtype=np.int64)
        cells.ImportLegacyFormat(support.numpy_to_vtkIdTypeArray(values, deep=True))
        self.SetLines(cells)


class Cached:
    """Descriptor that creates an accessor on first access and stores it in the instance."""

    def __init__(self, name, accessor):
        self.name = name
        self.accessor = accessor

    def __get__(self, mesh, kind):
        if mesh is None:
            return self.accessor
        made = self.accessor(mesh)
        mesh.__dict__[self.name] = made
        return made


def register_dataset_accessor(name, target_cls, *, override=False):
    """Stand-in for the function of PyVista."""

    def register(accessor):
        setattr(target_cls, name, Cached(name, accessor))
        REGISTERED["accessors"][name] = accessor
        return accessor

    return register


pyvista = types.ModuleType("pyvista")
pyvista.PolyData = PolyData
pyvista.PointSet = type("PointSet", (vtkPointSet,), {})
pyvista.UnstructuredGrid = type("UnstructuredGrid", (vtkUnstructuredGrid,), {})
pyvista.wrap = PolyData
pyvista.register_dataset_accessor = register_dataset_accessor
pyvista.register_reader = REGISTERED["readers"].__setitem__
sys.modules["pyvista"] = pyvista


def entry_points(group):
    """Returns the entry points of the package in a group, by name."""
    found = importlib.metadata.entry_points(group=group)
    return {point.name: point for point in found if point.value.startswith("vtkdgg.")}


class Metadata(unittest.TestCase):
    def test_version(self):
        self.assertEqual(importlib.metadata.version("vtkdgg"), vtkdgg.__version__)

    def test_entry_points(self):
        points = entry_points("pyvista.accessors")
        self.assertEqual(set(points), {"dgg"})
        module = points["dgg"].load()  # which registers it
        self.assertIs(REGISTERED["accessors"]["dgg"], module.DGGAccessor)
        points = entry_points("pyvista.readers")
        self.assertIs(points[".pcd"].load(), module.read_pcd)
        self.assertIs(REGISTERED["readers"][".pcd"], module.read_pcd)
        self.assertTrue(callable(entry_points("console_scripts")["vtkdgg"].load()))

    def test_older_pyvista(self):
        module = entry_points("pyvista.accessors")["dgg"].load()
        kept = dict(vars(pyvista))
        del pyvista.register_dataset_accessor, pyvista.register_reader
        try:
            module.register()
        finally:
            vars(pyvista).update(kept)


class Accessor(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        entry_points("pyvista.accessors")["dgg"].load()

    def setUp(self):
        self.points, self.triangles = support.bumpy()
        self.mesh = PolyData(support.polydata(self.points, self.triangles))

    def test_is_kept(self):
        self.assertIs(self.mesh.dgg, self.mesh.dgg)
        graph = self.mesh.dgg.graph(0.05)
        self.assertIs(self.mesh.dgg.graph(0.05), graph)
        self.assertIsNot(self.mesh.dgg.graph(0.1), graph)
        graph = self.mesh.dgg.graph(0.1)
        self.mesh.GetPoints().SetPoint(0, self.points[0] * 1.01)
        self.mesh.GetPoints().Modified()
        self.assertIsNot(self.mesh.dgg.graph(0.1), graph)

    def test_distance(self):
        exact = vtkdgg.distance(self.points, self.triangles, 5)
        found = self.mesh.dgg.distance(5)
        self.assertIsInstance(found, PolyData)
        np.testing.assert_array_equal(support.point_array(found, "GeodesicDistance"), exact)
        found = self.mesh.dgg.distance([5], accuracy=0.02)
        error = np.abs(support.point_array(found, "GeodesicDistance") - exact)
        self.assertTrue((error <= 0.0201 * exact).all())

    def test_geodesic(self):
        exact = vtkdgg.path(self.points, self.triangles, 5, 318)
        path = self.mesh.dgg.geodesic(5, 318)
        self.assertIsInstance(path, PolyData)
        ids = support.point_array(path, "vtkOriginalPointIds")
        order = path.lines[1:]
        self.assertEqual((ids[order[0]], ids[order[-1]]), (5, 318))
        back = self.mesh.dgg.geodesic(5, 318, keep_order=False)
        np.testing.assert_array_equal(back.lines[1:], order[::-1])
        self.assertAlmostEqual(self.mesh.dgg.geodesic_distance(5, 318), exact.length)
        with self.assertRaisesRegex(ValueError, "use_scalar_weights"):
            self.mesh.dgg.geodesic(5, 318, use_scalar_weights=True)
        self.assertIs(self.mesh.dgg.geodesic(5, 318, inplace=True), self.mesh)
        self.assertEqual(self.mesh.GetNumberOfLines(), 1)

    def test_the_rest(self):
        dgg = self.mesh.dgg
        start, end = np.zeros(642), np.zeros(642)
        start[5] = end[40] = 1.0
        colors = {"LeftColor": [[1.0, 0, 0]], "RightColor": [[0, 0, 1.0]]}
        curves = vtkdgg.Mesh(self.points[[5, 40]], lines=([0, 2], [0, 1]), cell_data=colors)
        for output, array in (
            (dgg.paths([5, 6], 318), "Length"),
            (dgg.isolines(5, 4), "IsoValue"),
            (dgg.sample(9), "CoveringRadius"),
            (dgg.voronoi([5, 318]), "SiteId"),
            (dgg.greens_function([5, 6]), "GreensFunction"),
            (dgg.biharmonic(5), "BiharmonicDistance"),
            (dgg.earth_movers(start, end), "EarthMoversPotential"),
            (dgg.interpolate([5, 40], [1.0, 2.0]), "Interpolation"),
            (dgg.probe(start, [5, 40]), "GeodesicDistance"),
            (dgg.patch_boundaries(self.mesh, [5, 40], [5, 40], edges=[[0, 1]])[1], "LayoutEdge"),
            (dgg.vector_graphics(curves, refinement_level=0), "Colors"),
        ):
            with self.subTest(array):
                self.assertIsInstance(output, PolyData)
                data = output.GetPointData(), output.GetCellData()
                self.assertTrue(any(arrays.HasArray(array) for arrays in data))
        tube = PolyData(support.polydata(*support.prism(9, 6)))
        self.assertEqual(tube.dgg.loop().GetNumberOfLines(), 1)

    @support.needs_clouds
    def test_cloud_from_a_file(self):
        points = support.plane(41, 21)
        path = os.path.join(support.output_folder("pyvista"), "cloud.pcd")
        vtkdgg.write(path, vtkdgg.Mesh(points))
        cloud = REGISTERED["readers"][".pcd"](path, progress_bar=False)
        self.assertIsInstance(cloud, PolyData)
        with self.assertRaisesRegex(ValueError, "accuracy: applies to meshes"):
            cloud.dgg.distance(0, accuracy=0.01)
        found = cloud.dgg.distance(0)
        straight = np.linalg.norm(points, axis=1)
        np.testing.assert_allclose(
            support.point_array(found, "GeodesicDistance"), straight, rtol=0.01, atol=1e-9
        )


if __name__ == "__main__":
    unittest.main()
