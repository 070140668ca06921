// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parts of the module, each of which adds its classes and functions.
#ifndef Module_h
#define Module_h

#include <pybind11/pybind11.h>

namespace dggPython
{
void AddSurface(pybind11::module_& module);
void AddDistances(pybind11::module_& module);
void AddGraph(pybind11::module_& module);
void AddCurves(pybind11::module_& module);
void AddRegions(pybind11::module_& module);
void AddFields(pybind11::module_& module);
void AddSpectral(pybind11::module_& module);
void AddEarthMovers(pybind11::module_& module);
void AddVectorGraphics(pybind11::module_& module);
void AddPatchLayout(pybind11::module_& module);
void AddFormats(pybind11::module_& module);
void AddCloudGraph(pybind11::module_& module);
}

#endif
