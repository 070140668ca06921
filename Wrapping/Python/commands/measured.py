# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relative errors against exact distances, compared with the promised accuracy."""

import numpy as np

# Relative rounding error of lengths in the graph.
ROUNDING = 1e-6


class Errors:
    """Signed relative errors of distances, and statistics of their absolute values.

    Where the exact distance is at most `floor`, the relative error is 0 if the difference is at
    most `floor` as well.
    """

    def __init__(self, distances, exact, floor=0.0):
        with np.errstate(invalid="ignore"):
            near = (exact <= floor) & (np.abs(distances - exact) <= floor)
        # At the source both are 0.
        with np.errstate(divide="ignore", invalid="ignore"):
            self.signed = np.where(near | (distances == exact), 0.0, distances / exact - 1.0)
        # Number of points other than the source within the floor.
        self.number_near = int((near & (exact > 0.0)).sum())
        measured = np.isfinite(exact) & (exact > floor)
        sizes = np.abs(self.signed[measured])
        # True if no distance is shorter than the exact one.
        self.is_upper_bound = not (self.signed[measured] < -ROUNDING).any()
        self.mean = float(sizes.mean()) if len(sizes) else 0.0
        self.percentile = float(np.percentile(sizes, 99.9)) if len(sizes) else 0.0
        self.largest = float(sizes.max()) if len(sizes) else 0.0
        # The error is infinite where one of the distances is, or only the exact distance is 0.
        reached = np.isfinite(exact)
        if (np.isfinite(distances) != reached).any() or (reached & ~measured & ~near).any():
            self.largest = float("inf")

    def keeps(self, accuracy):
        """Returns true if no error exceeds the accuracy."""
        return self.largest <= accuracy + ROUNDING
