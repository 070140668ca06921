# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths on a surface as numpy arrays."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray

from . import arguments
from .errors import VTKError, run
from .vtkDGGFiltersGeodesic import vtkDGGPath

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Path", "path"]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Path:
    """A polyline on a surface, from start to end. Every piece lies in one triangle.

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
        The triangle that the piece after the point lies in; that before it for the last point. -1
        at a point that no triangle uses.
    point_ids : numpy.ndarray of int64, shape (k,)
        The point of the mesh where the path is at one, else -1.
    arc_lengths : numpy.ndarray of float64, shape (k,)
        Length of the path up to the point.
    """

    points: NDArray[np.float64]
    length: float
    graph_length: float
    faces: NDArray[np.int64]
    point_ids: NDArray[np.int64]
    arc_lengths: NDArray[np.float64]

    def __repr__(self) -> str:
        count = len(self.points)
        unit = "point" if count == 1 else "points"
        return f"<vtkdgg.Path: length {self.length:g}, {count} {unit}>"


def path(
    points: ArrayLike,
    triangles: ArrayLike,
    start: ArrayLike,
    end: ArrayLike,
    accuracy: Optional[float] = None,
    merge_coincident_points: bool = False,
    projection_tolerance: Optional[float] = None,
    merge_tolerance: float = 0.0,
) -> Path:
    """A shortest path on a triangle mesh.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates.
    triangles : array_like of int, shape (m, 3)
        Point ids of the corners.
    start, end : int, or array_like, shape (3,)
        A point id, or coordinates of a point anywhere on the surface; it is moved to the closest
        point of the surface. Three integers are coordinates.
    accuracy : float, optional
        Default: None, the path is exactly shortest. With a number in [1e-6, 0.5] a graph is built
        for this one call, and the path in it is shortened to a geodesic; its length is off by no
        more than this fraction. That pays off for many calls: see `Graph.path`.
    merge_coincident_points : bool, optional
        Whether points with the very same coordinates are one, as along the seams of a textured
        mesh or in a soup of triangles. (MergeCoincidentPoints, in the messages of the filters.)
    merge_tolerance : float, optional
        How far from each other merged points may be, as a fraction of the diagonal of the bounding
        box of all points. Default: 0, the very same coordinates. Only used with
        `merge_coincident_points`. (MergeTolerance, in the messages of the filters.)
    projection_tolerance : float, optional
        How far coordinates may be from the surface, as a fraction of the diagonal of its bounding
        box. Default: 0.01. (ProjectionTolerance, in the messages of the filters.)

    Returns
    -------
    Path

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
    points = arguments.coordinates(points, "points")
    triangles = arguments.corners(triangles, len(points))
    ends = arguments.place(start, "start", len(points)), arguments.place(end, "end", len(points))
    tolerance = arguments.projection_tolerance(projection_tolerance)
    finder = vtkDGGPath()
    if accuracy is None:
        finder.SetMethodToExact()
    else:
        finder.SetAccuracy(arguments.number(accuracy, "accuracy"))
    finder.SetInputData(arguments.polydata(points, triangles))
    finder.SetMergeCoincidentPoints(bool(merge_coincident_points))
    finder.SetMergeTolerance(arguments.limit(merge_tolerance, "merge_tolerance"))
    finder.SetProjectionTolerance(tolerance)
    return find(finder, ends, points)


def find(finder, ends, points, heard=None):
    """The path between two ends, as arguments.place() gives them, by a filter that is set up for the
    surface with these points. `heard` as for run()."""
    finder.RemoveAllPairs()
    if all(isinstance(end, int) for end in ends):
        finder.AddPair(*ends)
        finder.SetPairData(None)
    else:
        names = ("start", "end")
        places = [_place(finder, end, name, points) for end, name in zip(ends, names)]
        finder.SetPairData(_line(places))
    try:
        output = run(finder, heard, lambda: _is_unconnected(finder))
    except VTKError:
        if not _is_unconnected(finder):
            raise
        raise ValueError(
            "start and end are not connected by the surface; where its parts only touch, "
            "merge_coincident_points may join them"
        ) from None
    result = _path(output)
    tolerance = 0.0
    if finder.GetMergeCoincidentPoints():
        tolerance = finder.GetMergeTolerance() * np.linalg.norm(
            np.ptp(points[np.isfinite(points).all(axis=1)], axis=0)
        )
    for i, end, name in zip((0, -1), ends, ("start", "end")):
        if not isinstance(end, int):
            continue
        is_off = np.linalg.norm(result.points[i] - points[end]) > tolerance
        if is_off or (tolerance == 0.0 and result.point_ids[i] < 0):
            raise ValueError(f"{name}: no triangle uses point {end}; it is connected with no other")
    return result


def _is_unconnected(finder):
    status = finder.GetOutput().GetFieldData().GetArray("PathStatus")
    return status is not None and status.GetNumberOfTuples() > 0 and status.GetValue(0) == 1


def _line(places):
    """The pair of points as a line."""
    line = arguments.polydata(np.array(places, dtype=np.float64))
    cells = vtkCellArray()
    cells.InsertNextCell(2)
    cells.InsertCellPoint(0)
    cells.InsertCellPoint(1)
    line.SetLines(cells)
    return line


def _path(output):
    """The one polyline of the output, in arrays of its own: the output goes with the filter."""
    data, cells = output.GetPointData(), output.GetCellData()
    return Path(
        points=np.array(vtk_to_numpy(output.GetPoints().GetData())),
        length=float(vtk_to_numpy(cells.GetArray("Length"))[0]),
        graph_length=float(vtk_to_numpy(cells.GetArray("GraphLength"))[0]),
        faces=np.array(vtk_to_numpy(data.GetArray("FaceId"))),
        point_ids=np.array(vtk_to_numpy(data.GetArray("vtkOriginalPointIds"))),
        arc_lengths=np.array(vtk_to_numpy(data.GetArray("ArcLength"))),
    )


def _place(finder, end, name, points):
    """Coordinates of an end. Those of a point given by id must identify it."""
    if not isinstance(end, int):
        return end
    same = np.flatnonzero((points == points[end]).all(axis=1))
    if len(same) > 1 and not finder.GetMergeCoincidentPoints():
        other = same[0] if same[0] != end else same[1]
        raise ValueError(
            f"{name}: points {end} and {other} have the same coordinates; give start and end both "
            "as ids, or merge_coincident_points"
        )
    return points[end]
