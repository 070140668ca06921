# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example that paints a bunny, and what it draws with."""

import os
import re
import unittest

import numpy as np
import support
from support import run
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkDecimatePro
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYWriter

GLMARK2_BUNNY = "/usr/share/glmark2/models/bunny.obj"


class VectorGraphicsBunny(unittest.TestCase):
    @unittest.skipUnless(os.path.exists(GLMARK2_BUNNY), "glmark2-data is not installed")
    def test_painted_bunny(self):
        folder = support.output_folder("pipeline")
        mesh, picture = (os.path.join(folder, name) for name in ("bunny.ply", "bunny.png"))
        reader = vtkOBJReader()
        reader.SetFileName(GLMARK2_BUNNY)
        coarse = vtkDecimatePro()
        coarse.SetInputConnection(reader.GetOutputPort())
        coarse.SetTargetReduction(0.85)
        coarse.PreserveTopologyOn()
        writer = vtkPLYWriter()
        writer.SetInputConnection(coarse.GetOutputPort())
        writer.SetFileName(mesh)
        writer.Write()
        result = run("vector_graphics_bunny.py", picture, mesh, "--level", "0")
        self.assertEqual(result.returncode, 0, result.stderr)
        said = re.fullmatch(r"(\d+) curves on (\d+) points, colours at (\d+)\n", result.stdout)
        self.assertTrue(said, result.stdout)
        curves, before, after = map(int, said.groups())
        # The branch may fall into another piece or two.
        self.assertTrue(86 <= curves <= 92)
        self.assertEqual(before, coarse.GetOutput().GetNumberOfPoints())
        self.assertGreater(after, 2 * before)
        array = support.pixels(support.read_image(picture))[::-1, :, :3].astype(int)
        self.assertEqual(array.shape[:2], (760, 1280))
        red, green, blue = np.moveaxis(array, -1, 0)
        # The ribbon and the back are painted; on the clay there are curves only.
        for is_color, least in (
            ((red > 170) & (green < 110) & (blue < 110), 3000),
            ((blue > 80) & (red < 0.55 * blue) & (green < 0.75 * blue), 25000),
        ):
            self.assertGreater(is_color[:, 640:].sum(), least)
            self.assertGreater(is_color[:, 640:].sum(), 4 * is_color[:, :640].sum())
        # The pupil, the heart of a blossom, a petal, the tail, the coat beside them.
        for (x, y), low, high in (
            ((808, 256), (0, 0, 0), (70, 60, 60)),
            ((1055, 463), (220, 180, 50), (255, 240, 140)),
            ((1030, 455), (230, 220, 220), (255, 255, 255)),
            ((1190, 600), (220, 215, 200), (255, 255, 255)),
            ((985, 655), (60, 100, 150), (140, 170, 225)),
        ):
            with self.subTest(x=x, y=y):
                seen = array[y - 1 : y + 2, x - 1 : x + 2].mean(axis=(0, 1))
                self.assertTrue((seen >= low).all() and (seen <= high).all(), seen)


class SurfaceCanvas(unittest.TestCase):
    """Drawing in a picture plane."""

    def setUp(self):
        self.module = support.example("surface_canvas")

    def make_canvas(self, slope, around):
        """Before the planes z = slope y and, behind it, z = slope y - 3."""
        points, triangles = support.grid(4, 4)
        points = points - [2.0, 2.0, 0.0]
        points[:, 2] = slope * points[:, 1]
        both = np.vstack([points, points - [0.0, 0.0, 3.0]])
        mesh = support.polydata(both, np.vstack([triangles, triangles + 25]))
        normal = np.array([0.0, -slope, 1.0]) / np.hypot(1.0, slope)
        mesh.GetPointData().SetNormals(numpy_to_vtk(np.tile(normal, (50, 1)), deep=True))
        return self.module.Canvas(mesh, around, 0.0)

    def test_projection(self):
        drawn = np.array([[0.3, 0.7], [-1.1, 0.2], [0.5, -0.9]])
        canvas = self.make_canvas(0.75, 0.0)
        # There is another sheet behind.
        for sign, depth in ((1.0, 0.0), (-1.0, 3.0)):
            expected = np.column_stack([drawn, 0.75 * drawn[:, 1] - depth])
            np.testing.assert_allclose(canvas.place(drawn, sign), expected, atol=1e-9)
        # From 60 degrees to the right, what is to the right looks half as long.
        canvas = self.make_canvas(0.0, 60.0)
        seen = canvas.place(drawn * [0.5, 1.0])
        np.testing.assert_allclose(seen, np.column_stack([drawn, 0.0 * drawn[:, 0]]), atol=1e-9)
        with self.assertRaisesRegex(Exception, "no surface is there"):
            canvas.place([[1.1, 0.0]])

    def test_discs_are_foreshortened(self):
        np.testing.assert_allclose(
            self.make_canvas(0.75, 0.0).flat(0.1, 0.2), [[1.0, 0.0], [0.0, 0.8]], atol=1e-9
        )
        np.testing.assert_allclose(
            self.make_canvas(0.0, 60.0).flat(0.1, 0.2), [[0.5, 0.0], [0.0, 1.0]], atol=1e-9
        )

    def test_left(self):
        canvas = self.make_canvas(0.0, 0.0)
        circle = np.pad(self.module.ellipse(0.0, 0.0, 1.0, 1.0), ((0, 0), (0, 1)))
        np.testing.assert_allclose(canvas.left(circle, True), -circle, atol=1e-9)
        half = circle[: len(circle) // 2]
        inward = [0.0, -1.0, 0.0]
        np.testing.assert_array_equal(canvas.with_left(half, inward), half)
        np.testing.assert_array_equal(canvas.with_left(half[::-1], inward), half)

    def test_strokes(self):
        field = self.module.Field((-0.5, -0.5), (1.5, 0.5), 0.01)
        field.add_stroke(np.array([[0.0, 0.0], [1.0, 0.0]]), [0.2])
        field.add_stroke(np.array([[0.5, 0.0], [0.5, 0.3]]), [0.1])
        (outline,) = field.outlines()
        x, y = outline.T
        area = 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
        # A stadium, and what sticks out of it: a strip with a half disc, on a flat side.
        expected = 0.4 + np.pi * 0.04 + 0.2 * 0.1 + 0.5 * np.pi * 0.01
        self.assertAlmostEqual(area, expected, delta=2e-3)

    def test_smooth(self):
        corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
        for is_closed in (False, True):
            line = self.module.smooth(corners, is_closed)
            steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
            self.assertLess(steps.max(), 1.05 * self.module.STEP)
            for corner in corners:
                away = np.linalg.norm(line - corner, axis=1).min()
                self.assertLess(away, 0.51 * self.module.STEP)
        self.assertLess(np.linalg.norm(line[0] - line[-1]), 1.05 * self.module.STEP)


if __name__ == "__main__":
    unittest.main()
