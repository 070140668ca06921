# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Earth mover's distances from Python."""

import math
import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def add_array(data, name, values):
    """A point array with a copy of the values."""
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


class EarthMoversDistance(unittest.TestCase):
    def setUp(self):
        self.points, triangles = support.bumpy()
        self.mesh = support.polydata(self.points, triangles)
        self.movers = vtkdgg.vtkSurfaceEarthMoversDistance()
        self.movers.SetInputData(self.mesh)
        self.exact = vtkdgg.distance(self.points, triangles, 0)

    def test_point_masses(self):
        farthest = int(self.exact.argmax())
        for setter, place in ((self.movers.SetFromData, 0), (self.movers.SetToData, farthest)):
            setter(support.polydata(self.points[[place]], np.zeros((0, 3))))
        output = vtkdgg.check(self.movers)
        distance = output.GetFieldData().GetArray("EarthMoversDistance").GetValue(0)
        self.assertEqual(distance, self.movers.GetDistance())
        self.assertAlmostEqual(distance / self.exact[farthest], 1.0, delta=0.1)
        self.assertLessEqual(self.movers.GetLowerBound(), distance)
        potential = vtk_to_numpy(output.GetPointData().GetArray("EarthMoversPotential"))
        self.assertGreater(potential[0], potential[farthest])
        flow = vtk_to_numpy(output.GetCellData().GetArray("EarthMoversFlow"))
        self.assertEqual(flow.shape, (self.mesh.GetNumberOfCells(), 3))
        self.assertTrue(np.isfinite(flow).all() and np.abs(flow).max() > 0.0)

    def test_densities(self):
        scale = self.exact.max()
        add_array(self.mesh, "near", np.exp(-((4.0 * self.exact / scale) ** 2)))
        add_array(self.mesh, "all", np.ones(len(self.points)))
        self.movers.SetFromArrayName("near")
        self.movers.SetToArrayName("near")
        vtkdgg.check(self.movers)
        self.assertEqual(self.movers.GetDistance(), 0.0)
        self.movers.SetToArrayName("all")
        vtkdgg.check(self.movers)
        self.assertTrue(0.2 * scale < self.movers.GetDistance() < 0.8 * scale)
        self.assertEqual(self.movers.GetNumberOfFactorizations(), 1)

    def test_errors(self):
        with self.assertRaisesRegex(vtkdgg.VTKError, "nothing to move from"):
            vtkdgg.check(self.movers)
        self.assertTrue(math.isnan(self.movers.GetDistance()))
        add_array(self.mesh, "one", np.ones(len(self.points)))
        add_array(self.mesh, "two", 2.0 * np.ones(len(self.points)))
        self.movers.SetFromArrayName("one")
        self.movers.SetToArrayName("two")
        self.movers.NormalizeOff()
        with self.assertRaisesRegex(vtkdgg.VTKError, "give both the same"):
            vtkdgg.check(self.movers)
        self.movers.NormalizeOn()
        vtkdgg.check(self.movers)
        self.assertAlmostEqual(self.movers.GetDistance(), 0.0)


if __name__ == "__main__":
    unittest.main()
