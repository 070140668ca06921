# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example that paints a bunny."""

import os
import re
import unittest

import numpy as np
import support
from support import run
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
        array = support.pixels(picture)[::-1]
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


if __name__ == "__main__":
    unittest.main()
