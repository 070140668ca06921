# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkExactGeodesicDistance as Python sees it: kinds of ids, observers, objects that go away."""

import gc
import math
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkPolyData


def make_filter(columns=4, rows=4):
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(support.polydata(*support.grid(columns, rows)))
    return distance


def ids_of(distance):
    return [distance.GetSourceId(i) for i in range(distance.GetNumberOfSourceIds())]


class Ids(unittest.TestCase):
    def test_integers_of_every_width(self):
        distance = make_filter()
        for name in ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"):
            kind = np.dtype(name).type
            with self.subTest(kind=kind):
                distance.SetSourceIds(np.array([3, 1, 2], dtype=kind))
                self.assertEqual(ids_of(distance), [3, 1, 2])
                distance.RemoveAllSourceIds()
                distance.AddSourceId(kind(7))
                self.assertEqual(ids_of(distance), [7])

    def test_views_and_sequences(self):
        distance = make_filter()
        for given, expected in (
            (np.arange(10)[::3], [0, 3, 6, 9]),
            (np.arange(12).reshape(3, 4)[:, 1], [1, 5, 9]),
            (np.flatnonzero([0, 1, 0, 1]), [1, 3]),
            (range(2, 5), [2, 3, 4]),
            ([np.int64(4), 5], [4, 5]),
            (np.array([], dtype=int), []),
            ([], []),
        ):
            with self.subTest(given=given):
                distance.SetSourceIds(given)
                self.assertEqual(ids_of(distance), expected)

    def test_what_is_not_an_id_changes_nothing(self):
        distance = make_filter()
        distance.SetSourceIds([1, 2])
        for bad in (5, "12", 1.5, [1.5], ["1"], [None], {1: 2}, np.ones(1), np.zeros((2, 2), int)):
            with self.subTest(bad=bad), self.assertRaises(TypeError):
                distance.SetSourceIds(bad)
        with self.assertRaises((TypeError, OverflowError)):
            distance.SetSourceIds([2**70])
        with self.assertRaises(TypeError):
            distance.AddSourceId("a")
        self.assertEqual(ids_of(distance), [1, 2])

    def test_none_and_lists_of_vtk(self):
        distance = make_filter()
        ids = vtkIdList()
        ids.InsertNextId(6)
        distance.SetSourceIds(ids)
        del ids
        gc.collect()
        self.assertEqual(ids_of(distance), [6])
        distance.SetSourceIds(None)
        self.assertEqual(ids_of(distance), [])


class Observers(unittest.TestCase):
    def test_progress_and_abort(self):
        distance = make_filter(60, 60)
        distance.AddSourceId(0)
        seen = []

        def stop(caller, event):
            if caller.GetAbortExecute() and caller.GetProgress() == 1.0:
                return  # not of the filter: later versions of VTK report the end, too
            seen.append(caller.GetProgress())
            if seen[-1] > 0.0:
                caller.AbortExecuteOn()

        tag = distance.AddObserver("ProgressEvent", stop)
        distance.Update()
        self.assertEqual(seen, sorted(seen))
        self.assertLess(seen[-1], 1.0)
        self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(distance.GetErrorCode(), 0)
        distance.RemoveObserver(tag)
        distance.Update()
        result = support.point_array(distance.GetOutput(), "GeodesicDistance")
        self.assertAlmostEqual(result[-1], 60.0 * math.sqrt(2.0), delta=1e-10)
        self.assertEqual(distance.GetProgress(), 1.0)


class Objects(unittest.TestCase):
    def test_the_input_may_go_away(self):
        distance = make_filter()
        distance.AddSourceId(0)
        before = support.point_array(vtkdgg.check(distance), "GeodesicDistance").copy()
        for _ in range(20):  # new objects may get the addresses of old ones
            distance.SetInputData(support.polydata(*support.grid(2, 2)))
            gc.collect()
            self.assertEqual(vtkdgg.check(distance).GetNumberOfPoints(), 9)
            distance.SetInputData(support.polydata(*support.grid(4, 4)))
            gc.collect()
            after = support.point_array(vtkdgg.check(distance), "GeodesicDistance")
            np.testing.assert_array_equal(after, before)

    def test_the_output_outlives_the_filter(self):
        distance = make_filter()
        distance.AddSourceId(0)
        output = vtkdgg.check(distance)
        del distance
        gc.collect()
        self.assertAlmostEqual(
            support.point_array(output, "GeodesicDistance")[-1], math.sqrt(32.0), delta=1e-12
        )

    def test_the_base_is_abstract(self):
        with self.assertRaises(TypeError):
            vtkdgg.vtkGeodesicDistanceAlgorithm()
        self.assertTrue(
            issubclass(vtkdgg.vtkExactGeodesicDistance, vtkdgg.vtkGeodesicDistanceAlgorithm)
        )

    def test_report(self):
        distance = make_filter()
        self.assertEqual(distance.GetMeshReport(), "no surface\n")
        distance.AddSourceId(0)
        vtkdgg.check(distance)
        self.assertIn("triangles: 32\n", distance.GetMeshReport())
        self.assertEqual(distance.GetNumberOfTriangles(), 32)
        self.assertEqual(distance.GetNumberOfBoundaryLoops(), 1)
        self.assertIs(distance.GetOrientable(), True)
        self.assertIn("GeodesicDistance", str(distance))


class BrokenMeshes(unittest.TestCase):
    def test_random_cells(self):
        """An answer or an error for whatever cells there are, and never a crash."""
        random = np.random.default_rng(12)
        answers = 0
        for trial in range(300):
            n = int(random.integers(1, 12))
            # Every other surface has coincident, collinear and coplanar points.
            points = random.random((n, 3))
            points = np.floor(5.0 * points) if trial % 4 < 2 else points
            if trial % 10 == 0:
                points[random.integers(n), random.integers(3)] = random.choice([np.nan, np.inf])
            mesh = support.polydata(points, random.integers(0, n + trial % 2, (15, 3)))
            distance = vtkdgg.vtkExactGeodesicDistance()
            distance.SetInputData(mesh)
            distance.SetMergeCoincidentPoints(trial % 3 == 0)
            distance.AddSourceId(int(random.integers(n)))
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                try:
                    output = vtkdgg.check(distance)
                except vtkdgg.VTKError:
                    self.assertNotEqual(distance.GetErrorCode(), 0)
                    self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
                    continue
            answers += 1
            result = support.point_array(output, "GeodesicDistance")
            self.assertEqual(result[distance.GetSourceId(0)], 0.0)
            reached = ~np.isnan(result)
            straight = np.linalg.norm(points - points[distance.GetSourceId(0)], axis=1)
            self.assertTrue(np.all(result[reached] >= straight[reached] - 1e-6))
        self.assertGreater(answers, 60)

    def test_polydata_without_anything(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(vtkPolyData())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(vtkdgg.check(distance).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
