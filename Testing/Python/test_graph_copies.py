# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of vtkdgg.Graph, pickled ones, and graphs from a vtkPolyData."""

import copy
import pickle
import unittest

import numpy as np
import support
import vtkdgg
from support import warnings_as
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData


class Copies(unittest.TestCase):
    def setUp(self):
        self.graph = vtkdgg.Graph(*support.bumpy(), accuracy=0.03, memory_limit=2**28)

    def check_equal(self, graph):
        with warnings_as("error"):
            for source in (11, [[0.7, 0.1, 0.2]]):
                found, expected = (g.distance(source, projection_tolerance=1.0)
                                   for g in (graph, self.graph))  # fmt: skip
                np.testing.assert_array_equal(found, expected)
            np.testing.assert_array_equal(graph.matrix([1, 2]), self.graph.matrix([1, 2]))
            self.assertEqual(graph.path(5, 318).length, self.graph.path(5, 318).length)
        self.assertEqual(graph._memory_limit, 2**28)
        self.assertEqual(repr(graph), repr(self.graph))

    def test_copies(self):
        for is_used in (False, True):
            if is_used:
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
        result = support.python(code, input=pickle.dumps(self.graph), text=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        graph, distances = pickle.loads(result.stdout)  # noqa: S301
        np.testing.assert_array_equal(distances, self.graph.distance(11))
        self.check_equal(graph)

    def test_other_data(self):
        mesh = self.graph.polydata
        values = np.arange(1926, dtype=np.uint8).reshape(-1, 3)
        support.add_array(mesh.GetPointData(), "Colours", values)
        graph = vtkdgg.Graph.from_polydata(mesh, memory_limit=2**28)
        graph = pickle.loads(pickle.dumps(graph))  # noqa: S301
        kept = support.point_array(graph.polydata, "Colours")
        self.assertEqual(kept.dtype, np.uint8)
        np.testing.assert_array_equal(kept, values)
        self.check_equal(graph)


class FromPolydata(support.Test):
    def setUp(self):
        self.points, self.triangles = support.bumpy()
        self.graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.03)
        self.expected = self.graph.distance(11)
        self.mesh = support.copy_of(self.graph.polydata)

    def check_equal(self, graph):
        self.assertEqual((graph.accuracy, graph.construction), (0.03, "Guaranteed"))
        np.testing.assert_array_equal(graph.targets, self.graph.targets)
        np.testing.assert_array_equal(graph.distance(11), self.expected)

    def test_shares_the_graph(self):
        with warnings_as("error"):
            graph = vtkdgg.Graph.from_polydata(self.graph.polydata)
        self.assertTrue(np.shares_memory(graph.lengths, self.graph.lengths))
        self.check_equal(graph)

    def test_from_a_pipeline(self):
        surface = support.polydata(self.points, self.triangles)
        builder = support.make("vtkDiscreteGeodesicGraph", surface, Accuracy=0.03)
        self.check_equal(vtkdgg.Graph.from_polydata(vtkdgg.check(builder)))
        builder.SetConstructionToSaddleVertexGraph()
        builder.SetNumberOfNeighbors(7)
        graph = vtkdgg.Graph.from_polydata(vtkdgg.check(builder))
        self.assertIsNone(graph.accuracy)
        self.assertEqual(len(graph.targets), builder.GetNumberOfGraphEdges())

    def test_the_surface_may_change_later(self):
        graph = vtkdgg.Graph.from_polydata(self.mesh)
        vtk_to_numpy(self.mesh.GetPoints().GetData())[:] = 0.0
        self.mesh.GetPoints().Modified()
        self.mesh.GetPolys().Reset()
        self.check_equal(graph)
        self.assertEqual(graph.polydata.GetNumberOfPolys(), len(self.triangles))

    def test_out_of_date(self):
        vtk_to_numpy(self.mesh.GetPoints().GetData())[:] *= 2.0
        with self.assertWarnsRegex(RuntimeWarning, "out of date") as caught:
            graph = vtkdgg.Graph.from_polydata(self.mesh)
        self.assertEqual((caught.filename, graph.accuracy), (__file__, 0.03))
        np.testing.assert_allclose(graph.distance(11), 2.0 * self.expected, rtol=1e-6)
        for function in (vtkdgg.distance, lambda *given: vtkdgg.path(*given, 12)):
            with self.assertWarnsRegex(RuntimeWarning, "out of date.* 0.03"):
                function(self.mesh, 11)

    def test_damaged(self):
        """Damage is a warning: another graph is built. Without parameters, it is an error."""

        def put(name, slot, value):
            return lambda fields: fields.GetArray(name).SetValue(slot, value)

        damaged = "graph on the mesh is damaged: .*"
        for damage, pattern in (
            (put("DGG.Lengths", 100, 0.5), "checksum is wrong.*A text file that rounds"),
            (put("DGG.Targets", 100, -1), "leads to vertex -1"),
            (lambda fields: fields.RemoveArray("DGG.Angles"), "DGG.Angles is missing"),
        ):
            mesh = support.copy_of(self.mesh)
            damage(mesh.GetFieldData())
            with self.assertWarnsRegex(RuntimeWarning, damaged + pattern):
                graph = vtkdgg.Graph.from_polydata(mesh)
            self.assertFalse(graph.used_input_graph)
            self.check_equal(graph)
        for damage, pattern in (
            (put("DGG.Info", 1, 2), damaged + "its kind is 2"),
            (put("DGG.Info", 2, 4), damaged + "its construction is 4"),
            (put("DGG.Info", 3, -1), damaged + "its accuracy is"),
            (put("DGG.Info", 0, 2), "graph on the mesh has the format version 2"),
            (lambda fields: fields.GetArray("DGG.Info").SetNumberOfTuples(3), "has 3 values"),
        ):
            mesh = support.copy_of(self.mesh)
            damage(mesh.GetFieldData())
            self.refuse(vtkdgg.Graph.from_polydata, ((mesh,), pattern))
        mesh.GetFieldData().RemoveArray("DGG.Info")
        for ask in (lambda mesh: vtkdgg.distance(mesh, 0), vtkdgg.Graph):
            with self.assertWarnsRegex(RuntimeWarning, "damaged: .*DGG.Info is missing"):
                ask(mesh)

    def test_other_data(self):
        mesh = support.polydata(self.points, self.triangles, Verts=[[3]], Lines=[[4, 5], [5, 6]])
        mesh.SetFieldData(self.mesh.GetFieldData())
        names = vtkStringArray()
        names.SetName("Names")
        names.SetNumberOfValues(3)
        mesh.GetFieldData().AddArray(names)
        for data, size in ((mesh.GetPointData(), 642), (mesh.GetCellData(), 1283)):
            data.SetScalars(support.add_array(data, "Numbers", np.arange(size)))
        graph = vtkdgg.Graph.from_polydata(mesh)
        self.check_equal(graph)
        kept = graph.polydata
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
            pickle.loads(pickle.dumps(graph)),  # noqa: S301
            vtkdgg.Graph.from_polydata(graph.polydata),
        ):
            with warnings_as("error"):  # nothing is rebuilt
                self.assertAlmostEqual(same.distance(0)[7], np.sqrt(5.0), delta=1e-6)
                self.assertEqual(same.path(0, 4).length, 1.0)
                self.assertEqual(same.path([0.0, 0.0, 0.0], 4).point_ids[0], 0)
        wrong = {"points": points, "triangles": triangles, "merge_tolerance": -1.0}
        self.refuse(vtkdgg.Graph, (wrong, "merge_tolerance"))

    def test_no_graph(self):
        with_graph = vtkPolyData()
        with_graph.SetFieldData(self.mesh.GetFieldData())
        mesh = support.polydata(self.points, self.triangles)
        self.refuse(
            vtkdgg.Graph.from_polydata,
            ((mesh,), "no graph.*vtkDiscreteGeodesicGraph"),
            ((vtkPolyData(),), "no graph"),
            ((with_graph,), "points: expected at least one"),
        )
        wrong = (((thing,), "expected a vtkPolyData") for thing in (None, 3, self.points))
        self.refuse(vtkdgg.Graph.from_polydata, *wrong, error=TypeError)


if __name__ == "__main__":
    unittest.main()
