# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arguments. Errors are a ValueError that names the argument."""

from __future__ import annotations

import functools
import inspect
import operator
from typing import TYPE_CHECKING, Any, Callable, Sequence, Tuple, TypeVar, Union

import numpy as np

from .checks import check_flag, check_ids, coordinates, numbers, there_are  # noqa: F401
from .errors import needing_vtk

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    #: A point id, coordinates, or a tuple (face, (b0, b1, b2)). A list is never one such tuple: it
    #: is three coordinates or a list of points.
    SurfacePointLike = Union[int, ArrayLike, Tuple[int, ArrayLike]]
    #: One or several of them.
    SurfacePointsLike = Union[SurfacePointLike, Sequence[SurfacePointLike]]
    #: A function or a method.
    Function = TypeVar("Function", bound=Callable[..., Any])

# Tolerance of barycentric coordinates and of their sum, the same as in the filters.
_BARYCENTRIC_TOLERANCE = 1e-6
# The arrays of SurfacePoints.
_GIVEN = ("point_ids", "coordinates", "faces", "barycentric")


class SurfacePoints:
    """Points of a surface in the order in which a function was given them.

    Attributes
    ----------
    point_ids : numpy.ndarray of int64, shape (k,)
        The point ids; -1 for points that were given in another way.
    coordinates : numpy.ndarray of float64, shape (k, 3)
        The coordinates; NaN for points that were given in another way.
    faces, barycentric : numpy.ndarray of int64 and float64, shapes (k,) and (k, 3)
        Cells of the surface, and barycentric coordinates with respect to their corners; -1 and 0
        for points that were given in another way.
    """

    def __init__(self, surface, count):
        self._surface = surface
        self.point_ids = np.full(count, -1, dtype=np.int64)
        self.coordinates = np.full((count, 3), np.nan)
        self.faces = np.full(count, -1, dtype=np.int64)
        self.barycentric = np.zeros((count, 3))

    def __len__(self):
        return len(self.point_ids)

    def __getitem__(self, rows):
        """Returns the points of a slice or of an array of indices."""
        result = SurfacePoints(self._surface, 0)
        for name in _GIVEN:
            setattr(result, name, getattr(self, name)[rows])
        return result

    def interleaved(self, others):
        """Returns the points, each followed by the one of `others` with the same index."""
        result = SurfacePoints(self._surface, 0)
        for name in _GIVEN:
            pairs = np.stack([getattr(self, name), getattr(others, name)], axis=1)
            setattr(result, name, pairs.reshape(-1, *pairs.shape[2:]))
        return result

    @property
    def are_ids(self):
        """True if all points were given by id."""
        return bool((self.point_ids >= 0).all())

    def in_kernel(self):
        """Returns the points as functions of the kernel take them."""
        return self.point_ids if self.are_ids else self.by_position()

    def by_position(self):
        """Returns the points by their coordinates, as functions of the kernel take them."""
        return {"points": self.positions(), **self.identities()}

    def identities(self):
        """Returns the arrays that identify the points beside their coordinates: ids of points, or
        cells and barycentric coordinates, or both."""
        found = {}
        if (self.faces < 0).any():
            found["original_ids"] = self.point_ids
        if (self.faces >= 0).any():
            found.update(cells=self.faces, barycentric=self.barycentric)
        return found

    def positions(self):
        """Coordinates of all points, shape (k, 3)."""
        result = self.coordinates.copy()
        points = self._surface.points
        by_id, in_face = self.point_ids >= 0, self.faces >= 0
        result[by_id] = points[self.point_ids[by_id]]
        corners = points[self[in_face].corners()]
        result[in_face] = (self.barycentric[in_face, :, np.newaxis] * corners).sum(axis=1)
        return result

    def polydata(self, result=None):
        """Returns the points as a vtkPolyData with the point arrays that identify them, and with the
        arrays of a result of the kernel."""
        with needing_vtk("as_polydata"):
            from . import vtk_data, vtk_output

        points = vtk_data.points_polydata(self.positions())
        names = {"original_ids": "vtkOriginalPointIds", "cells": "FaceId"}
        for key, values in self.identities().items():
            vtk_data.add_array(points.GetPointData(), names.get(key, "Barycentric"), values)
        return points if result is None else vtk_output.polydata_of_result(result, points)

    def corners(self):
        """Point ids of the corners of the faces, shape (k, 3), if all points were given so."""
        offsets, corners = self._surface.polygons
        polygons = self.faces - self._surface.first_polygon
        return corners[offsets[polygons][:, np.newaxis] + np.arange(3)]


def surface_points(values, name, surface, is_cloud=False):
    """Returns points of a surface as `SurfacePoints`: ids (integers), coordinates (floats), tuples
    (face, barycentric coordinates), or a sequence that mixes them."""
    if values is None:
        raise ValueError(f"{name}: missing; pass point ids, coordinates or points in faces")
    if _is_in_face(values):
        values = [values]
    if is_mixed(values):
        result = SurfacePoints(surface, len(values))
        for i, value in enumerate(values):
            _set(result, i, value, f"{name}[{i}]")
    else:
        array = numbers(values, name)
        if array.size == 0:
            raise ValueError(f"{name}: expected at least one, got none")
        is_float = array.dtype.kind == "f"
        if array.shape != (3,) and array.ndim != 2 if is_float else array.ndim > 1:
            raise ValueError(
                f"{name}: expected point ids (an integer or a sequence of integers), coordinates "
                "(floats of shape (3,) or (k, 3)) or tuples (face, (b0, b1, b2)), got "
                f"{array.dtype} of shape {array.shape}"
            )
        array = coordinates(np.atleast_2d(array), name) if is_float else np.atleast_1d(array)
        result = SurfacePoints(surface, len(array))
        if is_float:
            result.coordinates = array
        else:
            if surface.number_of_points:  # distance() takes a mesh without points
                check_ids(array, surface.number_of_points, name)
            result.point_ids = array.astype(np.int64)
    _check_faces(result, name, surface, is_cloud)
    return result


def surface_point(value, name, surface, is_cloud=False):
    """Returns one point of a surface, as `SurfacePoints` of length 1."""
    if not _is_in_face(value):
        array = None if is_mixed(value) else numbers(value, name)
        if array is None or array.shape != ((3,) if array.dtype.kind == "f" else ()):
            kind = type(value).__name__
            raise ValueError(
                f"{name}: expected a point id (an integer), coordinates (floats of shape (3,)) or "
                "a tuple (face, (b0, b1, b2)), got "
                + (f"a {kind}" if array is None else f"{array.dtype} of shape {array.shape}")
            )
    return surface_points(value, name, surface, is_cloud)


def is_mixed(values):
    """Returns true for a sequence that is not an array: of tuples (face, barycentric coordinates),
    of ids and coordinates, or of such sequences."""
    return isinstance(values, (list, tuple)) and (
        any(_is_in_face(value) or is_mixed(value) for value in values)
        or len({hasattr(value, "__len__") for value in values}) > 1
    )


def _is_in_face(value):
    """Returns true for a tuple of a number and a sequence. A list is a list of points."""
    return (
        isinstance(value, tuple)
        and len(value) == 2
        and not hasattr(value[0], "__len__")
        and isinstance(value[1], (list, tuple, np.ndarray))
    )


def _set(points, i, value, name):
    """Sets point i of `points` to one of a mixed sequence."""
    if _is_in_face(value):
        weights = numbers(value[1], name)
        if weights.shape != (3,):
            raise ValueError(
                f"{name}: expected three barycentric coordinates, got shape {weights.shape}"
            )
        if isinstance(value[0], (bool, np.bool_)):
            raise ValueError(f"{name}: expected a face id (an integer), got {value[0]}")
        points.faces[i] = integer(value[0], name)
        points.barycentric[i] = weights
        return
    one = surface_point(value, name, points._surface)
    points.point_ids[i], points.coordinates[i] = one.point_ids[0], one.coordinates[0]


def _check_faces(points, name, surface, is_cloud):
    """Raises an error for a face or barycentric coordinates that do not identify a point."""
    in_face = ((points.point_ids < 0) & np.isnan(points.coordinates[:, 0])).nonzero()[0]
    if len(in_face) == 0:
        return
    if is_cloud:
        raise ValueError(f"{name}: a point cloud has no faces; give point ids or coordinates")
    offsets, _ = surface.polygons
    for i in in_face:
        face, weights = points.faces[i], points.barycentric[i]
        entry = f"{name}: face {face} (entry {i})"
        if not 0 <= face < surface.number_of_cells:
            cells = there_are(surface.number_of_cells, "cell")
            raise ValueError(f"{entry} does not exist; {cells}")
        polygon = face - surface.first_polygon
        if not 0 <= polygon < len(offsets) - 1 or offsets[polygon + 1] - offsets[polygon] != 3:
            raise ValueError(f"{entry} is not a triangle; barycentric coordinates need one")
        # False for NaN.
        if not (weights.min() >= -_BARYCENTRIC_TOLERANCE) or not (
            abs(weights.sum() - 1.0) <= _BARYCENTRIC_TOLERANCE
        ):
            raise ValueError(
                f"{entry} has the barycentric coordinates {weights}; expected non-negative "
                "numbers with the sum 1"
            )


def point_id(value, name, number_of_points):
    """Returns one point id."""
    array = numbers(value, name)
    if array.ndim > 0 or array.dtype.kind == "f":
        raise ValueError(
            f"{name}: expected a point id (an integer), got {array.dtype} of shape {array.shape}"
        )
    check_ids(array[np.newaxis], number_of_points, name)
    return int(array)


def finite_numbers(values, name, count):
    """Returns `count` finite numbers; a single one is repeated."""
    array = numbers(values, name)
    if array.size == 0 or array.shape not in ((), (count,)):
        expected = "one number" if count == 1 else f"one number or {count}"
        raise ValueError(f"{name}: expected {expected}, got shape {array.shape}")
    array = np.array(np.broadcast_to(array, (count,)), dtype=np.float64)
    if not np.isfinite(array).all():
        entry = int(np.argmin(np.isfinite(array)))
        raise ValueError(f"{name}: entry {entry} is not finite: {array[entry]}")
    return array


def number(value, name):
    """Returns one number. Text is an error, also if it looks like a number, and so is a bool."""
    try:
        if isinstance(value, (str, bytes, bool, np.bool_)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name}: expected a number, got {value!r}") from None


def with_flags(function: Function) -> Function:
    """Decorator that checks the arguments of a function that are annotated as bool."""
    names = [name for name, kind in function.__annotations__.items() if kind == "bool"]
    positions = list(inspect.signature(function).parameters)

    @functools.wraps(function)
    def checked(*values: Any, **options: Any) -> Any:
        for name, value in (*zip(positions, values), *options.items()):
            if name in names:
                check_flag(value, name)
        return function(*values, **options)

    return checked


def integer(value, name):
    """Returns one integer of 32 bits. A bool is an error."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        result = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: expected an integer, got {value!r}") from None
    if not -(2**31) <= result < 2**31:
        raise ValueError(f"{name}: expected an integer of 32 bits, got {result}")
    return result


def number_of_bytes(value, name):
    """Returns a number of bytes; 0, the default of the filters, for None."""
    if value is None:
        return 0
    if not 1.0 <= number(value, name) < 2.0**63:
        raise ValueError(f"{name}: expected 1 to 2^63 - 1 bytes, got {value}")
    return int(value)
