# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Output of commands: arrays, files and tables."""

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..surface import add_array
from .words import notes_of


def with_arrays(data, arrays):
    """Returns the data with further point arrays, of which the first is active."""
    result = vtkPolyData()
    result.ShallowCopy(data)
    for name, values in arrays.items():
        add_array(result.GetPointData(), name, values)
    result.GetPointData().SetActiveScalars(next(iter(arrays)))
    return result


def print_table(rows, notes, warnings):
    """Prints rows, then notes and the warnings of filters, each once."""
    width = max([12, *(len(key) for key, _ in rows)])
    for key, value in rows:
        print(f"{key:<{width}} {value}")
    for note in [*notes, *notes_of(warnings)]:
        print(f"{'note':<{width}} {note}")
