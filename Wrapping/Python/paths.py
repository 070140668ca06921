# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shortest paths on a surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

from . import _kernel, arguments, meshes
from .errors import call
from .graph_info import choose_method, find_or_build, merging
from .results import Path, lines_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointLike

__all__ = ["NotConnectedError", "path"]


class NotConnectedError(ValueError):
    """No path exists, since the surface does not connect start and end."""


@arguments.with_flags
def path(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    start: Optional[SurfacePointLike] = None,
    end: Optional[SurfacePointLike] = None,
    *,
    accuracy: Optional[float] = None,
    method: Optional[str] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[Path, vtkPolyData]:
    """Shortest path on a mesh: ``path(points, triangles, start, end)`` or
    ``path(mesh, start, end)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    start, end : surface point
        As one of the sources of `distance`.
    accuracy : float, optional
        Largest relative error of the length, in [1e-6, 0.5]. A graph is built for this one call,
        unless the mesh has a graph, which is used, with a warning if it is coarser. The path in the
        graph is shortened to a geodesic. Default: the accuracy of the graph on the mesh, otherwise
        the path is exactly shortest. For many calls see `Graph.path`.
    method : {"exact", "graph"}, optional
        Default: "graph" with an `accuracy` and on a mesh or cloud that has a graph, otherwise
        "exact".
    merge_coincident_points : bool, optional
        Treat points with equal coordinates as one, as along the seams of a textured mesh or in a
        triangle soup.
    merge_tolerance : float, optional
        Largest distance of merged points, as a fraction of the diagonal of the bounding box of all
        points. Default: 0, equal coordinates. Only used with `merge_coincident_points`.
    projection_tolerance : float, optional
        Largest distance of coordinates from the surface, as a fraction of the diagonal of its
        bounding box. Default: 0.01.
    as_polydata : bool, optional
        Return a vtkPolyData with one polyline.

    Returns
    -------
    Path or vtkPolyData

    Raises
    ------
    ValueError
        When an array or another argument has the wrong shape or type, a number is not finite, or an
        id does not exist.
    NotConnectedError
        A ValueError: when start and end are not connected by the surface.
    Error
        When the mesh cannot be used, or a point is far off the surface.

    See Also
    --------
    Graph.path : for many calls on one mesh.
    vtkDGGPath : a filter for many pairs of points.

    References
    ----------
    D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence of rectilinear barriers",
    Networks 14, 1984; S.-Q. Xin, G.-J. Wang, "Efficiently determining a locally exact shortest path
    on polyhedral surfaces", Computer-Aided Design 39, 2007.

    Examples
    --------
    >>> p = vtkdgg.path([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 0, [1.5, 2, 0])
    >>> p.length, p.points
    (2.5, array([[0. , 0. , 0. ],
           [1.5, 2. , 0. ]]))
    """
    surface, (start, end) = meshes.take(points, triangles, start=start, end=end)
    start = arguments.surface_point(start, "start", surface)
    end = arguments.surface_point(end, "end", surface)
    method, info = choose_method(method, accuracy, surface, ("exact", "graph"))
    how = merging(merge_coincident_points, merge_tolerance, info)
    options = {"projection_tolerance": projection_tolerance}
    target = surface.prepared(*how, info is not None and info.is_cloud)
    if method == "graph":
        target = find_or_build(surface, target, accuracy, info)
    else:
        options["method"] = "Exact"
    result = find(target, start, end, **options)
    return surface.polydata(result) if as_polydata else paths_of(result, 1)[0]


def find(target, starts, ends, issued=None, **options):
    """Returns the result of the kernel for the paths between `SurfacePoints` on a surface or in a
    graph. A single pair that the surface does not connect is an error."""
    pairs = starts.interleaved(ends).in_kernel()
    check = _require_connection if len(starts) == 1 else None
    return call(_kernel.paths, target, pairs, issued=issued, check=check, **options)


def paths_of(result, count):
    """Returns the paths of `count` pairs; None for unconnected pairs."""
    found = [None] * count
    lines = lines_of(result, Path, length="Length", graph_length="GraphLength")
    for line, pair in zip(lines, result.cell_data["PairId"]):
        found[pair] = line
    return found


def _require_connection(result):
    if result.field_data["PathStatus"][0] != 0:
        raise NotConnectedError(
            "start and end are not connected by the surface; if its components "
            "have points with equal coordinates, `merge_coincident_points` may join them"
        )
