# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relative errors against exact distances, and whether they are what was promised."""

import numpy as np

# Rounding of lengths in the graph, relative.
ROUNDING = 1e-6


class Errors:
    """Signed relative errors of distances, and the sizes of those errors.

    Where the exact distance is not above the floor, the difference must not be either; that is all
    that is asked there, and the relative error is taken to be 0.
    """

    def __init__(self, distances, exact, floor=0.0):
        with np.errstate(invalid="ignore"):
            near = (exact <= floor) & (np.abs(distances - exact) <= floor)
        # At the source both are 0.
        with np.errstate(divide="ignore", invalid="ignore"):
            self.signed = np.where(near | (distances == exact), 0.0, distances / exact - 1.0)
        # How many points other than the source are that near.
        self.number_near = int((near & (exact > 0.0)).sum())
        measured = np.isfinite(exact) & (exact > floor)
        sizes = np.abs(self.signed[measured])
        # Whether the distances are nowhere shorter than the exact ones.
        self.is_upper_bound = not (self.signed[measured] < -ROUNDING).any()
        self.mean = float(sizes.mean()) if len(sizes) else 0.0
        self.percentile = float(np.percentile(sizes, 99.9)) if len(sizes) else 0.0
        self.largest = float(sizes.max()) if len(sizes) else 0.0
        # No ratio is an infinite error: a point that only one of them reaches, or a second source.
        reached = np.isfinite(exact)
        if (np.isfinite(distances) != reached).any() or (reached & ~measured & ~near).any():
            self.largest = float("inf")

    def keeps(self, accuracy):
        """Whether no error is larger than promised."""
        return self.largest <= accuracy + ROUNDING
