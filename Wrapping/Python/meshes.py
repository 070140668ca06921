# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other packages, and their conversion to vtkPolyData.

Points and cells are copied, so that changes made afterwards, even by another thread, do not affect
what is computed.
"""

import os

import numpy as np
from vtkmodules import vtkCommonDataModel as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkPointSet,
    vtkPolyData,
)

from . import arguments
from .data_set import DataSet
from .mesh import Mesh
from .reading import read
from .surface import copy_surface, grid_of, surface_of

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


# Names of meshio and types of VTK for cells of two and three dimensions.
CELL_TYPES = {
    "triangle": vtk.VTK_TRIANGLE,
    "triangle6": vtk.VTK_QUADRATIC_TRIANGLE,
    "quad": vtk.VTK_QUAD,
    "quad8": vtk.VTK_QUADRATIC_QUAD,
    "polygon": vtk.VTK_POLYGON,
    "tetra": vtk.VTK_TETRA,
    "tetra10": vtk.VTK_QUADRATIC_TETRA,
    "pyramid": vtk.VTK_PYRAMID,
    "wedge": vtk.VTK_WEDGE,
    "hexahedron": vtk.VTK_HEXAHEDRON,
    "hexahedron20": vtk.VTK_QUADRATIC_HEXAHEDRON,
}


def take(mesh, cells=None, **named):
    """Returns the surface as a new vtkPolyData, and the arguments that follow the mesh.

    The mesh is one object, or an array of points with `cells`. With one object `cells` is the first
    of the arguments that follow. A missing argument is None.
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
        if other is None:
            raise ValueError(f"{name}: missing")
    return surface, others


def opened(mesh):
    """Returns a Mesh, a vtkDataObject or a pair (points, cells); None for an array of points."""
    if isinstance(mesh, (Mesh, vtkDataObject)):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        return read(mesh)
    if isinstance(mesh, np.ndarray):
        return None
    if isinstance(mesh, (list, tuple)):
        return tuple(mesh) if len(mesh) == 2 and _is_table(mesh[0]) else None
    if hasattr(mesh, "to_mesh"):  # a scene of trimesh
        return opened(mesh.to_mesh())
    if isinstance(getattr(mesh, "dataset", None), vtkDataObject):  # vedo
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


def _is_table(points):
    """Returns true for a sequence of points, which may be empty."""
    return np.ndim(points) == 2 or np.ndim(points) == 1 and len(points) == 0


def cloud_of(mesh, name="points"):
    """Returns a new vtkPolyData of a cloud, with the arrays of a vtkPolyData or Mesh."""
    found = opened(mesh)
    if isinstance(found, vtkPolyData):
        return copy_surface(found)
    if isinstance(found, Mesh):
        return found.as_polydata()
    return arguments.polydata(points_of(mesh if found is None else found, name))


def points_of(mesh, name="points"):
    """Returns the coordinates of a mesh, cloud or array, shape (n, 3)."""
    found = opened(mesh)
    if isinstance(found, vtkDataObject):
        if not hasattr(found, "GetPoints"):
            raise ValueError(f"{name}: a {found.GetClassName()} has no points")
        found = vtk_to_numpy(found.GetPoints().GetData()) if found.GetPoints() else []
    elif isinstance(found, Mesh):
        found = found.points
    elif found is not None:
        found = found[0]
    return arguments.coordinates(mesh if found is None else found, name, is_finite=False)


def from_arrays(points, cells):
    """Returns a new vtkPolyData of points and polygons. Points of polygons must be finite."""
    mesh = Mesh(points, cells)
    offsets, corners = mesh.polygons
    bad = np.flatnonzero(~np.isfinite(mesh.points[corners]).all(axis=1))
    if len(bad):
        polygon = int(np.searchsorted(offsets, bad[0], side="right")) - 1
        row = int(corners[bad[0]])
        raise ValueError(
            f"points: row {row} is not finite: {mesh.points[row]}; polygon {polygon} uses it"
        )
    return mesh.as_polydata()


def _surface(found):
    """Returns a new vtkPolyData for a result of opened()."""
    if isinstance(found, Mesh):
        return found.as_polydata()
    if isinstance(found, tuple):
        return from_arrays(*found)
    if isinstance(found, vtkPolyData):
        return copy_surface(found)
    if isinstance(found, vtkPointSet):
        return copy_surface(surface_of(found, "The mesh"))
    remedy = "vtkDataSetSurfaceFilter extracts one"
    if isinstance(found, vtkCompositeDataSet):
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
    """Returns a vtkUnstructuredGrid of the blocks of meshio, of which each has cells of one type.
    Points and lines are skipped."""
    points = arguments.coordinates(points, "points", is_finite=False)
    types, sizes, corners = [], [], []
    for block in blocks:
        if block.type in ("vertex", "line"):
            continue
        kind = "polygon" if block.type.startswith("polygon") else block.type
        if kind not in CELL_TYPES:
            known = ", ".join(CELL_TYPES)
            raise ValueError(f"triangles: expected cells of {known}, got {block.type!r}")
        ids = arguments.numbers(block.data, "triangles", "integer")
        types.append(np.full(len(ids), CELL_TYPES[kind]))
        sizes.append(np.full(len(ids), ids.shape[1]))
        corners.append(ids.ravel())
    result = DataSet("UNSTRUCTURED_GRID")
    result.points = points
    if types:
        result.types = np.concatenate(types)
        offsets = np.cumsum(np.concatenate([[0], *sizes]))
        result.cells["cells"] = offsets, np.concatenate(corners)
    return grid_of(result)
