# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What commands print and write."""

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .words import notes_of


def with_arrays(data, arrays):
    """The data with these arrays at its points besides its own, coloured by the first."""
    result = vtkPolyData()
    result.ShallowCopy(data)
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    result.GetPointData().SetActiveScalars(next(iter(arrays)))
    return result


def print_table(rows, notes, warnings):
    """Print the rows; then the notes and the warnings of filters, each once."""
    for key, value in rows:
        print(f"{key:<12} {value}")
    for note in [*notes, *notes_of(warnings)]:
        print(f"{'note':<12} {note}")
