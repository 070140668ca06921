# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other packages, and their conversion to `Surface`.

Points and cells are copied, so that changes made afterwards, even by another thread, do not affect
what is computed. VTK is imported for objects of VTK only, and for volume cells.
"""

import os

import numpy as np

from . import arguments
from .data_set import DataSet
from .errors import needing_vtk
from .mesh import Mesh
from .reading import read
from .surface import Surface

# Attributes of points and cells; the first pair that an object has is used.
LAYOUTS = (
    ("vertex.positions", "triangle.indices"),  # Open3D, tensor meshes
    ("point.positions", None),  # Open3D, tensor clouds
    ("vertices", "faces"),  # trimesh
    ("vertices", "triangles"),  # Open3D
    ("coordinates", "faces"),  # nilearn
    ("points", "faces"),
    ("points", "cells"),  # meshio
    ("points", None),
    ("vertices", None),
)


# Names of meshio for cells of two and three dimensions, and their numbers in VTK.
CELL_TYPES = {
    "triangle": 5,
    "triangle6": 22,
    "quad": 9,
    "quad8": 23,
    "polygon": 7,
    "tetra": 10,
    "tetra10": 24,
    "pyramid": 14,
    "wedge": 13,
    "hexahedron": 12,
    "hexahedron20": 25,
}
# Names of cells that are polygons.
_FLAT = ("triangle", "quad", "polygon")


def take(mesh, cells=None, optional=(), **named):
    """Returns the mesh as a `Surface`, and the arguments that follow it.

    The mesh is one object, or an array of points with `cells`. With one object `cells` is the first
    of the arguments that follow. A missing argument is None, and an error unless its name is in
    `optional`.
    """
    others = list(named.values())
    found = opened(mesh)
    if found is None:
        points = arguments.coordinates(mesh, "points", is_finite=False)
        try:
            if cells is None:
                raise ValueError("triangles: missing, and the points have no cells")
            surface = from_arrays(points, cells)
        except ValueError as error:
            # Calls with points and sources alone may refer to a cloud.
            if cells is not None and all(other is not None for other in others):
                raise
            raise ValueError(
                f"{error}; use vtkdgg.CloudGraph for points without triangles"
            ) from None
    else:
        if cells is not None:
            missing = [i for i, other in enumerate(others) if other is None]
            if not missing:
                raise ValueError("triangles: given, but the mesh has cells of its own")
            del others[missing[0]]
            others.insert(0, cells)
        surface = _surface(found)
    for name, other in zip(named, others):
        if other is None and name not in optional:
            raise ValueError(f"{name}: missing")
    return surface, others


def opened(mesh):
    """Returns a Mesh, a vtkDataObject or a pair (points, cells); None for an array of points."""
    if isinstance(mesh, Mesh) or is_vtk(mesh):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        return read(mesh)
    if isinstance(mesh, np.ndarray):
        return None
    if isinstance(mesh, (list, tuple)):
        return tuple(mesh) if len(mesh) == 2 and _is_table(mesh[0]) else None
    if hasattr(mesh, "neighborhood"):
        name = type(mesh).__name__
        raise ValueError(f"points: expected a mesh, got a vtkdgg.{name}; call a method of the graph")
    if hasattr(mesh, "to_mesh"):  # a scene of trimesh
        return opened(mesh.to_mesh())
    if is_vtk(getattr(mesh, "dataset", None)):  # vedo
        return mesh.dataset
    for layout in LAYOUTS:
        points, cells = (None if path is None else _attribute(mesh, path) for path in layout)
        if points is not None and (cells is not None or layout[1] is None):
            if isinstance(cells, list) and cells and hasattr(cells[0], "type"):
                return _grid(points, cells)
            return points, [] if cells is None else cells
    if np.asarray(mesh).dtype == object:
        known = "; ".join(" and ".join(filter(None, layout)) for layout in LAYOUTS)
        raise ValueError(
            f"points: expected coordinates, a file name or a mesh, got an object of type "
            f"{type(mesh).__name__} without any of these sets of attributes: {known}"
        )
    return None


def is_vtk(mesh, kind="vtkDataObject"):
    """Returns true for an object of a class of VTK, whatever VTK it comes from."""
    return hasattr(mesh, "IsA") and bool(mesh.IsA(kind))


def _is_table(points):
    """Returns true for a sequence of points, which may be empty."""
    return np.ndim(points) == 2 or np.ndim(points) == 1 and len(points) == 0


def cloud_of(mesh, name="points"):
    """Returns a cloud as a `Surface`, with the arrays of a vtkPolyData or Mesh."""
    found = opened(mesh)
    if isinstance(found, Mesh) or is_vtk(found, "vtkPolyData"):
        return _surface(found)
    return Surface.of_points(points_of(mesh if found is None else found, name))


def points_of(mesh, name="points"):
    """Returns the coordinates of a mesh, cloud or array, shape (n, 3)."""
    found = opened(mesh)
    if is_vtk(found):
        from . import vtk_data

        if not hasattr(found, "GetPoints"):
            raise ValueError(f"{name}: a {found.GetClassName()} has no points")
        found = vtk_data.coordinates_of(found) if found.GetPoints() else []
    elif isinstance(found, Mesh):
        found = found.points
    elif found is not None:
        found = found[0]
    return arguments.coordinates(mesh if found is None else found, name, is_finite=False)


def from_arrays(points, cells):
    """Returns a `Surface` of points and polygons. Points of polygons must be finite."""
    mesh = Mesh(points, cells)
    offsets, corners = mesh.polygons
    bad = np.flatnonzero(~np.isfinite(mesh.points[corners]).all(axis=1))
    if len(bad):
        polygon = int(np.searchsorted(offsets, bad[0], side="right")) - 1
        row = int(corners[bad[0]])
        raise ValueError(
            f"points: row {row} is not finite: {mesh.points[row]}; polygon {polygon} uses it"
        )
    return Surface.of(mesh)


def _surface(found):
    """Returns a `Surface` for a result of opened()."""
    if isinstance(found, Mesh):
        return Surface.of(found)
    if isinstance(found, tuple):
        return from_arrays(*found)
    if is_vtk(found, "vtkPointSet"):
        from . import vtk_data

        is_surface = is_vtk(found, "vtkPolyData")
        polydata = found if is_surface else vtk_data.surface_of(found, "The mesh")
        return Surface(vtk_data.data_set_of(polydata), vtk_data.shallow_copy(polydata))
    remedy = "vtkDataSetSurfaceFilter extracts one"
    if is_vtk(found, "vtkCompositeDataSet"):
        remedy = "pass one block, or merge all blocks by vtkCompositeDataGeometryFilter"
    raise ValueError(f"points: expected a surface, got a {found.GetClassName()}; {remedy}")


def _attribute(mesh, path):
    """Returns the attribute at a dotted path, None if it is missing. Tensors become arrays."""
    for name in path.split("."):
        try:
            mesh = getattr(mesh, name)
        except (AttributeError, KeyError):  # Open3D raises the latter
            return None
    return mesh.numpy() if hasattr(mesh, "numpy") else mesh


def _grid(points, blocks):
    """Returns the blocks of meshio, of which each has cells of one type, as a Mesh of polygons or a
    vtkUnstructuredGrid. Points and lines are skipped."""
    points = arguments.coordinates(points, "points", is_finite=False)
    types, sizes, corners = [], [], []
    is_flat = True
    for block in blocks:
        if block.type in ("vertex", "line"):
            continue
        kind = "polygon" if block.type.startswith("polygon") else block.type
        if kind not in CELL_TYPES:
            known = ", ".join(CELL_TYPES)
            raise ValueError(f"triangles: expected cells of {known}, got {block.type!r}")
        is_flat = is_flat and kind in _FLAT
        ids = arguments.numbers(block.data, "triangles", "integer")
        types.append(np.full(len(ids), CELL_TYPES[kind]))
        sizes.append(np.full(len(ids), ids.shape[1]))
        corners.append(ids.ravel())
    if is_flat:
        offsets = np.cumsum(np.concatenate([[0], *sizes]).astype(np.int64))
        return Mesh(points, polygons=(offsets, np.concatenate([[], *corners]).astype(np.int64)))
    with needing_vtk("a mesh of other cells than triangles, quads and polygons"):
        from . import vtk_data

    result = DataSet("UNSTRUCTURED_GRID")
    result.points = points
    result.types = np.concatenate(types)
    offsets = np.cumsum(np.concatenate([[0], *sizes]))
    result.cells["cells"] = offsets, np.concatenate(corners)
    return vtk_data.grid_of(result)
