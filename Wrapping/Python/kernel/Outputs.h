// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results of tasks as Python objects.
#ifndef Outputs_h
#define Outputs_h

#include "dggOutput.h" // for Output

#include <pybind11/pybind11.h>

namespace dggPython
{
namespace py = pybind11;

/// Returns an empty types.SimpleNamespace.
py::object MakeNamespace();

/// Returns an output as a types.SimpleNamespace with the attributes points, cells, point_data,
/// cell_data, field_data, active, origins and warnings. The arrays take over the memory of the
/// output.
py::object ToPython(dgg::Output& output);
}

#endif
