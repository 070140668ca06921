// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Filters that put out new geometry on a surface, ready to run.
#ifndef SurfaceFilterCases_h
#define SurfaceFilterCases_h

#include "FilterTestTools.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace dggtest
{
/// A filter, and which of its outputs are new geometry.
struct SurfaceFilter
{
  const char* Name;
  /// The filter on a surface of 9 x 9 points.
  std::function<vtkSmartPointer<vtkGeodesicAlgorithm>(vtkPolyData* surface)> Make;
  std::vector<int> Ports;
  std::vector<const char*> Arrays;   ///< point arrays of all of them
  std::vector<const char*> Defaults; ///< lines that a new one prints
};
void PrintTo(const SurfaceFilter& filter, std::ostream* os);
const std::vector<SurfaceFilter>& GetSurfaceFilters();
const SurfaceFilter& GetSurfaceFilter(const std::string& name);

/// A surface that is neither flat nor straight, with coordinates of the given type that are
/// integers.
vtkSmartPointer<vtkPolyData> MakeRelief(int dataType);
void AddNote(vtkPolyData* surface, const char* name);
}

#endif
