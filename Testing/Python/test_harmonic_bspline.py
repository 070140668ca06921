# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Harmonic B-splines from Python."""

import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def square(n):
    """Points and triangles of the unit square, n by n quads."""
    x, y = np.meshgrid(np.linspace(0.0, 1.0, n + 1), np.linspace(0.0, 1.0, n + 1))
    points = np.column_stack([x.ravel(), y.ravel(), 0.0 * x.ravel()])
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)[None, :]).ravel()
    lower = np.column_stack([corner, corner + 1, corner + n + 2])
    upper = np.column_stack([corner, corner + n + 2, corner + n + 1])
    return points, np.vstack([lower, upper])


class HarmonicBSpline(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = square(24)
        self.mesh = support.polydata(self.points, self.triangles)
        self.spline = vtkdgg.vtkHarmonicBSpline()
        self.spline.SetInputData(self.mesh)

    def result(self, name, output=None):
        output = output or self.spline.GetOutput()
        return vtk_to_numpy(output.GetPointData().GetArray(name))

    def test_basis(self):
        self.spline.SetNumberOfSites(12)
        vtkdgg.check(self.spline)
        basis = self.result("HarmonicBSpline")
        self.assertEqual(basis.shape, (len(self.points), 12))
        np.testing.assert_allclose(basis.sum(axis=1), 1.0, atol=1e-10)
        sites = [self.spline.GetUsedSite(i) for i in range(12)]
        np.testing.assert_array_equal(self.result("Cell")[sites], np.arange(12))
        self.spline.SetSourceIds(sites[:5])
        vtkdgg.check(self.spline)
        self.assertEqual(self.spline.GetNumberOfUsedSites(), 5)

    def test_poisson(self):
        x, y = self.points[:, 0], self.points[:, 1]
        mode = np.cos(np.pi * x) * np.cos(np.pi * y)
        array = numpy_to_vtk(2.0 * np.pi**2 * mode, deep=True)
        array.SetName("f")
        self.mesh.GetPointData().AddArray(array)
        self.spline.SetRightHandSideArrayName("f")
        self.spline.SetNumberOfSites(len(self.points))  # finite elements
        self.spline.SetEvaluationData(support.polydata(np.array([[0.21, 0.37, 0.0]]), np.zeros((0, 3))))
        vtkdgg.check(self.spline)
        np.testing.assert_allclose(self.result("PoissonSolution"), mode, atol=0.01)
        there = self.result("PoissonSolution", self.spline.GetEvaluation())[0]
        self.assertAlmostEqual(there, np.cos(0.21 * np.pi) * np.cos(0.37 * np.pi), 2)

    def test_errors(self):
        self.spline.SetRightHandSideArrayName("missing")
        with self.assertRaisesRegex(vtkdgg.VTKError, "no point array 'missing'"):
            vtkdgg.check(self.spline)
        self.spline.SetRightHandSideArrayName(None)
        self.spline.SetSourceIds([3, 3])
        with self.assertRaisesRegex(vtkdgg.VTKError, "same as site 0"):
            vtkdgg.check(self.spline)
        self.spline.SetSourceIds([3, 30])
        vtkdgg.check(self.spline)


if __name__ == "__main__":
    unittest.main()
