// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts a vtkPolyData to the arrays of the kernel. Internal.
#ifndef DGGSurfaceArrays_h
#define DGGSurfaceArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggPreparedSurface.h"        // for SurfaceArrays

#include <list>   // for the copies
#include <vector> // for the copies

class vtkCellArray;
class vtkDataArray;
class vtkPolyData;

/// Points and cells of a vtkPolyData as the kernel needs them: views of its arrays where they hold
/// doubles and 64-bit integers, otherwise copies. The vtkPolyData must outlive this object.
class VTKDGGFILTERSCOMMON_EXPORT DGGSurfaceArrays
{
public:
  /// Omits the cells if `isCloud`.
  DGGSurfaceArrays(vtkPolyData* input, bool isCloud);

  const dgg::SurfaceArrays& Get() const { return this->Arrays; }

private:
  const double* ConvertPoints(vtkDataArray* points);
  dgg::CellArrays ConvertCells(vtkCellArray* cells);
  const dgg::Offset* ConvertIds(vtkDataArray* ids);

  dgg::SurfaceArrays Arrays;
  std::vector<double> Points;
  std::list<std::vector<dgg::Offset>> Ids;
};

#endif
