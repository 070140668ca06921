# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects of the VTK that is loaded as arguments of the kernel. This module imports VTK."""

import numpy as np

from .results import GRAPH_ARRAYS, WINDOW_ARRAYS
from .vtk_data import ids_of, values_of


def surface_arguments(polydata):
    """Returns the arguments for a Surface of the kernel as a dict."""
    arguments = {"points": values_of(polydata.GetPoints().GetData())}
    if polydata.GetNumberOfPolys():
        arguments["cells"] = ids_of(polydata.GetPolys())
    if polydata.GetNumberOfStrips():
        arguments["strips"] = ids_of(polydata.GetStrips())
    arguments["first_cell"] = polydata.GetNumberOfVerts() + polydata.GetNumberOfLines()
    return arguments


def surface_points(polydata, port, ids=(), rows=slice(None)):
    """Returns ids and the points of an input port, which may be None, as surface points.

    `rows` selects points of the port. The arrays vtkOriginalPointIds, or FaceId and Barycentric,
    identify points of the surface.
    """
    points = {"ids": np.array(ids, dtype=np.int64)}
    if polydata is None or polydata.GetNumberOfPoints() == 0:
        return points
    points["points"] = values_of(polydata.GetPoints().GetData())[rows]
    data = polydata.GetPointData()
    for key, name, columns in (
        ("original_ids", "vtkOriginalPointIds", 1),
        ("cells", "FaceId", 1),
        ("barycentric", "Barycentric", 3),
    ):
        array = data.GetArray(name)
        values = values_of(array)
        sizes = (polydata.GetNumberOfPoints(), columns)
        if values is not None and sizes == (len(values), array.GetNumberOfComponents()):
            points[key] = values[rows]
    has_both = data.HasArray("FaceId") and data.HasArray("Barycentric")
    if "original_ids" not in points and has_both and not {"cells", "barycentric"} <= set(points):
        raise ValueError(
            f"The point arrays FaceId and Barycentric of input port {port} are not numeric with 1 "
            "and 3 components and one tuple per point. Correct the arrays, or remove Barycentric"
        )
    return points


def graph_arrays(polydata):
    """Returns the VTK arrays of a graph in the field data by name."""
    data = polydata.GetFieldData()
    found = {name: data.GetAbstractArray(name) for name in GRAPH_ARRAYS}
    return {name: array for name, array in found.items() if array is not None}


def read_only(arrays):
    """Returns VTK arrays by name as read-only views, which a Graph of the kernel does not copy."""
    found = {}
    for name, array in arrays.items():
        values = values_of(array)
        if values is not None:
            found[name] = values.view()
            found[name].flags.writeable = False
    return found


def windows_of(polydata, distances):
    """Returns the windows of distances with this name in the field data by name."""
    data = polydata.GetFieldData()
    found = {f"{distances}{s}": data.GetAbstractArray(f"{distances}{s}") for s in WINDOW_ARRAYS}
    return {k: values_of(a) for k, a in found.items() if values_of(a) is not None}


def numbers(data, name, where, is_required=True):
    """Returns the array of numbers with this name; None if the name is empty."""
    array = data.GetAbstractArray(name) if data is not None and name else None
    if name and is_required and values_of(array) is None:
        raise ValueError(
            f"There is no point array '{name}' on {where}. Use the name of an array of numbers"
        )
    return values_of(array)
