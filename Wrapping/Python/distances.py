# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances on a surface in one call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import arguments, meshes
from .errors import run
from .graph_info import choose_method, set_up
from .results import array_of
from .surface import add_array
from .vtkDGGFiltersGeodesic import (
    vtkDGGDistance,
    vtkDGGFastMarchingDistance,
    vtkExactGeodesicDistance,
    vtkVirtualSourceGeodesicDistance,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["distance"]

#: Filters by the names of methods.
FILTERS = {
    "exact": vtkExactGeodesicDistance,
    "graph": vtkDGGDistance,
    "fast": vtkVirtualSourceGeodesicDistance,
    "marching": vtkDGGFastMarchingDistance,
}


def distance(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    sources: Optional[SurfacePointsLike] = None,
    *,
    maximum_distance: Optional[float] = None,
    initial_distances: Optional[ArrayLike] = None,
    return_source: bool = False,
    unreached: float = np.nan,
    accuracy: Optional[float] = None,
    method: Optional[str] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[NDArray[np.float64], Tuple[NDArray[np.float64], NDArray[np.intp]], vtkPolyData]:
    """Geodesic distance of every point of a mesh from the nearest source:
    ``distance(points, triangles, sources)`` or ``distance(mesh, sources)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        Coordinates, and point ids of the corners. Larger polygons have more columns, or rows of
        unequal lengths, or are one row with the number of corners of each polygon before its
        corners. A mesh is a `Mesh`, the name of a file (see `read`), a pair of such arrays, a
        vtkPolyData such as a mesh of PyVista, another vtkPointSet, whose surface is used, or a mesh
        of trimesh, meshio, Open3D, vedo or nilearn.
    sources : surface points
        Integers are point ids. Floats, shape (3,) or (k, 3), are coordinates anywhere on the
        surface, which are moved to its closest point. A tuple (face, (b0, b1, b2)) is a point in a
        triangle: an index into `triangles`, or a cell id of a vtkPolyData or Mesh, and barycentric
        coordinates with respect to the corners of the triangle. A list may mix all three; it is
        never itself such a tuple: [5, (x, y, z)] is the point with id 5 and a second point with
        these coordinates.
    maximum_distance : float, optional
        Points farther than this are not reached. Default: no limit.
    initial_distances : float or sequence of float, optional
        Distances at the sources, in the unit of the points. Default: 0.
    return_source : bool, optional
        Return the nearest source of each point as well.
    unreached : float, optional
        Distance given to points that no source reaches. Default: NaN.
    accuracy : float, optional
        Largest relative error, in [1e-6, 0.5]. A graph is built for this one call, unless the mesh
        has a graph, which is used, with a warning if it is coarser. Default: the accuracy of the
        graph on the mesh, otherwise the exact distance. For many calls see `Graph`.
    method : {"exact", "graph", "fast", "marching"}, optional
        Default: "graph" with an `accuracy` and on a mesh or cloud that has a graph, otherwise
        "exact". The default accuracy of "graph" is 0.01. "fast" (virtual sources) takes
        milliseconds. "marching" (fast marching) takes point clouds as well: a mesh without
        polygons, or [] for the triangles. Errors of these two have no bound. An `accuracy` with
        another method than "graph", or on a cloud, is an error.
    merge_coincident_points : bool, optional
        Treat points with equal coordinates as one, as along the seams of a textured mesh or in a
        triangle soup.
    merge_tolerance : float, optional
        Largest distance of merged points, as a fraction of the diagonal of the bounding box of all
        points. Default: 0, equal coordinates. Only used with `merge_coincident_points`.
    projection_tolerance : float, optional
        Largest distance of the coordinates of a source from the surface, as a fraction of the
        diagonal of its bounding box. Default: 0.01.
    as_polydata : bool, optional
        Return the surface with the point array "GeodesicDistance", and with `return_source` also
        "GeodesicSource".

    Returns
    -------
    distances : numpy.ndarray of float64, shape (n,), or vtkPolyData
        In the unit of `points`. Without points it is empty, whatever the ids in `sources`; points
        without triangles are an error.
    nearest : numpy.ndarray of int, shape (n,)
        Index into `sources` of the nearest one, -1 for unreached points. Only with `return_source`
        and without `as_polydata`.

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
    CloudGraph : for point clouds, far more accurate than "marching".
    vtkExactGeodesicDistance, vtkDGGDistance, vtkVirtualSourceGeodesicDistance,
        vtkDGGFastMarchingDistance : the filters that do the work, with further options.

    Examples
    --------
    >>> d = vtkdgg.distance([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 0)
    >>> d
    array([0., 3., 4.])
    """
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    limit = arguments.limit(maximum_distance, "maximum_distance")
    sources = arguments.surface_points(sources, "sources", surface)
    unreached = arguments.number(unreached, "unreached")
    method, info = choose_method(method, accuracy, surface, FILTERS)
    distance_filter = FILTERS[method]()
    merging = merge_coincident_points, merge_tolerance
    set_up(distance_filter, surface, *merging, projection_tolerance, info)
    set_sources(distance_filter, sources, initial_distances)
    if surface.GetNumberOfPoints() == 0:
        if as_polydata:
            return surface
        return (np.empty(0), np.empty(0, dtype=np.intp)) if return_source else np.empty(0)

    if accuracy is not None:
        distance_filter.SetAccuracy(arguments.accuracy(accuracy))
    distance_filter.SetGenerateNearestSource(bool(return_source))
    distance_filter.SetMaximumDistance(limit)
    distance_filter.SetUnreachedValue(unreached)
    output = run(distance_filter)
    if as_polydata:
        return output
    return field_of(distance_filter, return_source)


def set_sources(solve, sources, initial_distances):
    """Sets the sources of a distance filter, `SurfacePoints`, and their initial distances."""
    offsets = np.zeros(len(sources))
    if initial_distances is not None:
        offsets = arguments.finite_numbers(initial_distances, "initial_distances", len(sources))
    ids, data = sources.ids, sources.data
    solve.SetSourceIds(ids, offsets[: len(ids)])
    if data is not None and initial_distances is not None:
        add_array(data.GetPointData(), solve.GetInitialDistanceArrayName(), offsets)
    solve.SetSourceData(data)


def field_of(solve, return_source):
    """Returns the distances that a filter computed, and on request the nearest sources."""
    # Copies: the filter keeps its output and returns it again for equal parameters.
    data = solve.GetOutput().GetPointData()
    distances = array_of(data, solve.GetDistanceArrayName())
    if not return_source:
        return distances
    nearest = data.GetArray(solve.GetSourceArrayName())
    return distances, vtk_to_numpy(nearest).astype(np.intp)
