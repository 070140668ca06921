# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""One-liners on numpy arrays."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .errors import run
from .vtkDGGFiltersGeodesic import vtkExactGeodesicDistance

__all__ = ["distance"]


def distance(points, triangles, sources, maximum_distance=None, unreached=np.nan):
    """Exact geodesic distance of every point of a triangle mesh from the nearest source.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates.
    triangles : array_like of int, shape (m, 3)
        Point ids of the corners.
    sources : int, sequence of int, or array_like of float, shape (k, 3)
        Point ids, or coordinates of points anywhere on the surface; they are moved to the closest
        point of the surface.
    maximum_distance : float, optional
        Points farther than this are left unreached. Default: no limit.
    unreached : float, optional
        Distance given to points that no source reaches. Default: NaN.

    Returns
    -------
    numpy.ndarray of float64, shape (n,)
        Distances in the unit of `points`; empty when there are no points.

    Raises
    ------
    ValueError
        When an array has the wrong shape or type, a number is not finite, or an id does not exist.
    VTKError
        When the filter refuses the input, as for coordinates far off the surface.

    See Also
    --------
    vtkExactGeodesicDistance : the filter that does the work, with further options.

    Examples
    --------
    >>> d = vtkdgg.distance([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 0)
    >>> d
    array([0., 3., 4.])
    """
    points = _coordinates(points, "points")
    triangles = _triangles(triangles, len(points))
    limit = _limit(maximum_distance)
    ids, places = _sources(sources, len(points))
    if len(points) == 0:
        return np.empty(0)

    distance_filter = vtkExactGeodesicDistance()
    distance_filter.SetInputData(_polydata(points, triangles))
    if ids is not None:
        distance_filter.SetSourceIds(ids)
    else:
        distance_filter.SetInputData(1, _polydata(places))
    if limit is not None:
        distance_filter.SetMaximumDistance(limit)
    distance_filter.SetUnreachedValue(unreached)
    name = distance_filter.GetDistanceArrayName()
    output = run(distance_filter)
    # A copy, because the output goes with the filter.
    return np.array(vtk_to_numpy(output.GetPointData().GetArray(name)), dtype=np.float64)


def _array(values, name, kind):
    """`values` as an array of numbers of the kind ("integer", "number")."""
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of unequal length
        raise ValueError(f"{name}: not an array of numbers ({error})") from None
    allowed = {"integer": "iu", "number": "iuf"}[kind]
    if array.size and array.dtype.kind not in allowed:
        raise ValueError(f"{name}: {kind}s are wanted, not {array.dtype}")
    return array


def _coordinates(values, name):
    array = _array(values, name, "number")
    if array.size == 0 and array.ndim < 2:
        return np.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: the shape must be (n, 3), not {array.shape}")
    array = np.ascontiguousarray(array, dtype=np.float64)
    finite = np.isfinite(array).all(axis=1)
    if not finite.all():
        row = int(np.argmin(finite))
        raise ValueError(f"{name}: row {row} is not finite: {array[row]}")
    return array


def _triangles(values, number_of_points):
    array = _array(values, "triangles", "integer")
    if array.size == 0 and array.ndim < 2:
        array = np.empty((0, 3), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"triangles: the shape must be (m, 3), not {array.shape}")
    _check_ids(array, number_of_points, "triangles")
    return np.ascontiguousarray(array, dtype=np.int64)


def _sources(values, number_of_points):
    """A list of ids and None, or None and an array of coordinates."""
    array = _array(values, "sources", "number")
    if array.size == 0:
        raise ValueError("sources: at least one is wanted")
    if array.ndim == 2:
        return None, _coordinates(array, "sources")
    if array.ndim > 2 or array.dtype.kind not in "iu":
        raise ValueError(
            "sources: point ids (an integer or a sequence of integers) or coordinates "
            f"of shape (k, 3) are wanted, not {array.dtype} of shape {array.shape}"
        )
    array = np.atleast_1d(array)
    if number_of_points:
        _check_ids(array, number_of_points, "sources")
    return [int(i) for i in array], None


def _check_ids(array, number_of_points, name):
    outside = (array < 0) | (array >= number_of_points)
    if outside.any():
        place = np.unravel_index(int(np.argmax(outside)), array.shape)
        raise ValueError(
            f"{name}: point id {array[place]} (entry {', '.join(map(str, place))}) does not exist; "
            f"there are {number_of_points} points"
        )


def _limit(value):
    if value is None:
        return None
    limit = float(value)
    if not limit >= 0.0:
        raise ValueError(f"maximum_distance: must not be negative or NaN, is {limit}")
    return limit


def _polydata(points, triangles=None):
    # Deep copies: the pipeline may outlive the arrays.
    polydata = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    polydata.SetPoints(vtk_points)
    if triangles is not None:
        offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
        cells = vtkCellArray()
        cells.SetData(
            numpy_to_vtkIdTypeArray(offsets, deep=True),
            numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True),
        )
        polydata.SetPolys(cells)
    return polydata
