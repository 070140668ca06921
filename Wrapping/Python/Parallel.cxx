// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The module vtkdgg._parallel. Its import loads DGG::FiltersParallel, which registers itself.
#include "vtkDGGFiltersGeodesicModule.h" // registers the modules of vtk_module_autoinit()

#include <pybind11/pybind11.h>

PYBIND11_MODULE(_parallel, module)
{
  module.doc() = "Computations by several processes over MPI.";
}
