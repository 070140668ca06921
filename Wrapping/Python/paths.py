# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shortest paths on a surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import arguments, meshes
from .errors import VTKError, run
from .graph_info import choose_method, set_up
from .results import Path, lines_of
from .surface import cells_of
from .vtkDGGFiltersGeodesic import vtkDGGPath

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointLike

__all__ = ["path"]


class NotConnectedError(ValueError):
    """No path exists, since the surface does not connect start and end."""


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
        When an array or another argument has the wrong shape or type, a number is not finite, an
        id does not exist, or start and end are not connected by the surface.
    VTKError
        When the filter refuses the input, as for coordinates far off the surface.

    See Also
    --------
    Graph.path : for many calls on one mesh.
    vtkDGGPath : the filter that does the work, for many pairs of points and on all threads.

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
    finder = vtkDGGPath()
    method, info = choose_method(method, accuracy, surface, ("exact", "graph"))
    if method == "exact":
        finder.SetMethodToExact()
    elif accuracy is not None:
        finder.SetAccuracy(arguments.accuracy(accuracy))
    merging = merge_coincident_points, merge_tolerance
    set_up(finder, surface, *merging, projection_tolerance, info)
    found = find(finder, start, end)
    return finder.GetOutput() if as_polydata else found[0]


def find(finder, starts, ends, issued=None):
    """Returns the paths between `SurfacePoints` by a filter with its input. The path is None for a
    pair that the surface does not connect; if it is the only pair, that is an error. `issued` is as
    for run()."""
    set_pairs(finder, starts, ends)
    is_alone = len(starts) == 1
    try:
        output = run(finder, issued, (lambda: _is_unconnected(finder)) if is_alone else None)
    except VTKError:
        if not (is_alone and _is_unconnected(finder)):
            raise
        raise NotConnectedError(
            "start and end are not connected by the surface; if its components "
            "have points with equal coordinates, `merge_coincident_points` may join them"
        ) from None
    found = [None] * len(starts)
    if output.GetNumberOfLines() > 0:
        pairs = vtk_to_numpy(output.GetCellData().GetArray("PairId"))
        lines = lines_of(output, Path, length="Length", graph_length="GraphLength")
        for pair, line in zip(pairs, lines):
            found[pair] = line
    return found


def set_pairs(finder, starts, ends):
    """Sets the pairs of points between which a filter finds paths."""
    finder.RemoveAllPairs()
    finder.SetPairData(None)
    if starts.ids and ends.ids:
        for pair in zip(starts.ids, ends.ids):
            finder.AddPair(*pair)
        return
    pairs = starts.interleaved(ends).polydata()
    ids = np.arange(2 * len(starts) + 1)
    pairs.SetLines(cells_of(ids[::2], ids[:-1]))
    finder.SetPairData(pairs)


def _is_unconnected(finder):
    status = finder.GetOutput().GetFieldData().GetArray("PathStatus")
    return status is not None and status.GetNumberOfTuples() > 0 and status.GetValue(0) == 1
