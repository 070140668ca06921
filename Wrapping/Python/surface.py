# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of a vtkPolyData, and its way into numpy arrays and back."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

CELLS = ("Verts", "Lines", "Polys", "Strips")
DATA = ("PointData", "CellData", "FieldData")


def copy_surface(polydata):
    """The surface with points and cells of its own. Arrays of all other data are shared."""
    result = vtkPolyData()
    points = vtkPoints()
    if polydata.GetPoints():
        points.SetDataType(polydata.GetPoints().GetDataType())  # which DeepCopy() leaves as it is
        points.DeepCopy(polydata.GetPoints())
    result.SetPoints(points)
    for kind in CELLS:
        cells = vtkCellArray()
        cells.DeepCopy(getattr(polydata, f"Get{kind}")())
        getattr(result, f"Set{kind}")(cells)
    for kind in DATA:
        getattr(result, f"Get{kind}")().ShallowCopy(getattr(polydata, f"Get{kind}")())
    return result


def to_arrays(polydata):
    """The surface as a dict of what pickle knows. Arrays of text and of bits are left out."""
    result = {"Points": vtk_to_numpy(polydata.GetPoints().GetData())}
    for kind in CELLS:
        cells = getattr(polydata, f"Get{kind}")()
        result[kind] = tuple(
            vtk_to_numpy(array) for array in (cells.GetOffsetsArray(), cells.GetConnectivityArray())
        )
    for kind in DATA:
        data = getattr(polydata, f"Get{kind}")()
        arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
        result[kind] = [
            (array.GetName(), array.GetDataType(), vtk_to_numpy(array))
            for array in arrays
            if array is not None and array.GetDataType() != VTK_BIT
        ]
    return result


def from_arrays(arrays):
    """The surface that to_arrays() has taken apart. It shares nothing with the arrays."""
    result = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(arrays["Points"], deep=True))
    result.SetPoints(points)
    for kind in CELLS:
        cells = vtkCellArray()
        cells.SetData(
            *(numpy_to_vtkIdTypeArray(ids.astype(np.int64), deep=True) for ids in arrays[kind])
        )
        getattr(result, f"Set{kind}")(cells)
    for kind in DATA:
        for name, data_type, values in arrays[kind]:
            array = numpy_to_vtk(values, deep=True, array_type=data_type)
            array.SetName(name)
            getattr(result, f"Get{kind}")().AddArray(array)
    return result
