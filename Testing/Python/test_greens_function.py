# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Green's functions and biharmonic distances from Python."""

import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy


def sphere(rings=48, columns=96):
    """Points and triangles of a unit sphere with poles at its ends."""
    latitude = np.pi * np.arange(1, rings) / rings
    longitude = 2.0 * np.pi * np.arange(columns) / columns
    inner = np.column_stack(
        [
            np.outer(np.sin(latitude), np.cos(longitude)).ravel(),
            np.outer(np.sin(latitude), np.sin(longitude)).ravel(),
            np.repeat(np.cos(latitude), columns),
        ]
    )
    points = np.vstack([[[0.0, 0.0, 1.0]], inner, [[0.0, 0.0, -1.0]]])
    here = np.arange(columns)
    there = (here + 1) % columns
    triangles = [np.column_stack([0 * here, 1 + here, 1 + there])]
    for row in range(rings - 2):
        a = 1 + row * columns
        b = a + columns
        triangles.append(np.column_stack([a + here, b + here, b + there]))
        triangles.append(np.column_stack([a + here, b + there, a + there]))
    a = 1 + (rings - 2) * columns
    triangles.append(np.column_stack([a + here, 0 * here + len(points) - 1, a + there]))
    return points, np.vstack(triangles)


def exact(cosine):
    """The Green's function of the unit sphere."""
    return -(np.log(1.0 - cosine) + 1.0 - np.log(2.0)) / (4.0 * np.pi)


class GreensFunction(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = sphere()
        self.mesh = support.polydata(self.points, self.triangles)
        self.greens = vtkdgg.vtkDiscreteGreensFunction()
        self.greens.SetInputData(self.mesh)

    def result(self, output):
        return vtk_to_numpy(output.GetPointData().GetArray("GreensFunction"))

    def test_sphere(self):
        self.greens.SetSourceIds(np.array([2000, 3000]))
        values = self.result(vtkdgg.check(self.greens))
        self.assertEqual(values.shape, (len(self.points), 2))
        for k, source in enumerate((2000, 3000)):
            cosine = self.points @ self.points[source]
            away = cosine < 0.999
            np.testing.assert_allclose(values[away, k], exact(cosine[away]), atol=3e-3)
        self.assertAlmostEqual(values[3000, 0], values[2000, 1], 3)

    def test_sources_and_evaluation_anywhere(self):
        middle = self.points[self.triangles[[500, 4000]]].mean(axis=1)
        self.greens.SetSourceData(support.polydata(middle[:1], np.zeros((0, 3))))
        self.greens.SetEvaluationData(support.polydata(middle[1:], np.zeros((0, 3))))
        vtkdgg.check(self.greens)
        value = self.result(self.greens.GetEvaluation())[0]
        directions = middle / np.linalg.norm(middle, axis=1)[:, None]
        self.assertAlmostEqual(value, exact(directions[0] @ directions[1]), 2)

    def test_methods_and_sign(self):
        self.greens.SetSourceIds([1000])
        positive = self.result(vtkdgg.check(self.greens)).copy()
        self.greens.SetSignConventionToNegativeAtSource()
        np.testing.assert_array_equal(self.result(vtkdgg.check(self.greens)), -positive)
        self.greens.SetMethodToVertex()
        self.assertEqual(self.greens.GetMethodAsString(), "Vertex")
        vtkdgg.check(self.greens)
        self.assertEqual(self.greens.GetUsedMethod(0), vtkdgg.vtkDiscreteGreensFunction.Vertex)
        self.assertEqual(self.greens.GetNumberOfFactorizations(), 1)

    def test_errors(self):
        self.greens.SetSourceIds([5])
        self.greens.SetBoundaryToDirichlet()
        with self.assertRaisesRegex(vtkdgg.VTKError, "without a boundary"):
            vtkdgg.check(self.greens)
        self.greens.SetBoundaryToNeumann()
        self.greens.SetSourceIds([len(self.points)])
        with self.assertRaisesRegex(vtkdgg.VTKError, "out of range"):
            vtkdgg.check(self.greens)
        self.greens.SetSourceIds([5])
        vtkdgg.check(self.greens)


class BiharmonicDistance(unittest.TestCase):
    def test_sphere(self):
        points, triangles = sphere(24, 48)
        distance = vtkdgg.vtkBiharmonicDistance()
        distance.SetInputData(support.polydata(points, triangles))
        distance.SetSourceIds([0])
        vtkdgg.check(distance)
        d = vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("BiharmonicDistance"))
        self.assertEqual(d[0], 0.0)
        # The sum over l of (2l + 1) / (2 pi) (1 - (-1)^l) / (l (l + 1))^2 at the antipode.
        self.assertAlmostEqual(d[-1], np.sqrt(np.pi / 12.0), delta=0.01)
        distance.SetKindToDiffusion()
        distance.SetMethodToExact()
        with self.assertRaisesRegex(vtkdgg.VTKError, "SetMethodToSpectrum"):
            vtkdgg.check(distance)


if __name__ == "__main__":
    unittest.main()
