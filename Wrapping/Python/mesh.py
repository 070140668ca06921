# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh in NumPy arrays. This module imports no VTK."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from .checks import check_ids, coordinates, counted, numbers

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    Cells = Tuple[NDArray[np.int64], NDArray[np.int64]]

__all__ = ["Mesh"]


class Mesh:
    """A mesh, curves or a point cloud in NumPy arrays.

    `read` returns it, and every function accepts it as first argument. Arrays are copied. Verts,
    lines and polygons are pairs of arrays (offsets, corners): cell i has the point ids
    ``corners[offsets[i]:offsets[i + 1]]``. Cell ids count verts first, then lines, then polygons,
    as those of vtkPolyData do.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates. Points that no cell uses may be NaN.
    triangles : array_like, shape (m, 3), optional
        Point ids of the corners; larger polygons as for `distance`. Default: none, a point cloud.
    polygons, lines, verts : pair of array_like, shapes (k + 1,) and (p,), optional
        Offsets and corners; `polygons` replaces `triangles`.
    point_data, cell_data, field_data : dict of str to array_like, optional
        Arrays with one row for each point, one row for each cell, and of any length. A point array
        "Normals" with three columns holds the normals.

    Attributes
    ----------
    points : numpy.ndarray of float64, shape (n, 3)
        In the unit of the file or of the caller.
    polygons, lines, verts : pair of numpy.ndarray of int64, shapes (k + 1,) and (p,)
        Offsets and corners.
    point_data, cell_data, field_data : dict of str to numpy.ndarray
        Arrays of numbers by name.

    Raises
    ------
    ValueError
        When an array has the wrong shape or type, an id does not exist, or both `triangles` and
        `polygons` are given.

    Examples
    --------
    >>> mesh = vtkdgg.Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> mesh
    <vtkdgg.Mesh: 3 points, 1 polygon>
    >>> vtkdgg.distance(mesh, 0)
    array([0., 3., 4.])
    """

    def __init__(
        self,
        points: ArrayLike,
        triangles: Optional[ArrayLike] = None,
        *,
        polygons: Optional[Tuple[ArrayLike, ArrayLike]] = None,
        lines: Optional[Tuple[ArrayLike, ArrayLike]] = None,
        verts: Optional[Tuple[ArrayLike, ArrayLike]] = None,
        point_data: Optional[Dict[str, ArrayLike]] = None,
        cell_data: Optional[Dict[str, ArrayLike]] = None,
        field_data: Optional[Dict[str, ArrayLike]] = None,
    ) -> None:
        self.points: NDArray[np.float64] = coordinates(points, "points", is_finite=False).copy()
        if triangles is not None and polygons is not None:
            raise ValueError("triangles and polygons: expected one of them, got both")
        name = "polygons"
        if polygons is None:
            name = "triangles"
            polygons = polygons_of([] if triangles is None else triangles)
        self.polygons: Cells = checked_cells(polygons, name, len(self.points), 3)
        self.lines: Cells = checked_cells(lines or ([0], []), "lines", len(self.points), 2)
        self.verts: Cells = checked_cells(verts or ([0], []), "verts", len(self.points), 1)
        self.point_data: Dict[str, NDArray[Any]] = _arrays(
            point_data, "point_data", len(self.points)
        )
        count = sum(len(offsets) - 1 for offsets, _ in (self.verts, self.lines, self.polygons))
        self.cell_data: Dict[str, NDArray[Any]] = _arrays(cell_data, "cell_data", count)
        self.field_data: Dict[str, NDArray[Any]] = _arrays(field_data, "field_data", None)
        # For as_polydata(): names of the active arrays by attribute type of VTK, and True if the
        # file stores coordinates in single precision.
        self._active: Dict[int, str] = {}
        self._is_single = False

    @property
    def triangles(self) -> Optional[NDArray[np.int64]]:
        """Point ids of the corners, shape (m, 3); None if a polygon has more than three."""
        offsets, corners = self.polygons
        return corners.reshape(-1, 3) if (np.diff(offsets) == 3).all() else None

    @property
    def graph(self) -> Optional[Dict[str, NDArray[Any]]]:
        """Graph arrays in the field data (`DGG.Offsets` and others); None without a graph."""
        found = {key: value for key, value in self.field_data.items() if key.startswith("DGG.")}
        return found or None

    def as_polydata(self) -> vtkPolyData:
        """Returns a new vtkPolyData with copies of all arrays, for filters and writers."""
        from .surface import Surface  # which imports this module

        return Surface.of(self).polydata()

    def __repr__(self) -> str:
        counts = {"line": len(self.lines[0]) - 1, "polygon": len(self.polygons[0]) - 1}
        parts = [counted(n, one) for one, n in counts.items() if n]
        return f"<vtkdgg.Mesh: {', '.join([counted(len(self.points), 'point'), *parts])}>"


def checked_cells(pair, name, number_of_points, minimum=0):
    """Checks offsets and corners, and returns them as int64. Each cell must have at least `minimum`
    corners."""
    offsets, corners = (numbers(part, name, "integer") for part in pair)
    check_ids(corners, number_of_points, name)
    offsets, corners = offsets.astype(np.int64), corners.astype(np.int64).ravel()
    sizes = np.diff(offsets)
    ends = offsets[[0, -1]].tolist() if offsets.size else []
    if offsets.ndim != 1 or ends != [0, len(corners)] or (sizes < 0).any():
        raise ValueError(
            f"{name}: expected offsets that rise from 0 to the number of corners, {len(corners)}"
        )
    if len(sizes) and sizes.min() < minimum:
        kind = "polygon" if name == "triangles" else name[:-1]
        raise ValueError(f"{name}: a {kind} has {sizes.min()} corners; expected at least {minimum}")
    return offsets, corners


def _arrays(arrays, name, count):
    """Checks and copies named arrays; `count` is the number of rows, None for any number."""
    found = {}
    for key, values in (arrays or {}).items():
        if np.asarray(values).dtype == bool:  # a mask
            values = np.asarray(values, dtype=np.uint8)
        values = np.array(numbers(values, f"{name}[{key!r}]"))
        is_table = values.ndim == 1 or values.ndim == 2 and values.shape[1] > 0
        if not is_table or count not in (None, len(values)):
            expected = "rows" if count is None else f"{count} rows"
            raise ValueError(f"{name}[{key!r}]: expected {expected}, got shape {values.shape}")
        found[key] = values
    return found


def polygons_of(cells, name="triangles"):
    """Returns offsets and corners of polygons: rows of equal or unequal length, or one row
    [n, i, j, k, n, ...]."""
    if isinstance(cells, (list, tuple)) and len({np.size(row) for row in cells}) > 1:
        sizes = [np.size(row) for row in cells]
        corners = [i for row in cells for i in np.ravel(row)]
    else:
        array = numbers(cells, name, "integer")
        if array.size == 0 and array.ndim < 2:
            array = np.empty((0, 3), dtype=np.int64)
        if array.ndim == 2:
            if array.shape[1] < 3:
                raise ValueError(f"{name}: expected the shape (m, 3), got {array.shape}")
            if array.shape[1] == 4 and len(array) > 8 and (array[:, 0] == 3).all():
                raise ValueError(
                    f"{name}: every row of four begins with 3, as rows of VTK do; pass the other "
                    "three columns"
                )
            return np.arange(len(array) + 1) * array.shape[1], array
        if array.ndim != 1:
            raise ValueError(f"{name}: expected the shape (m, 3), got {array.shape}")
        sizes, corners = unpacked(array, name)
    return np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64), corners


def unpacked(row, name="triangles"):
    """Returns sizes and corners of cells in one row [n, i, j, k, n, ...]."""
    step = int(row[0]) + 1
    if step > 1 and len(row) % step == 0 and (row[::step] == step - 1).all():
        return np.full(len(row) // step, step - 1), row.reshape(-1, step)[:, 1:].ravel()
    starts = []
    at = 0
    while at < len(row):
        starts.append(at)
        if row[at] < 0:
            break
        at += int(row[at]) + 1
    if at != len(row):
        raise ValueError(
            f"{name}: expected the shape (m, 3), or one row with the number of corners of each "
            "polygon before its corners"
        )
    return row[starts], np.delete(row, starts)
