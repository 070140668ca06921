# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The chain reader, distance, contour, mapper, image, against a baseline.

DGG_WRITE_BASELINE=1 in the environment writes the baseline anew. Look at it before you keep it.
"""

import os
import unittest

import numpy as np
import support
import vtkdgg
from vtkdgg.pictures import actor_of, tubes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

SOURCE = 318
STEP = 0.25
# What rounding on another processor may cost, in vtkImageDifference's measure.
LIMIT = 40.0


class Chain:
    """From file to image; the source is the one thing that varies."""

    def __init__(self, source):
        reader = vtkPLYReader()
        reader.SetFileName(os.path.join(support.DATA, "bumpy.ply"))
        self.distance = vtkdgg.vtkExactGeodesicDistance()
        self.distance.SetInputConnection(reader.GetOutputPort())
        self.distance.AddSourceId(source)
        self.mesh = vtkdgg.check(self.distance)
        self.distances = support.point_array(self.mesh, "GeodesicDistance")
        self.contour = vtkContourFilter()
        self.contour.SetInputConnection(self.distance.GetOutputPort())
        for i in range(1, int(self.distances.max() / STEP) + 1):
            self.contour.SetValue(i - 1, i * STEP)
        self.lines = vtkdgg.check(self.contour)
        self.image = self.render()

    def render(self):
        surface = actor_of(self.mesh)
        surface.GetMapper().SetScalarRange(0.0, 2.5)
        surface.GetMapper().InterpolateScalarsBeforeMappingOn()
        lines = tubes(self.lines, 0.012, (0.0, 0.0, 0.0))

        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.AddActor(surface)
        renderer.AddActor(lines)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(2.0, 3.0, 6.0)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 1.0, 0.0)
        renderer.ResetCamera()
        camera.Zoom(1.6)
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetMultiSamples(0)
        window.SetSize(300, 300)
        window.AddRenderer(renderer)
        window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        return grabber.GetOutput()


class DistanceContours(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.chain = Chain(SOURCE)
        folder = support.output_folder("image")
        support.write_image(os.path.join(folder, "DistanceContours.png"), cls.chain.image)
        baseline = os.path.join(support.BASELINE, "DistanceContours.png")
        if os.environ.get("DGG_WRITE_BASELINE"):
            support.write_image(baseline, cls.chain.image)
        cls.baseline = support.read_image(baseline)

    def error(self, image):
        return support.image_error(image, self.baseline)

    def test_distances(self):
        # Numbers that must hold, whatever the picture looks like.
        distances = self.chain.distances
        self.assertEqual(distances[SOURCE], 0.0)
        self.assertTrue(np.isfinite(distances).all())
        points = vtk_to_numpy(self.chain.mesh.GetPoints().GetData()).astype(float)
        straight = np.linalg.norm(points - points[SOURCE], axis=1)
        self.assertTrue((distances >= straight * (1 - 1e-9)).all())

    def test_contours(self):
        levels = support.point_array(self.chain.lines, "GeodesicDistance") / STEP
        np.testing.assert_allclose(levels, np.round(levels), atol=1e-6)
        expected = np.arange(1, int(self.chain.distances.max() / STEP) + 1)
        np.testing.assert_array_equal(np.unique(np.round(levels)), expected)

    def test_equals_the_baseline(self):
        self.assertLess(self.error(self.chain.image), LIMIT)

    def test_a_shifted_picture_fails(self):
        array = support.pixels(self.chain.image)
        for shift, axis in ((1, 0), (-1, 0), (1, 1), (-1, 1), (2, 0), (2, 1)):
            with self.subTest(shift=shift, axis=axis):
                shifted = support.image_of(np.roll(array, shift, axis))
                self.assertGreater(self.error(shifted), 5 * LIMIT)

    def test_a_mirrored_picture_fails(self):
        array = support.pixels(self.chain.image)
        for mirrored in (array[:, ::-1], array[::-1], array[::-1, ::-1]):
            self.assertGreater(self.error(support.image_of(mirrored)), 5 * LIMIT)

    def test_another_source_fails(self):
        self.assertGreater(self.error(Chain(SOURCE + 1).image), 5 * LIMIT)


if __name__ == "__main__":
    unittest.main()
