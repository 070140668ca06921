# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances on a surface in one call, at its points or anywhere."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np

from . import _kernel, arguments, meshes
from .errors import call
from .graph_info import choose_method, find_or_build, merging

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["distance", "probe"]

_DISTANCE = "GeodesicDistance"
#: Functions of the kernel by the names of methods.
METHODS = {
    "exact": _kernel.exact_distance,
    "graph": _kernel.Graph.distance,
    "fast": _kernel.virtual_source_distance,
    "marching": _kernel.fast_marching_distance,
}


@arguments.with_flags
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
    at: Optional[SurfacePointsLike] = None,
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
    at : surface points, optional
        Points on the surface, in the forms of `sources`, at which the distances are returned. They
        are exact with the method "exact", and with "graph" where triangles are large for its
        accuracy; otherwise distances inside triangles have no error bound. A
        point is unreached if a corner of its triangle is. Not with `return_source`. Default: the
        points of the mesh.
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
        Return the surface, or the points of `at`, with the point array "GeodesicDistance", and with
        `return_source` also "GeodesicSource".

    Returns
    -------
    distances : numpy.ndarray of float64, shape (n,) or (p,), or vtkPolyData
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
    Error
        When the mesh cannot be used, or a point is far off the surface.

    See Also
    --------
    Graph : for many calls on one mesh.
    probe : for distances that were computed before.
    CloudGraph : for point clouds, far more accurate than "marching".
    vtkExactGeodesicDistance, vtkDGGDistance, vtkVirtualSourceGeodesicDistance,
        vtkDGGFastMarchingDistance : filters with further options.

    References
    ----------
    Exact: J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic problem",
    SIAM J. Comput. 16, 1987. "fast": P. Trettner, D. Bommes, L. Kobbelt, "Geodesic distance
    computation via virtual source propagation", Computer Graphics Forum 40(5), 2021. "marching":
    R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", Proc. Natl. Acad. Sci. 95,
    1998. "graph": see `Graph`.

    Examples
    --------
    >>> d = vtkdgg.distance([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 0)
    >>> d
    array([0., 3., 4.])
    """
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    sources = arguments.surface_points(sources, "sources", surface)
    options = field_options(sources, maximum_distance, initial_distances, projection_tolerance)
    options["unreached_value"] = arguments.number(unreached, "unreached")
    method, info = choose_method(method, accuracy, surface, METHODS)
    how = merging(merge_coincident_points, merge_tolerance, info)
    if at is not None:
        at = arguments.surface_points(at, "at", surface)
        if return_source:
            raise ValueError("return_source: expected False together with `at`, got True")
    elif surface.number_of_points == 0:
        if as_polydata:
            return surface.polydata()
        return (np.empty(0), np.empty(0, dtype=np.intp)) if return_source else np.empty(0)

    has_cloud = info is not None and info.is_cloud
    is_cloud = has_cloud or (method == "marching" and not surface.has_polygons)
    if is_cloud and at is not None:
        raise ValueError("at: applies to meshes, not to point clouds")
    target = prepared = surface.prepared(*how, is_cloud)
    if method == "graph":
        target = find_or_build(surface, target, accuracy, info)
    options["generate_nearest_source"] = return_source
    if at is not None:
        options["unreached_value"] = np.nan
        kind = "generate_windows" if method == "exact" else "generate_virtual_source"
        options[kind] = True
    result = call(METHODS[method], target, sources.in_kernel(), **options)
    if at is None:
        return surface.polydata(result) if as_polydata else field_of(result, return_source)
    result = _probed(prepared, result, _DISTANCE, at, options["projection_tolerance"])
    values = result.point_data[_DISTANCE]
    values[np.isnan(values)] = unreached
    return at.polydata(result) if as_polydata else values


@arguments.with_flags
def probe(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    distances: Union[str, ArrayLike, None] = None,
    at: Optional[SurfacePointsLike] = None,
    *,
    unreached: float = np.nan,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[NDArray[np.float64], vtkPolyData]:
    """Distances at points anywhere on a surface, from those at the points of its mesh:
    ``probe(points, triangles, distances, at)`` or ``probe(mesh, distances, at)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    distances : array_like of float, shape (n,), or str
        Distances by any method, or the name of a point array of the mesh. With a name, the array
        "GeodesicVirtualSource" and the windows that vtkExactGeodesicDistance adds are used if the
        mesh has them. Otherwise virtual sources are fitted to the distances.
    at : surface points
        Where the distances are evaluated, as the sources of `distance`.
    unreached : float, optional
        Value that marks unreached points, in addition to NaN and infinity. Default: NaN.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return the points of `at` with the point array, whose name is "GeodesicDistance" unless
        another one is given.

    Returns
    -------
    numpy.ndarray of float64, shape (p,), or vtkPolyData
        In the unit of `distances`; NaN in triangles with an unreached corner. Exact with windows;
        otherwise without an error bound: more accurate than linear interpolation if the
        sources are many edges apart, less accurate between sources a few edges apart.

    Raises
    ------
    ValueError, Error
        As for `distance`; also if there is no such array, or not one distance for each point.

    See Also
    --------
    distance : its argument `at` gives exact distances in one call.
    vtkGeodesicProbe : a filter with further options.

    References
    ----------
    J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic problem", SIAM J.
    Comput. 16, 1987, section 3.

    Examples
    --------
    >>> vtkdgg.probe([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], [0, 3, 4], [1.5, 2.0, 0.0])
    array([2.5])
    """
    surface, (distances, at) = meshes.take(points, triangles, distances=distances, at=at)
    at = arguments.surface_points(at, "at", surface)
    name, field = _DISTANCE, surface.data
    if isinstance(distances, str):
        name = distances
        if name not in field.point_data:
            known = ", ".join(map(repr, field.point_data)) or "none"
            raise ValueError(f"distances: there is no point array {name!r}; the mesh has {known}")
    else:
        values = arguments.numbers(distances, "distances")
        field = SimpleNamespace(point_data={name: values}, field_data={})
    options = {"unreached_value": unreached}
    prepared = surface.prepared(*merging(merge_coincident_points, merge_tolerance))
    result = _probed(prepared, field, name, at, projection_tolerance, **options)
    return at.polydata(result) if as_polydata else result.point_data[name]


def _probed(prepared, field, name, at, tolerance, **options):
    """Returns distances at `SurfacePoints` as a result of the kernel. `field` has the distances
    with this name, and may have their virtual sources and windows."""
    return call(
        _kernel.probe,
        prepared,
        field.point_data[name],
        at.in_kernel(),
        virtual_sources=field.point_data.get("GeodesicVirtualSource"),
        unreached=field.point_data.get(f"{name}.Unreached"),
        field_data=field.field_data,
        distance_array_name=name,
        projection_tolerance=tolerance,
        **options,
    )


def field_options(sources, maximum_distance, initial_distances, projection_tolerance):
    """Returns the options that distances of the kernel have in common, after their check."""
    options = {
        "maximum_distance": maximum_distance,
        "projection_tolerance": projection_tolerance,
    }
    if initial_distances is not None:
        count = len(sources)
        offsets = arguments.finite_numbers(initial_distances, "initial_distances", count)
        options["initial_distances"] = offsets
    return options


def field_of(result, return_source):
    """Returns the distances of a result, and on request the nearest sources."""
    distances = result.point_data[_DISTANCE]
    if not return_source:
        return distances
    return distances, result.point_data["GeodesicSource"].astype(np.intp)
