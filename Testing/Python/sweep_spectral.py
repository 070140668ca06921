# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the spectral filters on any mesh, for sweep_checks."""

import numpy as np
import support
from sweep_trial import ROUNDING

ZERO_MEAN = 2e-2  # largest mean of a Green's function, relative to its range
SYMMETRY = {"Interpolated": 1e-3, "SingularitySubtraction": 3e-2}  # error, relative to the range
METRIC = 1e-6  # error of biharmonic distances, relative to the largest one
UNITY = 1e-3  # error of the sum of splines
EIGENVALUES = 40


def greens(method):
    def check(trial):
        surface, sources = trial.surface, trial.surface.inner
        algorithm = trial.make("vtkDiscreteGreensFunction", SourceIds=sources.tolist())
        getattr(algorithm, f"SetMethodTo{method}")()
        values = support.point_array(trial.update(algorithm), "GreensFunction")
        values = values.reshape(len(surface.points), len(sources))
        trial.expect(np.isfinite(values), "not finite")
        spread = np.ptp(values)
        pairs = values[sources]
        off = np.abs(pairs - pairs.T).max()
        trial.expect_most(off / spread, SYMMETRY[method], "not symmetric, relative to the range")
        thirds = np.repeat(surface.areas[surface.once] / 3, 3)
        mass = np.bincount(surface.triangles[surface.once].ravel(), thirds, len(surface.points))
        own = surface.component == surface.component[sources[0]]
        mean = np.abs(mass[own] @ values[own]).max() / mass[own].sum()
        trial.expect_most(mean / spread, ZERO_MEAN, "mean is not 0, relative to the range")

    return check


def biharmonic(trial):
    sources = trial.surface.inner
    given = {"SourceIds": sources.tolist(), "NumberOfEigenvalues": EIGENVALUES}
    algorithm = trial.make("vtkBiharmonicDistance", **given)
    values = support.point_array(trial.update(algorithm), "BiharmonicDistance")
    values = values.reshape(len(trial.surface.points), -1)
    own = trial.surface.component == trial.surface.component[sources[0]]
    trial.expect(np.isfinite(values) == own[:, None], "reached is not what is connected")
    pairs = values[sources]
    slack = METRIC * np.nanmax(values)
    trial.expect_most(np.abs(pairs - pairs.T), slack, "not symmetric")
    trial.expect_most(np.diag(pairs), slack, "not 0 at the source")
    detour = (pairs[:, :, None] + pairs[None]).min(axis=1)
    trial.expect_most(pairs, detour + slack, "longer than a detour")


def splines(trial):
    algorithm = trial.make("vtkHarmonicBSpline", NumberOfSites=10)
    values = support.point_array(trial.update(algorithm), "HarmonicBSpline")
    used = trial.surface.component >= 0
    sums = values.reshape(len(used), -1).sum(axis=1)[used]
    trial.expect_most(np.abs(sums - 1.0), UNITY, "functions do not sum to 1")


def movers(trial):
    surface = trial.surface
    start, end = surface.inner[:2]
    mass = np.zeros((2, len(surface.points)))
    mass[0, start] = mass[1, end] = 1.0
    for name, values in zip(("From", "To"), mass):
        support.add_array(trial.mesh.GetPointData(), name, values)
    names = {"FromArrayName": "From", "ToArrayName": "To"}
    algorithm = trial.make("vtkSurfaceEarthMoversDistance", **names)
    algorithm.SetArrayMeaningToMass()
    trial.update(algorithm)
    cost, low = algorithm.GetDistance(), algorithm.GetLowerBound()
    trial.expect(np.isfinite([cost, low]), "not finite")
    trial.expect_most(low, cost * (1 + ROUNDING), "lower bound above the distance")


def graphics(trial):
    surface = trial.surface
    ends = surface.inner[:2]
    curve = support.polyline(surface.points[ends])
    for name, color in (("LeftColor", [1.0, 0.0, 0.0]), ("RightColor", [0.0, 0.0, 1.0])):
        support.add_array(curve.GetCellData(), name, [color])
    algorithm = trial.make("vtkPoissonVectorGraphics", CurveData=curve)
    colors = support.point_array(trial.update(algorithm), "Colors")
    trial.expect(np.isfinite(colors), "colours are not finite")
