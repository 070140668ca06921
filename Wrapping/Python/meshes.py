# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as other packages have them, and their way into VTK.

Points and cells are copied, so that whoever changes them afterwards, in another thread even, does
not change what is computed.
"""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData

from . import arguments
from .surface import copy_surface


def take(mesh, cells=None, **named):
    """The surface as a new vtkPolyData, and the arguments after it. The mesh is one object, or an
    array of points with `cells`; else `cells` is the first of the others, each of which may be None
    for one that is missing."""
    others = list(named.values())
    if not is_mesh(mesh):
        try:
            if cells is None:
                raise ValueError("triangles: they are missing, and the points have no cells")
            surface = from_arrays(mesh, cells)
        except ValueError as error:
            # Whoever gives points and sources alone may have a cloud.
            is_short = cells is None or any(other is None for other in others)
            if not (is_short and str(error).startswith("triangles: ")):
                raise
            raise ValueError(
                f"{error}; points without triangles are a cloud: see vtkdgg.CloudGraph"
            ) from None
    else:
        if cells is not None:
            missing = [i for i, other in enumerate(others) if other is None]
            if not missing:
                raise ValueError("triangles: the mesh has cells of its own")
            del others[missing[0]]
            others.insert(0, cells)
        surface = from_mesh(mesh)
    for name, other in zip(named, others):
        if other is None:
            raise ValueError(f"{name}: missing")
    return surface, others


def is_mesh(mesh):
    """Whether it is more than coordinates, and not the name of a file."""
    if isinstance(mesh, (str, os.PathLike)):
        raise ValueError(
            f"points: coordinates or a mesh are wanted, not {os.fspath(mesh)!r}; readers of VTK "
            "read files: mesh = vtkdgg.check(reader)"
        )
    return isinstance(mesh, vtkDataObject) or any(
        hasattr(mesh, name) for name in ("points", "vertices")
    )


def from_mesh(mesh):
    """A new vtkPolyData of any object with points and cells."""
    if isinstance(mesh, vtkPolyData):  # which those of PyVista are
        return copy_surface(mesh)
    if isinstance(mesh, vtkDataObject):
        raise ValueError(
            f"a surface is wanted, not a {mesh.GetClassName()}: vtkDataSetSurfaceFilter makes one "
            "of it"
        )
    points = mesh.points if hasattr(mesh, "points") else mesh.vertices
    if hasattr(mesh, "faces"):
        return from_arrays(points, mesh.faces)
    if hasattr(mesh, "cells"):  # meshio: blocks of cells of one type
        return from_arrays(points, [row for block in mesh.cells for row in _rows(block)])
    return from_arrays(points, [])


def points_of(mesh, name="points"):
    """The coordinates of a mesh, cloud or array, shape (n, 3)."""
    if isinstance(mesh, vtkDataObject):
        if not hasattr(mesh, "GetPoints"):
            raise ValueError(f"{name}: a {mesh.GetClassName()} has no points")
        mesh = vtk_to_numpy(mesh.GetPoints().GetData()) if mesh.GetPoints() else []
    elif is_mesh(mesh):
        mesh = mesh.points if hasattr(mesh, "points") else mesh.vertices
    return arguments.coordinates(mesh, name)


def from_arrays(points, cells):
    """A new vtkPolyData of points and polygons."""
    points = arguments.coordinates(points, "points")
    offsets, corners = _polygons(cells)
    arguments.check_ids(corners, len(points), "triangles")
    surface = arguments.polydata(points)
    polygons = vtkCellArray()
    polygons.SetData(
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(offsets, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners.ravel(), dtype=np.int64), deep=True),
    )
    surface.SetPolys(polygons)
    return surface


def _rows(block):
    """The polygons of a block of cells; points and lines have none."""
    kind = "".join(letter for letter in block.type if letter.isalpha())
    if kind in ("vertex", "line"):
        return []
    if block.type not in ("triangle", "quad") and kind != "polygon":
        raise ValueError(f"triangles: a surface is wanted, but there are cells {block.type!r}")
    return list(block.data)


def _polygons(cells):
    """Offsets of polygons and their corners, the ids as they were given.

    Cells have one row each, or are one row of all: the number of corners before the corners.
    """
    if isinstance(cells, (list, tuple)) and len({np.size(row) for row in cells}) > 1:
        sizes = [np.size(row) for row in cells]
        corners = [i for row in cells for i in np.ravel(row)]
    else:
        array = arguments.numbers(cells, "triangles", "integer")
        if array.size == 0 and array.ndim < 2:
            array = np.empty((0, 3), dtype=np.int64)
        if array.ndim == 2:
            if array.shape[1] < 3:
                raise ValueError(f"triangles: the shape must be (m, 3), not {array.shape}")
            return np.arange(len(array) + 1) * array.shape[1], array
        if array.ndim != 1:
            raise ValueError(f"triangles: the shape must be (m, 3), not {array.shape}")
        sizes, corners = _unpacked(array)
    if len(sizes) and min(sizes) < 3:
        raise ValueError(f"triangles: a polygon has {min(sizes)} corners")
    return np.concatenate([[0], np.cumsum(sizes)]), arguments.numbers(
        corners, "triangles", "integer"
    )


def _unpacked(row):
    """Numbers of corners and the corners, of [n, i, j, k, n, ...]."""
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
            "triangles: the shape must be (m, 3), or one row that has the number of corners before "
            "those of each polygon"
        )
    return row[starts], np.delete(row, starts)
