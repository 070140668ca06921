# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poisson vector graphics from Python."""

import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def add_array(data, name, values):
    """An array with a copy of the values."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)


class PoissonVectorGraphics(unittest.TestCase):
    def setUp(self):
        self.points, triangles = support.bumpy()
        self.mesh = support.polydata(self.points, triangles)
        self.graphics = vtkdgg.vtkPoissonVectorGraphics()
        self.graphics.SetInputData(self.mesh)
        far = int(vtkdgg.distance(self.points, triangles, 0).argmax())
        self.curve = support.polyline(self.points[[0, far]])
        self.graphics.SetCurveData(self.curve)

    def values(self):
        return vtk_to_numpy(vtkdgg.check(self.graphics).GetPointData().GetArray("Colors"))

    def test_diffusion_curve(self):
        left = np.array([[255, 0, 51], [255, 102, 51]], dtype=np.uint8)
        right = np.array([[0, 255, 51], [0, 204, 51]], dtype=np.uint8)
        add_array(self.curve.GetPointData(), "LeftColor", left)
        add_array(self.curve.GetPointData(), "RightColor", right)
        values = self.values()
        self.assertEqual(values.shape[1], 3)
        self.assertAlmostEqual(values[:, 0].min(), 0.0, delta=1e-9)
        self.assertAlmostEqual(values[:, 0].max(), 1.0, delta=1e-9)
        self.assertLess(np.abs(values[:, 2] - 0.2).max(), 1e-9)
        shown = vtk_to_numpy(self.graphics.GetOutput().GetPointData().GetScalars())
        self.assertEqual(shown.dtype, np.uint8)
        self.assertLessEqual(np.abs(shown - 255.0 * values).max(), 0.5 + 1e-6)
        # Edges of the output reach across the curve nowhere, but points on it are there twice.
        points = vtk_to_numpy(self.graphics.GetOutput().GetPoints().GetData())
        self.assertLess(len(np.unique(points, axis=0)), len(points))

    def test_poisson_curve(self):
        add_array(self.curve.GetCellData(), "CurveType", np.array([1], dtype=np.int32))
        add_array(self.curve.GetCellData(), "Strength", np.array([0.5]))
        self.graphics.SetBackgroundColor(0.25, 0.0, 0.0)
        self.graphics.SetWidth(0.3)
        values = self.values()
        self.assertEqual(values.ndim, 1)  # one channel
        self.assertAlmostEqual(values.max(), 0.75, delta=1e-9)
        self.assertAlmostEqual(values.min(), -0.25, delta=1e-9)
        self.assertGreater((np.abs(values - 0.25) < 1e-9).mean(), 0.3)

    def test_fragments(self):
        left = np.array([[0.25, 0.4, 1.0], [0.25, 0.4, 1.0]])
        add_array(self.curve.GetPointData(), "LeftColor", left)
        add_array(self.curve.GetPointData(), "RightColor", left)
        self.values()
        self.assertEqual(self.graphics.GetFragments().GetNumberOfPoints(), 0)
        self.graphics.GenerateFragmentsOn()
        self.graphics.SetFragmentDivision(2)
        self.values()
        fragments = self.graphics.GetFragments()
        surface = self.graphics.GetOutput()
        self.assertEqual(fragments.GetNumberOfPoints(), 4 * surface.GetNumberOfCells())
        data = fragments.GetPointData()
        self.assertLess(np.abs(vtk_to_numpy(data.GetArray("Colors")) - left[0]).max(), 1e-9)
        self.assertTrue((vtk_to_numpy(data.GetScalars()) == [64, 102, 255]).all())
        # Those of a triangle of the output are in the same cell of the input as it is.
        faces = vtk_to_numpy(data.GetArray("FaceId")).reshape(-1, 4)
        self.assertTrue((faces == faces[:, :1]).all())
        self.assertTrue((np.unique(faces) == np.arange(self.mesh.GetNumberOfCells())).all())
        # They have its middle.
        corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        points = vtk_to_numpy(surface.GetPoints().GetData())
        places = vtk_to_numpy(fragments.GetPoints().GetData()).reshape(-1, 4, 3)
        difference = places.mean(axis=1) - points[corners].mean(axis=1)
        self.assertLess(np.abs(difference).max(), 1e-6)

    def test_mistakes(self):
        with self.assertRaisesRegex(vtkdgg.VTKError, "LeftColor"):
            vtkdgg.check(self.graphics)
        self.graphics.SetCurveData(None)
        with self.assertRaisesRegex(vtkdgg.VTKError, "nothing to draw"):
            vtkdgg.check(self.graphics)


if __name__ == "__main__":
    unittest.main()
