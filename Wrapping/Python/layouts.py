# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same layout of curves on two surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Tuple, Union

import numpy as np

from . import _kernel, arguments, meshes
from .errors import call
from .graph_info import merging
from .results import PatchBoundary, lines_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["patch_boundaries"]


@arguments.with_flags
def patch_boundaries(
    first: Any,
    second: Any,
    first_landmarks: SurfacePointsLike,
    second_landmarks: SurfacePointsLike,
    patches: Optional[ArrayLike] = None,
    *,
    edges: Optional[ArrayLike] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[Tuple[List[PatchBoundary], List[PatchBoundary]], Tuple[vtkPolyData, vtkPolyData]]:
    """Curves between landmarks that divide two surfaces into the same patches, the first step of a
    map from one surface to the other.

    Curves meet at landmarks only, in the same order around each landmark, and every patch is a disk
    on both surfaces.

    Parameters
    ----------
    first, second : mesh
        The two surfaces, as one object each: a pair (points, triangles), or another mesh as for
        `distance`. The second one may be mirrored or inside out.
    first_landmarks, second_landmarks : surface points
        Landmarks of each surface, as the sources of `distance`. Landmarks with the same index
        correspond.
    patches : array_like of int, shape (m, k), optional
        Indices of the landmarks around each patch; rows may have unequal lengths. Patches are
        oriented consistently, like the faces of a closed surface. Their sides are curves.
    edges : array_like of int, shape (m, 2), optional
        Indices of the landmarks at the ends of further curves. Without patches the first surface
        determines the order of curves around landmarks.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`, for both surfaces.
    as_polydata : bool, optional
        Return two vtkPolyData with polylines and the arrays of vtkGeodesicPatchBoundaries.

    Returns
    -------
    tuple of two lists of PatchBoundary, or tuple of two vtkPolyData
        The curves on the first and on the second surface, in the same order and direction. A curve
        is locally shortest where no landmark or earlier curve obstructs it; the total length is not
        minimal.

    Raises
    ------
    ValueError, Error
        As for `distance`; also for different numbers of landmarks, two landmarks at one position, a
        surface that cannot be oriented, and a layout that is invalid or cannot be drawn.

    See Also
    --------
    vtkGeodesicPatchBoundaries : a filter with the same result.

    References
    ----------
    E. Praun, W. Sweldens, P. Schroeder, "Consistent mesh parameterizations", SIGGRAPH 2001: short
    curves first, curves of a spanning tree before all others.

    Examples
    --------
    >>> triangle = [[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]
    >>> curves, _ = vtkdgg.patch_boundaries(triangle, triangle, [0, 1, 2], [0, 1, 2], [[0, 1, 2]])
    >>> [curve.length for curve in curves]
    [3.0, 5.0, 4.0]
    """
    sides = [("first", first, first_landmarks), ("second", second, second_landmarks)]
    surfaces, landmarks = zip(*(_side(*side) for side in sides))
    if patches is None and edges is None:
        raise ValueError("patches: missing; pass landmarks around patches, or `edges`")
    options = {"projection_tolerance": projection_tolerance}
    if patches is not None:
        options["patches"] = _patches(patches)
    if edges is not None:
        options["edges"] = _edges(edges)
    how = merging(merge_coincident_points, merge_tolerance)
    prepared = [surface.prepared(*how) for surface in surfaces]
    results = call(_kernel.patch_boundaries, *prepared, *landmarks, **options)
    if as_polydata:
        return tuple(surface.polydata(result) for surface, result in zip(surfaces, results))
    names = {"length": "Length", "landmarks": "LayoutEdge", "fractions": "ArcFraction"}
    return tuple(lines_of(result, PatchBoundary, **names) for result in results)


def _side(name, mesh, landmarks):
    """Returns a surface, and its landmarks as functions of the kernel take them."""
    found = meshes.opened(mesh)
    if found is None:
        raise ValueError(f"{name}: expected one mesh, such as a pair (points, triangles)")
    surface, _ = meshes.take(found)
    points = arguments.surface_points(landmarks, f"{name}_landmarks", surface)
    return surface, points.in_kernel()


def _patches(patches):
    """Returns offsets and landmarks of patches: rows of equal or unequal length."""
    if not isinstance(patches, (list, tuple, np.ndarray)):
        raise ValueError(f"patches: expected rows of landmarks, got {patches!r}")
    rows = [arguments.numbers(row, "patches", "integer") for row in patches]
    if any(row.ndim != 1 or len(row) < 3 for row in rows):
        raise ValueError(
            "patches: expected rows of at least three landmarks each, such as [[0, 1, 2]]"
        )
    return np.cumsum([0, *map(len, rows)]), np.concatenate([*rows, np.empty(0, dtype=np.int64)])


def _edges(edges):
    """Returns the ends of edges, shape (m, 2)."""
    array = arguments.numbers(edges, "edges", "integer")
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"edges: expected the shape (m, 2), got {array.shape}")
    return array
