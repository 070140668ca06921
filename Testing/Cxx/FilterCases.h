// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tables of filters on surfaces and clouds: how to make one that runs, and what it must refuse.
#ifndef FilterCases_h
#define FilterCases_h

#include "FilterTestTools.h"

#include <array>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace dggtest
{
/// A wrong property or input, and words of the message: the name of the property, the value.
struct Refusal
{
  std::function<void(vtkGeodesicAlgorithm*)> Spoil;
  std::vector<std::string> Parts;
};

struct FilterCase
{
  const char* Name;
  /// Returns the filter on a relief, or on its points, ready to run.
  std::function<vtkSmartPointer<vtkGeodesicAlgorithm>(vtkPolyData* relief)> Make;
  /// Makes the filter use surface points on its further input ports, in place of ids. Null for
  /// filters without such a port.
  std::function<void(vtkGeodesicAlgorithm*, vtkPolyData* points)> SetPoints;
  std::vector<const char*> Defaults = {}; ///< lines that a new filter prints
  std::vector<Refusal> Refusals = {};
  std::vector<int> Ports = {};          ///< outputs with new points on the surface
  std::vector<const char*> Arrays = {}; ///< point arrays of each of these outputs
  bool TakesPoints = false;             ///< without polygons, as a cloud
};
void PrintTo(const FilterCase& filter, std::ostream* os);

std::vector<FilterCase> GetCurveFilters();
std::vector<FilterCase> GetDistanceFilters();
std::vector<FilterCase> GetSpectralFilters();
/// Filters of the test program: all filters on surfaces, or all on clouds.
std::vector<FilterCase> GetAllFilters();

/// Returns all that a filter puts out, as text.
std::string DescribeOutputs(vtkGeodesicAlgorithm* filter, bool withFieldData = true);

/// A surface of (n + 1) x (n + 1) points that is neither flat nor straight, with integer
/// coordinates of the given type.
vtkSmartPointer<vtkPolyData> MakeRelief(int dataType, int n = 8);
/// Returns the point of a relief of any size that has the id `id` in the one of 9 x 9 points.
vtkIdType OnRelief(vtkPolyData* relief, vtkIdType id);
std::vector<vtkIdType> OnRelief(vtkPolyData* relief, std::vector<vtkIdType> ids);
void AddNote(vtkPolyData* surface, const char* name);
/// Adds distances in space from the first point as an array of geodesic distances. Returns the
/// largest.
double AddSpaceDistances(vtkPolyData* surface);
/// A point above the relief, farther than the tolerance.
constexpr std::array<double, 3> FarFromRelief{ { 0.0, 0.0, 99.0 } };
/// Returns five points on edges of a relief: four around its middle, and one in the middle.
Points GetPointsOnEdges(vtkPolyData* relief);

template <typename Filter>
vtkSmartPointer<Filter> MakeFilter(vtkPolyData* relief)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(relief);
  return filter;
}

/// A refusal that is spoilt by a function of the class of the filter.
template <typename Filter, typename Function>
Refusal Refuse(Function spoil, const std::vector<std::string>& parts)
{
  return { [spoil](vtkGeodesicAlgorithm* filter) { spoil(Filter::SafeDownCast(filter)); }, parts };
}

/// Returns FilterCase::SetPoints by a function of the class of the filter.
template <typename Filter, typename Function>
std::function<void(vtkGeodesicAlgorithm*, vtkPolyData*)> PointSetter(Function set)
{
  return [set](vtkGeodesicAlgorithm* filter, vtkPolyData* points) {
    set(Filter::SafeDownCast(filter), points);
  };
}

/// Returns the refusals of surface points that are not finite or far away.
std::vector<Refusal> RefusePoints(const FilterCase& filter, const std::string& words);
/// Returns the refusals of values of a property.
template <typename Filter, typename Value>
std::vector<Refusal> RefuseValues(void (Filter::*set)(Value),
  const std::vector<std::decay_t<Value>>& values, const std::vector<std::string>& parts)
{
  std::vector<Refusal> refusals;
  for (const auto& value : values)
  {
    refusals.push_back(Refuse<Filter>([set, value](Filter* f) { (f->*set)(value); }, parts));
  }
  return refusals;
}
Refusal RefuseMemoryLimit(vtkTypeInt64 limit);
/// Returns the refusals of all filters.
std::vector<Refusal> RefuseInput();

/// Returns the refusals of all filters that search a graph.
template <typename Filter>
std::vector<Refusal> RefuseGraph()
{
  auto refusals = RefuseValues(&Filter::SetAccuracy,
    { 0.0, 9e-7, 0.51, std::numeric_limits<double>::quiet_NaN() }, { "ccuracy", "1e-06", "0.5" });
  refusals.push_back(RefuseMemoryLimit(1000));
  return refusals;
}

inline std::vector<Refusal> operator+(std::vector<Refusal> a, const std::vector<Refusal>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
}

#endif
