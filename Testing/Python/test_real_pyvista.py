# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page about PyVista, and ``mesh.dgg`` of all its kinds of meshes. Needs PyVista 0.48 or newer,
which finds the accessor without an import."""

import os
import unittest

import numpy as np
import pages
import pyvista
import support

FOLDER = support.output_folder("pyvista")
POINTS, TRIANGLES = support.bumpy()
SPHERE = pyvista.PolyData.from_regular_faces(POINTS, TRIANGLES)


class RealPyVista(unittest.TestCase):
    def test_page(self):
        (block,) = pages.blocks("Wrapping/Python/PyVista.md", "python")
        before = os.getcwd()
        os.chdir(FOLDER)
        self.addCleanup(os.chdir, before)
        SPHERE.save("mesh.ply")
        names = {}
        exec(block, names)  # noqa: S102
        picture = pyvista.read("pyvista.png")
        self.assertEqual(picture.dimensions[:2], (1400, 600))
        self.assertGreater(len(np.unique(picture["PNGImage"], axis=0)), 1000)
        self.assertEqual(len(np.unique(names["cells"]["SiteId"])), 12)
        self.assertEqual(names["lines"].n_lines, len(np.unique(names["lines"]["IsoValue"])))

    def test_kinds_of_meshes(self):
        exact = SPHERE.dgg.distance(5)["GeodesicDistance"]
        grid = SPHERE.cast_to_unstructured_grid().dgg.distance(5)
        np.testing.assert_array_equal(grid["GeodesicDistance"], exact)
        cloud = pyvista.PointSet(SPHERE.points).dgg.distance(5)
        self.assertLess(np.abs(cloud["GeodesicDistance"] - exact).mean(), 0.03)
        for found in (grid, cloud):
            self.assertIsInstance(found, pyvista.PolyData)
        length = SPHERE.dgg.geodesic_distance(5, 300)
        self.assertAlmostEqual(length, exact[300], places=6)
        self.assertLess(length, SPHERE.geodesic_distance(5, 300))

    def test_graph_is_kept(self):
        mesh = SPHERE.copy()
        graph = mesh.dgg.graph()
        self.assertIs(mesh.dgg.graph(), graph)
        mesh.points[0] *= 1.01
        mesh.Modified()
        self.assertIsNot(mesh.dgg.graph(), graph)


if __name__ == "__main__":
    unittest.main()
