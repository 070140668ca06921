# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances between many points of a graph, dense and sparse."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from . import arguments
from .graph_data import GraphData
from .progress import Bar, Part

if TYPE_CHECKING:
    from numpy.typing import DTypeLike, NDArray

    from .arguments import SurfacePointLike, SurfacePointsLike

# Number of entries of a block of a matrix.
_BLOCK = 2**23


class Matrices(GraphData):
    """Queries of a graph for distances between many points."""

    def matrix(
        self,
        rows: SurfacePointsLike,
        columns: Optional[SurfacePointsLike] = None,
        *,
        out: Optional[Any] = None,
        dtype: Optional[DTypeLike] = None,
        unreached: float = np.nan,
        projection_tolerance: Optional[float] = None,
    ) -> NDArray[Any]:
        """Distances between two sets of points, or between all pairs of one set.

        They are lengths of paths in the graph (there is no correction): at least the exact
        distance, and at most (1 + accuracy) times that. Between points of the mesh they are a
        metric.

        Parameters
        ----------
        rows, columns : surface points
            As for `distance`. Default of `columns`: the rows; the matrix is then symmetric.
        out : numpy.ndarray, memmap or similar, shape (number of rows, number of columns), optional
            Is filled with the distances block by block, and returned. Any object with a shape works
            if slices can be assigned to it. The matrix need not fit into memory.
        dtype : floating-point numpy.dtype, optional
            Type of the new array; one of another type than float64 is filled block by block. With
            `out` it must be the type of `out`. Default: float64, or the type of `out`.
        unreached : float, optional
            Distance given to pairs that are not connected. Default: NaN.
        projection_tolerance : float, optional
            As for `distance`.

        Returns
        -------
        numpy.ndarray of float64 or `dtype`, shape (number of rows, number of columns), or `out`
            In the unit of the points.

        Raises
        ------
        ValueError, Error
            As for `distance`; an Error also when the matrix, or a block of it, would take more
            memory than `memory_limit`.

        See Also
        --------
        vtkdgg.distributed.matrix : the same on a Dask cluster.
        """
        request = MatrixRequest(self, rows, columns, out, dtype, unreached, projection_tolerance)
        if out is None and request.dtype == np.float64:
            return self._call(
                self._graph.matrix, request.rows, request.columns, **request.options
            )
        request.check_rows(self)
        out = np.empty(request.shape, request.dtype) if out is None else out
        bar = Bar()
        try:
            for first, last in request.strips(max(1, _BLOCK // request.shape[1])):
                done = first / request.shape[0], last / request.shape[0]
                part = functools.partial(Part, bar, *done)
                strip = request.compute(self, first, last, bar=part)
                request.store(out, first, strip)
        finally:
            bar.close()
        return out

    def sparse_matrix(
        self,
        maximum_distance: float,
        rows: Optional[SurfacePointsLike] = None,
        *,
        projection_tolerance: Optional[float] = None,
    ) -> Any:
        """Distances between all pairs of points that are close to each other.

        The entries are those of `matrix`, without pairs that are farther apart and without pairs of
        a point with itself. Two points in the same position have an explicit 0. The cost is
        proportional to the number of entries.

        Parameters
        ----------
        maximum_distance : float
            Largest distance of an entry, in the unit of the points.
        rows : surface points, optional
            As for `distance`. Default: all points of the mesh.
        projection_tolerance : float, optional
            As for `distance`.

        Returns
        -------
        scipy.sparse.csr_matrix of float64, shape (number of rows, number of points)
            In the unit of the points.

        Raises
        ------
        ImportError
            When SciPy is not installed.
        ValueError, Error
            As for `matrix`.

        See Also
        --------
        neighborhood : the points around one point.
        """
        csr_matrix = self._csr_matrix("Graph.sparse_matrix")
        n = self.number_of_points
        rows = self._points(np.arange(n) if rows is None else rows, "rows")
        found = self._rows(rows, maximum_distance, False, projection_tolerance)
        offsets, columns, distances = found
        keep = columns != np.repeat(rows.point_ids, np.diff(offsets))
        offsets = np.concatenate([[0], np.cumsum(keep)])[offsets]
        return csr_matrix((distances[keep], columns[keep], offsets), shape=(len(rows), n))

    @arguments.with_flags
    def neighborhood(
        self,
        source: SurfacePointLike,
        radius: float,
        *,
        correction: bool = True,
        projection_tolerance: Optional[float] = None,
    ) -> Tuple[NDArray[np.intp], NDArray[np.float64]]:
        """Points within a distance from one point, nearest first.

        The distances are those of `distance` with `maximum_distance=radius`. The cost is
        proportional to the number of points found and does not depend on the size of the mesh.

        Parameters
        ----------
        source : surface point
            As one of the sources of `distance`.
        radius : float
            The largest distance, in the unit of the points.
        correction, projection_tolerance
            As for `distance`.

        Returns
        -------
        ids : numpy.ndarray of int, shape (k,)
            Point ids by increasing distance, then by increasing id. A source that is a point of the
            mesh is included.
        distances : numpy.ndarray of float64, shape (k,)
            In the unit of the points.

        Raises
        ------
        ValueError, Error
            As for `distance`.
        """
        point = arguments.surface_point(source, "source", self._surface, self.is_cloud)
        names = {"maximum_distance": "radius"}
        radius = arguments.number(radius, "radius")
        found = self._rows(point, radius, correction, projection_tolerance, names=names)
        _, ids, distances = found
        order = np.argsort(distances, kind="stable")
        return ids[order].astype(np.intp), distances[order]

    def _rows(self, rows, radius, correction, tolerance, **options):
        """Returns offsets, columns and distances of compressed rows."""
        return self._call(
            self._graph.neighborhood,
            rows.in_kernel(),
            maximum_distance=radius,
            correction=correction,
            projection_tolerance=tolerance,
            **options,
        )


class MatrixRequest:
    """A matrix of distances that is computed in strips: some rows, and all columns or, if it is
    symmetric, those from the diagonal on."""

    def __init__(self, graph, rows, columns, out, dtype, unreached, projection_tolerance):
        rows = graph._points(rows, "rows")
        columns = None if columns is None else graph._points(columns, "columns")
        self.shape = len(rows), len(rows if columns is None else columns)
        dtype = None if dtype is None else _floating_point(dtype)
        if out is not None:
            _check_out(out, self.shape, dtype)
            given = getattr(out, "dtype", None)
            dtype = given if isinstance(given, np.dtype) else dtype
        self.dtype = np.dtype(np.float64 if dtype is None else dtype)
        self.rows = rows.in_kernel()
        self.columns = None if columns is None else columns.in_kernel()
        self.options = {"unreached_value": unreached, "projection_tolerance": projection_tolerance}

    def check_rows(self, graph):
        """Raises an error if a row is not on the surface: strips would name the row wrongly."""
        if isinstance(self.rows, dict):
            tolerance = self.options["projection_tolerance"]
            graph._call(
                graph._graph.neighborhood,
                self.rows,
                maximum_distance=0.0,
                projection_tolerance=tolerance,
            )

    def strips(self, height):
        """Yields the first row of each strip and the row after its last one."""
        for first in range(0, self.shape[0], height):
            yield first, min(first + height, self.shape[0])

    def compute(self, graph, first, last, **options):
        """Returns the strip of the rows from `first` to before `last`."""
        columns = _slice(self.rows, first, None) if self.columns is None else self.columns
        rows = _slice(self.rows, first, last)
        strip = graph._call(graph._graph.matrix, rows, columns, **self.options, **options)
        if self.columns is None:
            square = strip[:, : last - first]
            np.minimum(square, square.T.copy(), out=square)
            np.fill_diagonal(square, 0.0)
        return strip

    def store(self, out, first, strip):
        """Writes a strip to the output."""
        last = first + len(strip)
        if self.columns is None:
            out[first:last, first:] = strip
            out[last:, first:last] = strip[:, last - first :].T
        else:
            out[first:last] = strip


def _slice(points, first, last):
    """Returns some of the points that a function of the kernel takes."""
    if isinstance(points, dict):
        return {name: values[first:last] for name, values in points.items()}
    return points[first:last]


def _floating_point(dtype):
    """Returns the argument as a floating-point numpy.dtype."""
    try:
        found = np.dtype(dtype)
    except TypeError:
        raise ValueError(f"dtype: expected a floating-point type, got {dtype!r}") from None
    if found.kind != "f":
        raise ValueError(f"dtype: expected a floating-point type, got {found}")
    return found


def _check_out(out, shape, dtype):
    """Raises an error if `out` cannot be filled with distances."""
    if not hasattr(out, "shape"):
        raise ValueError(f"out: expected an array, got {type(out).__name__}")
    if tuple(out.shape) != shape:
        raise ValueError(f"out: expected the shape {shape}, got {tuple(out.shape)}")
    given = getattr(out, "dtype", None)
    if getattr(given, "kind", "f") != "f":
        raise ValueError(f"out: expected a floating-point type, got {given}")
    if dtype is not None and given != dtype:
        raise ValueError(f"dtype: expected {given}, the type of out, got {dtype}; omit dtype")
    if isinstance(out, np.ndarray) and not out.flags.writeable:
        raise ValueError("out: the array is read-only")
