# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of Green's functions and B-splines on spheres of radius 1, where there is a closed form.

Usage: measure_spheres.py OUT.json OUT.md [--name=value ...]

  --levels=3,4,5,6        of icospheres
  --poles=10              inside of faces on each of them, for all levels at the same positions
  --splines=80,320,1280   sites of harmonic B-splines, on the icosphere of level 5

Errors of Green's functions are relative L2 errors over the vertices within 0.2 of the pole and over all,
means over the poles, and the largest error of all. The order of an error is the slope of its logarithm
over that of the mean edge, a line fitted to all spheres (least squares). The error of B-splines is that
of the solution of -Laplace u = 6 x z, which is x z.
"""

import modes
import numpy as np
import vtkdgg
from exhibits import surfaces
from summarize import WAYS
from tables import (
    column,
    count_text,
    folded,
    hundredths,
    listing,
    percent,
    slope,
    table,
    time_text,
    titled,
)
from vtkdgg.vtk_data import add_array
from vtkmodules.util.numpy_support import vtk_to_numpy

SPLINE_LEVEL = 5
LOCAL_RADIUS = 0.2
# Smallest barycentric coordinate of poles. Interpolation is more accurate close to corners or
# sides.
LEAST_COORDINATE = 0.05
ERRORS = {
    "error_local": "within 0.2",
    "error_global": "everywhere",
    "error_largest": "largest",
}


def poles_of(points, triangles, count):
    """Returns positions inside of faces. Each split of the faces appends those of three corners, so
    that the index modulo their number finds the face of every level that contains a position."""
    random = np.random.default_rng(surfaces.SEED)
    faces = random.integers(20 * 4**12, size=count) % len(triangles)
    weights = []
    while len(weights) < count:
        drawn = random.dirichlet((1.0, 1.0, 1.0))
        if drawn.min() > LEAST_COORDINATE:
            weights.append(drawn)
    return np.einsum("ki,kij->kj", weights, points[triangles[faces]])


def greens_functions(mesh, places, way):
    """Returns the Green's functions of points as columns, and the number of points of another method
    than that of the way."""
    greens = vtkdgg.vtkDiscreteGreensFunction()
    greens.SetInputData(mesh)
    greens.SetSourceData(vtkdgg.Mesh(places).as_polydata())
    method = getattr(greens, "SingularitySubtraction" if way == "RegularPart" else way)
    greens.SetMethod(method)
    greens.SetInterpolateRegularPart(way == "RegularPart")
    output = vtkdgg.check(greens)
    others = sum(greens.GetUsedMethod(k) != method for k in range(len(places)))
    return vtk_to_numpy(output.GetPointData().GetArray(greens.GetResultArrayName())), others


def areas_of(points, triangles):
    """Returns a third of the area of the faces around each vertex."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    thirds = np.linalg.norm(normals, axis=1) / 6.0
    return np.bincount(triangles.ravel(), np.repeat(thirds, 3), len(points))


def relative(areas, values, truth):
    """Returns the relative L2 error."""
    return float(np.sqrt(areas @ (values - truth) ** 2 / (areas @ truth**2)))


def measure_sphere(level, poles, way):
    """Returns the errors of a way on one sphere."""
    points, triangles = surfaces.icosphere(level)
    mesh = surfaces.from_arrays(points, triangles)
    places = poles_of(points, triangles, poles)
    columns, others = greens_functions(mesh, places, way)
    areas = areas_of(points, triangles)
    found = {error: [] for error in ERRORS}
    for place, values in zip(places, columns.T):
        cosines = points @ place / np.linalg.norm(place)
        truth = -(np.log(1.0 - cosines) + 1.0 - np.log(2.0)) / (4.0 * np.pi)
        near = cosines > np.cos(LOCAL_RADIUS)
        found["error_local"].append(relative(areas[near], values[near], truth[near]))
        found["error_global"].append(relative(areas, values, truth))
        found["error_largest"].append(float(np.abs(values - truth).max()))
    size = (len(points), surfaces.mean_edge(points, triangles))
    forms = {"error_largest": max}
    return {e: (*size, float(forms.get(e, np.mean)(v))) for e, v in found.items()}, others


def measure_ways(levels, poles):
    """Returns {way: {error: [(vertices, mean edge, error)]}}, coarse spheres first, and the number of
    poles of another method."""
    curves, others = {}, 0
    for way in WAYS:
        curves[way] = {error: [] for error in ERRORS}
        for level in levels:
            found, replaced = measure_sphere(level, poles, way)
            others += replaced
            for error, point in found.items():
                curves[way][error].append(point)
    return curves, others


def measure_splines(sites):
    """Returns the error of a solution by B-splines."""
    points, triangles = surfaces.icosphere(SPLINE_LEVEL)
    mesh = surfaces.from_arrays(points, triangles)
    truth = points[:, 0] * points[:, 2]
    add_array(mesh.GetPointData(), "f", 6.0 * truth)
    splines = vtkdgg.vtkHarmonicBSpline()
    splines.SetInputData(mesh)
    splines.SetNumberOfSites(sites)
    splines.SetRightHandSideArrayName("f")
    splines.GenerateBasisOff()
    seconds, output = modes.timed(lambda: vtkdgg.check(splines))
    solution = vtk_to_numpy(output.GetPointData().GetArray("PoissonSolution"))
    error = relative(areas_of(points, triangles), solution, truth)
    return {"vertices": len(points), "sites": sites, "error": error, "seconds": seconds}


def measure(options):
    curves, others = measure_ways(options.levels, options.poles)
    splines = [measure_splines(sites) for sites in options.splines]
    return {"curves": curves, "other method": others, "splines": splines}


def order(points):
    """Slope of the logarithms of errors over those of mean edges; None for less than two."""
    return slope([(edge, error) for _, edge, error in points])


def convergence_table(curves):
    rows = []
    for error, title in ERRORS.items():
        columns = [curves[way][error] for way in WAYS]
        for points in zip(*columns):
            rows.append([title, str(points[0][0]), *(f"{value:.1e}" for *_, value in points)])
        rows.append([title, "order", *(hundredths(order(points)) for points in columns)])
    return table(["error", "vertices", *WAYS.values()], rows)


def spline_table(rows):
    columns = (
        column("vertices of a sphere", count_text, "vertices"),
        column("sites of B-splines", str, "sites"),
        column("error of a solution, %", percent, "error"),
        column("time", time_text, "seconds"),
    )
    return listing(columns, rows)


def tables(results):
    """Returns all tables."""
    errors = convergence_table(results["curves"])
    if results["other method"]:
        errors += f"\nAt {results['other method']} poles another method was used.\n"
    return titled(
        {
            "Harmonic B-splines": spline_table(results["splines"]),
            "": folded("Errors on spheres of radius 1", errors),
        }
    )


def parse(arguments=None):
    """Returns the options of a command line."""
    return modes.parse(__doc__, arguments, levels=(3, 4, 5, 6), poles=10, splines=(80, 320, 1280))


if __name__ == "__main__":
    modes.run(measure, tables, parse())
