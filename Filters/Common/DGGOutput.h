// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts outputs of the kernel to VTK. Internal.
#ifndef DGGOutput_h
#define DGGOutput_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggOutput.h"                 // for Output
#include "dggStatus.h"                 // for Status

#include "vtkSmartPointer.h" // for cells

class vtkCellArray;
class vtkFieldData;
class vtkPolyData;

/// Fills `data` with an output that is new geometry, and takes over the memory of the output. The
/// field data of `input` are passed, except its graph and windows, which belong to its points.
/// `precision` is a value of vtkAlgorithm::DesiredOutputPrecision. Fails if single precision is
/// requested and coordinates are out of the range of floats.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGFillOutput(
  dgg::Output& output, vtkPolyData* input, int precision, vtkPolyData* data);

/// Returns the cells, and takes over their memory.
VTKDGGFILTERSCOMMON_EXPORT vtkSmartPointer<vtkCellArray> DGGMakeCells(dgg::OutputCells& cells);

///@{
/// Adds all arrays of an output, with its active scalars, or one group of arrays (of its points,
/// its cells or the whole), and takes over their memory. Other scalars of `data` remain.
VTKDGGFILTERSCOMMON_EXPORT void DGGAddArrays(dgg::Output& output, vtkPolyData* data);
VTKDGGFILTERSCOMMON_EXPORT void DGGAddArrays(dgg::OutputArrays& arrays, vtkFieldData* data);
///@}

#endif
