# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of clouds that are not easy."""

import os
import sys
import unittest

import numpy as np
import support

sys.path.insert(0, os.path.join(support.EXAMPLES, "Python"))
import cloud_guards  # noqa: E402  (it is in that folder)


class CloudGuards(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(1)

    def test_density_and_noise(self):
        points = cloud_guards.sphere(4000, self.random, density=10.0)
        self.assertEqual(points.shape, (4000, 3))
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1.0)
        # Slices of a sphere that are equally thick have the same area.
        left, right = ((side * points[:, 0] > 0.7).sum() for side in (-1.0, 1.0))
        self.assertTrue(4.5 * right < left < 7.0 * right, (left, right))
        noisy = cloud_guards.sphere(4000, self.random, noise=0.02)
        self.assertAlmostEqual(np.linalg.norm(noisy, axis=1).std(), 0.02, delta=0.002)

    def test_paths_go_around_holes(self):
        points = cloud_guards.perforated(4000, self.random)
        hole = np.array([1.0 + 0.45 * np.cos(0.6), 0.0, 0.45 * np.sin(0.6)])
        offset = points - hole
        self.assertGreaterEqual(np.linalg.norm(offset, axis=1).min(), 0.17)
        # From one side of it to the other, nearer than which there are points.
        rim = np.linalg.norm(offset, axis=1) < 0.25
        start = int(np.argmin(np.where(rim, points[:, 1], np.inf)))
        end = int(np.argmax(np.where(rim, points[:, 1], -np.inf)))
        _, distances = cloud_guards.distances_on(points, start)
        straight = np.linalg.norm(points[end] - points[start])
        self.assertGreater(distances[end], 1.1 * straight)
        self.assertLess(distances[end], 1.7 * straight)

    def test_sheets_stay_apart(self):
        points = cloud_guards.sheets(4000, self.random)
        gap = 3.0 * 1.5 * np.sqrt(2.0 / 4000)
        wave = 0.06 * np.sin(7.0 * points[:, 0] + 0.5) * np.cos(5.0 * points[:, 1])
        upper = points[:, 2] - wave > 0.5 * gap
        self.assertTrue(100 < upper.sum() < 2000)
        _, distances = cloud_guards.distances_on(points, int(np.argmin(upper)))
        np.testing.assert_array_equal(np.isnan(distances), upper)

    def test_picture(self):
        picture = os.path.join(support.OUTPUT, "cloud_guards.png")
        cloud_guards.main(picture, 0.1)
        image = support.pixels(support.read_image(picture))[:, :, :3]
        self.assertEqual(image.shape[:2], cloud_guards.SIZE[::-1])
        rows, columns = image.shape[0] // 2, image.shape[1] // 2
        for i in range(4):
            row, column = i // 2 * rows, i % 2 * columns
            panel = image[row : row + rows, column : column + columns].reshape(-1, 3)
            self.assertTrue(0.1 < (panel < 250).any(axis=1).mean() < 0.9, i)
            red = (panel[:, 0] > 120) & (panel[:, 1:] < 60).all(axis=1)
            self.assertGreater(red.sum(), 50, i)


if __name__ == "__main__":
    unittest.main()
