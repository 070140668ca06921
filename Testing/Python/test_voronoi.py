# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples and Voronoi cells from Python."""

import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy


def values(data, name):
    """An array of point, cell or field data."""
    return vtk_to_numpy(data.GetArray(name))


class Voronoi(unittest.TestCase):
    def test_samples_stay_on_their_sheet(self):
        points, triangles = support.grid(8, 8)
        surface = support.polydata(
            np.vstack([points, points]), np.vstack([triangles, triangles[:, ::-1] + len(points)])
        )
        sampler = vtkdgg.vtkGeodesicSampler()
        sampler.SetInputData(surface)
        sampler.SetNumberOfSamples(10)
        voronoi = vtkdgg.vtkGeodesicVoronoi()
        voronoi.SetInputData(surface)
        voronoi.SetSiteConnection(sampler.GetOutputPort())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of coincident boundaries
            vtkdgg.check(voronoi)
        ids = values(sampler.GetOutput().GetPointData(), "vtkOriginalPointIds")
        nearest = values(voronoi.GetOutput().GetPointData(), "GeodesicSource")
        self.assertGreater((ids >= len(points)).sum(), 0)
        np.testing.assert_array_equal(nearest[ids], np.arange(10))

    def test_ids(self):
        voronoi = vtkdgg.vtkGeodesicVoronoi()
        voronoi.SetInputData(support.polydata(*support.bumpy()))
        voronoi.SetSiteIds([3, 600])
        vtkdgg.check(voronoi)
        nearest = values(voronoi.GetOutput().GetPointData(), "GeodesicSource")
        self.assertEqual((nearest[3], nearest[600]), (0, 1))
        voronoi.SetSiteIds(np.array([5, 642]))
        with self.assertRaisesRegex(vtkdgg.VTKError, "site id 642"):
            vtkdgg.check(voronoi)


if __name__ == "__main__":
    unittest.main()
