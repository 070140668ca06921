# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the kernel as vtkPolyData of the VTK that is loaded. This module imports VTK."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE,
    VTK_FLOAT,
    VTK_ID_TYPE,
    vtkAbstractArray,
    vtkDataArray,
    vtkIdList,
    vtkPoints,
    vtkTypeInt32Array,
    vtkTypeInt64Array,
)
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData

from .results import GRAPH_ARRAYS, WINDOW_ARRAYS, is_on_input, window_arrays
from .vtk_data import cells_of, shallow_copy, values_of

# Values of OutputPointsPrecision.
SINGLE_PRECISION, DOUBLE_PRECISION, DEFAULT_PRECISION = range(3)


def polydata_of_result(result, polydata, precision=DOUBLE_PRECISION):
    """Returns a result of the kernel as a new vtkPolyData, with the arrays that filters pass.

    Parameters
    ----------
    result : types.SimpleNamespace
        Points and cells, or arrays on the points and cells of the input.
    polydata : vtkPolyData
        The input, whose arrays are interpolated, copied or shared.
    precision : int
        Type of new points: 0 for floats, 1 for doubles, 2 for floats if those of the input are.

    Raises
    ------
    ValueError
        When coordinates are out of the range of floats.
    """
    if is_on_input(result):
        return with_result(result, polydata)
    output = vtkPolyData()
    output.GetFieldData().PassData(polydata.GetFieldData())
    remove_graph(output)
    remove_windows(output)
    output.SetPoints(_points(result.points, polydata.GetPoints(), precision))
    for name, kind in (("verts", "Verts"), ("lines", "Lines"), ("polygons", "Polys")):
        getattr(output, f"Set{kind}")(cells_of(*result.cells[name]))
    if result.origins:
        _interpolate(result.origins, polydata, output.GetPointData())
        if "cells" in result.origins:
            cells = polydata.GetCellData(), polydata.GetNumberOfCells()
            _copy(result.origins["cells"], *cells, output.GetCellData())
    add_result(result, output)
    return output


def with_result(result, polydata):
    """Returns a shallow copy of a vtkPolyData with the arrays of a result."""
    output = shallow_copy(polydata)
    add_result(result, output)
    return output


def add_result(result, polydata):
    """Adds the arrays of a result, which replace arrays of the same names."""
    for kind in ("Point", "Cell", "Field"):
        data = getattr(polydata, f"Get{kind}Data")()
        for name, values in getattr(result, f"{kind.lower()}_data").items():
            data.AddArray(vtk_array(values, name))
        active = result.active.get(f"{kind.lower()}s")
        if active:
            data.SetActiveScalars(active)  # SetScalars() would remove the scalars of the input


def remove_graph(polydata):
    """Removes the arrays of any graph from the field data."""
    for name in GRAPH_ARRAYS:
        polydata.GetFieldData().RemoveArray(name)


def remove_windows(polydata, distances=None):
    """Removes the windows of distances with this name from the field data; None for all windows."""
    data = polydata.GetFieldData()
    names = [data.GetArrayName(i) or "" for i in range(data.GetNumberOfArrays())]
    for name in window_arrays(names, distances):
        data.RemoveArray(name)


def vtk_array(values, name=None, is_stored=False):
    """Returns a copy of an array of the type that filters use for results, or for integers of
    graphs and windows. Memory is not shared, because shallow copies of an array by VTK do not keep
    NumPy's memory alive."""
    values = np.ascontiguousarray(values)
    is_stored |= name in GRAPH_ARRAYS or (name or "").endswith(WINDOW_ARRAYS)
    if is_stored and values.dtype.kind == "i":
        array = vtkTypeInt64Array() if values.itemsize == 8 else vtkTypeInt32Array()
        array.DeepCopy(numpy_to_vtk(values))
    else:
        data_type = VTK_ID_TYPE if values.dtype == np.int64 else None
        array = numpy_to_vtk(values, deep=True, array_type=data_type)
    if name is not None:
        array.SetName(name)
    return array


def vtk_array_like(array, rows, first=0, first_tuple=0, missing=np.nan):
    """Returns an array whose tuple i is the tuple `first_tuple + rows[i] - first` of another array;
    without such a tuple `missing` if it has floats, otherwise 0 or the empty string."""
    found = vtkAbstractArray.CreateArray(array.GetDataType())
    found.SetName(array.GetName())
    found.SetNumberOfComponents(array.GetNumberOfComponents())
    found.CopyComponentNames(array)
    found.SetNumberOfTuples(len(rows))
    if isinstance(found, vtkDataArray):
        found.Fill(missing if array.GetDataType() in (VTK_FLOAT, VTK_DOUBLE) else 0.0)
    rows = np.asarray(rows, dtype=np.int64)
    tuples = first_tuple + rows - first
    at = np.flatnonzero((rows >= first) & (tuples < array.GetNumberOfTuples()))
    found.InsertTuples(_ids(at), _ids(tuples[at]), array)
    return found


def pass_arrays(points, first, nearest, output):
    """Adds the point arrays of sources to an output, whose row i has the values of the point
    `nearest[i] - first`. Arrays of the output with the same names are kept."""
    if points is None:
        return
    # Ghost flags and identities describe the source, not the points nearest to it.
    skipped = (vtkDataSetAttributes.GhostArrayName(), "vtkOriginalPointIds", "Barycentric")
    data = points.GetPointData()
    for array in [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]:
        name = array.GetName()
        is_complete = array.GetNumberOfTuples() == points.GetNumberOfPoints()
        if name and name not in skipped and is_complete and not output.HasArray(name):
            output.AddArray(vtk_array_like(array, nearest, first))


def _points(coordinates, of_input, precision):
    """Returns vtkPoints of a precision. `of_input` may be None."""
    largest = np.abs(coordinates).max(initial=0.0)
    limits = np.finfo(np.float32)
    if precision == SINGLE_PRECISION and largest != 0 and not limits.tiny <= largest <= limits.max:
        raise ValueError(
            f"precision is single, but coordinates of up to {largest:.6g} are out of the range of "
            "floats. Use double precision"
        )
    if precision == DEFAULT_PRECISION and of_input is not None:
        precision = int(of_input.GetDataType() != VTK_FLOAT)
    if precision == SINGLE_PRECISION:
        with np.errstate(over="ignore", under="ignore"):
            coordinates = coordinates.astype(np.float32)
    points = vtkPoints()
    points.SetData(vtk_array(coordinates, "Points"))
    return points


def _of_size(data, tuples):
    """Returns attributes without arrays whose number of tuples is wrong."""
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    for i in reversed(range(copy.GetNumberOfArrays())):
        if copy.GetAbstractArray(i).GetNumberOfTuples() != tuples:
            copy.RemoveArray(i)
    return copy


def _ids(values):
    """Returns integers as a vtkIdList."""
    ids = vtkIdList()
    # A cell array fills the list without a loop in Python.
    cells_of(np.array([0, len(values)]), values).GetCellAtId(0, ids)
    return ids


def _copy(rows, data, tuples, output):
    """Copies tuples of point or cell data."""
    source = _of_size(data, tuples)
    output.CopyAllocate(source, len(rows))
    output.CopyData(source, _ids(rows), _ids(np.arange(len(rows))))


def _interpolate(origins, polydata, output):
    """Interpolates point data as VTK does, without a loop over points for arrays of numbers."""
    ids, weights = origins["points"], origins["weights"]
    source = _of_size(polydata.GetPointData(), polydata.GetNumberOfPoints())
    output.InterpolateAllocate(source, len(ids))
    output.CopyData(source, _ids(ids[:, 0]), _ids(np.arange(len(ids))))
    rows = np.flatnonzero(ids[:, 1] != -1)
    ids, weights = ids[rows], weights[rows]
    triple = _ids(np.zeros(3, dtype=int))
    # VTK skips arrays of ids and keeps the order of the others.
    arrays = (source.GetAbstractArray(i) for i in range(source.GetNumberOfArrays()))
    for i in range(output.GetNumberOfArrays()):
        target = output.GetAbstractArray(i)
        array = next(a for a in arrays if _kind(a) == _kind(target))
        values = values_of(array) if array.HasStandardMemoryLayout() else None
        if values is None:
            for row, corners, factors in zip(rows.tolist(), ids.tolist(), weights.tolist()):
                for k in range(3):
                    triple.SetId(k, corners[k])
                target.InterpolateTuple(row, triple, array, factors)
        else:
            limits = array.GetDataTypeMin(), array.GetDataTypeMax()
            values_of(target)[rows] = _interpolated(values, ids, weights, limits)


def _kind(array):
    """Returns the name and the type of an array."""
    return array.GetName(), array.GetDataType()


def _interpolated(values, ids, weights, limits):
    """Returns weighted sums of three rows each, rounded like those of VTK."""
    weights = weights.reshape(len(ids), 3, *[1] * (values.ndim - 1))
    sums = np.zeros((len(ids), *values.shape[1:]))
    with np.errstate(all="ignore"):
        for k in range(3):
            sums += weights[:, k] * values[ids[:, k]].astype(np.float64)
        if values.dtype != np.float64:
            sums = np.clip(sums, *limits)
        if values.dtype.kind != "f":
            sums = np.trunc(np.where(sums >= 0, sums + 0.5, sums - 0.5))
        return sums.astype(values.dtype)
