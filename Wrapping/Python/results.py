# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of queries as NumPy arrays."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, List, Tuple

import numpy as np

from .checks import counted

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["EarthMovers", "Isoline", "Loop", "PatchBoundary", "Path", "Samples", "Voronoi"]

GRAPH_ARRAYS = tuple(
    f"DGG.{role}"
    for role in (
        "Offsets", "Targets", "Lengths", "Angles", "ArrivalAngles", "Radii", "GhostIds", "Info"
    )
)
WINDOW_ARRAYS = (".WindowOffsets", ".Windows", ".WindowSources", ".WindowInfo")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Path:
    """A polyline on a surface, from start to end. Every segment lies in one triangle.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (k, 3)
        One point when start and end coincide.
    length : float
        In the unit of the points.
    graph_length : float
        Length of the path in the graph, before it was shortened: at most (1 + accuracy) times the
        exact distance. NaN for exact paths.
    faces : numpy.ndarray of int64, shape (k,)
        Id of the cell that contains the segment after the point; for the last point, the segment
        before it. -1 at a point that no cell uses, and on clouds.
    barycentric : numpy.ndarray of float64, shape (k, 3), or None
        Barycentric coordinates in `faces`; 0 if the face is -1. The list
        ``list(zip(faces, barycentric))`` identifies the points as sources, also where layers of the
        surface coincide. None for a surface with other cells than triangles, and for a cloud.
    point_ids : numpy.ndarray of int64, shape (k,)
        Id of the point of the mesh at this position, otherwise -1.
    arc_lengths : numpy.ndarray of float64, shape (k,)
        Length of the line up to the point.
    """

    points: NDArray[np.float64]
    length: float
    graph_length: float
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    point_ids: NDArray[np.int64]
    arc_lengths: NDArray[np.float64]

    def __repr__(self) -> str:
        count = len(self.points)
        unit = "point" if count == 1 else "points"
        return f"<vtkdgg.Path: length {self.length:g}, {count} {unit}>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Loop:
    """A closed polyline on a surface; the last point equals the first.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (k, 3)
        Closed.
    length : float
        In the unit of the points.
    angle : float
        The smallest angle of the loop at its points, in radians: pi for a closed geodesic.
    faces, barycentric, point_ids, arc_lengths : numpy.ndarray
        As those of a `Path`.
    """

    points: NDArray[np.float64]
    length: float
    angle: float
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    point_ids: NDArray[np.int64]
    arc_lengths: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"<vtkdgg.Loop: length {self.length:g}, {len(self.points)} points>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Isoline:
    """A polyline along which a distance has one value, with lower distances on its left.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (k, 3)
        The last point equals the first unless the line ends at the boundary.
    value : float
        The distance, in the unit of the points.
    faces, barycentric, point_ids, arc_lengths : numpy.ndarray
        As those of a `Path`.
    """

    points: NDArray[np.float64]
    value: float
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    point_ids: NDArray[np.int64]
    arc_lengths: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"<vtkdgg.Isoline: value {self.value:g}, {len(self.points)} points>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PatchBoundary:
    """A curve of a patch layout, from one landmark to another.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (k, 3)
        From the first landmark to the second.
    landmarks : tuple of two int
        Indices of the two landmarks.
    length : float
        In the unit of the points.
    fractions : numpy.ndarray of float64, shape (k,)
        Length of the line up to the point, divided by `length`. Points of the same curve on both
        surfaces correspond if their fractions are equal.
    faces, barycentric, point_ids, arc_lengths : numpy.ndarray
        As those of a `Path`.
    """

    points: NDArray[np.float64]
    landmarks: Tuple[int, int]
    length: float
    fractions: NDArray[np.float64]
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    point_ids: NDArray[np.int64]
    arc_lengths: NDArray[np.float64]

    def __repr__(self) -> str:
        first, second = self.landmarks
        return f"<vtkdgg.PatchBoundary: landmarks {first} and {second}, length {self.length:g}>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Samples:
    """Points that are spread evenly on a surface, in the order in which they were chosen.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (k, 3)
        Coordinates.
    point_ids : numpy.ndarray of int64, shape (k,)
        Id of the point of the mesh, -1 for a sample in a face or on an edge.
    faces : numpy.ndarray of int64, shape (k,)
        Id of a cell that contains the sample; -1 at points that no cell uses, and on clouds.
    barycentric : numpy.ndarray of float64, shape (k, 3), or None
        As that of a `Path`.
    covering_radii : numpy.ndarray of float64, shape (k,)
        The largest distance of a point of the mesh from the samples up to this one, in the unit of
        the points; infinite until every component has a sample.
    """

    points: NDArray[np.float64]
    point_ids: NDArray[np.int64]
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    covering_radii: NDArray[np.float64]

    def __repr__(self) -> str:
        radius = self.covering_radii[-1] if len(self.points) else np.inf
        return f"<vtkdgg.Samples: {len(self.points)}, covering radius {radius:g}>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Voronoi:
    """Voronoi cells of sites.

    Attributes
    ----------
    nearest : numpy.ndarray of int, shape (n,)
        Index of the nearest site of each point of the mesh, -1 for unreached points.
    distances : numpy.ndarray of float64, shape (n,)
        Distance from the nearest site, in the unit of the points; NaN for unreached points.
    sites : numpy.ndarray of float64, shape (k, 3)
        Coordinates of the sites, after they were moved.
    point_ids, faces, barycentric : numpy.ndarray
        Of the sites, as those of `Samples`.
    areas : numpy.ndarray of float64, shape (k,), or None
        Areas of the cells, in the squared unit of the points; None for a cloud.
    """

    nearest: NDArray[np.intp]
    distances: NDArray[np.float64]
    sites: NDArray[np.float64]
    point_ids: NDArray[np.int64]
    faces: NDArray[np.int64]
    barycentric: NDArray[np.float64] | None
    areas: NDArray[np.float64] | None

    def __repr__(self) -> str:
        return f"<vtkdgg.Voronoi: {counted(len(self.sites), 'site')}, {len(self.nearest)} points>"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class EarthMovers:
    """Transport of one distribution to another at the least cost.

    Attributes
    ----------
    distance : float
        The cost: for distributions of mass 1 a length in the unit of the points.
    lower_bound : float
        A lower bound of the cost on this mesh.
    potential : numpy.ndarray of float64, shape (n,)
        A length at each point, with slope at most 1, that proves the lower bound.
    flow : numpy.ndarray of float64, shape (m, 3)
        Mass per length that flows through each cell.
    """

    distance: float
    lower_bound: float
    potential: NDArray[np.float64]
    flow: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"<vtkdgg.EarthMovers: distance {self.distance:g}>"


def is_on_input(result):
    """Returns true if a result consists of arrays on the points or the cells of the input."""
    has_rows = any(len(values) for values in result.point_data.values())
    return len(result.points) == 0 and has_rows


def window_arrays(names, distances=None):
    """Returns the names of the field arrays that contain the windows of a distance array, or all
    windows for None. `names` are the names of all field arrays."""
    info = WINDOW_ARRAYS[-1]
    found = [name[: -len(info)] for name in names if name.endswith(info) and name != info]
    prefixes = found if distances is None else [distances]
    return [f"{prefix}{suffix}" for prefix in prefixes for suffix in WINDOW_ARRAYS]


def surface_points_of(arrays):
    """Returns the point arrays that identify surface points, by names of attributes."""
    return {
        "point_ids": arrays["vtkOriginalPointIds"],
        "faces": arrays["FaceId"],
        "barycentric": arrays.get("Barycentric"),
    }


def voronoi_of(points, sites):
    """Returns Voronoi cells from two results of the kernel."""
    return Voronoi(
        nearest=points.point_data["GeodesicSource"].astype(np.intp),
        distances=points.point_data["GeodesicDistance"],
        sites=sites.points,
        **surface_points_of(sites.point_data),
        areas=sites.point_data.get("CellArea"),
    )


def lines_of(result, kind, **names):
    """Returns the polylines of a result of the kernel as objects of the class `kind`. `names` are
    the point or cell arrays of its further attributes."""
    offsets, corners = result.cells["lines"]
    if len(offsets) < 2:
        return []
    points, data = result.points, result.point_data
    per_point = {**surface_points_of(data), "arc_lengths": data["ArcLength"]}
    first = len(result.cells["verts"][0]) - 1  # arrays of cells begin with verts
    per_point.update({key: data[name] for key, name in names.items() if name in data})
    cells = {key: name for key, name in names.items() if name in result.cell_data}
    per_line = {key: result.cell_data[name][first:] for key, name in cells.items()}
    lines: List = []
    for i in range(len(offsets) - 1):
        ids = corners[offsets[i] : offsets[i + 1]]
        ids = ids[:1] if len(ids) == 2 and ids[0] == ids[1] else ids
        of_points = {k: None if v is None else v[ids] for k, v in per_point.items()}
        if len(ids) > 1 and ids[0] == ids[-1]:  # the array has 0 at the first point
            closing = np.linalg.norm(points[ids[-1]] - points[ids[-2]])
            of_points["arc_lengths"][-1] = of_points["arc_lengths"][-2] + closing
        lines.append(
            kind(
                points=points[ids],
                **of_points,
                **{key: _plain(values[i]) for key, values in per_line.items()},
            )
        )
    return lines


def _plain(row):
    """Returns a row of an array as a number, or as a tuple of numbers."""
    found = row.tolist()
    return tuple(found) if isinstance(found, list) else found
