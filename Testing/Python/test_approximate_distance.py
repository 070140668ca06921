# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkHeatGeodesicDistance and its like from Python."""

import unittest

import numpy as np
import support
import vtkdgg


def distances(distance):
    return support.point_array(vtkdgg.check(distance), "GeodesicDistance")


class ApproximateDistances(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.grid(30, 20)
        self.exact = np.linalg.norm(self.points - self.points[200], axis=1)

    def prepare(self, distance):
        distance.SetInputData(support.polydata(self.points, self.triangles))
        distance.SetSourceIds([200])
        return distance

    def test_fast_marching(self):
        distance = self.prepare(vtkdgg.vtkDGGFastMarchingDistance())
        self.assertIsInstance(distance, vtkdgg.vtkGeodesicDistanceAlgorithm)
        np.testing.assert_allclose(distances(distance), self.exact, atol=1e-12)
        distance.SetFrontShapeToPlanar()
        planar = distances(distance)
        self.assertLess(np.abs(planar - self.exact).max(), 2.0)
        self.assertGreater(np.abs(planar - self.exact).max(), 0.01)

    def test_heat(self):
        distance = self.prepare(vtkdgg.vtkHeatGeodesicDistance())
        result = distances(distance)
        self.assertEqual(result[200], 0.0)
        self.assertLess(np.abs(result - self.exact).mean(), 0.5)
        self.assertEqual(distance.GetNumberOfFactorizations(), 2)
        distance.SetSourceIds(np.array([200, 3]))
        self.assertEqual(distances(distance)[3], 0.0)
        self.assertEqual(distance.GetNumberOfFactorizations(), 2)

    def test_virtual_sources(self):
        distance = self.prepare(vtkdgg.vtkVirtualSourceGeodesicDistance())
        np.testing.assert_allclose(distances(distance), self.exact, rtol=1e-5)

    def test_method(self):
        found = vtkdgg.distance(self.points, self.triangles, 200, method="fast")
        np.testing.assert_allclose(found, self.exact, rtol=1e-5)
        found = vtkdgg.distance(self.points, self.triangles, 200, method="graph")
        np.testing.assert_allclose(found, self.exact, rtol=1e-2)
        found = vtkdgg.distance(self.points, self.triangles, 200, method="exact")
        np.testing.assert_allclose(found, self.exact, rtol=1e-12)
        for wrong in (
            {"method": "quick"},
            {"method": ["fast"]},
            {"method": 1},
            {"method": "fast", "accuracy": 0.1},
        ):
            with self.assertRaisesRegex(ValueError, "method"):
                vtkdgg.distance(self.points, self.triangles, 200, **wrong)

    def test_marching_on_a_cloud(self):
        points = np.random.default_rng(1).random((3000, 3)) * [1.0, 1.0, 0.0]
        straight = np.linalg.norm(points - points[7], axis=1)
        found = vtkdgg.distance(points, [], 7, method="marching")
        self.assertEqual(found[7], 0.0)
        np.testing.assert_allclose(found, straight, rtol=0.1, atol=0.01)
        distance = vtkdgg.vtkDGGFastMarchingDistance()
        distance.SetInputData(vtkdgg.distance(points, [], 7, method="marching", as_polydata=True))
        distance.SetSourceIds([7])
        distance.SetResolution(400)
        distance.SetBandRadius(10.0)
        np.testing.assert_allclose(distances(distance), straight, rtol=0.05, atol=0.01)
        self.assertEqual(distance.GetUsedResolution(), 400)
        with self.assertRaisesRegex(vtkdgg.VTKError, "no polygons"):
            vtkdgg.distance(points, [], 7)

    def test_wrong_properties(self):
        distance = self.prepare(vtkdgg.vtkHeatGeodesicDistance())
        distance.SetTimeStepFactor(-1.0)
        with self.assertRaisesRegex(vtkdgg.VTKError, "TimeStepFactor"):
            vtkdgg.check(distance)


if __name__ == "__main__":
    unittest.main()
