// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts a vtkPolyData to the arrays of the kernel. Internal.
#ifndef DGGSurfaceArrays_h
#define DGGSurfaceArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggInputArray.h"             // for InputArray
#include "dggPreparedSurface.h"        // for SurfaceArrays

#include <functional> // for the cells
#include <list>       // for the copies
#include <string>     // for messages
#include <vector>     // for the copies

class vtkAbstractArray;
class vtkCellArray;
class vtkDataArray;
class vtkFieldData;
class vtkPolyData;

/// Points and cells of a vtkPolyData in the form of the kernel: views of arrays of doubles and
/// 64-bit integers, copies of other arrays. The vtkPolyData must outlive this object.
class VTKDGGFILTERSCOMMON_EXPORT DGGSurfaceArrays
{
public:
  DGGSurfaceArrays() = default;
  DGGSurfaceArrays(vtkPolyData* input, bool withPoints, bool withCells);
  DGGSurfaceArrays(const DGGSurfaceArrays&) = delete;
  DGGSurfaceArrays& operator=(const DGGSurfaceArrays&) = delete;

  const dgg::SurfaceArrays& Get() const { return this->Arrays; }

  ///@{
  /// Converts any cells, and any integers; both may be null. Valid as long as this object and the
  /// argument exist.
  dgg::CellArrays ConvertCells(vtkCellArray* cells);
  const dgg::Offset* ConvertIds(vtkDataArray* ids);
  ///@}

private:
  const double* ConvertPoints(vtkDataArray* points);

  dgg::SurfaceArrays Arrays;
  std::vector<double> Points;
  std::list<std::vector<dgg::Offset>> Ids;
};

/// Returns a function that converts the polygons and strips of a vtkPolyData at its first call.
VTKDGGFILTERSCOMMON_EXPORT std::function<const dgg::SurfaceArrays&()> DGGConvertCells(
  vtkPolyData* input);

/// Returns an error unless a point array is numeric, with this number of components (0 for any) and
/// a tuple per point. `where` is the name of `data` in messages.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGCheckPointArray(vtkAbstractArray* array,
  vtkPolyData* data, const std::string& where, int components, vtkDataArray*& numbers);

///@{
/// Reads an array, which may be null, or the array of this name; `data` may be null.
VTKDGGFILTERSCOMMON_EXPORT dgg::InputArray DGGReadArray(
  vtkAbstractArray* array, const std::string& name);
VTKDGGFILTERSCOMMON_EXPORT dgg::InputArray DGGReadArray(
  vtkFieldData* data, const std::string& name);
///@}

#endif
