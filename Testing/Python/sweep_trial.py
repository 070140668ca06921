# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tools of the checks of filters on any mesh: properties of a mesh without filters, filters with a
time limit, and geometry."""

import os

import numpy as np
import support
import vtkdgg
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

ROUNDING = 1e-6  # relative error of lengths in the graph, beside its accuracy
EXACT = 1e-9  # relative error of exact distances, lengths and areas
LENGTH = 1e-15  # relative rounding error of the lengths of edges
ON_SURFACE = 1e-9  # largest distance of points from their triangle, relative to its longest side


class Surface:
    """Properties of a mesh that need no filter."""

    def __init__(self, mesh):
        self.name, self.merge = mesh.name, mesh.merge
        self.points = mesh.points
        self.cells = mesh.triangles
        first = np.arange(len(mesh.points))
        if mesh.merge:
            _, index, inverse = np.unique(
                mesh.points + 0.0, axis=0, return_index=True, return_inverse=True
            )
            first = index[inverse]
        self.triangles = first[mesh.triangles]
        a, b, c = self.triangles.T
        self.proper = (a != b) & (b != c) & (c != a)
        # The first of several triangles on the same three points.
        _, index, inverse = np.unique(
            np.sort(self.triangles, axis=1), axis=0, return_index=True, return_inverse=True
        )
        self.first_copy = index[inverse]
        self.once = self.proper & (self.first_copy == np.arange(len(self.triangles)))
        corners = self.points[self.triangles]
        sides = corners - np.roll(corners, 1, axis=1)
        self.areas = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
        self.sides = np.linalg.norm(sides, axis=2)
        self.mean_edge = self.sides[self.proper].mean()
        self.component = components(first, self.triangles[self.proper])
        self.rounding = 1e-13 * np.abs(self.points).max()
        rng = np.random.default_rng(sum(mesh.name.encode()))
        used = np.unique(self.triangles[self.proper])
        area = np.bincount(self.component[a[self.once]], self.areas[self.once])
        largest = used[self.component[used] == np.argmax(area)]
        self.inner = rng.choice(largest, min(4, len(largest)), replace=False)
        anywhere = rng.choice(used, 2 if len(used) < 100_000 else 0)
        self.sources = np.unique(np.append(self.inner[:2], anywhere))
        self.rng = rng

    def __str__(self):
        sides = self.triangles[self.once][:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        _, count = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
        double = (self.proper & ~self.once).sum()
        touching = (count > 2).sum()
        return f"{len(self.points)} points, {double} duplicates, {touching} edges of three or more"


def components(first, triangles):
    """Returns the smallest point id of the component of each point, -1 without a triangle."""
    label = first.copy()
    while True:
        before = label.copy()
        least = label[triangles].min(axis=1)
        for corner in range(3):
            np.minimum.at(label, triangles[:, corner], least)
            np.minimum.at(label, before[triangles[:, corner]], least)
        label = label[label]
        if np.array_equal(label, before):
            break
    used = np.zeros(len(first), dtype=bool)
    used[triangles] = True
    return np.where(used[first], label[first], -1)


class Trial:
    """One filter on one surface, in a process of its own."""

    def __init__(self, surface, results, folder, timer):
        self.surface = surface
        self.results = results
        self.folder = folder
        self.timer = timer
        self.failures = []
        self.lengthened = 0.0
        self.moved = 0.0
        self.mesh = support.polydata(surface.points, surface.cells)

    def make(self, kind, data=None, **properties):
        """Returns a filter of the mesh, or of other data."""
        return support.make(kind, data or self.mesh, **properties)

    def update(self, algorithm):
        """Returns the output of a filter within the time limit."""
        if hasattr(algorithm, "SetMergeCoincidentPoints"):
            algorithm.SetMergeCoincidentPoints(self.surface.merge)
        with self.timer:
            output = vtkdgg.check(algorithm)
        if hasattr(algorithm, "GetMeshReportTable"):
            report = algorithm.GetMeshReportTable()
            added = report.GetColumnByName("Mollification").GetValue(0)
            height = report.GetColumnByName("LargestCapHeight").GetValue(0)
            self.lengthened = max(self.lengthened, added)
            self.moved = max(self.moved, height)
        return output

    def expect(self, holds, text):
        """Reports the number of violations of an array of conditions."""
        wrong = ~np.atleast_1d(np.asarray(holds, dtype=bool))
        if wrong.any():
            self.failures.append(f"{text} ({wrong.sum()} of {wrong.size})")

    def expect_most(self, values, bounds, text):
        """Reports values that exceed their bounds, and the worst of them."""
        values, bounds = np.broadcast_arrays(np.atleast_1d(values), bounds)
        with np.errstate(invalid="ignore"):
            excess = np.where(values <= bounds, -np.inf, values - bounds)
        if excess.size and excess.max() != -np.inf:
            i = np.unravel_index(np.argmax(np.nan_to_num(excess, nan=np.inf)), excess.shape)
            self.expect(excess == -np.inf, f"{text}: {values[i]:.10g} > {bounds[i]:.10g}")

    def expect_close(self, found, true, text, relative=0.0):
        """Reports finite distances that differ from the true ones by more than rounding errors, or
        by more than a relative error."""
        reached = np.isfinite(true)
        found, true = found[reached], true[reached]
        self.expect_most(np.abs(found - true), relative * true + self.slack(true), text)

    def slack(self, distance):
        """Returns the error of exact distances by rounding and by changed or skipped triangles."""
        changed = 4 * self.lengthened + 2 * self.moved
        return EXACT * np.abs(distance) + self.surface.rounding + changed

    def gained(self, faces):
        """Returns the error of the heights of faces that filters compute from lengths of edges: the
        square of the height grows by the error of an edge times twice its length. The error is
        small except in long triangles."""
        longest = self.surface.sides[faces].max(axis=1)
        height = 2 * self.surface.areas[faces] / np.where(longest > 0, longest, 1)
        longer = self.lengthened + LENGTH * longest
        return np.sqrt(height**2 + 2 * longer * longest) - height

    def graph(self):
        """Returns the surface with its graph, from the file."""
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(self.folder, "graph.vtp"))
        return vtkdgg.check(reader)


# --- Geometry ------------------------------------------------------------------------------------


def to_triangles(points, corners):
    """Returns the distance of each point from the closest point of its triangle, which may have no
    area."""
    best = np.full(len(points), np.inf)
    for i in range(3):
        a, b = corners[:, i - 1], corners[:, i]
        along = np.einsum("ij,ij->i", points - a, b - a)
        length = np.einsum("ij,ij->i", b - a, b - a)
        t = np.clip(along / np.where(length > 0, length, 1), 0, 1)[:, None]
        best = np.minimum(best, np.linalg.norm(points - (a + t * (b - a)), axis=1))
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    w = points - corners[:, 0]
    normal = np.cross(u, v)
    square = np.einsum("ij,ij->i", normal, normal)
    square = np.where(square > 0, square, np.inf)
    s = np.einsum("ij,ij->i", np.cross(w, v), normal) / square
    t = np.einsum("ij,ij->i", np.cross(u, w), normal) / square
    inside = (s >= 0) & (t >= 0) & (s + t <= 1)
    foot = corners[:, 0] + s[:, None] * u + t[:, None] * v
    return np.where(inside, np.minimum(best, np.linalg.norm(points - foot, axis=1)), best)


def pieces_of(lines):
    """Returns the point ids of both ends of each piece of polylines, and the index of its line."""
    if lines.GetNumberOfLines() == 0:
        return np.empty((0, 2), dtype=int), np.empty(0, dtype=int)
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    line = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    inner = line[1:] == line[:-1]
    return np.column_stack([ids[:-1], ids[1:]])[inner], line[:-1][inner]


def polygon_areas(polygons):
    """Returns the areas of planar polygons."""
    points = vtk_to_numpy(polygons.GetPoints().GetData())
    offsets = vtk_to_numpy(polygons.GetPolys().GetOffsetsArray())
    ids = vtk_to_numpy(polygons.GetPolys().GetConnectivityArray())
    polygon = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    after = np.arange(1, len(ids) + 1)
    after[offsets[1:] - 1] = offsets[:-1]
    start = points[ids[offsets[polygon]]]  # as origin, for the digits
    doubled = np.cross(points[ids] - start, points[ids[after]] - start)
    sums = [np.bincount(polygon, doubled[:, axis], len(offsets) - 1) for axis in range(3)]
    return 0.5 * np.linalg.norm(sums, axis=0)


def with_points(surface, places, faces):
    """Returns the mesh with a point inserted into each of some faces and into its duplicates."""
    new = np.full(len(surface.triangles), -1)
    new[faces] = len(surface.points) + np.arange(len(faces))
    new = new[surface.first_copy]
    split = surface.triangles[new >= 0]
    a, b, c = split.T
    m = new[new >= 0]
    parts = [np.column_stack(t) for t in ((a, b, m), (b, c, m), (c, a, m))]
    return np.vstack([surface.points, places]), np.concatenate([surface.triangles[new < 0], *parts])
