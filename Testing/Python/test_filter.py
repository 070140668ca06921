# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkExactGeodesicDistance from Python: ways to name sources, and wrong input."""

import math
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def make_filter(columns=3, rows=3):
    """A filter with a plane rectangle as input, and no source."""
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(support.polydata(*support.grid(columns, rows)))
    return distance


def make_points(*places):
    """Points without cells."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in places:
        points.InsertNextPoint(place)
    result = vtkPolyData()
    result.SetPoints(points)
    return result


class Sources(unittest.TestCase):
    def distances(self, distance):
        return support.point_array(vtkdgg.check(distance), "GeodesicDistance")

    def test_ways_to_give_ids(self):
        ids = vtkIdList()
        ids.InsertNextId(2)
        ids.InsertNextId(12)
        expected = None
        for given in (ids, [2, 12], (2, 12), np.array([2, 12]), np.array([2, 12], dtype=np.int32)):
            with self.subTest(given=type(given)):
                distance = make_filter()
                distance.SetSourceIds(given)
                result = self.distances(distance)
                self.assertEqual(result[2], 0.0)
                self.assertEqual(result[12], 0.0)
                expected = result if expected is None else expected
                np.testing.assert_array_equal(result, expected)
        distance = make_filter()
        distance.AddSourceId(2)
        distance.AddSourceId(12)
        np.testing.assert_array_equal(self.distances(distance), expected)

    def test_numbering_of_sources(self):
        distance = make_filter()
        distance.GenerateNearestSourceOn()
        distance.SetInputData(1, make_points((0.0, 3.0, 0.0)))
        distance.SetSourceIds([0, 3])
        output = vtkdgg.check(distance)
        nearest = support.point_array(output, "GeodesicSource")
        self.assertEqual([nearest[0], nearest[3], nearest[12]], [0, 1, 2])

    def test_initial_distance(self):
        places = make_points((0.0, 0.0, 0.0), (3.0, 0.0, 0.0))
        offsets = vtkDoubleArray()
        offsets.SetName("InitialDistance")
        offsets.InsertNextValue(0.5)
        offsets.InsertNextValue(1.0)
        places.GetPointData().AddArray(offsets)
        distance = make_filter()
        distance.SetInputData(1, places)
        result = self.distances(distance)
        np.testing.assert_allclose(result[:4], [0.5, 1.5, 2.0, 1.0], rtol=1e-13)

    def test_the_input_is_passed_on(self):
        distance = make_filter()
        distance.AddSourceId(0)
        output = vtkdgg.check(distance)
        mesh = distance.GetInput()
        self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), 0)
        self.assertEqual(output.GetNumberOfCells(), mesh.GetNumberOfCells())
        self.assertEqual(output.GetPoint(7), mesh.GetPoint(7))


class WrongInput(unittest.TestCase):
    def refuses(self, distance, pattern):
        """The error is raised, the output empty, and the filter works again when set right."""
        with self.assertRaisesRegex(vtkdgg.VTKError, pattern) as caught:
            vtkdgg.check(distance)
        self.assertNotEqual(distance.GetErrorCode(), 0)
        self.assertEqual(caught.exception.code, distance.GetErrorCode())
        self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(distance.GetOutput().GetPointData().GetNumberOfArrays(), 0)

        distance.SetInputData(support.polydata(*support.grid(3, 3)))
        distance.RemoveAllSources()
        distance.AddSourceId(0)
        distance.SetMaximumDistance(math.inf)
        distance.SetProjectionTolerance(0.01)
        distance.SetDistanceArrayName("GeodesicDistance")
        output = vtkdgg.check(distance)
        self.assertEqual(distance.GetErrorCode(), 0)
        result = support.point_array(output, "GeodesicDistance")
        self.assertAlmostEqual(result[15], math.sqrt(18.0), delta=1e-12)

    def test_no_source(self):
        self.refuses(make_filter(), "source")

    def test_id_out_of_range(self):
        for bad in (-1, 16, 2**40):
            with self.subTest(bad=bad):
                distance = make_filter()
                distance.SetSourceIds([0, bad])
                self.refuses(distance, str(bad))

    def test_point_off_the_surface(self):
        distance = make_filter()
        distance.SetInputData(1, make_points((1.0, 1.0, 0.0), (1.0, 1.0, 2.0)))
        self.refuses(distance, "source point 1 .*ProjectionTolerance")

    def test_point_not_finite(self):
        for bad in (math.nan, math.inf):
            distance = make_filter()
            distance.SetInputData(1, make_points((1.0, bad, 0.0)))
            self.refuses(distance, "source point 0")

    def test_wrong_initial_distances(self):
        for values in ((math.nan,), (math.inf,), ()):
            with self.subTest(values=values):
                offsets = vtkDoubleArray()
                offsets.SetName("InitialDistance")
                for value in values:
                    offsets.InsertNextValue(value)
                places = make_points((1.0, 1.0, 0.0))
                places.GetPointData().AddArray(offsets)
                distance = make_filter()
                distance.SetInputData(1, places)
                self.refuses(distance, "InitialDistance")

    def test_points_but_no_polygons(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(make_points((0.0, 0.0, 0.0)))
        distance.AddSourceId(0)
        self.refuses(distance, "polygon|triangle|cell")

    def test_only_degenerate_polygons(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(support.polydata(np.eye(3), [[0, 1, 1], [2, 2, 2]]))
        distance.AddSourceId(0)
        self.refuses(distance, "polygon|distinct")

    def test_cell_with_unknown_point(self):
        for bad in (3, -1):
            distance = vtkdgg.vtkExactGeodesicDistance()
            distance.SetInputData(support.polydata(np.eye(3), [[0, 1, bad]]))
            distance.AddSourceId(0)
            self.refuses(distance, str(bad))

    def test_coordinate_not_finite(self):
        for bad in (math.nan, math.inf):
            points, triangles = support.grid(2, 2)
            points[4, 2] = bad
            distance = vtkdgg.vtkExactGeodesicDistance()
            distance.SetInputData(support.polydata(points, triangles))
            distance.AddSourceId(0)
            self.refuses(distance, "4")

    def test_properties(self):
        for name, value in (
            ("MaximumDistance", -1.0),
            ("MaximumDistance", math.nan),
            ("ProjectionTolerance", -0.5),
            ("ProjectionTolerance", math.nan),
            ("DistanceArrayName", ""),
        ):
            with self.subTest(name=name, value=value):
                distance = make_filter()
                distance.AddSourceId(0)
                getattr(distance, f"Set{name}")(value)
                self.refuses(distance, "name" if isinstance(value, str) else name)

    def test_missing_input(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.AddSourceId(0)
        with self.assertRaisesRegex(vtkdgg.VTKError, "no input"):
            vtkdgg.check(distance)

    def test_empty_input(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(vtkPolyData())
        distance.AddSourceId(0)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            output = vtkdgg.check(distance)
        self.assertIn("empty", str(caught[0].message))
        self.assertEqual(output.GetNumberOfPoints(), 0)

    def test_wrong_types(self):
        distance = make_filter()
        for bad in ([0.5], ["a"], None.__class__, [[1, 2]]):
            with self.subTest(bad=bad), self.assertRaises(TypeError):
                distance.SetSourceIds(bad)

    def test_index_of_a_source(self):
        distance = make_filter()
        distance.AddSourceId(5)
        self.assertEqual(distance.GetSourceId(0), 5)
        for bad in (-1, 1):
            with self.assertRaises(ValueError):
                distance.GetSourceId(bad)


if __name__ == "__main__":
    unittest.main()
