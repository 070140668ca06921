# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples and Voronoi cells from Python."""

import os
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYReader

BUMPY = os.path.join(support.DATA, "bumpy.ply")


def values(data, name):
    """An array of point, cell or field data."""
    return vtk_to_numpy(data.GetArray(name))


class Voronoi(unittest.TestCase):
    def setUp(self):
        self.reader = vtkPLYReader()
        self.reader.SetFileName(BUMPY)
        self.sampler = vtkdgg.vtkGeodesicSampler()
        self.sampler.SetInputConnection(self.reader.GetOutputPort())
        self.sampler.SetNumberOfSamples(40)
        self.voronoi = vtkdgg.vtkGeodesicVoronoi()
        self.voronoi.SetInputConnection(self.reader.GetOutputPort())
        self.voronoi.SetSiteConnection(self.sampler.GetOutputPort())

    def test_samples(self):
        vtkdgg.check(self.sampler)
        data = self.sampler.GetOutput().GetPointData()
        self.assertEqual(len(np.unique(values(data, "vtkOriginalPointIds"))), 40)
        self.assertTrue(np.all(np.diff(values(data, "CoveringRadius")) <= 0.0))

    def test_labels_are_those_of_the_distances(self):
        vtkdgg.check(self.voronoi)
        ids = values(self.sampler.GetOutput().GetPointData(), "vtkOriginalPointIds")
        fields = []
        for i in ids:
            exact = vtkdgg.vtkExactGeodesicDistance()
            exact.SetInputConnection(self.reader.GetOutputPort())
            exact.SetSourceIds([int(i)])
            vtkdgg.check(exact)
            fields.append(support.point_array(exact.GetOutput(), "GeodesicDistance").copy())
        fields = np.array(fields)
        data = self.voronoi.GetOutput().GetPointData()
        nearest = values(data, "GeodesicSource")
        own = fields[nearest, np.arange(fields.shape[1])]
        self.assertTrue(np.all(own <= 1.02 * fields.min(axis=0)))
        np.testing.assert_allclose(
            values(data, "GeodesicDistance"), fields.min(axis=0), rtol=0.010001, atol=0.0
        )

    def test_cells_have_the_area_of_the_surface(self):
        vtkdgg.check(self.voronoi)
        triangles = vtkTriangleFilter()
        triangles.SetInputData(self.voronoi.GetCells())
        areas = []
        for source in (triangles, self.reader):
            mass = vtkMassProperties()
            mass.SetInputConnection(source.GetOutputPort())
            mass.Update()
            areas.append(mass.GetSurfaceArea())
        self.assertAlmostEqual(areas[0] / areas[1], 1.0, 9)
        of_sites = values(self.voronoi.GetSites().GetPointData(), "CellArea")
        self.assertAlmostEqual(of_sites.sum() / areas[1], 1.0, 6)
        sites = values(self.voronoi.GetBoundaries().GetCellData(), "SiteId")
        self.assertEqual(sites.shape[1], 2)
        self.assertTrue(np.all(sites[:, 0] < sites[:, 1]))

    def test_centroidal(self):
        self.voronoi.CentroidalOn()
        self.voronoi.SetNumberOfIterations(8)
        vtkdgg.check(self.voronoi)
        energy = values(self.voronoi.GetOutput().GetFieldData(), "Energy")
        self.assertEqual(len(energy), 9)
        self.assertTrue(np.all(np.diff(energy) < 0.0))

    def test_samples_stay_on_their_sheet(self):
        points, triangles = support.grid(8, 8)
        surface = support.polydata(
            np.vstack([points, points]), np.vstack([triangles, triangles[:, ::-1] + len(points)])
        )
        self.sampler.SetInputConnection(None)
        self.sampler.SetInputData(surface)
        self.sampler.SetNumberOfSamples(10)
        self.voronoi.SetInputConnection(None)
        self.voronoi.SetInputData(surface)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of coincident boundaries
            vtkdgg.check(self.voronoi)
        ids = values(self.sampler.GetOutput().GetPointData(), "vtkOriginalPointIds")
        nearest = values(self.voronoi.GetOutput().GetPointData(), "GeodesicSource")
        self.assertGreater((ids >= len(points)).sum(), 0)
        np.testing.assert_array_equal(nearest[ids], np.arange(10))

    def test_ids(self):
        self.voronoi.SetSiteConnection(None)
        self.voronoi.SetSiteIds([3, 600])
        vtkdgg.check(self.voronoi)
        nearest = values(self.voronoi.GetOutput().GetPointData(), "GeodesicSource")
        self.assertEqual((nearest[3], nearest[600]), (0, 1))
        self.voronoi.SetSiteIds(np.array([5, 642]))
        with self.assertRaisesRegex(vtkdgg.VTKError, "site id 642"):
            vtkdgg.check(self.voronoi)


if __name__ == "__main__":
    unittest.main()
