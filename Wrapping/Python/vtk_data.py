# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversions between vtkPolyData and NumPy arrays; copies and surfaces of VTK's data sets. This
module imports VTK."""

import warnings

import numpy as np
from vtkmodules.util.numpy_support import (
    get_vtk_to_numpy_typemap,
    numpy_to_vtk,
    numpy_to_vtkIdTypeArray,
    vtk_to_numpy,
)
from vtkmodules.vtkCommonCore import VTK_BIT, reference, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_CONVEX_POINT_SET,
    VTK_LAGRANGE_HEXAHEDRON,
    VTK_NUMBER_OF_CELL_TYPES,
    vtkCellArray,
    vtkDataSetAttributes,
    vtkGenericCell,
    vtkPolyData,
    vtkStaticCellLocator,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from .checks import counted
from .data_set import POLYHEDRON, DataSet
from .errors import depth_of_package
from .mesh import checked_cells
from .pipeline import check

CELLS = ("Verts", "Lines", "Polys", "Strips")
DATA = ("PointData", "CellData", "FieldData")
# Minimum number of corners of cell types that can have more.
_MINIMUM_SIZES = {2: 1, 4: 2, 6: 3, 7: 3, 36: 6, POLYHEDRON: 4}
# Number of corners of Lagrange and Bézier cells with n points along each edge.
_SIZES_BY_ORDER = {
    kind: size
    for kinds, size in (
        ((68, 75), lambda n: n),
        ((69, 76), lambda n: n * (n + 1) // 2),
        ((70, 77), lambda n: n * n),
        ((71, 78), lambda n: n * (n + 1) * (n + 2) // 6),
        ((72, 79), lambda n: n**3),
        ((73, 80), lambda n: n * n * (n + 1) // 2),
    )
    for kind in kinds
}


def configured(target, **properties):
    """Sets properties of a VTK object, and returns the object. A list is several arguments."""
    for name, value in properties.items():
        getattr(target, f"Set{name}")(*value if isinstance(value, list) else [value])
    return target


def copy_surface(polydata):
    """Returns a copy of the surface with new points and cells. All other arrays are shared."""
    result = vtkPolyData()
    points = vtkPoints()
    if polydata.GetPoints():
        # DeepCopy() does not change the type.
        points.SetDataType(polydata.GetPoints().GetDataType())
        points.DeepCopy(polydata.GetPoints())
    result.SetPoints(points)
    for kind in CELLS:
        cells = vtkCellArray()
        cells.DeepCopy(getattr(polydata, f"Get{kind}")())
        getattr(result, f"Set{kind}")(cells)
    for kind in DATA:
        getattr(result, f"Get{kind}")().ShallowCopy(getattr(polydata, f"Get{kind}")())
    return result


def vtk_points(values):
    """Returns a copy of coordinates as vtkPoints of the same precision."""
    return configured(vtkPoints(), Data=numpy_to_vtk(np.ascontiguousarray(values), deep=True))


def shallow_copy(polydata):
    """Returns a new vtkPolyData that shares all points, cells and arrays."""
    result = vtkPolyData()
    result.ShallowCopy(polydata)
    return result


def structure_of(polydata):
    """Returns a new vtkPolyData that shares points and cells, without arrays."""
    result = vtkPolyData()
    result.CopyStructure(polydata)
    return result


def with_arrays(polydata, arrays):
    """Returns a shallow copy with further point arrays, of which the first is active."""
    result = shallow_copy(polydata)
    for name, values in arrays.items():
        add_array(result.GetPointData(), name, values)
    result.GetPointData().SetActiveScalars(next(iter(arrays)))
    return result


def coordinates_of(polydata):
    """Returns the coordinates of all points as float64, shape (n, 3)."""
    return vtk_to_numpy(polydata.GetPoints().GetData()).astype(float)


def triangles_of(polydata):
    """Returns the point ids of the corners, shape (m, 3), of a surface of triangles."""
    return vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def area_vectors(polydata):
    """Returns the normals of all triangles, whose lengths are the areas, shape (m, 3)."""
    a, b, c = coordinates_of(polydata)[triangles_of(polydata)].swapaxes(0, 1)
    return 0.5 * np.cross(b - a, c - a)


def triangulated(contents, path):
    """Returns the triangles; polygons and strips are triangulated, lines and vertices removed."""
    triangulate = configured(vtkTriangleFilter(), InputData=contents, PassLines=False)
    mesh = check(configured(triangulate, PassVerts=False))
    if mesh.GetNumberOfPolys() == 0:
        raise ValueError(f"{path}: contains no surface")
    return mesh


def locator_of(polydata):
    """Returns a locator of the cells."""
    locator = configured(vtkStaticCellLocator(), DataSet=polydata)
    locator.BuildLocator()
    return locator


def closest_cell(locator, position):
    """Returns the closest position on a surface, and the corners of the cell that contains it."""
    closest, cell, sub, squared = [0.0] * 3, reference(0), reference(0), reference(0.0)
    locator.FindClosestPoint(position, closest, cell, sub, squared)
    ids = locator.GetDataSet().GetCell(cell.get()).GetPointIds()
    return np.array(closest), [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def data_set_of(polydata):
    """Returns the contents of a vtkPolyData. Points and cells are copied; texts are skipped."""
    data = DataSet("POLYDATA")
    if polydata.GetPoints():
        data.points = np.array(vtk_to_numpy(polydata.GetPoints().GetData()))
    for name, kind in zip(data.cells, CELLS):
        data.cells[name] = tuple(map(np.array, ids_of(getattr(polydata, f"Get{kind}")())))
    data.point_data = named_arrays(polydata.GetPointData())
    data.cell_data = named_arrays(polydata.GetCellData())
    data.field_data = named_arrays(polydata.GetFieldData())
    for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES):
        array = polydata.GetPointData().GetAbstractAttribute(kind)
        if array is not None:
            data.active[kind] = array.GetName()
    return data


def grid_of(data):
    """Returns a DataSet of an unstructured or structured grid as a vtkPointSet.

    Inconsistent cells, with which VTK ends the process, are an error.
    """
    if data.kind == "STRUCTURED_GRID":
        if np.prod(data.dimensions, dtype=object) != len(data.points):
            raise ValueError(
                f"dimensions {data.dimensions} contradict {counted(len(data.points), 'point')}"
            )
        grid = configured(vtkStructuredGrid(), Dimensions=data.dimensions)
    else:
        grid = vtkUnstructuredGrid()
        _add_cells(grid, data)
    grid.SetPoints(vtk_points(data.points))
    _add_arrays(grid, data, data.active)
    return grid


def polydata_of(data):
    """Returns a DataSet of the kind POLYDATA as a new vtkPolyData. Without cells it gets verts,
    which renderers draw."""
    values = data.stored_points()
    result = configured(vtkPolyData(), Points=vtk_points(values))
    configured(result, **{kind: cells_of(*data.cells[name]) for name, kind in zip(data.cells, CELLS)})
    if result.GetNumberOfCells() == 0:
        ids = np.flatnonzero(np.isfinite(values).all(axis=1))
        result.SetVerts(cells_of(np.arange(len(ids) + 1), ids))
    _add_arrays(result, data, {vtkDataSetAttributes.NORMALS: "Normals", **data.active})
    return result


def points_polydata(points):
    """Returns checked coordinates as points without cells."""
    return configured(vtkPolyData(), Points=vtk_points(points))


def polyline(points):
    """Returns coordinates as points with one line through all of them."""
    line = cells_of(np.array([0, len(points)]), np.arange(len(points)))
    return configured(points_polydata(points), Lines=line)


def surface_of(data, name):
    """Returns the surface of a vtkPointSet as a vtkPolyData with the same points.

    A warning about volume cells begins with `name`.
    """
    if data.GetNumberOfCells() == 0:
        result = configured(vtkPolyData(), Points=data.GetPoints())
        result.GetPointData().ShallowCopy(data.GetPointData())
        result.GetFieldData().ShallowCopy(data.GetFieldData())
        return result
    dimension = 0
    for i in _one_of_each_type(data):
        cell = data.GetCell(i)
        dimension = max(dimension, cell.GetCellDimension())
        if cell.GetClassName().startswith("vtkBezier"):
            raise ValueError(
                f"cell {i} is a {cell.GetClassName()}, whose surface does not contain its points; "
                "expected linear, quadratic or Lagrange cells"
            )
    name_of_ids = "vtkdgg ids"  # PassThroughPointIds of VTK 9.1 is wrong on quadratic cells
    numbered = data.NewInstance()
    numbered.CopyStructure(data)
    add_array(numbered.GetPointData(), name_of_ids, np.arange(data.GetNumberOfPoints()))
    numbered.GetCellData().ShallowCopy(data.GetCellData())
    found = check(configured(vtkDataSetSurfaceFilter(), InputData=numbered))
    if dimension == 3:
        faces = found.GetNumberOfPolys() + found.GetNumberOfStrips()
        warnings.warn(
            f"{name} has volume cells: distances are measured on the surface of {faces} faces",
            RuntimeWarning,
            stacklevel=depth_of_package(),
        )
    result = configured(vtkPolyData(), Points=data.GetPoints())
    ids = found.GetPointData().GetArray(name_of_ids)
    for kind in CELLS:
        offsets, corners = ids_of(getattr(found, f"Get{kind}")())
        if len(corners):
            getattr(result, f"Set{kind}")(cells_of(offsets, vtk_to_numpy(ids)[corners]))
    result.GetPointData().ShallowCopy(data.GetPointData())
    result.GetCellData().ShallowCopy(found.GetCellData())
    result.GetFieldData().ShallowCopy(data.GetFieldData())
    return result


def add_array(data, name, values, is_shared=False):
    """Adds a copy of an array to point, cell or field data, or an array that shares its memory and
    keeps it alive."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=not is_shared)
    array.SetName(name)
    data.AddArray(array)


def named_arrays(data):
    """Returns the arrays of numbers that have a name, as NumPy arrays by name."""
    arrays = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    found = {array.GetName(): values_of(array) for array in arrays if array.GetName()}
    return {name: values for name, values in found.items() if values is not None}


def values_of(array):
    """Returns the numbers of a VTK array, without a copy where possible; None for other arrays, of
    texts or bits, and if the array is None."""
    types = get_vtk_to_numpy_typemap()
    is_number = array is not None and array.GetDataType() in types
    return vtk_to_numpy(array) if is_number and array.GetDataType() != VTK_BIT else None


def ids_of(cells):
    """Returns offsets and point ids of a vtkCellArray, without a copy."""
    return values_of(cells.GetOffsetsArray()), values_of(cells.GetConnectivityArray())


def cells_of(*arrays):
    """Returns a vtkCellArray of offsets and corners."""
    cells = vtkCellArray()
    cells.SetData(*(numpy_to_vtkIdTypeArray(ids.astype(np.int64), deep=True) for ids in arrays))
    return cells


def _add_cells(grid, data):
    """Checks the cells of a DataSet and adds them to a vtkUnstructuredGrid."""
    offsets, corners = checked_cells(data.cells["cells"], "cells", len(data.points))
    sizes = np.diff(offsets)
    if len(sizes) != len(data.types):
        cells, types = counted(len(sizes), "cell"), counted(len(data.types), "cell type")
        raise ValueError(f"expected one type per cell, got {cells} and {types}")
    for kind in np.unique(data.types).tolist():
        for size in np.unique(sizes[data.types == kind]).tolist():
            if not _is_size(kind, size):
                raise ValueError(f"cells of type {kind} with {size} corners have no surface")
    if data.is_of_vtk_8:
        _reorder(data.types, offsets, corners)
    if POLYHEDRON not in data.types:
        types = numpy_to_vtk(data.types.astype(np.uint8), deep=True)
        grid.SetCells(types, cells_of(offsets, corners))
        return
    for i, kind in enumerate(data.types.tolist()):
        row = corners[offsets[i] : offsets[i + 1]].tolist()
        if kind == POLYHEDRON:
            row = [len(data.faces[i])]
            for face in data.faces[i]:
                row += [len(face), *face.tolist()]
        ids = vtkIdList()
        for k in row:
            ids.InsertNextId(k)
        grid.InsertNextCell(kind, ids)


def _reorder(types, offsets, corners):
    """Swaps the nodes on the last two edges of Lagrange hexahedra, as VTK 9 does."""
    for i in np.flatnonzero((types == VTK_LAGRANGE_HEXAHEDRON) & (np.diff(offsets) > 8)):
        count = round((offsets[i + 1] - offsets[i]) ** (1 / 3)) - 2  # nodes inside an edge
        first = offsets[i] + 8 + 10 * count
        nodes = corners[first : first + 2 * count]
        nodes[:] = np.roll(nodes, count)


def _add_arrays(result, mesh, active):
    """Adds the arrays of a Mesh or DataSet to a vtkDataSet. `active` has names of point arrays by
    attribute type; those with a wrong number of components do not become active."""
    for kind, arrays in zip(DATA, (mesh.point_data, mesh.cell_data, mesh.field_data)):
        data = getattr(result, f"Get{kind}")()
        for name, values in arrays.items():
            add_array(data, name, values)
    data = result.GetPointData()
    silence = data.AddObserver("WarningEvent", lambda *_: None)
    for kind, name in active.items():
        data.SetActiveAttribute(name, kind)
    data.RemoveObserver(silence)


def _is_size(kind, size):
    """Returns true if cells of a type of VTK can have this number of corners."""
    if kind in _MINIMUM_SIZES:
        return size >= _MINIMUM_SIZES[kind]
    if kind in _SIZES_BY_ORDER:
        return any(_SIZES_BY_ORDER[kind](n) == size for n in range(2, 12))
    cell = vtkGenericCell.InstantiateCell(kind) if 0 <= kind < VTK_NUMBER_OF_CELL_TYPES else None
    return cell is not None and kind != VTK_CONVEX_POINT_SET and size == cell.GetNumberOfPoints()


def _one_of_each_type(data):
    """Returns the id of one cell of each type."""
    if not hasattr(data, "GetCellTypesArray"):
        return [0] if data.GetNumberOfCells() else []
    if data.GetNumberOfCells() == 0:
        return []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of VTK 9.7, without a successor in 9.1
        types = vtk_to_numpy(data.GetCellTypesArray())
    return np.unique(types, return_index=True)[1].tolist()
