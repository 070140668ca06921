# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds from Python: the graph as arrays, and the filters that search it."""

import os
import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPointSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


def cloud_of(points):
    """A vtkPolyData of points without cells."""
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(vtk_points)
    return cloud


def plane(n, seed=3):
    """n x n points of a square, moved a little within it."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(n, dtype=float), np.arange(n, dtype=float))
    flat = np.column_stack([x.ravel(), y.ravel()]) + random.uniform(-0.2, 0.2, (n * n, 2))
    return np.column_stack([flat / (n - 1), np.zeros(n * n)])


def sphere(n):
    """Points spread evenly over the unit sphere."""
    i = np.arange(n)
    z = 1.0 - (2.0 * i + 1.0) / n
    r = np.sqrt(1.0 - z * z)
    angle = np.pi * (3.0 - np.sqrt(5.0)) * i
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z])


class PointCloudTest(unittest.TestCase):
    def make_graph(self, points):
        graph = vtkdgg.vtkPointCloudDGG()
        graph.SetInputData(cloud_of(points))
        return graph

    def test_distance_on_the_sphere(self):
        points = sphere(4000)
        graph = self.make_graph(points)
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputConnection(graph.GetOutputPort())
        distance.SetSourceIds([0])
        vtkdgg.check(distance)
        found = support.point_array(distance.GetOutput(), "GeodesicDistance")
        exact = np.arccos(np.clip(points @ points[0], -1.0, 1.0))
        error = np.abs(found[1:] / exact[1:] - 1.0)
        self.assertLess(error.mean(), 1.5e-3)
        self.assertEqual(graph.GetNumberOfComponents(), 1)
        self.assertEqual(graph.GetSchemeAsString(), "C")

    def test_graph_is_a_sparse_matrix(self):
        graph = self.make_graph(plane(20))
        vtkdgg.check(graph)
        field = graph.GetOutput().GetFieldData()
        offsets, targets, lengths = (
            vtk_to_numpy(field.GetArray("DGG." + name))
            for name in ("Offsets", "Targets", "Lengths")
        )
        self.assertEqual(len(offsets), 401)
        self.assertEqual(offsets[-1], len(targets))
        self.assertEqual(len(targets), graph.GetNumberOfGraphEdges())
        dense = np.zeros((400, 400))
        for i in range(400):
            row = targets[offsets[i] : offsets[i + 1]]
            self.assertTrue(np.all(np.diff(row) > 0))
            dense[i, row] = lengths[offsets[i] : offsets[i + 1]]
        self.assertTrue(np.array_equal(dense, dense.T))

    def test_source_is_a_point_source(self):
        """A cloud as VTK makes one, with verts."""
        source = vtkPointSource()
        source.SetNumberOfPoints(2000)
        source.SetDistributionToShell()
        graph = vtkdgg.vtkPointCloudDGG()
        graph.SetInputConnection(source.GetOutputPort())
        path = vtkdgg.vtkDGGPath()
        path.SetInputConnection(graph.GetOutputPort())
        path.AddPair(0, 1000)
        vtkdgg.check(path)
        points = vtk_to_numpy(source.GetOutput().GetPoints().GetData()).astype(float)
        half = 0.5 * np.linalg.norm(points[0] - points[1000]) / 0.5
        length = path.GetOutput().GetCellData().GetArray("GraphLength").GetValue(0)
        self.assertAlmostEqual(length, np.arcsin(half), delta=0.02 * length)

    def test_several_consumers(self):
        graph = self.make_graph(plane(30))
        sampler = vtkdgg.vtkGeodesicSampler()
        sampler.SetInputConnection(graph.GetOutputPort())
        sampler.SetNumberOfSamples(12)
        voronoi = vtkdgg.vtkGeodesicVoronoi()
        voronoi.SetInputConnection(graph.GetOutputPort())
        voronoi.SetSiteConnection(sampler.GetOutputPort())
        voronoi.CentroidalOn()
        vtkdgg.check(voronoi)
        labels = support.point_array(voronoi.GetOutput(), "GeodesicSource")
        self.assertEqual(set(labels), set(range(12)))
        energy = vtk_to_numpy(voronoi.GetOutput().GetFieldData().GetArray("Energy"))
        self.assertTrue(np.all(np.diff(energy) < 0.0))
        matrix = vtkdgg.vtkGeodesicDistanceMatrix()
        matrix.SetInputConnection(graph.GetOutputPort())
        matrix.SetRowConnection(sampler.GetOutputPort())
        vtkdgg.check(matrix)
        table = vtk_to_numpy(matrix.GetMatrix())
        points = vtk_to_numpy(sampler.GetOutput().GetPoints().GetData())
        exact = np.linalg.norm(points[:, None] - points[None, :], axis=2)
        self.assertTrue(np.allclose(table, exact, rtol=0.02))

    def test_files(self):
        graph = self.make_graph(plane(15))
        path = os.path.join(support.output_folder("point_cloud"), "cloud.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputConnection(graph.GetOutputPort())
        self.assertEqual(writer.Write(), 1)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(path)
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputConnection(reader.GetOutputPort())
        distance.SetSourceIds([7])
        vtkdgg.check(distance)
        self.assertTrue(distance.GetUsedInputGraph())

    def test_properties(self):
        graph = self.make_graph(plane(15))
        for name, value in (
            ("Scheme", 1),
            ("OffsetInVoxels", 2.0),
            ("Resolution", 40),
            ("Alpha", 2.5),
            ("Accuracy", 0.01),
            ("ArcLengthWeights", False),
            ("UseInputNormals", False),
            ("OrientedNormals", True),
            ("EstimateNormals", True),
            ("NumberOfNeighbors", 12),
            ("MemoryLimit", 1 << 30),
            ("ComponentArrayName", "part"),
        ):
            getattr(graph, "Set" + name)(value)
            self.assertEqual(getattr(graph, "Get" + name)(), value)
        vtkdgg.check(graph)
        output = graph.GetOutput()
        self.assertEqual(set(support.point_array(output, "part")), {0})
        normals = support.point_array(output, "Normals")
        self.assertTrue(np.allclose(np.abs(normals), [0.0, 0.0, 1.0], atol=1e-4))

    def test_errors(self):
        cloud = cloud_of(plane(10))
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputData(cloud)
        distance.SetSourceIds([0])
        with self.assertRaisesRegex(vtkdgg.VTKError, "vtkPointCloudDGG"):
            vtkdgg.check(distance)
        graph = vtkdgg.vtkPointCloudDGG()
        graph.SetInputData(cloud)
        vtkdgg.check(graph)
        with self.assertRaisesRegex(ValueError, "point cloud"):
            vtkdgg.Graph.from_polydata(graph.GetOutput())
        moved = vtkPolyData()
        moved.ShallowCopy(graph.GetOutput())
        moved.SetPoints(cloud_of(plane(10, seed=4)).GetPoints())
        distance.SetInputData(moved)
        with self.assertRaisesRegex(vtkdgg.VTKError, "out of date.*vtkPointCloudDGG"):
            vtkdgg.check(distance)
        graph.SetAlpha(-1.0)
        with self.assertRaisesRegex(vtkdgg.VTKError, "Alpha is -1"):
            vtkdgg.check(graph)


if __name__ == "__main__":
    unittest.main()
