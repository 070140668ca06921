# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters around the graph from Python, as ParaView connects them: ports and pipelines."""

import gc
import math
import os
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkPointSource
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

BUMPY = os.path.join(support.DATA, "bumpy.ply")


def silent(function, *arguments):
    """The result of a call that must not warn."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return function(*arguments)


def distances_of(output):
    return support.point_array(output, "GeodesicDistance")


def make_reader():
    reader = vtkPLYReader()
    reader.SetFileName(BUMPY)
    return reader


def make_graph(source, accuracy=0.05):
    """A graph filter connected to an algorithm."""
    graph = vtkdgg.vtkDiscreteGeodesicGraph()
    graph.SetInputConnection(source.GetOutputPort())
    graph.SetAccuracy(accuracy)
    return graph


def make_distance(source, *ids):
    """A distance filter connected to an algorithm."""
    distance = vtkdgg.vtkDGGDistance()
    distance.SetInputConnection(source.GetOutputPort())
    distance.SetSourceIds(ids)
    return distance


def exact_distances(source, *ids):
    exact = vtkdgg.vtkExactGeodesicDistance()
    exact.SetInputConnection(source.GetOutputPort())
    exact.SetSourceIds(ids)
    return distances_of(vtkdgg.check(exact))


class Chain(unittest.TestCase):
    def test_reader_graph_distance_contour(self):
        reader = make_reader()
        graph = make_graph(reader)
        distance = make_distance(graph, 318)
        contour = vtkContourFilter()
        contour.SetInputConnection(distance.GetOutputPort())
        contour.SetValue(0, 1.0)
        lines = silent(vtkdgg.check, contour)
        self.assertGreater(lines.GetNumberOfLines(), 50)
        np.testing.assert_allclose(distances_of(lines), 1.0, rtol=1e-6)
        self.assertTrue(distance.GetUsedInputGraph())
        self.assertEqual(distance.GetGraphBuildTime(), 0)
        self.assertEqual(distance.GetGraphAccuracy(), 0.05)
        self.assertIs(distance.GetGraphIsGuaranteed(), True)
        self.assertEqual(distance.GetNumberOfGraphEdges(), graph.GetNumberOfGraphEdges())
        exact = exact_distances(reader, 318)
        found = distances_of(distance.GetOutput())
        self.assertTrue((np.abs(found - exact) <= 0.05 * exact * (1 + 1e-6)).all())

    def test_sources_on_a_port(self):
        places = vtkPointSource()
        places.SetNumberOfPoints(3)
        places.SetRadius(0.0)
        places.SetCenter(0.4, 0.3, 0.0)
        plane = vtkPlaneSource()
        plane.SetResolution(10, 10)
        distance = make_distance(make_graph(plane))
        distance.SetInputConnection(1, places.GetOutputPort())
        distance.GenerateNearestSourceOn()
        output = vtkdgg.check(distance)
        points = vtk_to_numpy(output.GetPoints().GetData())
        straight = np.linalg.norm(points - [0.4, 0.3, 0.0], axis=1)
        found = distances_of(output)
        self.assertTrue((np.abs(found - straight) <= 0.05 * straight + 1e-6).all())
        self.assertTrue((support.point_array(output, "GeodesicSource") >= 0).all())
        places.SetCenter(0.0, 0.0, 0.0)
        self.assertLess(distances_of(vtkdgg.check(distance))[60], 1e-6)

    def test_through_a_file(self):
        folder = support.output_folder("graph")
        graph = make_graph(make_reader())
        expected = distances_of(vtkdgg.check(make_distance(graph, 3)))
        for mode in ("Appended", "Binary", "Ascii"):
            with self.subTest(mode=mode):
                path = os.path.join(folder, f"{mode}.vtp")
                writer = vtkXMLPolyDataWriter()
                writer.SetInputConnection(graph.GetOutputPort())
                writer.SetFileName(path)
                getattr(writer, f"SetDataModeTo{mode}")()
                vtkdgg.check(writer)
                reader = vtkXMLPolyDataReader()
                reader.SetFileName(path)
                distance = make_distance(reader, 3)
                found = distances_of(silent(vtkdgg.check, distance))
                self.assertTrue(distance.GetUsedInputGraph())
                np.testing.assert_array_equal(found, expected)
                again = make_graph(reader)
                silent(vtkdgg.check, again)
                self.assertEqual(again.GetGraphBuildTime(), 0)
                self.assertEqual(again.GetNumberOfGraphEdges(), graph.GetNumberOfGraphEdges())


class Graph(unittest.TestCase):
    def test_arrays(self):
        graph = make_graph(make_reader())
        output = vtkdgg.check(graph)
        data = output.GetFieldData()
        arrays = {
            name: vtk_to_numpy(data.GetArray(f"DGG.{name}"))
            for name in ("Offsets", "Targets", "Lengths", "Angles", "ArrivalAngles", "Info")
        }
        edges = graph.GetNumberOfGraphEdges()
        expected = {
            "Offsets": (np.int64, 643),
            "Targets": (np.int32, edges),
            "Lengths": (np.float32, edges),
            "Angles": (np.float32, edges),
            "ArrivalAngles": (np.float32, edges),
            "Info": (np.int64, 12),
        }
        found = {name: (array.dtype, len(array)) for name, array in arrays.items()}
        self.assertEqual(found, expected)
        self.assertEqual(arrays["Offsets"][-1], edges)
        self.assertAlmostEqual(graph.GetMeanDegree(), edges / 642.0)
        self.assertEqual(graph.GetMemorySize(), 16 * edges + 8 * 643)
        self.assertEqual(arrays["Info"][3:4].view(np.float64)[0], 0.05)
        # Nothing else has changed.
        self.assertEqual(output.GetNumberOfPolys(), 1280)
        self.assertEqual(output.GetPointData().GetNumberOfArrays(), 0)
        self.assertEqual(graph.GetInput().GetFieldData().GetNumberOfArrays(), 0)

    def test_properties(self):
        graph = vtkdgg.vtkDiscreteGeodesicGraph()
        self.assertEqual(graph.GetAccuracy(), 0.01)
        self.assertEqual(graph.GetConstructionAsString(), "Guaranteed")
        graph.SetConstruction(graph.OneRelay)
        self.assertEqual(graph.GetConstructionAsString(), "OneRelay")
        self.assertEqual(graph.GetGraphBuildTime(), 0)
        self.assertEqual(graph.GetMemorySize(), 0)
        for word in ("Accuracy: 0.01", "OneRelay", "NumberOfGraphEdges: 0"):
            self.assertIn(word, str(graph))

    def test_it_goes_with_its_last_user(self):
        graph = make_graph(make_reader())
        output = vtkdgg.check(graph)
        lengths = vtk_to_numpy(output.GetFieldData().GetArray("DGG.Lengths"))
        kept = lengths.copy()
        del graph, output
        gc.collect()
        np.testing.assert_array_equal(lengths, kept)

    def test_mistakes(self):
        graph = make_graph(make_reader())
        for accuracy in (0.0, 0.6, math.nan):
            graph.SetAccuracy(accuracy)
            for _ in range(2):
                with self.assertRaisesRegex(vtkdgg.VTKError, "1e-06, 0.5") as caught:
                    vtkdgg.check(graph)
            self.assertNotEqual(caught.exception.code, 0)
            self.assertEqual(graph.GetOutput().GetNumberOfPoints(), 0)
        graph.SetAccuracy(0.1)
        graph.SetMemoryLimit(5000)
        with self.assertRaisesRegex(vtkdgg.VTKError, "MemoryLimit"):
            vtkdgg.check(graph)
        self.assertEqual(graph.GetOutput().GetFieldData().GetNumberOfArrays(), 0)
        graph.SetMemoryLimit(0)
        self.assertEqual(vtkdgg.check(graph).GetNumberOfPoints(), 642)
        with self.assertRaises(TypeError):
            graph.SetAccuracy("fine")

    def test_no_input(self):
        for kind in (
            vtkdgg.vtkDiscreteGeodesicGraph,
            vtkdgg.vtkDGGDistance,
            vtkdgg.vtkGeodesicDistanceMatrix,
        ):
            with self.subTest(kind=kind), self.assertRaisesRegex(vtkdgg.VTKError, "no input"):
                vtkdgg.check(kind())

    def test_an_error_upstream(self):
        graph = make_graph(make_reader(), 2.0)
        distance = make_distance(graph, 0)
        with self.assertRaisesRegex(vtkdgg.VTKError, "vtkDiscreteGeodesicGraph.*0.5"):
            vtkdgg.check(distance)
        graph.SetAccuracy(0.2)
        self.assertEqual(distances_of(vtkdgg.check(distance))[0], 0.0)

    def test_a_base_is_abstract(self):
        with self.assertRaises(TypeError):
            vtkdgg.vtkGeodesicAlgorithm()
        for kind in (
            vtkdgg.vtkDiscreteGeodesicGraph,
            vtkdgg.vtkGeodesicDistanceAlgorithm,
            vtkdgg.vtkGeodesicDistanceMatrix,
        ):
            self.assertTrue(issubclass(kind, vtkdgg.vtkGeodesicAlgorithm))
        self.assertTrue(issubclass(vtkdgg.vtkDGGDistance, vtkdgg.vtkGeodesicDistanceAlgorithm))


class InitialDistances(unittest.TestCase):
    def test_of_ids(self):
        distance = make_distance(make_graph(make_reader()))
        distance.AddSourceId(4)
        distance.AddSourceId(7, 0.5)
        self.assertEqual(distance.GetSourceInitialDistance(1), 0.5)
        expected = distances_of(silent(vtkdgg.check, distance))
        distance.SetSourceIds(np.array([4, 7]), np.array([0.0, 0.5]))
        np.testing.assert_array_equal(distances_of(silent(vtkdgg.check, distance)), expected)
        self.assertEqual(expected[4], 0.0)
        distance.SetSourceIds([4], [np.inf])
        with self.assertRaisesRegex(vtkdgg.VTKError, "source id 4 .* initial distance inf"):
            vtkdgg.check(distance)


class WrongQueries(unittest.TestCase):
    def test_sources(self):
        graph = make_graph(make_reader())
        distance = make_distance(graph)
        for ids, pattern in (([], "no source"), ([642], "source id 642"), ([0, -1], "id -1")):
            distance.SetSourceIds(ids)
            with self.subTest(ids=ids), self.assertRaisesRegex(vtkdgg.VTKError, pattern):
                vtkdgg.check(distance)
            self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
        distance.SetSourceIds([1])
        self.assertEqual(distances_of(silent(vtkdgg.check, distance))[1], 0.0)

    def test_a_damaged_graph(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(vtkdgg.check(make_graph(make_reader())))
        producer = vtkTrivialProducer()
        producer.SetOutput(mesh)
        expected = distances_of(vtkdgg.check(make_distance(make_reader(), 4)))
        vtk_to_numpy(mesh.GetFieldData().GetArray("DGG.Targets"))[17] = 10**9
        distance = make_distance(producer, 4)
        with self.assertWarnsRegex(RuntimeWarning, "edge 17 .*1000000000 of 642"):
            found = distances_of(vtkdgg.check(distance))
        np.testing.assert_array_equal(found, expected)


class Matrix(unittest.TestCase):
    def setUp(self):
        self.graph = make_graph(make_reader())
        self.matrix = vtkdgg.vtkGeodesicDistanceMatrix()
        self.matrix.SetInputConnection(self.graph.GetOutputPort())

    def values(self):
        silent(vtkdgg.check, self.matrix)
        array = self.matrix.GetMatrix()
        shape = array.GetNumberOfTuples(), array.GetNumberOfComponents()
        return np.array(vtk_to_numpy(array)).reshape(shape)

    def test_it_outlives_the_filter(self):
        self.matrix.SetRowIds([0, 5, 600])
        self.matrix.GenerateTableOff()
        expected = self.values()
        view = vtk_to_numpy(self.matrix.GetMatrix())
        self.assertEqual(self.matrix.GetOutput().GetNumberOfRows(), 0)
        self.matrix.ReleaseMatrix()
        self.assertEqual(self.matrix.GetMatrix().GetNumberOfTuples(), 0)
        self.values()
        del self.matrix
        np.testing.assert_array_equal(view, expected)

    def test_table(self):
        self.matrix.SetRowIds([0, 5, 600])
        self.matrix.SetColumnIds(np.array([7, 8]))
        values = self.values()
        self.assertEqual(values.shape, (3, 2))
        self.assertTrue(self.matrix.GetUsedInputGraph())
        self.assertEqual(self.matrix.GetGraphAccuracy(), 0.05)
        table = self.matrix.GetOutput()
        self.assertTrue(table.IsA("vtkTable"))
        self.assertEqual(table.GetNumberOfElements(vtkDataObject.ROW), 3)
        self.assertEqual([table.GetColumnName(j) for j in range(2)], ["0", "1"])
        for j in range(2):
            np.testing.assert_array_equal(vtk_to_numpy(table.GetColumn(j)), values[:, j])
            distance = make_distance(self.graph, 7 + j)
            distance.CorrectionOff()
            field = distances_of(vtkdgg.check(distance))
            np.testing.assert_allclose(values[:, j], field[[0, 5, 600]], rtol=1e-12)

    def test_ids(self):
        ids = vtkIdList()
        for i in (4, 9):
            ids.InsertNextId(i)
        results = []
        for given in (ids, [4, 9], (4, 9), np.array([4, 9], dtype=np.int16)):
            self.matrix.SetRowIds(given)
            results.append(self.values())
        for result in results:
            np.testing.assert_array_equal(result, results[0])
        np.testing.assert_array_equal(results[0], results[0].T)
        for bad in ([0.5], "12", [None], 3):
            with self.subTest(bad=bad), self.assertRaises(TypeError):
                self.matrix.SetColumnIds(bad)

    def test_points_on_ports(self):
        sphere = vtkPointSource()
        sphere.SetNumberOfPoints(5)
        sphere.SetRadius(0.0)
        sphere.SetCenter(self.point(3))
        self.matrix.SetInputConnection(1, sphere.GetOutputPort())
        self.matrix.SetColumnIds([3, 4])
        values = self.values()
        self.assertEqual(values.shape, (5, 2))
        self.assertLess(values[:, 0].max(), 1e-4)
        sphere.SetCenter(self.point(4))
        self.assertLess(self.values()[:, 1].max(), 1e-4)

    def point(self, i):
        return vtkdgg.check(self.graph).GetPoint(i)

    def test_mistakes(self):
        for rows, columns, pattern in (
            ([], [0], "no row"),
            ([642], [], "row id 642"),
            ([0], [-1], "column id -1"),
        ):
            self.matrix.SetRowIds(rows)
            self.matrix.SetColumnIds(columns)
            with self.subTest(pattern=pattern), self.assertRaisesRegex(vtkdgg.VTKError, pattern):
                vtkdgg.check(self.matrix)
            self.assertEqual(self.matrix.GetOutput().GetNumberOfRows(), 0)
            self.assertEqual(self.matrix.GetMatrix().GetNumberOfTuples(), 0)
        self.matrix.SetColumnIds([1])
        self.assertEqual(self.values().shape, (1, 1))


if __name__ == "__main__":
    unittest.main()
