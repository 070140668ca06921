# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of vtkdgg.Graph, pickled ones, and graphs from a vtkPolyData."""

import copy
import os
import pickle
import subprocess
import sys
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter


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

    def test_double_precision(self):
        graph = vtkdgg.Graph(self.points / 3.0, self.triangles, accuracy=0.03)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            again = vtkdgg.Graph.from_polydata(graph.polydata)
        np.testing.assert_array_equal(again.distance(11), graph.distance(11))

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
            with self.assertRaisesRegex(ValueError, f"graph on the mesh is damaged: .*{pattern}"):
                vtkdgg.Graph.from_polydata(mesh)

    def test_damaged(self):
        mesh = self.editable()
        vtk_to_numpy(mesh.GetFieldData().GetArray("DGG.Lengths"))[100] *= 0.5
        self.refuses(mesh, "checksum is wrong.*a text file that rounds.*give an accuracy")
        mesh = self.editable()
        mesh.GetFieldData().GetArray("DGG.Targets").SetNumberOfTuples(100)
        self.refuses(mesh, "DGG.Targets has 100")
        mesh = self.editable()
        vtk_to_numpy(mesh.GetFieldData().GetArray("DGG.Targets"))[100] = -1
        self.refuses(mesh, "leads to vertex -1")
        mesh = self.editable()
        mesh.GetFieldData().RemoveArray("DGG.Angles")
        self.refuses(mesh, "DGG.Angles is missing")

        mesh = self.editable()
        mesh.GetFieldData().RemoveArray("DGG.Info")
        for ask in (lambda mesh: vtkdgg.distance(mesh, 0), vtkdgg.Graph):
            with self.assertWarnsRegex(RuntimeWarning, "damaged: .*DGG.Info is missing"):
                ask(mesh)

    def test_damaged_parameters(self):
        for slot, value, pattern in (
            (1, 2, "its kind is 2"),
            (2, 4, "its construction is 4"),
            (2, -1, "its construction is -1"),
            (3, 0, "its accuracy is 0"),
            (3, -1, "its accuracy is"),
        ):
            mesh = self.editable()
            mesh.GetFieldData().GetArray("DGG.Info").SetValue(slot, value)
            with self.subTest(slot=slot, value=value):
                self.refuses(mesh, pattern)
        for damage in (lambda info: info.SetValue(0, 2), lambda info: info.SetNumberOfTuples(3)):
            mesh = self.editable()
            damage(mesh.GetFieldData().GetArray("DGG.Info"))
            with self.assertRaisesRegex(ValueError, "DGG.Info of another version, or is damaged"):
                vtkdgg.Graph.from_polydata(mesh)

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
                with self.assertRaisesRegex(ValueError, "as by a text file that rounds them"):
                    vtkdgg.Graph.from_polydata(mesh)

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

    def test_merged_within_a_tolerance(self):
        points, triangles = support.two_squares([1.0 + 1e-7, 0.0, 0.0])
        graph = vtkdgg.Graph(points, triangles, merge_coincident_points=True, merge_tolerance=1e-6)
        for same in (
            graph,
            pickle.loads(pickle.dumps(graph)),
            vtkdgg.Graph.from_polydata(graph.polydata),
        ):
            with warnings.catch_warnings():
                warnings.simplefilter("error")  # nothing is rebuilt
                self.assertAlmostEqual(same.distance(0)[7], np.sqrt(5.0), delta=1e-6)
                self.assertEqual(same.path(0, 4).length, 1.0)
                self.assertEqual(same.path([0.0, 0.0, 0.0], 4).point_ids[0], 0)
        with self.assertRaisesRegex(ValueError, "merge_tolerance"):
            vtkdgg.Graph(points, triangles, merge_tolerance=-1.0)

    def test_no_graph(self):
        with self.assertRaisesRegex(ValueError, "no graph.*vtkDiscreteGeodesicGraph"):
            vtkdgg.Graph.from_polydata(support.polydata(self.points, self.triangles))
        for thing in (None, 3, self.points):
            with self.assertRaisesRegex(TypeError, "expected a vtkPolyData"):
                vtkdgg.Graph.from_polydata(thing)

    def test_no_points(self):
        empty = vtkPolyData()
        with_graph = vtkPolyData()
        with_graph.SetFieldData(self.graph.polydata.GetFieldData())
        for mesh in (empty, with_graph):
            with self.assertRaisesRegex(ValueError, "no graph|points: expected at least one"):
                vtkdgg.Graph.from_polydata(mesh)


if __name__ == "__main__":
    unittest.main()
