# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""One-liners on numpy arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import arguments
from .errors import run
from .vtkDGGFiltersGeodesic import (
    vtkDGGDistance,
    vtkExactGeodesicDistance,
    vtkVirtualSourceGeodesicDistance,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["distance"]


def distance(
    points: ArrayLike,
    triangles: ArrayLike,
    sources: ArrayLike,
    maximum_distance: Optional[float] = None,
    unreached: float = np.nan,
    accuracy: Optional[float] = None,
    merge_coincident_points: bool = False,
    projection_tolerance: Optional[float] = None,
    merge_tolerance: float = 0.0,
    method: Optional[str] = None,
) -> NDArray[np.float64]:
    """Geodesic distance of every point of a triangle mesh from the nearest source.

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
    accuracy : float, optional
        Largest relative error, in [1e-6, 0.5]. Default: None, the exact distance. With a number a
        graph is built for this one call. That pays off for many calls: see `Graph`.
    merge_coincident_points : bool, optional
        Whether points with the very same coordinates are one, as along the seams of a textured
        mesh or in a soup of triangles. (MergeCoincidentPoints, in the messages of the filters.)
    merge_tolerance : float, optional
        How far from each other merged points may be, as a fraction of the diagonal of the bounding
        box of all points. Default: 0, the very same coordinates. Only used with
        `merge_coincident_points`. (MergeTolerance, in the messages of the filters.)
    projection_tolerance : float, optional
        How far coordinates of sources may be from the surface, as a fraction of the diagonal of
        its bounding box. Default: 0.01. (ProjectionTolerance, in the messages of the filters.)
    method : {"exact", "graph", "fast"}, optional
        Default: "exact", or "graph" when there is an `accuracy`, whose default is 0.01 then. "fast"
        takes milliseconds, and nothing bounds its errors; together with `accuracy` it is an error.

    Returns
    -------
    numpy.ndarray of float64, shape (n,)
        Distances in the unit of `points`; empty when there are no points.

    Raises
    ------
    ValueError
        When an array or another argument has the wrong shape or type, a number is not finite, or
        an id does not exist.
    VTKError
        When the filter refuses the input, as for coordinates far off the surface.

    See Also
    --------
    Graph : for many calls on one mesh.
    vtkExactGeodesicDistance, vtkDGGDistance, vtkVirtualSourceGeodesicDistance : the filters that
        do the work, with further options.

    Examples
    --------
    >>> d = vtkdgg.distance([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 0)
    >>> d
    array([0., 3., 4.])
    """
    points = arguments.coordinates(points, "points")
    triangles = arguments.corners(triangles, len(points))
    limit = arguments.limit(maximum_distance, "maximum_distance")
    ids, places = arguments.places(sources, "sources", len(points))
    unreached = arguments.number(unreached, "unreached")
    tolerance = arguments.projection_tolerance(projection_tolerance)
    kinds = {
        "exact": vtkExactGeodesicDistance,
        "graph": vtkDGGDistance,
        "fast": vtkVirtualSourceGeodesicDistance,
    }
    if method is None:
        method = "exact" if accuracy is None else "graph"
    if not isinstance(method, str) or method not in kinds:
        raise ValueError(f"method is {method!r}: it has to be one of {', '.join(map(repr, kinds))}")
    if accuracy is not None and method != "graph":
        raise ValueError(f'accuracy is for the method "graph", not for {method!r}')
    if len(points) == 0:
        return np.empty(0)

    distance_filter = kinds[method]()
    if accuracy is not None:
        distance_filter.SetAccuracy(arguments.number(accuracy, "accuracy"))
    distance_filter.SetInputData(arguments.polydata(points, triangles))
    if ids is not None:
        distance_filter.SetSourceIds(ids)
    else:
        distance_filter.SetSourceData(arguments.polydata(places))
    distance_filter.SetMergeCoincidentPoints(bool(merge_coincident_points))
    distance_filter.SetMergeTolerance(arguments.limit(merge_tolerance, "merge_tolerance"))
    distance_filter.SetProjectionTolerance(tolerance)
    distance_filter.SetMaximumDistance(limit)
    distance_filter.SetUnreachedValue(unreached)
    name = distance_filter.GetDistanceArrayName()
    output = run(distance_filter)
    # A copy, because the output goes with the filter.
    return np.array(vtk_to_numpy(output.GetPointData().GetArray(name)), dtype=np.float64)
