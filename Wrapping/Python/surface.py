# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversions between vtkPolyData and NumPy arrays; copies and surfaces of VTK's data sets."""

import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from .errors import check, depth_of_package
from .mesh import Mesh

CELLS = ("Verts", "Lines", "Polys", "Strips")
DATA = ("PointData", "CellData", "FieldData")


def copy_surface(polydata):
    """Returns a copy of the surface with new points and cells. All other arrays are shared."""
    result = vtkPolyData()
    points = vtkPoints()
    if polydata.GetPoints():
        points.SetDataType(polydata.GetPoints().GetDataType())  # DeepCopy() does not change the type
        points.DeepCopy(polydata.GetPoints())
    result.SetPoints(points)
    for kind in CELLS:
        cells = vtkCellArray()
        cells.DeepCopy(getattr(polydata, f"Get{kind}")())
        getattr(result, f"Set{kind}")(cells)
    for kind in DATA:
        getattr(result, f"Get{kind}")().ShallowCopy(getattr(polydata, f"Get{kind}")())
    return result


def mesh_of(polydata):
    """Returns the vtkPolyData as a Mesh. Strips become triangles; texts are skipped."""
    if polydata.GetNumberOfStrips() > 0:
        triangulate = vtkTriangleFilter()
        triangulate.SetInputData(polydata)
        polydata = check(triangulate)
    points = polydata.GetPoints()
    data = polydata.GetPointData()
    mesh = Mesh(
        vtk_to_numpy(points.GetData()) if points else [],
        polygons=_ids_of(polydata.GetPolys()),
        lines=_ids_of(polydata.GetLines()),
        verts=_ids_of(polydata.GetVerts()),
        point_data=named_arrays(data),
        cell_data=named_arrays(polydata.GetCellData()),
        field_data=named_arrays(polydata.GetFieldData()),
    )
    mesh._is_single = points is not None and points.GetDataType() == VTK_FLOAT
    for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES):
        array = data.GetAbstractAttribute(kind)
        if array is not None:
            mesh._active[kind] = array.GetName()
    return mesh


def polydata_of(mesh):
    """Returns the Mesh as a new vtkPolyData. Without cells it gets verts, which renderers draw."""
    result = vtkPolyData()
    result.SetPoints(_points_of(mesh))
    result.SetVerts(cells_of(*mesh.verts))
    result.SetLines(cells_of(*mesh.lines))
    result.SetPolys(cells_of(*mesh.polygons))
    if result.GetNumberOfCells() == 0:
        ids = np.flatnonzero(np.isfinite(mesh.points).all(axis=1))
        result.SetVerts(cells_of(np.arange(len(ids) + 1), ids))
    for kind, arrays in zip(DATA, (mesh.point_data, mesh.cell_data, mesh.field_data)):
        data = getattr(result, f"Get{kind}")()
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.AddArray(array)
    for kind, name in {vtkDataSetAttributes.NORMALS: "Normals", **mesh._active}.items():
        result.GetPointData().SetActiveAttribute(name, kind)
    return result


def surface_of(data, name):
    """Returns the surface of a vtkPointSet as a vtkPolyData with the same points.

    A warning about volume cells begins with `name`.
    """
    ids = numpy_to_vtkIdTypeArray(np.arange(data.GetNumberOfPoints()), deep=True)
    ids.SetName("vtkdgg ids")  # PassThroughPointIds of VTK 9.1 is wrong on quadratic cells
    numbered = data.NewInstance()
    numbered.CopyStructure(data)
    numbered.GetPointData().AddArray(ids)
    numbered.GetCellData().ShallowCopy(data.GetCellData())
    extract = vtkDataSetSurfaceFilter()
    extract.SetInputData(numbered)
    found = check(extract)
    is_solid = any(data.GetCell(i).GetCellDimension() == 3 for i in _one_of_each_type(data))
    if is_solid:
        faces = found.GetNumberOfPolys() + found.GetNumberOfStrips()
        warnings.warn(
            f"{name} has volume cells: distances are measured on the surface of {faces} faces",
            RuntimeWarning,
            stacklevel=depth_of_package(),
        )
    result = vtkPolyData()
    result.SetPoints(data.GetPoints())
    ids = found.GetPointData().GetArray(ids.GetName())
    for kind in CELLS:
        offsets, corners = _ids_of(getattr(found, f"Get{kind}")())
        if len(corners):
            getattr(result, f"Set{kind}")(cells_of(offsets, vtk_to_numpy(ids)[corners]))
    result.GetPointData().ShallowCopy(data.GetPointData())
    result.GetCellData().ShallowCopy(found.GetCellData())
    result.GetFieldData().ShallowCopy(data.GetFieldData())
    return result


def named_arrays(data):
    """Returns the arrays of numbers that have a name, as NumPy arrays by name."""
    return {a.GetName(): vtk_to_numpy(a) for a in _numeric(data) if a.GetName()}


def cells_of(*arrays):
    """Returns a vtkCellArray of offsets and corners."""
    cells = vtkCellArray()
    cells.SetData(*(numpy_to_vtkIdTypeArray(ids.astype(np.int64), deep=True) for ids in arrays))
    return cells


def to_arrays(polydata):
    """Returns the surface as a dict that can be pickled, without arrays of texts and bits."""
    result = {"Points": vtk_to_numpy(polydata.GetPoints().GetData())}
    for kind in CELLS:
        result[kind] = _ids_of(getattr(polydata, f"Get{kind}")())
    for kind in DATA:
        result[kind] = [
            (array.GetName(), array.GetDataType(), vtk_to_numpy(array))
            for array in _numeric(getattr(polydata, f"Get{kind}")())
        ]
    return result


def from_arrays(arrays):
    """Returns the surface of a dict that to_arrays() returned. Arrays are copied."""
    result = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(arrays["Points"], deep=True))
    result.SetPoints(points)
    for kind in CELLS:
        getattr(result, f"Set{kind}")(cells_of(*arrays[kind]))
    for kind in DATA:
        for name, data_type, values in arrays[kind]:
            array = numpy_to_vtk(values, deep=True, array_type=data_type)
            array.SetName(name)
            getattr(result, f"Get{kind}")().AddArray(array)
    return result


def _points_of(mesh):
    """Returns vtkPoints: single precision for unchanged coordinates of a file that stores it."""
    values = mesh.points
    if mesh._is_single and (values.astype(np.float32) == values).all():
        values = values.astype(np.float32)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(values), deep=True))
    return points


def _ids_of(cells):
    """Returns offsets and corners of a vtkCellArray, without a copy."""
    return tuple(
        vtk_to_numpy(array) for array in (cells.GetOffsetsArray(), cells.GetConnectivityArray())
    )


def _numeric(data):
    """Returns the arrays of numbers, without those of bits."""
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return [a for a in arrays if a is not None and a.GetDataType() != VTK_BIT]


def _one_of_each_type(data):
    """Returns the id of one cell of each type."""
    if not hasattr(data, "GetCellTypesArray"):
        return [0] if data.GetNumberOfCells() else []
    if data.GetNumberOfCells() == 0:
        return []
    return np.unique(vtk_to_numpy(data.GetCellTypesArray()), return_index=True)[1].tolist()
