# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loops from Python."""

import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersCore import vtkTubeFilter

SIDES = 7
ROWS = 8


def values(data, name):
    """An array of point, cell or field data."""
    return vtk_to_numpy(data.GetArray(name))


def points_of(lines, i):
    """Positions along a polyline."""
    ids = vtkIdList()
    lines.GetLines().GetCellAtId(i, ids)
    return np.array([lines.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())])


class Loop(unittest.TestCase):
    def setUp(self):
        self.loop = vtkdgg.vtkDGGLoop()
        self.loop.SetInputData(support.polydata(*support.prism(SIDES, ROWS)))

    def test_through_points(self):
        for ids in ([3 * SIDES, 5 * SIDES + 2], (3 * SIDES, 5 * SIDES + 2)):
            self.loop.SetPointIds(ids)
            lines = vtkdgg.check(self.loop)
            data = lines.GetCellData()
            np.testing.assert_allclose(values(data, "Length"), SIDES, rtol=1e-10)
            np.testing.assert_allclose(values(data, "Angle"), np.pi, atol=1e-6)
            np.testing.assert_array_equal(values(data, "Kinked"), [0, 0])
            np.testing.assert_array_equal(values(data, "LoopId"), [0, 1])
            np.testing.assert_array_equal(values(lines.GetFieldData(), "LoopStatus"), [0, 0])
            for i in range(2):
                points = points_of(lines, i)
                np.testing.assert_array_equal(points[0], points[-1])
                np.testing.assert_allclose(points[:, 2], 3.0 + 2.0 * i, atol=1e-9)
                steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
                self.assertAlmostEqual(steps.sum(), SIDES, delta=1e-9)

    def test_tubes(self):
        self.loop.SetPointIds([4 * SIDES])
        self.loop.SetTapeWidth(1.2)
        for port in (self.loop.GetOutputPort(), self.loop.GetTapePort()):
            tubes = vtkTubeFilter()
            tubes.SetInputConnection(port)
            tubes.SetRadius(0.05)
            self.assertGreater(vtkdgg.check(tubes).GetNumberOfStrips(), 0)

    def test_no_loop(self):
        points, triangles = support.grid(4, 4)
        self.loop.SetInputData(support.polydata(points, triangles))
        self.loop.SetPointIds([12])
        with self.assertWarnsRegex(RuntimeWarning, "contract to the point"):
            lines = vtkdgg.check(self.loop)
        self.assertEqual(lines.GetNumberOfCells(), 0)
        np.testing.assert_array_equal(values(lines.GetFieldData(), "LoopStatus"), [1])


if __name__ == "__main__":
    unittest.main()
